// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SPLIT_FLAT_CHORDS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SPLIT_FLAT_CHORDS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Mesh_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

/// \file split_flat_chords.h

namespace CGAL {

namespace Surface_mesh_parameterization {

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
    internal::ABF::Chart_reader<TriangleMesh> reader(mesh, internal::ABF::given_points<TriangleMesh>(np));
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

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SPLIT_FLAT_CHORDS_H
