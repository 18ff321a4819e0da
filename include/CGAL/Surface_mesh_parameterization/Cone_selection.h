// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_SELECTION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_SELECTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <boost/graph/graph_traits.hpp>

#include <string>
#include <utility>
#include <vector>

/// \file Cone_selection.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// How `select_cones()` finds the angles of the cones that it chose.
enum class Cone_angles
{
  PREDICTED,    ///< The predicted scale is 1 at all cones.
  LEAST_SQUARES ///< The predicted scale varies as little as these cones allow, in the mean over the area.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `select_cones()` reports besides the cones.
struct Cone_report
{
  /// What went wrong. In all cases but the first, there are no cones.
  enum Diagnosis
  {
    NOTHING_WRONG,       ///< There are cones with angles that are possible.
    EMPTY_MESH,          ///< The mesh has no faces.
    NOT_TRIANGULATED,    ///< A face is not a triangle.
    NON_FINITE_POINT,    ///< A coordinate is infinite or not a number.
    NON_MANIFOLD_VERTEX, ///< A vertex is surrounded by faces, and belongs to other faces as well.
    SEVERAL_COMPONENTS,  ///< The surface is not connected.
    WRONG_OPTION,        ///< A named parameter is out of its range.
    WRONG_TOPOLOGY,    ///< Multiples of an angle are for spheres and disks only, and the surface is neither.
    INFEASIBLE_ANGLES, ///< The angle of a cone would not be positive, or too large for its triangles.
    LINEAR_SYSTEM_FAILED, ///< The linear solver failed.
    TOO_LARGE             ///< The surface has more triangles than 32-bit numbers allow.
  };

  Diagnosis diagnosis = NOTHING_WRONG; ///< what went wrong
  std::string message;                 ///< the same for people; empty if nothing is wrong

  /// the \f$L_2\f$ stretch that the scale \f$e^u\f$ predicts for a map with these cones
  double predicted_stretch = 1;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"INFEASIBLE_ANGLES"`.
///
/// \relates Cone_report
inline std::string to_string(Cone_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Cone_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Cone_report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Cone_report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Cone_report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Cone_report::NON_MANIFOLD_VERTEX:
    return "NON_MANIFOLD_VERTEX";
  case Cone_report::SEVERAL_COMPONENTS:
    return "SEVERAL_COMPONENTS";
  case Cone_report::WRONG_OPTION:
    return "WRONG_OPTION";
  case Cone_report::WRONG_TOPOLOGY:
    return "WRONG_TOPOLOGY";
  case Cone_report::INFEASIBLE_ANGLES:
    return "INFEASIBLE_ANGLES";
  case Cone_report::LINEAR_SYSTEM_FAILED:
    return "LINEAR_SYSTEM_FAILED";
  case Cone_report::TOO_LARGE:
    return "TOO_LARGE";
  }
  return "unknown";
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The cones that `select_cones()` chooses.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Cone_selection : Cone_report
{
  /// Vertex type
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  /// Face type
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;

  /// the cones in the order in which they were chosen, each with the sum of the planar angles around it, in radians;
  /// `free_cone_angle` if these sums are free
  std::vector<std::pair<vertex_descriptor, double>> cones;

  /// the vertices that the diagnosis is about: the pinched one, or those whose angles are not possible
  std::vector<vertex_descriptor> offending_vertices;

  /// the face that the diagnosis is about: the first one of a second component
  std::vector<face_descriptor> offending_faces;

  /// returns the cones without their angles, for `parameters::terminals()`.
  std::vector<vertex_descriptor> vertices() const
  {
    std::vector<vertex_descriptor> result;
    for(const auto& cone : cones)
      result.push_back(cone.first);
    return result;
  }

  /// returns the angles as a property map for `ABF_plus_plus_parameterizer_3::set_angle_sums()`.
  Vertex_angles<TriangleMesh> angles() const
  {
    Vertex_angles<TriangleMesh> result;
    for(const auto& cone : cones)
      result.set(cone.first, cone.second);
    return result;
  }
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_SELECTION_H
