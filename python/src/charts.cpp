// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Single charts: disks that ABF++ or LSCM flattens

#include "bindings.h"
#include "option_taker.h"
#include "surfaces.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>

#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

namespace {

using CGAL::Texture_atlas::internal::Json;
using CGAL::Texture_atlas::internal::json_text;

using Direct = SMP::ABF_plus_plus_parameterizer_3<Mesh>;
using Hierarchical = SMP::Hierarchical_parameterizer_3<Mesh>;
using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

template <class Options>
Options options_of(const py::dict& given, const std::string& method)
{
  Options options;
  take_options(given, "the " + method + " method", options);
  return options;
}

Json common_json(const SMP::Flattening_report& report, const std::string& method)
{
  return {{"method", method},
          {"vertices", report.vertices},
          {"triangles", report.triangles},
          {"borders", report.borders},
          {"border_is_simple", report.border_is_simple},
          {"flipped_triangles", report.flipped_triangles},
          {"injective", report.injective},
          {"smallest_angle", report.smallest_angle},
          {"contact", report.contact},
          {"largest_pin_distance", report.largest_pin_distance},
          {"seconds", report.seconds.total()}};
}

std::string json_of(const SMP::ABF_plus_plus_report& report)
{
  Json json = common_json(report, "direct");
  json.update({{"strategy", to_string(report.strategy)},
               {"converged", report.converged},
               {"iterations", report.iterations},
               {"energy", report.energy},
               {"constraint_residual", report.constraint_residual},
               {"side_deviation", report.side_deviation}});
  return json_text(json);
}

std::string json_of(const SMP::Hierarchical_report& report)
{
  Json json = common_json(report, "hierarchical");
  json.update({{"levels", report.levels},
               {"coarse_triangles", report.coarse_triangles},
               {"relaxed_angles", report.relaxed_angles},
               {"polished", report.polished},
               {"note", report.note}});
  CGAL::Texture_atlas::internal::add_coarse_charts(json, report);
  return json_text(json);
}

struct Flattening
{
  std::vector<Kernel::Point_2> uv; // of each vertex; NaN outside of the chart
  std::string json;
};

UV_map empty_coordinates(Mesh& mesh)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  return mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv", Kernel::Point_2(none, none)).first;
}

// What a chart should look like
struct Prescriptions
{
  std::vector<Index> corners; // of a rectangle: none or four
  double aspect_ratio = 0;    // if not 0, corners for this ratio are chosen
  std::vector<std::pair<Index, double>> angles;
  std::vector<std::pair<Index, std::array<double, 2>>> pins;
};

// Vertices that do not exist, and no number but one of an existing one
Vertex checked(const Index v, const Mesh& mesh, const char* const what)
{
  return Vertex(index_below(v, mesh.number_of_vertices(), what, "vertices"));
}

void prescribe(const Prescriptions& wanted, const Surface& surface, Direct& direct)
{
  const Mesh& mesh = surface.mesh;
  const auto take = [&](const auto& rectangle) {
    check_report(surface, rectangle);
    direct.set_angle_sums(rectangle.angles);
  };
  if(wanted.aspect_ratio > 0) {
    take(SMP::rectangle_angles(mesh, CGAL::Polygon_mesh_processing::longest_border(mesh).first,
                               wanted.aspect_ratio, CGAL::parameters::vertex_index_map(vertex_numbers())));
  } else if(!wanted.corners.empty()) {
    std::array<Vertex, 4> corners;
    for(std::size_t i = 0; i < 4; ++i) {
      corners[i] = checked(wanted.corners[i], mesh, "a corner");
    }
    take(SMP::rectangle_angles(mesh, corners, CGAL::parameters::vertex_index_map(vertex_numbers())));
  }
  if(!wanted.angles.empty()) {
    SMP::Vertex_angles<Mesh> angles;
    for(const auto& [v, angle] : wanted.angles) {
      angles.set(checked(v, mesh, "a vertex with a given angle"), angle);
    }
    direct.set_angle_sums(angles);
  }
}

void pin(const Prescriptions& wanted, Mesh& mesh, Direct& direct)
{
  if(!wanted.pins.empty()) {
    const auto pins = mesh.add_property_map<Vertex, std::optional<Kernel::Point_2>>("v:pin").first;
    for(const auto& [v, p] : wanted.pins) {
      pins[checked(v, mesh, "a pin")] = Kernel::Point_2(p[0], p[1]);
    }
    direct.set_pins(pins);
  }
}

// Flattens a mesh, and again when its vertices have moved.
class Flattener
{
public:
  Flattener(Given_mesh mesh, const bool is_hierarchical, const py::dict& options, Prescriptions prescriptions)
      : m_given(std::move(mesh)), m_prescriptions(std::move(prescriptions)),
        m_hierarchical(is_hierarchical ? std::make_optional<Hierarchical>(watched(
                                             options_of<SMP::Hierarchical_options>(options, "hierarchical")))
                                       : std::nullopt),
        m_direct(
            watched(options_of<SMP::ABF_plus_plus_options>(is_hierarchical ? py::dict() : options, "direct")))
  {}

  Flattening solve(const py::array& vertices, const Watch& watch)
  {
    const std::unique_lock<std::mutex> lock(m_mutex, std::try_to_lock);
    if(!lock) {
      throw std::runtime_error("this Flattener is at work in another thread; give each thread its own");
    }
    if(!m_surface) {
      m_given.vertices = vertices;
      build(soup_of(m_given, ""));
    } else {
      move_vertices(read_points<Kernel::Point_3, 3>(vertices));
    }
    return run_interruptibly(watch, [this](Progress_state& state) {
      return with_failures(
          [&] { return m_hierarchical ? solve(*m_hierarchical, state) : solve(m_direct, state); });
    });
  }

private:
  template <class Options>
  Options watched(Options options)
  {
    options.visitor = &m_watcher;
    return options;
  }

  void build(Surface_soup&& soup)
  {
    Surface surface = surface_of(std::move(soup));
    prescribe(m_prescriptions, surface, m_direct);
    pin(m_prescriptions, surface.mesh, m_direct);
    m_surface = std::make_unique<Surface>(std::move(surface));
  }

  void move_vertices(std::vector<Kernel::Point_3>&& points)
  {
    Mesh& mesh = m_surface->mesh;
    if(points.size() != mesh.number_of_vertices()) {
      throw py::value_error("there are " + std::to_string(points.size()) + " vertices, and were " +
                            std::to_string(mesh.number_of_vertices()) + " before");
    }
    for(const Vertex v : mesh.vertices()) {
      mesh.point(v) = points[v.idx()];
    }
  }

  template <class Parameterizer>
  Flattening solve(Parameterizer& parameterizer, Progress_state& state)
  {
    Mesh& mesh = m_surface->mesh;
    const UV_map uv = empty_coordinates(mesh);
    m_watcher.follow(state);
    const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    if(border == Mesh::null_halfedge()) {
      throw Mesh_failure("NO_BORDER",
                         "the surface is closed: it has no border; cut it open first, or call atlas()");
    }
    parameterizer.set_vertex_numbers(vertex_numbers());
    SMP::parameterize(mesh, parameterizer, border, uv);
    check_report(*m_surface, parameterizer.report());
    Flattening result{{}, json_of(parameterizer.report())};
    for(const Vertex v : mesh.vertices()) {
      result.uv.push_back(uv[v]);
    }
    return result;
  }

  Flattening_watcher m_watcher;
  Given_mesh m_given;
  Prescriptions m_prescriptions;
  std::optional<Hierarchical> m_hierarchical;
  Direct m_direct;
  std::unique_ptr<Surface> m_surface;
  std::mutex m_mutex;
};

Flattening lscm(const Given_mesh& given, const Watch& watch)
{
  Surface_soup soup = soup_of(given, "");
  return run_interruptibly(watch, [&](Progress_state&) {
    return with_failures([&] {
      Surface surface = surface_of(std::move(soup));
      Mesh& mesh = surface.mesh;
      const UV_map uv = empty_coordinates(mesh);
      const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
      if(border == Mesh::null_halfedge()) {
        throw Mesh_failure("NO_BORDER", "the surface is closed: it has no border; cut it open first");
      }
      const SMP::Error_code error = SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), border, uv);
      if(error != SMP::OK) {
        throw Mesh_failure("LSCM_FAILED", SMP::get_error_message(error));
      }
      Flattening result{{}, "{\"method\": \"lscm\"}"};
      for(const Vertex v : mesh.vertices()) {
        result.uv.push_back(uv[v]);
      }
      return result;
    });
  });
}

py::tuple tuple_of(const Flattening& flattening)
{
  return py::make_tuple(array_of_points(flattening.uv), flattening.json);
}

} // namespace

void bind_charts(py::module_& module)
{
  py::class_<Prescriptions>(module, "Prescriptions")
      .def(py::init([](std::vector<Index> corners, const double aspect_ratio,
                       std::vector<std::pair<Index, double>> angles,
                       std::vector<std::pair<Index, std::array<double, 2>>> pins) {
        return Prescriptions{std::move(corners), aspect_ratio, std::move(angles), std::move(pins)};
      }));
  py::class_<Flattener>(module, "Flattener")
      .def(py::init<Given_mesh, bool, py::dict, Prescriptions>())
      .def("solve", [](Flattener& flattener, const py::array& vertices, const Watch& watch) {
        return tuple_of(flattener.solve(vertices, watch));
      });
  module.def("lscm",
             [](const Given_mesh& given, const Watch& watch) { return tuple_of(lscm(given, watch)); });
}

} // namespace abf_python
