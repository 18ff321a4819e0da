// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_POLYGON_ANGLES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_POLYGON_ANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_corners.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_surface_sums.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// \file polygon_angles.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Marks a cone with a free sum of angles, for `ABF_plus_plus_parameterizer_3::set_angle_sums()`. Without this mark or
/// a prescribed sum, a vertex in the middle of a seam gets \f$2\pi\f$.
inline constexpr double free_cone_angle = (std::numeric_limits<double>::infinity)();

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Prescribed angles at some vertices, in radians, for `ABF_plus_plus_parameterizer_3::set_angle_sums()`. Copies share
/// the angles.
///
/// \cgalModels{ReadablePropertyMap}
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
class Vertex_angles
{
public:
  /// Key type
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor key_type;
  /// Value type: nothing where no angle is prescribed
  typedef std::optional<double> value_type;
  /// Same as `value_type`
  typedef value_type reference;
  /// Category
  typedef boost::readable_property_map_tag category;

  /// prescribes the angle of a vertex, or removes it.
  void set(const key_type& v, const value_type& angle)
  {
    if(angle)
      (*m_angles)[v] = *angle;
    else
      m_angles->erase(v);
  }

  /// returns the angle that is prescribed at a vertex, if there is one.
  value_type operator[](const key_type& v) const
  {
    const auto found = m_angles->find(v);
    return found == m_angles->end() ? value_type() : value_type(found->second);
  }

  /// returns the angle that is prescribed at a vertex, if there is one.
  friend value_type get(const Vertex_angles& angles, const key_type& v) { return angles[v]; }

private:
  std::shared_ptr<std::map<key_type, double>> m_angles = std::make_shared<std::map<key_type, double>>();
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `polygon_angles()` and `rectangle_angles()` return.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Polygon_report : Mesh_report<TriangleMesh>
{
  Vertex_angles<TriangleMesh> angles; ///< The angles; none if anything is wrong.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the angles of a polygon whose corners are some vertices of a border of `mesh`: at each corner the given
/// inner angle, and
/// \f$\pi\f$ at all other vertices of that border, so that they are on straight sides.
///
/// The inner angles of a polygon with \f$k\f$ corners sum to \f$(k - 2)\pi\f$. This function does not check the angles;
/// `ABF_plus_plus_parameterizer_3::parameterize()` checks whether the polygon is possible. The time is linear, up to a
/// factor of \cgalBigO{\log b} for \f$b\f$ border vertices.
///
/// \tparam TriangleMesh a model of `VertexListGraph` and `HalfedgeListGraph` whose vertex descriptors are ordered by
///   `<`
///
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh
/// \param corners the corners with their angles in radians, in any order
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{the numbers of vertices in messages}
///     \cgalParamType{a model of `ReadablePropertyMap` with an integer as value type}
///     \cgalParamDefault{positions in the sequence of vertices, from 0}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the angles, or what is wrong: there is no corner or a corner occurs twice (`Diagnosis::WRONG_OPTION`), or a
///   corner is not on the border of the first one (`Diagnosis::NOT_ON_BORDER`). The offending vertex is the corner.
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Polygon_report<TriangleMesh> polygon_angles(
    const TriangleMesh& mesh,
    const std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, double>>&
        corners,
    const NamedParameters& np = parameters::default_values())
{
  Polygon_report<TriangleMesh> report;
  const auto fail = [&](Diagnosis diagnosis, const auto& v, const char* what) {
    report.status = diagnosis;
    report.message = internal::ABF::vertex_of_mesh_text(mesh, v, np) + what;
    report.offending_vertices = {v};
    return report;
  };
  if(corners.empty()) {
    report.status = Diagnosis::WRONG_OPTION;
    report.message = "a polygon needs corners";
    return report;
  }
  const auto all = halfedges(mesh);
  const auto start = std::find_if(all.begin(), all.end(), [&](auto h) {
    return CGAL::is_border(h, mesh) && target(h, mesh) == corners.front().first;
  });
  if(start == all.end())
    return fail(Diagnosis::NOT_ON_BORDER, corners.front().first, " is a corner, and is not on a border");
  Vertex_angles<TriangleMesh> angles;
  for(auto h : CGAL::halfedges_around_face(*start, mesh))
    angles.set(target(h, mesh), CGAL_PI);
  for(auto corner = corners.begin(); corner != corners.end(); ++corner) {
    const auto v = corner->first;
    if(!angles[v])
      return fail(Diagnosis::NOT_ON_BORDER, v, " is a corner, and is not on the border of the first corner");
    if(std::any_of(corners.begin(), corner, [&](const auto& other) { return other.first == v; }))
      return fail(Diagnosis::WRONG_OPTION, v, " is a corner twice");
    angles.set(v, corner->second);
  }
  report.angles = angles;
  return report;
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the angles of a rectangle whose corners are four vertices of a border of `mesh`, in any order. The surface
/// determines the ratio of its sides; the overload with a ratio chooses corners for it.
///
/// Requirements, named parameters, report and time are those of `polygon_angles()`.
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Polygon_report<TriangleMesh>
rectangle_angles(const TriangleMesh& mesh,
                 const std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 4>& corners,
                 const NamedParameters& np = parameters::default_values())
{
  std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, double>> right;
  for(const auto& v : corners)
    right.emplace_back(v, CGAL_PI / 2);
  return polygon_angles(mesh, right, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `rectangle_angles()` returns if it chooses the corners.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Rectangle_report : Polygon_report<TriangleMesh>
{
  /// The corners, counterclockwise in the plane; without meaning if anything is wrong.
  std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 4> corners = {};
  /// The predicted length of the side from the first corner to the second one, divided by that of the next side; 0 if
  /// anything is wrong.
  double predicted_ratio = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// chooses four corners on the border of `bhd` so that the sides of the rectangle have a given ratio, and returns its
/// angles.
///
/// A conformal map of the border to the boundary of a half-plane gives an estimate of the ratio of each rectangle. Among
/// the rectangles that are near to the wanted ratio, the function takes one where the border is fine at the corners, so
/// that angles change little. Harmonic functions predict the ratio of this rectangle, and it is replaced by another one
/// while the prediction is not within 1 %. The map meets the ratio only approximately; `fit_rectangle()` removes the
/// rest. Section \ref ABF_angles_ratio says how well.
///
/// The border vertex that `bhd` points to is not a corner in general. The first corner is one of the two that are
/// possible: the one that comes first counterclockwise from there. The map of `parameterize()` may turn the first side
/// to any direction.
///
/// The function solves 3 to 15 linear systems with nearly as many unknowns as there are vertices. With \f$b\f$ border
/// vertices, it looks at \cgalBigO{\log b} rectangles for each of up to 64 first corners.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh
/// \param bhd a halfedge on the border of `mesh`: one without a face
/// \param aspect_ratio the length of the side from the first corner to the second one, divided by that of the next
///   side
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver of the linear systems}
///     \cgalParamType{a model of `SparseLinearAlgebraTraits_d`}
///     \cgalParamDefault{`SuperLU_solver_traits<>`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the corners and angles, or what is wrong with the surface, as
///   `ABF_plus_plus_parameterizer_3::report()` says it; or with the ratio (`Diagnosis::WRONG_OPTION`): it is not
///   positive and finite, or no rectangle on this border has it. A border with three vertices is too short
///   (`Diagnosis::SHORT_BORDER`, with its vertices).
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Rectangle_report<TriangleMesh>
rectangle_angles(const TriangleMesh& mesh,
                 typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, double aspect_ratio,
                 const NamedParameters& np = parameters::default_values())
{
  Rectangle_report<TriangleMesh> report;
  internal::ABF::Chart_reader<TriangleMesh> reader(mesh, internal::ABF::given_points<TriangleMesh>(np),
                                                   internal::ABF::given_numbers<TriangleMesh>(np));
  internal::ABF::Rectangle_corners chosen;
  chosen.defect = reader.read(bhd);
  if(!chosen.defect)
    chosen = internal::ABF::choose_rectangle_corners(reader.chart, aspect_ratio,
                                                     internal::ABF::linear_solvers(np));
  if(chosen.defect) {
    internal::ABF::report_defect(chosen.defect, reader, report);
    return report;
  }
  for(int i = 0; i < 4; ++i)
    report.corners[i] = reader.vertex_descriptors[chosen.vertices[i]];
  report.predicted_ratio = chosen.aspect_ratio;
  report.angles = rectangle_angles(mesh, report.corners).angles;
  return report;
}

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// Splits an inner edge in its middle, and both of its triangles.
template <typename TriangleMesh, typename VertexPointMap>
typename boost::graph_traits<TriangleMesh>::vertex_descriptor
split_in_the_middle(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, TriangleMesh& mesh,
                    VertexPointMap points)
{
  const auto middle = CGAL::midpoint(get(points, source(h, mesh)), get(points, target(h, mesh)));
  const auto first = Euler::split_edge(h, mesh); // its target is the new vertex, and `h` follows
  put(points, target(first, mesh), middle);
  const auto back = opposite(h, mesh);
  Euler::split_face(first, next(h, mesh), mesh);
  Euler::split_face(back, next(next(back, mesh), mesh), mesh);
  return target(first, mesh);
}

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

/// \ingroup PkgAngleBasedFlatteningRef
///
/// An edge that was split.
template <typename TriangleMesh>
struct Split_edge
{
  /// Vertex type
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  vertex_descriptor source; ///< One of its vertices.
  vertex_descriptor target; ///< Its other vertex.
  vertex_descriptor middle; ///< The new vertex between them.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `split_flat_chords()` reports.
template <typename TriangleMesh>
struct Split_edges_report : Mesh_report<TriangleMesh>
{
  std::vector<Split_edge<TriangleMesh>> edges; ///< The edges that were split.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// splits the edges of `mesh` that are in the way of a planar border with prescribed angles: those for which
/// `ABF_plus_plus_parameterizer_3::parameterize()` has the diagnosis `Diagnosis::FLAT_CHORD`.
///
/// Such an edge joins two border vertices, and the prescribed border between them is straight, or turns away from the
/// edge. The triangles between the edge and the border would have no area. Most such edges cut off a triangle with two
/// border edges, whose third vertex should be on a straight side. The edge is split in its middle, together with the
/// two triangles beside it, so that it can bend.
///
/// The shape of the surface does not change. If the prescribed angles are wrong in another way, nothing is split. The
/// time is linear.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph` with an internal vertex point property map.
/// \tparam VertexAngleSumMap a model of `ReadablePropertyMap` as for `ABF_plus_plus_parameterizer_3::set_angle_sums()`.
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a triangle mesh.
/// \param bhd a halfedge on the border of `mesh`: one without a face.
/// \param angle_sums the prescribed angles. New vertices are not on the border, and must not have a prescribed angle.
/// \param np optional named parameters:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadWritePropertyMap` with a `Point_3` of any kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the edges that were split, or what is wrong with the surface or with the prescribed angles in another way,
///   as `ABF_plus_plus_parameterizer_3::report()` says it.
template <typename TriangleMesh, typename VertexAngleSumMap,
          typename NamedParameters = parameters::Default_named_parameters>
Split_edges_report<TriangleMesh>
split_flat_chords(TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                  VertexAngleSumMap angle_sums, const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  Split_edges_report<TriangleMesh> report;
  std::vector<vertex_descriptor> ends;
  {
    internal::ABF::Chart_reader<TriangleMesh> reader(mesh, internal::ABF::given_points<TriangleMesh>(np),
                                                     internal::ABF::given_numbers<TriangleMesh>(np));
    internal::ABF::Chart_defect defect = reader.read(bhd);
    if(!defect)
      defect = internal::ABF::diagnose(reader.chart, true);
    if(!defect)
      defect = internal::ABF::read_angle_sums(reader.vertex_descriptors,
                                              internal::ABF::vertex_angle_sums<TriangleMesh>(angle_sums),
                                              mesh, reader.chart);
    if(defect && defect.status != Diagnosis::FLAT_CHORD) {
      internal::ABF::report_defect(defect, reader, report);
      return report;
    }
    for(int v : defect.vertices)
      ends.push_back(reader.vertex_descriptors[v]);
  }
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_property_map(CGAL::vertex_point, mesh));
  for(std::size_t i = 0; i + 1 < ends.size(); i += 2)
    report.edges.push_back(
        {ends[i], ends[i + 1],
         internal::ABF::split_in_the_middle(halfedge(ends[i], ends[i + 1], mesh).first, mesh, points)});
  return report;
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_POLYGON_ANGLES_H
