// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All of `flatten_with_cones()`: selects cones, cuts through them, and flattens with equal sides of seams and the
// angles of the cones. Included by `flatten_with_cones.h`. The map comes from ABF++ with the equations of
// `chart/seam_nodes.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CONE_FLATTENER_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CONE_FLATTENER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Cone_selection.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Texture_atlas/internal/cones/choose_cones.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_surface_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_directly.h>
#endif

namespace CGAL::Texture_atlas::internal {

// Chooses cones, leads seams through them, and flattens the resulting disk. Writes seams and coordinates if all of this
// succeeds.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename NamedParameters>
class Cone_flattener
{
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<bool>>::const_type Marks;

public:
  Cone_flattener(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uvmap,
                 const Cone_options& options, const NamedParameters& np)
      : m_mesh(mesh), m_seams(seams), m_uvmap(uvmap), m_cone_options(options),
        m_options(options.parameterizer), m_np(np), m_marks(get(CGAL::dynamic_edge_property_t<bool>(), mesh)),
        m_reader(mesh,
                 parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, mesh)),
                 given_numbers<TriangleMesh>(np))
  {}

  Cone_flattening<TriangleMesh> run(std::size_t number_of_cones)
  {
    const Report end = run_bounded(m_options.time_limit, [&] { compute(number_of_cones); });
    if(!end) {
      internal::fail(m_result.map, end.status, end.message);
      static_cast<Report&>(m_result) = end;
    }
    m_result.map.peak_memory = peak_resident_size();
    return std::move(m_result);
  }

private:
  void compute(std::size_t number_of_cones)
  {
    m_result.cones = select_cones_of_mesh(m_mesh, number_of_cones, m_cone_options, m_np);
    if(!m_result.cones) {
      fail(m_result.cones);
      return;
    }
    for(const auto& e : edges(m_mesh))
      put(m_marks, e, false);
    const auto cones = m_result.cones.vertices();
    const auto seams =
        cut_to_disks(m_mesh, m_marks, m_np.vertex_is_constrained_map(CGAL::make_boolean_property_map(cones)));
    m_result.seams = seams;
    if(!seams) {
      fail(seams);
      return;
    }
    with_threads(m_options.threads, [&] { flatten(); });
    if(!m_result.map) {
      m_result.status = m_result.map.status;
      m_result.message = m_result.map.message;
    }
  }

  template <typename PartReport>
  void fail(const PartReport& part)
  {
    m_result.status = part.status;
    m_result.message = part.message;
    m_result.offending_vertices = part.offending_vertices;
    m_result.offending_edges = part.offending_edges;
    m_result.offending_faces = part.offending_faces;
  }

  // Names vertices and triangles of the surface, cut open, whose corners are those of the surface.
  void name_offenders(const Chart& chart, const std::vector<int>& offending_vertices,
                      const std::vector<int>& triangles)
  {
    for(int v : offending_vertices) {
      const auto corner = std::find(chart.vertex.begin(), chart.vertex.end(), v) - chart.vertex.begin();
      m_result.offending_vertices.push_back(target(m_reader.halfedge_to(static_cast<int>(corner)), m_mesh));
    }
    for(int t : triangles)
      m_result.offending_faces.push_back(m_reader.face_of(t));
  }

  bool are_free() const { return m_cone_options.angles == Cone_angles::FREE; }

  void flatten()
  {
    typedef typename boost::property_traits<HalfedgeUVMap>::value_type Point;
    const Chart chart = read();
    if(m_result.map.status != Diagnosis::NOTHING_WRONG)
      return;
    const Linear_solvers solvers = linear_solvers(m_np);
    Flattening<ABF_plus_plus_report> flattening =
        flatten_chart(chart, m_options, solvers, &round_to_points<Point>);
    m_result.map = std::move(flattening.report);
    if(!m_result.map) {
      name_offenders(chart, {}, flattening.invalid);
      return;
    }
    for(const auto& e : edges(m_mesh))
      put(m_seams, e, bool(get(m_marks, e)));
    for(int c = 0; c < chart.number_of_corners(); ++c) {
      const Point p = planar_point<Point>(flattening.uv[chart.vertex[c]]);
      const auto h = m_reader.halfedge_to(c);
      put(m_uvmap, h, p);
      if(const auto border = opposite(next(h, m_mesh), m_mesh); CGAL::is_border(border, m_mesh))
        put(m_uvmap, border, p);
    }
  }

  // The surface, cut open; or what is wrong
  Chart read()
  {
    Chart chart;
    Chart_defect defect = find_wrong_option();
    if(!defect) {
      Mesh_report<TriangleMesh, Seam_report> report; // the surface was read before without complaint
      m_reader.read([](const auto&) { return false; }, report);
      chart = cut_open(m_reader.parts().front().chart);
      defect = diagnose(chart, false);
    }
    if(!defect)
      defect = find_no_area(chart, degenerate_triangles(chart));
    if(!defect && m_options.equal_seam_lengths.value_or(true))
      defect = equalize_seams(chart);
    if(!defect && !are_free() && chart.equal_seams)
      defect = set_angle_sums(sums_at_seams(chart), chart);
    if(defect) {
      internal::fail(m_result.map, defect.status, defect.message);
      name_offenders(chart, defect.vertices, defect.triangles);
    }
    return chart;
  }

  Chart_defect find_wrong_option() const
  {
    std::string message = wrong_option(m_options);
    if(message.empty() && !are_free() && !m_options.equal_seam_lengths.value_or(true))
      message = "cones with given angles need seams of equal lengths";
    if(message.empty())
      return {};
    return {Diagnosis::WRONG_OPTION, message, {}, {}};
  }

  Chart cut_open(const Chart& surface) const
  {
    std::vector<char> is_seam;
    for(int c = 0; c < surface.number_of_corners(); ++c)
      is_seam.push_back(surface.opposite[c] >= 0 && get(m_marks, m_reader.edge_of(c)));
    return opened_along_seams(surface, std::vector<double>(surface.vertex.size(), 0.), is_seam).chart;
  }

  // The angles of all copies of the cones; other vertices on seams get full turns
  std::vector<double> sums_at_seams(const Chart& chart) const
  {
    std::vector<double> sums(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)());
    const Surface_mesh_parameterization::Vertex_angles<TriangleMesh> angles = m_result.cones.angles();
    for(int c = 0; c < chart.number_of_corners(); ++c)
      if(const auto angle = angles[target(m_reader.halfedge_to(c), m_mesh)])
        sums[chart.vertex[c]] = *angle;
    return sums;
  }

  const TriangleMesh& m_mesh;
  EdgeIsSeamMap m_seams;
  HalfedgeUVMap m_uvmap;
  const Cone_options& m_cone_options;
  const ABF_plus_plus_options& m_options;
  const NamedParameters& m_np;
  Marks m_marks; // of the seams
  Surface_reader<TriangleMesh, Vertex_point_map, Mesh_report<TriangleMesh, Seam_report>> m_reader;
  Cone_flattening<TriangleMesh> m_result;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CONE_FLATTENER_H
