// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From the triangles of all charts to their outlines, scaled to the areas that they should have.
// `pack_impl.h` reads its input by it; `certify_packing_impl.h` shares the lists of triangles by chart.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_READ_OUTLINES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_READ_OUTLINES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/chart_outline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The triangles of each chart, in their order: those of chart c are m_triangles[first(c)] and so on
class Triangles_of_charts
{
public:
  Triangles_of_charts(const std::vector<int>& chart, int number_of_charts)
      : m_first(static_cast<std::size_t>(number_of_charts) + 1, 0), m_triangles(chart.size())
  {
    for(int c : chart)
      ++m_first[c + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<int> next(m_first.begin(), m_first.end() - 1);
    for(std::size_t t = 0; t < chart.size(); ++t)
      m_triangles[next[chart[t]]++] = static_cast<int>(t);
  }

  int number_of_charts() const { return static_cast<int>(m_first.size()) - 1; }
  const int* begin(int c) const { return m_triangles.data() + m_first[c]; }
  const int* end(int c) const { return m_triangles.data() + m_first[c + 1]; }

private:
  std::vector<int> m_first, m_triangles;
};

// Reads one chart. `largest_area` is that of all triangles. Its coordinates are not finite if they are too large for
// their differences.
class Outline_reader
{
public:
  Outline_reader(const std::vector<Planar_point>& corners, const int* begin, const int* end)
      : m_corners(corners), m_begin(begin), m_end(end)
  {}

  Chart_outline read()
  {
    if(m_begin == m_end || !find_box())
      return m_outline;
    Outline_edges edges;
    for(const int* t = m_begin; t != m_end; ++t) {
      const Planar_point p = moved(3 * *t), q = moved(3 * *t + 1), r = moved(3 * *t + 2);
      const double twice_area = cross(q - p, r - p);
      m_outline.area += std::abs(twice_area) / 2;
      if(twice_area == 0) {
        m_outline.needles.push_back({p, q});
        m_outline.needles.push_back({q, r});
        m_outline.needles.push_back({r, p});
        continue;
      }
      edges.add(p, twice_area > 0 ? q : r);
      edges.add(twice_area > 0 ? q : r, twice_area > 0 ? r : q);
      edges.add(twice_area > 0 ? r : q, p);
    }
    m_outline.edges = edges.edges();
    find_hull();
    return std::move(m_outline);
  }

private:
  bool find_box()
  {
    Planar_point lower = m_corners[3 * *m_begin], upper = lower;
    for(const int* t = m_begin; t != m_end; ++t)
      for(int k = 0; k < 3; ++k) {
        lower = lower.cwiseMin(m_corners[3 * *t + k]);
        upper = upper.cwiseMax(m_corners[3 * *t + k]);
      }
    m_outline.origin = lower / 2 + upper / 2;
    m_outline.extent = (upper - lower).maxCoeff();
    return m_outline.extent > 0 && std::isfinite(m_outline.extent);
  }

  Planar_point moved(int corner) const // without a negative zero, which is another bit pattern
  {
    const Planar_point p = m_corners[corner] - m_outline.origin;
    return {p.x() / m_outline.extent + 0., p.y() / m_outline.extent + 0.};
  }

  void find_hull()
  {
    for(const Planar_segment& edge : m_outline.edges)
      m_outline.perimeter += (edge[1] - edge[0]).norm();
    if(m_outline.needles.empty())
      m_outline.hull = convex_hull(m_outline.edges);
    else {
      std::vector<Planar_segment> all = m_outline.edges;
      all.insert(all.end(), m_outline.needles.begin(), m_outline.needles.end());
      m_outline.hull = convex_hull(all);
    }
    for(std::size_t i = 0; i < m_outline.hull.size(); ++i)
      m_outline.hull_area += cross(m_outline.hull[i], m_outline.hull[(i + 1) % m_outline.hull.size()]) / 2;
    const std::optional<double> axes = angle_of_axes(m_outline.edges, m_outline.perimeter);
    m_outline.has_axes = axes.has_value();
    m_outline.angle_of_rectangle = axes ? *axes : angle_of_smallest_rectangle(m_outline.hull);
  }

  const std::vector<Planar_point>& m_corners;
  const int *m_begin, *m_end;
  Chart_outline m_outline;
};

// The outlines of all charts, with the lengths that they should have where all areas together are 1
inline std::vector<Chart_outline> read_outlines(const std::vector<Planar_point>& corners,
                                                const Triangles_of_charts& triangles,
                                                const std::vector<double>& areas_of_charts)
{
  std::vector<Chart_outline> outlines(areas_of_charts.size());
  const double sum = std::accumulate(areas_of_charts.begin(), areas_of_charts.end(), 0.);
  parallel_for(static_cast<int>(outlines.size()), [&](int c) {
    outlines[c] = Outline_reader(corners, triangles.begin(c), triangles.end(c)).read();
    if(outlines[c].has_area())
      outlines[c].length = std::sqrt(areas_of_charts[c] / sum / outlines[c].area);
  });
  return outlines;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_READ_OUTLINES_H
