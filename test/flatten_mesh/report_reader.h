// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_REPORT_READER_H
#define TEST_REPORT_READER_H

// Reads the data of a page that `flatten_mesh --report` wrote.

#include "run_flatten_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

// The content of the element with an id, in which there are no elements
inline std::string element_of_page(const std::string& page, const std::string& id)
{
  const std::size_t place = page.find(" id=\"" + id + "\">");
  BOOST_TEST_REQUIRE((place != std::string::npos), "the page lacks " << id);
  const std::size_t begin = page.find('>', place) + 1;
  return page.substr(begin, page.find('<', begin) - begin);
}

inline std::string bytes_of_base64(const std::string& text)
{
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  BOOST_TEST(text.size() % 4 == 0u);
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for(const char letter : text.substr(0, text.find('='))) {
    bits = (bits << 6 | static_cast<std::uint32_t>(letters.find(letter))) & 0xffffffu;
    count += 6;
    if(count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xffu);
    }
  }
  return bytes;
}

template <class Number>
std::vector<Number> array_of_page(const std::string& page, const std::string& name)
{
  const std::string bytes = bytes_of_base64(element_of_page(page, "array-" + name));
  BOOST_TEST_REQUIRE(bytes.size() % sizeof(Number) == 0u);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if(!numbers.empty())
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

struct Report_page
{
  using Tree = boost::property_tree::ptree;

  std::string text;
  Tree json;
  std::vector<float> points, wedge_uv;
  std::vector<std::uint32_t> wedge_points, triangles, faces, borders;
  std::vector<std::int32_t> charts;
  std::array<std::vector<float>, 3> measures;

  static const std::array<std::string, 3>& names_of_measures()
  {
    static const std::array<std::string, 3> names = {"angle_change", "area_change", "stretch_ratio"};
    return names;
  }

  explicit Report_page(const std::string& page) : text(page)
  {
    std::istringstream stream(element_of_page(page, "report"));
    boost::property_tree::read_json(stream, json);
    points = array_of_page<float>(page, "points");
    wedge_uv = array_of_page<float>(page, "wedge_uv");
    wedge_points = array_of_page<std::uint32_t>(page, "wedge_points");
    triangles = array_of_page<std::uint32_t>(page, "triangles");
    faces = array_of_page<std::uint32_t>(page, "faces");
    borders = array_of_page<std::uint32_t>(page, "borders");
    charts = array_of_page<std::int32_t>(page, "charts");
    for(std::size_t i = 0; i < 3; ++i)
      measures[i] = array_of_page<float>(page, names_of_measures()[i]);
    check_sizes();
  }

  std::size_t number_of_triangles() const { return charts.size(); }

  const Tree& measure(const std::size_t i) const
  {
    auto child = json.get_child("measures").begin();
    std::advance(child, i);
    return child->second;
  }

  std::array<double, 3> point(const std::size_t corner) const
  {
    const float* p = &points[3 * wedge_points[triangles[corner]]];
    return {p[0], p[1], p[2]};
  }

  std::complex<double> uv(const std::size_t corner) const
  {
    const float* p = &wedge_uv[2 * triangles[corner]];
    return {p[0], p[1]};
  }

  double area(const std::size_t t) const
  {
    const auto a = point(3 * t), b = point(3 * t + 1), c = point(3 * t + 2);
    double squares = 0;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const double part = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
      squares += part * part;
    }
    return std::sqrt(squares) / 2;
  }

  double planar_area(const std::size_t t) const
  {
    const auto a = uv(3 * t), b = uv(3 * t + 1), c = uv(3 * t + 2);
    return std::imag(std::conj(b - a) * (c - a)) / 2;
  }

private:
  void check_sizes() const
  {
    const std::size_t n = number_of_triangles();
    BOOST_TEST_REQUIRE(json.get<std::size_t>("shown_triangles") == n);
    BOOST_TEST_REQUIRE(json.get_child("measures").size() == 3u);
    BOOST_TEST_REQUIRE(triangles.size() == 3 * n);
    BOOST_TEST_REQUIRE(faces.size() == n);
    BOOST_TEST_REQUIRE(wedge_uv.size() == 2 * wedge_points.size());
    BOOST_TEST_REQUIRE(points.size() % 3 == 0u);
    BOOST_TEST_REQUIRE(borders.size() % 3 == 0u);
    for(const std::vector<float>& values : measures)
      BOOST_TEST_REQUIRE(values.size() == n);
    const auto all = [](const auto& values, const auto& condition) {
      return std::all_of(values.begin(), values.end(), condition);
    };
    BOOST_TEST_REQUIRE(all(triangles, [this](const std::uint32_t w) { return w < wedge_points.size(); }));
    BOOST_TEST_REQUIRE(all(wedge_points, [this](const std::uint32_t p) { return 3 * p < points.size(); }));
    BOOST_TEST_REQUIRE(all(points, [](const float x) { return std::isfinite(x); }));
  }
};

#endif // TEST_REPORT_READER_H
