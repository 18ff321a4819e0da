// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles of models that the program wrote, in any format, with their texture coordinates.

#ifndef TEST_READ_TEXTURED_MODEL_H
#define TEST_READ_TEXTURED_MODEL_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/read_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace textured {

struct Textured_face
{
  std::string material;
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<double, 2>> uv; // empty where there is none
};

// Polygons become fans of triangles.
inline std::vector<Textured_face> read_textured(const std::string& file)
{
  using namespace flatten_mesh;
  Command_line command;
  command.quiet = true;
  Notes notes = notes_of(command);
  const Model model = read_model(file, Degenerate_faces::KEPT, notes);
  std::vector<Textured_face> faces;
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    const Index first = model.first_corners[p];
    for(Index last = first + 2; last < model.first_corners[p + 1]; ++last) {
      Textured_face face;
      const Index material = model.material(p);
      face.material = material == no_index ? "" : model.material_names[material];
      for(const Index c : {first, last - 1, last}) {
        const Kernel::Point_3& point = model.points[model.vertices[c]];
        face.points.push_back(
            {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())});
        if(const Index t = model.texture_point(c); t != no_index)
          face.uv.push_back({model.texture[t].x(), model.texture[t].y()});
      }
      faces.push_back(face);
    }
  }
  return faces;
}

// Their corners, whatever their order
inline std::multiset<std::multiset<std::array<float, 3>>> corners_of(const std::vector<Textured_face>& faces)
{
  std::multiset<std::multiset<std::array<float, 3>>> result;
  for(const Textured_face& face : faces)
    result.emplace(face.points.begin(), face.points.end());
  return result;
}

inline std::vector<std::vector<std::array<double, 2>>> texture_of(const std::vector<Textured_face>& faces)
{
  std::vector<std::vector<std::array<double, 2>>> texture;
  for(const Textured_face& face : faces)
    texture.push_back(face.uv);
  return texture;
}

inline double area(const std::vector<Textured_face>& faces)
{
  double sum = 0;
  for(const Textured_face& face : faces) {
    std::array<double, 3> a = {}, b = {};
    for(std::size_t i = 0; i < 3; ++i) {
      a[i] = static_cast<double>(face.points[1][i]) - face.points[0][i];
      b[i] = static_cast<double>(face.points[2][i]) - face.points[0][i];
    }
    sum += std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

// Twice the area, negative if the face is turned
inline double signed_area(const std::array<double, 2>& p, const std::array<double, 2>& q,
                          const std::array<double, 2>& r)
{
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

inline double planar_area(const std::vector<Textured_face>& faces)
{
  double sum = 0;
  for(const Textured_face& face : faces)
    sum += face.uv.empty() ? 0 : signed_area(face.uv[0], face.uv[1], face.uv[2]) / 2;
  return sum;
}

// How many texels of a page of `n` by `n` have their centre inside of several faces
inline std::size_t number_of_shared_texels(const std::vector<Textured_face>& faces, const int n)
{
  std::vector<int> count(static_cast<std::size_t>(n * n), 0);
  const double tolerance = 1e-9; // of coordinates of type `float`, squared
  for(const Textured_face& face : faces) {
    if(face.uv.empty())
      continue;
    const auto place = [n](const double x) {
      return (std::min)((std::max)(static_cast<int>(n * x), 0), n - 1);
    };
    const auto [x_low, x_high] = std::minmax({face.uv[0][0], face.uv[1][0], face.uv[2][0]});
    const auto [y_low, y_high] = std::minmax({face.uv[0][1], face.uv[1][1], face.uv[2][1]});
    for(int i = place(x_low); i <= place(x_high); ++i) {
      for(int j = place(y_low); j <= place(y_high); ++j) {
        const std::array<double, 2> centre = {(i + 0.5) / n, (j + 0.5) / n};
        bool is_inside = true;
        for(std::size_t k = 0; k < 3; ++k)
          is_inside = is_inside && signed_area(face.uv[k], face.uv[(k + 1) % 3], centre) > tolerance;
        count[static_cast<std::size_t>(i * n + j)] += is_inside;
      }
    }
  }
  return static_cast<std::size_t>(
      std::count_if(count.begin(), count.end(), [](const int c) { return c > 1; }));
}

} // namespace textured

#endif // TEST_READ_TEXTURED_MODEL_H
