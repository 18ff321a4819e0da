// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Single charts: disks that ABF++ or LSCM flattens

#include "interface.h"
#include "results.h"
#include "surfaces.h"
#include "take_options.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

namespace {

using abf::json_text;

using Direct = SMP::ABF_plus_plus_parameterizer_3<Mesh>;
using Hierarchical = SMP::Hierarchical_parameterizer_3<Mesh>;
using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

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
  abf::add_coarse_charts(json, report);
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
  std::vector<Index> angle_vertices, pin_vertices;
  std::vector<double> angles; // of each of these vertices
  std::vector<Kernel::Point_2> pins;

  explicit Prescriptions(const abf_prescriptions& given) : aspect_ratio(given.aspect_ratio)
  {
    const auto vertices = [](const abf_array& array) {
      return is_given(array) ? read_indices(array, std::numeric_limits<Index>::max(), "a vertex", "vertices")
                             : std::vector<Index>();
    };
    corners = vertices(given.corners);
    angle_vertices = vertices(given.angle_vertices);
    pin_vertices = vertices(given.pin_vertices);
    if(is_given(given.angles)) {
      angles = read_numbers(given.angles);
    }
    if(is_given(given.pins)) {
      pins = read_points<Kernel::Point_2, 2>(given.pins);
    }
  }
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
    for(std::size_t i = 0; i < wanted.angles.size(); ++i) {
      angles.set(checked(wanted.angle_vertices[i], mesh, "a vertex with a given angle"), wanted.angles[i]);
    }
    direct.set_angle_sums(angles);
  }
}

void pin(const Prescriptions& wanted, Mesh& mesh, Direct& direct)
{
  if(!wanted.pins.empty()) {
    const auto pins = mesh.add_property_map<Vertex, std::optional<Kernel::Point_2>>("v:pin").first;
    for(std::size_t i = 0; i < wanted.pins.size(); ++i) {
      pins[checked(wanted.pin_vertices[i], mesh, "a pin")] = wanted.pins[i];
    }
    direct.set_pins(pins);
  }
}

// Flattens a mesh, and again when its vertices have moved.
class Flattener
{
public:
  Flattener(const abf_mesh& mesh, const bool is_hierarchical, const char* const options,
            const abf_prescriptions& prescriptions)
      : m_given(mesh), m_prescriptions(prescriptions),
        m_hierarchical(is_hierarchical
                           ? std::make_optional<Hierarchical>(watched(
                                 options_of<SMP::Hierarchical_options>(options, "the hierarchical method")))
                           : std::nullopt),
        m_direct(watched(
            options_of<SMP::ABF_plus_plus_options>(is_hierarchical ? "{}" : options, "the direct method")))
  {}

  Flattening solve(const abf_array& vertices, abf_progress& state)
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
    return with_failures(
        [&] { return m_hierarchical ? solve(*m_hierarchical, state) : solve(m_direct, state); });
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
      throw Wrong_value("there are " + std::to_string(points.size()) + " vertices, and were " +
                        std::to_string(mesh.number_of_vertices()) + " before");
    }
    for(const Vertex v : mesh.vertices()) {
      mesh.point(v) = points[v.idx()];
    }
  }

  template <class Parameterizer>
  Flattening solve(Parameterizer& parameterizer, abf_progress& state)
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
  abf_mesh m_given; // Python keeps its arrays
  Prescriptions m_prescriptions;
  std::optional<Hierarchical> m_hierarchical;
  Direct m_direct;
  std::unique_ptr<Surface> m_surface;
  std::mutex m_mutex;
};

Flattening lscm(const abf_mesh& given)
{
  Surface surface = surface_of(soup_of(given, ""));
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
}

abf_result* result_of_flattening(const std::function<Flattening()>& f)
{
  return result_of([&f](abf_result& result) {
    Flattening flattening = f();
    result.add_points(flattening.uv);
    result.text = std::move(flattening.json);
  });
}

} // namespace

} // namespace abf_python

using namespace abf_python;

// For Python, a `Flattener` is an address.
abf_result* abf_make_flattener(const abf_mesh* const mesh, const int is_hierarchical,
                               const char* const options, const abf_prescriptions* const prescriptions,
                               abf_flattener** const flattener)
{
  return result_of([&](abf_result&) {
    *flattener =
        reinterpret_cast<abf_flattener*>(new Flattener(*mesh, is_hierarchical != 0, options, *prescriptions));
  });
}

abf_result* abf_solve(abf_flattener* const flattener, const abf_array* const vertices,
                      abf_progress* const progress)
{
  return result_of_flattening(
      [&] { return reinterpret_cast<Flattener*>(flattener)->solve(*vertices, *progress); });
}

void abf_free_flattener(abf_flattener* const flattener)
{
  delete reinterpret_cast<Flattener*>(flattener);
}

abf_result* abf_lscm(const abf_mesh* const mesh, abf_progress*)
{
  return result_of_flattening([&] { return with_failures([&] { return lscm(*mesh); }); });
}
