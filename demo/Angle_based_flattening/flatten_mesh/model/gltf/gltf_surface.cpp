// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/model/gltf/Gltf_primitive_reader.h"
#include "flatten_mesh/model/gltf/load_gltf.h"
#include "flatten_mesh/model/gltf/node_places.h"
#include "flatten_mesh/model/gltf_surface.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

namespace {

// Each node gets a mesh of its own.
void separate_instances(Gltf_file& file)
{
  std::vector<bool> is_used(file.model.meshes.size(), false);
  for(std::size_t n = 0; n < file.model.nodes.size(); ++n) {
    int& mesh = file.model.nodes[n].mesh;
    if(mesh >= 0) {
      const tinygltf::Mesh copy = gltf_element(file, file.model.meshes, mesh, node_text(file, n), "mesh");
      if(is_used[static_cast<std::size_t>(mesh)]) {
        mesh = static_cast<int>(file.model.meshes.size());
        file.model.meshes.push_back(copy);
        is_used.push_back(false);
      }
      is_used[static_cast<std::size_t>(mesh)] = true;
    }
  }
}

class Gltf_surface_reader
{
public:
  Gltf_surface_reader(Gltf_file& file, Gltf_surface& surface)
      : m_file(file), m_surface(surface), m_accessors(file), m_primitives(file)
  {}

  void read()
  {
    for(const tinygltf::Material& material : m_file.model.materials) {
      const std::vector<double>& factor = material.pbrMetallicRoughness.baseColorFactor;
      Glb_material result = {material.name, {1, 1, 1, 1}, false};
      std::copy_n(factor.begin(), (std::min)(factor.size(), result.color.size()), result.color.begin());
      m_surface.materials.push_back(result);
    }
    const std::vector<Gltf_place> places = places_of_meshes();
    std::size_t left_out = 0;
    for(std::size_t m = 0; m < m_file.model.meshes.size(); ++m) {
      const tinygltf::Mesh& mesh = m_file.model.meshes[m];
      m_surface.mesh_names.push_back(mesh_name(m_file, m));
      for(std::size_t k = 0; k < mesh.primitives.size(); ++k) {
        const int mode = mesh.primitives[k].mode;
        if(mode < TINYGLTF_MODE_TRIANGLES) {
          ++left_out;
        } else if(mode > TINYGLTF_MODE_TRIANGLE_FAN) {
          refuse_gltf(m_file.name,
                      primitive_text(m_file, m, k) + " has the unknown mode " + std::to_string(mode));
        } else {
          m_surface.primitives.push_back(m_primitives.read(m, k, places[m]));
          m_file.primitives.emplace_back(m, k);
        }
      }
    }
    if(left_out > 0) {
      m_surface.remarks.push_back(count_text(left_out, "primitive") + " of points or lines left out");
    }
    check_other_accessors();
    m_surface.scene_parts = scene_parts();
  }

private:
  // Joints place the vertices of a mesh with a skin, and not its node.
  std::vector<Gltf_place> places_of_meshes()
  {
    const std::vector<Gltf_place> places = node_places(m_file);
    std::vector<std::optional<Gltf_place>> first(m_file.model.meshes.size());
    for(std::size_t n = 0; n < places.size(); ++n) {
      const tinygltf::Node& node = m_file.model.nodes[n];
      if(node.mesh >= 0) {
        gltf_element(m_file, m_file.model.meshes, node.mesh, node_text(m_file, n), "mesh");
        auto& place = first[static_cast<std::size_t>(node.mesh)];
        m_surface.instances += place.has_value();
        place = place.value_or(node.skin >= 0 ? Gltf_place() : places[n]);
      }
    }
    std::vector<Gltf_place> result;
    for(const auto& place : first) {
      result.push_back(place.value_or(Gltf_place()));
    }
    return result;
  }

  // What is only written again: wrong parts of a file are told before the work begins.
  void check_other_accessors() const
  {
    const tinygltf::Model& model = m_file.model;
    for(const auto& [m, k] : m_file.primitives) {
      const auto mesh = static_cast<std::size_t>(m), number = static_cast<std::size_t>(k);
      const tinygltf::Primitive& primitive = model.meshes[mesh].primitives[number];
      const std::string text = primitive_text(m_file, mesh, number);
      const auto position = static_cast<std::size_t>(primitive.attributes.at("POSITION"));
      const std::size_t vertices = model.accessors[position].count;
      for(const auto& [key, accessor] : primitive.attributes) {
        if(key != "POSITION" && key != "NORMAL" && key != "TEXCOORD_0" && key != "COLOR_0") {
          m_primitives.read_elements({accessor, key + " of " + text}, vertices);
        }
      }
      for(const auto& target : primitive.targets) {
        for(const auto& [key, accessor] : target) {
          m_primitives.read_elements({accessor, key + " of a morph target of " + text}, vertices);
        }
      }
    }
    for(std::size_t i = 0; i < model.skins.size(); ++i) {
      if(model.skins[i].inverseBindMatrices >= 0) {
        m_accessors.read({model.skins[i].inverseBindMatrices, "skin " + std::to_string(i)});
      }
    }
    for(std::size_t i = 0; i < model.animations.size(); ++i) {
      for(const tinygltf::AnimationSampler& sampler : model.animations[i].samplers) {
        m_accessors.read({sampler.input, "animation " + std::to_string(i)});
        m_accessors.read({sampler.output, "animation " + std::to_string(i)});
      }
    }
  }

  // What the surface does not say
  std::string scene_parts() const
  {
    const tinygltf::Model& model = m_file.model;
    bool has_targets = false;
    for(const tinygltf::Mesh& mesh : model.meshes) {
      for(const tinygltf::Primitive& primitive : mesh.primitives) {
        has_targets = has_targets || !primitive.targets.empty();
      }
    }
    std::string text;
    const auto add = [&text](const bool is_there, const char* const name) {
      text += !is_there ? "" : text.empty() ? name : std::string(", ") + name;
    };
    add(!model.textures.empty(), "textures");
    add(!model.skins.empty(), "skins");
    add(has_targets, "morph targets");
    add(!model.animations.empty(), "animations");
    add(!model.cameras.empty(), "cameras");
    add(!model.lights.empty(), "lights");
    return text;
  }

  Gltf_file& m_file;
  Gltf_surface& m_surface;
  Gltf_accessors m_accessors;
  Gltf_primitive_reader m_primitives;
};

} // namespace

Gltf_surface gltf_surface(const std::string_view content, const bool is_binary, const std::string& name,
                          const bool unique_instances)
{
  Gltf_surface surface;
  const auto file = std::make_shared<Gltf_file>(load_gltf(content, is_binary, name, surface.remarks));
  if(unique_instances) {
    separate_instances(*file);
  }
  Gltf_surface_reader(*file, surface).read();
  surface.file = file;
  surface.files_beside = file->files_beside;
  return surface;
}

} // namespace flatten_mesh
