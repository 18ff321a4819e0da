// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NODE_PLACES_H
#define FLATTEN_MESH_NODE_PLACES_H

#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// An affine map of space
struct Gltf_place
{
  std::array<std::array<double, 4>, 3> rows = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  // Of a matrix of glTF: four columns, one after the other
  static Gltf_place of_columns(const double* const numbers)
  {
    Gltf_place place;
    for(std::size_t i = 0; i < 3; ++i) {
      for(std::size_t j = 0; j < 4; ++j) {
        place.rows[i][j] = numbers[4 * j + i];
      }
    }
    return place;
  }

  std::array<double, 3> point(const std::array<double, 3>& p) const
  {
    std::array<double, 3> result;
    for(std::size_t i = 0; i < 3; ++i) {
      result[i] = rows[i][0] * p[0] + rows[i][1] * p[1] + rows[i][2] * p[2] + rows[i][3];
    }
    return result;
  }

  double determinant() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      sum += rows[0][i] * cofactor(0, i);
    }
    return sum;
  }

  // Of any length
  std::array<double, 3> normal(const std::array<double, 3>& n) const
  {
    const double sign = determinant() < 0 ? -1 : 1;
    std::array<double, 3> result;
    for(std::size_t i = 0; i < 3; ++i) {
      result[i] = sign * (cofactor(i, 0) * n[0] + cofactor(i, 1) * n[1] + cofactor(i, 2) * n[2]);
    }
    return result;
  }

private:
  double cofactor(const std::size_t i, const std::size_t j) const
  {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return rows[i1][j1] * rows[i2][j2] - rows[i1][j2] * rows[i2][j1];
  }
};

namespace internal {

inline Gltf_place product(const Gltf_place& a, const Gltf_place& b)
{
  Gltf_place result;
  for(std::size_t i = 0; i < 3; ++i) {
    for(std::size_t j = 0; j < 4; ++j) {
      result.rows[i][j] = a.rows[i][0] * b.rows[0][j] + a.rows[i][1] * b.rows[1][j] +
                          a.rows[i][2] * b.rows[2][j] + (j == 3 ? a.rows[i][3] : 0);
    }
  }
  return result;
}

inline void check_numbers(const Gltf_file& file, const std::vector<double>& numbers,
                          const std::size_t expected, const std::string& what)
{
  if(!numbers.empty() && numbers.size() != expected) {
    refuse_gltf(file.name, what + " has " + count_text(numbers.size(), "number") + " instead of " +
                               std::to_string(expected));
  }
}

// Of a node in its parent
inline Gltf_place own_place(const Gltf_file& file, const tinygltf::Node& node, const std::string& text)
{
  check_numbers(file, node.matrix, 16, "the matrix of " + text);
  check_numbers(file, node.translation, 3, "the translation of " + text);
  check_numbers(file, node.rotation, 4, "the rotation of " + text);
  check_numbers(file, node.scale, 3, "the scale of " + text);
  Gltf_place place;
  if(!node.matrix.empty()) {
    return Gltf_place::of_columns(node.matrix.data());
  }
  if(!node.rotation.empty()) {
    const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3],
                 squared = x * x + y * y + z * z + w * w, s = squared > 0 ? 2 / squared : 0;
    place.rows = {{{1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), 0},
                   {s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w), 0},
                   {s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y), 0}}};
  }
  for(std::size_t i = 0; i < 3; ++i) {
    for(std::size_t j = 0; j < 3; ++j) {
      place.rows[i][j] *= node.scale.empty() ? 1 : node.scale[j];
    }
    place.rows[i][3] = node.translation.empty() ? 0 : node.translation[i];
  }
  return place;
}

} // namespace internal

inline std::string node_text(const Gltf_file& file, const std::size_t number)
{
  const std::string& name = file.model.nodes[number].name;
  return "node " + std::to_string(number) + (name.empty() ? "" : " ('" + name + "')");
}

// The place of each node in its scene. Throws if the nodes are no trees.
inline std::vector<Gltf_place> node_places(const Gltf_file& file)
{
  const std::vector<tinygltf::Node>& nodes = file.model.nodes;
  std::vector<bool> has_parent(nodes.size(), false);
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    for(const int child : nodes[n].children) {
      gltf_element(file, nodes, child, node_text(file, n), "node");
      const auto number = static_cast<std::size_t>(child);
      if(has_parent[number]) {
        refuse_gltf(file.name, node_text(file, number) + " has two parents");
      }
      has_parent[number] = true;
    }
  }
  std::vector<Gltf_place> places(nodes.size());
  std::vector<std::size_t> order; // parents before children
  for(std::size_t n = 0; n < nodes.size(); ++n) {
    places[n] = internal::own_place(file, nodes[n], node_text(file, n));
    if(!has_parent[n]) {
      order.push_back(n);
    }
  }
  for(std::size_t i = 0; i < order.size(); ++i) {
    for(const int child : nodes[order[i]].children) {
      const auto number = static_cast<std::size_t>(child);
      places[number] = internal::product(places[order[i]], places[number]);
      order.push_back(number);
    }
  }
  if(order.size() < nodes.size()) {
    refuse_gltf(file.name, "nodes are their own ancestors");
  }
  return places;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NODE_PLACES_H
