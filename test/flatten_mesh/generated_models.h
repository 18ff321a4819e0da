// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Models with everything that OBJ files have, and their text as different programs would write it.

#ifndef TEST_GENERATED_MODELS_H
#define TEST_GENERATED_MODELS_H

#include "flatten_mesh/texts.h"

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace generated {

struct Corner
{
  int vertex = -1, texture = -1, normal = -1;

  bool operator==(const Corner& other) const
  {
    return vertex == other.vertex && texture == other.texture && normal == other.normal;
  }
};

using Polygon = std::vector<Corner>;

// A statement, or else a polygon
struct Line
{
  std::string statement;
  Polygon polygon;
};

struct Model
{
  std::vector<std::array<double, 3>> points, normals, colors;
  std::vector<std::array<double, 2>> texture;
  std::vector<Line> lines;

  std::vector<Polygon> polygons() const
  {
    std::vector<Polygon> result;
    for(const Line& line : lines)
      if(line.statement.empty())
        result.push_back(line.polygon);
    return result;
  }
};

struct Kinds
{
  bool has_colors = true, has_normals = true, has_texture = true;
  bool is_complete = false; // all polygons have what some have, and a material
};

class Random
{
public:
  explicit Random(const unsigned seed) : m_engine(seed) {}

  int below(const int n) { return static_cast<int>(m_engine() % static_cast<unsigned>(n)); }

  double number() { return static_cast<double>(m_engine()) / 4294967296. - 0.5; }

private:
  std::mt19937 m_engine;
};

// A bent strip of triangles, quadrangles and polygons with up to eight corners, in groups and two materials, with seams
// between some polygons.
inline Model strip(const unsigned seed, const Kinds& kinds = {})
{
  Random random(seed);
  Model model;
  const auto add_point = [&](const double x, const double y) {
    model.points.push_back({x + 0.1 * random.number(), y + 0.1 * random.number(), 0.3 * random.number()});
    if(kinds.has_colors)
      model.colors.push_back({random.number() + 0.5, random.number() + 0.5, random.number() + 0.5});
    return static_cast<int>(model.points.size()) - 1;
  };
  for(int i = 0; kinds.has_normals && i < 20; ++i)
    model.normals.push_back({random.number(), random.number(), 1});
  const std::array<const char*, 8> statements = {"g left side", "g",   "o second object", "usemtl red paint",
                                                 "usemtl blue", "s 1", "s off",           "g right"};
  std::vector<int> last_texture; // of the corners at the last side
  int low = add_point(0, 0), high = add_point(0, 1);
  double x = 0;
  model.lines.push_back({"mtllib paint.mtl", {}});
  if(kinds.is_complete)
    model.lines.push_back({"usemtl blue", {}});
  for(int k = 0; k < 24; ++k) {
    if(k % 3 == 0)
      model.lines.push_back({statements[static_cast<std::size_t>(k / 3)], {}});
    const int size = 3 + random.below(6), next_high = size == 3 ? high : -1;
    Polygon polygon = {{low}, {add_point(x + 1, 0)}};
    std::vector<int> top;
    for(int i = 0; i < size - 3; ++i)
      polygon.push_back({add_point(x + 1 - (i + 0.01) / (size - 3), 1 + 0.3 * random.below(2) * (i > 0))});
    polygon.push_back({high});
    const bool has_texture = kinds.has_texture && (kinds.is_complete || k % 8 != 7), is_seam = k % 5 == 0;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      Corner& corner = polygon[i];
      if(has_texture) {
        const bool is_last_side = i == 0 || i + 1 == polygon.size();
        if(is_last_side && !is_seam && !last_texture.empty()) {
          corner.texture = last_texture[i == 0 ? 0 : 1];
        } else {
          corner.texture = static_cast<int>(model.texture.size());
          model.texture.push_back({random.number() + 0.5, random.number() + 0.5});
        }
      }
      if(kinds.has_normals && (kinds.is_complete || k % 6 != 5))
        corner.normal = random.below(20);
    }
    low = polygon[1].vertex;
    high = next_high == -1 ? polygon[2].vertex : next_high;
    last_texture =
        has_texture ? std::vector<int>{polygon[1].texture, polygon[2].texture} : std::vector<int>();
    model.lines.push_back({"", polygon});
    x += 1;
  }
  return model;
}

inline void append_numbers(std::string& text, const char* keyword, const double* numbers,
                           const std::size_t count)
{
  text += keyword;
  for(std::size_t i = 0; i < count; ++i) {
    text += ' ';
    flatten_mesh::append_number(text, numbers[i]);
  }
}

// The same in different ways: numbers counted from the end, comments, continued lines, and ends of lines as on other
// systems.
inline std::string obj_text(const Model& model, const unsigned seed)
{
  Random random(seed);
  std::string text = "# a model\n\n";
  const bool is_dos = random.below(2) == 0, counts_back = random.below(2) == 0;
  const auto end_line = [&] {
    text += random.below(9) == 0 ? "  # a comment" : "";
    text += is_dos ? "\r\n" : "\n";
  };
  for(std::size_t v = 0; v < model.points.size(); ++v) {
    append_numbers(text, "v", model.points[v].data(), 3);
    if(!model.colors.empty())
      append_numbers(text, "", model.colors[v].data(), 3);
    end_line();
  }
  for(const auto& uv : model.texture) {
    append_numbers(text, "vt", uv.data(), 2);
    text += random.below(2) == 0 ? " 0" : "";
    end_line();
  }
  for(const auto& normal : model.normals) {
    append_numbers(text, "vn", normal.data(), 3);
    end_line();
  }
  const auto number = [&](const int i, const std::size_t all) {
    return std::to_string(counts_back ? i - static_cast<int>(all) : i + 1);
  };
  for(const Line& line : model.lines) {
    text += line.statement.empty() ? "f" : line.statement;
    for(const Corner& corner : line.polygon) {
      text += random.below(9) == 0 ? (is_dos ? " \\\r\n" : " \\\n") : random.below(2) == 0 ? "\t" : " ";
      text += number(corner.vertex, model.points.size());
      if(corner.texture >= 0 || corner.normal >= 0)
        text += "/" + (corner.texture < 0 ? "" : number(corner.texture, model.texture.size()));
      if(corner.normal >= 0)
        text += "/" + number(corner.normal, model.normals.size());
    }
    end_line();
  }
  return text;
}

} // namespace generated

#endif // TEST_GENERATED_MODELS_H
