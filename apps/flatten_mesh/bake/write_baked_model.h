// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_BAKED_MODEL_H
#define FLATTEN_MESH_WRITE_BAKED_MODEL_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/bake/bake_textures.h"
#include "flatten_mesh/bake/baked_files.h"
#include "flatten_mesh/bake/png_textures.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/divide_polygons.h"
#include "flatten_mesh/model/own_materials.h"
#include "flatten_mesh/model/write_model.h"

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

constexpr const char* baked_material = "baked";

// The normals of a model become those that the texture refers to: one for each vertex of the mesh.
inline void replace_normals(const Mesh& mesh, const Corner_origins& origins, const Baked_surface& baked,
                            Model& model, Model_texture& texture)
{
  std::vector<Index> number(mesh.number_of_vertices(), no_index);
  model.normals.clear();
  model.has_point_normals = false;
  model.corner_normals.assign(model.number_of_corners(), no_index);
  texture.tangents.resize(model.number_of_corners());
  for(const Halfedge h : mesh.halfedges()) {
    const Index corner = origins.corners[h.idx()];
    if(corner == no_index || !texture.has_uv(corner)) {
      continue;
    }
    const TA::Tangent_frame& frame = baked.frames[h];
    Index& normal = number[mesh.target(h).idx()];
    if(normal == no_index) {
      normal = static_cast<Index>(model.normals.size());
      model.normals.emplace_back(frame.normal[0], frame.normal[1], frame.normal[2]);
    }
    model.corner_normals[corner] = normal;
    texture.tangents[corner] = {frame.tangent[0], frame.tangent[1], frame.tangent[2], frame.sign};
  }
}

inline std::string material_text(const Command_line& command, const Model& model, const Baking_record& record)
{
  const auto file = [&command](const char* ending) {
    return std::filesystem::path(baked_file(command, ending)).filename().string();
  };
  const std::string normals = file(normals_ending);
  std::string pictures = record.has_colors ? "map_Kd " + file(colors_ending) + "\n" : std::string();
  pictures += "norm " + normals + "\nmap_Bump " + normals + "\ndisp -mm " +
              format_number("%.9g", record.least_displacement) + " " +
              format_number("%.9g", record.greatest_displacement - record.least_displacement) + " " +
              file(displacement_ending) + "\n";
  return flatten_mesh::material_text("materials with baked pictures", baked_material, pictures,
                                     record.has_colors, model);
}

} // namespace internal

// The model with the normals that its textures refer to, and its pictures: in the same file for GLB, beside it for OBJ.
inline void write_baked_model(const Command_line& command, Model model, const Mesh& mesh,
                              const Corner_origins& origins, const Baked_surface& baked,
                              Model_texture texture, Output_files& files)
{
  internal::replace_normals(mesh, origins, baked, model, texture);
  if(baked.record.has_colors) {
    model.colors.clear();
  }
  const std::string normals = normals_png(baked.textures);
  const std::string colors = baked.record.has_colors ? colors_png(baked.textures) : std::string();
  if(!is_obj_output(command.output)) {
    texture.normal_picture = normals;
    texture.color_picture = colors;
    write_model(files.open(command.output), command.output, model, texture);
    return;
  }
  if(command.triangles) {
    take_triangles(model, texture);
  }
  const std::string material_file = baked_file(command, material_ending);
  check_material_file(material_file, model);
  files.open(material_file).write(internal::material_text(command, model, baked.record));
  replace_materials(material_file, internal::baked_material, model);
  model.name = command.output; // what it refers to is beside it
  write_model(files.open(command.output), command.output, model, texture);
  files.open(baked_file(command, normals_ending)).write(normals);
  files.open(baked_file(command, displacement_ending)).write(displacements_png(baked.textures));
  if(baked.record.has_colors) {
    files.open(baked_file(command, colors_ending)).write(colors);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_BAKED_MODEL_H
