// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of any topology: seams, cones, and textures of fine surfaces

#include "interface.h"
#include "results.h"
#include "surfaces.h"
#include "take_options.h"

#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

namespace {

using abf::json_text;
using Weights = Mesh::Property_map<Edge, double>;

std::string json_of(const TA::Seam_report& report)
{
  return json_text({{"components", report.number_of_components},
                    {"disks", report.number_of_disks},
                    {"terminals", report.number_of_terminals},
                    {"length", report.seam_length},
                    {"relative_length", report.relative_seam_length},
                    {"predicted_stretch", report.predicted_stretch},
                    {"bound_reached", report.bound_reached}});
}

std::optional<Weights> weights_of(Surface& surface, const std::string& way)
{
  if(way == "length") {
    return std::nullopt;
  }
  const Weights weights = surface.mesh.add_property_map<Edge, double>("e:weight", 0).first;
  check_report(surface, way == "hidden" ? TA::compute_visibility_weights(surface.mesh, weights)
                                        : TA::compute_crease_weights(surface.mesh, weights));
  return weights;
}

using Fine_surface = TA::Baked_surface<Mesh, Mesh>;

std::string json_of(const TA::Baking_report& report)
{
  return json_text({{"chart_texels", report.number_of_chart_texels},
                    {"gutter_texels", report.number_of_gutter_texels},
                    {"back_faces", report.number_of_back_faces},
                    {"missed_rays", report.number_of_missed_rays},
                    {"ray_length", report.ray_length},
                    {"largest_distance", report.largest_distance},
                    {"mean_distance", report.mean_distance}});
}

Mesh::Property_map<Vertex, CGAL::IO::Color> colors_of(const abf_array& given, Mesh& mesh)
{
  const Elements<std::uint8_t> elements(given);
  const auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : mesh.vertices()) {
    colors[v] = CGAL::IO::Color(elements(v.idx(), 0), elements(v.idx(), 1), elements(v.idx(), 2));
  }
  return colors;
}

} // namespace

} // namespace abf_python

using namespace abf_python;
namespace np = CGAL::parameters;

abf_result* abf_seams(const abf_mesh* const given, const char* const way, const char* const given_options,
                      abf_progress*)
{
  return result_of([&](abf_result& result) {
    const auto options = options_of<TA::Seam_options>(given_options, "seams");
    with_failures([&] {
      Surface surface = surface_of(soup_of(*given, ""));
      prepare::mark_seams_of_soup(surface.soup, surface, prepare::seam_marks(surface.mesh));
      const auto is_seam = prepare::seam_marks(surface.mesh), is_diagonal = prepare::diagonals(surface.mesh);
      const std::optional<Weights> weights = weights_of(surface, way);
      const SMP::Mesh_report<Mesh, TA::Seam_report> report =
          weights
              ? TA::select_seams(surface.mesh, is_seam, options,
                                 np::edge_weight_map(*weights)
                                     .edge_is_constrained_map(is_diagonal)
                                     .vertex_index_map(vertex_numbers()))
              : TA::select_seams(surface.mesh, is_seam, options,
                                 np::edge_is_constrained_map(is_diagonal).vertex_index_map(vertex_numbers()));
      check_report(surface, report);
      result.add_pairs(marked_pairs(surface.mesh, is_seam));
      result.text = json_of(report);
    });
  });
}

// The arrays are the cones, their angles and, with a map, the coordinates of each corner and the seams.
abf_result* abf_cones(const abf_mesh* const given, const int number, const double angle_multiple,
                      const int is_flattened, const int threads, abf_progress* const progress)
{
  return result_of([&](abf_result& result) {
    with_failures([&] {
      Surface surface = surface_of(soup_of(*given, ""));
      Mesh& mesh = surface.mesh;
      TA::Cone_options options;
      options.angle_multiple = angle_multiple;
      options.parameterizer.threads = threads;
      Flattening_watcher watcher;
      watcher.follow(*progress);
      options.parameterizer.visitor = &watcher;
      const auto numbers = CGAL::parameters::vertex_index_map(vertex_numbers());
      const auto add_cones = [&result](const TA::Cone_selection<Mesh>& selection) {
        std::vector<std::int64_t> vertices;
        std::vector<double> angles;
        for(const auto& [v, angle] : selection.cones) {
          vertices.push_back(v.idx());
          angles.push_back(angle);
        }
        result.add(std::move(vertices));
        result.add(std::move(angles));
        result.text = json_text(abf::Json(selection.predicted_stretch));
      };
      if(is_flattened == 0) {
        const auto selection = TA::select_cones(mesh, number, options, numbers);
        check_report(surface, selection);
        add_cones(selection);
        return;
      }
      const auto uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
      const auto is_seam = prepare::seam_marks(mesh);
      const auto flattening = TA::flatten_with_cones(mesh, number, is_seam, uv, options, numbers);
      check_report(surface, flattening);
      add_cones(flattening.cones);
      result.add_points(corners_of(surface, uv));
      result.add_pairs(marked_pairs(mesh, is_seam));
    });
  });
}

// The arrays are normals, displacements, texels and, if the fine surface has them, colours: a row of each for a texel.
// The text begins with the number of rows of texels.
abf_result* abf_bake(const abf_mesh* const given, const abf_mesh* const given_fine,
                     const abf_array* const given_colors, const char* const given_options, abf_progress*)
{
  return result_of([&](abf_result& result) {
    const auto options = options_of<TA::Baking_options>(given_options, "textures");
    with_failures([&] {
      Surface surface = surface_of(soup_of(*given, "")),
              fine = surface_of(soup_of(*given_fine, "the fine mesh"));
      const auto uv = corner_map(surface);
      const auto chart = surface.mesh.add_property_map<Face, int>("f:chart", 0).first;
      for(const Face f : surface.mesh.faces()) {
        const Kernel::Point_2& p = uv[surface.mesh.halfedge(f)];
        chart[f] = std::isfinite(p.x()) && std::isfinite(p.y()) ? 0 : -1;
      }
      const auto charts = np::face_patch_map(chart).vertex_index_map(vertex_numbers());
      const auto fine_numbers = np::vertex_index_map(vertex_numbers());
      Fine_surface baked =
          is_given(*given_colors)
              ? TA::bake_surface(surface.mesh, uv, fine.mesh, options, charts,
                                 fine_numbers.vertex_color_map(colors_of(*given_colors, fine.mesh)))
              : TA::bake_surface(surface.mesh, uv, fine.mesh, options, charts, fine_numbers);
      check_report(surface, baked);
      result.text = std::to_string(baked.height) + "\n" + json_of(baked);
      result.add(std::move(baked.normals), 3);
      result.add(std::move(baked.displacements));
      result.add(std::move(baked.texels));
      if(!baked.colors.empty()) {
        result.add(std::move(baked.colors), 3);
      }
    });
  });
}
