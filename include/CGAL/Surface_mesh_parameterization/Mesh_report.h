// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MESH_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MESH_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

/// \file Mesh_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// A report with the elements of a mesh that its diagnosis is about. Those that a diagnosis is not about are empty, and
/// all are if nothing is wrong. Section \ref ABF_errors of the manual says which diagnosis names what.
///
/// \tparam Mesh a model of `FaceGraph`
/// \tparam Report_ `Report`, or what derives from it
template <typename Mesh, typename Report_ = Report>
struct Mesh_report : Report_
{
  /// Vertex type
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  /// Edge type
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  /// Face type
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;

  std::vector<vertex_descriptor> offending_vertices; ///< The vertices that the diagnosis is about.
  std::vector<edge_descriptor> offending_edges;      ///< The edges that it is about.
  std::vector<face_descriptor> offending_faces;      ///< The faces that it is about.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MESH_REPORT_H
