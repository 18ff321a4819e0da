// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The data of a chart for packing: edges of the outline, hull, area, and the directions with the smallest bounding box.
// `read_outlines.h` fills it, and `chart_shape.h` draws it, at the cost of the outline instead of all triangles.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHART_OUTLINE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHART_OUTLINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_kernel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

typedef std::array<Planar_point, 2> Planar_segment;

// What packing knows about a chart. Its points are moved and scaled, so that its bounding box has the origin as centre
// and a longest side of length 1.
struct Chart_outline
{
  Planar_point origin = Planar_point::Zero();
  double extent = 0;    // the longest side of the bounding box
  double area = 0;      // in the plane, after scaling
  double perimeter = 0; // the same
  double length = 0;    // that the longest side of the bounding box should have
  std::vector<Planar_segment>
      edges; // The triangles are on their left. Where they overlap, and only there, they wind several times.
  std::vector<Planar_segment> needles; // the sides of triangles without area
  std::vector<Planar_point> hull;      // counterclockwise
  double hull_area = 0;                // after scaling
  double angle_of_rectangle = 0;       // turned by that, the bounding box is smallest
  bool has_axes = false; // most of the border is parallel to the sides of a rectangle, which is that one then

  bool has_area() const { return extent > least_extent && area > least_relative_area; }

private:
  static constexpr double least_extent = 1e-300; // the inverse of less is infinite
  static constexpr double least_relative_area =
      1. / (1ull << 40); // of the square of the extent; less is rounding
};

// Of the bits of coordinates, which Boost hashes faster than numbers. There is no negative zero: where coordinates are
// equal, their bits are.
struct Segment_hash
{
  std::size_t operator()(const Planar_segment& s) const
  {
    std::size_t seed = 0;
    for(const Planar_point& p : s)
      for(const double coordinate : {p.x(), p.y()}) {
        std::uint64_t bits;
        std::memcpy(&bits, &coordinate, sizeof(bits));
        boost::hash_combine(seed, bits);
      }
    return seed;
  }
};

struct Segment_less
{
  bool operator()(const Planar_segment& s, const Planar_segment& t) const
  {
    const auto key = [](const Planar_segment& u) {
      return std::array<double, 4>{u[0].x(), u[0].y(), u[1].x(), u[1].y()};
    };
    return key(s) < key(t);
  }
};

// Takes the edges of triangles that no other triangle has in the opposite direction. All triangles count as
// counterclockwise.
class Outline_edges
{
public:
  void add(const Planar_point& p, const Planar_point& q)
  {
    if(p == q)
      return;
    if(const auto found = m_count.find({q, p}); found == m_count.end())
      ++m_count[{p, q}];
    else if(--found->second == 0)
      m_count.erase(found);
  }

  std::vector<Planar_segment> edges() const
  {
    std::vector<Planar_segment> result;
    for(const auto& [edge, count] : m_count)
      result.insert(result.end(), static_cast<std::size_t>(count), edge);
    std::sort(result.begin(), result.end(), Segment_less());
    return result;
  }

private:
  std::unordered_map<Planar_segment, int, Segment_hash> m_count;
};

inline std::vector<Planar_point> convex_hull(const std::vector<Planar_segment>& segments)
{
  typedef Planar_kernel::Point_2 Point;
  std::vector<Point> points, hull;
  for(const Planar_segment& s : segments)
    for(const Planar_point& p : s)
      points.emplace_back(p.x(), p.y());
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  std::vector<Planar_point> result;
  for(const Point& p : hull)
    result.emplace_back(p.x(), p.y());
  return result;
}

// Width and height of a chart that is turned by an angle
inline Planar_point turned_extent(const std::vector<Planar_point>& hull, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  Planar_point lower(HUGE_VAL, HUGE_VAL), upper = -lower;
  for(const Planar_point& p : hull) {
    const Planar_point q(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    lower = lower.cwiseMin(q);
    upper = upper.cwiseMax(q);
  }
  return upper - lower;
}

inline double angle_of_smallest_rectangle(const std::vector<Planar_point>& hull)
{
  typedef Planar_kernel::Point_2 Point;
  std::vector<Point> points, corners;
  for(const Planar_point& p : hull)
    points.emplace_back(p.x(), p.y());
  CGAL::min_rectangle_2(points.begin(), points.end(), std::back_inserter(corners));
  if(corners.size() < 2)
    return 0;
  const auto side = corners[1] - corners[0];
  return -std::atan2(side.y(), side.x());
}

// Turned by this angle, most of the border is parallel to the axes; none if it has no such main directions.
inline std::optional<double> angle_of_axes(const std::vector<Planar_segment>& edges, double perimeter)
{
  const int sectors = 360; // of a quarter turn
  const double quarter = std::acos(0.), least_share = 0.5;
  std::vector<double> length(sectors, 0), moment(sectors, 0);
  for(const Planar_segment& edge : edges) {
    const Planar_point side = edge[1] - edge[0];
    const double turn = std::atan2(side.y(), side.x()) / quarter + 2,
                 place = (turn - std::floor(turn)) * sectors;
    const int sector = static_cast<int>(place) % sectors;
    length[sector] += side.norm();
    moment[sector] += side.norm() * (place - static_cast<int>(place));
  }
  const auto sum_around = [&](int i) {
    return length[(i + sectors - 1) % sectors] + length[i] + length[(i + 1) % sectors];
  };
  int best = 0;
  for(int i = 1; i < sectors; ++i)
    best = sum_around(i) > sum_around(best) ? i : best;
  if(!(sum_around(best) >= least_share * perimeter))
    return std::nullopt;
  double place = 0;
  for(int k = -1; k <= 1; ++k) {
    const int i = (best + k + sectors) % sectors;
    place += (length[i] * (best + k) + moment[i]) / sum_around(best);
  }
  return -place / sectors * quarter;
}

// Turned by this angle, the chart has the smallest bounding box with a given width, divided by the height: of many
// angles the best one, refined by bisection
inline double angle_of_smallest_page(const std::vector<Planar_point>& hull, double aspect)
{
  const int samples = 512, quarters = aspect == 1 ? 1 : 2;
  double step = std::acos(0.) / samples, best_angle = 0, best = HUGE_VAL;
  const auto look_at = [&](double angle) {
    const Planar_point extent = turned_extent(hull, angle);
    const double side = (std::max)(extent.x(), aspect * extent.y());
    if(side < best) {
      best = side;
      best_angle = angle;
    }
  };
  for(int i = 0; i < quarters * samples; ++i)
    look_at(i * step);
  for(; step > 1e-6; step /= 2) {
    const double centre = best_angle;
    look_at(centre - step / 2);
    look_at(centre + step / 2);
  }
  return best_angle;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHART_OUTLINE_H
