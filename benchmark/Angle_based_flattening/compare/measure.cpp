// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"

#include "../common/Peak_memory.h"
#include "../common/read_mesh.h"
#include "../common/use_cores.h"
#include "../methods/Method.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include <malloc.h>

#include <exception>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace compare {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef ABF_benchmark::Point_2 Point_2;
typedef SMP::internal::ABF::Chart_reader<Mesh> Reader;
typedef boost::graph_traits<Mesh>::halfedge_descriptor Halfedge;

// Seconds and bytes of a method, from where it has the surface in its own form.
Measurement run_method(const ABF_benchmark::Method& method, const Reader& reader, std::vector<Point_2>& uv)
{
  CGAL::Real_timer timer;
  std::unique_ptr<Peak_memory> memory;
  ABF_benchmark::Run_report report;
  report.begin = [&] {
    malloc_trim(0); // what was freed before shall not be used again unseen
    memory = std::make_unique<Peak_memory>();
    timer.reset();
    timer.start();
  };
  report.begin();
  const bool done = method.flatten(reader.chart, uv, report);
  timer.stop();
  if(!done) {
    return failed_measurement(report.failure);
  }
  return {"",
          {{"seconds", timer.time()},
           {"bytes", memory->bytes()},
           {"iterations", static_cast<double>(report.iterations)},
           {"triangles", static_cast<double>(reader.chart.number_of_triangles())}}};
}

void measure_map(Mesh& mesh, const Halfedge border, const Reader& reader, const std::vector<Point_2>& uv,
                 std::map<std::string, double>& numbers)
{
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  for(std::size_t v = 0; v < uv.size(); ++v) {
    map[reader.vertex_descriptors[v]] = uv[v];
  }
  const SMP::Flattening_measures m = SMP::measure_flattening(mesh, border, map);
  numbers["shear"] = m.l2_shear;
  numbers["principal_shear"] = m.l2_principal_shear;
  numbers["equal_stretch_error"] = m.l2_equal_stretch_error;
  numbers["stretch"] = m.l2_stretch;
  numbers["linf_stretch"] = m.linf_stretch;
  numbers["angular"] = m.angular_distortion;
  numbers["quasi_conformal"] = m.mean_quasi_conformal_ratio;
  numbers["area"] = m.l2_area_distortion;
  numbers["symmetric_dirichlet"] = m.symmetric_dirichlet_energy;
  numbers["flips"] = m.flipped_triangles;
  numbers["border_is_simple"] = m.border_is_simple;
}

} // namespace

Measurement measure(const Command_line& command)
{
  try {
    use_cores(command.threads);
    const ABF_benchmark::Method method = ABF_benchmark::find_method(command.run);
    Mesh mesh = read_mesh(command.file);
    const Halfedge border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    Reader reader(mesh);
    if(const auto defect = reader.read(border)) {
      return failed_measurement(defect.message);
    }
    std::vector<Point_2> uv;
    Measurement measurement = run_method(method, reader, uv);
    if(measurement.succeeded()) {
      measure_map(mesh, border, reader, uv, measurement.numbers);
    }
    return measurement;
  } catch(const std::bad_alloc&) {
    return failed_measurement("out of memory");
  } catch(const std::exception& error) {
    return failed_measurement(error.what());
  }
}

} // namespace compare
