// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `flatten_mesh --plain` with prescribed angles, as a black box: rectangles, angles in files.

#include "run_flatten_mesh.h"

BOOST_AUTO_TEST_SUITE(test_flatten_mesh_angles)

struct Angle_folder : Folder
{
  Angle_folder() { common_options = "--plain "; }

  // The corners in the report
  std::vector<int> corners() const
  {
    std::vector<int> result;
    for(const auto& corner : json().get_child("prescribed.corners"))
      result.push_back(corner.second.get_value<int>());
    return result;
  }

  // Of each vertex that has them: these surfaces have no seams.
  std::vector<std::array<double, 2>> coordinates() const
  {
    std::vector<std::array<double, 2>> result(lines_with(obj(), "vt").size());
    for(const std::vector<Obj_corner>& face : corners_of(obj()))
      for(const Obj_corner& corner : face)
        result.at(static_cast<std::size_t>(corner.vertex)) = {corner.uv.real(), corner.uv.imag()};
    return result;
  }

  // The layout lies within the box of its first border edge, and all border vertices are on the sides.
  void check_rectangle(const std::vector<int>& border) const
  {
    const auto uv = coordinates();
    std::array<double, 2> least = uv[0], most = uv[0];
    for(const auto& p : uv) {
      for(int k : {0, 1}) {
        least[k] = (std::min)(least[k], p[k]);
        most[k] = (std::max)(most[k], p[k]);
      }
    }
    const double size = (std::max)(most[0] - least[0], most[1] - least[1]);
    for(const int v : border) {
      double distance = size;
      for(int k : {0, 1})
        distance = (std::min)({distance, uv[v][k] - least[k], most[k] - uv[v][k]});
      BOOST_TEST(distance < 1e-12 * size, "vertex " << v);
    }
    BOOST_TEST(json().get<double>("prescribed.side_deviation") < 1e-12);
    BOOST_TEST(json().get<double>("prescribed.largest_angle_error") < 1e-9);
  }
};

// The vertices of the border of a sheet, from 0
inline std::vector<int> border_of(const Sheet& sheet)
{
  std::vector<int> border;
  for(int j = 0; j <= sheet.rows; ++j) {
    for(int i = 0; i <= sheet.columns; ++i)
      if(i == 0 || j == 0 || i == sheet.columns || j == sheet.rows)
        border.push_back(j * (sheet.columns + 1) + i);
  }
  return border;
}

BOOST_FIXTURE_TEST_SUITE(rectangles, Angle_folder)

BOOST_AUTO_TEST_CASE(have_the_corners_that_are_asked_for)
{
  const Sheet sheet;
  const std::string input = write("sheet.off", off(sheet));
  flatten(input, "--rectangle 1,7,35,29");
  check_success();
  BOOST_TEST(corners().size() == 4u);
  for(const int v : {1, 7, 35, 29}) {
    const std::vector<int> found = corners();
    BOOST_TEST(std::count(found.begin(), found.end(), v) == 1);
  }
  check_rectangle(border_of(sheet));
  BOOST_TEST(json().get<int>("prescribed.split_edges") == 0);
  const std::string svg = content(file("flat.svg"));
  std::size_t dots = 0;
  for(std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1))
    ++dots;
  BOOST_TEST(dots == 4u);
  BOOST_TEST(standard_output.find("vertices 1, ") != std::string::npos, standard_output);
}

// On a sheet, they are those of the sheet.
BOOST_AUTO_TEST_CASE(find_their_corners)
{
  Sheet sheet;
  sheet.columns = 12;
  sheet.rows = 8;
  flatten(write("sheet.off", off(sheet)), "--rectangle auto");
  check_success();
  std::vector<int> found = corners();
  std::sort(found.begin(), found.end());
  BOOST_TEST(found == (std::vector<int>{1, 13, 105, 117}), boost::test_tools::per_element());
  check_rectangle(border_of(sheet));
}

// Two corners of the sheet are triangles with two border edges each, and are on straight sides now.
BOOST_AUTO_TEST_CASE(split_what_is_in_the_way)
{
  for(const bool triangulated : {true, false}) {
    BOOST_TEST_INFO_SCOPE("triangulated: " << triangulated);
    Sheet sheet;
    sheet.triangulated = triangulated;
    const std::string input = write("sheet.off", off(sheet));
    flatten(input, "--rectangle 3,14,33,22");
    BOOST_TEST(status == 0);
    check_told("split in the middle");
    BOOST_TEST(json().get<std::string>("status") == "OK");
    const int split = json().get<int>("prescribed.split_edges");
    BOOST_TEST(split > 0);
    BOOST_TEST(json().get<int>("flipped_triangles") == 0);
    BOOST_TEST(static_cast<int>(lines_with(obj(), "v").size()) == sheet.vertices() + split);
    // Each edge is split together with the triangles beside it, of which there are two.
    const Lines faces = lines_with(obj(), "f");
    BOOST_TEST(static_cast<int>(faces.size()) == 2 * sheet.columns * sheet.rows + 2 * split);
    for(const std::string& face : faces) {
      std::istringstream stream(face);
      const auto corners = std::distance(std::istream_iterator<std::string>(stream), {});
      BOOST_TEST(corners == 3);
      BOOST_TEST(std::count(face.begin(), face.end(), '/') == 3, face);
    }
    check_rectangle(border_of(sheet));
  }
}

BOOST_AUTO_TEST_CASE(that_split_edges_are_written_in_each_format)
{
  const std::string input = write("sheet.off", off(Sheet()));
  for(const std::string output : {"flat.ply", "flat.glb"}) {
    for(const std::string corners : {"3,14,33,22", "1,7,35,29"}) {
      run(quoted(input) + " --rectangle " + corners + " --output " + quoted(file(output)));
      BOOST_TEST(status == 0, standard_error);
      BOOST_TEST(fs::file_size(file(output)) > 1000u);
      fs::remove(file(output));
    }
  }
}

BOOST_AUTO_TEST_CASE(of_other_surfaces_are_refused)
{
  Block cube;
  cube.triangulated = true;
  flatten(write("cube.off", cube.make().text()), "--rectangle auto");
  check_refusal({"closed"});
  const std::string sheet = write("sheet.off", off(Sheet()));
  for(const std::string corners :
      {"1,2,3", "1,2,3,3", "1,2,3,x", "1,2,3,4,5", "0.5,1,2,3", "1,,2,3", "somewhere"}) {
    flatten(sheet, "--rectangle " + corners);
    check_refusal({"--rectangle", "1,20,300,4000"});
  }
  for(const std::string number : {"0", "9", "36", "99999999999999"}) {
    flatten(sheet, "--rectangle 1,7,35," + number);
    check_refusal({"--rectangle", "not on the outer border"});
  }
  flatten(sheet, "--rectangle auto --method hierarchical");
  check_refusal({"--rectangle", "--method"});
  flatten(sheet, "--rectangle auto --cut topology");
  check_refusal({"--rectangle", "cut"});
  flatten(sheet, "--rectangle auto --layout least-squares");
  check_refusal({"--rectangle", "--layout"});
  flatten(sheet, "--rectangle auto --border-angles " + quoted(file("angles.txt")));
  check_refusal({"--rectangle", "--border-angles"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(angles_in_a_file, Angle_folder)

// A triangle with its corners at three of those of the sheet, whose fourth one is on its longest side
BOOST_AUTO_TEST_CASE(make_a_polygon)
{
  const Sheet sheet;
  std::string text = "# vertex, degrees\n\n";
  for(const int v : border_of(sheet))
    text += std::to_string(v + 1) + (v == 0 ? "\t90" : v == 6 || v == 28 ? " 45" : "  180") + " \r\n";
  flatten(write("sheet.off", off(sheet)), "--border-angles " + quoted(write("angles.txt", text)));
  check_success();
  BOOST_TEST(corners().size() == 3u);
  BOOST_TEST(json().get<double>("prescribed.side_deviation") < 1e-12);
  const auto uv = coordinates();
  const auto distance = [&](int v, int w) { return std::hypot(uv[v][0] - uv[w][0], uv[v][1] - uv[w][1]); };
  BOOST_TEST(distance(0, 6) == distance(0, 28), boost::test_tools::tolerance(1e-10));
  BOOST_TEST(distance(6, 28) == std::sqrt(2.) * distance(0, 6), boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(that_are_not_possible_are_named)
{
  const std::string sheet = write("sheet.off", off(Sheet()));
  const auto run_with = [&](const std::string& text) {
    flatten(sheet, "--border-angles " + quoted(write("angles.txt", text)));
  };
  run_with("1 90\n2 180\nx 90\n");
  check_refusal({"angles.txt", "line 3", "degrees"});
  run_with("1\n");
  check_refusal({"line 1"});
  run_with("1 90 90\n");
  check_refusal({"line 1"});
  run_with("1 nan\n");
  check_refusal({"line 1"});
  run_with("1 90\n1 80\n");
  check_refusal({"line 2", "vertex 1 "});
  run_with("9 90\n");
  check_refusal({"line 1", "vertex 9", "not on the outer border"});
  run_with("4 -90\n");
  check_refusal({"WRONG_ANGLE_SUM", "vertex 4"});
  run_with("4 560\n");
  check_refusal({"WRONG_ANGLE_SUM", "vertex 4", "3 triangle(s)"});
  std::string all;
  for(const int v : border_of(Sheet()))
    all += std::to_string(v + 1) + " 170\n";
  run_with(all);
  check_refusal({"WRONG_ANGLE_TOTAL", "20 border vertices", "18 pi"});
  flatten(sheet, "--border-angles " + quoted(file("missing.txt")));
  check_refusal({"missing.txt"});
  run("--border-angles x " + quoted(sheet));
  BOOST_TEST(status == 2);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(equal_seams, Angle_folder)

BOOST_AUTO_TEST_CASE(of_a_closed_surface_have_equal_lengths)
{
  Block block;
  block.length = 4;
  block.width = 3;
  block.height = 3;
  block.triangulated = true;
  block.round = true;
  block.noise = 0.1;
  const std::string input = write("ball.off", block.make().text());
  double jumps[2];
  for(const bool equal : {false, true}) {
    flatten(input, std::string("--cut topology --equal-seams ") + (equal ? "on" : "off"));
    BOOST_TEST(status == 0);
    BOOST_TEST(json().get<int>("flipped_triangles") == 0);
    jumps[equal] = json().get<double>("largest_seam_jump");
    BOOST_TEST(standard_output.find("seam jump") != std::string::npos);
  }
  BOOST_TEST(jumps[0] > 1e-2);
  BOOST_TEST(jumps[1] < 1e-5);
}

BOOST_AUTO_TEST_CASE(wrong_usage)
{
  const std::string sheet = write("sheet.off", off(Sheet()));
  for(const std::string options :
      {"--equal-seams maybe", "--equal-seams on --method hierarchical", "--equal-seams on --injective"}) {
    flatten(sheet, options);
    check_refusal({"equal-seams"});
  }
  flatten(sheet, "--equal-seams on"); // there are none
  check_success();
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
