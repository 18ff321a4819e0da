// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_ATLAS_H
#define FLATTEN_MESH_WRITE_ATLAS_H

#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/atlas/join_models.h"
#include "flatten_mesh/atlas/place_charts.h"
#include "flatten_mesh/atlas/report_atlas_json.h"
#include "pictures/textured_atlas.h"
#include "flatten_mesh/bake/bake_textures.h"
#include "flatten_mesh/check_style_options.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/face_options.h"
#include "flatten_mesh/model/concave_polygons.h"
#include "flatten_mesh/model/divide_polygons.h"
#include "flatten_mesh/model/own_materials.h"
#include "flatten_mesh/model/Shared_uv.h"
#include "flatten_mesh/model/write_model.h"
#include "flatten_mesh/model/write_model_glb.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/process_memory.h"
#include "flatten_mesh/pictures/draw_atlas.h"
#include "flatten_mesh/pictures/draw_plane.h"
#include "flatten_mesh/pictures/page_boxes.h"
#include "flatten_mesh/pictures/Up_axis.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/texture_option.h"

#ifdef ABF_WITH_PNG
#include "flatten_mesh/bake/write_baked_model.h"
#include "flatten_mesh/pictures/chart_images.h"
#include "flatten_mesh/pictures/checkerboard_png.h"
#endif

#ifdef ABF_WITH_THREE
#include "flatten_mesh/report/contents_of_atlas.h"
#include "flatten_mesh/report/report_page.h"
#endif

#include <CGAL/Bbox_2.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>
#include <CGAL/Texture_atlas/seam_selection.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace pictures;
using namespace CGAL::Texture_atlas::internal::prepare;

inline std::string seams_text(const Mesh& mesh, const Atlas& atlas)
{
  std::ostringstream text;
  TA::write_seam_selection(text, mesh, atlas.seams);
  return text.str();
}

// The texture of a model, as its output has it
inline Model_texture written_texture(const Command_line& command, const Model& model, const Mesh& mesh,
                                     const Corner_origins& origins, const Atlas& atlas)
{
  Model_texture texture = texture_of(model, mesh, origins, atlas);
  texture.is_second_set = command.atlas.uv_set == 1;
  if(!texture.is_second_set) {
    keep_given_texture(model, left_out_polygons(face_choice_of(command.atlas), model), texture);
  }
  return texture;
}

// The polygons that other programs would draw with triangles that overlap. GLB files have none.
inline std::vector<bool> polygons_to_divide(const Command_line& command, const Atlas_input& input,
                                            const Atlas& atlas, const Float_grid& grid)
{
  if(command.output.empty() || file_format(command.output) == "glb") {
    return {};
  }
  std::vector<bool> is_divided =
      concave_polygons(input.model, texture_of(input.model, input.mesh, input.origins, atlas), grid);
  const std::vector<bool> is_torn = torn_polygons(
      input.model, input.mesh, input.origins, [&atlas](const Halfedge h) { return atlas.uv[h]; },
      [&atlas](const Face f) { return chart_number(atlas, f); });
  std::transform(is_divided.begin(), is_divided.end(), is_torn.begin(), is_divided.begin(),
                 std::logical_or<bool>());
  for(std::size_t p = 0; p < input.origins.has_no_area.size(); ++p) {
    is_divided[p] = is_divided[p] && !input.origins.has_no_area[p];
  }
  return is_divided;
}

// A model that is written, with its charts
struct Written_model
{
  Command_line command;
  const Atlas_input& input;
  Atlas atlas;
  std::vector<bool> is_divided; // of each polygon
};

inline std::vector<Written_model> models_to_write(const Command_line& command, Atlas_input& input,
                                                  const Atlas& atlas, const TA::Atlas_report& report)
{
  std::vector<Written_model> models;
  const Float_grid grid = grid_of_outputs(command);
  const auto add = [&](const Command_line& own, const Atlas_input& model, const Atlas& charts) {
    models.push_back({own, model, charts, {}});
    if(report.has_atlas()) {
      models.back().is_divided = polygons_to_divide(own, model, charts, grid);
    }
  };
  if(input.joined.empty()) {
    add(command, input, atlas);
  }
  for(Joined_model& model : input.joined) {
    add(model.command, model.input, atlas_of_model(atlas, model));
  }
  return models;
}

inline void tell_changed_polygons(const std::vector<Written_model>& models, const TA::Atlas_report& report,
                                  Notes& notes)
{
  std::vector<bool> is_divided;
  for(const Written_model& model : models) {
    if(!model.command.triangles) { // where all are divided
      is_divided.insert(is_divided.end(), model.is_divided.begin(), model.is_divided.end());
    }
  }
  if(const std::string text = polygons_text(report.number_of_mended_polygons, is_divided); !text.empty()) {
    notes.add(text);
  }
}

// Says what other programs will make of the outputs: of faces without texture coordinates, of polygons that stay and
// must not be drawn as fans, and of a picture that is not there.
inline void tell_outputs(const std::vector<Written_model>& models, Notes& notes)
{
  std::size_t without_uv = 0, bad_fans = 0;
  std::set<std::string> formats, missing_pictures;
  for(const auto& [command, input, atlas, is_divided] : models) {
    if(command.output.empty()) {
      continue;
    }
    const std::string format = is_obj_output(command.output) ? "obj" : file_format(command.output);
    const Model& model = input.model;
    const Model_texture texture = written_texture(command, model, input.mesh, input.origins, atlas);
    for(Index p = 0; p < model.number_of_polygons(); ++p) {
      if(!has_uv_everywhere(model, texture, p)) {
        ++without_uv;
        formats.insert(format);
      }
      const bool stays = !command.triangles && format != "glb" && (is_divided.empty() || !is_divided[p]);
      bad_fans += stays && has_bad_fan(model, p);
    }
    if(lacks_picture(command)) {
      missing_pictures.insert(command.texture);
    }
  }
  if(without_uv > 0) {
    notes.add(count_text(without_uv, "face has", "faces have") + " no texture coordinates: " +
              (formats.count("glb") == 1 ? "such triangles are primitives of their own"
                                         : "other programs read (0, 0) at such corners"));
  }
  if(bad_fans > 0) {
    notes.add(count_text(bad_fans, "polygon has", "polygons have") +
              " a reflex corner on the surface: programs that draw polygons as fans turn triangles over; "
              "--triangles divides all polygons rightly");
  }
  for(const std::string& picture : missing_pictures) {
    notes.add("--texture: there is no file '" + picture + "' yet");
  }
}

// Says so if a node has to put a model where it belongs, because its positions are too far away for `float`.
inline void tell_moved_origins(const std::vector<Written_model>& models, Notes& notes)
{
  for(const Written_model& written : models) {
    const Model& model = written.input.model;
    if(!written.command.output.empty() && file_format(written.command.output) == "glb" && !model.gltf.file &&
       origin_of_floats(model) != std::array<double, 3>{0, 0, 0}) {
      notes.add("positions are more than a hundred times as far from the origin as the model is large, which "
                "is too far "
                "for the numbers in GLB files: they begin in its middle, and its node has the rest");
    }
  }
}

// Writes a material file with the picture of `--texture`, which all materials get.
inline void write_textured_materials(const Command_line& command, Model& model, Output_files& files)
{
  const std::string file = baked_file(command, material_ending);
  check_material_file(file, model);
  files.open(file).write(material_text("materials with a picture", textured_material,
                                       "map_Kd " + texture_name(command) + "\n", true, model));
  replace_materials(file, textured_material, model);
  model.name = command.output; // what it refers to is beside it
}

inline void write_model_or_baked(const Command_line& command, const Model& model, const Mesh& mesh,
                                 const Corner_origins& origins, const Atlas& atlas,
                                 const Baked_surface& baked, Output_files& files)
{
#ifdef ABF_WITH_PNG
  if(!command.atlas.bake_from.empty()) {
    write_baked_model(command, model, mesh, origins, baked, texture_of(model, mesh, origins, atlas), files);
    return;
  }
#else
  (void)baked;
#endif
  if(!command.output.empty()) {
    Model_texture texture = written_texture(command, model, mesh, origins, atlas);
    if(!command.triangles && (command.texture.empty() || !is_obj_output(command.output))) {
      write_model(files.open(command.output), command.output, model, texture, style_of(command));
      return;
    }
    Model changed = model;
    if(command.triangles) {
      take_triangles(changed, texture);
    }
    if(!command.texture.empty() && is_obj_output(command.output)) {
      write_textured_materials(command, changed, files);
    }
    write_model(files.open(command.output), command.output, changed, texture, style_of(command));
  }
}

inline void write_surface(const Written_model& written, const Baked_surface& baked, Output_files& files)
{
  const auto& [command, input, atlas, is_divided] = written;
#ifdef ABF_WITH_PNG
  if(makes_checkerboard(command)) {
    files.open(texture_file(command)).write(checkerboard_png(command.atlas));
  }
#endif
  if(std::find(is_divided.begin(), is_divided.end(), true) == is_divided.end()) {
    write_model_or_baked(command, input.model, input.mesh, input.origins, atlas, baked, files);
    return;
  }
  Model model = input.model;
  Corner_origins origins = input.origins;
  divide_polygons(model, input.mesh, origins, is_divided);
  write_model_or_baked(command, model, input.mesh, origins, atlas, baked, files);
}

// In the plane of the pictures, where texels are squares
inline std::vector<CGAL::Bbox_2> pages_of(const Atlas_command& options, const Mesh& mesh, const Atlas& atlas,
                                          const TA::Atlas_report& report)
{
  if(options.is_in_world_units() && report.number_of_pages <= 1) {
    return {box_of(mesh, atlas)};
  }
  const double width = options.is_in_world_units() ? 1 / report.scale : 1;
  return page_boxes(report.number_of_pages, width, width * options.number_of_rows() / options.resolution);
}

inline void draw(const Command_line& command, const Atlas_input& input, const Atlas& atlas,
                 const Atlas_record& record, Output_files& files)
{
  Textured_surface surface = textured_atlas(input.mesh, atlas);
  if(!command.atlas.is_in_world_units()) {
    make_texels_squares(command.atlas.resolution, command.atlas.number_of_rows(), surface);
  }
  const std::vector<CGAL::Bbox_2> pages = pages_of(command.atlas, input.mesh, atlas, record.report);
  const std::string up = up_axis(command, surface);
  if(!command.svg.empty()) {
    files.open(command.svg).write(atlas_svg(surface, pages));
  }
  if(!command.picture.empty()) {
    files.open(command.picture).write(atlas_picture(surface, Upright::of(up), pages));
  }
#ifdef ABF_WITH_THREE
  if(!command.report.empty()) {
    files.open(command.report)
        .write(report_page(contents_of_atlas(input, record, std::move(surface), up, pages),
                           command.options.threads));
  }
#endif
}

// Writes the requested files under temporary names.
inline void write_files(const Command_line& command, const Atlas_input& input, const Atlas& atlas,
                        const Baked_surface& baked, const std::vector<Written_model>& models,
                        Atlas_record& record, Output_files& files)
{
  CGAL::Real_timer timer;
  timer.start();
  if(record.report.has_atlas()) {
    for(const Written_model& model : models) {
      write_surface(model, baked, files);
    }
    if(!command.svg.empty() || !command.picture.empty() || !command.report.empty()) {
      draw(command, input, atlas, record, files);
    }
    for(const Written_model& model : models) {
      if(!model.command.seams_to.empty()) {
        files.open(model.command.seams_to).write(seams_text(model.input.mesh, model.atlas));
      }
    }
#ifdef ABF_WITH_PNG
    if(!command.chart_image.empty()) {
      write_chart_images(command, input.mesh, atlas, record.report, files);
    }
#endif
  }
  record.write_seconds = timer.time();
  record.peak_memory_mb = peak_memory_mb();
  if(!command.json.empty()) {
    files.open(command.json).write(report_json(record, command.batch));
  }
  record.written = files.names();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_ATLAS_H
