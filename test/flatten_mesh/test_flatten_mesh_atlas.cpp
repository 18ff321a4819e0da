// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `flatten_mesh` without `--plain` as a black box: atlases, pictures, several files, streams.

#include "run_flatten_mesh.h"

#include "flatten_mesh/Progress_bar.h"

#include <CGAL/number_type_config.h>

#include <pty.h>

#include <tuple>

BOOST_AUTO_TEST_SUITE(test_flatten_mesh_atlas)

using Uv = std::array<double, 2>;

// Twice the signed area
inline double area_of(const std::vector<Uv>& polygon)
{
  double area = 0;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Uv &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    area += p[0] * q[1] - p[1] * q[0];
  }
  return area;
}

struct Atlas_folder : public Folder
{
  boost::property_tree::ptree atlas() const { return json().get_child("atlas"); }

  std::size_t charts() const { return atlas().get_child("charts").size(); }

  // All faces of the input have coordinates, turned as they should be, in the unit square unless these are world units.
  void check_atlas(const std::vector<std::vector<int>>& faces, const bool in_world_units = false)
  {
    BOOST_TEST(status == 0);
    BOOST_TEST(standard_error == "");
    BOOST_TEST(json().get<std::string>("status") == "OK");
    BOOST_TEST(json().get_child("skipped").size() == 0u);
    BOOST_TEST(atlas().get<int>("flipped_triangles") == 0);
    BOOST_TEST(atlas().get<bool>("injective"));
    std::vector<bool> has_texture;
    BOOST_TEST((obj_faces(obj(), has_texture) == faces));
    for(const std::vector<Uv>& face : texture_of_faces(obj())) {
      BOOST_TEST(face.size() > 2u);
      BOOST_TEST(area_of(face) > 0);
      for(const Uv& uv : face)
        BOOST_TEST((in_world_units || (uv[0] >= 0 && uv[0] <= 1 && uv[1] >= 0 && uv[1] <= 1)));
    }
  }

  void remove_outputs() const
  {
    for(const char* name : {"flat.obj", "flat.svg", "flat.json"})
      fs::remove(file(name));
  }

  // The refusal is of the whole file, and nothing is written but the report.
  void check_refused(const std::string& input, const std::string& options, const Lines& words)
  {
    BOOST_TEST_INFO_SCOPE(options);
    remove_outputs();
    flatten(input, options);
    check_refusal(words);
  }

  void check_success()
  {
    BOOST_TEST(status == 0);
    check_told_nothing();
    BOOST_TEST(json().get<std::string>("status") == "OK");
  }

  void check_told_nothing() const { BOOST_TEST(standard_error == ""); }
};

// The six sides of a block with vertices of their own
struct Split_surface
{
  explicit Split_surface(const Block& block)
  {
    const Lines lines = lines_of(block.text());
    std::map<std::array<int, 3>, int> numbers; // of a vertex on a side of an axis
    for(const std::vector<int>& face : block.faces) {
      faces.emplace_back();
      for(const int v : face) {
        const std::array<int, 3> key = {side_of(block, face)[0], side_of(block, face)[1], v};
        const auto [place, is_new] = numbers.emplace(key, static_cast<int>(numbers.size()));
        points += is_new ? lines[2 + static_cast<std::size_t>(v)] + "\n" : "";
        faces.back().push_back(place->second);
      }
    }
    count = static_cast<int>(numbers.size());
  }

  // The axis along which all corners are equal, and their coordinate
  static std::array<int, 2> side_of(const Block& block, const std::vector<int>& face)
  {
    for(int axis = 0; axis < 3; ++axis) {
      const auto coordinate = [&](const int v) {
        return block.places[static_cast<std::size_t>(v)][static_cast<std::size_t>(axis)];
      };
      if(std::all_of(face.begin(), face.end(),
                     [&](const int v) { return coordinate(v) == coordinate(face[0]); }))
        return {axis, coordinate(face[0])};
    }
    return {};
  }

  int vertices() const { return count; }

  std::string points;
  std::vector<std::vector<int>> faces;
  int count = 0;
};

inline std::vector<float> floats(const int vertices, const std::string& points)
{
  std::vector<float> result;
  for(const double x : numbers(lines_of(points)))
    result.push_back(static_cast<float>(x));
  BOOST_TEST_REQUIRE(result.size() == 3 * static_cast<std::size_t>(vertices));
  return result;
}

// The points of a block, elsewhere
inline std::string moved(const Block& block, const std::string& shift)
{
  const std::vector<double> by = numbers({shift});
  std::string text;
  for(std::size_t v = 0; v < block.places.size(); ++v) {
    const std::vector<double> point = numbers({lines_of(block.text())[2 + v]});
    for(std::size_t i = 0; i < 3; ++i)
      text += std::to_string(point[i] + by[i]) + (i < 2 ? " " : "\n");
  }
  return text;
}

BOOST_FIXTURE_TEST_SUITE(good_input, Atlas_folder)

BOOST_AUTO_TEST_CASE(closed_surfaces)
{
  for(const Block& block : {cube(), sphere(), ring(), two_rings()}) {
    BOOST_TEST_INFO_SCOPE(block.text());
    const std::string seams = file("block.selection.txt");
    flatten(write("block.off", block.text()), "--for few-charts --seams-to " + quoted(seams));
    check_atlas(block.faces);
    BOOST_TEST(charts() == 1u);
    BOOST_TEST((edges_with_two_textures(obj()) == edges_in(content(seams))));
    const auto tree = atlas();
    BOOST_TEST(tree.get<double>("seams.relative_length") > 0.5);
    BOOST_TEST(tree.get<int>("seams.terminals") >= 1);
    BOOST_TEST(tree.get<double>("packing.covered_share") > 0.2);
    BOOST_TEST(tree.get<double>("packing.covered_share") < 1);
    const auto chart = tree.get_child("charts").front().second;
    BOOST_TEST(chart.get<double>("scale_stretch") >= 1);
    BOOST_TEST(chart.get<double>("scale_stretch") <= 1.03 * 1.1);
    BOOST_TEST(chart.get<bool>("bound_reached"));
    BOOST_TEST(chart.get<double>("share_of_area") == 1, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(chart.get<std::string>("method") != "");
  }
}

// All seams of a cube lie on its edges, where there are six seams or more; the faces stay squares.
BOOST_AUTO_TEST_CASE(seams_along_creases)
{
  for(const char* seams : {"creases", "creases:80"}) {
    flatten(write("cube.off", cube().text()), std::string("--for few-charts --seams ") + seams);
    check_success();
    BOOST_TEST(charts() == 1u);
    BOOST_TEST(atlas().get<double>("seams.relative_length") == 7 / std::sqrt(6.),
               boost::test_tools::tolerance(1e-4));
    BOOST_TEST(atlas().get<double>("mean_angle_change") < 1e-4);
    BOOST_TEST(atlas().get<std::string>("seams.way") == "creases");
    BOOST_TEST(atlas().get<bool>("seams.is_hard_surface"));
    BOOST_TEST(json().get_child("notes").empty());
    check_printed("along creases of a hard surface");
  }
  flatten(write("cube.off", cube().text()), "--for few-charts --seams creases:100"); // there are none
  BOOST_TEST(status == 0);
  BOOST_TEST(json().get_child("notes").size() == 1u);
  check_told("no creases divide the surface where faces differ by more than 100 degrees");
  BOOST_TEST(!atlas().get<bool>("seams.is_hard_surface"));
  BOOST_TEST(atlas().get<double>("seams.crease_angle") == 100 * CGAL_PI / 180,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(atlas().get<double>("mean_angle_change") > 0.01);
}

// By default, seams are short. Those of textures of hard surfaces are near creases, and on all creases if there are few
// and all between them unfolds.
BOOST_AUTO_TEST_CASE(way_of_seams_by_default)
{
  const std::string block = write("block.off", ring().text());
  Collection both;
  both.add(ring());
  both.add(sphere());
  const std::string with_sphere = write("both.off", both.text());
  const std::string given = file("given.selection.txt");
  flatten(block, "--for few-charts --seams-to " + quoted(given));
  for(const auto& [input, options, way, is_hard] :
      {std::tuple(block, std::string(), "creases", "true"),
       {with_sphere, std::string(), "near-creases", "true"},
       {block, "--seams-from " + quoted(given), "near-creases", "true"},
       {block, "--for few-charts", "length", "null"},
       {block, "--seams length", "length", "null"},
       {block, "--for conformal --seams near-creases", "near-creases", "null"},
       {dinosaur(), "--weld off", "length", "false"}}) {
    BOOST_TEST_INFO_SCOPE(input << " " << options);
    flatten(input, options);
    check_success();
    BOOST_TEST(atlas().get<std::string>("seams.way") == way);
    BOOST_TEST(atlas().get<std::string>("seams.is_hard_surface") == is_hard);
    BOOST_TEST((atlas().get<std::string>("seams.crease_angle") == "null") == (way != std::string("creases")));
    BOOST_TEST((standard_output.find("creases of a hard surface") != std::string::npos) ==
               (is_hard == std::string("true")));
  }
}

// Of a symmetric surface. Without a symmetry, the atlas is as without the option.
BOOST_AUTO_TEST_CASE(symmetric_seams)
{
  flatten(dinosaur(), "--weld off");
  BOOST_TEST(atlas().get<std::string>("seams.symmetry") == "null");
  const double length = atlas().get<double>("seams.length");
  flatten(dinosaur(), "--weld off --symmetric");
  check_success();
  BOOST_TEST(json().get_child("notes").empty());
  BOOST_TEST(atlas().get<bool>("seams.symmetry.has_symmetric_surface"));
  BOOST_TEST(atlas().get<bool>("seams.symmetry.has_symmetric_seams"));
  BOOST_TEST(atlas().get<double>("seams.symmetry.deviation") < 0.002);
  BOOST_TEST(atlas().get<double>("seams.symmetry.asymmetry") < 0.01);
  BOOST_TEST(atlas().get_child("seams.symmetry.plane").size() == 4u);
  BOOST_TEST(atlas().get<double>("seams.length") <= 1.05 * length);
  BOOST_TEST(atlas().get<double>("seams.length") ==
                 (1 + atlas().get<double>("seams.symmetry.extra_length")) * length,
             boost::test_tools::tolerance(1e-6));

  const std::string input = write("irregular.off", "OFF\n4 4 0\n0 0 0\n4 0 0\n4 5 0\n0 0 7\n"
                                                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  flatten(input, "");
  const std::string usual = obj();
  flatten(input, "--symmetric");
  BOOST_TEST(status == 0);
  BOOST_TEST(obj() == usual);
  BOOST_TEST(!atlas().get<bool>("seams.symmetry.has_symmetric_surface"));
  BOOST_TEST(!atlas().get<bool>("seams.symmetry.has_symmetric_seams"));
  BOOST_TEST(atlas().get<double>("seams.symmetry.deviation") > 0.015);
  BOOST_TEST(json().get_child("notes").size() == 1u);
  check_told("the surface is not symmetric");
}

// A triangle needs none.
BOOST_AUTO_TEST_CASE(no_seams_are_symmetric)
{
  flatten(write("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "--symmetric");
  BOOST_TEST(status == 0);
  BOOST_TEST(json().get_child("notes").empty());
  BOOST_TEST(atlas().get<double>("seams.length") == 0);
  BOOST_TEST(atlas().get<double>("seams.symmetry.asymmetry") == 0);
  BOOST_TEST(atlas().get<double>("seams.symmetry.extra_length") == 0);
}

BOOST_AUTO_TEST_CASE(hidden_seams_are_others)
{
  const std::string shortest = file("shortest.selection.txt"), hidden = file("hidden.selection.txt");
  flatten(dinosaur(), "--for few-charts --seams length --seams-to " + quoted(shortest));
  BOOST_TEST(status == 0);
  const double length = atlas().get<double>("seams.length");
  flatten(dinosaur(), "--for few-charts --seams hidden --seams-to " + quoted(hidden));
  BOOST_TEST(status == 0);
  BOOST_TEST(atlas().get<std::string>("seams.way") == "hidden");
  BOOST_TEST(atlas().get<std::string>("seams.is_hard_surface") == "null");
  BOOST_TEST((edges_in(content(hidden)) != edges_in(content(shortest))));
  BOOST_TEST(atlas().get<double>("seams.length") > length);
}

BOOST_AUTO_TEST_CASE(figures_and_lines_of_the_reports)
{
  flatten(dinosaur(), "--for few-charts --weld off"); // it was cut open
  check_success();
  const auto tree = json();
  for(const char* key : {"vertices", "triangles", "components", "atlas.seams.length", "atlas.l2_stretch",
                         "atlas.linf_stretch", "atlas.mean_angle_change", "atlas.smallest_angle",
                         "atlas.packing.covered_share", "seconds.read", "seconds.charts", "seconds.pack",
                         "seconds.certify", "seconds.measure", "seconds.write", "peak_memory_mb"}) {
    BOOST_TEST_INFO_SCOPE(key);
    BOOST_TEST(std::isfinite(tree.get<double>(key)));
  }
  BOOST_TEST(tree.get<std::string>("input") == dinosaur());
  BOOST_TEST(tree.get<std::string>("atlas.units") == "square");
  BOOST_TEST(tree.get<int>("atlas.packing.resolution") == 1024);
  for(const char* word : {"charts ", "seams ", "scale stretch", "covered", "angle change", "L2 stretch",
                          "flipped triangles", "seconds", "pack ", "written"})
    check_printed(word);
  check_printed("all charts", false);
}

BOOST_AUTO_TEST_CASE(several_components)
{
  Collection all;
  all.add(sphere());
  all.add(Sheet());
  all.add(two_rings());
  flatten(write("all.off", all.text()), "--for few-charts");
  check_atlas(all.faces);
  BOOST_TEST(charts() == 3u);
  BOOST_TEST(json().get<int>("components") == 3);
  double share = 0;
  const auto tree = atlas();
  for(const auto& chart : tree.get_child("charts"))
    share += chart.second.get<double>("share_of_area");
  BOOST_TEST(share == 1, boost::test_tools::tolerance(1e-9));
  check_printed("all charts");
}

BOOST_AUTO_TEST_CASE(one_component)
{
  Collection all;
  all.add(cube());
  all.add(Sheet());
  all.add(sphere());
  const std::string input = write("all.off", all.text());
  const auto check = [&](const std::string& number, const std::size_t first, const std::size_t count) {
    BOOST_TEST_INFO_SCOPE("component " << number);
    flatten(input, "--for few-charts --component " + number);
    BOOST_TEST(status == 0);
    BOOST_TEST(charts() == 1u);
    const auto faces = texture_of_faces(obj());
    BOOST_TEST(lines_of(standard_error).size() == 1u, standard_error);
    check_told(std::to_string(faces.size() - count) + " faces have no texture coordinates");
    for(std::size_t f = 0; f < faces.size(); ++f) {
      BOOST_TEST((faces[f].empty() || area_of(faces[f]) > 0));
      BOOST_TEST(faces[f].empty() == (f < first || f >= first + count));
    }
  };
  const std::size_t in_cube = 6, in_sheet = Sheet().faces().size(), in_sphere = sphere().faces.size();
  check("0", in_cube + in_sheet, in_sphere);
  check("1", in_cube, in_sheet);
  check("2", 0, in_cube);
  check_refused(input, "--component 3", {"no component 3", "numbers 0 to 2"});
}

// A purpose is nothing else than its options, as --help names them.
BOOST_AUTO_TEST_CASE(purposes)
{
  const std::string input = write("strip.off", spiral());
  for(const auto& [purpose, options] :
      {std::pair<std::string, std::string>("few-charts",
                                           "--separate off --isometric off --seam-price inf "
                                           "--stretch-bound 1.1 --area-weight 0.02 --equal-seams on"),
       {"conformal", "--separate on --isometric off --seam-price 0.04 --stretch-bound 1.1 "
                     "--area-weight 0.02 --equal-seams on"},
       {"texture", "--separate on --isometric on --seam-price 0.04 --stretch-bound 1.07 "
                   "--area-weight 1 --equal-seams off"}}) {
    flatten(input, "--for " + purpose);
    const std::string usual = obj();
    for(const std::string other : {"few-charts", "conformal", "texture"}) {
      flatten(input, "--for " + other + " " + options);
      BOOST_TEST(obj() == usual);
    }
  }
  flatten(input, "--for texture");
  const std::string texture = obj();
  flatten(input); // the default
  BOOST_TEST(obj() == texture);
}

// Exporters give each side of a seam vertices of its own. The output has those, too.
BOOST_AUTO_TEST_CASE(split_models_are_joined)
{
  const Split_surface split(sphere());
  for(const std::string& input :
      {write("split.off", off(split.vertices(), split.points, split.faces)),
       write("split.ply", ply(floats(split.vertices(), split.points), split.faces))}) {
    BOOST_TEST_INFO_SCOPE(input);
    flatten(input, "--for few-charts");
    BOOST_TEST(status == 0);
    check_told("were merged: " + std::to_string(sphere().places.size()) + " vertices remain of " +
               std::to_string(split.vertices()));
    BOOST_TEST(charts() == 1u);
    BOOST_TEST(json().get<std::size_t>("vertices") == sphere().places.size());
    std::vector<bool> has_texture;
    BOOST_TEST((obj_faces(obj(), has_texture) == split.faces));
    BOOST_TEST(lines_with(obj(), "v").size() == static_cast<std::size_t>(split.vertices()));
    flatten(input, "--for few-charts --weld off");
    check_success();
    BOOST_TEST(charts() == 6u);
    flatten(input, "--for few-charts --repair off");
    BOOST_TEST(charts() == 6u);
  }
}

// Closed parts that touch stay apart, and the sides of a sheet.
BOOST_AUTO_TEST_CASE(what_only_touches_is_not_joined)
{
  for(const std::string shift : {"1 0 0", "1 1 0", "1 1 1"}) {
    BOOST_TEST_INFO_SCOPE(shift);
    Collection cubes;
    cubes.add(cube());
    cubes.add(8, moved(cube(), shift), cube().faces);
    flatten(write("cubes.off", cubes.text()));
    check_atlas(cubes.faces);
    BOOST_TEST(json().get<int>("components") == 2);
    BOOST_TEST(json().get<int>("vertices") == 16);
  }
  std::vector<std::vector<int>> back = Sheet().faces();
  for(std::vector<int>& face : back)
    std::reverse(face.begin(), face.end());
  Collection sides;
  sides.add(Sheet());
  sides.add(Sheet().vertices(), Sheet().points(), back);
  flatten(write("sides.off", sides.text()));
  check_atlas(sides.faces);
  BOOST_TEST(charts() == 2u);
}

// In world units, as large as the surface: a row of charts side by side, or the packed ones.
BOOST_AUTO_TEST_CASE(units)
{
  Collection all;
  all.add(cube());
  Block longer;
  longer.length = 3;
  all.add(longer.make());
  const std::string input = write("all.off", all.text());
  for(const std::string options : {"--no-pack", "--units world"}) {
    BOOST_TEST_INFO_SCOPE(options);
    flatten(input, options);
    check_atlas(all.faces, true);
    BOOST_TEST(atlas().get<std::string>("units") == "world");
    double area = 0;
    std::array<double, 4> a = {1e9, 1e9, -1e9, -1e9}, b = a; // the boxes of both charts
    const auto faces = texture_of_faces(obj());
    for(std::size_t f = 0; f < faces.size(); ++f) {
      area += area_of(faces[f]) / 2;
      std::array<double, 4>& box = f < 6 ? a : b;
      for(const Uv& uv : faces[f]) {
        box = {std::min(box[0], uv[0]), std::min(box[1], uv[1]), std::max(box[2], uv[0]),
               std::max(box[3], uv[1])};
      }
    }
    BOOST_TEST(area == 6 + 14, boost::test_tools::tolerance(0.01));
    if(options == "--no-pack")
      BOOST_TEST((a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1]));
  }
  flatten(input, "--resolution 128 --gutter 4 --rotations 4");
  check_atlas(all.faces);
  BOOST_TEST(atlas().get<int>("packing.gutter") == 4);
  for(const auto& [options, gutter] :
      {std::pair("", 4), std::pair("--resolution 2048", 8), std::pair("--resolution 64", 1),
       std::pair("--mip-levels 0", 1), std::pair("--mip-levels 3", 8)}) {
    flatten(input, options);
    check_atlas(all.faces);
    BOOST_TEST(atlas().get<int>("packing.gutter") == gutter, options);
  }
}

BOOST_AUTO_TEST_CASE(given_seams_are_kept)
{
  const Block block = two_rings();
  const std::string input = write("block.off", block.text()), seams = file("seams.selection.txt");
  flatten(input, "--for few-charts --seams-to " + quoted(seams));
  const std::string first = obj();
  const Edges given = edges_in(content(seams));

  flatten(input, "--for few-charts --seams-from " + quoted(seams));
  check_atlas(block.faces);
  BOOST_TEST((edges_with_two_textures(obj()) == given));

  flatten(write("textured.obj", first), "--for few-charts --seams-from uv");
  check_atlas(block.faces);
  BOOST_TEST((edges_with_two_textures(obj()) == given));

  const Edges ring_around = edges_in(path_line({block.vertex({1, 0, 0}), block.vertex({1, 0, 1})}));
  flatten(input, "--seams-from " + quoted(write("part.selection.txt", path_line({block.vertex({1, 0, 0}),
                                                                                 block.vertex({1, 0, 1})}))));
  check_atlas(block.faces);
  const Edges after = edges_with_two_textures(obj());
  BOOST_TEST(std::includes(after.begin(), after.end(), ring_around.begin(), ring_around.end()));

  check_refused(input, "--seams-from uv", {"no texture coordinates"});
  check_refused(input, "--charts-from-materials", {"no materials"});
  const std::vector<int>& face = block.faces.front();
  check_refused(input,
                "--seams-from " + quoted(write("diagonal.selection.txt", path_line({face[0], face[2]}))),
                {"no edge between vertices"});
}

BOOST_AUTO_TEST_CASE(given_charts_are_packed_anew)
{
  const Block block = two_rings();
  const std::string input = write("block.off", block.text());
  flatten(input, "--for few-charts --resolution 256");
  const std::string first = obj();
  const Edges seams = edges_with_two_textures(first);
  const std::size_t number = charts();
  const std::string textured = write("textured.obj", first);
  flatten(textured, "--repack --resolution 64");
  check_atlas(block.faces);
  BOOST_TEST(charts() == number);
  BOOST_TEST((edges_with_two_textures(obj()) == seams));
  const auto report = atlas();
  for(const auto& chart : report.get_child("charts"))
    BOOST_TEST(chart.second.get<std::string>("method") == "given");
  check_refused(input, "--repack", {"no texture coordinates", "block.off"});
  flatten(input, "--repack --repair-charts --for few-charts");
  check_atlas(block.faces);

  std::string mirrored, line;
  for(std::istringstream lines(first); std::getline(lines, line);)
    mirrored += line.rfind("vt ", 0) == 0 ? "vt -" + line.substr(3) + '\n' : line + '\n';
  const std::string wrong = write("mirrored.obj", mirrored);
  remove_outputs();
  flatten(wrong, "--repack");
  BOOST_TEST(status == 0);
  BOOST_TEST(number == 1u);
  check_told("1 given chart turned over, because it is mirrored as a whole");
  BOOST_TEST(charts() == number);
  flatten(wrong, "--repack --repair-charts");
  BOOST_TEST(status == 0);
  BOOST_TEST(charts() == number);
  const Edges after = edges_with_two_textures(obj());
  BOOST_TEST(std::includes(after.begin(), after.end(), seams.begin(), seams.end()));
}

BOOST_AUTO_TEST_CASE(charts_of_materials)
{
  const Sheet sheet;
  std::string text = obj_input(sheet);
  text.insert(text.find("f "), "usemtl first\n");
  text.insert(text.rfind("f ", text.size() - 40), "usemtl second\n");
  const std::string input = write("sheet.obj", text);
  flatten(input, "--for few-charts");
  check_atlas(sheet.faces());
  BOOST_TEST(charts() == 1u);
  flatten(input, "--charts-from-materials");
  check_atlas(sheet.faces());
  BOOST_TEST(charts() == 2u);
  BOOST_TEST(lines_with(obj(), "usemtl").size() == 2u);
}

BOOST_AUTO_TEST_CASE(same_bytes_on_any_number_of_threads)
{
  Collection all;
  all.add(sphere());
  all.add(two_rings());
  all.add(Sheet());
  const std::string input = write("all.off", all.text());
  std::array<std::string, 2> results;
  for(std::size_t i = 0; i < 2; ++i) {
    flatten(input, "--threads " + std::to_string(i + 1) + " --seams-to " + quoted(file("all.selection.txt")));
    check_atlas(all.faces);
    results[i] = obj() + content(file("flat.svg")) + content(file("all.selection.txt"));
  }
  BOOST_TEST((results[0] == results[1]));
}

// A filled path for each chart, and lines in the colours of the seams
BOOST_AUTO_TEST_CASE(drawn_plane)
{
  Collection all;
  all.add(sphere());
  all.add(Sheet());
  flatten(write("all.off", all.text()));
  const std::string svg = content(file("flat.svg"));
  BOOST_TEST(svg.find("<svg") < 100u);
  BOOST_TEST((svg.find("2 charts") != std::string::npos));
  BOOST_TEST((svg.find("nan") == std::string::npos));
  BOOST_TEST(count_in_svg(svg, "fill:rgb(") == 2u);
  BOOST_TEST(count_in_svg(svg, "stroke:rgb(100%,0%,0%)") == 1u); // the first seam
}

#ifdef ABF_WITH_PNG
// Six views and the plane: both colours of the checkerboard, the lighter fill of the chart, and dark lines
BOOST_AUTO_TEST_CASE(picture)
{
  run(quoted(write("sphere.off", sphere().text())) + " --for few-charts --picture " +
      quoted(file("flat.png")));
  BOOST_TEST(status == 0);
  const std::vector<Pixel> pixels = pixels_of(file("flat.png"));
  const std::size_t width = 2100, size = 420;
  BOOST_REQUIRE(pixels.size() == width * 2 * size);
  std::size_t fill = 0;
  std::array<std::size_t, 6> light = {}, dark = {};
  for(std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t column = i % width / size, row = i / width / size;
    const Pixel& p = pixels[i];
    if(column < 3) {
      light[3 * row + column] += p[0] > 100 && p[0] < 250;
      dark[3 * row + column] += p[2] > p[0] + 25;
    } else {
      fill += p[2] > p[0] + 25;
    }
  }
  for(std::size_t i = 0; i < 6; ++i) {
    BOOST_TEST(light[i] > size * size / 10);
    BOOST_TEST(dark[i] > size * size / 10);
  }
  BOOST_TEST(fill > size * size);
}

// A board across one axis, of which the views from above and from below show the large sides. The name is in the
// corner of each view.
BOOST_AUTO_TEST_CASE(sides_in_the_picture)
{
  const std::size_t width = 2100, size = 420;
  for(const std::string axis : {"x", "y", "z"}) {
    BOOST_TEST_INFO_SCOPE(axis);
    Block board;
    board.length = axis == "x" ? 1 : 8;
    board.width = axis == "y" ? 1 : 8;
    board.height = axis == "z" ? 1 : 8;
    run(quoted(write("board.off", board.make().text())) + " --picture " + quoted(file("flat.png")) +
        " --up " + axis);
    BOOST_TEST(status == 0);
    const std::vector<Pixel> pixels = pixels_of(file("flat.png"));
    BOOST_REQUIRE(pixels.size() == width * 2 * size);
    std::array<std::size_t, 6> covered = {}, ink = {};
    for(std::size_t i = 0; i < pixels.size(); ++i) {
      const std::size_t x = i % width, y = i / width % size;
      if(x < 3 * size && pixels[i][1] < 250)
        ++(y < 30 ? ink : covered)[i / width / size * 3 + x / size];
    }
    for(std::size_t i = 0; i < 6; ++i) {
      BOOST_TEST(ink[i] > 50u);
      BOOST_TEST((covered[i] > size * size / 2) == (i > 3), "side " << i);
    }
  }
}

// An upright table along the y axis or along the z axis
BOOST_AUTO_TEST_CASE(upward_axis_is_told_from_the_shape)
{
  const auto picture = [this](const std::string& input, const std::string& options) {
    run(quoted(input) + " --picture " + quoted(file("flat.png")) + " " + options);
    BOOST_TEST(status == 0);
    return content(file("flat.png"));
  };
  for(const std::string axis : {"y", "z"}) {
    std::string text = "OFF\n5 5 0\n";
    for(const std::string point : {"-1 -1 0", "1 -1 0", "1 1 0", "-1 1 0", "0 0 2"}) {
      std::istringstream words(point);
      std::string x, y, z;
      words >> x >> y >> z;
      text += axis == "y" ? y + " " + z + " " + x + "\n" : point + "\n";
    }
    const std::string input = write("pyramid.off", text + "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n");
    const std::string by_shape = picture(input, "");
    BOOST_TEST((by_shape == picture(input, "--up " + axis)), axis);
    BOOST_TEST((by_shape != picture(input, axis == "y" ? "--up z" : "--up y")), axis);
  }
}
#endif

BOOST_AUTO_TEST_CASE(quiet_and_verbose)
{
  const std::string input = write("sphere.off", sphere().text());
  flatten(input, "--quiet");
  BOOST_TEST(status == 0);
  BOOST_TEST(standard_output == "");
  check_told_nothing();
  flatten(input, "--verbose");
  for(const char* stage : {"reading: ", "cutting and flattening: ", "packing: ", "writing: "})
    check_told(stage);
  std::vector<std::vector<int>> faces = Sheet().faces();
  std::swap(faces[0][1], faces[0][2]);
  const std::string turned = write("turned.off", off(Sheet().vertices(), Sheet().points(), faces));
  flatten(turned);
  BOOST_TEST(status == 0);
  check_told("note: ");
  flatten(turned, "--quiet");
  check_told_nothing();
  BOOST_TEST(json().get_child("notes").size() == 1u);
}

BOOST_AUTO_TEST_CASE(several_inputs)
{
  const std::string a = write("a.off", sphere().text()), b = write("b.off", off(Sheet()));
  fs::create_directory(path / "out");
  const std::string outputs =
      " --output " + quoted(file("out/%_flat.obj")) + " --json " + quoted(file("out/%.json"));
  run(quoted(a) + " " + quoted(b) + outputs);
  BOOST_TEST(status == 0);
  check_told_nothing();
  BOOST_TEST(texture_of_faces(content(file("out/a_flat.obj"))).size() == sphere().faces.size());
  BOOST_TEST(texture_of_faces(content(file("out/b_flat.obj"))).size() == Sheet().faces().size());
  BOOST_TEST((content(file("out/b.json")).find("\"status\": \"OK\"") != std::string::npos));

  fs::remove_all(path / "out");
  fs::create_directory(path / "out");
  run(quoted(a) + " " + quoted(file("absent.off")) + " " + quoted(b) + outputs);
  BOOST_TEST(status == 2);
  check_told("absent.off");
  BOOST_TEST(fs::exists(path / "out/a_flat.obj"));
  BOOST_TEST(!fs::exists(path / "out/absent_flat.obj"));
  BOOST_TEST(fs::exists(path / "out/b_flat.obj"));
  BOOST_TEST((content(file("out/absent.json")).find("WRONG_INPUT") != std::string::npos));
}

BOOST_AUTO_TEST_CASE(streams)
{
  const std::string input = write("sphere.off", sphere().text());
  flatten(input);
  const std::string expected = obj();
  remove_outputs();
  run("- --format off --quiet --output - < " + quoted(input));
  BOOST_TEST(status == 0);
  BOOST_TEST((standard_output == expected));
  check_told_nothing();
  run("- --format off --json - < " + quoted(input));
  check_printed("\"input\": \"standard input\"");
  run("- --format off < /dev/null");
  check_refusal({"standard input", "empty"});
  run("- --format off < " + quoted(write("broken.off", "OFF\n3 1 0\n0 0 0\n")));
  check_refusal({"standard input"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(bad_input, Atlas_folder)

// A face at a wrong coordinate has no chart, and a face with a vertex twice; all else has.
BOOST_AUTO_TEST_CASE(rubbish_is_named)
{
  std::vector<float> points = floats(Sheet());
  std::vector<std::vector<int>> faces = Sheet().faces();
  const int n = Sheet().vertices();
  const std::size_t right = faces.size();
  for(const float x :
      {0.f, 0.f, 5.f, 1.f, 0.f, 5.f, 0.f, std::numeric_limits<float>::quiet_NaN(), 5.f, 1.f, 1.f, 5.f})
    points.push_back(x);
  faces.push_back({n, n + 1, n + 3});
  faces.push_back({n, n + 3, n + 2});
  faces.push_back({3, 4, 4});
  flatten(write("rubbish.ply", ply(points, faces)), "--for few-charts");
  BOOST_TEST(status == 2);
  check_told("no chart for 1 face, the first is face " + std::to_string(right + 2));
  check_told("NON_FINITE_POINT: vertex " + std::to_string(n + 3));
  check_told("DEGENERATE_FACE: face " + std::to_string(right + 3));
  const auto tree = json();
  BOOST_TEST(tree.get<std::string>("status") == "SOMETHING_SKIPPED");
  BOOST_TEST(tree.get_child("skipped").size() == 2u);
  BOOST_TEST(tree.get_child("skipped").front().second.get<std::size_t>("first_face") == right + 2);
  BOOST_TEST(tree.get_child("skipped").front().second.get<int>("faces") == 1);
  BOOST_TEST(charts() == 2u);
  const auto texture = texture_of_faces(obj());
  BOOST_REQUIRE(texture.size() == faces.size());
  for(std::size_t f = 0; f < texture.size(); ++f)
    BOOST_TEST(texture[f].empty() == (f > right));
}

BOOST_AUTO_TEST_CASE(nothing_but_rubbish)
{
  flatten(write("line.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"));
  BOOST_TEST(status == 2);
  check_told("no chart for 1 face");
  BOOST_TEST(json().get<std::string>("status") == "NO_AREA");
  BOOST_TEST(json().get<std::string>("atlas") == "null");
  BOOST_TEST(!fs::exists(file("flat.obj")));
  flatten(write("twice.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 1 0\n3 0 1 1\n"));
  BOOST_TEST(status == 2);
  check_told("DEGENERATE_FACE");
  BOOST_TEST(!fs::exists(file("flat.obj")));
}

// Faces that are there twice. Those that are turned are backs, which have a place of their own.
BOOST_AUTO_TEST_CASE(duplicate_faces_are_named)
{
  std::vector<std::vector<int>> faces = Sheet().faces();
  const std::size_t half = faces.size();
  for(std::size_t f = 0; f < half; ++f) {
    faces.push_back(faces[f]);
    if(f % 2 == 0)
      std::reverse(faces.back().begin(), faces.back().end());
  }
  flatten(write("twice.off", off(Sheet().vertices(), Sheet().points(), faces)));
  BOOST_TEST(status == 2);
  check_told(
      "no chart for 24 faces, the first is face 50: DUPLICATE_FACE: face 50 has the same corners as face 2");
  check_told("24 faces are the backs of others, as face 49 is of face 1: they are sheets of their own");
  const auto tree = json();
  BOOST_TEST(tree.get<std::string>("status") == "SOMETHING_SKIPPED");
  BOOST_TEST(tree.get_child("skipped").size() == 1u);
  BOOST_TEST(tree.get_child("skipped").front().second.get<std::size_t>("first_face") == half + 2);
  BOOST_TEST(tree.get_child("skipped").front().second.get<std::size_t>("faces") == half / 2);
  BOOST_TEST(tree.get_child("skipped").front().second.get<std::string>("diagnosis") == "DUPLICATE_FACE");
  const auto texture = texture_of_faces(obj());
  BOOST_REQUIRE(texture.size() == faces.size());
  for(std::size_t f = 0; f < texture.size(); ++f)
    BOOST_TEST(texture[f].empty() == (f >= half && f % 2 == 1));
}

// Three sheets that share an edge are separated. Without repairs they have no chart, and others have.
BOOST_AUTO_TEST_CASE(more_than_two_faces_at_an_edge)
{
  Collection all;
  all.add(5, "0 0 0\n0 0 1\n1 0 0\n-1 1 0\n-1 -1 0\n", {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  all.add(sphere());
  const std::string input = write("fan.off", all.text());
  flatten(input);
  BOOST_TEST(status == 0);
  check_told("more than two faces meet at ");
  for(const std::vector<Uv>& face : texture_of_faces(obj()))
    BOOST_TEST(face.size() > 2u);
  flatten(input, "--repair off");
  BOOST_TEST(status == 2);
  check_told("NON_MANIFOLD_EDGE: the edge between vertex 1 (");
  const auto texture = texture_of_faces(obj());
  for(std::size_t f = 0; f < texture.size(); ++f)
    BOOST_TEST(texture[f].empty() == (f < 3));
}

BOOST_AUTO_TEST_CASE(options_that_mean_nothing)
{
  const std::string input = write("sheet.off", off(Sheet()));
  for(const std::string option :
      {"--method direct", "--border 0", "--cut auto", "--injective", "--split-overlaps", "--holes fill",
       "--polish", "--barrier 0", "--solver eigen", "--clearance 0.5", "--layout exact"})
    check_refused(input, option, {"goes with --plain only", option.substr(0, option.find(' '))});
  for(const std::string option :
      {"--for texture", "--separate on", "--isometric on", "--seam-price 1", "--seams hidden", "--no-pack",
       "--units world", "--seams-from uv", "--charts-from-materials", "--resolution 64", "--gutter 1",
       "--mip-levels 1", "--rotations 4", "--repack"})
    check_refused(input, "--plain " + option, {"not with --plain", option.substr(0, option.find(' '))});
  for(const std::string& options :
      parts_of("--no-pack --units square|--no-pack --gutter 3|--no-pack --mip-levels 1|--mip-levels=-1|"
               "--mip-levels 11|--resolution 64 --mip-levels 5|--gutter 2 --mip-levels 1|--units inches|"
               "--resolution 0|--gutter=-1|--rotations 0|--for games|--separate yes|--isometric 1|"
               "--seam-price=-1|--seam-price nan|--seam-price 1 --no-pack|--seams-from seams.txt|"
               "--repair-charts|--repack --seams-from uv|--repack --for texture|"
               "--repack --stretch-bound 2|--repack --repair-charts --seam-price 1|"
               "--repack --component 0|--quiet --verbose|--format off|--area-weight 2|--repair maybe|"
               "--stretch-bound 0.9|--weld maybe|--weld=-1|--weld nan|--weld 1mm|--weld ''|"
               "--weld on --repair off|--up x|--seams seen|--seams ''|--symmetric --one-atlas|"
               "--symmetric --seams-from uv|--symmetric --repack|--symmetric --plain|--seams creases:|"
               "--seams creases:0|--seams creases:180|--seams creases:nan|--seams creases:4O|"
               "--seams cut.selection.txt|--seams-to cut.txt"))
    check_refused(input, options, {"flatten_mesh: "});
}

BOOST_AUTO_TEST_CASE(wrong_inputs_and_outputs)
{
  const std::string a = write("a.off", off(Sheet()));
  fs::create_directory(path / "b");
  const std::string same = write("b/a.off", off(Sheet()));
  const auto refuse = [this](const std::string& arguments, const Lines& words) {
    BOOST_TEST_INFO_SCOPE(arguments);
    run(arguments);
    check_refusal(words);
  };
  refuse(quoted(a) + " " + quoted(same) + " --output " + quoted(file("flat.obj")), {"2 inputs", "'%'"});
  refuse(quoted(a) + " " + quoted(same) + " --output " + quoted(file("flat_%.obj")),
         {"flat_a.obj", "runs of their own"});
  refuse(quoted(a) + " " + quoted(write("c.obj", obj_input(Sheet()))) + " --output " + quoted(file("%.obj")),
         {"overwrite"});
  refuse("-", {"--format"});
  refuse("- - --format off", {"once"});
  refuse("- --format docx < " + quoted(a), {"--format", "docx"});
  refuse(quoted(a) + " --seams-from " + quoted(file("absent.selection.txt")), {"absent.selection.txt"});
}

BOOST_AUTO_TEST_CASE(interrupted)
{
  check_interrupted(write("sheet.off", off(Sheet())));
}

// What a run leaves that is killed, the next one removes. It leaves the files of those that still run, and others.
BOOST_AUTO_TEST_CASE(killed)
{
  const std::string input = write("sheet.off", off(Sheet()));
  write("notes.unfinished", "");
  write("notes.2.unfinished", "");
  const pid_t process = waiting_process(input);
  flatten(input);
  BOOST_TEST(status == 0);
  BOOST_TEST(unfinished_files() == 3u);
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
  BOOST_TEST(unfinished_files() == 3u);
  flatten(input);
  BOOST_TEST(status == 0);
  BOOST_TEST(unfinished_files() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(progress)

BOOST_AUTO_TEST_CASE(line)
{
  using flatten_mesh::progress_line;
  BOOST_TEST(progress_line("packing", -1, 3.2) == "packing (3 s)");
  BOOST_TEST(progress_line("charts", 0.5, 4) == "charts [###############...............] 50 %, 4 s left");
  BOOST_TEST(progress_line("charts", 0, 4) == "charts [..............................] 0 %");
  BOOST_TEST(progress_line("charts", 1, 4) == "charts [##############################] 100 %, 0 s left");
}

// The program waits for a writer of its input, on a terminal: it says that it reads.
BOOST_FIXTURE_TEST_CASE(is_shown_on_a_terminal, Atlas_folder)
{
  BOOST_REQUIRE(::mkfifo(file("pipe.off").c_str(), 0600) == 0);
  int terminal = -1;
  const pid_t process = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  BOOST_REQUIRE(process >= 0);
  if(process == 0) {
    ::execl(program().c_str(), "flatten_mesh", file("pipe.off").c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  std::string shown;
  char text[256];
  while(shown.find("reading (") == std::string::npos) {
    const ssize_t count = ::read(terminal, text, sizeof(text));
    if(count <= 0)
      break;
    shown.append(text, static_cast<std::size_t>(count));
  }
  BOOST_TEST((shown.find("\r\033[Kreading (") != std::string::npos), shown);
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
  ::close(terminal);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
