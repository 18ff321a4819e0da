// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SELECT_SEAMS_H
#define CGAL_TEXTURE_ATLAS_SELECT_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Texture_atlas/internal/seams/apply_seams.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

/// \file select_seams.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

cuts a surface of any topology to disks that can be flattened with little stretch.

First, the surface is cut to disks as by `cut_to_disks()`. The cotangent Laplacian then predicts the scale \f$e^u\f$ of
a conformal map: \f$L u = -K\f$, where \f$K\f$ is the angle defect of a vertex, and \f$u\f$ vanishes on seams and
borders. The vertex with the largest \f$|u|\f$ becomes a *terminal*: the shortest path joins it to the seams. This is
repeated until the predicted \f$L_2\f$ stretch \f$\sqrt{\overline{e^{-2u}}\;\overline{e^{2u}}}\f$, with means over the
area, is at most `Seam_options::stretch_bound`. Key-path exchange then shortens the seams. A sphere has at least two
terminals; the first one is the vertex where it would shrink most.

The stretch of a map by ABF++ is usually within a few percent of the prediction. Coarse triangulations with long thin
triangles can stretch more: measure the map.

Seams of surfaces with more than 12,000 vertices are selected on a coarser copy with 5,000 vertices, and drawn on the
surface as shortest paths near those of the copy. If constrained edges bar such a path, the shortest path anywhere
replaces it, and the stretch is predicted again on the surface itself. It may then miss the bound. Given seams remain
seams, and count as borders.

For \f$n\f$ triangles, the copy and the paths take time \f$O(n \log n)\f$. The Laplacian of the copy is factored once,
and again where exchanges change many seams. Each vertex of the path to a terminal takes one solution.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams the seams: marked edges stay seams, and new seams are marked; unchanged if anything is wrong
\param options the options
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must not become seams}
    \cgalParamType{a model of `ReadablePropertyMap` with `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{the cost of a seam along each edge}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of the linear systems}
    \cgalParamType{a model of `SparseLinearAlgebraTraits_d`}
    \cgalParamDefault{`SuperLU_solver_traits<>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the length of all seams, and what is wrong, if anything. `Diagnosis::NO_CUT_ALLOWED` means that the edges that
may become seams leave no way to cut.
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Seam_report> select_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                    const Seam_options& options = Seam_options(),
                                                    const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Mesh_report<TriangleMesh, Seam_report> report;
  report.message = internal::wrong_option(options);
  if(!report.message.empty()) {
    report.status = Diagnosis::WRONG_OPTION;
    return report;
  }
  const internal::Linear_solvers solvers = internal::linear_solvers(np);
  internal::Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, true);
  const Report end = internal::run_bounded(options.time_limit, [&] {
    report = application.run([&](const internal::Surface_part& part) {
      return internal::find_seams(part.chart, part.cost, options, solvers);
    });
  });
  if(!end) {
    static_cast<Report&>(report) = end;
    return report;
  }
  report.bound_reached = report.predicted_stretch <= options.stretch_bound;
  return report;
}

/// \ingroup PkgTextureAtlasRef
///
/// selects seams as above, with the default options.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_report<TriangleMesh, Seam_report> select_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                    const CGAL_NP_CLASS& np)
{
  return select_seams(mesh, seams, Seam_options(), np);
}

/*!
\ingroup PkgTextureAtlasRef

cuts a surface of any topology to disks along short seams, without regard to its shape.

Borders are joined by shortest paths, in the manner of Mehlhorn's approximation of Steiner trees. Handles are cut along
the greedy homotopy basis of Erickson and Whittlesey (2005). Key-path exchange then shortens the seams: without one path
between two branches, the disk is an annulus, and the shortest path between the two borders of the annulus makes it a
disk again. A sphere is cut along a path between two vertices that are far from each other.

The seams reach all given vertices (`vertex_is_constrained_map`), and then have no other ends inside the surface: a
sphere with two or more given vertices is cut along a tree that joins them. Given vertices on borders and on given seams
count as reached.

Given seams remain seams, and count as borders. A seam of one edge on a sphere becomes longer, because a border of two
edges is not a polygon. To get disks that can be flattened with little stretch, call `select_seams()`.

For \f$n\f$ triangles, the time is \f$O(n \log n)\f$, with any number of given vertices, and that of the exchanges. An
exchange visits the vertices that are nearest to its seam; all of them visit each vertex at most 100 times.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams the seams: marked edges stay seams, and new seams are marked; unchanged if anything is wrong
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must not become seams}
    \cgalParamType{a model of `ReadablePropertyMap` with `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{the cost of a seam along each edge}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the vertices that seams must reach, such as cones}
    \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key
    type and `bool` as value type. `TriangleMesh` must then also be a model of `VertexListGraph`.}
    \cgalParamDefault{no vertex}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the length of all seams, and what is wrong, if anything. `Diagnosis::NO_CUT_ALLOWED` means that the edges that
may become seams leave no way to cut. `Diagnosis::WRONG_OPTION` means that a given vertex has no face.
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Seam_report> cut_to_disks(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                    const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  internal::Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, true);
  Mesh_report<TriangleMesh, Seam_report> report;
  if(!internal::can_reach_terminals(mesh, np, report))
    return report;
  return application.run([&](const internal::Surface_part& part) {
    return internal::find_topological_seams(part.chart, part.cost, application.terminals_of(part));
  });
}

/*!
\ingroup PkgTextureAtlasRef

shortens seams that leave disks. The shorter seams leave disks as well.

The method is key-path exchange, as in `cut_to_disks()`. The ends of seams inside the surface do not move. Seams that
leave anything else than disks are shortened where a path has the same border on both sides.

Searches visit each vertex 100 times at most.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams which edges are seams; unchanged if anything is wrong
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must not become seams}
    \cgalParamType{a model of `ReadablePropertyMap` with `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{the cost of a seam along each edge}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the length of all seams, and what is wrong, if anything
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Seam_report> shorten_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                     const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  internal::Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np,
                                                                                       false);
  return application.run([&](const internal::Surface_part& part) {
    return internal::shorten_seams(part.chart, part.cost, application.seams_of(part));
  });
}

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SELECT_SEAMS_H
