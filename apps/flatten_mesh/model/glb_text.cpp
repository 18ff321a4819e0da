// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/model/glb_text.h"

#include "flatten_mesh/model/tiny_picture.h"

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>
#include <boost/locale/encoding_utf.hpp>

#include <tiny_gltf.h>

#include <algorithm>
#include <stdexcept>

namespace flatten_mesh {

namespace {

// Appends bytes to the only buffer of the model, and describes them.
int add_view(tinygltf::Model& model, const void* bytes, const std::size_t size, const int target)
{
  std::vector<unsigned char>& data = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = size;
  view.target = target;
  const auto* first = static_cast<const unsigned char*>(bytes);
  data.insert(data.end(), first, first + size);
  model.bufferViews.push_back(view);
  return static_cast<int>(model.bufferViews.size()) - 1;
}

template <class Number>
int add_accessor(tinygltf::Model& model, const std::vector<Number>& numbers, const std::size_t width,
                 const int type, const int component, const int target)
{
  tinygltf::Accessor accessor;
  accessor.bufferView = add_view(model, numbers.data(), sizeof(Number) * numbers.size(), target);
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = numbers.size() / width;
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

int add_floats(tinygltf::Model& model, const std::vector<float>& numbers, const std::size_t width,
               const int type)
{
  return add_accessor(model, numbers, width, type, TINYGLTF_COMPONENT_TYPE_FLOAT,
                      TINYGLTF_TARGET_ARRAY_BUFFER);
}

// The format asks for the box of the positions.
void add_box(tinygltf::Accessor& accessor, const std::vector<float>& positions)
{
  for(std::size_t axis = 0; axis < 3; ++axis) {
    float low = positions[axis], high = low;
    for(std::size_t i = axis; i < positions.size(); i += 3) {
      low = (std::min)(low, positions[i]);
      high = (std::max)(high, positions[i]);
    }
    accessor.minValues.push_back(low);
    accessor.maxValues.push_back(high);
  }
}

tinygltf::Primitive add_primitive(tinygltf::Model& model, const Glb_primitive& given)
{
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = static_cast<int>(given.material);
  const int positions = add_floats(model, given.positions, 3, TINYGLTF_TYPE_VEC3);
  add_box(model.accessors[static_cast<std::size_t>(positions)], given.positions);
  primitive.attributes["POSITION"] = positions;
  if(!given.normals.empty()) {
    primitive.attributes["NORMAL"] = add_floats(model, given.normals, 3, TINYGLTF_TYPE_VEC3);
  }
  if(!given.tangents.empty()) {
    primitive.attributes["TANGENT"] = add_floats(model, given.tangents, 4, TINYGLTF_TYPE_VEC4);
  }
  if(!given.texture.empty()) {
    primitive.attributes["TEXCOORD_0"] = add_floats(model, given.texture, 2, TINYGLTF_TYPE_VEC2);
  }
  if(!given.second_texture.empty()) {
    primitive.attributes["TEXCOORD_1"] = add_floats(model, given.second_texture, 2, TINYGLTF_TYPE_VEC2);
  }
  if(!given.colors.empty()) {
    primitive.attributes["COLOR_0"] = add_floats(model, given.colors, 4, TINYGLTF_TYPE_VEC4);
  }
  primitive.indices =
      add_accessor(model, given.indices, 1, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                   TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return primitive;
}

// Returns the number of the texture, or -1 without a picture.
int add_texture(tinygltf::Model& model, const std::string& png)
{
  if(png.empty()) {
    return -1;
  }
  tinygltf::Image image;
  image.mimeType = "image/png";
  image.bufferView = add_view(model, png.data(), png.size(), 0);
  model.images.push_back(image);
  tinygltf::Texture texture;
  texture.source = static_cast<int>(model.images.size()) - 1;
  model.textures.push_back(texture);
  return static_cast<int>(model.textures.size()) - 1;
}

// By a strength of 0, and a factor of 0, which is the default, pictures show nothing.
void add_tiny_picture(tinygltf::Model& model, const std::vector<Glb_material>& materials,
                      const bool has_two_sets)
{
  const int picture = add_texture(model, std::string(tiny_picture.begin(), tiny_picture.end()));
  for(std::size_t i = 0; i < materials.size(); ++i) {
    if(materials[i].has_pictures) {
      model.materials[i].occlusionTexture.index = picture;
      model.materials[i].occlusionTexture.strength = 0;
      if(has_two_sets) {
        model.materials[i].occlusionTexture.texCoord = 1;
        model.materials[i].emissiveTexture.index = picture;
      }
    }
  }
}

void add_textures(tinygltf::Model& model, const std::vector<Glb_material>& materials,
                  const Glb_pictures& pictures)
{
  const int normals = add_texture(model, pictures.normals), colors = add_texture(model, pictures.colors);
  for(std::size_t i = 0; i < materials.size(); ++i) {
    if(materials[i].has_pictures) {
      model.materials[i].normalTexture.index = normals;
      model.materials[i].pbrMetallicRoughness.baseColorTexture.index = colors;
    }
  }
}

tinygltf::Material make_material(const Glb_material& given)
{
  tinygltf::Material material;
  material.name = boost::locale::conv::utf_to_utf<char>(given.name); // without bytes that are no UTF-8
  material.pbrMetallicRoughness.baseColorFactor.assign(given.color.begin(), given.color.end());
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.doubleSided = true;
  if(given.color[3] < 1) {
    material.alphaMode = "BLEND";
  }
  return material;
}

} // namespace

std::string glb_text(const std::vector<Glb_material>& materials, const std::vector<Glb_primitive>& primitives,
                     const Glb_pictures& pictures, const std::array<double, 3>& place)
{
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "flatten_mesh";
  for(const Glb_material& material : materials) {
    model.materials.push_back(make_material(material));
  }
  std::size_t bytes = pictures.normals.size() + pictures.colors.size();
  for(const Glb_primitive& primitive : primitives) {
    bytes += primitive.bytes();
  }
  model.buffers.emplace_back();
  model.buffers[0].data.reserve(bytes);
  tinygltf::Mesh mesh;
  for(const Glb_primitive& primitive : primitives) {
    mesh.primitives.push_back(add_primitive(model, primitive));
  }
  if(pictures.has_tiny_one) { // behind the numbers, which have to be aligned
    add_tiny_picture(model, materials,
                     std::any_of(primitives.begin(), primitives.end(), [](const Glb_primitive& primitive) {
                       return !primitive.second_texture.empty();
                     }));
  } else {
    add_textures(model, materials, pictures);
  }
  model.meshes.push_back(mesh);
  tinygltf::Node node;
  node.mesh = 0;
  if(place != std::array<double, 3>{0, 0, 0}) {
    node.translation.assign(place.begin(), place.end());
  }
  model.nodes.push_back(node);
  tinygltf::Scene scene;
  scene.nodes.push_back(0);
  model.scenes.push_back(scene);
  model.defaultScene = 0;

  std::string text;
  text.reserve(bytes + 10000);
  boost::iostreams::stream<boost::iostreams::back_insert_device<std::string>> stream(text);
  if(!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true)) {
    throw std::runtime_error("tinygltf could not write the model");
  }
  stream.flush();
  return text;
}

} // namespace flatten_mesh
