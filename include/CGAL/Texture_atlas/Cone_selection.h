// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_CONE_SELECTION_H
#define CGAL_TEXTURE_ATLAS_CONE_SELECTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <boost/graph/graph_traits.hpp>

#include <set>
#include <string>
#include <utility>
#include <vector>

/// \file Cone_selection.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// How `select_cones()` finds the angles of the cones.
enum class Cone_angles
{
  PREDICTED,     ///< The predicted scale is 1 at all cones.
  LEAST_SQUARES, ///< The predicted scale varies as little as possible, in the mean over the area.

  /// The map determines the angles: all are `free_cone_angle`. A sphere may then have fewer than three cones.
  FREE
};

/// \ingroup PkgTextureAtlasRef
///
/// The options of `select_cones()` and `flatten_with_cones()`.
struct Cone_options
{
  Cone_angles angles = Cone_angles::PREDICTED; ///< How the angles of the cones are found.

  /// If not 0, the angles of the cones are multiples of this angle, in radians; \f$2\pi\f$ must be a multiple of it.
  /// With \f$\pi/2\f$, a grid continues across all seams. The surface must be a sphere or a disk, and `angles` must not
  /// be `FREE`.
  double angle_multiple = 0;

  /// The options of ABF++ in `flatten_with_cones()`. `Flattening_options::time_limit` bounds the whole time of
  /// `select_cones()` or `flatten_with_cones()`. `ABF_plus_plus_options::equal_seam_lengths` may be `false` only
  /// with free angles.
  ABF_plus_plus_options parameterizer;
};

/// \ingroup PkgTextureAtlasRef
///
/// The report of `select_cones()`, without the cones.
struct Cone_report : Report
{
  using Report::Report;

  /// the \f$L_2\f$ stretch that the scale \f$e^u\f$ predicts for a map with these cones
  double predicted_stretch = 1;
};

/// \ingroup PkgTextureAtlasRef
///
/// The cones that `select_cones()` chooses.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Cone_selection : Mesh_report<TriangleMesh, Cone_report>
{
  /// Vertex type
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  /// the cones in the order in which they were chosen, each with the sum of the planar angles around it, in radians;
  /// `free_cone_angle` if these sums are free
  std::vector<std::pair<vertex_descriptor, double>> cones;

  /// returns the cones without their angles. `vertex_is_constrained_map(CGAL::make_boolean_property_map(vertices))`
  /// gives such a set to `cut_to_disks()`.
  std::set<vertex_descriptor> vertices() const
  {
    std::set<vertex_descriptor> result;
    for(const auto& cone : cones)
      result.insert(cone.first);
    return result;
  }

  /// returns the angles as a property map for `ABF_plus_plus_parameterizer_3::set_angle_sums()`.
  Surface_mesh_parameterization::Vertex_angles<TriangleMesh> angles() const
  {
    Surface_mesh_parameterization::Vertex_angles<TriangleMesh> result;
    for(const auto& cone : cones)
      result.set(cone.first, cone.second);
    return result;
  }
};

/// \ingroup PkgTextureAtlasRef
///
/// What `flatten_with_cones()` reports. If anything is wrong, `status`, `message` and the offending elements are those
/// of the first part that failed.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Cone_flattening : Mesh_report<TriangleMesh>
{
  Cone_selection<TriangleMesh> cones; ///< the cones with their angles
  Seam_report seams;                  ///< the seams through the cones
  ABF_plus_plus_report map;           ///< the map
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_CONE_SELECTION_H
