// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_DISK_CUT_CHECK_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_DISK_CUT_CHECK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// \file Disk_cut_check.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What keeps a part of a surface that is cut open from being flattened. If a part has several defects, it is the first
/// one in this order.
enum class Disk_cut_defect
{
  NOTHING_WRONG,       ///< The part is a topological disk that can be flattened.
  EMPTY_MESH,          ///< The mesh has no faces.
  NOT_TRIANGULATED,    ///< A face is not a triangle.
  NON_MANIFOLD_VERTEX, ///< A vertex is surrounded by faces, and belongs to other faces as well.
  CLOSED,              ///< The part has neither a border nor a seam.
  HANDLES,             ///< The part has handles.
  SEVERAL_BORDERS,     ///< The part has several border cycles.
  SHORT_BORDER,  ///< The border of the part has fewer than three edges, such as a sphere slit along one edge.
  PARALLEL_EDGES ///< Two edges of the part have the same vertices, or an edge is a loop.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a defect, such as `"SEVERAL_BORDERS"`.
inline std::string to_string(Disk_cut_defect defect)
{
  switch(defect) {
  case Disk_cut_defect::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Disk_cut_defect::EMPTY_MESH:
    return "EMPTY_MESH";
  case Disk_cut_defect::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Disk_cut_defect::NON_MANIFOLD_VERTEX:
    return "NON_MANIFOLD_VERTEX";
  case Disk_cut_defect::CLOSED:
    return "CLOSED";
  case Disk_cut_defect::HANDLES:
    return "HANDLES";
  case Disk_cut_defect::SEVERAL_BORDERS:
    return "SEVERAL_BORDERS";
  case Disk_cut_defect::SHORT_BORDER:
    return "SHORT_BORDER";
  case Disk_cut_defect::PARALLEL_EDGES:
    return "PARALLEL_EDGES";
  }
  return "unknown";
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `is_disk_cut()` finds. It converts to `true` if all parts are disks that can be flattened.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
template <typename TriangleMesh>
struct Disk_cut_check
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
      halfedge_descriptor; ///< A halfedge of the mesh.
  typedef
      typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor; ///< A face of the mesh.

  /// A part of the surface: faces that are connected across edges that are neither seams nor border edges.
  struct Part
  {
    /// What is wrong with the part.
    Disk_cut_defect defect = Disk_cut_defect::NOTHING_WRONG;

    /// A face of the part, the first one in the order of the mesh.
    face_descriptor face = boost::graph_traits<TriangleMesh>::null_face();

    std::size_t number_of_faces = 0; ///< Faces of the part.

    /// Vertices minus edges plus faces; 1 for a disk.
    std::ptrdiff_t euler_characteristic = 0;

    std::size_t number_of_handles = 0; ///< The genus: 0 for a disk, 1 for a torus.

    /// For each border cycle, a halfedge that has a face of the part, and whose edge is a seam or a border edge.
    std::vector<halfedge_descriptor> borders;

    std::vector<std::size_t> border_sizes; ///< For each border cycle, the number of its edges.

    /// Where the defect is; the null halfedge if there is none. This halfedge belongs to the face that is not a
    /// triangle, points to the vertex that is not a manifold, is on the second or short border, is a loop, or is one of the
    /// parallel edges. For closed parts and handles, it belongs to `face`.
    halfedge_descriptor where = boost::graph_traits<TriangleMesh>::null_halfedge();
  };

  Disk_cut_defect defect =
      Disk_cut_defect::NOTHING_WRONG; ///< What is wrong with the first part with a defect.

  /// A sentence that says what is wrong with that part; empty if nothing is. It numbers faces and vertices from 0, in the
  /// order of the mesh.
  std::string message;

  std::vector<Part> parts;         ///< All parts, ordered by their first faces.
  std::size_t number_of_disks = 0; ///< Parts without defect.
  std::size_t defective_part =
      0; ///< Rank of the first part with a defect; the number of parts if there is none.

  /// returns whether all parts are disks that can be flattened.
  explicit operator bool() const { return defect == Disk_cut_defect::NOTHING_WRONG; }
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_DISK_CUT_CHECK_H
