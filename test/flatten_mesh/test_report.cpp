// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pages that `flatten_mesh --report` writes: their data against the other files of the same run, and against
// computations here.

#include "report_reader.h"
#include "run_flatten_mesh.h"

#ifdef ABF_WITH_THREE

#include "flatten_mesh/report/Displayed_surface.h"
#include "flatten_mesh/report/base64.h"

#include <CGAL/number_utils.h>

BOOST_AUTO_TEST_SUITE(test_report)

using Point = std::array<double, 3>;

template <std::size_t n>
double distance(const std::array<double, n>& p, const std::array<double, n>& q)
{
  double squares = 0;
  for(std::size_t i = 0; i < n; ++i)
    squares += (p[i] - q[i]) * (p[i] - q[i]);
  return std::sqrt(squares);
}

// Points are relative to the centre of the box of all.
inline Obj_faces centered_corners_of(const std::string& obj)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Point low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
  Obj_faces faces = corners_of(obj);
  const auto for_each_coordinate = [&faces](const auto& change) {
    for(std::vector<Obj_corner>& face : faces) {
      for(Obj_corner& corner : face)
        for(std::size_t i = 0; i < 3; ++i)
          change(corner.point[i], i);
    }
  };
  for_each_coordinate([&](const double x, const std::size_t i) {
    low[i] = (std::min)(low[i], x);
    high[i] = (std::max)(high[i], x);
  });
  for_each_coordinate([&](double& x, const std::size_t i) { x -= (low[i] + high[i]) / 2; });
  return faces;
}

// Runs the program with all that the page is compared to.
struct Report_folder : public Folder
{
  Report_page report(const std::string& input, const std::string& options = "")
  {
    flatten(input, "--report " + quoted(file("page.html")) + " " + options);
    return Report_page(content(file("page.html")));
  }

  // Whether each triangle of the page lies in the face that it names, with the same places on the surface and in the
  // plane, and whether these triangles cover all faces with charts
  void check_triangles(const Report_page& page) const
  {
    const Obj_faces faces = centered_corners_of(obj());
    std::vector<std::size_t> triangles_of_face(faces.size(), 0);
    std::size_t wrong = 0;
    for(std::size_t t = 0; t < page.number_of_triangles(); ++t) {
      BOOST_TEST_REQUIRE(page.faces[t] < faces.size());
      const std::vector<Obj_corner>& face = faces[page.faces[t]];
      triangles_of_face[page.faces[t]] += page.charts[t] >= 0;
      for(std::size_t c = 3 * t; c < 3 * t + 3 && page.charts[t] >= 0; ++c) {
        wrong += std::none_of(face.begin(), face.end(), [&](const Obj_corner& corner) {
          return distance(corner.point, page.point(c)) < 1e-5 * (1 + distance(corner.point, Point())) &&
                 std::abs(corner.uv - page.uv(c)) < 1e-6 * (1 + std::abs(corner.uv));
        });
      }
    }
    BOOST_TEST(wrong == 0u);
    for(std::size_t f = 0; f < faces.size(); ++f)
      BOOST_TEST(triangles_of_face[f] == (faces[f][0].texture < 0 ? 0u : faces[f].size() - 2));
  }
};

// The angles, the factor of areas and the quasi-conformal ratio of a triangle, from the lengths of its sides alone
struct Independent_measures
{
  double angle_change = 0, area_change = 0, stretch_ratio = 1;

  Independent_measures(const Report_page& page, const std::size_t t)
  {
    std::array<double, 3> space, plane; // squared lengths of the sides opposite to the corners
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = 3 * t + (i + 1) % 3, b = 3 * t + (i + 2) % 3;
      space[i] = std::pow(distance(page.point(a), page.point(b)), 2);
      plane[i] = std::pow(std::abs(page.uv(a) - page.uv(b)), 2);
    }
    for(std::size_t i = 0; i < 3; ++i)
      angle_change += std::abs(angle(space, i) - angle(plane, i)) / 3 * 180 / CGAL_PI;
    const double factor = std::abs(page.planar_area(t)) / page.area(t);
    area_change = std::log2(factor / std::pow(page.json.get<double>("scale"), 2));
    // The sum of the squares of the two stretches, by the cotangents of one triangle and the sides of the other
    double squares = 0;
    for(std::size_t i = 0; i < 3; ++i)
      squares += plane[i] / std::tan(angle(space, i)) / (2 * page.area(t));
    const double half = squares / factor / 2;
    stretch_ratio = half + std::sqrt((std::max)(half * half - 1, 0.));
  }

private:
  static double angle(const std::array<double, 3>& sides, const std::size_t i)
  {
    const double a = sides[i], b = sides[(i + 1) % 3], c = sides[(i + 2) % 3];
    return std::acos(std::clamp((b + c - a) / (2 * std::sqrt(b * c)), -1., 1.));
  }
};

inline void check_measures(const Report_page& page)
{
  std::size_t wrong = 0;
  for(std::size_t t = 0; t < page.number_of_triangles(); ++t) {
    if(page.charts[t] >= 0) {
      const Independent_measures expected(page, t);
      wrong += !(std::abs(page.measures[0][t] - expected.angle_change) < 0.02) ||
               !(std::abs(page.measures[1][t] - expected.area_change) < 0.01) ||
               !(std::abs(page.measures[2][t] - expected.stretch_ratio) < 0.01 * expected.stretch_ratio);
    } else {
      for(std::size_t i = 0; i < 3; ++i)
        wrong += !std::isnan(page.measures[i][t]);
    }
  }
  BOOST_TEST(wrong == 0u);
}

inline double mean_by_area(const Report_page& page, const std::size_t measure)
{
  double sum = 0, total = 0;
  for(std::size_t t = 0; t < page.number_of_triangles(); ++t) {
    if(page.charts[t] >= 0) {
      sum += page.area(t) * page.measures[measure][t];
      total += page.area(t);
    }
  }
  return sum / total;
}

// Of the pages that show all triangles
inline void check_histogram(const Report_page& page, const std::size_t measure)
{
  const Report_page::Tree& tree = page.measure(measure);
  const double first = tree.get<double>("histogram.first"), width = tree.get<double>("histogram.width");
  std::vector<double> shares, expected;
  for(const auto& share : tree.get_child("histogram.shares"))
    shares.push_back(share.second.get_value<double>());
  expected.assign(shares.size(), 0);
  double total = 0, sum = 0;
  for(std::size_t t = 0; t < page.number_of_triangles(); ++t) {
    const double bin = std::floor((page.measures[measure][t] - first) / width);
    if(std::isfinite(bin)) {
      expected[static_cast<std::size_t>(std::clamp(bin, 0., static_cast<double>(shares.size() - 1)))] +=
          page.area(t);
      total += page.area(t);
    }
  }
  for(std::size_t i = 0; i < shares.size(); ++i) {
    BOOST_TEST(std::abs(shares[i] - expected[i] / total) < 1e-3);
    sum += shares[i];
  }
  BOOST_TEST(std::abs(sum - 1) < 1e-9);
  const double low = tree.get_child("limits").front().second.get_value<double>(),
               high = tree.get_child("limits").back().second.get_value<double>();
  BOOST_TEST(low < high);
  BOOST_TEST(first <= low);
  BOOST_TEST(shares.back() <= 0.0101); // the colours cover nearly all
}

inline void check_worst(const Report_page& page, const std::size_t measure)
{
  const Report_page::Tree& tree = page.measure(measure);
  const double best = tree.get<double>("best");
  std::vector<double> all;
  for(const float value : page.measures[measure])
    if(std::isfinite(value))
      all.push_back(std::abs(value - best));
  std::sort(all.rbegin(), all.rend());
  BOOST_TEST(tree.get_child("worst").size() == (std::min)(all.size(), std::size_t(20)));
  auto expected = all.begin();
  for(const auto& entry : tree.get_child("worst")) {
    const auto t = entry.second.get<std::size_t>("triangle");
    const double value = entry.second.get<double>("value");
    BOOST_TEST_REQUIRE(t < page.number_of_triangles());
    BOOST_TEST(entry.second.get<std::size_t>("face") == page.faces[t]);
    BOOST_TEST(std::abs(page.measures[measure][t] - value) <= 1e-5 * (1 + std::abs(value)));
    BOOST_TEST(std::abs(std::abs(value - best) - *expected++) <= 1e-5 * (1 + std::abs(value)));
  }
}

// Each side is one of exactly one triangle; both sides of a seam have the same points and number, and other sides none.
inline void check_borders(const Report_page& page)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles_of_side;
  for(std::size_t c = 0; c < page.triangles.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    if(page.charts[c / 3] >= 0)
      ++triangles_of_side[{page.triangles[c], page.triangles[next]}];
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> borders;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> seams_of_edge;
  for(std::size_t i = 0; i < page.borders.size(); i += 3) {
    const std::uint32_t a = page.borders[i], b = page.borders[i + 1];
    BOOST_TEST((triangles_of_side[{a, b}] == 1));
    borders.insert({a, b});
    seams_of_edge[std::minmax({page.wedge_points[a], page.wedge_points[b]})].push_back(page.borders[i + 2]);
  }
  BOOST_TEST(3 * borders.size() == page.borders.size());
  for(const auto& [side, count] : triangles_of_side)
    if(count > 0 && borders.count(side) == 0)
      BOOST_TEST((triangles_of_side.count({side.second, side.first}) == 1u));
  for(const auto& [edge, seams] : seams_of_edge) {
    const bool is_seam = seams.front() != 0xffffffffu;
    BOOST_TEST((seams.size() == 1 || (seams.size() == 2 && is_seam && seams[0] == seams[1])));
  }
}

inline void check_page(const Report_page& page)
{
  BOOST_TEST(page.json.get<std::size_t>("triangles") == page.number_of_triangles());
  check_measures(page);
  check_borders(page);
  for(std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(page.measure(i).get<std::string>("name") == Report_page::names_of_measures()[i]);
    check_histogram(page, i);
    check_worst(page, i);
  }
}

// The number of lines with these words in both texts: all rows of the page are those of the report for people.
inline void check_rows(const Report_page& page, const std::string& text)
{
  for(const auto& row : page.json.get_child("rows")) {
    for(const auto& word : row.second) {
      BOOST_TEST((text.find(word.second.get_value<std::string>()) != std::string::npos),
                 word.second.get_value<std::string>());
    }
  }
  BOOST_TEST(page.json.get_child("rows").size() > 15u);
}

BOOST_FIXTURE_TEST_SUITE(pages, Report_folder)

BOOST_AUTO_TEST_CASE(atlas_of_quadrangles)
{
  const Report_page page = report(write("ball.off", sphere().text()));
  BOOST_TEST(status == 0);
  check_triangles(page);
  check_page(page);
  check_rows(page, standard_output);
  BOOST_TEST(page.json.get<std::string>("title") == "ball.off");
  BOOST_TEST(page.json.get<std::string>("kind") == "atlas");
  BOOST_TEST(page.json.get<bool>("is_packed"));
  BOOST_TEST(page.json.get<int>("resolution") == 1024);
  BOOST_TEST(page.json.get<std::string>("up") == "y");
  BOOST_TEST(std::abs(mean_by_area(page, 0) - json().get<double>("atlas.mean_angle_change") * 180 / CGAL_PI) <
             1e-3);
  BOOST_TEST(std::abs(mean_by_area(page, 2) - json().get<double>("atlas.mean_quasi_conformal_ratio")) < 1e-4);
  for(const float x : page.wedge_uv)
    BOOST_TEST((x >= 0 && x <= 1));
}

BOOST_AUTO_TEST_CASE(several_charts)
{
  for(const std::string options : {"", "--no-pack", "--units world", "--component 0", "--for few-charts"}) {
    Collection surfaces;
    surfaces.add(two_rings());
    surfaces.add(sphere());
    surfaces.add(cube());
    const Report_page page = report(write("parts.off", surfaces.text()), options);
    BOOST_TEST(status == 0, standard_error);
    check_triangles(page);
    check_page(page);
    const auto& charts = page.json.get_child("charts");
    BOOST_TEST(charts.size() == json().get_child("atlas.charts").size());
    std::vector<std::size_t> triangles(charts.size(), 0);
    for(const std::int32_t chart : page.charts)
      if(chart >= 0)
        ++triangles.at(static_cast<std::size_t>(chart));
    std::size_t i = 0;
    for(const auto& chart : charts)
      BOOST_TEST(chart.second.get<std::size_t>("triangles") == triangles[i++]);
  }
}

BOOST_AUTO_TEST_CASE(repaired_surfaces)
{
  Block block = sphere();
  for(std::size_t f = 0; f < block.faces.size(); f += 3)
    std::reverse(block.faces[f].begin(), block.faces[f].end());
  const Report_page page = report(write("turned.off", block.text()));
  BOOST_TEST(status == 0);
  check_triangles(page);
  check_page(page);
  BOOST_TEST(page.json.get_child("notes").size() == 1u);
}

BOOST_AUTO_TEST_CASE(plain_charts)
{
  Sheet sheet;
  sheet.columns = 20;
  sheet.rows = 12;
  sheet.holes = {50, 51};
  const Report_page open = report(write("sheet.off", off(sheet)), "--plain --up x");
  check_triangles(open);
  check_page(open);
  check_rows(open, standard_output);
  BOOST_TEST(open.json.get<std::string>("up") == "x");
  BOOST_TEST(open.json.get<std::string>("kind") == "chart");
  BOOST_TEST(!open.json.get<bool>("is_packed"));
  BOOST_TEST(std::abs(mean_by_area(open, 0) - json().get<double>("mean_angle_change") * 180 / CGAL_PI) <
             1e-3);
  for(const std::string options : {"--plain", "--plain --split-overlaps"}) {
    const Report_page cut = report(write("rings.off", two_rings().text()), options);
    BOOST_TEST(status == 0, standard_error);
    check_triangles(cut);
    check_page(cut);
    BOOST_TEST(cut.points.size() / 3 == two_rings().places.size()); // both sides of seams share points
  }
}

// Their parts are in the face that they were in.
BOOST_AUTO_TEST_CASE(triangles_split_beside_straight_sides)
{
  const Report_page page = report(write("sheet.off", off(Sheet())), "--plain --rectangle 3,14,33,22");
  BOOST_TEST(json().get<int>("prescribed.split_edges") > 0);
  check_triangles(page);
  check_page(page);
  check_rows(page, standard_output);
}

BOOST_AUTO_TEST_CASE(skipped_parts)
{
  Collection surfaces;
  surfaces.add(3, "1 1 0\n2 1 0\n3 1 0\n", {{0, 1, 1}}); // a vertex twice: set aside
  surfaces.add(Sheet());
  surfaces.add(3, "1 2 0\n2 2 0\n3 2 0\n", {{0, 1, 2}}); // no area: no chart
  const Report_page page = report(write("parts.off", surfaces.text()));
  BOOST_TEST(status == 2);
  check_triangles(page);
  check_page(page);
  BOOST_TEST(std::count(page.charts.begin(), page.charts.end(), -1) == 0); // not in the mesh
  const auto& skipped = page.json.get_child("skipped");
  BOOST_TEST(skipped.size() == 2u);
  BOOST_TEST_REQUIRE(skipped.size() == json().get_child("skipped").size());
  BOOST_TEST(skipped.front().second.get<int>("first_face") + 1 ==
             json().get_child("skipped").front().second.get<int>("first_face"));
  fs::remove(file("page.html"));
  flatten(write("nothing.ply", ply({0, 0, 0, 1, 0, 0, 0, NAN, 0}, {{0, 1, 2}})),
          "--report " + quoted(file("page.html")));
  BOOST_TEST(status == 2);
  BOOST_TEST(!fs::exists(file("page.html")));
}

BOOST_AUTO_TEST_CASE(names_are_text_wherever_they_stand)
{
  fs::create_directory(path / "a<");
  for(const std::string name :
      {"a</script><b>\"&amp;<!--.off", "\xc3\xa4\xe2\x80\xa8 \\u003c.off", "\xff.off"}) {
    write(name, off(Sheet()));
    const Report_page page = report(file(name));
    BOOST_TEST(status == 0);
    const std::string shown = page.json.get<std::string>("title");
    BOOST_TEST(shown == (name[0] == '\xff' ? "\xef\xbf\xbd.off" : fs::path(name).filename().string()));
    for(const std::string tag : {"<script", "</script", "<!--"}) { // no more than for other names
      const auto count = [&tag](const std::string& text) {
        std::size_t n = 0;
        for(std::size_t i = text.find(tag); i != std::string::npos; i = text.find(tag, i + 1))
          ++n;
        return n;
      };
      const std::string plain_name = file("plain.off");
      run(quoted(write("plain.off", off(Sheet()))) + " --quiet --report " + quoted(file("plain.html")));
      BOOST_TEST(count(page.text) == count(content(file("plain.html"))));
    }
    BOOST_TEST(page.text.find("<b>\"&amp;") == std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(large_and_small_coordinates)
{
  for(const char* exponent : {"e60", "e-60"}) {
    std::string text = "OFF\n5 4 0\n";
    for(const char* point : {"0 0 1", "1 0 0", "0 1 0", "-1 0 0", "0 -1 0"}) {
      std::istringstream words(point);
      for(std::string word; words >> word;)
        text += word + (word == "0" ? "" : exponent) + " ";
      text += "\n";
    }
    for(const std::string options : {"", "--units world", "--plain"}) {
      const Report_page page =
          report(write("pyramid.off", text + "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1\n"), options);
      BOOST_TEST(status == 0, standard_error);
      check_page(page);
    }
  }
}

BOOST_AUTO_TEST_CASE(same_page_with_any_number_of_threads)
{
  const std::string input = write("ball.off", sphere().text());
  std::set<std::string> pages;
  for(const char* threads : {"1", "2", "3"})
    pages.insert(report(input, std::string("--threads ") + threads).text);
  BOOST_TEST(pages.size() == 1u);
}

BOOST_AUTO_TEST_CASE(files_of_reports)
{
  const std::string a = quoted(write("a.off", off(Sheet()))), b = quoted(write("b.off", sphere().text()));
  run(a + " " + b + " --report " + quoted(file("%.html")));
  BOOST_TEST(status == 0);
  BOOST_TEST(Report_page(content(file("a.html"))).json.get<std::string>("title") == "a.off");
  BOOST_TEST(Report_page(content(file("b.html"))).json.get<std::string>("title") == "b.off");
  run(a + " " + b + " --report " + quoted(file("c.html")));
  check_refusal({"--report", "%.html"});
  run(a + " --report " + quoted(file("c.htm")));
  check_refusal({"--report does not write .htm", "--report .html"});
  run(a + " --report ''");
  check_refusal({"--report is empty"});
  run(a + " --report " + quoted(file("c.html")) + " --json " + quoted(file("c.html")));
  BOOST_TEST(status == 2);
  BOOST_TEST(!fs::exists(file("c.html")));
  run(a + " --report " + quoted(file("no_folder/c.html")) + " --output " + quoted(file("flat.obj")));
  check_refusal({"no_folder"});
  run(a + " --report -");
  BOOST_TEST(status == 0);
  BOOST_TEST(Report_page(standard_output).json.get<std::string>("title") == "a.off");
  check_told("written");
}

BOOST_AUTO_TEST_CASE(a_hundred_thousand_triangles_take_twelve_megabytes)
{
  Sheet sheet;
  sheet.columns = sheet.rows = std::getenv("ABF_TEST_QUICK") != nullptr ? 50 : 224;
  run(quoted(write("sheet.off", off(sheet))) + " --plain --report " + quoted(file("page.html")));
  BOOST_TEST(status == 0, standard_error);
  BOOST_TEST(fs::file_size(file("page.html")) <= 12000000u);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(of_large_surfaces, Report_folder)

BOOST_AUTO_TEST_CASE(are_thinned)
{
  Sheet sheet;
  sheet.columns = 500;
  sheet.rows = 260;
  const Report_page page = report(write("sheet.off", off(sheet)), "--plain");
  BOOST_TEST(page.json.get<std::size_t>("triangles") == 260000u);
  BOOST_TEST(page.number_of_triangles() <= 250000u);
  BOOST_TEST(page.number_of_triangles() >= 249000u);
  check_borders(page);
  for(std::size_t i = 0; i < 3; ++i) {
    for(const auto& entry : page.measure(i).get_child("worst")) {
      const auto t = entry.second.get<std::size_t>("triangle");
      const double value = entry.second.get<double>("value");
      BOOST_TEST_REQUIRE(t < page.number_of_triangles());
      BOOST_TEST(entry.second.get<std::size_t>("face") == page.faces[t]);
      BOOST_TEST(std::abs(page.measures[i][t] - value) <= 1e-5 * (1 + std::abs(value)));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(base64_of_arrays)
{
  for(std::uint32_t size = 0; size < 8; ++size) {
    std::vector<std::uint32_t> numbers;
    for(std::uint32_t i = 0; i < size; ++i)
      numbers.push_back(0x89abcdefu * (i + 1));
    std::string text;
    flatten_mesh::append_base64(text, numbers);
    BOOST_TEST((array_of_page<std::uint32_t>("<x id=\"array-a\">" + text + "</x>", "a") == numbers));
  }
}

BOOST_AUTO_TEST_SUITE_END()

#else

BOOST_AUTO_TEST_SUITE(test_report)

BOOST_FIXTURE_TEST_CASE(programs_without_three_say_so, Folder)
{
  run(quoted(write("a.off", off(Sheet()))) + " --report " + quoted(file("a.html")));
  check_refusal({"--report", "libjs-three"});
}

BOOST_AUTO_TEST_SUITE_END()

#endif // ABF_WITH_THREE
