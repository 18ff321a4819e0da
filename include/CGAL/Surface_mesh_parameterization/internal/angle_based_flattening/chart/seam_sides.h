// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What tells a `Seam_mesh` from other meshes: the halfedges on the other sides of seams, and the mesh that it cuts.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_SIDES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_SIDES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {

template <class TM, class SEM, class SVM>
class Seam_mesh;

} // namespace CGAL

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The seams of a `Seam_mesh`. `across()` returns the halfedge on the other side of a seam for an inner halfedge at the
// border; the null halfedge if there is no seam.
template <typename TriangleMesh>
struct Seam_sides
{
  typedef void surface_vertex_descriptor;
  static constexpr bool has_seams = false;
};

template <typename TM, typename SEM, typename SVM>
struct Seam_sides<CGAL::Seam_mesh<TM, SEM, SVM>>
{
  typedef CGAL::Seam_mesh<TM, SEM, SVM> Mesh;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TM>::vertex_descriptor surface_vertex_descriptor;
  static constexpr bool has_seams = true;

  static halfedge_descriptor across(const halfedge_descriptor& h, const Mesh& mesh)
  {
    const typename Mesh::TM_halfedge_descriptor other = opposite(h.tmhd, mesh.mesh());
    return mesh.has_on_seam(h.tmhd) && !CGAL::is_border(other, mesh.mesh())
               ? halfedge_descriptor(other)
               : boost::graph_traits<Mesh>::null_halfedge();
  }

  // The vertex of the mesh that was cut
  static surface_vertex_descriptor
  surface_vertex(const typename boost::graph_traits<Mesh>::vertex_descriptor& v, const Mesh& mesh)
  {
    const typename Mesh::TM_halfedge_descriptor h = v;
    return target(h, mesh.mesh());
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_SIDES_H
