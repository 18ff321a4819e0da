// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates of faces without area, which are in no chart: on an edge of a neighbor.
// `mesh_in_atlas.h` places them when the charts have their final coordinates.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FACES_WITHOUT_AREA_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FACES_WITHOUT_AREA_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Where a corner of a face is
struct Corner_in_atlas
{
  Chart::Point_2 uv;
  std::size_t chart;
};

template <typename TriangleMesh, typename VertexPointMap>
class Faces_without_area
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

public:
  Faces_without_area(const TriangleMesh& mesh, VertexPointMap points) : m_mesh(mesh), m_points(points) {}

  // `corner_at(h)` is the corner that a halfedge of a face points to, if the face is in a chart. A neighbor may be
  // another face without area, which was placed before.
  template <typename CornerAt>
  void place(std::vector<face_descriptor> faces, const CornerAt& corner_at)
  {
    for(std::size_t before = faces.size() + 1; faces.size() < before;) {
      before = faces.size();
      const auto is_placed = [&](face_descriptor f) { return place_face(f, corner_at); };
      faces.erase(std::remove_if(faces.begin(), faces.end(), is_placed), faces.end());
    }
  }

  // The charts of faces that were placed, and the coordinates of their halfedges' targets
  const std::map<face_descriptor, std::size_t>& charts() const { return m_charts; }
  const std::map<halfedge_descriptor, Chart::Point_2>& uv() const { return m_uv; }

private:
  // On its longest edge with such a neighbor: each corner is at the nearer end, which any number type can hold.
  // Returns whether there is one.
  template <typename CornerAt>
  bool place_face(face_descriptor f, const CornerAt& corner_at)
  {
    double length = -1;
    std::optional<Corner_in_atlas> from, to;
    halfedge_descriptor longest;
    for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const halfedge_descriptor across = opposite(h, m_mesh); // which runs the other way
      const double squared = squared_distance(source(h, m_mesh), target(h, m_mesh));
      if(CGAL::is_border(across, m_mesh) || !(squared > length))
        continue;
      if(const std::optional<Corner_in_atlas> corner = corner_of(across, corner_at)) {
        length = squared;
        longest = h;
        from = corner;
        to = corner_of(prev(across, m_mesh), corner_at);
      }
    }
    if(!from)
      return false;
    const vertex_descriptor third = target(next(longest, m_mesh), m_mesh);
    m_uv[longest] = to->uv;
    m_uv[prev(longest, m_mesh)] = from->uv;
    m_uv[next(longest, m_mesh)] =
        squared_distance(third, source(longest, m_mesh)) < squared_distance(third, target(longest, m_mesh))
            ? from->uv
            : to->uv;
    m_charts[f] = from->chart;
    return true;
  }

  template <typename CornerAt>
  std::optional<Corner_in_atlas> corner_of(halfedge_descriptor h, const CornerAt& corner_at) const
  {
    const auto uv = m_uv.find(h);
    return uv == m_uv.end() ? corner_at(h) : Corner_in_atlas{uv->second, m_charts.at(face(h, m_mesh))};
  }

  double squared_distance(vertex_descriptor v, vertex_descriptor w) const
  {
    return CGAL::to_double(CGAL::squared_distance(get(m_points, v), get(m_points, w)));
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_points;
  std::map<face_descriptor, std::size_t> m_charts;
  std::map<halfedge_descriptor, Chart::Point_2> m_uv;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FACES_WITHOUT_AREA_H
