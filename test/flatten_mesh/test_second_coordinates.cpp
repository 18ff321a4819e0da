// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `flatten_mesh --uv-set 1`: the atlas as second texture coordinates, as for light maps.

#include "run_flatten_mesh.h"

#include "generated_gltf.h"
#include "generated_models.h"

BOOST_AUTO_TEST_SUITE(test_second_coordinates)

using Json = boost::property_tree::ptree;
using Texture = std::vector<std::array<float, 2>>;

inline const Json& element(const Json& list, const std::size_t number)
{
  auto child = list.begin();
  std::advance(child, number);
  return child->second;
}

// A GLB file as a reader of the format sees it. Nothing of the program's own is used.
struct Glb
{
  Json json;
  std::string bytes;

  explicit Glb(const std::string& text)
  {
    const auto number = [&text](const std::size_t place) {
      std::uint32_t value = 0;
      std::memcpy(&value, &text.at(place), 4);
      return value;
    };
    BOOST_TEST_REQUIRE(number(8) == text.size());
    std::istringstream stream(text.substr(20, number(12)));
    boost::property_tree::read_json(stream, json);
    bytes = text.substr(28 + number(12), number(20 + number(12)));
  }

  std::vector<Json> primitives() const
  {
    std::vector<Json> result;
    for(const auto& [key, mesh] : json.get_child("meshes"))
      for(const auto& [number, primitive] : mesh.get_child("primitives"))
        result.push_back(primitive);
    return result;
  }

  template <class Number, std::size_t width>
  std::vector<std::array<Number, width>> numbers(const std::size_t accessor_number) const
  {
    const Json& accessor = element(json.get_child("accessors"), accessor_number);
    const Json& view = element(json.get_child("bufferViews"), accessor.get<std::size_t>("bufferView"));
    BOOST_TEST(accessor.get<int>("componentType") == (std::is_same<Number, float>::value ? 5126 : 5125));
    std::vector<std::array<Number, width>> result(accessor.get<std::size_t>("count"));
    const std::size_t first =
        view.get("byteOffset", std::size_t(0)) + accessor.get("byteOffset", std::size_t(0));
    BOOST_TEST_REQUIRE(first + sizeof(result[0]) * result.size() <= bytes.size());
    std::memcpy(result.data(), &bytes[first], sizeof(result[0]) * result.size());
    return result;
  }

  // Of each corner of a primitive; empty if it has no such attribute
  template <std::size_t width>
  std::vector<std::array<float, width>> corners(const Json& primitive, const std::string& key) const
  {
    std::vector<std::array<float, width>> result;
    if(const auto accessor = primitive.get_child("attributes").get_optional<std::size_t>(key)) {
      const auto all = numbers<float, width>(*accessor);
      for(const auto& v : numbers<std::uint32_t, 1>(primitive.get<std::size_t>("indices")))
        result.push_back(all.at(v[0]));
    }
    return result;
  }
};

// Sets of a primitive are counted from 0 without a gap.
inline void check_sets(const Json& primitive)
{
  std::size_t sets = 0;
  for(const auto& [key, accessor] : primitive.get_child("attributes"))
    sets += key.compare(0, 9, "TEXCOORD_") == 0;
  for(std::size_t i = 0; i < sets; ++i)
    BOOST_TEST(primitive.get_child("attributes").count("TEXCOORD_" + std::to_string(i)) == 1u);
}

// The triangles are in the unit square, and turned as they should be: v goes down.
inline void check_atlas(const Texture& uv)
{
  BOOST_TEST_REQUIRE(!uv.empty());
  for(std::size_t c = 0; c < uv.size(); c += 3) {
    const auto& [p, q, r] = std::tie(uv[c], uv[c + 1], uv[c + 2]);
    BOOST_TEST((p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1));
    BOOST_TEST((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) < 0);
  }
}

using Textured_points = std::multiset<std::pair<std::array<float, 3>, std::array<float, 2>>>;

inline Textured_points textured_points(const Glb& glb, const std::string& key)
{
  Textured_points result;
  for(const Json& primitive : glb.primitives()) {
    const auto points = glb.corners<3>(primitive, "POSITION");
    const Texture uv = glb.corners<2>(primitive, key);
    for(std::size_t c = 0; c < uv.size(); ++c)
      result.insert({points[c], uv[c]});
  }
  return result;
}

// A sheet whose coordinates are the places of its vertices from above
inline std::string textured_sheet()
{
  const Sheet sheet;
  std::string text = obj_input(sheet);
  std::string lines;
  for(const std::string& line : lines_of(text)) {
    if(line[0] == 'v') {
      std::istringstream words(line.substr(2));
      double x = 0, y = 0;
      words >> x >> y;
      lines += "vt " + std::to_string(x) + " " + std::to_string(y) + "\n";
    }
  }
  for(const std::string& line : lines_of(text)) {
    if(line[0] != 'f') {
      lines += line + "\n";
      continue;
    }
    std::istringstream words(line.substr(2));
    lines += "f";
    for(std::string v; words >> v;)
      lines += " " + v + "/" + v;
    lines += "\n";
  }
  return lines;
}

struct Outputs : Folder
{
  Glb flatten_glb(const std::string& input, const std::string& options)
  {
    run(quoted(input) + " --output " + quoted(file("flat.glb")) + " " + options);
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    return Glb(content(path / "flat.glb"));
  }
};

BOOST_FIXTURE_TEST_SUITE(of_the_program, Outputs)

// The first set stays bit by bit, and textures keep to it. What was the second one comes after the atlas.
BOOST_AUTO_TEST_CASE(from_gltf)
{
  generated::Gltf gltf = generated::ball_with_nodes("{\"mesh\":0}");
  const generated::Ball ball(8, 12);
  std::vector<float> other;
  for(const float x : ball.texture)
    other.push_back(7 + x);
  const std::string second = ",\"TEXCOORD_1\":" + std::to_string(gltf.add(other, "VEC2")) + "}";
  for(const bool has_two : {false, true}) {
    generated::Gltf given = gltf;
    for(std::size_t i = 0; has_two && (i = given.json.find("\"TEXCOORD_0\":", i)) != std::string::npos; ++i)
      given.json.replace(given.json.find('}', i), 1, second);
    const std::string input = write("ball.glb", given.binary());
    const Glb first = flatten_glb(input, ""), glb = flatten_glb(input, "--uv-set 1");
    for(const Json& primitive : glb.primitives()) {
      check_sets(primitive);
      check_atlas(glb.corners<2>(primitive, "TEXCOORD_1"));
      BOOST_TEST(primitive.get_child("attributes").count("TEXCOORD_2") == (has_two ? 1u : 0u));
    }
    BOOST_TEST((textured_points(glb, "TEXCOORD_1") == textured_points(first, "TEXCOORD_0")));
    BOOST_TEST((textured_points(glb, "TEXCOORD_0") == textured_points(first, "TEXCOORD_1")));
    BOOST_TEST((textured_points(glb, "TEXCOORD_2") == textured_points(first, "TEXCOORD_2")));
    const std::string place = "pbrMetallicRoughness.baseColorTexture.texCoord";
    BOOST_TEST(element(glb.json.get_child("materials"), 0).get(place, 0) == 0);
    BOOST_TEST(element(first.json.get_child("materials"), 0).get(place, 0) == 1);
  }
}

BOOST_AUTO_TEST_CASE(from_obj)
{
  const std::string input = write("sheet.obj", textured_sheet());
  const Glb first = flatten_glb(input, ""), glb = flatten_glb(input, "--uv-set 1");
  BOOST_TEST((textured_points(glb, "TEXCOORD_1") == textured_points(first, "TEXCOORD_0")));
  BOOST_TEST(textured_points(first, "TEXCOORD_1").empty());
  for(const Json& primitive : glb.primitives()) {
    check_sets(primitive);
    check_atlas(glb.corners<2>(primitive, "TEXCOORD_1"));
    const auto points = glb.corners<3>(primitive, "POSITION");
    const Texture uv = glb.corners<2>(primitive, "TEXCOORD_0");
    BOOST_TEST_REQUIRE(uv.size() == points.size());
    for(std::size_t c = 0; c < uv.size(); ++c) {
      BOOST_TEST(uv[c][0] == points[c][0], boost::test_tools::tolerance(1e-5f));
      BOOST_TEST(1 - uv[c][1] == points[c][1], boost::test_tools::tolerance(1e-5f));
    }
  }
}

// Sets have no gap where only some faces have coordinates.
BOOST_AUTO_TEST_CASE(some_faces_have_coordinates)
{
  const std::string some = textured_sheet() + "v 20 0 0\nv 21 0 0\nv 20 1 0\nusemtl other\nf 36 37 38\n";
  const Glb glb = flatten_glb(write("some.obj", some), "--uv-set 1");
  BOOST_TEST(glb.primitives().size() == 2u);
  for(const Json& primitive : glb.primitives()) {
    check_sets(primitive);
    check_atlas(glb.corners<2>(primitive, "TEXCOORD_1"));
  }
  const Texture zeros = glb.corners<2>(glb.primitives()[0], "TEXCOORD_0").size() == 3
                            ? glb.corners<2>(glb.primitives()[0], "TEXCOORD_0")
                            : glb.corners<2>(glb.primitives()[1], "TEXCOORD_0");
  BOOST_TEST((zeros == Texture(3, {0, 0})));
  // Left-out faces have only their own ones.
  for(const Json& primitive : flatten_glb(file("some.obj"), "--uv-set 1 --ignore other").primitives())
    check_sets(primitive);
  for(const Json& primitive : flatten_glb(file("some.obj"), "--uv-set 1 --only-material other").primitives())
    check_sets(primitive);
}

BOOST_AUTO_TEST_CASE(ply_has_two_lists)
{
  const std::string input = write("sheet.obj", textured_sheet());
  const auto bytes_of = [&](const std::string& options) {
    run(quoted(input) + " --output " + quoted(file("flat.ply")) + " " + options);
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    return content(path / "flat.ply");
  };
  const std::string one = bytes_of(""), two = bytes_of("--uv-set 1");
  const std::size_t faces = Sheet().faces().size(), end = two.find("end_header\n") + 11;
  BOOST_TEST(two.find("property list uchar float texcoord\nproperty list uchar float texcoord1\n") < end);
  // A face is 3 vertices, and once or twice 6 coordinates, each with a count, and a chart.
  const std::size_t list = 1 + 6 * sizeof(float), vertices = 1 + 3 * sizeof(std::int32_t),
                    chart = sizeof(std::int32_t);
  const std::size_t first = one.size() - faces * (vertices + list + chart),
                    second = two.size() - faces * (vertices + 2 * list + chart);
  BOOST_TEST(two.substr(end, second - end) == one.substr(one.find("end_header\n") + 11, second - end));
  for(std::size_t f = 0; f < faces; ++f) {
    const std::string a = one.substr(first + f * (vertices + list + chart), vertices + list + chart),
                      b = two.substr(second + f * (vertices + 2 * list + chart), vertices + 2 * list + chart);
    BOOST_TEST(a.substr(0, vertices) == b.substr(0, vertices));
    BOOST_TEST(a.substr(vertices) == b.substr(vertices + list));
    BOOST_TEST(a.substr(vertices, list) != b.substr(vertices, list));
  }
  run(quoted(file("flat.ply")) + " --seams-from uv --output " + quoted(file("again.ply"))); // the first ones
  BOOST_TEST(status == 0, standard_error);
}

BOOST_AUTO_TEST_CASE(what_has_no_two_sets)
{
  const std::string input = write("sheet.obj", textured_sheet()), plain = write("plain.off", off(Sheet())),
                    glb = quoted(file("flat.glb"));
  for(const auto& [options, word] :
      {std::pair<std::string, std::string>{"--output " + quoted(file("flat.obj")), "OBJ files have one set"},
       {"--output -", "OBJ files have one set"},
       {"--svg " + quoted(file("flat.svg")), "--uv-set 1 needs --output"},
       {"--output " + glb + " --simplify 20", "goes without --simplify"},
       {"--output " + glb + " --plain", "--uv-set goes with an atlas"}}) {
    BOOST_TEST_INFO_SCOPE(options);
    run(quoted(input) + " --uv-set 1 " + options);
    check_refusal({word});
  }
  run(quoted(plain) + " --uv-set 1 --output " + glb);
  check_refusal({quoted(plain), "it has none"});
  run(quoted(input) + " " + quoted(plain) + " --one-atlas --uv-set 1 --output " + quoted(file("flat%.glb")));
  check_refusal({quoted(plain), "it has none"});
  run(quoted(input) + " --uv-set 2 --output " + glb);
  check_refusal({"--uv-set is 2, and must be from 0 to 1"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
