// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// glTF files that the program `flatten_mesh` reads, and what it keeps of them.

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/formats.h"
#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/texts.h"

#include "generated_gltf.h"
#include "generated_models.h"
#include "temporary_folder.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

BOOST_AUTO_TEST_SUITE(test_gltf)

namespace fs = std::filesystem;
using namespace flatten_mesh;
using generated::attributes;
using generated::Ball;
using generated::ball_with_nodes;
using generated::Gltf;
using generated::scene;

namespace {

struct Files : Temporary_folder
{
  Files() : Temporary_folder("test_gltf") { command.quiet = true; }

  Model read(const std::string& name, const std::string& text, const Gltf_options& options = Gltf_options())
  {
    return read_model(write(name, text), Degenerate_faces::KEPT, notes, "", options);
  }

  Model read_again(const std::string& name) { return read_model(file(name), Degenerate_faces::KEPT, notes); }

  void check_refused(const std::string& name, const std::string& text, const std::string& word)
  {
    BOOST_CHECK_EXCEPTION(read(name, text), Input_error, [&word](const Input_error& error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(word) != std::string::npos;
    });
  }

  bool is_told(const std::string& word) const
  {
    return std::any_of(notes.texts().begin(), notes.texts().end(),
                       [&word](const std::string& text) { return text.find(word) != std::string::npos; });
  }

  int flatten(const std::string& input, const std::string& output, const std::string& options = "") const
  {
    const char* const program = std::getenv("ABF_FLATTEN_MESH");
    BOOST_TEST_REQUIRE(program != nullptr);
    const auto quoted = [](const std::string& word) { return " '" + word + "'"; };
    const std::string line = quoted(program) + quoted(file(input)) + " " + options + " --output" +
                             quoted(file(output)) + " > /dev/null 2>" + quoted(file("stderr"));
    return WEXITSTATUS(std::system(line.c_str()));
  }

  Command_line command;
  Notes notes = notes_of(command);
};

using Triangle = std::set<std::vector<float>>;

// The triangles of a model by the places of their corners, whatever their order
std::multiset<Triangle> places_of_triangles(const Model& model)
{
  std::multiset<Triangle> triangles;
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    Triangle triangle;
    for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
      const Kernel::Point_3& point = model.points[model.vertices[c]];
      triangle.insert(
          {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())});
    }
    triangles.insert(triangle);
  }
  return triangles;
}

double volume(const Model& model)
{
  double sum = 0;
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    const Index c = model.first_corners[p];
    sum += CGAL::determinant(model.points[model.vertices[c]] - CGAL::ORIGIN,
                             model.points[model.vertices[c + 1]] - CGAL::ORIGIN,
                             model.points[model.vertices[c + 2]] - CGAL::ORIGIN) /
           6;
  }
  return sum;
}

// One primitive, and a node that shows it
Gltf one_primitive(Gltf gltf, const std::string& primitive)
{
  gltf.json +=
      ",\"meshes\":[{\"name\":\"one\",\"primitives\":[" + primitive + "]}],\"nodes\":[{\"mesh\":0}]" + scene;
  return gltf;
}

const std::vector<float> row_of_points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0};

} // namespace

BOOST_FIXTURE_TEST_SUITE(reading, Files)

BOOST_AUTO_TEST_CASE(files_of_the_input_are_not_overwritten)
{
  const Gltf gltf = ball_with_nodes("{\"mesh\":0}");
  write("data.svg", gltf.bytes);
  write("ball.gltf", gltf.text("data.svg"));
  BOOST_TEST(flatten("ball.gltf", "flat.obj", "--svg '" + file("data.svg") + "'") == 2);
  BOOST_TEST(content("data.svg") == gltf.bytes);
  BOOST_TEST(!fs::exists(file("flat.obj")));
  BOOST_TEST(content("stderr").find("data.svg' would overwrite a file that the input refers to") !=
             std::string::npos);
  BOOST_TEST(flatten("ball.gltf", "flat.obj", "--svg '" + file("other.svg") + "'") == 0);
}

BOOST_AUTO_TEST_CASE(the_same_in_all_kinds_of_files)
{
  const Gltf gltf = ball_with_nodes("{\"mesh\":0}");
  write("ball data.bin", gltf.bytes);
  const Ball ball(8, 12);
  for(const auto& [name, text] :
      std::map<std::string, std::string>{{"ball.glb", gltf.binary()},
                                         {"text.gltf", gltf.text()},
                                         {"binary.gltf", gltf.binary()},
                                         {"files.gltf", gltf.text("ball%20data.bin")}}) {
    BOOST_TEST_INFO_SCOPE(name);
    const Model model = read(name, text);
    BOOST_TEST(model.number_of_polygons() == ball.triangles.size() / 3);
    BOOST_TEST(model.points.size() == 7u * 12 + 2); // the seam is closed, and the poles are points
    BOOST_TEST(model.material_names == (std::vector<std::string>{"wood", "wood_1"}),
               boost::test_tools::per_element());
    BOOST_TEST((model.material_colors[0] == Point_color{1, 0.5, 0, 1}));
    BOOST_TEST(model.material(29) == 0u);
    BOOST_TEST(model.material(30) == 1u);
    BOOST_TEST(model.statements.size() == 3u);
    BOOST_TEST(volume(model) > 3.5);
    for(Index c = 0; c < model.number_of_corners(); ++c) {
      const std::uint32_t v = ball.triangles[c];
      BOOST_TEST_REQUIRE(model.texture_point(c) != no_index);
      BOOST_TEST(model.texture[model.texture_point(c)].x() == ball.texture[2 * v]);
      BOOST_TEST(model.texture[model.texture_point(c)].y() == 1 - double(ball.texture[2 * v + 1]));
      BOOST_TEST((model.normals[model.normal(c)] == model.points[model.vertices[c]] - CGAL::ORIGIN));
      BOOST_TEST(model.points[model.vertices[c]].x() == ball.points[3 * v]);
    }
    BOOST_TEST(notes.texts().empty());
  }
  const Model split = read("ball.glb", gltf.binary(), {false, false, true});
  BOOST_TEST(split.points.size() > 9u * 13 - 2); // of both primitives
}

BOOST_AUTO_TEST_CASE(strips_fans_and_no_indices)
{
  const auto vertices = [this](const std::string& more, const std::vector<std::uint8_t>& indices) {
    Gltf gltf;
    gltf.add(row_of_points, "VEC3");
    gltf.add(indices, "SCALAR");
    return read("strip.glb", one_primitive(gltf, "{\"attributes\":{\"POSITION\":0}" + more + "}").binary())
        .vertices;
  };
  const std::string indexed = ",\"indices\":1,\"mode\":";
  BOOST_TEST(vertices(indexed + "5", {0, 1, 2, 3, 4, 5}) ==
                 (std::vector<Index>{0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5}),
             boost::test_tools::per_element());
  BOOST_TEST(vertices(indexed + "5", {0, 1, 2, 2, 3, 4}) == (std::vector<Index>{0, 1, 2, 3, 2, 4}),
             boost::test_tools::per_element());
  BOOST_TEST(vertices(indexed + "6", {0, 1, 3, 2}) == (std::vector<Index>{0, 1, 3, 0, 3, 2}),
             boost::test_tools::per_element());
  BOOST_TEST(vertices(indexed + "5", {0, 1, 2, 255, 2, 3, 4, 5}) == // another strip begins behind 255
                 (std::vector<Index>{0, 1, 2, 2, 3, 4, 4, 3, 5}),
             boost::test_tools::per_element());
  BOOST_TEST(vertices(indexed + "6", {255, 0, 1, 3, 2, 255, 255, 4, 5, 2}) ==
                 (std::vector<Index>{0, 1, 3, 0, 3, 2, 4, 5, 2}),
             boost::test_tools::per_element());
  BOOST_TEST(vertices("", {}) == (std::vector<Index>{0, 1, 2, 3, 4, 5}), boost::test_tools::per_element());
  BOOST_TEST(vertices(",\"mode\":5", {}).size() == 12u);
  BOOST_TEST(!is_told("left out"));
  BOOST_TEST(vertices(",\"mode\":5},{\"attributes\":{\"POSITION\":0},\"mode\":0", {}).size() == 12u);
  BOOST_TEST(is_told("1 primitive of points or lines left out"));
  BOOST_CHECK_EXCEPTION(vertices(",\"indices\":1,\"mode\":1", {0, 1}), Input_error,
                        [](const Input_error& error) {
                          return std::string(error.what()).find("only points or lines") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(nodes_place_meshes)
{
  const std::string nodes = "{\"children\":[1],\"translation\":[1,2,3],\"scale\":[2,2,2]},"
                            "{\"children\":[2],\"rotation\":[0,0,0.7071067811865476,0.7071067811865476]},"
                            "{\"mesh\":0,\"matrix\":[1,0,0,0,0,SIGN,0,0,0,0,3,0,5,0,0,1]}";
  for(const std::string sign : {"1", "-1"}) {
    const Model model =
        read("placed.glb", ball_with_nodes(boost::replace_all_copy(nodes, "SIGN", sign)).binary());
    const Ball ball(8, 12);
    const double s = std::stod(sign);
    for(Index c = 0; c < 3; ++c) {
      const Index corner = s < 0 ? (3 - c) % 3 : c; // turned
      const float* const p = &ball.points[3 * ball.triangles[corner]];
      const Kernel::Point_3 expected(1 - 2 * s * p[1], 2 + 2 * (p[0] + 5.), 3 + 2 * 3. * p[2]);
      const Kernel::Point_3& found = model.points[model.vertices[c]];
      BOOST_TEST(CGAL::squared_distance(found, expected) < 1e-25);
      const Kernel::Vector_3 normal = model.normals[model.normal(c)], out(-s * p[1], p[0], p[2] / 3.);
      BOOST_TEST(CGAL::cross_product(normal, out).squared_length() <
                 1e-12 * normal.squared_length() * out.squared_length());
      BOOST_TEST(normal * out > 0);
    }
    BOOST_TEST(volume(model) > 24 * 3.5); // fronts stay outside
  }
}

BOOST_AUTO_TEST_CASE(hidden_by_the_scale_0)
{
  const Model shown = read("shown.glb", ball_with_nodes("{\"mesh\":0}").binary());
  const Model hidden = read("hidden.glb", ball_with_nodes("{\"mesh\":0,\"scale\":[0,0,0]}").binary());
  BOOST_TEST(is_told("1 node with a scale of 0"));
  BOOST_TEST((hidden.points == shown.points));
}

BOOST_AUTO_TEST_CASE(instances)
{
  const std::string nodes =
      "{\"mesh\":0,\"translation\":[3,0,0]},{\"mesh\":0},{\"mesh\":0,\"scale\":[1,-1,1]}";
  const std::string binary = ball_with_nodes(nodes, ",\"scenes\":[{\"nodes\":[0,1,2]}]").binary();
  const Model once = read("balls.glb", binary);
  BOOST_TEST(once.number_of_polygons() == 168u);
  BOOST_TEST(CGAL::bbox_3(once.points.begin(), once.points.end()).xmin() > 1.9);
  BOOST_TEST(is_told("2 nodes show meshes that another node shows as well"));
  const Model each = read("balls.glb", binary, {true, true, true});
  BOOST_TEST(each.number_of_polygons() == 3 * 168u);
  BOOST_TEST(each.points.size() == 3 * once.points.size()); // meshes at the same place stay apart
  BOOST_TEST(volume(each) > 3 * 3.5);
}

BOOST_AUTO_TEST_CASE(numbers_of_all_kinds)
{
  Gltf gltf;
  gltf.add(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 0, -32767, 0}, "VEC3", ",\"normalized\":true");
  gltf.add(std::vector<std::uint8_t>{255, 0, 51, 0, 255, 0, 0, 0, 0}, "VEC3", ",\"normalized\":true");
  gltf.add(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 13107}, "VEC2", ",\"normalized\":true");
  gltf.json += ",\"extensionsRequired\":[\"KHR_mesh_quantization\"]";
  const Model model =
      read("small.glb",
           one_primitive(gltf, "{\"attributes\":{\"POSITION\":0,\"COLOR_0\":1,\"TEXCOORD_0\":2}}").binary());
  BOOST_TEST((model.points[1] == Kernel::Point_3(1, 0, 0)));
  BOOST_TEST((model.points[2] == Kernel::Point_3(0, -1, 0)));
  BOOST_TEST(model.colors[0][0] == 1., boost::test_tools::tolerance(1e-12)); // sRGB
  BOOST_TEST(model.colors[0][1] == 0.);
  BOOST_TEST(model.colors[0][2] == 0.4845292, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(model.colors[0][3] == 1.);
  BOOST_TEST((model.texture[1] == Kernel::Point_2(1, 1)));
  BOOST_TEST((model.texture[2] == Kernel::Point_2(0, 0.8)));
}

BOOST_AUTO_TEST_CASE(strides_and_sparse_elements)
{
  Gltf gltf;
  const std::vector<float> mixed = {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9};
  std::string bytes(mixed.size() * 4, '\0');
  std::memcpy(&bytes[0], mixed.data(), bytes.size());
  gltf.add_view(bytes);
  gltf.views[0].insert(gltf.views[0].size() - 1, ",\"byteStride\":16");
  gltf.add(std::vector<std::uint8_t>{2}, "SCALAR");
  gltf.add(std::vector<float>{0, 7, 0}, "VEC3");
  gltf.accessors = {
      "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"sparse\":{\"count\":1,"
      "\"indices\":{\"bufferView\":1,\"componentType\":5121},\"values\":{\"bufferView\":2}}}"};
  const Model model = read("sparse.glb", one_primitive(gltf, "{\"attributes\":{\"POSITION\":0}}").binary());
  BOOST_TEST((model.points[1] == Kernel::Point_3(1, 0, 0)));
  BOOST_TEST((model.points[2] == Kernel::Point_3(0, 7, 0)));
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_named)
{
  Gltf good;
  good.add(row_of_points, "VEC3");
  good.add(std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3}, "SCALAR");
  const std::string primitive = "{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  BOOST_TEST(read("good.glb", one_primitive(good, primitive).binary()).number_of_polygons() == 2u);
  const auto refused = [&](const std::string& before, const std::string& after, const std::string& word) {
    Gltf gltf = one_primitive(good, primitive);
    std::size_t changes = 0;
    for(std::string* const text :
        {&gltf.json, &gltf.accessors[0], &gltf.accessors[1], &gltf.views[0], &gltf.views[1]}) {
      changes += text->find(before) != std::string::npos;
      boost::replace_first(*text, before, after);
    }
    BOOST_TEST_REQUIRE(changes > 0u);
    check_refused("bad.glb", gltf.binary(), word);
    check_refused("bad.gltf", gltf.text(), word);
  };
  const std::string what = "accessor 0 (POSITION of primitive 0 of mesh 'one')";
  refused("\"count\":6,\"type\":\"VEC3\"", "\"count\":7,\"type\":\"VEC3\"",
          what + " lies outside of buffer view 0");
  refused("\"count\":6,\"type\":\"VEC3\"", "\"count\":18446744073709551615,\"type\":\"VEC3\"", what);
  refused("\"count\":6,\"type\":\"VEC3\"",
          "\"byteOffset\":18446744073709551600,\"count\":6,\"type\":\"VEC3\"", what);
  refused("\"byteLength\":72", "\"byteLength\":9999",
          "buffer view 0 lies outside of buffer 0, which has 96 bytes");
  refused("\"byteOffset\":0", "\"byteOffset\":18446744073709551000",
          "buffer view 0 lies outside of buffer 0");
  refused("\"buffer\":0", "\"buffer\":3", "buffer view 0 names buffer 3, which does not exist");
  refused("\"bufferView\":0", "\"bufferView\":5", "names buffer view 5, which does not exist");
  refused("\"byteLength\":72", "\"byteLength\":72,\"byteStride\":8", what + " has elements of 12 bytes");
  refused("\"componentType\":5126", "\"componentType\":5127", "5127");
  refused("\"bufferView\":0,", "\"name\":\"x\",",
          "primitive 0 of mesh 'one' has positions without a buffer view");
  refused("\"POSITION\":0", "\"POSITION\":0,\"_OWN\":7",
          "_OWN of primitive 0 of mesh 'one' names accessor 7");
  refused("VEC3", "VEC2", what + " has 2 numbers at each vertex instead of 3");
  refused("5125", "5126", "accessor 1 (indices of primitive 0 of mesh 'one') does not contain indices");
  refused("\"POSITION\":0", "\"POSITION\":7", "accessor 7, which does not exist");
  refused("\"POSITION\":0", "\"NORMAL\":0", "has no attribute POSITION");
  refused("\"POSITION\":0", "\"POSITION\":0,\"NORMAL\":1", "accessor 1 (NORMAL");
  refused("\"indices\":1", "\"indices\":1,\"material\":2", "material 2, which does not exist");
  refused("\"indices\":1", "\"indices\":1,\"mode\":9", "unknown mode 9");
  refused("\"indices\":1", "\"indices\":1,\"extensions\":{\"KHR_draco_mesh_compression\":{}}",
          "KHR_draco_mesh_compression");
  refused("\"bufferView\":1,", "\"extensions\":{\"KHR_draco_mesh_compression\":{}},",
          "needs the glTF extension KHR_draco_mesh_compression, which is not read: decompress");
  refused("\"mesh\":0", "\"mesh\":1", "node 0 names mesh 1, which does not exist");
  refused("\"mesh\":0", "\"mesh\":0,\"children\":[0]", "nodes are their own ancestors");
  refused("\"mesh\":0", "\"mesh\":0,\"children\":[4]", "node 4, which does not exist");
  refused("\"mesh\":0", "\"mesh\":0,\"scale\":[1,2]", "the scale of node 0 has 2 numbers instead of 3");
  refused("\"version\":\"2.0\"", "\"version\":\"1.0\"", "version '1.0'");
  for(const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
    refused("\"asset\"", "\"extensionsUsed\":[\"" + name + "\"],\"asset\"", name);
  refused("\"asset\"", "\"extensionsRequired\":[\"ABC_new\"],\"asset\"", "ABC_new");
  refused("\"asset\"", "\"images\":[{\"bufferView\":8,\"mimeType\":\"image/png\"}],\"asset\"",
          "picture 0 names buffer view 8, which does not exist");
  for(const std::string number : {"-2", "4294967296", "0.5"}) {
    refused("\"asset\"", "\"skins\":[{\"inverseBindMatrices\":" + number + "}],\"asset\"",
            "skin 0 has a wrong 'inverseBindMatrices'");
  }
  refused("\"asset\"", "\"skins\":[7],\"asset\"", "'skins' is not a list of objects");
  refused("\"asset\"", "\"skins\":[{\"inverseBindMatrices\":\"no\"}],\"asset\"",
          "skin 0 has a wrong 'inverseBindMatrices'");
  refused("\"asset\"", "\"skins\":[{\"inverseBindMatrices\":9}],\"asset\"",
          "accessor 9, which does not exist");
  refused("\"asset\"", "\"extras\":1e999,\"asset\"", "its description has a number that is too large");
  refused("\"asset\"", "oops,\"asset\"", "its description is no JSON: byte 2 does not fit");
  refused("\"asset\"", "\"extras\":" + std::string(100000, '[') + std::string(100000, ']') + ",\"asset\"",
          "nested");
  Gltf wrong = good;
  wrong.bytes.replace(72 + 8, 4, Gltf::number(6));
  check_refused("wrong.glb", one_primitive(wrong, primitive).binary(),
                "accessor 1 (indices of primitive 0 of mesh 'one') names vertex 6 (counted from 0)");
  for(const std::string name : {"other.glb", "other.gltf"})
    check_refused(name, "v 0 0 0\n", "begin with 'glTF' if they are binary");
  check_refused("missing.gltf", one_primitive(good, primitive).text("missing.bin"), "missing.bin");
  check_refused("device.gltf", one_primitive(good, primitive).text("/dev/zero"), "/dev/zero");
}

// Whatever bytes change, a file is read or refused.
BOOST_AUTO_TEST_CASE(any_damage)
{
  const std::string whole = ball_with_nodes("{\"mesh\":0,\"children\":[1]},{\"mesh\":0}").binary();
  for(std::size_t length = 0; length < whole.size(); length += length < 100 ? 1 : 97)
    BOOST_CHECK_THROW(read("short.glb", whole.substr(0, length)), Input_error);
  std::mt19937 random(1);
  const std::size_t description = whole.find("BIN");
  std::size_t refused = 0;
  for(int i = 0; i < 600; ++i) {
    std::string damaged = whole;
    for(int k = 0; k < 1 + i % 3; ++k) {
      char& byte = damaged[random() % (i % 2 == 0 ? description : whole.size())];
      byte = static_cast<char>(byte >= '0' && byte <= '9' ? '0' + random() % 10 : random() % 256);
    }
    try {
      read("damaged.glb", damaged);
    } catch(const Input_error&) {
      ++refused;
    }
  }
  BOOST_TEST(refused > 100u);
  BOOST_TEST(refused < 500u);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(program, Files)

// Each atlas has the same triangles, and texture coordinates for all.
BOOST_AUTO_TEST_CASE(triangles_stay_from_file_to_file)
{
  for(const std::string options : {"", "--plain"}) {
    for(const unsigned seed : {1u, 2u}) {
      write("model.obj", generated::obj_text(generated::strip(seed), seed));
      BOOST_TEST_REQUIRE(flatten("model.obj", "first.glb") == 0);
      BOOST_TEST_REQUIRE(flatten("first.glb", "second.glb", options) == 0, content("stderr"));
      BOOST_TEST_REQUIRE(flatten("second.glb", "third.obj", options) == 0, content("stderr"));
      const Model first = read_again("first.glb"), second = read_again("second.glb"),
                  third = read_again("third.obj");
      BOOST_TEST(first.number_of_polygons() > 20u);
      BOOST_TEST((places_of_triangles(first) == places_of_triangles(second)));
      BOOST_TEST((places_of_triangles(first) == places_of_triangles(third)));
      BOOST_TEST(first.material_names == second.material_names, boost::test_tools::per_element());
      BOOST_TEST(first.points.size() == second.points.size());
      BOOST_TEST(second.corner_texture.size() == second.number_of_corners());
      BOOST_TEST(std::count(second.corner_texture.begin(), second.corner_texture.end(), no_index) == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(seams_of_the_file)
{
  write("ball.gltf", ball_with_nodes("{\"mesh\":0}").text());
  BOOST_TEST_REQUIRE(
      flatten("ball.gltf", "flat.obj", "--seams-from uv --seams-to '" + file("s.selection.txt") + "'") == 0,
      content("stderr"));
  const Model model = read_again("flat.obj");
  BOOST_TEST(model.points.size() == 86u);
  BOOST_TEST(model.texture.size() >= 86u + 7); // along the meridian
  BOOST_TEST(content("stderr").find("textures; '--output FILE.glb' keeps it") != std::string::npos,
             content("stderr"));
}

// Textures stay where they were, with the coordinates that they had.
BOOST_AUTO_TEST_CASE(scenes_stay)
{
  const std::string nodes =
      "{\"name\":\"left\",\"mesh\":0,\"translation\":[3,0,0]},{\"mesh\":0,\"scale\":[1,-1,1]}";
  Gltf gltf = ball_with_nodes(
      nodes, ",\"scenes\":[{\"nodes\":[0,1]}],\"extras\":{\"maker\":\"test\"},"
             "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":1,\"znear\":2}}]");
  write("balls.glb", gltf.binary());
  BOOST_TEST_REQUIRE(flatten("balls.glb", "flat.glb") == 0, content("stderr"));
  const std::string flat = content("flat.glb");
  for(const std::string part :
      {"\"name\":\"left\"", "\"translation\":[3,0,0]", "\"scale\":[1,-1,1]",
       "\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"texCoord\":1,"
       "\"offset\":[0.5,0]}},\"texCoord\":1}",
       "\"perspective\":{\"yfov\":1,\"znear\":2}", "\"maker\":\"test\"", "not looked at IEND\xAE",
       "\"TEXCOORD_1\":"})
    BOOST_TEST(flat.find(part) != std::string::npos, "no " << part);
  Model before = read_again("balls.glb"), after = read_again("flat.glb");
  BOOST_TEST((places_of_triangles(before) == places_of_triangles(after)));
  BOOST_TEST(volume(after) > 3.5);
  BOOST_TEST(std::count_if(notes.texts().begin(), notes.texts().end(), [](const std::string& text) {
               return text.find("1 node shows a mesh that another node shows") != std::string::npos;
             }) == 2);
  BOOST_TEST_REQUIRE(flatten("balls.glb", "each.glb", "--unique-instances") == 0, content("stderr"));
  after = read_again("each.glb");
  BOOST_TEST(after.number_of_polygons() == 2 * before.number_of_polygons());
  BOOST_TEST(volume(after) > 2 * 3.5);
}

// What is not ours passes through, whatever its numbers and names are, and whatever extensions leave out.
BOOST_AUTO_TEST_CASE(other_parts_stay_as_they_are)
{
  const std::string parts =
      R"(,"extras":{"large":9007199254740991,"none":null,"list":[-1700000000000,1e-300]},)"
      R"("cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.01},"extras":null}],)"
      R"("samplers":[{"magFilter":9729,"name":"smooth"}],)"
      R"("textures":[{"sampler":0,"name":"without source"}],)"
      R"("images":[{"uri":"not%20there.png","name":"lost"}],)"
      R"("skins":[{"joints":[1],"name":"no matrices"}],)"
      R"("animations":[{"name":"none","channels":[],"samplers":[]}],)"
      R"("extensionsUsed":["KHR_animation_pointer"])";
  Gltf gltf;
  const Ball ball(8, 12);
  const std::string all = attributes(gltf, ball),
                    triangles = std::to_string(gltf.add(ball.triangles, "SCALAR"));
  gltf.json += ",\"meshes\":[{\"primitives\":[{\"attributes\":" + all + ",\"indices\":" + triangles +
               "}]}],\"nodes\":[{\"mesh\":0,\"skin\":0},{\"extras\":[null,false]}]" + scene + parts;
  write("parts.glb", gltf.binary());
  BOOST_TEST_REQUIRE(flatten("parts.glb", "flat.glb") == 0, content("stderr"));
  const std::string flat = content("flat.glb");
  BOOST_TEST(content("stderr").find("picture 0 ('not%20there.png') cannot be read: there is no such file") !=
                 std::string::npos,
             content("stderr"));
  BOOST_TEST(flat.find(parts) != std::string::npos, flat.substr(20, 3000));
  BOOST_TEST(flat.find(R"({"extras":[null,false]})") != std::string::npos);
}

// `float` tells the points of a terrain apart only near the origin.
BOOST_AUTO_TEST_CASE(terrains_in_geographic_coordinates)
{
  write("terrain.obj", "v 573430.1 4119946.2 1500\nv 573430.6 4119946.2 1500.1\nv 573430.1 4119946.7 1500.2\n"
                       "v 573430.6 4119946.7 1500\nf 1 2 3\nf 2 4 3\n");
  BOOST_TEST_REQUIRE(flatten("terrain.obj", "flat.glb") == 0, content("stderr"));
  BOOST_TEST(content("stderr").find("a hundred times as far from the origin") != std::string::npos,
             content("stderr"));
  const Model before = read_again("terrain.obj"), after = read_again("flat.glb");
  BOOST_TEST_REQUIRE(after.points.size() == 4u);
  for(const Kernel::Point_3& p : before.points) {
    BOOST_TEST(std::count_if(after.points.begin(), after.points.end(), [&p](const Kernel::Point_3& q) {
                 return CGAL::squared_distance(p, q) < 1e-14;
               }) == 1);
  }
}

// The second half of a sheet shows the texture of the first one, mirrored.
BOOST_AUTO_TEST_CASE(mirrored_charts_are_repacked)
{
  write("halves.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                      "f 1/1 2/2 3/3 4/4\nf 2/2 5/1 6/4 3/3\n");
  BOOST_TEST_REQUIRE(flatten("halves.obj", "flat.obj", "--repack") == 0, content("stderr"));
  BOOST_TEST(content("stderr").find("mirrored along 1 edge, which is a seam now") != std::string::npos);
  BOOST_TEST(content("stderr").find("1 given chart turned over") != std::string::npos);
  BOOST_TEST_REQUIRE(flatten("flat.obj", "again.obj", "--repack") == 0, content("stderr"));
  BOOST_TEST(content("stderr").empty(), content("stderr"));
}

// The first of two materials moves its texture by one half.
BOOST_AUTO_TEST_CASE(transforms_of_textures)
{
  Gltf_options options;
  options.transforms_texture = true;
  const std::string text = ball_with_nodes("{\"mesh\":0}").binary();
  const Model given = read("ball.glb", text), moved = read("ball.glb", text, options);
  BOOST_TEST_REQUIRE(moved.number_of_corners() == given.number_of_corners());
  for(Index c = 0; c < given.number_of_corners(); ++c) {
    const double move = given.material(given.polygon_of_corner(c)) == 0 ? 0.5 : 0;
    const Kernel::Vector_2 difference =
        moved.texture[moved.texture_point(c)] - given.texture[given.texture_point(c)];
    BOOST_TEST(std::abs(difference.x() - move) < 1e-12);
    BOOST_TEST(difference.y() == 0);
  }
}

// With one input, a percent sign behind a digit is part of the name.
BOOST_AUTO_TEST_CASE(percent_signs_in_the_name_of_an_output)
{
  write("ball.glb", ball_with_nodes("{\"mesh\":0}").binary());
  BOOST_TEST_REQUIRE(flatten("ball.glb", "50% off.glb") == 0, content("stderr"));
  BOOST_TEST(fs::exists(file("50% off.glb")));
  BOOST_TEST_REQUIRE(flatten("ball.glb", "flat %.glb") == 0, content("stderr"));
  BOOST_TEST(fs::exists(file("flat ball.glb")));
}

// A skin shows the mesh in the size of the joints: here, a hundredth.
BOOST_AUTO_TEST_CASE(skinned_meshes_have_the_size_of_their_joints)
{
  const std::string skins = ",\"skins\":[{\"joints\":[1]}]";
  const Model large = read("one.glb", ball_with_nodes("{\"mesh\":0},{}", skins + scene).binary()),
              small =
                  read("small.glb",
                       ball_with_nodes("{\"mesh\":0,\"skin\":0},{\"scale\":[0.01,0.01,0.01]}", skins + scene)
                           .binary());
  BOOST_TEST(volume(small) == 1e-6 * volume(large), boost::test_tools::tolerance(1e-6));
}

// A name with a percent sign is the one of the file, or stands for it.
BOOST_AUTO_TEST_CASE(names_with_percent_signs)
{
  const Gltf gltf = ball_with_nodes("{\"mesh\":0}");
  for(const std::string name : {"ball 10%.bin", "ball%2010.bin"}) {
    write(name, gltf.bytes);
    BOOST_TEST(read("ball.gltf", gltf.text(name)).number_of_polygons() > 0u);
  }
  write("ball 10.bin", gltf.bytes);
  BOOST_TEST(read("ball.gltf", gltf.text("ball%2010.bin")).number_of_polygons() > 0u);
  check_refused("bad.gltf", gltf.text("a\\u0007%0b.bin"), R"(there is no file 'a\x07%0b.bin')");
}

// What belongs to vertices follows them, bit by bit.
BOOST_AUTO_TEST_CASE(skins_and_morph_targets_stay)
{
  const Ball ball(6, 8);
  Gltf gltf;
  const std::string all = attributes(gltf, ball);
  std::vector<std::uint8_t> joints;
  std::vector<float> weights, moves;
  for(std::size_t v = 0; v < ball.points.size() / 3; ++v) {
    joints.insert(joints.end(), {static_cast<std::uint8_t>(v % 2), 1, 0, 0});
    weights.insert(weights.end(), {0.5f, 0.5f, 0, 0});
    moves.insert(moves.end(), {ball.points[3 * v], 1, 0});
  }
  const auto number = [](const std::size_t accessor) { return std::to_string(accessor); };
  std::string attributes = all.substr(0, all.size() - 1) +
                           ",\"JOINTS_0\":" + number(gltf.add(joints, "VEC4")) +
                           ",\"WEIGHTS_0\":" + number(gltf.add(weights, "VEC4")) + "}";
  std::vector<float> identity(32, 0.f);
  for(const std::size_t i : {0, 5, 10, 15})
    identity[i] = identity[i + 16] = 1;
  gltf.json +=
      ",\"meshes\":[{\"primitives\":[{\"attributes\":" + attributes +
      ",\"indices\":" + number(gltf.add(ball.triangles, "SCALAR")) +
      ",\"targets\":[{\"POSITION\":" + number(gltf.add(moves, "VEC3")) + "}]}],\"weights\":[0.25]}]," +
      "\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":" + number(gltf.add(identity, "MAT4")) + "}]," +
      "\"nodes\":[{\"mesh\":0,\"skin\":0,\"translation\":[9,9,9]},{},{}],\"animations\":[{\"channels\":[{"
      "\"sampler\":0,\"target\":{\"node\":1,\"path\":\"translation\"}}],\"samplers\":[{\"input\":" +
      number(gltf.add(std::vector<float>{0, 1}, "SCALAR", ",\"min\":[0],\"max\":[1]")) +
      ",\"output\":" + number(gltf.add(std::vector<float>{0, 0, 0, 1, 2, 3}, "VEC3")) + "}]}]" + scene;
  write("moving.glb", gltf.binary());
  BOOST_TEST_REQUIRE(flatten("moving.glb", "flat.glb") == 0, content("stderr"));
  BOOST_TEST(content("stderr").empty(), content("stderr"));
  const std::string flat = content("flat.glb");
  for(const std::string part :
      {"\"JOINTS_0\":", "\"WEIGHTS_0\":", "\"targets\":[{\"POSITION\":", "\"weights\":[0.25]",
       "\"inverseBindMatrices\":", "\"animations\":[{\"channels\":"})
    BOOST_TEST(flat.find(part) != std::string::npos, "no " << part);
  const Model model = read_again("flat.glb");
  BOOST_TEST(CGAL::bbox_3(model.points.begin(), model.points.end()).xmax() <
             2); // joints place it, not its node
  BOOST_TEST_REQUIRE(flatten("moving.glb", "flat.ply") == 0, content("stderr"));
  BOOST_TEST(content("stderr").find("skins, morph targets, animations") != std::string::npos,
             content("stderr"));
}

BOOST_AUTO_TEST_CASE(nothing_is_written_for_what_is_wrong)
{
  const std::string binary = ball_with_nodes("{\"mesh\":0}").binary();
  write("short.glb", binary.substr(0, binary.size() - 8));
  for(const std::string output : {"flat.obj", "flat.glb"}) {
    BOOST_TEST(flatten("short.glb", output) == 2);
    BOOST_TEST(content("stderr").find("it was cut short") != std::string::npos, content("stderr"));
    BOOST_TEST(!fs::exists(file(output)));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
