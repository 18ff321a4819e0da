// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TINY_PICTURE_IN_GLTF_H
#define FLATTEN_MESH_TINY_PICTURE_IN_GLTF_H

#include "flatten_mesh/Json.h"
#include "flatten_mesh/model/gltf/next_texture.h"
#include "flatten_mesh/model/tiny_picture.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// Puts a picture into materials of a glTF file, such that it refers to a set of texture coordinates, and shows nothing.
class Tiny_picture
{
public:
  Tiny_picture(Json& json, const int set, const std::string& output)
      : m_json(json), m_set(set), m_output(output)
  {}

  // All primitives come before `end()`, and again after it, by `assign()`.
  void add(Json& primitive)
  {
    const bool has = has_set(primitive);
    m_needs_default = m_needs_default || (has && !primitive.contains("material"));
    for(const Json* const number : numbers(primitive)) {
      (has ? m_with_set : m_without_set).insert(number->get<std::size_t>());
    }
  }

  // Materials of triangles with and without the coordinates become two.
  void end(const int buffer_view)
  {
    const std::size_t image = add_to("images", {{"mimeType", "image/png"}, {"bufferView", buffer_view}});
    m_texture = add_to("textures", {{"source", image}});
    if(m_needs_default) {
      m_default = add_to("materials", Json::object());
      m_with_set.insert(m_default);
    }
    for(const std::size_t before : m_with_set) {
      std::size_t after = before;
      if(m_without_set.count(before) == 1) {
        const Json copy = m_json["materials"][before];
        after = add_to("materials", copy);
      }
      m_changed.emplace(before, after);
      add_pictures(after);
    }
  }

  void assign(Json& primitive) const
  {
    if(!has_set(primitive)) {
      return;
    }
    if(!primitive.contains("material")) {
      primitive["material"] = m_default;
    }
    for(Json* const number : numbers(primitive)) {
      *number = m_changed.at(number->get<std::size_t>());
    }
  }

private:
  std::size_t add_to(const char* const list, Json element)
  {
    m_json[list].push_back(std::move(element));
    return m_json[list].size() - 1;
  }

  bool has_set(const Json& primitive) const
  {
    return primitive.at("attributes").contains(texture_key + std::to_string(m_set));
  }

  // Those of the materials of a primitive, also in its variants
  static std::vector<Json*> numbers(Json& primitive)
  {
    std::vector<Json*> result;
    if(primitive.contains("material")) {
      result.push_back(&primitive["material"]);
    }
    const Json::json_pointer variants("/extensions/KHR_materials_variants/mappings");
    if(primitive.contains(variants)) {
      for(Json& mapping : primitive[variants]) {
        if(mapping.contains("material")) {
          result.push_back(&mapping["material"]);
        }
      }
    }
    return result;
  }

  // Tools that find the second set alone in use would make it the first one.
  void add_pictures(const std::size_t number)
  {
    for(int set = m_set; set >= 0; --set) {
      Json& material = m_json["materials"][number]; // which moves if the file gets its first extension
      if(!refers_to(material, set)) {
        add_picture(material, number, set);
      }
    }
  }

  static bool refers_to(const Json& part, const int set)
  {
    if(part.is_object() && part.contains("index")) {
      const Json::json_pointer moved("/extensions/KHR_texture_transform/texCoord");
      const int own = part.value("texCoord", 0);
      if((part.contains(moved) ? part[moved].get<int>() : own) == set) {
        return true;
      }
    }
    return part.is_structured() && std::any_of(part.begin(), part.end(),
                                               [set](const Json& member) { return refers_to(member, set); });
  }

  void add_picture(Json& material, const std::size_t number, const int set)
  {
    Json picture = {{"index", m_texture}};
    if(set > 0) {
      picture["texCoord"] = set;
    }
    const Json::json_pointer specular("/extensions/KHR_materials_specular/specularTexture");
    if(!material.contains("occlusionTexture")) {
      picture["strength"] = 0;
      material["occlusionTexture"] = picture;
    } else if(!material.contains("emissiveTexture") && !is_emissive(material)) {
      material["emissiveTexture"] = picture;
    } else if(!material.contains(specular) && may_be_specular(material)) { // of which the opacity counts
      material[specular] = picture;
      use_extension("KHR_materials_specular");
    } else {
      throw Output_error("cannot write '" + m_output + "': material " + std::to_string(number + 1) +
                         (material.contains("name") ? " " + material["name"].dump() : "") +
                         " has all textures that it can have: leave --placeholder-texture out");
    }
  }

  static bool is_emissive(const Json& material)
  {
    const auto factor = material.find("emissiveFactor");
    return factor != material.end() && *factor != Json::array({0, 0, 0});
  }

  static bool may_be_specular(const Json& material)
  {
    const auto extensions = material.find("extensions");
    return extensions == material.end() || !(extensions->contains("KHR_materials_unlit") ||
                                             extensions->contains("KHR_materials_pbrSpecularGlossiness"));
  }

  void use_extension(const char* const name)
  {
    Json& used = m_json["extensionsUsed"];
    if(std::find(used.begin(), used.end(), Json(name)) == used.end()) {
      used.push_back(name);
    }
  }

  Json& m_json;
  int m_set;
  std::string m_output;
  std::size_t m_texture = 0, m_default = 0;
  bool m_needs_default = false; // there are triangles with coordinates and without material
  std::set<std::size_t> m_with_set, m_without_set; // materials of triangles with and without the coordinates
  std::map<std::size_t, std::size_t> m_changed;    // materials with the coordinates: their number afterwards
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TINY_PICTURE_IN_GLTF_H
