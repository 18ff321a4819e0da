// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/model/gltf/Gltf_primitive_reader.h"
#include "flatten_mesh/model/gltf/load_gltf.h"
#include "flatten_mesh/model/gltf/node_places.h"
#include "flatten_mesh/model/gltf/other_accessors.h"
#include "flatten_mesh/model/gltf_surface.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

class Gltf_surface_reader
{
public:
  Gltf_surface_reader(Gltf_file& file, const Gltf_options& options, Gltf_surface& surface)
      : m_file(file), m_surface(surface), m_accessors(file), m_primitives(file, options)
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
    if(left_out > 0 && m_surface.primitives.empty()) {
      refuse_gltf(m_file.name, "its meshes are only points or lines, and have no triangles");
    }
    if(left_out > 0) {
      m_surface.remarks.push_back(count_text(left_out, "primitive") + " of points or lines left out");
    }
    check_other_accessors();
    m_surface.scene_parts = scene_parts();
  }

private:
  // Joints place the vertices of a mesh with a skin, and not its node. Some programs hide a mesh by the scale 0.
  std::vector<Gltf_place> places_of_meshes()
  {
    const std::vector<Gltf_place> all_places = node_places(m_file);
    std::vector<Gltf_place> places = all_places;
    std::size_t collapsed = 0;
    for(std::size_t n = 0; n < places.size(); ++n) {
      if(m_file.model.nodes[n].mesh >= 0 && places[n].determinant() == 0) {
        places[n] = Gltf_place();
        ++collapsed;
      }
    }
    if(collapsed > 0) {
      m_surface.remarks.push_back(count_text(collapsed, "node") + " with a scale of 0: " +
                                  (collapsed == 1 ? "its mesh is" : "their meshes are") +
                                  " flattened as if not scaled");
    }
    std::vector<std::optional<Gltf_place>> first(m_file.model.meshes.size());
    for(std::size_t n = 0; n < places.size(); ++n) {
      const tinygltf::Node& node = m_file.model.nodes[n];
      if(node.mesh >= 0) {
        gltf_element(m_file, m_file.model.meshes, node.mesh, node_text(m_file, n), "mesh");
        auto& place = first[static_cast<std::size_t>(node.mesh)];
        m_surface.instances += place.has_value();
        place = place.value_or(node.skin >= 0 ? place_of_skin(node.skin, all_places) : places[n]);
      }
    }
    std::vector<Gltf_place> result;
    for(const auto& place : first) {
      result.push_back(place.value_or(Gltf_place()));
    }
    return result;
  }

  // Joints draw a mesh in another size than its own if, for example, a model in centimeters hangs below a node that
  // scales it to meters. Its size is the one of the joint in the middle.
  Gltf_place place_of_skin(const int number, const std::vector<Gltf_place>& places) const
  {
    const std::vector<const Json*> skins = objects_in(m_file, std::as_const(m_file.json), "skins");
    const std::string text = "skin " + std::to_string(number);
    if(static_cast<std::size_t>(number) >= skins.size()) {
      refuse_gltf(m_file.name, text + " does not exist: the file has " + std::to_string(skins.size()));
    }
    const Json& skin = *skins[static_cast<std::size_t>(number)];
    const auto joints = skin.find("joints");
    const int accessor = number_in(m_file, skin, "inverseBindMatrices", text);
    const std::vector<double> numbers =
        accessor < 0 ? std::vector<double>() : m_accessors.read({accessor, text}).numbers();
    std::vector<double> scales;
    for(std::size_t i = 0; joints != skin.end() && joints->is_array() && i < joints->size(); ++i) {
      const Json& joint = (*joints)[i];
      if(!joint.is_number_unsigned() || joint.get<std::size_t>() >= places.size()) {
        refuse_gltf(m_file.name, text + " names a node that does not exist");
      }
      double volume = places[joint.get<std::size_t>()].determinant();
      if(16 * (i + 1) <= numbers.size()) {
        volume *= Gltf_place::of_columns(&numbers[16 * i]).determinant();
      }
      scales.push_back(std::cbrt(std::abs(volume)));
    }
    Gltf_place place;
    if(!scales.empty()) {
      const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
      std::nth_element(scales.begin(), middle, scales.end());
      const bool is_other = std::isfinite(*middle) && *middle > 0 && std::abs(*middle - 1) > 1e-3;
      for(std::size_t axis = 0; axis < 3 && is_other; ++axis) {
        place.rows[axis][axis] = *middle;
      }
    }
    return place;
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
    for_each_other_accessor(m_file, std::as_const(m_file.json),
                            [this](const Json& number, const std::string& text) {
                              m_accessors.read({number.get<int>(), text});
                            });
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
    const auto has = [this](const char* const key) {
      return !objects_in(m_file, std::as_const(m_file.json), key).empty();
    };
    add(has("textures"), "textures");
    add(has("skins"), "skins");
    add(has_targets, "morph targets");
    add(has("animations"), "animations");
    add(has("cameras"), "cameras");
    const std::vector<const Json*> nodes = objects_in(m_file, std::as_const(m_file.json), "nodes");
    add(std::any_of(nodes.begin(), nodes.end(),
                    [](const Json* const node) {
                      return node->contains(Json::json_pointer("/extensions/EXT_mesh_gpu_instancing"));
                    }),
        "instances");
    add(m_file.json.contains(Json::json_pointer("/extensions/KHR_lights_punctual")), "lights");
    return text;
  }

  Gltf_file& m_file;
  Gltf_surface& m_surface;
  Gltf_accessors m_accessors;
  Gltf_primitive_reader m_primitives;
};

} // namespace

Gltf_surface gltf_surface(const std::string_view content, const bool is_binary, const std::string& name,
                          const Gltf_options& options)
{
  Gltf_surface surface;
  const auto file = std::make_shared<Gltf_file>(
      load_gltf(content, is_binary, name, options.unique_instances, surface.remarks));
  Gltf_surface_reader(*file, options, surface).read();
  surface.file = file;
  surface.files_beside = file->files_beside;
  return surface;
}

} // namespace flatten_mesh
