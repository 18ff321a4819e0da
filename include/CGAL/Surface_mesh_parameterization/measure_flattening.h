// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MEASURE_FLATTENING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MEASURE_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certify.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/read_chart.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Measures of the distortion of a flattening. All of them are invariant under similarities of the plane, but
/// for the shear, which depends on the direction of the axes.
struct Flattening_measures
{
  /// Mean over all corners of \f$(\alpha/\beta - 1)^2\f$ with planar angles \f$\alpha\f$ and target angles
  /// \f$\beta\f$: the energy of Equation 1 of \cgalCite{cgal:slmb-abf-05} divided by \f$3 n_f\f$.
  double angular_distortion = 0;

  /// \f$L_2\f$ stretch \cgalCite{cgal:ssgh-tmpm-01}, for equal areas; 1 at best, infinite if a triangle
  /// has no area in the plane.
  double l2_stretch = 0;

  /// \f$L_2\f$ shear, Equation 24 of \cgalCite{cgal:slmb-abf-05}; 0 at best.
  double l2_shear = 0;

  /// Number of triangles that are not positively oriented in the plane (exact).
  int flipped_triangles = 0;

  /// Smallest angle of a planar triangle, in radians.
  double smallest_angle = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// measures the distortion of the map from the connected component of `bhd` to the plane, whichever
/// parameterizer computed it. In linear time, but for a sort of the vertices.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
/// \tparam VertexUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a two-dimensional point as
///         value type.
/// \tparam FaceDistortionMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type.
///
/// \param mesh a triangulated surface.
/// \param bhd a halfedge on the border of `mesh`.
/// \param uvmap the map to be measured.
/// \param face_distortion_map receives the angular distortion of each face, whose mean is that of the map.
///
/// \exception std::invalid_argument if `bhd` is not a border halfedge of a triangulated component.
template <typename TriangleMesh, typename VertexUVMap, typename FaceDistortionMap>
Flattening_measures measure_flattening(const TriangleMesh& mesh,
                                       typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                                       VertexUVMap uvmap, FaceDistortionMap face_distortion_map)
{
  internal::Chart_reader<TriangleMesh> reader(mesh);
  if(const internal::Chart_defect defect = reader.read(bhd))
    throw std::invalid_argument(defect.message);
  const internal::Chart& chart = reader.chart;

  std::vector<internal::Chart::Point_2> uv;
  for(auto v : reader.vertex_descriptors) {
    const auto& p = get(uvmap, v);
    uv.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }

  Flattening_measures measures;
  const std::vector<double> beta = internal::target_angles(chart);
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    const double distortion = internal::angular_distortion(chart, beta, uv, t);
    put(face_distortion_map, reader.face_descriptors[t], distortion);
    measures.angular_distortion += distortion / chart.number_of_triangles();
  }
  const internal::Stretch_and_shear both = internal::stretch_and_shear(chart, uv);
  measures.l2_stretch = both.l2_stretch;
  measures.l2_shear = both.l2_shear;
  measures.flipped_triangles = static_cast<int>(internal::flipped_triangles(chart, uv).size());
  measures.smallest_angle = internal::smallest_angle(chart, uv);
  return measures;
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// measures the distortion of a map, as above.
template <typename TriangleMesh, typename VertexUVMap>
Flattening_measures measure_flattening(const TriangleMesh& mesh,
                                       typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                                       VertexUVMap uvmap)
{
  return measure_flattening(mesh, bhd, uvmap, boost::dummy_property_map());
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MEASURE_FLATTENING_H
