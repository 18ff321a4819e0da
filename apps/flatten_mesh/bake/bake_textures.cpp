// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/bake/bake_textures.h"

#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/texts.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/bake_surface.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace flatten_mesh {

namespace {

using Colors = Mesh::Property_map<Vertex, CGAL::IO::Color>;

struct Fine_surface
{
  Mesh mesh;
  bool has_colors = false;
  Colors colors;
};

unsigned char byte_of(const double part)
{
  return static_cast<unsigned char>(std::lround(255 * (std::min)((std::max)(part, 0.), 1.)));
}

// Points without a colour are white.
void add_colors(const Atlas_input& input, Fine_surface& fine)
{
  const Model& model = input.model;
  fine.has_colors = std::any_of(model.colors.begin(), model.colors.end(),
                                [](const Point_color& color) { return std::isfinite(color[0]); });
  if(!fine.has_colors) {
    return;
  }
  fine.colors = fine.mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color", CGAL::IO::white()).first;
  for(const Halfedge h : fine.mesh.halfedges()) {
    if(!fine.mesh.is_border(h)) {
      const Point_color& color = model.colors[model.vertices[input.origins.corners[h.idx()]]];
      if(std::isfinite(color[0])) {
        fine.colors[fine.mesh.target(h)] =
            CGAL::IO::Color(byte_of(color[0]), byte_of(color[1]), byte_of(color[2]));
      }
    }
  }
}

// Repairs it as the surface that is flattened, and says so.
Fine_surface read_fine_surface(const std::string& name, Notes& notes)
{
  Command_line quiet;
  quiet.quiet = true;
  Notes own = notes_of(quiet);
  Gltf_options every_node; // has its part of the fine surface
  every_node.unique_instances = true;
  Atlas_input input;
  try {
    input = atlas_input_of(read_model(name, Degenerate_faces::KEPT, own, "", every_node), true, own);
  } catch(const Input_error& error) {
    const std::string text = error.what();
    throw Input_error("--bake-from: " + (text.find(name) == std::string::npos ? "'" + name + "': " : "") +
                      text);
  }
  for(const std::string& text : own.texts()) {
    notes.add("'" + name + "': " + text);
  }
  std::size_t left_out = 0;
  for(const TA::Atlas_report::Skipped& part : input.set_aside) {
    left_out += part.number_of_faces;
  }
  if(left_out > 0) {
    notes.add("'" + name + "': " + count_text(left_out, "face") + " of invalid parts are not baked");
  }
  Fine_surface fine;
  fine.mesh = std::move(input.mesh);
  add_colors(input, fine);
  return fine;
}

// From this share of texels on, people will see them.
constexpr double notable_share = 0.01;

void look_at_rays(const Baking_record& record, Notes& notes)
{
  const double missed = record.share(record.report.number_of_missed_rays),
               back = record.share(record.report.number_of_back_faces);
  if(missed >= notable_share) {
    notes.add(format_number("%.1f %%", 100 * missed) + " of the rays met nothing of '" + record.from +
              "' within " + format_number("%.4g", record.report.ray_length) +
              ": it has holes there, or is in another place. The closest points were taken");
  }
  if(back >= notable_share) {
    notes.add(format_number("%.1f %%", 100 * back) + " of the rays met only back faces of '" + record.from +
              "': its faces have the wrong orientation, or it is not closed. Normals were reversed there");
  }
}

// What baking changes of the model itself
void tell_what_is_replaced(const Model& model, const Baking_record& baking, Notes& notes)
{
  std::string replaced;
  const auto add = [&replaced](const bool has, const std::string& what) {
    replaced += has ? (replaced.empty() ? "" : ", ") + what : "";
  };
  add(!model.normals.empty(), "normals");
  add(!model.colors.empty() && baking.has_colors, "colours of points");
  add(!model.material_names.empty(), baking.has_colors ? "materials except names and opacities"
                                                       : "materials except names, opacities and colours");
  if(!replaced.empty()) {
    notes.add("baking replaces parts of the input: " + replaced);
  }
}

} // namespace

Baked_surface bake_textures(const Command_line& command, Atlas_input& input, const Atlas& atlas, Notes& notes)
{
  Mesh& mesh = input.mesh;
  namespace np = CGAL::parameters;
  CGAL::Real_timer timer;
  timer.start();
  const Fine_surface fine = read_fine_surface(command.atlas.bake_from, notes);
  Baked_surface baked;
  baked.frames = mesh.add_property_map<Halfedge, TA::Tangent_frame>("h:flatten_mesh_frame").first;
  TA::Baking_options options;
  options.resolution = command.atlas.resolution;
  options.height = command.atlas.height;
  options.gutter = command.atlas.number_of_gutter_texels();
  options.threads = command.options.threads;
  const auto charts = np::face_patch_map(atlas.chart).vertex_index_map(soup_numbers(mesh).points);
  const auto fine_numbers = np::vertex_index_map(
      boost::make_function_property_map<Vertex>([](const Vertex v) { return std::size_t(v.idx()) + 1; }));
  baked.textures = fine.has_colors ? TA::bake_surface(mesh, atlas.uv, fine.mesh, baked.frames, options,
                                                      charts, fine_numbers.vertex_color_map(fine.colors))
                                   : TA::bake_surface(mesh, atlas.uv, fine.mesh, baked.frames, options,
                                                      charts, fine_numbers);
  if(!baked.textures) {
    throw Input_error("cannot bake '" + command.atlas.bake_from + "': " + baked.textures.message);
  }
  baked.record = {command.atlas.bake_from,
                  fine.mesh.number_of_faces(),
                  fine.has_colors,
                  baked.textures.least_displacement,
                  baked.textures.greatest_displacement,
                  baked.textures,
                  timer.time()};
  look_at_rays(baked.record, notes);
  tell_what_is_replaced(input.model, baked.record, notes);
  return baked;
}

} // namespace flatten_mesh
