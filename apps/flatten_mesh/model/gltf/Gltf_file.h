// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_FILE_H
#define FLATTEN_MESH_GLTF_FILE_H

#include "flatten_mesh/Json.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

struct Gltf_file
{
  std::string name;
  std::vector<std::string> files_beside; // that it refers to
  Json json;                             // the whole description, in which what is not ours stays as it is
  tinygltf::Model model;                 // what the description says of the surface
  std::vector<std::vector<unsigned char>> bytes; // of each buffer
  std::vector<std::pair<int, int>> primitives;   // those of `Gltf_surface`: the mesh, and the number in it
};

[[noreturn]] inline void refuse_gltf(const std::string& file, const std::string& what)
{
  throw Input_error("'" + file + "': " + what + "; export the mesh again");
}

// The elements of a list in a part of the description, such as the `skins`; none if there is no list. `Json_type` is
// `Json` or `const Json`.
template <class Json_type>
std::vector<Json_type*> objects_in(const Gltf_file& file, Json_type& parent, const std::string& key)
{
  std::vector<Json_type*> result;
  const auto list = parent.find(key);
  if(list == parent.end()) {
    return result;
  }
  for(Json_type& element : *list) {
    if(!list->is_array() || !element.is_object()) {
      refuse_gltf(file.name, "'" + key + "' is not a list of objects");
    }
    result.push_back(&element);
  }
  return result;
}

// The number of an element that a part of the description names, or -1 if it names none
inline int number_in(const Gltf_file& file, const Json& parent, const std::string& key,
                     const std::string& text)
{
  const auto number = parent.find(key);
  if(number == parent.end()) {
    return -1;
  }
  if(!number->is_number_unsigned() || number->get<std::uint64_t>() > (std::numeric_limits<int>::max)()) {
    refuse_gltf(file.name, text + " has a wrong '" + key + "'");
  }
  return number->get<int>();
}

// The element with this number, or an `Input_error` that says what names it
template <class Element>
const Element& gltf_element(const Gltf_file& file, const std::vector<Element>& elements, const int number,
                            const std::string& from, const char* const noun)
{
  if(number < 0 || static_cast<std::size_t>(number) >= elements.size()) {
    refuse_gltf(file.name, from + " names " + noun + ' ' + std::to_string(number) +
                               ", which does not exist: the file has " + std::to_string(elements.size()));
  }
  return elements[static_cast<std::size_t>(number)];
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_FILE_H
