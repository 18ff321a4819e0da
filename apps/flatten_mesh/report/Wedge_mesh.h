// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WEDGE_MESH_H
#define FLATTEN_MESH_WEDGE_MESH_H

#include "pictures/Textured_surface.h"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace pictures;

// A surface with one vertex, a wedge, for all corners at a point that have the same coordinates in the same chart. Only
// points of triangles are there.
struct Wedge_mesh
{
  using Index = Textured_surface::Index;

  struct Side
  {
    std::array<Index, 2> wedges;
    int seam; // as in `Textured_surface`
  };

  std::vector<Kernel::Point_3> points;
  std::vector<Index> wedge_points;
  std::vector<Kernel::Point_2> wedge_uv; // NaN without chart
  std::vector<std::array<Index, 3>> triangles;
  std::vector<int> charts; // of each triangle; -1 without one
  std::vector<Side> borders;
};

namespace internal {

constexpr Textured_surface::Index no_wedge = static_cast<Textured_surface::Index>(-1);

// Numbers points and wedges in the order in which triangles have them.
class Wedge_builder
{
public:
  using Index = Textured_surface::Index;

  explicit Wedge_builder(const Textured_surface& surface)
      : m_surface(surface), m_point(surface.points.size(), no_wedge),
        m_last_wedge(surface.points.size(), no_wedge)
  {}

  Wedge_mesh build()
  {
    m_mesh.charts = m_surface.charts;
    m_mesh.triangles.resize(m_surface.triangles.size());
    for(std::size_t t = 0; t < m_surface.triangles.size(); ++t) {
      for(std::size_t i = 0; i < 3; ++i) {
        m_mesh.triangles[t][i] = wedge(m_surface.triangles[t][i], m_surface.charts[t], m_surface.uv[t][i]);
      }
    }
    for(const Textured_surface::Border& border : m_surface.borders) {
      for(const Textured_surface::Side& side : border.sides) {
        const std::array<Index, 3>& triangle = m_mesh.triangles[side.triangle];
        m_mesh.borders.push_back({{triangle[side.corner], triangle[(side.corner + 1u) % 3]}, side.seam});
      }
    }
    return std::move(m_mesh);
  }

private:
  Index wedge(const Index point, const int chart, const Kernel::Point_2& uv)
  {
    for(Index w = m_last_wedge[point]; w != no_wedge; w = m_wedge_before[w]) {
      if(m_wedge_charts[w] == chart && (chart < 0 || m_mesh.wedge_uv[w] == uv)) {
        return w;
      }
    }
    if(m_point[point] == no_wedge) {
      m_point[point] = static_cast<Index>(m_mesh.points.size());
      m_mesh.points.push_back(m_surface.points[point]);
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    const Index wedge = static_cast<Index>(m_mesh.wedge_points.size());
    m_mesh.wedge_points.push_back(m_point[point]);
    m_mesh.wedge_uv.push_back(chart < 0 ? Kernel::Point_2(none, none) : uv);
    m_wedge_charts.push_back(chart);
    m_wedge_before.push_back(m_last_wedge[point]);
    m_last_wedge[point] = wedge;
    return wedge;
  }

  const Textured_surface& m_surface;
  Wedge_mesh m_mesh;
  std::vector<Index> m_point;        // of each point of the surface: its number here
  std::vector<Index> m_last_wedge;   // of each point of the surface
  std::vector<Index> m_wedge_before; // of each wedge: the one before it at the same point
  std::vector<int> m_wedge_charts;
};

} // namespace internal

inline Wedge_mesh wedge_mesh(const Textured_surface& surface)
{
  return internal::Wedge_builder(surface).build();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WEDGE_MESH_H
