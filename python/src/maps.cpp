// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is known of a map: its distortion, its certificate, its place on pages

#include "interface.h"
#include "results.h"
#include "surfaces.h"
#include "take_options.h"

#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/Texture_atlas/pack_charts.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace abf_python {

namespace {

using abf::json_text;

std::string measures_json(const SMP::Flattening_measures& measures)
{
  Json json;
  abf::add_measures(json, &measures);
  json["flipped_triangles"] = measures.flipped_triangles;
  json["border_is_simple"] = measures.border_is_simple;
  return json_text(json);
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

} // namespace

} // namespace abf_python

using namespace abf_python;

abf_result* abf_measure(const abf_mesh* const given, abf_progress*)
{
  return result_of([&](abf_result& result) {
    with_failures([&] {
      Surface surface = surface_of(soup_of(*given, ""));
      const auto report = SMP::measure_flattening(surface.mesh, corner_map(surface),
                                                  CGAL::parameters::vertex_index_map(vertex_numbers()));
      check_report(surface, report);
      result.text = measures_json(report);
    });
  });
}

// The text is whether the map is injective.
abf_result* abf_certify(const abf_mesh* const given, abf_progress*)
{
  return result_of([&](abf_result& result) {
    with_failures([&] {
      Surface surface = surface_of(soup_of(*given, ""));
      const auto uv = corner_map(surface);
      std::vector<Face> flipped, overlapping;
      const bool is_injective = SMP::is_injective(surface.mesh, uv);
      if(!is_injective) {
        SMP::flipped_faces(surface.mesh, uv, std::back_inserter(flipped));
        TA::overlapping_faces(surface.mesh, uv, std::back_inserter(overlapping));
      }
      result.text = is_injective ? "true" : "false";
      result.add(faces_in_soup(surface, flipped));
      result.add(faces_in_soup(surface, overlapping));
    });
  });
}

// The vertices of several charts, each with its own ones: those of chart i begin at `first_faces[i]`, likewise.
abf_result* abf_pack(const abf_mesh* const given, const abf_array* const given_first_faces,
                     const char* const given_options, abf_progress*)
{
  return result_of([&](abf_result& result) {
    const auto options = options_of<TA::Packing_options>(given_options, "packing");
    const std::vector<Index> first_faces =
        read_indices(*given_first_faces, std::numeric_limits<Index>::max(), "first_faces", "faces");
    with_failures([&] {
      Surface surface = surface_of(soup_of(*given, ""));
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
      std::vector<Kernel::Point_2> of_vertices(mesh.number_of_vertices(), Kernel::Point_2(none, none));
      for(const Halfedge h : mesh.halfedges()) {
        if(!mesh.is_border(h)) {
          of_vertices[mesh.target(h).idx()] = uv[h];
        }
      }
      result.add_points(of_vertices);
      result.text = packing_json(report);
    });
  });
}

// A new vertex for each vertex and each of its coordinates, in the order of the corners
abf_result* abf_unshared(const abf_array* const indices, const abf_array* const given_uv, abf_progress*)
{
  return result_of([&](abf_result& result) {
    const std::vector<Index> vertices =
        read_indices(*indices, std::numeric_limits<Index>::max(), "indices", "vertices");
    const std::vector<Kernel::Point_2> uv = read_points<Kernel::Point_2, 2>(*given_uv);
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
    result.add(std::move(mapping));
    result.add(std::move(new_indices));
    result.add(std::move(coordinates), 2);
  });
}
