// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_elements.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/model/gltf/Tiny_picture.h"
#include "flatten_mesh/model/gltf/next_texture.h"
#include "flatten_mesh/model/gltf/other_accessors.h"
#include "flatten_mesh/model/gltf_surface.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

class Gltf_rewriter
{
public:
  Gltf_rewriter(const Gltf_file& file, const int set)
      : m_file(file), m_set(set), m_accessors(file), m_json(file.json)
  {
    m_json["accessors"] = Json::array();
    m_json["bufferViews"] = Json::array();
    m_json["asset"]["generator"] = "flatten_mesh";
  }

  void replace_triangles(const std::vector<Gltf_triangles>& all)
  {
    for(Json* const mesh : objects_in(m_file, m_json, "meshes")) {
      (*mesh)["primitives"] = Json::array();
    }
    bool has_textures = false;
    for(const Gltf_triangles& triangles : all) {
      const auto [mesh, number] = m_file.primitives[triangles.primitive];
      const auto m = static_cast<std::size_t>(mesh), k = static_cast<std::size_t>(number);
      const tinygltf::Primitive& given = m_file.model.meshes[m].primitives[k];
      has_textures = has_textures || has_moved_keys(given, m_set);
      m_json["meshes"][m]["primitives"].push_back(
          primitive(m_file.json["meshes"][m]["primitives"][k], given, triangles));
    }
    if(has_textures) {
      for(Json* const material : objects_in(m_file, m_json, "materials")) {
        use_next_texture(*material, m_set);
      }
    }
    remove_empty_meshes();
  }

  void keep_other_numbers()
  {
    for_each_other_accessor(m_file, m_json,
                            [this](Json& number, const std::string& text) { keep(number, text); });
    for(Json* const image : objects_in(m_file, m_json, "images")) {
      if(image->contains("bufferView")) {
        const auto [first, size] = m_accessors.view((*image)["bufferView"].get<int>(), "picture");
        (*image)["bufferView"] = add_view(first, size, 0, 0);
      }
    }
  }

  // Each material of triangles with new coordinates refers to them.
  void add_tiny_picture(const std::string& output)
  {
    Tiny_picture picture(m_json, m_set, output);
    const auto for_each_primitive = [this](const auto& f) {
      for(Json* const mesh : objects_in(m_file, m_json, "meshes")) {
        for(Json& primitive : (*mesh)["primitives"]) {
          f(primitive);
        }
      }
    };
    for_each_primitive([&picture](Json& primitive) { picture.add(primitive); });
    picture.end(add_view(tiny_picture.data(), tiny_picture.size(), 0, 0));
    for_each_primitive([&picture](Json& primitive) { picture.assign(primitive); });
  }

  // Two chunks, for the description and for the numbers, whose lengths are multiples of 4
  std::string text(const std::string& output)
  {
    if(m_data.size() > largest_glb) {
      throw Output_error("cannot write '" + output +
                         "': binary glTF files have at most 4 GB; use .ply or .obj");
    }
    m_json["buffers"] = {{{"byteLength", m_data.size()}}};
    std::string json = m_json.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    m_data.resize((m_data.size() + 3) / 4 * 4, 0);
    std::string text = "glTF";
    text.reserve(28 + json.size() + m_data.size());
    const auto add_number = [&text](const std::size_t number) {
      for(int shift = 0; shift < 32; shift += 8) {
        text += static_cast<char>(number >> shift & 0xFF);
      }
    };
    add_number(2);
    add_number(28 + json.size() + m_data.size());
    add_number(json.size());
    text += "JSON" + json;
    add_number(m_data.size());
    text.append("BIN\0", 4);
    text.append(m_data.begin(), m_data.end());
    return text;
  }

private:
  Json primitive(Json result, const tinygltf::Primitive& given, const Gltf_triangles& triangles)
  {
    result.erase("mode"); // which is triangles then
    Json attributes = Json::object();
    for(const auto& [key, accessor] : given.attributes) {
      attributes[next_key(key, m_set)] = add_chosen({accessor, key}, triangles.vertices, key == "POSITION");
    }
    if(!triangles.texture.empty() || has_moved_keys(given, m_set)) {
      add_texture(triangles.texture, m_set, triangles.vertices.size(), attributes);
      if(!attributes.contains(texture_key + "0")) {
        add_texture({}, 0, triangles.vertices.size(), attributes);
      }
    }
    result["attributes"] = attributes;
    for(std::size_t i = 0; i < given.targets.size(); ++i) {
      Json chosen = Json::object();
      for(const auto& [key, accessor] : given.targets[i]) {
        chosen[next_key(key, m_set)] =
            add_chosen({accessor, key + " of a morph target"}, triangles.vertices, key == "POSITION");
      }
      result["targets"][i] = chosen;
    }
    result["indices"] = add(triangles.triangles, "SCALAR", TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                            TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return result;
  }

  // A set of texture coordinates, with 0 where there are none: sets are counted from 0 without a gap.
  void add_texture(std::vector<float> numbers, const int set, const std::size_t vertices, Json& attributes)
  {
    numbers.resize(2 * vertices, 0);
    attributes[texture_key + std::to_string(set)] =
        add(numbers, "VEC2", TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
  }

  // Appends an element to a list, and returns its number.
  int add_to(const char* const list, Json element)
  {
    m_json[list].push_back(std::move(element));
    return static_cast<int>(m_json[list].size()) - 1;
  }

  // Appends bytes to the only buffer, each view where any numbers may begin.
  int add_view(const unsigned char* const bytes, const std::size_t size, const std::size_t stride,
               const int target)
  {
    m_data.resize((m_data.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", m_data.size()}, {"byteLength", size}};
    if(stride != 0) {
      view["byteStride"] = stride;
    }
    if(target != 0) {
      view["target"] = target;
    }
    m_data.insert(m_data.end(), bytes, bytes + size);
    return add_to("bufferViews", std::move(view));
  }

  template <class Number>
  int add(const std::vector<Number>& numbers, const std::string& type, const int component_type,
          const int target)
  {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(numbers.data());
    const int view = add_view(bytes, sizeof(Number) * numbers.size(), 0, target);
    return add_to("accessors", {{"bufferView", view},
                                {"componentType", component_type},
                                {"count", numbers.size() / (type == "VEC2" ? 2 : 1)},
                                {"type", type}});
  }

  // An accessor of the file whose elements are elsewhere now
  Json moved_accessor(const int number, const int view) const
  {
    Json accessor = m_file.json["accessors"][static_cast<std::size_t>(number)];
    accessor.erase("sparse");
    accessor.erase("byteOffset");
    accessor["bufferView"] = view;
    return accessor;
  }

  // Some elements of an accessor of vertices. The format wants each vertex to begin at a multiple of four bytes.
  int add_chosen(const Gltf_accessor_name& name, const std::vector<std::uint32_t>& chosen, const bool has_box)
  {
    const Gltf_elements elements = m_accessors.read(name);
    const std::size_t size = elements.element_size(), stride = (size + 3) / 4 * 4;
    std::vector<unsigned char> bytes(chosen.size() * stride, 0);
    for(std::size_t i = 0; i < chosen.size(); ++i) {
      std::memcpy(bytes.data() + i * stride, elements.bytes.data() + chosen[i] * size, size);
    }
    const int view =
        add_view(bytes.data(), bytes.size(), stride == size ? 0 : stride, TINYGLTF_TARGET_ARRAY_BUFFER);
    Json accessor = moved_accessor(name.number, view);
    accessor["count"] = chosen.size();
    accessor.erase("min");
    accessor.erase("max");
    if(has_box) {
      add_box(elements, chosen, accessor);
    }
    return add_to("accessors", std::move(accessor));
  }

  static void add_box(const Gltf_elements& elements, const std::vector<std::uint32_t>& chosen, Json& accessor)
  {
    const std::size_t width = elements.width();
    for(std::size_t axis = 0; axis < width; ++axis) {
      double low = elements.raw_number(chosen[0] * width + axis), high = low;
      for(const std::uint32_t v : chosen) {
        const double number = elements.raw_number(v * width + axis);
        low = (std::min)(low, number);
        high = (std::max)(high, number);
      }
      accessor["min"].push_back(low);
      accessor["max"].push_back(high);
    }
  }

  // Numbers that have nothing to do with vertices: an accessor several times is one again.
  void keep(Json& number, const std::string& use)
  {
    const int before = number.get<int>();
    const auto [place, is_new] = m_kept.emplace(before, -1);
    if(is_new) {
      const Gltf_elements elements = m_accessors.read({before, use});
      const int view = add_view(elements.bytes.data(), elements.bytes.size(), 0, 0);
      place->second = add_to("accessors", moved_accessor(before, view));
    }
    number = place->second;
  }

  // Meshes of points and lines alone
  void remove_empty_meshes()
  {
    std::vector<int> numbers;
    Json kept = Json::array();
    for(Json* const mesh : objects_in(m_file, m_json, "meshes")) {
      const bool is_empty = (*mesh)["primitives"].empty();
      numbers.push_back(is_empty ? -1 : static_cast<int>(kept.size()));
      if(!is_empty) {
        kept.push_back(std::move(*mesh));
      }
    }
    m_json["meshes"] = std::move(kept);
    for(Json* const node : objects_in(m_file, m_json, "nodes")) {
      const int mesh = number_in(m_file, *node, "mesh", "a node");
      if(mesh >= 0 && numbers[static_cast<std::size_t>(mesh)] >= 0) {
        (*node)["mesh"] = numbers[static_cast<std::size_t>(mesh)];
      } else if(mesh >= 0) {
        for(const char* const key : {"mesh", "skin", "weights"}) {
          node->erase(key);
        }
      }
    }
  }

  const Gltf_file& m_file;
  int m_set; // that the new texture coordinates become
  Gltf_accessors m_accessors;
  Json m_json;
  std::vector<unsigned char> m_data; // of the only buffer
  std::map<int, int> m_kept;         // of accessors in the file: their new number
};

} // namespace

std::string gltf_with_texture(const Gltf_file& file, const std::vector<Gltf_triangles>& triangles,
                              const Gltf_texture& texture, const std::string& output)
{
  Gltf_rewriter rewriter(file, texture.is_second_set ? 1 : 0);
  rewriter.replace_triangles(triangles);
  rewriter.keep_other_numbers();
  if(texture.has_tiny_picture) {
    rewriter.add_tiny_picture(output);
  }
  return rewriter.text(output);
}

} // namespace flatten_mesh
