// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_elements.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/model/gltf/next_texture.h"
#include "flatten_mesh/model/gltf_surface.h"
#include "flatten_mesh/texts.h"

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

class Gltf_rewriter
{
public:
  Gltf_rewriter(const Gltf_file& file, const int set)
      : m_file(file), m_set(set), m_accessors(file), m_model(file.model)
  {
    m_model.accessors.clear();
    m_model.bufferViews.clear();
    m_model.buffers.assign(1, {});
    m_model.asset.generator = "flatten_mesh";
  }

  void replace_triangles(const std::vector<Gltf_triangles>& all)
  {
    for(tinygltf::Mesh& mesh : m_model.meshes) {
      mesh.primitives.clear();
    }
    bool has_textures = false;
    for(const Gltf_triangles& triangles : all) {
      const auto [mesh, number] = m_file.primitives[triangles.primitive];
      const tinygltf::Primitive& given =
          m_file.model.meshes[static_cast<std::size_t>(mesh)].primitives[static_cast<std::size_t>(number)];
      has_textures = has_textures || has_moved_keys(given, m_set);
      m_model.meshes[static_cast<std::size_t>(mesh)].primitives.push_back(primitive(given, triangles));
    }
    if(has_textures) {
      for(tinygltf::Material& material : m_model.materials) {
        use_next_texture(material, m_set);
      }
    }
    remove_empty_meshes();
  }

  void keep_other_numbers()
  {
    for(std::size_t i = 0; i < m_model.skins.size(); ++i) {
      keep(m_model.skins[i].inverseBindMatrices, "skin " + std::to_string(i));
    }
    for(std::size_t i = 0; i < m_model.animations.size(); ++i) {
      for(tinygltf::AnimationSampler& sampler : m_model.animations[i].samplers) {
        keep(sampler.input, "animation " + std::to_string(i));
        keep(sampler.output, "animation " + std::to_string(i));
      }
    }
    for(tinygltf::Image& image : m_model.images) {
      const auto [first, size] = m_accessors.view(image.bufferView, "picture");
      image.bufferView = add_view(first, size, 0, 0);
    }
  }

  std::string text(const std::string& output)
  {
    fill_empty_objects();
    if(m_model.buffers[0].data.size() > largest_glb) {
      throw Output_error("cannot write '" + output +
                         "': binary glTF files have at most 4 GB; use .ply or .obj");
    }
    std::string text;
    text.reserve(m_model.buffers[0].data.size() + 10000);
    boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> stream(text);
    if(!tinygltf::TinyGLTF().WriteGltfSceneToStream(&m_model, stream, false, true)) {
      throw std::runtime_error("tinygltf could not write the model");
    }
    stream.flush();
    return text;
  }

private:
  tinygltf::Primitive primitive(const tinygltf::Primitive& given, const Gltf_triangles& triangles)
  {
    tinygltf::Primitive result = given;
    result.mode = TINYGLTF_MODE_TRIANGLES;
    result.attributes.clear();
    for(const auto& [key, accessor] : given.attributes) {
      result.attributes[next_key(key, m_set)] =
          add_chosen({accessor, key}, triangles.vertices, key == "POSITION");
    }
    if(!triangles.texture.empty() || has_moved_keys(given, m_set)) {
      add_texture(triangles.texture, m_set, triangles.vertices.size(), result);
      if(result.attributes.count(texture_key + "0") == 0) {
        add_texture({}, 0, triangles.vertices.size(), result);
      }
    }
    for(auto& target : result.targets) {
      std::map<std::string, int> chosen;
      for(const auto& [key, accessor] : target) {
        chosen[next_key(key, m_set)] =
            add_chosen({accessor, key + " of a morph target"}, triangles.vertices, key == "POSITION");
      }
      target = chosen;
    }
    result.indices = add(triangles.triangles, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                         TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return result;
  }

  // A set of texture coordinates, with 0 where there are none: sets are counted from 0 without a gap.
  void add_texture(std::vector<float> numbers, const int set, const std::size_t vertices,
                   tinygltf::Primitive& primitive)
  {
    numbers.resize(2 * vertices, 0);
    primitive.attributes[texture_key + std::to_string(set)] =
        add(numbers, TINYGLTF_TYPE_VEC2, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
  }

  // Appends bytes to the only buffer, each view where any numbers may begin.
  int add_view(const void* const bytes, const std::size_t size, const std::size_t stride, const int target)
  {
    std::vector<unsigned char>& data = m_model.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = size;
    view.byteStride = stride;
    view.target = target;
    const auto* first = static_cast<const unsigned char*>(bytes);
    data.insert(data.end(), first, first + size);
    m_model.bufferViews.push_back(view);
    return static_cast<int>(m_model.bufferViews.size()) - 1;
  }

  template <class Number>
  int add(const std::vector<Number>& numbers, const int type, const int component_type, const int target)
  {
    tinygltf::Accessor accessor;
    accessor.type = type;
    accessor.componentType = component_type;
    accessor.count = numbers.size() / (type == TINYGLTF_TYPE_VEC2 ? 2 : 1);
    accessor.bufferView = add_view(numbers.data(), sizeof(Number) * numbers.size(), 0, target);
    m_model.accessors.push_back(accessor);
    return static_cast<int>(m_model.accessors.size()) - 1;
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
    tinygltf::Accessor accessor = m_file.model.accessors[static_cast<std::size_t>(name.number)];
    accessor.sparse.isSparse = false;
    accessor.byteOffset = 0;
    accessor.count = chosen.size();
    accessor.minValues.clear();
    accessor.maxValues.clear();
    if(has_box) {
      add_box(elements, chosen, accessor);
    }
    accessor.bufferView =
        add_view(bytes.data(), bytes.size(), stride == size ? 0 : stride, TINYGLTF_TARGET_ARRAY_BUFFER);
    m_model.accessors.push_back(accessor);
    return static_cast<int>(m_model.accessors.size()) - 1;
  }

  static void add_box(const Gltf_elements& elements, const std::vector<std::uint32_t>& chosen,
                      tinygltf::Accessor& accessor)
  {
    const std::size_t width = elements.width();
    for(std::size_t axis = 0; axis < width; ++axis) {
      double low = elements.raw_number(chosen[0] * width + axis), high = low;
      for(const std::uint32_t v : chosen) {
        const double number = elements.raw_number(v * width + axis);
        low = (std::min)(low, number);
        high = (std::max)(high, number);
      }
      accessor.minValues.push_back(low);
      accessor.maxValues.push_back(high);
    }
  }

  // Numbers that have nothing to do with vertices: an accessor several times is one again.
  void keep(int& number, const std::string& use)
  {
    if(number < 0) {
      return;
    }
    const auto [place, is_new] = m_kept.emplace(number, -1);
    if(is_new) {
      const Gltf_elements elements = m_accessors.read({number, use});
      tinygltf::Accessor accessor = m_file.model.accessors[static_cast<std::size_t>(number)];
      accessor.sparse.isSparse = false;
      accessor.byteOffset = 0;
      accessor.bufferView = add_view(elements.bytes.data(), elements.bytes.size(), 0, 0);
      place->second = static_cast<int>(m_model.accessors.size());
      m_model.accessors.push_back(accessor);
    }
    number = place->second;
  }

  // Meshes of points and lines alone
  void remove_empty_meshes()
  {
    std::vector<int> numbers;
    int next = 0;
    for(const tinygltf::Mesh& mesh : m_model.meshes) {
      numbers.push_back(mesh.primitives.empty() ? -1 : next++);
    }
    m_model.meshes.erase(std::remove_if(m_model.meshes.begin(), m_model.meshes.end(),
                                        [](const tinygltf::Mesh& mesh) { return mesh.primitives.empty(); }),
                         m_model.meshes.end());
    for(tinygltf::Node& node : m_model.nodes) {
      if(node.mesh >= 0) {
        node.mesh = numbers[static_cast<std::size_t>(node.mesh)];
      }
      if(node.mesh < 0) {
        node.skin = -1;
        node.weights.clear();
      }
    }
  }

  // Tinygltf writes objects without any content as `null`, which is none. These contents are the defaults, or names.
  void fill_empty_objects()
  {
    for(tinygltf::Node& node : m_model.nodes) {
      if(node.matrix.empty() && node.translation.empty()) {
        node.translation = {0, 0, 0};
      }
    }
    for(tinygltf::Scene& scene : m_model.scenes) {
      scene.name = scene.name.empty() && scene.nodes.empty() ? "empty" : scene.name;
    }
    for(tinygltf::Camera& camera : m_model.cameras) { // no far plane is written as one at 0
      if(camera.perspective.zfar == 0) {
        camera.perspective.zfar = 1e9 * (std::max)(camera.perspective.znear, 1.);
      }
    }
    for(tinygltf::Texture& texture : m_model.textures) {
      texture.name = texture.name.empty() && texture.source < 0 ? "empty" : texture.name;
    }
  }

  const Gltf_file& m_file;
  int m_set; // that the new texture coordinates become
  Gltf_accessors m_accessors;
  tinygltf::Model m_model;
  std::map<int, int> m_kept; // of accessors in the file: their new number
};

} // namespace

std::string gltf_with_texture(const Gltf_file& file, const std::vector<Gltf_triangles>& triangles,
                              const bool is_second_set, const std::string& output)
{
  Gltf_rewriter rewriter(file, is_second_set ? 1 : 0);
  rewriter.replace_triangles(triangles);
  rewriter.keep_other_numbers();
  return rewriter.text(output);
}

} // namespace flatten_mesh
