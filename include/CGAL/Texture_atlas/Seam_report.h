// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SEAM_REPORT_H
#define CGAL_TEXTURE_ATLAS_SEAM_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// \file Seam_report.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// The report of `cut_to_disks()`, `select_seams()` and `shorten_seams()`.
struct Seam_report : Report
{
  using Report::Report;

  std::size_t number_of_components = 0; ///< the number of connected components
  std::size_t number_of_disks = 0;      ///< the number of disks between the seams

  /// the number of vertices that seams lead to: for `select_seams()` because of their scale, for `cut_to_disks()`
  /// because they were given
  std::size_t number_of_terminals = 0;
  double seam_length = 0;          ///< the length of all seams, each counted once
  double relative_seam_length = 0; ///< `seam_length`, divided by the square root of the area
  double predicted_stretch = 1; ///< the largest \f$L_2\f$ stretch that `select_seams()` predicts for a disk
  bool bound_reached = true;    ///< whether the predicted stretch is at most the bound
};

/// \ingroup PkgTextureAtlasRef
///
/// The report of `read_seam_selection()` and `write_seam_selection()`. It converts to `true` on success, like the
/// `bool` of \cgal's functions for files.
struct Seam_selection_report : Report
{
  using Report::Report;

  std::size_t line = 0; ///< The line with the error, from 1; 0 if there is none.

  /// The position of the wrong number in its line, from 1; 0 if there is none. For a pair, it is the first number.
  std::size_t element = 0;

  std::size_t number_of_seams = 0; ///< The number of pairs in the file that are seams.

  /// The number of pairs in the file that are border edges. They are not marked: a border edge is not a seam.
  std::size_t number_of_border_edges = 0;
};

/// \ingroup PkgTextureAtlasRef
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

/// \ingroup PkgTextureAtlasRef
///
/// The report of `split_overlaps()`.
struct Overlap_split_report : Report
{
  using Report::Report;

  std::size_t number_of_charts = 0; ///< The number of charts: connected pieces between given seams.
  std::size_t number_of_overlapping_charts = 0; ///< The number of charts whose maps were not injective.

  /// The number of faces that overlapped other faces of their chart. It may be too small if a chart has more than 64
  /// overlapping pairs for each face, because not all pairs are then examined.
  std::size_t number_of_overlapping_faces = 0;
  /// The number of connected pieces between all seams, each with an injective map.
  std::size_t number_of_pieces = 0;

  /// The length of the borders of the overlapping charts; a seam within a chart counts twice.
  double border_length = 0;
  double added_seam_length = 0; ///< The length of the added seams, each counted once.

  /// The relative growth of the borders: twice `added_seam_length` divided by `border_length`; 0 if nothing overlapped.
  double extra_seam = 0;
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SEAM_REPORT_H
