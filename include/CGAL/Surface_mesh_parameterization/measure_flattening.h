// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MEASURE_FLATTENING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MEASURE_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal::ABF {

struct No_face_visitor
{
  template <typename Face>
  void operator()(const Face&, const Flattening_face_measures&) const
  {}
};

} // namespace internal::ABF

/// \ingroup PkgAngleBasedFlatteningRef
///
/// measures the distortion of a map of the connected component of `bhd` to the plane, and of each of its triangles. The
/// map may come from any parameterizer. The time is linear, except for a sort of the vertices and \cgalBigO{b \log b}
/// for \f$b\f$ border edges. With \tbb, the function runs in parallel. The result has the same bits for any number of
/// threads.
///
/// None of these measures is that of `compute_L2_stretch()` in `measure_distortion.h` of the package
/// \ref PkgSurfaceMeshParameterization. In spite of its name, that function considers only areas. For each interior
/// vertex it takes the area of the triangles around the vertex, as a fraction of the total area. It returns the root
/// of the sum of the squared relative changes of these fractions. The value is 0 at best, and grows with the number
/// of vertices. `Flattening_measures::l2_stretch`
/// is the \f$L_2\f$ stretch of \cgalCite{cgal:ssgh-tmpm-01}, and `Flattening_measures::l2_area_distortion` is a mean
/// of the change of areas.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
/// \tparam VertexUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a two-dimensional point as
///         value type. Coordinates are converted to `double`.
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangulated surface.
/// \param bhd a halfedge on the border of `mesh`: one without a face.
/// \param uvmap the map to be measured. It may have any size and flipped triangles.
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called once for each face, with the measures of the face, by the calling thread}
///     \cgalParamType{a function object that takes a `boost::graph_traits<TriangleMesh>::%face_descriptor` and a
///                    `const Flattening_face_measures&`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the measures of the whole component, or what is wrong: the surface is closed (`Diagnosis::NO_BORDER`),
///   `bhd` is not a border halfedge (`Diagnosis::NOT_ON_BORDER`) or has no face on the other side
///   (`Diagnosis::EMPTY_MESH`), a face is not a triangle (`Diagnosis::NOT_TRIANGULATED`), or a point of the
///   component has a coordinate that is not finite (`Diagnosis::NON_FINITE_POINT`). The visitor is not called then.
template <typename TriangleMesh, typename VertexUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Flattening_measures_report<TriangleMesh>
measure_flattening(const TriangleMesh& mesh,
                   typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVMap uvmap,
                   const NamedParameters& np = parameters::default_values())
{
  internal::ABF::Check_vertex_map<TriangleMesh, VertexUVMap>();
  auto visitor = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                              internal::ABF::No_face_visitor());
  Flattening_measures_report<TriangleMesh> report;
  internal::ABF::Chart_reader<TriangleMesh> reader(mesh, internal::ABF::given_points<TriangleMesh>(np),
                                                   internal::ABF::given_numbers<TriangleMesh>(np));
  internal::ABF::Chart_defect defect = reader.read(bhd);
  if(!defect)
    defect = internal::ABF::find_non_finite_point(reader.chart);
  if(defect) {
    internal::ABF::report_defect(defect, reader, report);
    return report;
  }
  std::vector<internal::ABF::Chart::Point_2> uv;
  uv.reserve(reader.vertex_descriptors.size());
  double largest = 0;
  for(auto v : reader.vertex_descriptors) {
    const auto& p = get(uvmap, v);
    uv.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    largest = (std::max)({largest, std::abs(uv.back().x()), std::abs(uv.back().y())});
  }
  const double scale =
      internal::ABF::power_of_two(largest); // of the layout; the measures do not depend on it
  for(internal::ABF::Chart::Point_2& p : uv)
    p = internal::ABF::Chart::Point_2(p.x() / scale, p.y() / scale);
  static_cast<Flattening_measures&>(report) =
      internal::ABF::measure_chart(reader.chart, uv, [&](int t, const Flattening_face_measures& face) {
        visitor(reader.face_of_triangle(t), face);
      });
  return report;
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// measures the distortion of a map of the whole surface, such as an atlas of any program. The map may consist of any
/// number of charts. All charts are measured at one scale, so that differences of texel density count;
/// `Atlas_report::measures`, in contrast, scales each chart by itself. `Flattening_measures::border_is_simple` says
/// whether the borders of all charts are simple and apart.
///
/// The time is as above. The keys of the map of a `Seam_mesh` are its vertices, or halfedges of the mesh that it cuts.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam UVMap a model of `ReadablePropertyMap` with a two-dimensional point as value type. The key type is
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` or `%halfedge_descriptor`. A halfedge stores the
///         coordinates of its target in its face, as `make_atlas()` writes them; the surface is then cut open along the
///         edges whose two sides have different coordinates.
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangulated surface.
/// \param uvmap the map to be measured.
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{as above}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the measures of the whole surface, or what is wrong: the mesh has no faces (`Diagnosis::EMPTY_MESH`), a face
///   is not a triangle (`Diagnosis::NOT_TRIANGULATED`), or a point has a coordinate that is not finite
///   (`Diagnosis::NON_FINITE_POINT`). The visitor is not called then.
template <typename TriangleMesh, typename UVMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Flattening_measures_report<TriangleMesh>
measure_flattening(const TriangleMesh& mesh, UVMap uvmap,
                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  auto visitor = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor),
                                              internal::ABF::No_face_visitor());
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_const_property_map(CGAL::vertex_point, mesh));
  return internal::ABF::Mapped_surface(mesh, points, internal::ABF::given_numbers<TriangleMesh>(np), uvmap)
      .measure(visitor);
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MEASURE_FLATTENING_H
