// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A run of a parameterizer on a mesh: checks options, reads the chart, flattens it, writes coordinates, and reports in
// terms of the mesh. `ABF_plus_plus_parameterizer_3.h` and `Hierarchical_parameterizer_3.h` differ in the function that
// they pass to it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_RUN_PARAMETERIZER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_RUN_PARAMETERIZER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/Containers_filler.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/importance.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/write_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/peak_memory.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#include <boost/property_map/property_map.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The outcome of a run of a parameterizer, in terms of the caller's mesh.
template <typename TriangleMesh, typename Report>
struct Outcome
{
  Report report;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> offending_vertices;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> offending_faces;

  // The outcome if an exception ended the run
  static Outcome interrupted()
  {
    Outcome outcome;
    fail(outcome.report, Diagnosis::CANCELLED, "an exception ended the computation");
    return outcome;
  }

  void name_offenders(const Chart_reader<TriangleMesh>& reader, const std::vector<int>& vertices,
                      const std::vector<int>& triangles)
  {
    for(int v : vertices)
      offending_vertices.push_back(reader.vertex_descriptors[v]);
    for(int t : triangles)
      offending_faces.push_back(reader.face_of_triangle(t));
  }
};

// The outcome of a parameterizer's last run. As functions of CGAL take parameterizers by value, a copy passes its
// outcome on to its original. Several copies may do so at once.
template <typename Outcome>
class Last_outcome
{
  struct Link
  {
    std::mutex mutex;
    Outcome outcome;
    std::shared_ptr<Link> original;
  };

public:
  Last_outcome() : m_link(std::make_shared<Link>()) {}

  Last_outcome(const Last_outcome& other) : Last_outcome()
  {
    const std::lock_guard<std::mutex> lock(other.m_link->mutex);
    m_link->outcome = other.m_link->outcome;
    m_link->original = other.m_link;
  }

  Last_outcome(Last_outcome&&) noexcept = default;

  Last_outcome& operator=(Last_outcome other) noexcept
  {
    std::swap(m_link, other.m_link);
    return *this;
  }

  const Outcome& get() const { return m_link->outcome; }

  void set(const Outcome& outcome)
  {
    for(Link* link = m_link.get(); link != nullptr; link = link->original.get()) {
      const std::lock_guard<std::mutex> lock(link->mutex);
      link->outcome = outcome;
    }
  }

private:
  std::shared_ptr<Link> m_link;
};

// Reads the chart of a border halfedge, flattens it by `flatten`, and writes the coordinates if the map is valid.
template <typename Report, typename TriangleMesh, typename VertexUVmap, typename VertexIndexMap,
          typename Flatten>
class Parameterizer_run
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;

public:
  Parameterizer_run(const TriangleMesh& mesh, halfedge_descriptor bhd, VertexUVmap uvmap,
                    VertexIndexMap vimap, const Prescriptions<TriangleMesh>& prescriptions,
                    const Flattening_options& options, const Flatten& flatten)
      : m_mesh(mesh), m_reader(mesh), m_border(bhd), m_uvmap(uvmap), m_vimap(vimap),
        m_prescriptions(prescriptions), m_options(options), m_flatten(flatten)
  {}

  Outcome<TriangleMesh, Report> run()
  {
    with_threads(m_options.threads, [&]() {
      try {
        if(read())
          flatten();
      } catch(const Cancelled&) {
        fail(m_outcome.report, Diagnosis::CANCELLED, "a visitor stopped the computation");
      }
    });
    m_outcome.report.peak_memory = peak_resident_size();
    return std::move(m_outcome);
  }

private:
  bool read()
  {
    Report& report = m_outcome.report;
    const Stage stage(m_options.visitor, Flattening_visitor::READ, report.seconds.read);
    Chart_defect defect = m_reader.read(m_border, m_vimap);
    if(!defect)
      defect = diagnose(m_reader.chart, m_options.holes != Flattening_options::REFUSE);
    if(!defect)
      defect = read_importance(m_reader, m_prescriptions.importance);
    if(!defect && m_prescriptions.seam_sides) {
      m_reader.link_seams([&](halfedge_descriptor h) { return across_seam(h); });
      defect = find_wrong_seam(m_reader.chart);
    }
    if(!defect)
      defect = m_prescriptions.find_conflict();
    if(!defect && m_prescriptions.wants_equal_seams())
      defect = equalize_seams(m_reader.chart, m_prescriptions.equal_seam_lengths.has_value());
    if(!defect)
      defect =
          read_angle_sums(m_reader.vertex_descriptors, m_prescriptions.angle_sums, m_mesh, m_reader.chart);
    report.vertices = m_reader.chart.number_of_vertices();
    report.triangles = m_reader.number_of_faces();
    report.borders = static_cast<int>(m_reader.chart.borders.size());
    if(!defect)
      return true;
    fail(report, defect.status, defect.message);
    m_outcome.name_offenders(m_reader, defect.vertices, defect.triangles);
    return false;
  }

  halfedge_descriptor across_seam(halfedge_descriptor h) const
  {
    const halfedge_descriptor other = m_prescriptions.seam_sides(opposite(h, m_mesh));
    return other != boost::graph_traits<TriangleMesh>::null_halfedge() && CGAL::is_border(other, m_mesh)
               ? opposite(other, m_mesh)
               : boost::graph_traits<TriangleMesh>::null_halfedge();
  }

  void flatten()
  {
    typedef typename boost::property_traits<VertexUVmap>::value_type Point;
    Report& report = m_outcome.report;
    Flattening<Report> flattening = m_flatten(m_reader.chart, &round_to_points<Point>);
    flattening.report.seconds += report.seconds;
    report = std::move(flattening.report);
    if(report.status != Diagnosis::NOTHING_WRONG) {
      m_outcome.name_offenders(m_reader, {}, flattening.invalid);
      return;
    }
    const Stage stage(m_options.visitor, Flattening_visitor::WRITE, report.seconds.write);
    write_chart(m_reader, flattening.uv, m_uvmap);
  }

  const TriangleMesh& m_mesh;
  Chart_reader<TriangleMesh> m_reader;
  halfedge_descriptor m_border;
  VertexUVmap m_uvmap;
  VertexIndexMap m_vimap;
  const Prescriptions<TriangleMesh>& m_prescriptions;
  const Flattening_options& m_options;
  const Flatten& m_flatten;
  Outcome<TriangleMesh, Report> m_outcome;
};

// `flatten` is called with a chart and a function that rounds its coordinates, and returns a `Flattening<Report>`.
template <typename Report, typename TriangleMesh, typename VertexUVmap, typename VertexIndexMap,
          typename Options, typename Flatten>
Outcome<TriangleMesh, Report>
run_parameterizer(const TriangleMesh& mesh,
                  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVmap uvmap,
                  VertexIndexMap vimap, const Prescriptions<TriangleMesh>& prescriptions,
                  const Options& options, const Flatten& flatten)
{
  std::string wrong = wrong_option(options);
  if(wrong.empty())
    wrong = missing_strategy(options);
  if(!wrong.empty()) {
    Outcome<TriangleMesh, Report> outcome;
    fail(outcome.report, Diagnosis::WRONG_OPTION, wrong);
    return outcome;
  }
  return Parameterizer_run<Report, TriangleMesh, VertexUVmap, VertexIndexMap, Flatten>(
             mesh, bhd, uvmap, vimap, prescriptions, options, flatten)
      .run();
}

// Numbers the vertices of a component, and calls a parameterizer, which checks the halfedge.
template <typename TriangleMesh, typename Parameterizer, typename VertexUVmap>
Error_code parameterize_component(TriangleMesh& mesh, Parameterizer& parameterizer,
                                  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                                  VertexUVmap uvmap)
{
  const auto number = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  if(bhd != boost::graph_traits<TriangleMesh>::null_halfedge() && CGAL::is_border(bhd, mesh))
    internal::fill_index_map_of_cc(bhd, mesh, number);
  return parameterizer.parameterize(mesh, bhd, uvmap, number,
                                    get(CGAL::dynamic_vertex_property_t<bool>(), mesh));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_RUN_PARAMETERIZER_H
