// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is known of a map: its distortion, its certificate, its place on pages

#include "bindings.h"
#include "option_taker.h"
#include "surfaces.h"

#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/Texture_atlas/pack_charts.h>

#include <pybind11/stl.h>

#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace abf_python {

namespace {

using CGAL::Texture_atlas::internal::Json;
using CGAL::Texture_atlas::internal::json_text;

std::string measures_json(const SMP::Flattening_measures& measures)
{
  Json json;
  CGAL::Texture_atlas::internal::add_measures(json, &measures);
  json["flipped_triangles"] = measures.flipped_triangles;
  json["border_is_simple"] = measures.border_is_simple;
  return json_text(json);
}

std::string measure(const Given_mesh& given, const Watch& watch)
{
  Surface_soup soup = soup_of(given, "");
  return run_interruptibly(watch, [&](Progress_state&) {
    return with_failures([&] {
      Surface surface = surface_of(std::move(soup));
      const auto report = SMP::measure_flattening(surface.mesh, corner_map(surface),
                                                  CGAL::parameters::vertex_index_map(vertex_numbers()));
      check_report(surface, report);
      return measures_json(report);
    });
  });
}

struct Certificate
{
  bool is_injective = false;
  std::vector<std::int64_t> flipped, overlapping;
};

Certificate certify(const Given_mesh& given, const Watch& watch)
{
  Surface_soup soup = soup_of(given, "");
  return run_interruptibly(watch, [&](Progress_state&) {
    return with_failures([&] {
      Surface surface = surface_of(std::move(soup));
      const auto uv = corner_map(surface);
      Certificate certificate;
      certificate.is_injective = SMP::is_injective(surface.mesh, uv);
      if(!certificate.is_injective) {
        std::vector<Face> faces;
        SMP::flipped_faces(surface.mesh, uv, std::back_inserter(faces));
        certificate.flipped = faces_in_soup(surface, faces);
        faces.clear();
        TA::overlapping_faces(surface.mesh, uv, std::back_inserter(faces));
        certificate.overlapping = faces_in_soup(surface, faces);
      }
      return certificate;
    });
  });
}

TA::Packing_options packing_options(const py::dict& given)
{
  TA::Packing_options options;
  take_options(given, "packing", options);
  return options;
}

std::string packing_json(const TA::Packing_report& report)
{
  return json_text({{"pages", report.number_of_pages},
                    {"page_of_chart", report.page_of_chart},
                    {"scale_of_chart", report.scale_of_chart},
                    {"covered_share", report.covered_share},
                    {"faces_off_grid", report.faces_off_grid},
                    {"texels_per_unit", report.texels_per_length}});
}

struct Packing
{
  std::vector<Kernel::Point_2> uv; // of each vertex; NaN where no face is
  std::string json;
};

// The vertices of several charts, each with its own ones: those of chart i begin at `first_faces[i]`, likewise.
Packing pack(const Given_mesh& given, const std::vector<std::size_t>& first_faces,
             const py::dict& given_options, const Watch& watch)
{
  Surface_soup soup = soup_of(given, "");
  const TA::Packing_options options = packing_options(given_options);
  return run_interruptibly(watch, [&](Progress_state&) {
    return with_failures([&] {
      Surface surface = surface_of(std::move(soup));
      Mesh& mesh = surface.mesh;
      const auto chart = mesh.add_property_map<Face, int>("f:chart").first;
      for(const Face f : mesh.faces()) {
        const auto after = std::upper_bound(first_faces.begin(), first_faces.end(), face_in_soup(surface, f));
        chart[f] = static_cast<int>(after - first_faces.begin()) - 1;
      }
      const auto uv = corner_map(surface);
      const auto report =
          TA::pack_charts(mesh, chart, uv, options, CGAL::parameters::vertex_index_map(vertex_numbers()));
      check_report(surface, report);
      const double none = std::numeric_limits<double>::quiet_NaN();
      Packing packing{std::vector<Kernel::Point_2>(mesh.number_of_vertices(), Kernel::Point_2(none, none)),
                      packing_json(report)};
      for(const Halfedge h : mesh.halfedges()) {
        if(!mesh.is_border(h)) {
          packing.uv[mesh.target(h).idx()] = uv[h];
        }
      }
      return packing;
    });
  });
}

// A new vertex for each vertex and each of its coordinates, in the order of the corners
py::tuple unshared(const py::array& indices, const py::array& given_uv)
{
  const std::vector<Index> vertices =
      read_indices(indices, std::numeric_limits<Index>::max(), "indices", "vertices");
  const std::vector<Kernel::Point_2> uv = read_points<Kernel::Point_2, 2>(given_uv);
  constexpr Index none = Surface_soup::none;
  std::vector<Index> last_of_vertex, previous, new_indices; // new vertices of one vertex are linked
  std::vector<Index> mapping;
  std::vector<float> coordinates;
  const auto is_same = [&](const Index made, const Kernel::Point_2& p) {
    const float u = static_cast<float>(p.x()), v = static_cast<float>(p.y());
    const float x = coordinates[2 * made], y = coordinates[2 * made + 1];
    return (x == u && y == v) || (std::isnan(x) && std::isnan(u));
  };
  for(std::size_t c = 0; c < vertices.size(); ++c) {
    const Index v = vertices[c];
    if(v >= last_of_vertex.size()) {
      last_of_vertex.resize(v + 1, none);
    }
    Index made = last_of_vertex[v];
    while(made != none && !is_same(made, uv[c])) {
      made = previous[made];
    }
    if(made == none) {
      made = static_cast<Index>(mapping.size());
      mapping.push_back(v);
      coordinates.push_back(static_cast<float>(uv[c].x()));
      coordinates.push_back(static_cast<float>(uv[c].y()));
      previous.push_back(last_of_vertex[v]);
      last_of_vertex[v] = made;
    }
    new_indices.push_back(made);
  }
  const auto number = static_cast<py::ssize_t>(mapping.size()),
             corners = static_cast<py::ssize_t>(new_indices.size());
  return py::make_tuple(array_of(std::move(mapping), {number}), array_of(std::move(new_indices), {corners}),
                        array_of(std::move(coordinates), {number, 2}));
}

} // namespace

void bind_maps(py::module_& module)
{
  module.def("measure", &measure);
  module.def("certify", [](const Given_mesh& given, const Watch& watch) {
    const Certificate certificate = certify(given, watch);
    return py::make_tuple(certificate.is_injective, certificate.flipped, certificate.overlapping);
  });
  module.def("pack", [](const Given_mesh& given, const std::vector<std::size_t>& first_faces,
                        const py::dict& options, const Watch& watch) {
    const Packing packing = pack(given, first_faces, options, watch);
    return py::make_tuple(array_of_points(packing.uv), packing.json);
  });
  module.def("unshared", &unshared);
}

} // namespace abf_python
