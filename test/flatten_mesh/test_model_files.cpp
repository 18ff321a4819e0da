// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program `flatten_mesh` keeps of a file: read, repaired, divided into triangles, textured, written, and read
// again.

#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/model/color_spaces.h"
#include "flatten_mesh/model/divide_polygons.h"
#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/model/write_model.h"

#include "generated_models.h"
#include "read_faces.h"
#include "temporary_folder.h"

#ifdef ABF_WITH_ASSIMP
#include "assimp_reader.h"
#endif

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/internal/prepare/given_seams.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

BOOST_AUTO_TEST_SUITE(test_model_files)

namespace fs = std::filesystem;
using namespace flatten_mesh;

namespace {

struct Files : Temporary_folder
{
  Files() : Temporary_folder("test_model_files")
  {
    command.quiet = true;
    write("paint.mtl", "newmtl red paint\nKd 1 0.25 0\nnewmtl blue\r\nKd 0 0 1\r\nd 0.5\r\n");
  }

  Model read(const std::string& name, const std::string& text)
  {
    return read_model(write(name, text), Degenerate_faces::KEPT, notes);
  }

  std::string write_model(const std::string& name, const Model& model, const Model_texture& texture) const
  {
    Output_file output(file(name));
    flatten_mesh::write_model(output, file(name), model, texture);
    output.publish();
    return file(name);
  }

  // The texture coordinates that the model has already, for its polygons in the surface of which the program makes an
  // atlas
  Model_texture own_texture(const Model& model)
  {
    const Atlas_input input = atlas_input_of(model, true, notes);
    Model_texture texture = empty_texture(model, input.mesh, input.origins);
    for(const Model_triangle& triangle : texture.triangles) {
      for(Index c = model.first_corners[triangle.polygon]; c < model.first_corners[triangle.polygon + 1]; ++c)
        if(model.texture_point(c) != no_index)
          texture.uv[c] = model.texture[model.texture_point(c)];
    }
    return texture;
  }

  void check_told(const std::string& word) const
  {
    BOOST_TEST(std::any_of(notes.texts().begin(), notes.texts().end(),
                           [&word](const std::string& text) { return text.find(word) != std::string::npos; }),
               "no note says " << word);
  }

  Command_line command;
  Notes notes = notes_of(command);
};

std::vector<double> numbers(const Kernel::Point_3& point)
{
  return {point.x(), point.y(), point.z()};
}

std::vector<double> numbers(const Kernel::Vector_3& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

std::vector<double> numbers(const Kernel::Point_2& point)
{
  return {point.x(), point.y()};
}

// Everything that matters of an OBJ text that the program wrote, with values in place of numbers
struct Plain_obj
{
  struct Line
  {
    std::string statement;
    std::vector<Read_corner> corners;
  };

  std::vector<std::vector<double>> points, texture, normals;
  std::vector<Line> lines;

  std::size_t placeholders = 0; // among `texture`: those of faces without any, which are empty

  explicit Plain_obj(const std::string& text)
  {
    std::istringstream stream(text);
    bool is_for_none = false;
    for(std::string line; std::getline(stream, line);) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if(keyword == "v" || keyword == "vt" || keyword == "vn") {
        std::vector<double>& numbers = (keyword == "v"    ? points
                                        : keyword == "vt" ? texture
                                                          : normals)
                                           .emplace_back();
        for(double number; words >> number;)
          numbers.push_back(number);
        if(is_for_none)
          numbers.clear();
        is_for_none = false;
      } else if(line == "# of faces without texture coordinates:") {
        is_for_none = true;
        ++placeholders;
      } else if(keyword == "f") {
        lines.push_back({"", {}});
        for(std::string word; words >> word;)
          lines.back().corners.push_back(corner(word));
      } else if(keyword != "#") {
        lines.push_back({line, {}});
      }
    }
  }

  Read_corner corner(const std::string& word) const
  {
    std::array<std::string, 3> parts;
    std::istringstream stream(word);
    for(std::string& part : parts)
      std::getline(stream, part, '/');
    const auto value = [](const std::vector<std::vector<double>>& all, const std::string& number) {
      return number.empty() ? std::vector<double>() : all.at(std::stoul(number) - 1);
    };
    return {value(points, parts[0]), value(texture, parts[1]), value(normals, parts[2]), {}};
  }
};

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

} // namespace

BOOST_FIXTURE_TEST_SUITE(reading, Files)

BOOST_AUTO_TEST_CASE(obj_in_every_manner)
{
  for(unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const generated::Model given = generated::strip(seed, {seed % 2 == 0, seed % 3 != 0, seed % 4 != 3});
    const Model model = read("model.obj", generated::obj_text(given, seed));
    const auto polygons = given.polygons();
    BOOST_TEST_REQUIRE(model.number_of_polygons() == polygons.size());
    BOOST_TEST_REQUIRE(model.points.size() == given.points.size());
    for(std::size_t v = 0; v < given.points.size(); ++v) {
      BOOST_TEST(numbers(model.points[v]) ==
                     std::vector<double>(given.points[v].begin(), given.points[v].end()),
                 boost::test_tools::per_element());
    }
    BOOST_TEST_REQUIRE(model.colors.size() == given.colors.size());
    for(std::size_t v = 0; v < given.colors.size(); ++v)
      BOOST_TEST(std::equal(given.colors[v].begin(), given.colors[v].end(), model.colors[v].begin()));
    for(Index p = 0; p < model.number_of_polygons(); ++p) {
      BOOST_TEST_REQUIRE(model.size(p) == polygons[p].size());
      for(Index i = 0; i < model.size(p); ++i) {
        const Index c = model.first_corners[p] + i;
        const generated::Corner corner = {static_cast<int>(model.vertices[c]),
                                          static_cast<int>(model.texture_point(c)),
                                          static_cast<int>(model.normal(c))};
        BOOST_TEST((corner == polygons[p][i]));
      }
    }
    std::size_t statement = 0;
    Index p = 0;
    for(const generated::Line& line : given.lines) {
      if(line.statement.empty()) {
        ++p;
        continue;
      }
      BOOST_TEST_REQUIRE(statement < model.statements.size());
      BOOST_TEST(model.statements[statement].text == line.statement);
      BOOST_TEST(model.statements[statement].polygon == p);
      ++statement;
    }
    BOOST_TEST(statement == model.statements.size());
    BOOST_TEST(model.material_names == (std::vector<std::string>{"red paint", "blue"}),
               boost::test_tools::per_element());
    BOOST_TEST(model.material(0) == no_index);
    BOOST_TEST(model.material(9) == 0u);
    BOOST_TEST(model.material(23) == 1u);
    BOOST_TEST(notes.texts().empty());
  }
}

BOOST_AUTO_TEST_CASE(wrong_attributes_are_left_out_with_a_note)
{
  const Model model = read("wrong.obj", std::string(square) + "v 2 2 2 1 0 x\nvt 0 zero\nvt 0.5 0.5\nvn 1 2\n"
                                                              "f 1/2 2/1 3/7 4/x\nf 1//1 2 5//9\n");
  BOOST_TEST(notes.texts().size() == 2u);
  check_told("4 colours, texture coordinates or normals");
  check_told("line 5");
  check_told("4 times");
  BOOST_TEST(model.colors.empty());
  const std::vector<Index> expected = {1, no_index, no_index, no_index};
  for(Index c = 0; c < 7; ++c) {
    BOOST_TEST(model.texture_point(c) == (c < 4 ? expected[c] : no_index));
    BOOST_TEST(model.normal(c) == no_index);
  }
}

BOOST_AUTO_TEST_CASE(off_with_all_attributes)
{
  const std::string faces = "4 0 1\n2\n 3 # over three lines\n", end = "4 1 0\r";
  const Model model = read("all.off", "\r\n # first\r\n STCNOFF " + end +
                                          "0 0 0 0 0 1 255 0 51 0.25 0.5\n1 0 0 0 0 1 1 0.5 0 0.5 1 0.5\n"
                                          "1 1 0 0 0 1 7 7 1 1\n1 0 1 0 0 0 1 1 0 1\n" +
                                          faces);
  BOOST_TEST_REQUIRE(model.number_of_polygons() == 1u);
  BOOST_TEST(model.vertices == (std::vector<Index>{0, 1, 2, 3}), boost::test_tools::per_element());
  BOOST_TEST((model.colors.at(0) == Point_color{1, 0, 0.2, 1}));
  BOOST_TEST((model.colors.at(1) == Point_color{1, 0.5, 0, 0.5}));
  BOOST_TEST((model.texture.at(0) == Kernel::Point_2(0.25, 0.5)));
  BOOST_TEST((model.texture.at(1) == Kernel::Point_2(1, 0.5)));
  BOOST_TEST((model.texture.at(2) == Kernel::Point_2(1, 1)));
  BOOST_TEST(std::isnan(model.colors.at(2)[0])); // two numbers are no colour
  BOOST_TEST((model.normals.at(3) == Kernel::Vector_3(0, 0, 0)));
}

BOOST_AUTO_TEST_CASE(strips_are_triangles_that_are_oriented_alike)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                             "property float z\nelement tristrips 2\nproperty list int int vertex_indices\n"
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  const Model model = read("strips.ply", header + "7 0 1 2 3 -1 2 3\n5 2 2 3 4 0\n");
  BOOST_TEST(model.vertices == (std::vector<Index>{0, 1, 2, 2, 1, 3, 3, 2, 4, 3, 4, 0}),
             boost::test_tools::per_element());
  BOOST_TEST(model.number_of_polygons() == 4u);
  BOOST_CHECK_THROW(read("strips.ply", header + "3 0 1 -2\n3 0 1 2\n"), Input_error);
}

// Whatever the format, the surface is read if that is asked for, and otherwise the message names the vertex.
BOOST_AUTO_TEST_CASE(coordinates_that_are_no_numbers)
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 NAN 0\n"
                            "endloop\nendfacet\n";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"nan.obj", "v 0 0 0\nv 1 0 0\nv 0 NAN 0\nf 1 2 3\n"},
      {"nan.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 NAN 0\n3 0 1 2\n"},
      {"nan.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                  "float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n"
                  "0 NAN 0\n3 0 1 2\n"},
      {"nan.stl", "solid\n" + facet + "endsolid\n"},
      {"nan.ts", "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 NAN 0\nTRGL 1 2 3\nEND\n"}};
  for(const std::string word : {"nan", "-nan(ind)", "inf", "1.#QNAN", "-1.#IND", "1e999"}) {
    for(const auto& [name, text] : files) {
      BOOST_TEST_INFO_SCOPE(name << " with " << word);
      const std::string dirty = boost::replace_all_copy(text, "NAN", word);
      const Model model = read(name, dirty);
      BOOST_TEST_REQUIRE(model.points.size() == 3u);
      BOOST_TEST(!std::isfinite(model.points[2].y()));
      BOOST_CHECK_EXCEPTION(read_model(write(name, dirty), Degenerate_faces::REFUSED, notes), Input_error,
                            [](const Input_error& error) {
                              return std::string(error.what()).find("vertex 3") != std::string::npos;
                            });
    }
  }
}

// A file of CGAL's has comments right behind the colours of points.
BOOST_AUTO_TEST_CASE(comments_need_no_blank_before_them)
{
  for(const std::string comment : {" # red", "#red", "#red 7", "#1"}) {
    const Model off =
        read("comments.off", "COFF\n3 1 0\n0 0 0 0.5 0 1.0" + comment + "\n1 0 0 0 0.5 0\n0 1 0 0 0 0.5" +
                                 comment + "\n3 0 1 2" + comment + "\n");
    BOOST_TEST(off.number_of_polygons() == 1u);
    BOOST_TEST((off.colors[0] == Point_color{0.5, 0, 1, 1}));
    BOOST_TEST((off.colors[2] == Point_color{0, 0, 0.5, 1}));
    const Model obj = read("comments.obj", "v 0 0 0" + comment + "\nv 1 0 0\nv 0 1 2" + comment +
                                               "\nf 1 2 3" + comment + "\n");
    BOOST_TEST(obj.number_of_polygons() == 1u);
    BOOST_TEST((obj.points[2] == Kernel::Point_3(0, 1, 2)));
  }
}

BOOST_AUTO_TEST_CASE(lines_end_as_on_any_system)
{
  const std::string text = std::string(square) + "f 1 2 \\\n3\nf 1 3 4\n";
  for(const std::string end : {"\n", "\r\n", "\r"}) {
    const Model model = read("lines.obj", "\xEF\xBB\xBF" + boost::replace_all_copy(text, "\n", end));
    BOOST_TEST(model.number_of_polygons() == 2u);
    BOOST_TEST(model.points.size() == 4u);
    BOOST_TEST(notes.texts().empty());
  }
}

BOOST_AUTO_TEST_CASE(json_is_utf_8)
{
  const Json json = {{"gr\xFCn", "\xC3\xBC \xE2\x82\xAC \xC3\"\\\n\x7F \xF0\x9F"}};
  BOOST_TEST(internal::json_text(json) ==
             "{\"gr\xEF\xBF\xBDn\":\"\xC3\xBC \xE2\x82\xAC \xEF\xBF\xBD\\\"\\\\\\n\x7F \xEF\xBF\xBD\"}");
}

BOOST_AUTO_TEST_CASE(wrong_numbers_of_vertices_are_errors)
{
  const auto refused = [this](const std::string& lines, const std::string& word) {
    BOOST_CHECK_EXCEPTION(read("wrong.obj", square + lines), Input_error, [&word](const Input_error& error) {
      return std::string(error.what()).find(word) != std::string::npos;
    });
  };
  refused("f 1 2 5\n", "line 5: the face names vertex 5, which does not exist");
  refused("f 1 2 3\nl 1 9\n", "line 6: the line names vertex 9");
  refused("f 0 1 2\n", "vertex 0");
  refused("f\n", "line 5: the face has no vertices");
  refused("f 1 2 1e3\n", "'1e3'");
  refused("f 1 2 99999999999999999999\n", "'99999999999999999999'");
  refused("v 1 2 zero\nf 1 2 3\n", "line 5: the coordinate 'zero' of vertex 5");
  BOOST_CHECK_THROW(
      read_model(write("pair.obj", std::string(square) + "f 1 2\n"), Degenerate_faces::REFUSED, notes),
      Input_error);
}

BOOST_AUTO_TEST_CASE(lines_and_points_stay)
{
  const Model model = read("lines.obj", std::string(square) + "f 1 2 3\nl -4/1 -3/2\nf 1 3 4\np 2\n");
  BOOST_TEST(notes.texts().empty());
  BOOST_TEST_REQUIRE(model.statements.size() == 2u);
  BOOST_TEST(model.statements[0].text == "l 1 2");
  BOOST_TEST(model.statements[0].polygon == 1u);
  BOOST_TEST(model.statements[1].text == "p 2");
}

BOOST_AUTO_TEST_CASE(ply_with_attributes)
{
  const std::string points = "0 0 0  0 0 1  10 20 255 51  0.25 0.5\n1 0 0  0 1 0  0 0 0 255  0.75 0.5\n"
                             "0 1 0  1 0 0  1 2 3 255  0.5 1\n";
  for(const std::array<std::string, 2>& names :
      {std::array<std::string, 2>{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
    const Model model = read(
        "model.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                     "float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar "
                     "red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nproperty float " +
                         names[0] + "\nproperty float " + names[1] +
                         "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + points +
                         "3 2 0 1\n");
    BOOST_TEST(model.normal(0) == 2u);
    BOOST_TEST(numbers(model.normals[1]) == (std::vector<double>{0, 1, 0}), boost::test_tools::per_element());
    BOOST_TEST(model.colors[0] == (Point_color{10 / 255., 20 / 255., 1, 0.2}),
               boost::test_tools::per_element());
    BOOST_TEST(model.texture_point(1) == 0u);
    BOOST_TEST(numbers(model.texture[0]) == (std::vector<double>{0.25, 0.5}),
               boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(ply_with_texture_of_corners)
{
  const Model model = read(
      "model.ply", std::string("ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double "
                               "y\nproperty double z\nelement face 3\nproperty list uchar uint "
                               "vertex_index\nproperty list uchar float texcoord\nend_header\n") +
                       "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 0\n3 0 2 3 6 .5 .5 1 1 0 1\n3 0 1 3 2 7 7\n");
  for(const Index c : {0, 1, 2, 6, 7, 8})
    BOOST_TEST(model.texture_point(c) == no_index);
  BOOST_TEST(numbers(model.texture[model.texture_point(4)]) == (std::vector<double>{1, 1}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_outputs_lack_is_told)
{
  read("labels.ply",
       "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nelement vertex 3\nproperty float x\nproperty "
       "float "
       "y\nproperty float z\nproperty float label\nelement face 1\nproperty list uchar int "
       "vertex_indices\nproperty int texnumber\nproperty int chart\nelement edge 1\nproperty int "
       "vertex1\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2 4 5\n0\n");
  check_told("without these properties: label of 'vertex'; texnumber of 'face'; vertex1 of 'edge'");
  check_told("names of textures");
  read("painted.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 1\n");
  check_told("without the colours of 1 face");
  std::string stl(80, ' ');
  stl += std::string("\1\0\0\0", 4) + std::string(48, '\0') + "\x1f\x80";
  read("painted.stl", stl);
  check_told("of 1 triangle");
  BOOST_TEST(notes.texts().size() == 4u);
}

BOOST_AUTO_TEST_CASE(equal_texture_of_all_vertices_is_none)
{
  const std::string
      begin = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
              "z\nproperty float s\nproperty float t\nelement face 1\nproperty list uchar int "
              "vertex_indices\nproperty list uchar float texcoord\nend_header\n",
      end = "3 0 1 2 6 0 0 1 0 0 1\n";
  const Model zeros = read("zeros.ply", begin + "0 0 0 0 0\n1 0 0 0 0\n0 1 0 0 0\n" + end);
  check_told("those of the faces are taken");
  BOOST_TEST(!zeros.has_point_texture);
  BOOST_TEST(numbers(zeros.texture.at(zeros.texture_point(2))) == (std::vector<double>{0, 1}),
             boost::test_tools::per_element());
  const Model given = read("given.ply", begin + "0 0 0 0 0\n1 0 0 0 0\n0 1 0 0 0.5\n" + end);
  BOOST_TEST(given.has_point_texture);
}

BOOST_AUTO_TEST_CASE(off_with_attributes)
{
  const Model colored =
      read("colors.off", "COFF\n3 1 0\n0 0 0 255 0 51\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
  BOOST_TEST(colored.colors.at(0) == (Point_color{1, 0, 0.2, 1}), boost::test_tools::per_element());
  BOOST_TEST(colored.normals.empty());
  const Model shaded = read("normals.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 1 0\n0 1 0 1 0 0\n3 0 1 2\n");
  BOOST_TEST(shaded.normal(1) == 1u);
  BOOST_TEST(numbers(shaded.normals.at(1)) == (std::vector<double>{0, 1, 0}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(seams_and_materials_of_the_file)
{
  const Model model =
      read("seams.obj", std::string(square) +
                            "v 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 1 0\n"
                            "usemtl one\nf 1/1 2/2 3/3 4/4\nusemtl two\nf 2/5 5/1 6/2 3/3\n"
                            "f 5/3 7/1 8/1 6/2\n");
  const Atlas_input surface = atlas_input_of(model, true, notes);
  const std::vector<bool> seams = texture_seams(model, surface.mesh, surface.origins);
  std::set<std::pair<std::size_t, std::size_t>> found;
  for(const Edge e : surface.mesh.edges()) {
    if(seams[e.idx()]) {
      found.insert(
          std::minmax<std::size_t>(surface.mesh.vertex(e, 0).idx(), surface.mesh.vertex(e, 1).idx()));
    }
  }
  // between the first two polygons the coordinates are equal, but not their numbers
  BOOST_TEST((found == std::set<std::pair<std::size_t, std::size_t>>{{4, 5}}));
  std::multiset<Index> materials;
  for(const Index material : materials_of_faces(model, surface.mesh, surface.origins))
    materials.insert(material);
  BOOST_TEST((materials == std::multiset<Index>{0, 0, 1, 1, 1, 1}));
}

BOOST_AUTO_TEST_CASE(split_faces_are_joined)
{
  const auto inner_edges = [this](const std::string& text, const Welding& welding) {
    const Model model = read("split.obj", text);
    const Mesh mesh = atlas_input_of(model, true, notes, welding).mesh;
    BOOST_TEST(mesh.is_valid()); // some vertices have no faces
    return std::count_if(mesh.edges().begin(), mesh.edges().end(),
                         [&mesh](const Edge e) { return !mesh.is_border(e); });
  };
  const std::string points = std::string(square) + "v 1 0 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\n";
  const std::string sheet = points + "f 1 2 3\nf 1 3 4\nf 5 7 8\nf 5 8 6\n";
  const Welding all, none = {Welding::NONE, 0}, separate = {Welding::SEPARATE_FACES, 0};
  BOOST_TEST(inner_edges(sheet, all) == 3);
  BOOST_TEST(inner_edges(sheet, none) == 2);
  BOOST_TEST(inner_edges(sheet, separate) == 2); // because some share vertices
  BOOST_TEST(inner_edges(points + "f 1 2 3\nf 5 7 6\n", separate) == 1);
  // a sheet with two sides, and one in which a face is turned
  BOOST_TEST(inner_edges(std::string(square) + square + "f 1 2 3\nf 1 3 4\nf 7 6 5\nf 8 7 5\n", all) == 2);
  BOOST_TEST(inner_edges(points + "f 1 2 3\nf 1 3 4\nf 8 7 5\nf 6 8 5\n", all) == 3);
  // three faces with vertices of their own at an edge
  BOOST_TEST(inner_edges(points + "v 1 0 0\nv 1 1 0\nv 1 0 1\nf 1 2 3\nf 5 7 6\nf 9 10 11\n", all) == 0);
  check_told("at 1 edge, more than two faces with vertices of their own meet");
  const std::string apart = std::string(square) + "v 1.01 0 0\nv 1 1.01 0\nv 2 0 0\nf 1 2 3 4\nf 5 7 6\n";
  BOOST_TEST(inner_edges(apart, all) == 1);
  BOOST_TEST(inner_edges(apart, {Welding::ALL, 0.02}) == 2);
  BOOST_TEST(inner_edges(apart, {Welding::ALL, 0.005}) == 1);
  BOOST_TEST(inner_edges(apart, {Welding::ALL, 100}) == 1); // all faces would be points
  // near only by way of a third point
  const std::string chain =
      "v 0 0 0\nv 0 5 0\nv -5 0 0\nv 1.8 0 0\nv 0 5 0\nv 7 0 0\nv 0.9 0 0\nv 0.9 -5 0\nv 3 -5 0\n"
      "f 1 2 3\nf 4 6 5\nf 7 8 9\n";
  BOOST_TEST(inner_edges(chain, {Welding::ALL, 1}) == 0);
  BOOST_TEST(inner_edges(chain, {Welding::ALL, 1.9}) == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(writing, Files)

// Polygon by polygon, line by line
BOOST_AUTO_TEST_CASE(obj_has_all_that_was_there)
{
  for(unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const generated::Model given = generated::strip(seed, {seed % 2 == 0, seed % 3 != 0, seed % 4 != 3});
    const Model model = read("model.obj", generated::obj_text(given, seed));
    const Atlas_input surface = atlas_input_of(model, true, notes);
    write_model("flat.obj", model, own_texture(model));
    const Plain_obj obj(content("flat.obj"));
    BOOST_TEST_REQUIRE(obj.lines.size() == given.lines.size());
    for(std::size_t i = 0; i < obj.lines.size(); ++i) {
      BOOST_TEST(obj.lines[i].statement == given.lines[i].statement);
      const generated::Polygon& polygon = given.lines[i].polygon;
      BOOST_TEST_REQUIRE(obj.lines[i].corners.size() == polygon.size());
      for(std::size_t k = 0; k < polygon.size(); ++k) {
        const Read_corner& corner = obj.lines[i].corners[k];
        const auto& point = given.points[static_cast<std::size_t>(polygon[k].vertex)];
        std::vector<double> uv, normal, all(point.begin(), point.end());
        if(!given.colors.empty()) {
          const auto& color = given.colors[static_cast<std::size_t>(polygon[k].vertex)];
          all.insert(all.end(), color.begin(), color.end());
        }
        if(polygon[k].texture >= 0) {
          const auto& t = given.texture[static_cast<std::size_t>(polygon[k].texture)];
          uv.assign(t.begin(), t.end());
        }
        if(polygon[k].normal >= 0) {
          const auto& n = given.normals[static_cast<std::size_t>(polygon[k].normal)];
          normal.assign(n.begin(), n.end());
        }
        BOOST_TEST((corner.point == all && corner.uv == uv && corner.normal == normal));
      }
    }
    // each texture coordinate once, though corners share some
    BOOST_TEST(obj.texture.size() == given.texture.size() + obj.placeholders);
    BOOST_TEST(obj.points.size() == given.points.size());
  }
}

BOOST_AUTO_TEST_CASE(corners_share_texture_coordinates_within_a_chart_only)
{
  const Model model = read("two.obj", std::string(square) + "f 1 2 3\nf 1 3 4\n");
  const Atlas_input surface = atlas_input_of(model, true, notes);
  const auto uv = [&](const Halfedge h) {
    const Kernel::Point_3& point = surface.mesh.point(surface.mesh.target(h));
    return Kernel::Point_2(point.x(), point.y());
  };
  for(const Index charts : {1u, 2u}) {
    const auto chart = [charts](const Face f) { return static_cast<Index>(f.idx()) % charts; };
    write_model("flat.obj", model, model_texture(model, surface.mesh, surface.origins, uv, chart));
    BOOST_TEST(Plain_obj(content("flat.obj")).texture.size() == (charts == 1 ? 4u : 6u));
  }
  const auto first_only = [](const Face f) { return f.idx() == 0 ? Index(0) : no_index; };
  write_model("flat.obj", model, model_texture(model, surface.mesh, surface.origins, uv, first_only));
  const Plain_obj obj(content("flat.obj"));
  BOOST_TEST(obj.texture.size() == 3u + 1u);
  BOOST_TEST(obj.placeholders == 1u);
  BOOST_TEST(std::count_if(obj.lines.begin(), obj.lines.end(),
                           [](const Plain_obj::Line& line) { return line.corners[0].uv.empty(); }) == 1);
}

// What is left out or turned in the mesh is in the output all the same, and turned.
BOOST_AUTO_TEST_CASE(repaired_models_are_written_whole)
{
  const Model model =
      read("rubbish.obj", std::string(square) +
                              "v 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                              "f 1/1 2/2 3/3 4/1\nf 1 1 2\nf 2/1 3/2 6/3 5/1\nf 4 3\nf 4 3 2 1\n");
  const Atlas_input surface = atlas_input_of(model, true, notes);
  for(const std::string format : {"obj", "ply"}) {
    write_model("flat." + format, model, own_texture(model));
    const Model again = read_model(file("flat." + format), Degenerate_faces::KEPT, notes);
    BOOST_TEST(again.points.size() == 6u);
    BOOST_TEST_REQUIRE(again.number_of_polygons() == 5u);
    for(Index p = 0; p < 5; ++p) {
      std::vector<Index> expected(model.vertices.begin() + model.first_corners[p],
                                  model.vertices.begin() + model.first_corners[p + 1]);
      if(surface.origins.is_turned[p])
        std::reverse(expected.begin(), expected.end());
      const std::vector<Index> found(again.vertices.begin() + again.first_corners[p],
                                     again.vertices.begin() + again.first_corners[p + 1]);
      BOOST_TEST(found == expected, boost::test_tools::per_element());
      BOOST_TEST((again.texture_point(again.first_corners[p]) != no_index) == (p == 0 || p == 2));
    }
  }
  const auto& is_turned = surface.origins.is_turned;
  BOOST_TEST(std::count(is_turned.begin(), is_turned.end(), true) == 1);
}

// By CGAL, which reads what the program reads, and by the program
BOOST_AUTO_TEST_CASE(ply_is_read_back)
{
  for(unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const generated::Model given = generated::strip(seed, {seed % 2 == 0, false, true});
    const Model model = read("model.obj", generated::obj_text(given, seed));
    const Model_texture texture = own_texture(model);
    const std::string name = write_model("flat.ply", model, texture);
    std::ifstream stream(name, std::ios::binary);
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    std::vector<CGAL::IO::Color> colors, face_colors;
    const auto parameters = CGAL::parameters::vertex_color_output_iterator(std::back_inserter(colors))
                                .face_color_output_iterator(std::back_inserter(face_colors))
                                .verbose(false);
    BOOST_TEST_REQUIRE(CGAL::IO::read_PLY(stream, points, polygons, parameters));
    BOOST_TEST((points == model.points));
    BOOST_TEST_REQUIRE(polygons.size() == model.number_of_polygons());
    for(Index p = 0; p < model.number_of_polygons(); ++p) {
      BOOST_TEST(std::equal(polygons[p].begin(), polygons[p].end(),
                            model.vertices.begin() + model.first_corners[p],
                            model.vertices.begin() + model.first_corners[p + 1]));
    }
    BOOST_TEST_REQUIRE(colors.size() == model.colors.size());
    for(std::size_t v = 0; v < colors.size(); ++v) {
      BOOST_TEST(colors[v].red() == std::lround(255 * model.colors[v][0]));
      BOOST_TEST(colors[v].blue() == std::lround(255 * model.colors[v][2]));
    }
    const Model again = read_model(name, Degenerate_faces::REFUSED, notes);
    for(Index c = 0; c < model.number_of_corners(); ++c) {
      BOOST_TEST_REQUIRE((again.texture_point(c) != no_index) == texture.has_uv(c));
      if(texture.has_uv(c)) {
        const Kernel::Point_2& uv = again.texture[again.texture_point(c)];
        BOOST_TEST(uv.x() == static_cast<float>(texture.uv[c].x()));
        BOOST_TEST(uv.y() == static_cast<float>(texture.uv[c].y()));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(ply_keeps_attributes_of_points)
{
  const Model model = read(
      "model.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty float y\nproperty "
                   "float z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar "
                   "red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face "
                   "1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0.1 0 0 0 0 1 1 2 3 4\n1 0 0 0 1 0 5 6 7 8\n0 1 0 1 0 0 9 10 11 12\n9 9 9 0 1 0 0 0 0 0\n"
                   "3 0 1 2\n");
  const Model_texture texture = own_texture(model);
  write_model("flat.ply", model, texture);
  const Model again = read_model(file("flat.ply"), Degenerate_faces::REFUSED, notes);
  BOOST_TEST((again.points == model.points));
  BOOST_TEST((again.normals == model.normals));
  BOOST_TEST((again.colors == model.colors));
  BOOST_TEST(content("flat.ply").find("property double x") != std::string::npos);

  Model plain = read("plain.obj", std::string(square) + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
  write_model("flat.ply", plain, own_texture(plain));
  BOOST_TEST(content("flat.ply").find("property float x") != std::string::npos);
  BOOST_TEST(content("flat.ply").find("property float nx") != std::string::npos);
}

// More corners than a byte counts
BOOST_AUTO_TEST_CASE(ply_of_large_polygons)
{
  const int n = 300;
  std::string text, face = "f";
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * i / n;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    text += "vt " + std::to_string(i / 512.) + " 0.5\n";
    face += " " + std::to_string(i + 1) + "/" + std::to_string(i + 1);
  }
  const Model model = read("large.obj", text + face + "\n");
  write_model("flat.ply", model, own_texture(model));
  const Model again = read_model(file("flat.ply"), Degenerate_faces::REFUSED, notes);
  BOOST_TEST_REQUIRE(again.number_of_corners() == static_cast<std::size_t>(n));
  for(Index c = 0; c < static_cast<Index>(n); ++c)
    BOOST_TEST(again.texture[again.texture_point(c)].x() == static_cast<float>(model.texture[c].x()));
}

BOOST_AUTO_TEST_CASE(obj_is_read_back_by_CGAL)
{
  const Model model = read("model.obj", generated::obj_text(generated::strip(1, {false, true, true}), 1));
  write_model("flat.obj", model, own_texture(model));
  std::ifstream stream(file("flat.obj"));
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  BOOST_TEST_REQUIRE(CGAL::IO::read_OBJ(stream, points, polygons, CGAL::parameters::verbose(false)));
  BOOST_TEST(points.size() == model.points.size());
  BOOST_TEST_REQUIRE(polygons.size() == model.number_of_polygons());
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    BOOST_TEST(std::equal(polygons[p].begin(), polygons[p].end(),
                          model.vertices.begin() + model.first_corners[p],
                          model.vertices.begin() + model.first_corners[p + 1]));
  }
}

// The name of a material file leads to it from wherever the output is.
BOOST_AUTO_TEST_CASE(material_files_are_found_from_other_folders)
{
  fs::create_directories(path / "out" / "deep");
  fs::create_directories(path / "my paint");
  write("my paint/a b.mtl", "newmtl a\n");
  const std::string faces = std::string(square) + "f 1 2 3 4\n";
  const auto line_in = [&](const std::string& line, const std::string& name) {
    const Model model = read("model.obj", line + "\n" + faces);
    write_model(name, model, own_texture(model));
    return Plain_obj(content(name)).lines.at(0).statement;
  };
  BOOST_TEST(line_in("mtllib paint.mtl", "flat.obj") == "mtllib paint.mtl");
  BOOST_TEST(line_in("mtllib paint.mtl", "out/deep/flat.obj") == "mtllib ../../paint.mtl");
  BOOST_TEST(line_in("mtllib my paint/a b.mtl", "out/flat.obj") == "mtllib ../my paint/a b.mtl");
  BOOST_TEST(line_in("mtllib absent.mtl paint.mtl", "out/flat.obj") == "mtllib absent.mtl ../paint.mtl");
  BOOST_TEST(line_in("mtllib " + file("paint.mtl"), "out/flat.obj") == "mtllib " + file("paint.mtl"));
}

#ifdef ABF_WITH_ASSIMP

namespace {

Read_corner expected_corner(const Model& model, const Model_texture& texture, const Index c)
{
  Read_corner corner;
  corner.point = numbers(model.points[model.vertices[c]]);
  if(texture.has_uv(c))
    corner.uv = numbers(texture.uv[c]);
  if(model.normal(c) != no_index)
    corner.normal = numbers(model.normals[model.normal(c)]);
  if(!model.colors.empty()) {
    const Point_color& color = model.colors[model.vertices[c]];
    corner.color = {color[0], color[1], color[2]};
  }
  return corner;
}

std::string material_name(const Model& model, const Index polygon, const std::string& otherwise)
{
  return model.material(polygon) == no_index ? otherwise : model.material_names[model.material(polygon)];
}

std::vector<Read_face> expected_polygons(const Model& model, const Model_texture& texture)
{
  std::vector<Read_face> faces;
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    Read_face face;
    face.material = material_name(model, p, "DefaultMaterial");
    for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c)
      face.corners.push_back(expected_corner(model, texture, c));
    if(texture.is_turned[p])
      std::reverse(face.corners.begin(), face.corners.end());
    faces.push_back(face);
  }
  return faces;
}

} // namespace

// It makes up coordinates where only some polygons of a material have them.
BOOST_AUTO_TEST_CASE(obj_is_read_back_by_assimp)
{
  for(unsigned seed = 0; seed < 10; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const generated::Model given =
        generated::strip(seed, {seed % 2 == 0, seed % 3 != 0, seed % 4 != 3, true});
    const Model model = read("model.obj", generated::obj_text(given, seed));
    const Model_texture texture = own_texture(model);
    const auto found = faces_by_assimp(write_model("flat.obj", model, texture));
    BOOST_TEST(found.size() == model.number_of_polygons());
    BOOST_TEST(missing_faces(expected_polygons(model, texture), found, 1e-6) == 0u);
  }
}

// Of PLY files it knows one texture coordinate of a vertex only: no seams.
BOOST_AUTO_TEST_CASE(ply_is_read_back_by_assimp)
{
  const Model model =
      read("model.obj", std::string(square) + "v 2 0 0\nv 2 1 0\nvt .25 0\nvt 1 0\nvt 1 1\nvt 0 "
                                              "1\nvt 2 0\nvt 2 1.5\n"
                                              "f 1/1 2/2 3/3 4/4\nf 2/2 5/5 6/6 3/3\n");
  const Model_texture texture = own_texture(model);
  const auto found = faces_by_assimp(write_model("flat.ply", model, texture));
  BOOST_TEST(found.size() == 2u);
  Left_out left_out;
  left_out.material = true;
  BOOST_TEST(missing_faces(expected_polygons(model, texture), found, 1e-6, left_out) == 0u);
}

#ifdef ABF_WITH_GLTF

namespace {

std::vector<Read_face> expected_triangles(const Model& model, const Model_texture& texture)
{
  std::vector<Read_face> faces;
  for(const Model_triangle& triangle : texture.triangles) {
    Read_face face;
    face.material = material_name(model, triangle.polygon, "default");
    bool has_uv = true, has_normals = true;
    for(const Index c : triangle.corners) {
      face.corners.push_back(expected_corner(model, texture, c));
      has_uv = has_uv && texture.has_uv(c);
      has_normals = has_normals && model.normal(c) != no_index;
    }
    for(Read_corner& corner : face.corners) {
      if(!corner.color.empty()) {
        const Point_color linear = linear_of_srgb({corner.color[0], corner.color[1], corner.color[2], 1});
        corner.color = {linear[0], linear[1], linear[2]};
      }
      corner.uv.resize(has_uv ? 2 : 0);
      corner.normal.resize(has_normals ? 3 : 0);
      double length = 0;
      for(const double x : corner.normal)
        length += x * x;
      for(double& x : corner.normal)
        x /= std::sqrt(length);
    }
    faces.push_back(face);
  }
  return faces;
}

} // namespace

BOOST_AUTO_TEST_CASE(glb_is_read_back_by_assimp)
{
  for(unsigned seed = 0; seed < 10; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const generated::Model given = generated::strip(seed, {seed % 2 == 0, seed % 3 != 0, seed % 4 != 3});
    const Model model = read("model.obj", generated::obj_text(given, seed));
    const Atlas_input surface = atlas_input_of(model, true, notes);
    const Model_texture texture = own_texture(model);
    const auto found = faces_by_assimp(write_model("flat.glb", model, texture));
    BOOST_TEST(found.size() == surface.mesh.number_of_faces());
    BOOST_TEST(missing_faces(expected_triangles(model, texture), found, 1e-6) == 0u);
  }
}

// Those with a coordinate that is no number cannot be there.
BOOST_AUTO_TEST_CASE(glb_has_faces_that_are_left_out)
{
  Model model = read("model.obj", std::string(square) + "v 0 0 1\nv 0 1 1\nf 1 2 3\nf 1 3 4\nf 3 4 1\n"
                                                        "f 1 2 2\nf 1 5 6\n");
  model.points[5] = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 1);
  const Model_texture texture = own_texture(model);
  const auto found = faces_by_assimp(write_model("flat.glb", model, texture));
  BOOST_TEST(found.size() == 4u);
  BOOST_TEST(missing_faces(expected_triangles(model, texture), found, 1e-6) == 0u);
}

BOOST_AUTO_TEST_CASE(glb_has_colors_of_materials)
{
  const Model model = read("model.obj", generated::obj_text(generated::strip(0), 0));
  write_model("flat.glb", model, own_texture(model));
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file("flat.glb"), 0);
  BOOST_TEST_REQUIRE(scene != nullptr);
  std::map<std::string, std::array<float, 4>> colors;
  for(unsigned m = 0; m < scene->mNumMaterials; ++m) {
    aiColor4D color;
    BOOST_TEST(scene->mMaterials[m]->Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS);
    colors[scene->mMaterials[m]->GetName().C_Str()] = {color.r, color.g, color.b, color.a};
  }
  BOOST_TEST((colors.at("red paint") == std::array<float, 4>{1, 0.25f, 0, 1}));
  BOOST_TEST((colors.at("blue") == std::array<float, 4>{0, 0, 1, 0.5f}));
  BOOST_TEST(colors.count("default") == 1u);
}

BOOST_AUTO_TEST_CASE(material_files_that_are_devices_are_not_read)
{
  const Model model =
      read("model.obj", "mtllib /dev/zero\n" + std::string(square) + "usemtl red paint\nf 1 2 3 4\n");
  BOOST_TEST((material_colors(model) == std::vector<Point_color>{{1, 1, 1, 1}}));
}

// Names that are no UTF-8 are not what JSON allows.
BOOST_AUTO_TEST_CASE(glb_with_any_name_of_material)
{
  const Model model = read("model.obj", std::string(square) + "usemtl gr\xFCn \"x\"\nf 1 2 3 4\n");
  const auto found = faces_by_assimp(write_model("flat.glb", model, own_texture(model)));
  BOOST_TEST_REQUIRE(found.size() == 2u);
  BOOST_TEST(found[0].material == "grn \"x\"");
}

#endif
#endif

BOOST_AUTO_TEST_SUITE_END()

// The formats of the program itself
BOOST_FIXTURE_TEST_SUITE(program, Files)

namespace {

int flatten(const Files& files, const std::string& input, const std::string& output,
            const std::string& options = "")
{
  const char* const program = std::getenv("ABF_FLATTEN_MESH");
  BOOST_TEST_REQUIRE(program != nullptr);
  const auto quoted = [](const std::string& word) { return " '" + word + "'"; };
  const std::string command = quoted(program) + quoted(files.file(input)) + " " + options + " --output" +
                              quoted(files.file(output)) + " > /dev/null 2>" + quoted(files.file("stderr"));
  return WEXITSTATUS(std::system(command.c_str()));
}

// Two components and a turned polygon
std::string two_components(const unsigned seed)
{
  generated::Model model = generated::strip(seed);
  std::reverse(model.lines[4].polygon.begin(), model.lines[4].polygon.end());
  std::string text = generated::obj_text(model, seed);
  return text + "v 9 9 9\nv 10 9 9\nv 9 10 9\nf -3 -2 -1\n";
}

// Of each face, the points and texture coordinates of its corners
std::vector<Read_face> faces_of(const Model& model)
{
  std::vector<Read_face> faces;
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    Read_face face;
    for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
      Read_corner corner;
      corner.point = numbers(model.points[model.vertices[c]]);
      if(model.texture_point(c) != no_index)
        corner.uv = numbers(model.texture[model.texture_point(c)]);
      face.corners.push_back(corner);
    }
    faces.push_back(face);
  }
  return faces;
}

} // namespace

BOOST_AUTO_TEST_CASE(ply_has_the_texture_of_obj)
{
  for(const std::string options : {"", "--plain"}) {
    for(unsigned seed = 0; seed < 4; ++seed) {
      write("model.obj", two_components(seed));
      BOOST_TEST_REQUIRE(flatten(*this, "model.obj", "flat.obj", options) == 0);
      BOOST_TEST_REQUIRE(flatten(*this, "model.obj", "flat.ply", options) == 0);
      const auto obj = faces_of(read_model(file("flat.obj"), Degenerate_faces::REFUSED, notes)),
                 ply = faces_of(read_model(file("flat.ply"), Degenerate_faces::REFUSED, notes));
      BOOST_TEST_REQUIRE(obj.size() >= 25u); // more where polygons were divided
      BOOST_TEST_REQUIRE(ply.size() == obj.size());
      for(std::size_t p = 0; p < obj.size(); ++p) {
        BOOST_TEST(is_same_face(obj[p], ply[p], 1e-6, {}));
        BOOST_TEST(obj[p].corners[0].uv.empty() == (options == "--plain" && p + 1 == obj.size()));
      }
    }
  }
}

// An atlas leaves all that was in the file, and adds texture coordinates.
BOOST_AUTO_TEST_CASE(obj_of_an_atlas_has_all_that_was_there)
{
  const generated::Model given = generated::strip(3);
  write("model.obj", generated::obj_text(given, 3));
  BOOST_TEST_REQUIRE(flatten(*this, "model.obj", "flat.obj") == 0);
  const Plain_obj obj(content("flat.obj"));
  auto line = obj.lines.begin();
  for(const auto& given_line : given.lines) {
    BOOST_TEST_REQUIRE((line != obj.lines.end()));
    BOOST_TEST(line->statement == given_line.statement);
    const std::size_t size = given_line.polygon.size();
    const std::size_t pieces = line->corners.size() == size ? 1 : size - 2; // of one that fans would spoil
    for(std::size_t piece = 0; piece < pieces; ++piece, ++line) {
      BOOST_TEST_REQUIRE((line != obj.lines.end()));
      BOOST_TEST_REQUIRE(line->corners.size() == (pieces == 1 ? size : 3u));
      for(std::size_t k = 0; k < line->corners.size(); ++k) {
        const Read_corner& found = line->corners[k];
        const auto has_its_place = [&](const generated::Corner& corner) {
          const auto& point = given.points[static_cast<std::size_t>(corner.vertex)];
          return std::equal(point.begin(), point.end(), found.point.begin());
        };
        const auto& polygon = given_line.polygon;
        const auto corner = pieces == 1 ? polygon.begin() + static_cast<std::ptrdiff_t>(k)
                                        : std::find_if(polygon.begin(), polygon.end(), has_its_place);
        BOOST_TEST_REQUIRE((corner != polygon.end()));
        BOOST_TEST(has_its_place(*corner));
        BOOST_TEST(found.point.size() == 6u); // with a colour
        BOOST_TEST(found.uv.size() == 2u);
        BOOST_TEST(found.normal.empty() == (corner->normal < 0));
      }
    }
  }
  BOOST_TEST((line == obj.lines.end()));
}

#if defined(ABF_WITH_ASSIMP) && defined(ABF_WITH_GLTF)
BOOST_AUTO_TEST_CASE(glb_has_the_texture_of_obj)
{
  write("model.obj", two_components(1));
  BOOST_TEST_REQUIRE(flatten(*this, "model.obj", "flat.obj") == 0);
  BOOST_TEST_REQUIRE(flatten(*this, "model.obj", "flat.glb") == 0);
  const auto add_corners = [](const std::vector<Read_face>& faces, std::set<std::vector<float>>& all) {
    for(const Read_face& face : faces) {
      for(const Read_corner& corner : face.corners) {
        std::vector<float> numbers;
        for(const double x : corner.point)
          numbers.push_back(static_cast<float>(x));
        for(const double x : corner.uv) // without the last digits, of which 1 - v loses some
          numbers.push_back(std::round(static_cast<float>(x) * 1000));
        all.insert(numbers);
      }
    }
  };
  std::set<std::vector<float>> expected, found;
  add_corners(faces_of(read_model(file("flat.obj"), Degenerate_faces::REFUSED, notes)), expected);
  add_corners(faces_by_assimp(file("flat.glb")), found);
  BOOST_TEST((found == expected));
}
#endif

BOOST_AUTO_TEST_CASE(other_formats_are_refused)
{
  write("model.obj", two_components(1));
  BOOST_TEST(flatten(*this, "model.obj", "flat.gltf") == 2);
  BOOST_TEST((content("stderr").find("--output .obj|.ply|.glb") != std::string::npos), content("stderr"));
#ifndef ABF_WITH_GLTF
  BOOST_TEST(flatten(*this, "model.obj", "flat.glb") == 2);
  BOOST_TEST((content("stderr").find("libtinygltf-dev") != std::string::npos), content("stderr"));
#endif
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
