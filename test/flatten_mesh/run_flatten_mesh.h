// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_FLATTEN_MESH_H
#define RUN_FLATTEN_MESH_H

// What tests of the program `flatten_mesh` have in common: runs of it, and surfaces to run it on.

#include <boost/test/unit_test.hpp>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#ifdef ABF_WITH_PNG
#include <png.h>
#endif

#include "temporary_folder.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

// A path that the build defines as a macro, and the environment may override.
inline std::string place(const char* variable, const char* built)
{
  const char* value = std::getenv(variable);
  return value != nullptr ? value : built;
}

inline std::string program()
{
  return place("ABF_FLATTEN_MESH", ABF_FLATTEN_MESH);
}

inline std::string dinosaur()
{
  return place("ABF_EXAMPLES_DIR", ABF_EXAMPLES_DIR) + "/dinosaur.off";
}

inline std::string content(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

inline Lines lines_of(const std::string& text)
{
  Lines lines;
  std::istringstream stream(text);
  for(std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

// What is between the bars of a text
inline Lines parts_of(const std::string& text)
{
  Lines parts;
  std::istringstream stream(text);
  for(std::string part; std::getline(stream, part, '|');)
    parts.push_back(part);
  return parts;
}

// The lines that begin with a word, without it.
inline Lines lines_with(const std::string& text, const std::string& word)
{
  Lines result;
  for(const std::string& line : lines_of(text))
    if(line.compare(0, word.size() + 1, word + " ") == 0)
      result.push_back(line.substr(word.size() + 1));
  return result;
}

inline std::string quoted(const std::string& word)
{
  return "'" + word + "'";
}

// A separate folder for each test, and the results of the program's last run.
struct Folder : Temporary_folder
{
  Folder() : Temporary_folder("test_flatten_mesh") {}

  void run(const std::string& arguments, const std::string& standard_output_file = "")
  {
    const std::string command = quoted(program()) + " " + common_options + arguments + " > " +
                                quoted(standard_output_file.empty() ? file("stdout") : standard_output_file) +
                                " 2> " + quoted(file("stderr"));
    const int result = std::system(command.c_str());
    status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
    standard_output = content(path / "stdout");
    standard_error = content(path / "stderr");
    asks_for_json = false;
  }

  // Runs the program on a file, with all outputs.
  void flatten(const std::string& input, const std::string& options = "")
  {
    run(quoted(input) + " --output " + quoted(file("flat.obj")) + " --svg " + quoted(file("flat.svg")) +
        " --json " + quoted(file("flat.json")) + " " + options);
    asks_for_json = true;
  }

  boost::property_tree::ptree json() const
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(file("flat.json"), tree);
    return tree;
  }

  std::string obj() const { return content(path / "flat.obj"); }

  // Status 2, one line that contains all the words, and of the three files, only the report.
  void check_refusal(const Lines& words)
  {
    BOOST_TEST(status == 2);
    BOOST_TEST(lines_of(standard_error).size() == 1u, standard_error);
    BOOST_TEST(standard_output == "");
    for(const std::string& word : words)
      BOOST_TEST((standard_error.find(word) != std::string::npos), standard_error << " lacks " << word);
    if(asks_for_json) {
      BOOST_TEST(json().get<std::string>("status") != "OK");
      BOOST_TEST((standard_error.find(json().get<std::string>("message")) != std::string::npos));
      fs::remove(file("flat.json"));
    }
    check_nothing_is_left();
  }

  void check_nothing_is_left() const
  {
    for(const fs::directory_entry& entry : fs::directory_iterator(path)) {
      BOOST_TEST(entry.path().stem() != "flat", entry.path() << " is left");
      BOOST_TEST(entry.path().extension() != ".unfinished", entry.path() << " is left");
    }
  }

  void check_told(const std::string& word) const
  {
    BOOST_TEST((standard_error.find(word) != std::string::npos), standard_error << " lacks " << word);
  }

  void check_printed(const std::string& word, const bool is_printed = true) const
  {
    BOOST_TEST((standard_output.find(word) != std::string::npos) == is_printed,
               standard_output << (is_printed ? " lacks " : " has ") << word);
  }

  // Whether the map does so and was not split
  bool overlaps() const
  {
    return json().get<std::string>("border") == "not simple" && json().get<std::string>("split") == "null";
  }

  // Whether it was told that the map stretches lengths more than a good chart of an atlas does
  bool is_stretched() const
  {
    return standard_error.find("--stretch-bound 1.5 cuts the surface where that helps") != std::string::npos;
  }

  // Nothing is told but stretch, an overlap, polygons that were mended or divided, and what other programs make of faces.
  void check_success()
  {
    BOOST_TEST(status == 0);
    std::vector<std::string> lines = lines_of(standard_error);
    BOOST_TEST((!is_stretched() || json().get<double>("l2_stretch") > 2));
    const auto is_of_polygons = [](const std::string& line) {
      const auto says = [&line](const char* words) { return line.find(words) != std::string::npos; };
      return says("other programs would draw triangles that overlap") ||
             says("no texture coordinates: other") || says("--triangles divides");
    };
    lines.erase(std::remove_if(lines.begin(), lines.end(), is_of_polygons), lines.end());
    BOOST_TEST(lines.size() == static_cast<std::size_t>(is_stretched()) + overlaps(), standard_error);
    if(overlaps())
      check_told("the map overlaps itself: --injective");
    BOOST_TEST(json().get<std::string>("status") == "OK");
    BOOST_TEST(json().get<int>("flipped_triangles") == 0);
  }

  std::size_t unfinished_files() const
  {
    const fs::directory_iterator entries(path);
    return static_cast<std::size_t>(
        std::count_if(begin(entries), end(entries), [](const fs::directory_entry& entry) {
          return entry.path().extension() == ".unfinished";
        }));
  }

  // The program waits for a reader of a pipe. Its first file then exists under a temporary name.
  pid_t waiting_process(const std::string& input) const
  {
    BOOST_REQUIRE(::mkfifo(file("pipe").c_str(), 0600) == 0);
    const std::size_t before = unfinished_files();
    int steady = 0; // for how long
    const pid_t process = ::fork();
    if(process == 0) {
      ::execl(program().c_str(), "flatten_mesh", input.c_str(), "--output", file("flat.obj").c_str(), "--svg",
              file("pipe").c_str(), common_options.empty() ? nullptr : "--plain",
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    for(int i = 0; i < 3000 && steady < 20; ++i) { // before it reads, it only tries the names
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      steady = unfinished_files() > before ? steady + 1 : 0;
    }
    BOOST_TEST(unfinished_files() == before + 1);
    return process;
  }

  // Nothing is left of a process that is interrupted.
  void check_interrupted(const std::string& input) const
  {
    const pid_t process = waiting_process(input);
    ::kill(process, SIGTERM);
    int result = 0;
    ::waitpid(process, &result, 0);
    BOOST_TEST(WIFSIGNALED(result));
    BOOST_TEST(WTERMSIG(result) == SIGTERM);
    check_nothing_is_left();
  }

  std::string common_options; // with a blank behind
  int status = -1;
  bool asks_for_json = false;
  std::string standard_output;
  std::string standard_error;
};

// A bent sheet of `columns` by `rows` quadrangles as OFF text, without the quadrangles of `holes`.
struct Sheet
{
  int columns = 6;
  int rows = 4;
  bool triangulated = true;
  std::vector<int> holes;
  double shift = 0;

  int vertices() const { return (columns + 1) * (rows + 1); }

  std::string points() const
  {
    std::ostringstream text;
    for(int j = 0; j <= rows; ++j)
      for(int i = 0; i <= columns; ++i)
        text << shift + i + 0.1 * (j % 2) << ' ' << j << ' ' << 0.05 * i * i + 0.03 * i * j << '\n';
    return text.str();
  }

  std::vector<std::vector<int>> faces(const int first = 0) const
  {
    std::vector<std::vector<int>> result;
    for(int q = 0; q < columns * rows; ++q) {
      if(std::find(holes.begin(), holes.end(), q) == holes.end()) {
        const int a = first + q / columns * (columns + 1) + q % columns, b = a + 1, d = a + columns + 1,
                  c = d + 1;
        if(triangulated) {
          result.push_back({a, b, c});
          result.push_back({a, c, d});
        } else {
          result.push_back({a, b, c, d});
        }
      }
    }
    return result;
  }
};

inline std::string face_lines(const std::vector<std::vector<int>>& faces)
{
  std::ostringstream text;
  for(const std::vector<int>& face : faces) {
    text << face.size();
    for(const int v : face)
      text << ' ' << v;
    text << '\n';
  }
  return text.str();
}

inline std::string off(const int vertices, const std::string& points,
                       const std::vector<std::vector<int>>& faces)
{
  return "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces.size()) + " 0\n" + points +
         face_lines(faces);
}

inline std::string off(const Sheet& sheet)
{
  return off(sheet.vertices(), sheet.points(), sheet.faces());
}

// Hills with noise in units of the edges, of 203,522 triangles: enough for `--method auto` to be hierarchical.
inline std::string terrain(const double noise)
{
  Sheet grid;
  grid.columns = 319;
  grid.rows = 319;
  std::mt19937 random(1);
  std::ostringstream points;
  for(int j = 0; j <= grid.rows; ++j) {
    for(int i = 0; i <= grid.columns; ++i) {
      const double chance = static_cast<double>(random()) / 2147483648. - 1;
      points << i << ' ' << j << ' ' << 8 * std::sin(0.07 * i) * std::cos(0.05 * j) + noise * chance << '\n';
    }
  }
  return off(grid.vertices(), points.str(), grid.faces());
}

// The surface of a block of unit cubes, without some of them: a closed surface of quadrangles. The columns of cubes in
// `holes` make handles.
struct Block
{
  int length = 1, width = 1, height = 1;
  std::vector<int> holes = {}; // i + length * j
  bool triangulated = false;
  bool round = false; // projected to a sphere
  double noise = 0;   // of the radius of the sphere, relative

  std::vector<std::array<int, 3>> places = {};
  std::vector<std::vector<int>> faces = {};

  Block& make()
  {
    for(int i = 0; i < length; ++i) {
      for(int j = 0; j < width; ++j) {
        for(int k = 0; k < height; ++k) {
          for(int axis = 0; axis < 3 && is_full(i, j, k); ++axis) {
            add_side({i, j, k}, axis, 0);
            add_side({i, j, k}, axis, 1);
          }
        }
      }
    }
    return *this;
  }

  std::string text() const
  {
    std::ostringstream points;
    points.precision(17);
    std::mt19937 random(1);
    for(const std::array<int, 3>& place : places) {
      const double x = place[0] - length / 2., y = place[1] - width / 2., z = place[2] - height / 2.;
      const double radius = 1 + noise * (static_cast<double>(random()) / 2147483648. - 1);
      const double scale = round ? radius / std::sqrt(x * x + y * y + z * z) : 1;
      points << scale * x << ' ' << scale * y << ' ' << scale * z << '\n';
    }
    return off(static_cast<int>(places.size()), points.str(), faces);
  }

  // From 0
  int vertex(const std::array<int, 3>& place) const
  {
    return static_cast<int>(std::find(places.begin(), places.end(), place) - places.begin());
  }

private:
  bool is_full(const int i, const int j, const int k) const
  {
    return i >= 0 && i < length && j >= 0 && j < width && k >= 0 && k < height &&
           std::find(holes.begin(), holes.end(), i + length * j) == holes.end();
  }

  void add_side(const std::array<int, 3>& cube, const int axis, const int side)
  {
    const auto a = static_cast<std::size_t>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
    std::array<int, 3> other = cube, corner = cube;
    other[a] += 2 * side - 1;
    if(is_full(other[0], other[1], other[2]))
      return;
    corner[a] += side;
    std::vector<int> face;
    for(const auto& step : {std::array<int, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      std::array<int, 3> place = corner;
      place[b] += step[side == 1 ? 0 : 1];
      place[c] += step[side == 1 ? 1 : 0];
      if(vertex(place) == static_cast<int>(places.size()))
        places.push_back(place);
      face.push_back(vertex(place));
    }
    if(triangulated) {
      faces.push_back({face[0], face[1], face[2]});
      faces.push_back({face[0], face[2], face[3]});
    } else {
      faces.push_back(face);
    }
  }
};

// A strip of quadrangles that winds around as it rises, twice if there are 48
inline std::string spiral(const int columns = 48)
{
  std::string text = "OFF\n" + std::to_string(2 * columns + 2) + " " + std::to_string(columns) + " 0\n";
  for(int i = 0; i <= columns; ++i) {
    const double angle = -0.26 * i;
    for(const double radius : {1., 2.}) {
      text += std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) +
              " " + std::to_string(0.01 * i) + "\n";
    }
  }
  for(int i = 0; i < columns; ++i) {
    text += "4 " + std::to_string(2 * i) + " " + std::to_string(2 * i + 2) + " " + std::to_string(2 * i + 3) +
            " " + std::to_string(2 * i + 1) + "\n";
  }
  return text;
}

inline Block cube()
{
  return Block().make();
}

inline Block sphere()
{
  Block block;
  block.length = block.width = block.height = 8;
  block.round = true;
  return block.make();
}

inline Block ring()
{
  Block block;
  block.length = block.width = 3;
  block.holes = {4};
  block.triangulated = true;
  return block.make();
}

inline Block two_rings()
{
  Block block;
  block.length = 5;
  block.width = 3;
  block.holes = {6, 8};
  return block.make();
}

// Surfaces in one OFF text
struct Collection
{
  int vertices = 0;
  std::string points;
  std::vector<std::vector<int>> faces;

  void add(const int n, const std::string& more_points, const std::vector<std::vector<int>>& more_faces)
  {
    for(std::vector<int> face : more_faces) {
      for(int& v : face)
        v += vertices;
      faces.push_back(face);
    }
    vertices += n;
    points += more_points;
  }

  void add(const Block& block)
  {
    const Lines lines = lines_of(block.text());
    std::string more;
    for(std::size_t v = 0; v < block.places.size(); ++v)
      more += lines[2 + v] + "\n";
    add(static_cast<int>(block.places.size()), more, block.faces);
  }

  void add(const Sheet& sheet) { add(sheet.vertices(), sheet.points(), sheet.faces()); }

  std::string text() const { return off(vertices, points, faces); }
};

// A line of a selection file: a path of vertices, from 0.
inline std::string path_line(const std::vector<int>& path)
{
  std::string line;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    line += std::to_string(path[i]) + " " + std::to_string(path[i + 1]) + " ";
  return "\n\n" + line + "\n";
}

using Edges = std::set<std::pair<int, int>>; // of vertices from 0, the smaller one first

inline Edges edges_in(const std::string& selection)
{
  Edges edges;
  std::istringstream words(selection);
  for(int v = 0, w = 0; words >> v >> w;)
    edges.insert(std::minmax(v, w));
  return edges;
}

inline std::vector<double> numbers(const Lines& lines)
{
  std::vector<double> result;
  for(const std::string& line : lines) {
    std::istringstream words(line);
    for(double number; words >> number;)
      result.push_back(number);
  }
  return result;
}

// A corner of a face in an OBJ text, with numbers from 0; `texture` is -1 where it has no texture coordinates
struct Obj_corner
{
  int vertex = -1, texture = -1;
  std::array<double, 3> point = {};
  std::complex<double> uv;
};

using Obj_faces = std::vector<std::vector<Obj_corner>>;

// Whether the corners of a face, at several vertices, have the same texture coordinates by number
inline bool stand_for_none(const std::vector<Obj_corner>& face)
{
  std::set<int> vertices, texture;
  for(const Obj_corner& corner : face) {
    vertices.insert(corner.vertex);
    texture.insert(corner.texture);
  }
  return vertices.size() > 1 && texture.size() == 1;
}

inline Obj_faces corners_of(const std::string& obj)
{
  const Lines points = lines_with(obj, "v");
  const std::vector<double> texture = numbers(lines_with(obj, "vt"));
  Obj_faces faces;
  for(const std::string& line : lines_with(obj, "f")) {
    std::istringstream words(line);
    faces.emplace_back();
    for(std::string word; words >> word;) {
      Obj_corner& corner = faces.back().emplace_back();
      corner.vertex = std::stoi(word) - 1;
      const std::vector<double> point = numbers({points.at(static_cast<std::size_t>(corner.vertex))});
      std::copy_n(point.begin(), 3, corner.point.begin());
      const std::size_t slash = word.find('/');
      if(slash != std::string::npos && slash + 1 < word.size() && word[slash + 1] != '/') {
        corner.texture = std::stoi(word.substr(slash + 1)) - 1;
        const auto i = 2 * static_cast<std::size_t>(corner.texture);
        corner.uv = {texture.at(i), texture.at(i + 1)};
      }
    }
    if(stand_for_none(faces.back())) {
      for(Obj_corner& corner : faces.back()) {
        corner.texture = -1;
        corner.uv = 0;
      }
    }
  }
  return faces;
}

// The vertices of the faces in an OBJ text, and whether all of them have texture coordinates
inline std::vector<std::vector<int>> obj_faces(const std::string& text, std::vector<bool>& has_texture)
{
  std::vector<std::vector<int>> faces;
  has_texture.clear();
  for(const std::vector<Obj_corner>& face : corners_of(text)) {
    faces.emplace_back();
    has_texture.push_back(true);
    for(const Obj_corner& corner : face) {
      faces.back().push_back(corner.vertex);
      has_texture.back() = has_texture.back() && corner.texture >= 0;
    }
  }
  return faces;
}

// Of each face with texture coordinates: these. Other faces have none.
inline std::vector<std::vector<std::array<double, 2>>> texture_of_faces(const std::string& text)
{
  std::vector<std::vector<std::array<double, 2>>> faces;
  for(const std::vector<Obj_corner>& face : corners_of(text)) {
    faces.emplace_back();
    for(const Obj_corner& corner : face)
      if(corner.texture >= 0)
        faces.back().push_back({corner.uv.real(), corner.uv.imag()});
  }
  return faces;
}

// Of the edges whose two sides have different texture coordinates: the quotient of the sides
inline std::map<std::pair<int, int>, std::complex<double>> seams_of(const std::string& obj)
{
  typedef std::pair<Obj_corner, Obj_corner> Side;
  std::map<std::pair<int, int>, Side> sides;
  for(const std::vector<Obj_corner>& face : corners_of(obj)) {
    for(std::size_t i = 0; i < face.size(); ++i) {
      const Obj_corner &a = face[i], &b = face[(i + 1) % face.size()];
      sides[{a.vertex, b.vertex}] = {a, b};
    }
  }
  std::map<std::pair<int, int>, std::complex<double>> seams;
  for(const auto& [edge, side] : sides) {
    const auto other = sides.find({edge.second, edge.first});
    if(edge.first < edge.second && other != sides.end() &&
       (other->second.first.texture != side.second.texture ||
        other->second.second.texture != side.first.texture))
      seams[edge] = (other->second.first.uv - other->second.second.uv) / (side.second.uv - side.first.uv);
  }
  return seams;
}

inline Edges edges_with_two_textures(const std::string& obj)
{
  Edges edges;
  for(const auto& seam : seams_of(obj))
    edges.insert(seam.first);
  return edges;
}

// The largest |logarithm| of the ratio of the lengths of both sides of a seam
inline double largest_seam_jump(const std::string& obj)
{
  double largest = 0;
  for(const auto& seam : seams_of(obj))
    largest = (std::max)(largest, std::abs(std::log(std::abs(seam.second))));
  return largest;
}

template <class Number>
void append_binary(std::string& text, const Number number)
{
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &number, sizeof(Number));
  text.append(bytes, sizeof(Number));
}

// A binary PLY, whose format has NaN and infinities.
inline std::string ply(const std::vector<float>& coordinates, const std::vector<std::vector<int>>& triangles)
{
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(coordinates.size() / 3) +
      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
      std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for(const float x : coordinates)
    append_binary(text, x);
  for(const std::vector<int>& triangle : triangles) {
    append_binary(text, static_cast<std::uint8_t>(triangle.size()));
    for(const int v : triangle)
      append_binary(text, static_cast<std::int32_t>(v));
  }
  return text;
}

inline std::vector<float> floats(const Sheet& sheet)
{
  const std::vector<double> all = numbers(lines_of(sheet.points()));
  return std::vector<float>(all.begin(), all.end());
}

inline std::string stl(const Sheet& sheet)
{
  const Lines points = lines_of(sheet.points());
  std::string text = "solid sheet\n";
  for(const std::vector<int>& face : sheet.faces()) {
    text += "facet normal 0 0 1\nouter loop\n";
    for(const int v : face)
      text += "vertex " + points[static_cast<std::size_t>(v)] + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid sheet\n";
}

inline std::string obj_input(const Sheet& sheet)
{
  std::string text = "# sheet\no sheet\n";
  for(const std::string& line : lines_of(sheet.points()))
    text += "v " + line + "\n";
  for(const std::vector<int>& face : sheet.faces()) {
    text += "f";
    for(const int v : face)
      text += " " + std::to_string(v + 1);
    text += "\n";
  }
  return text;
}

// How often an SVG file has a property, such as "stroke:rgb(60%,60%,60%)". Versions of Cairo write it as an attribute or
// as a part of the style, with or without blanks.
inline std::size_t count_in_svg(std::string svg, const std::string& property)
{
  svg.erase(std::remove_if(svg.begin(), svg.end(), [](const char c) { return c == ' ' || c == '"'; }),
            svg.end());
  std::replace(svg.begin(), svg.end(), '=', ':');
  std::size_t count = 0;
  for(std::size_t at = svg.find(property); at != std::string::npos; at = svg.find(property, at + 1))
    ++count;
  return count;
}

#ifdef ABF_WITH_PNG
using Pixel = std::array<png_byte, 3>; // red, green, blue

inline std::vector<Pixel> pixels_of(const std::string& png_file)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  BOOST_REQUIRE(png_image_begin_read_from_file(&image, png_file.c_str()) != 0);
  image.format = PNG_FORMAT_RGB;
  std::vector<Pixel> pixels(PNG_IMAGE_SIZE(image) / sizeof(Pixel));
  BOOST_REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}
#endif

#endif // RUN_FLATTEN_MESH_H
