// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_PLY_H
#define FLATTEN_MESH_READ_PLY_H

#include "flatten_mesh/model/Model.h"

#include <CGAL/IO/PLY/PLY_reader.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <istream>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

namespace ply = CGAL::IO::internal;

using Ply_numbers = std::vector<double>;
using Ply_getter = std::function<void(Ply_numbers&)>; // appends what was read last

// CGAL::IO::read_PLY() drops normals and texture coordinates, but what it is made of reads them. Whole numbers of colours
// are scaled to at most 1.
template <class Number>
Ply_getter ply_getter_of(const ply::PLY_read_number* property, const bool is_color)
{
  const double unit = is_color && std::is_integral<Number>::value
                          ? static_cast<double>((std::numeric_limits<Number>::max)())
                          : 1;
  if(const auto* number = dynamic_cast<const ply::PLY_read_typed_number<Number>*>(property)) {
    return [number, unit](Ply_numbers& out) { out.push_back(static_cast<double>(number->buffer()) / unit); };
  }
  if(const auto* list = dynamic_cast<const ply::PLY_read_typed_list<Number>*>(property)) {
    return [list](Ply_numbers& out) { out.insert(out.end(), list->buffer().begin(), list->buffer().end()); };
  }
  return {};
}

inline Ply_getter ply_getter(const ply::PLY_read_number* property, const bool is_color)
{
  for(const auto make :
      {ply_getter_of<float>, ply_getter_of<double>, ply_getter_of<std::int8_t>, ply_getter_of<std::uint8_t>,
       ply_getter_of<std::int16_t>, ply_getter_of<std::uint16_t>, ply_getter_of<std::int32_t>,
       ply_getter_of<std::uint32_t>}) {
    if(Ply_getter getter = make(property, is_color)) {
      return getter;
    }
  }
  return {};
}

using Ply_names = std::initializer_list<const char*>;

// Reads all the properties of these names, or none.
inline std::vector<Ply_getter> ply_getters(ply::PLY_element& element, const Ply_names& names,
                                           const bool is_color = false)
{
  std::vector<Ply_getter> getters;
  for(const std::string name : names) {
    for(std::size_t k = 0; k < element.number_of_properties(); ++k) {
      if(element.property(k)->name() == name) {
        getters.push_back(ply_getter(element.property(k), is_color));
        break;
      }
    }
  }
  return getters.size() == names.size() ? getters : std::vector<Ply_getter>();
}

inline std::vector<Ply_getter> first_ply_getters(ply::PLY_element& element,
                                                 const std::initializer_list<Ply_names>& all_names,
                                                 const bool is_color = false)
{
  for(const Ply_names& names : all_names) {
    std::vector<Ply_getter> getters = ply_getters(element, names, is_color);
    if(!getters.empty()) {
      return getters;
    }
  }
  return {};
}

// Reads one item. False at the end of the file.
inline bool get_ply_item(ply::PLY_element& element, std::istream& file)
{
  for(std::size_t k = 0; k < element.number_of_properties(); ++k) {
    element.property(k)->get(file);
    if(file.fail()) {
      return false;
    }
  }
  return true;
}

inline const Ply_numbers& get_ply_numbers(const std::vector<Ply_getter>& getters, Ply_numbers& numbers)
{
  numbers.clear();
  for(const Ply_getter& getter : getters) {
    getter(numbers);
  }
  return numbers;
}

inline bool read_ply_vertices(std::istream& file, ply::PLY_element& element, Model& model)
{
  const auto points = ply_getters(element, {"x", "y", "z"}),
             normals = ply_getters(element, {"nx", "ny", "nz"});
  const auto texture = first_ply_getters(element, {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}});
  const auto colors = first_ply_getters(
      element, {{"red", "green", "blue", "alpha"}, {"red", "green", "blue"}, {"r", "g", "b"}}, true);
  if(points.empty()) {
    return false;
  }
  Ply_numbers n;
  for(std::size_t j = 0; j < element.number_of_items(); ++j) {
    if(!get_ply_item(element, file) || get_ply_numbers(points, n).size() != 3) {
      return false;
    }
    model.points.emplace_back(n[0], n[1], n[2]);
    if(get_ply_numbers(normals, n).size() == 3) {
      model.normals.emplace_back(n[0], n[1], n[2]);
    }
    if(get_ply_numbers(texture, n).size() == 2) {
      model.texture.emplace_back(n[0], n[1]);
    }
    if(get_ply_numbers(colors, n).size() >= 3) {
      model.colors.push_back({n[0], n[1], n[2], n.size() > 3 ? n[3] : 1});
    }
  }
  return true;
}

// Texture coordinates of the corners of the last polygon, as two numbers each
inline void add_ply_corners(const Ply_numbers& numbers, const std::size_t first, Model& model)
{
  if(numbers.empty() || numbers.size() != 2 * (model.vertices.size() - first)) {
    return;
  }
  model.corner_texture.resize(first, no_index);
  for(std::size_t i = 0; i < numbers.size(); i += 2) {
    model.corner_texture.push_back(static_cast<Index>(model.texture.size()));
    model.texture.emplace_back(numbers[i], numbers[i + 1]);
  }
}

inline bool read_ply_faces(std::istream& file, ply::PLY_element& element, Model& model)
{
  const auto vertices = first_ply_getters(element, {{"vertex_indices"}, {"vertex_index"}});
  const auto texture =
      model.has_point_texture ? std::vector<Ply_getter>() : ply_getters(element, {"texcoord"});
  if(vertices.empty()) {
    return false;
  }
  Ply_numbers n;
  for(std::size_t j = 0; j < element.number_of_items(); ++j) {
    if(!get_ply_item(element, file)) {
      return false;
    }
    const std::size_t first = model.vertices.size();
    for(const double index : get_ply_numbers(vertices, n)) {
      model.vertices.push_back(index >= 0 && index < no_index ? static_cast<Index>(index) : no_index);
    }
    add_ply_corners(get_ply_numbers(texture, n), first, model);
    model.end_polygon();
  }
  return true;
}

} // namespace internal

// Reads a PLY file: points, their colours, normals and texture coordinates, polygons, and the texture coordinates of
// their corners. Returns whether it was understood.
inline bool read_ply(std::istream& file, Model& model)
{
  internal::ply::PLY_reader reader(false);
  if(!reader.init(file)) {
    return false;
  }
  for(std::size_t i = 0; i < reader.number_of_elements(); ++i) {
    internal::ply::PLY_element& element = reader.element(i);
    bool is_right = true;
    if(element.name() == "vertex" || element.name() == "vertices") {
      is_right = model.points.empty() && internal::read_ply_vertices(file, element, model);
      model.has_point_normals = !model.normals.empty();
      model.has_point_texture = !model.texture.empty();
    } else if(element.name() == "face" || element.name() == "faces") {
      is_right = internal::read_ply_faces(file, element, model);
    } else {
      for(std::size_t j = 0; j < element.number_of_items() && is_right; ++j) {
        is_right = internal::get_ply_item(element, file);
      }
    }
    if(!is_right) {
      return false;
    }
  }
  if(!model.corner_texture.empty()) {
    model.corner_texture.resize(model.number_of_corners(), no_index);
  }
  return true;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_PLY_H
