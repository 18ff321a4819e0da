// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of any topology: seams, cones, and textures of fine surfaces

#include "bindings.h"
#include "option_taker.h"
#include "surfaces.h"

#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>
#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

namespace {

using CGAL::Texture_atlas::internal::json_text;
using Weights = Mesh::Property_map<Edge, double>;

struct Seams
{
  Vertex_pairs pairs;
  std::string json;
};

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

Seams seams(const Given_mesh& given, const std::string& way, const TA::Seam_options& options,
            const Watch& watch)
{
  Surface_soup soup = soup_of(given, "");
  return run_interruptibly(watch, [&](Progress_state&) {
    return with_failures([&] {
      namespace np = CGAL::parameters;
      Surface surface = surface_of(std::move(soup));
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
      return Seams{marked_pairs(surface.mesh, is_seam), json_of(report)};
    });
  });
}

using Cones = std::vector<std::pair<std::int64_t, double>>; // vertices and angles

Cones cones_of(const TA::Cone_selection<Mesh>& selection)
{
  Cones cones;
  for(const auto& [v, angle] : selection.cones) {
    cones.emplace_back(v.idx(), angle);
  }
  return cones;
}

struct Cone_map
{
  Cones cones;
  double predicted_stretch = 1;
  std::vector<Kernel::Point_2> uv; // of each corner; empty if only cones are wanted
  Vertex_pairs seams;
};

Cone_map cones(const Given_mesh& given, const std::size_t number, const double angle_multiple,
               const bool is_flattened, const int threads, const Watch& watch)
{
  Surface_soup soup = soup_of(given, "");
  return run_interruptibly(watch, [&](Progress_state& state) {
    return with_failures([&] {
      Surface surface = surface_of(std::move(soup));
      Mesh& mesh = surface.mesh;
      TA::Cone_options options;
      options.angle_multiple = angle_multiple;
      options.parameterizer.threads = threads;
      Flattening_watcher watcher;
      watcher.follow(state);
      options.parameterizer.visitor = &watcher;
      const auto numbers = CGAL::parameters::vertex_index_map(vertex_numbers());
      if(!is_flattened) {
        const auto selection = TA::select_cones(mesh, number, options, numbers);
        check_report(surface, selection);
        return Cone_map{cones_of(selection), selection.predicted_stretch, {}, {}};
      }
      const auto uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
      const auto is_seam = prepare::seam_marks(mesh);
      const auto flattening = TA::flatten_with_cones(mesh, number, is_seam, uv, options, numbers);
      check_report(surface, flattening);
      return Cone_map{cones_of(flattening.cones), flattening.cones.predicted_stretch, corners_of(surface, uv),
                      marked_pairs(mesh, is_seam)};
    });
  });
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

Mesh::Property_map<Vertex, CGAL::IO::Color> colors_of(const std::vector<std::array<std::uint8_t, 3>>& given,
                                                      Mesh& mesh)
{
  const auto colors = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : mesh.vertices()) {
    colors[v] = CGAL::IO::Color(given[v.idx()][0], given[v.idx()][1], given[v.idx()][2]);
  }
  return colors;
}

TA::Baked_textures bake(const Given_mesh& given, const Given_mesh& given_fine,
                        const std::vector<std::array<std::uint8_t, 3>>& given_colors,
                        const TA::Baking_options& options, const Watch& watch)
{
  Surface_soup soup = soup_of(given, ""), fine_soup = soup_of(given_fine, "the fine mesh");
  return run_interruptibly(watch, [&](Progress_state&) {
    return with_failures([&]() -> TA::Baked_textures {
      namespace np = CGAL::parameters;
      Surface surface = surface_of(std::move(soup)), fine = surface_of(std::move(fine_soup));
      const auto uv = corner_map(surface);
      const auto chart = surface.mesh.add_property_map<Face, int>("f:chart", 0).first;
      for(const Face f : surface.mesh.faces()) {
        const Kernel::Point_2& p = uv[surface.mesh.halfedge(f)];
        chart[f] = std::isfinite(p.x()) && std::isfinite(p.y()) ? 0 : -1;
      }
      const auto charts = np::face_patch_map(chart).vertex_index_map(vertex_numbers());
      const auto fine_numbers = np::vertex_index_map(vertex_numbers());
      const Fine_surface baked =
          given_colors.empty()
              ? TA::bake_surface(surface.mesh, uv, fine.mesh, options, charts, fine_numbers)
              : TA::bake_surface(surface.mesh, uv, fine.mesh, options, charts,
                                 fine_numbers.vertex_color_map(colors_of(given_colors, fine.mesh)));
      check_report(surface, baked);
      return static_cast<const TA::Baked_textures&>(baked);
    });
  });
}

py::tuple tuple_of(TA::Baked_textures&& textures)
{
  const std::string json = json_of(textures);
  const py::ssize_t rows = textures.height, columns = textures.resolution;
  const py::object colors = textures.colors.empty()
                                ? py::object(py::none())
                                : py::object(array_of(std::move(textures.colors), {rows, columns, 3}));
  return py::make_tuple(array_of(std::move(textures.normals), {rows, columns, 3}),
                        array_of(std::move(textures.displacements), {rows, columns}), colors,
                        array_of(std::move(textures.texels), {rows, columns}), json);
}

} // namespace

void bind_surfaces(py::module_& module)
{
  module.def("seams",
             [](const Given_mesh& given, const std::string& way, const py::dict& values, const Watch& watch) {
               TA::Seam_options options;
               take_options(values, "seams", options);
               const Seams found = seams(given, way, options, watch);
               return py::make_tuple(array_of_pairs(found.pairs), found.json);
             });
  module.def("cones", [](const Given_mesh& given, const std::size_t number, const double angle_multiple,
                         const bool is_flattened, const int threads, const Watch& watch) {
    const Cone_map map = cones(given, number, angle_multiple, is_flattened, threads, watch);
    return py::make_tuple(map.cones, map.predicted_stretch, array_of_points(map.uv),
                          array_of_pairs(map.seams));
  });
  module.def("bake", [](const Given_mesh& given, const Given_mesh& fine,
                        const std::vector<std::array<std::uint8_t, 3>>& colors, const py::dict& values,
                        const Watch& watch) {
    TA::Baking_options options;
    take_options(values, "textures", options);
    return tuple_of(bake(given, fine, colors, options, watch));
  });
}

} // namespace abf_python
