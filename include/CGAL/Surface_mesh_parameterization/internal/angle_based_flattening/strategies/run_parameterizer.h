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

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/Containers_filler.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_pins.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>

#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_surface_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_directly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/pin_map.h>
#endif

#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What a run of a parameterizer tells, in terms of the caller's mesh.
template <typename TriangleMesh, typename Report>
struct Outcome
{
  Mesh_report<TriangleMesh, Report> report;
  std::shared_ptr<const Planar_angles> angles; // of the last map, if a later run is to start there

  // That of a run which an exception ends
  static std::shared_ptr<const Outcome> interrupted()
  {
    const auto outcome = std::make_shared<Outcome>();
    fail(outcome->report, Diagnosis::CANCELLED, "an exception ended the computation");
    return outcome;
  }

  void name_offenders(const Chart_reader<TriangleMesh>& reader, const std::vector<int>& vertices,
                      const std::vector<int>& triangles)
  {
    for(int v : vertices)
      report.offending_vertices.push_back(reader.vertex_descriptors[v]);
    for(int t : triangles)
      report.offending_faces.push_back(reader.face_of_triangle(t));
  }
};

// The outcome of a parameterizer's last run. As functions of CGAL take parameterizers by value, a copy passes its
// outcome on to what it was copied from. Several copies may do so at once. That takes no memory, which might run out
// when the coordinates are written already.
template <typename Outcome>
class Last_outcome
{
  struct Link
  {
    std::mutex mutex;
    std::shared_ptr<const Outcome> outcome = std::make_shared<const Outcome>();
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

  const Outcome& get() const { return *m_link->outcome; }

  std::shared_ptr<const Planar_angles> angles() const
  {
    const std::lock_guard<std::mutex> lock(m_link->mutex);
    return m_link->outcome->angles;
  }

  void set(const std::shared_ptr<const Outcome>& outcome)
  {
    for(Link* link = m_link.get(); link != nullptr; link = link->original.get()) {
      const std::lock_guard<std::mutex> lock(link->mutex);
      link->outcome = outcome;
    }
  }

private:
  std::shared_ptr<Link> m_link;
};

// Reads the chart of a border halfedge with all that is prescribed for it, and checks it. Counts in the report.
template <typename TriangleMesh, typename VertexIndexMap>
Chart_defect read_prescribed_chart(const TriangleMesh& mesh,
                                   typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                                   VertexIndexMap vimap, const Prescriptions<TriangleMesh>& prescriptions,
                                   Flattening_options::Holes holes, Chart_reader<TriangleMesh>& reader,
                                   Flattening_report& report)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  Chart_defect defect = reader.read(bhd, vimap);
  if(!defect)
    defect = diagnose(reader.chart, holes != Flattening_options::REFUSE);
  report.vertices = reader.chart.number_of_vertices();
  report.triangles = reader.number_of_faces();
  report.borders = static_cast<int>(reader.chart.borders.size());
  if(!defect) {
    std::vector<int> degenerate = degenerate_triangles(reader.chart);
    report.degenerate_triangles = static_cast<int>(degenerate.size());
    defect = find_no_area(reader.chart, std::move(degenerate));
  }
  if(!defect)
    defect = read_importance(reader, prescriptions.importance);
  if(!defect && prescriptions.seam_sides) {
    reader.link_seams([&](typename Graph_traits::halfedge_descriptor h) {
      const auto other = prescriptions.seam_sides(opposite(h, mesh));
      return other != Graph_traits::null_halfedge() && CGAL::is_border(other, mesh)
                 ? opposite(other, mesh)
                 : Graph_traits::null_halfedge();
    });
    defect = find_wrong_seam(reader.chart);
  }
  reader.end();
  if(!defect)
    defect = prescriptions.find_conflict();
  if(!defect && prescriptions.wants_equal_seams())
    defect = equalize_seams(reader.chart, prescriptions.equal_seam_lengths.has_value());
  if(!defect)
    defect = read_angle_sums(reader.vertex_descriptors, prescriptions.angle_sums, mesh, reader.chart);
  if(!defect)
    defect = read_pins<TriangleMesh>(reader.vertex_descriptors, prescriptions.pins, reader.chart);
  return defect;
}

// Reads a chart, flattens it, and writes the coordinates if the map is valid. `flatten` is called with the chart, which
// it may consume if there are no pins, and with what rounds its coordinates; it returns a `Flattening<Report>`.
template <typename Report, typename TriangleMesh, typename VertexUVmap, typename VertexIndexMap,
          typename Options, typename Flatten>
std::shared_ptr<Outcome<TriangleMesh, Report>>
run_parameterizer(const TriangleMesh& mesh,
                  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVmap uvmap,
                  VertexIndexMap vimap, const Prescriptions<TriangleMesh>& prescriptions,
                  const Options& options, const Linear_solvers& solvers, const Flatten& flatten)
{
  const auto outcome = std::make_shared<Outcome<TriangleMesh, Report>>();
  Report& report = outcome->report;
  if(const std::string wrong = wrong_option(options); !wrong.empty()) {
    fail(report, Diagnosis::WRONG_OPTION, wrong);
    return outcome;
  }
  const auto run = [&] {
    Chart_reader<TriangleMesh> reader(mesh, prescriptions.points, prescriptions.numbers);
    {
      const Stage stage(options.visitor, Flattening_visitor::READ, report.seconds.read);
      const Chart_defect defect =
          read_prescribed_chart(mesh, bhd, vimap, prescriptions, options.holes, reader, report);
      if(defect) {
        fail(report, defect.status, defect.message);
        outcome->name_offenders(reader, defect.vertices, defect.triangles);
        return;
      }
    }
    if(!prescriptions.may_have_pins && reader.chart.pins.empty() && !std::isinf(options.pin_weight)) {
      fail(report, Diagnosis::WRONG_OPTION,
           "pin_weight would have no effect: there are no pins, see set_pins()");
      return;
    }
    // A map with pins is rounded when it has been moved to them.
    const Rounding round = &round_to_points<typename boost::property_traits<VertexUVmap>::value_type>;
    const bool has_pins = !reader.chart.pins.empty();
    Flattening<Report> flattening =
        flatten(reader.chart, has_pins ? [](std::vector<Chart::Point_2>&) {} : round);
    if(has_pins && flattening.succeeded())
      pin_map(reader.chart, options, solvers, round, flattening);
    flattening.report.seconds += report.seconds;
    flattening.report.degenerate_triangles = report.degenerate_triangles;
    report = std::move(flattening.report);
    outcome->angles = std::move(flattening.angles);
    if(report.status != Diagnosis::NOTHING_WRONG) {
      outcome->name_offenders(reader, flattening.offending_vertices, flattening.invalid);
      return;
    }
    const Stage stage(options.visitor, Flattening_visitor::WRITE, report.seconds.write);
    write_chart(reader, flattening.uv, uvmap);
  };
  const auto end = run_bounded(options.time_limit, [&] { with_threads(options.threads, run); });
  if(!end)
    fail(report, end.status, end.message);
  report.peak_memory = peak_resident_size();
  return outcome;
}

// The vertices of the component of a border halfedge, numbered
template <typename TriangleMesh>
auto numbered_vertices(const TriangleMesh& mesh,
                       typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd)
{
  const auto number = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  if(bhd != boost::graph_traits<TriangleMesh>::null_halfedge() && CGAL::is_border(bhd, mesh))
    internal::fill_index_map_of_cc(bhd, mesh, number);
  return number; // for a wrong halfedge, which the parameterizer refuses, without numbers
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_RUN_PARAMETERIZER_H
