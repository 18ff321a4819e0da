// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `flatten_mesh --plain` with cones and with seams of equal lengths, as a black box: what it writes is
// measured again.

#include "run_flatten_mesh.h"

#include <utility>

BOOST_AUTO_TEST_SUITE(test_flatten_mesh_cones)

const double pi = 3.14159265358979323846;

// The sum of the planar angles around each vertex
inline std::map<int, double> angle_sums(const Obj_faces& faces)
{
  std::map<int, double> sums;
  for(const std::vector<Obj_corner>& face : faces) {
    for(std::size_t i = 0; i < face.size() && face[i].texture >= 0; ++i) {
      const auto at = [&](const std::size_t k) { return face[k % face.size()].uv; };
      const double angle = std::arg((at(i + face.size() - 1) - at(i)) / (at(i + 1) - at(i)));
      sums[face[i].vertex] += angle < 0 ? angle + 2 * pi : angle;
    }
  }
  return sums;
}

// Vertices at the border of the surface
inline std::set<int> border_vertices(const Obj_faces& faces)
{
  std::set<std::pair<int, int>> sides;
  for(const std::vector<Obj_corner>& face : faces)
    for(std::size_t i = 0; i < face.size(); ++i)
      sides.insert({face[i].vertex, face[(i + 1) % face.size()].vertex});
  std::set<int> result;
  for(const auto& [v, w] : sides)
    if(sides.count({w, v}) == 0)
      result.insert({v, w});
  return result;
}

inline double distance_to_multiple(const double angle, const double quantum)
{
  return std::abs(angle - quantum * std::round(angle / quantum));
}

inline std::string degrees_text(const double degrees)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", degrees);
  return text;
}

struct Cone_folder : Folder
{
  Cone_folder() { common_options = "--plain "; }

  // The angle of each cone in the report, by vertex from 0
  std::map<int, double> cones() const
  {
    std::map<int, double> result;
    const boost::property_tree::ptree report = json();
    for(const auto& cone : report.get_child("cones.cones")) {
      const double angle = cone.second.get<double>("angle");
      BOOST_TEST(cone.second.get<double>("degrees") == angle * 180 / pi, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(result.emplace(cone.second.get<int>("vertex") - 1, angle).second);
    }
    return result;
  }

  // Everything that a report says is measured again in the OBJ file.
  void check_cones(const double quantum = 0)
  {
    check_succeeded();
    const Obj_faces faces = corners_of(obj());
    const auto seams = seams_of(obj());
    const std::map<int, double> angles = cones();
    const double jump = largest_seam_jump(obj());
    BOOST_TEST(seams.size() > 0u);
    BOOST_TEST(jump < 1e-5);
    BOOST_TEST(std::abs(jump - json().get<double>("largest_seam_jump")) < 1e-8);
    BOOST_TEST(json().get<std::string>("equal_seams") == "true");
    BOOST_TEST(json().get<std::string>("prescribed") == "null");
    BOOST_TEST(json().get<std::string>("seams.cut") == "cones");
    BOOST_TEST(json().get<double>("cones.largest_seam_turn") < 2e-5);
    BOOST_TEST(json().get<double>("cones.largest_angle_error") < 2e-5);
    const std::set<int> border = border_vertices(faces);
    for(const auto& [v, sum] : angle_sums(faces)) {
      const auto cone = angles.find(v);
      if(cone != angles.end() || border.count(v) == 0)
        BOOST_TEST(std::abs(sum - (cone == angles.end() ? 2 * pi : cone->second)) < 2e-5, "vertex " << v);
    }
    for(const auto& seam : seams)
      BOOST_TEST((quantum == 0 || distance_to_multiple(std::arg(seam.second), quantum) < 1e-4));
    check_dots(faces, angles);
  }

  void check_succeeded()
  {
    BOOST_TEST(status == 0, standard_error);
    BOOST_TEST(json().get<std::string>("status") == "OK");
    BOOST_TEST(json().get<int>("flipped_triangles") == 0);
  }

  // One for each place of each cone, with its title. Pieces of a split chart have the same places.
  void check_dots(const Obj_faces& faces, const std::map<int, double>& angles) const
  {
    std::set<std::array<double, 3>> copies; // with the vertex
    for(const std::vector<Obj_corner>& face : faces) {
      for(const Obj_corner& corner : face)
        if(angles.count(corner.vertex) != 0 && corner.texture >= 0)
          copies.insert({double(corner.vertex), corner.uv.real(), corner.uv.imag()});
    }
    const std::string svg = content(file("flat.svg"));
    BOOST_TEST(count(svg, "<circle ") == copies.size());
    for(const auto& [v, angle] : angles) {
      const std::string title = "<title>vertex " + std::to_string(v + 1) + ": " +
                                degrees_text(angle * 180 / pi) + " degrees</title>";
      BOOST_TEST(count(svg, title) > 0u, title);
    }
  }

  static std::size_t count(const std::string& text, const std::string& word)
  {
    std::size_t number = 0;
    for(std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      ++number;
    return number;
  }
};

// A sphere with bumps
inline Block ball(const bool triangulated = true, const int size = 6)
{
  Block block;
  block.length = size;
  block.width = size;
  block.height = size;
  block.triangulated = triangulated;
  block.round = true;
  block.noise = 0.1;
  return block.make();
}

// Of genus 2, finer than `two_rings()`
inline Block double_ring()
{
  Block block;
  block.length = 10;
  block.width = 6;
  block.height = 2;
  for(const int i : {2, 3, 6, 7})
    for(const int j : {2, 3})
      block.holes.push_back(i + block.length * j);
  return block.make();
}

// A tube of quadrangles around a circle, wider in three places
inline std::string torus()
{
  const int n = 24, m = 16;
  std::ostringstream points;
  std::vector<std::vector<int>> faces;
  const auto vertex = [](const int i, const int j) { return i % n * m + j % m; };
  for(int i = 0; i < n; ++i) {
    for(int j = 0; j < m; ++j) {
      const double a = 2 * pi * i / n, b = 2 * pi * j / m, width = 1 + 0.2 * std::sin(3 * a);
      const double radius = 3 + width * std::cos(b);
      points << radius * std::cos(a) << ' ' << radius * std::sin(a) << ' ' << width * std::sin(b) << '\n';
      faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return off(n * m, points.str(), faces);
}

inline double sum_of_charges(const std::map<int, double>& angles)
{
  double sum = 0;
  for(const auto& cone : angles)
    sum += 2 * pi - cone.second;
  return sum;
}

BOOST_FIXTURE_TEST_SUITE(cones, Cone_folder)

BOOST_AUTO_TEST_CASE(of_a_sphere)
{
  for(const bool triangulated : {true, false}) {
    BOOST_TEST_INFO_SCOPE("triangulated: " << triangulated);
    flatten(write("ball.off", ball(triangulated).text()), "--cones 8");
    check_cones();
    BOOST_TEST(cones().size() == 8u);
    BOOST_TEST(json().get<int>("cones.wanted") == 8);
    BOOST_TEST(json().get<std::string>("cones.angle_multiple") == "null");
    BOOST_TEST(std::abs(sum_of_charges(cones()) - 4 * pi) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(of_multiples_of_an_angle)
{
  const std::string input = write("ball.off", ball().text());
  for(const int degrees : {90, 60}) {
    BOOST_TEST_INFO_SCOPE(degrees << " degrees");
    flatten(input, "--cones 8 --cone-angle-multiple " + std::to_string(degrees));
    check_cones(degrees * pi / 180);
    BOOST_TEST(json().get<double>("cones.angle_multiple") == degrees * pi / 180,
               boost::test_tools::tolerance(1e-12));
    for(const auto& cone : cones())
      BOOST_TEST(distance_to_multiple(cone.second, degrees * pi / 180) < 1e-9);
    BOOST_TEST(std::abs(sum_of_charges(cones()) - 4 * pi) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(of_a_surface_with_handles)
{
  flatten(write("rings.off", double_ring().text()), "--cones 10");
  check_cones();
  BOOST_TEST(std::abs(sum_of_charges(cones()) + 4 * pi) < 1e-9);
}

BOOST_AUTO_TEST_CASE(of_a_component)
{
  Collection collection;
  const Block first = ball(false, 7), second = ball(false, 5);
  collection.add(first);
  collection.add(second);
  const int vertices = static_cast<int>(first.places.size());
  flatten(write("balls.off", collection.text()),
          "--cones 6 --component 1 --seams-to " + quoted(file("flat.selection.txt")));
  check_cones();
  for(const auto& cone : cones())
    BOOST_TEST(cone.first >= vertices);
  BOOST_TEST(edges_in(content(file("flat.selection.txt"))).size() == seams_of(obj()).size());
}

// A plane needs none.
BOOST_AUTO_TEST_CASE(that_are_not_needed)
{
  Sheet sheet;
  std::ostringstream points;
  for(int v = 0; v < sheet.vertices(); ++v)
    points << v % (sheet.columns + 1) << ' ' << v / (sheet.columns + 1) << " 0\n";
  flatten(write("plane.off", off(sheet.vertices(), points.str(), sheet.faces())), "--cones 4");
  check_succeeded();
  check_told("0 cones instead of 4");
  BOOST_TEST(cones().empty());
  BOOST_TEST(json().get<std::string>("seams") == "null");
}

BOOST_AUTO_TEST_CASE(survive_a_split)
{
  flatten(write("torus.off", torus()), "--cones 24 --split-overlaps");
  check_succeeded();
  BOOST_TEST(json().get<int>("split.pieces") > 1);
  BOOST_TEST(largest_seam_jump(obj()) < 1e-5);
  check_dots(corners_of(obj()), cones());
}

BOOST_AUTO_TEST_CASE(that_are_not_possible_are_refused)
{
  const std::string sphere = write("ball.off", ball().text());
  flatten(sphere, "--cones 0");
  check_refusal({"cannot choose cones", "needs cones"});
  for(const std::string number : {"1", "2"}) {
    flatten(sphere, "--cones " + number);
    check_refusal({"cannot choose cones", "the cone at vertex "});
  }
  flatten(sphere, "--cones 3 --cone-angle-multiple 180");
  check_refusal({"cannot choose cones", "take more cones"});
  flatten(write("rings.off", double_ring().text()), "--cones 8 --cone-angle-multiple 90");
  check_refusal({"cannot choose cones", "only on a sphere or a disk"});
}

BOOST_AUTO_TEST_CASE(wrong_usage)
{
  const std::string input = write("ball.off", ball().text());
  const std::vector<std::pair<std::string, std::string>> conflicts = {
      {"--rectangle auto", "--rectangle"},
      {"--border-angles angles.txt", "--border-angles"},
      {"--cut topology", "--cut"},
      {"--stretch-bound 1.2", "--stretch-bound"},
      {"--equal-seams off", "--equal-seams off"},
      {"--method hierarchical", "--method"},
      {"--injective", "--injective"},
      {"--layout least-squares", "--layout"}};
  for(const auto& [option, word] : conflicts) {
    flatten(input, "--cones 8 " + option);
    check_refusal({word});
  }
  for(const std::string number : {"-1", "1001", "8.5", "many"}) {
    flatten(input, "--cones=" + number);
    check_refusal({"cones"});
  }
  for(const std::string angle : {"0", "-90", "70", "361", "nan", "inf", "1e-9", "right"}) {
    flatten(input, "--cones 8 --cone-angle-multiple=" + angle);
    check_refusal({"cone-angle-multiple"});
  }
  flatten(input, "--cone-angle-multiple 90");
  check_refusal({"--cones only"});
  common_options = "";
  flatten(input, "--cones 8");
  check_refusal({"--cones", "--plain only"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(equal_seams, Cone_folder)

// They are the default of the direct method.
BOOST_AUTO_TEST_CASE(of_the_direct_method)
{
  for(const std::string& surface : {ball().text(), double_ring().text()}) {
    const std::string input = write("surface.off", surface);
    for(const std::string option : {"", "--method direct", "--equal-seams on", "--equal-seams off"}) {
      BOOST_TEST_INFO_SCOPE(option);
      flatten(input, "--cut topology " + option);
      check_succeeded();
      const bool is_on = option != "--equal-seams off";
      const double jump = largest_seam_jump(obj());
      BOOST_TEST((jump < 1e-5) == is_on, jump);
      BOOST_TEST((jump > 1e-2) != is_on, jump);
      BOOST_TEST(std::abs(jump - json().get<double>("largest_seam_jump")) < 1e-8);
      BOOST_TEST(json().get<std::string>("equal_seams") == (is_on ? "true" : "false"));
      check_printed("--equal-seams", false);
    }
  }
}

// The default does not change the method, and the report says what that means.
BOOST_AUTO_TEST_CASE(not_of_the_hierarchical_method)
{
  flatten(write("ball.off", ball(true, 12).text()), "--cut topology --method hierarchical");
  check_succeeded();
  BOOST_TEST(json().get<std::string>("method") == "hierarchical");
  BOOST_TEST(json().get<std::string>("equal_seams") == "false");
  const double jump = largest_seam_jump(obj());
  BOOST_TEST(jump > 1e-2);
  BOOST_TEST(std::abs(jump - json().get<double>("largest_seam_jump")) < 1e-8);
  check_printed("--equal-seams on takes the direct one");
}

BOOST_AUTO_TEST_CASE(mean_nothing_without_seams)
{
  flatten(write("sheet.off", off(Sheet())));
  check_success();
  BOOST_TEST(json().get<std::string>("equal_seams") == "null");
  BOOST_TEST(json().get<std::string>("largest_seam_jump") == "null");
  BOOST_TEST(json().get<std::string>("cones") == "null");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
