// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The borders of a piece of a map, and what chords between their places cut off. `cut_along_chords.h` and `cut_rings.h`
// choose among the chords, and `chord_paths.h` finds paths along them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BORDER_OF_PIECE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BORDER_OF_PIECE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline double distance(const Chart::Point_2& p, const Chart::Point_2& q)
{
  return std::hypot(p.x() - q.x(), p.y() - q.y());
}

// A border of a piece of a map: counterclockwise, unless it is that of a hole
class Border_of_piece
{
  typedef Chart::Point_2 Point_2;

public:
  // The border that a corner faces
  Border_of_piece(const Sector_graph& graph, const std::vector<Point_2>& uv, int start)
  {
    int c = start;
    do {
      m_corners.push_back(c);
      m_points.push_back(uv[graph.surface().edge_source(c)]);
      c = graph.next_open(c);
    } while(c != start);
    m_area.push_back(0);
    for(std::size_t i = 0; i < size(); ++i) {
      m_area.push_back(m_area.back() + cross_product(point(i), next_point(i)));
      m_length += distance(point(i), next_point(i));
    }
  }

  std::size_t size() const { return m_corners.size(); }
  int corner(std::size_t i) const { return m_corners[i]; }          // that faces an edge
  const Point_2& point(std::size_t i) const { return m_points[i]; } // the source of an edge
  double length() const { return m_length; }
  double area() const { return m_area.back() / 2; } // negative if it is that of a hole

  // What the border from one place to a later one encloses with the origin
  double area_of_sector(std::size_t from, std::size_t to) const { return (m_area[to] - m_area[from]) / 2; }

  // At even distances, and at most so many
  std::vector<std::size_t> sampled_places(std::size_t most) const
  {
    std::vector<std::size_t> places;
    double since = m_length; // the last place
    for(std::size_t i = 0; i < size(); ++i) {
      if(since >= m_length / static_cast<double>(most)) {
        places.push_back(i);
        since = 0;
      }
      since += distance(point(i), next_point(i));
    }
    return places;
  }

  // By the parity of the edges below it
  bool encloses(const Point_2& p) const
  {
    bool is_inside = false;
    for(std::size_t i = 0; i < size(); ++i) {
      const Point_2 &r = point(i), &s = next_point(i);
      is_inside ^= (r.x() <= p.x()) != (s.x() <= p.x()) &&
                   (CGAL::orientation(r, s, p) == CGAL::LEFT_TURN) == (r.x() < s.x());
    }
    return is_inside;
  }

  // Whether a chord meets edges that do not share an end with it
  bool crosses(const Point_2& p, const Point_2& q) const
  {
    for(std::size_t i = 0; i < size(); ++i) {
      const Point_2 &r = point(i), &s = next_point(i);
      if(r != p && r != q && s != p && s != q && CGAL::orientation(p, q, r) != CGAL::orientation(p, q, s) &&
         CGAL::orientation(r, s, p) != CGAL::orientation(r, s, q))
        return true;
    }
    return false;
  }

  static double cross_product(const Point_2& p, const Point_2& q) { return p.x() * q.y() - p.y() * q.x(); }

private:
  const Point_2& next_point(std::size_t i) const { return m_points[i + 1 < size() ? i + 1 : 0]; }

  std::vector<int> m_corners;
  std::vector<Point_2> m_points;
  std::vector<double> m_area; // twice what the edges before enclose with the origin
  double m_length = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BORDER_OF_PIECE_H
