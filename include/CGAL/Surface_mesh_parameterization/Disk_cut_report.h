// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_DISK_CUT_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_DISK_CUT_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Mesh_report.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

/// \file Disk_cut_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `is_disk_cut()` finds. It converts to `true` if all parts are disks that can be flattened. Otherwise, `status`
/// and `message` are about the first part that is not one. If a part has several defects, its status is the first of
/// `EMPTY_MESH`, `NOT_TRIANGULATED`, `NON_MANIFOLD_VERTEX`, `NO_BORDER`, `NONZERO_GENUS`, `SEVERAL_BORDERS`,
/// `SHORT_BORDER` and `PARALLEL_EDGES`. The message numbers faces and vertices from 0, in the order of the mesh. The
/// offending element is the face, the vertex or the edge that `Part::where` is in, or `Part::face` for closed parts and
/// handles.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Disk_cut_report : Mesh_report<TriangleMesh>
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
      halfedge_descriptor; ///< A halfedge of the mesh.
  typedef
      typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor; ///< A face of the mesh.

  /// A part of the surface: faces that are connected across edges that are neither seams nor border edges.
  struct Part
  {
    /// What is wrong with the part.
    Diagnosis status = Diagnosis::NOTHING_WRONG;

    /// A face of the part, the first one in the order of the mesh.
    face_descriptor face = boost::graph_traits<TriangleMesh>::null_face();

    std::size_t number_of_faces = 0; ///< The number of faces.

    /// Vertices minus edges plus faces; 1 for a disk.
    std::ptrdiff_t euler_characteristic = 0;

    std::size_t number_of_handles = 0; ///< The genus: 0 for a disk, 1 for a torus.

    /// For each border cycle, a halfedge that has a face of the part, and whose edge is a seam or a border edge.
    std::vector<halfedge_descriptor> borders;

    std::vector<std::size_t> border_sizes; ///< For each border cycle, the number of its edges.

    /// A halfedge at the defect, or the null halfedge if there is none. This halfedge belongs to the face that is not a
    /// triangle, points to the non-manifold vertex, is on the second or on the short border, is a loop, or is one of
    /// the parallel edges. For closed parts and handles, it belongs to `face`.
    halfedge_descriptor where = boost::graph_traits<TriangleMesh>::null_halfedge();
  };

  std::vector<Part> parts;         ///< All parts, ordered by their first faces.
  std::size_t number_of_disks = 0; ///< The number of parts without defect.

  /// The position of the first part with a defect in `parts`; the number of parts if there is none.
  std::size_t defective_part = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_DISK_CUT_REPORT_H
