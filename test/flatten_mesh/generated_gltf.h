// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// glTF files as other programs may write them.

#ifndef TEST_GENERATED_GLTF_H
#define TEST_GENERATED_GLTF_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace generated {

inline std::string base64(const std::string& bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for(std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

// Puts a file together: numbers by functions, all else as JSON.
class Gltf
{
public:
  std::string json = "\"asset\":{\"version\":\"2.0\"}"; // what is not said by the functions
  std::string bytes;                                    // of the only buffer
  std::vector<std::string> accessors, views;

  // Returns the number of the accessor.
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers, const std::string& type, const std::string& more = "")
  {
    static const std::map<std::string, std::size_t> widths = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    bytes.resize((bytes.size() + 3) / 4 * 4);
    std::string data(numbers.size() * sizeof(Number), '\0');
    std::memcpy(&data[0], numbers.data(), data.size());
    add_view(data);
    accessors.push_back("{\"bufferView\":" + std::to_string(views.size() - 1) +
                        ",\"componentType\":" + std::to_string(component_type(Number())) +
                        ",\"count\":" + std::to_string(numbers.size() / widths.at(type)) + ",\"type\":\"" +
                        type + "\"" + more + "}");
    return accessors.size() - 1;
  }

  std::size_t add_view(const std::string& data)
  {
    views.push_back("{\"buffer\":0,\"byteOffset\":" + std::to_string(bytes.size()) +
                    ",\"byteLength\":" + std::to_string(data.size()) + "}");
    bytes += data;
    return views.size() - 1;
  }

  // With the buffer as a text, or in a file of its own
  std::string text(const std::string& uri = "") const
  {
    return description(",\"uri\":\"" +
                       (uri.empty() ? "data:application/octet-stream;base64," + base64(bytes) : uri) + "\"");
  }

  std::string binary() const
  {
    std::string description = this->description(""), data = bytes;
    description.resize((description.size() + 3) / 4 * 4, ' ');
    data.resize((data.size() + 3) / 4 * 4, '\0');
    return "glTF" + number(2) + number(28 + description.size() + data.size()) + number(description.size()) +
           "JSON" + description + number(data.size()) + std::string("BIN\0", 4) + data;
  }

  static std::string number(const std::size_t given)
  {
    const auto value = static_cast<std::uint32_t>(given);
    std::string text(4, '\0');
    std::memcpy(&text[0], &value, 4);
    return text;
  }

private:
  static int component_type(std::uint8_t) { return 5121; }
  static int component_type(std::int16_t) { return 5122; }
  static int component_type(std::uint16_t) { return 5123; }
  static int component_type(std::uint32_t) { return 5125; }
  static int component_type(float) { return 5126; }

  static std::string list(const std::vector<std::string>& items)
  {
    std::string text;
    for(const std::string& item : items)
      text += (text.empty() ? "" : ",") + item;
    return "[" + text + "]";
  }

  std::string description(const std::string& uri) const
  {
    return "{" + json + ",\"buffers\":[{\"byteLength\":" + std::to_string(bytes.size()) + uri +
           "}],\"bufferViews\":" + list(views) + ",\"accessors\":" + list(accessors) + "}";
  }
};

// A ball of latitudes and longitudes, split along a meridian, as texture coordinates need it.
struct Ball
{
  std::vector<float> points, normals, texture;
  std::vector<std::uint32_t> triangles;

  explicit Ball(const std::uint32_t n, const std::uint32_t m)
  {
    const double pi = std::acos(-1.);
    for(std::uint32_t i = 0; i <= n; ++i) {
      for(std::uint32_t j = 0; j <= m; ++j) {
        const double a = pi * i / n, b = 2 * pi * (j % m) / m, s = i == 0 || i == n ? 0 : std::sin(a);
        const std::array<double, 3> point = {s * std::cos(b), std::cos(a), s * std::sin(b)};
        for(const double x : point) {
          points.push_back(static_cast<float>(x));
          normals.push_back(static_cast<float>(x));
        }
        texture.push_back(static_cast<float>(j) / static_cast<float>(m));
        texture.push_back(static_cast<float>(i) / static_cast<float>(n));
      }
    }
    for(std::uint32_t i = 0; i < n; ++i) {
      for(std::uint32_t j = 0; j < m; ++j) {
        const std::uint32_t a = i * (m + 1) + j, b = a + 1, c = a + m + 1, d = c + 1;
        if(i > 0)
          triangles.insert(triangles.end(), {a, b, c});
        if(i + 1 < n)
          triangles.insert(triangles.end(), {b, d, c});
      }
    }
  }
};

inline const std::string scene = ",\"scenes\":[{\"nodes\":[0]}],\"scene\":0";

inline std::string attributes(Gltf& gltf, const Ball& ball)
{
  return "{\"POSITION\":" + std::to_string(gltf.add(ball.points, "VEC3")) +
         ",\"NORMAL\":" + std::to_string(gltf.add(ball.normals, "VEC3")) +
         ",\"TEXCOORD_0\":" + std::to_string(gltf.add(ball.texture, "VEC2")) + "}";
}

// A ball in two materials, with a picture, under these nodes
inline Gltf ball_with_nodes(const std::string& nodes, const std::string& more = scene)
{
  Gltf gltf;
  const Ball ball(8, 12);
  const auto middle = ball.triangles.begin() + 90;
  const std::string all = attributes(gltf, ball),
                    first = std::to_string(
                        gltf.add(std::vector<std::uint16_t>(ball.triangles.begin(), middle), "SCALAR")),
                    second = std::to_string(
                        gltf.add(std::vector<std::uint32_t>(middle, ball.triangles.end()), "SCALAR")),
                    picture = std::to_string(
                        gltf.add_view(std::string("\x89PNG\r\n\x1A\n", 8) + "not looked at IEND\xAE"));
  gltf.json +=
      ",\"meshes\":[{\"name\":\"ball\",\"primitives\":[{\"attributes\":" + all + ",\"indices\":" + first +
      ",\"material\":0},{\"attributes\":" + all + ",\"indices\":" + second +
      ",\"material\":1}]}],\"materials\":[{\"name\":\"wood\",\"pbrMetallicRoughness\":{\"baseColorFactor\":["
      "1,0.5,0,1],\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"texCoord\":"
      "0,"
      "\"offset\":[0.5,0]}}}}},{\"name\":\"wood\"}],\"textures\":[{\"source\":0}],\"images\":[{\"mimeType\":"
      "\"image/png\",\"bufferView\":" +
      picture + "}],\"extensionsUsed\":[\"KHR_texture_transform\"],\"nodes\":[" + nodes + "]" + more;
  return gltf;
}

} // namespace generated

#endif // TEST_GENERATED_GLTF_H
