// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of packing that work on many texels at a time, compared with loops over single ones, and the search for a
// scale that is large enough.

#include <boost/test/unit_test.hpp>

#include "planar_charts.h"

#include <CGAL/Texture_atlas/internal/packing/place_charts.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>
#include <CGAL/Texture_atlas/internal/packing/visit_texels.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_places)

namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
namespace TA = CGAL::Texture_atlas;
using TA::internal::Occupied_cells;
using TA::internal::Packing;
using ABF::Planar_point;
using TA::internal::Texel;
using TA::internal::Texel_mask;

namespace {

int below(int end, std::mt19937& random)
{
  return static_cast<int>(random() % static_cast<unsigned>(end));
}

// Some intervals, which touch all sides of the mask
Texel_mask random_mask(int width, int height, int intervals, std::mt19937& random)
{
  Texel_mask mask(width, height);
  for(int i = 0; i < intervals; ++i) {
    const int x = below(width, random), y = below(height, random);
    mask.add(x, x + 1 + below(width - x, random), y);
  }
  mask.add(0, 1, below(height, random));
  mask.add(width - 1, width, below(height, random));
  mask.add(below(width, random), width, 0);
  mask.add(below(width, random), width, height - 1);
  return mask;
}

int longest_run(const Texel_mask& mask, int y, bool is_free)
{
  int longest = 0;
  for(int x = 0, run = 0; x < mask.width(); ++x) {
    run = mask.has(x, y) == is_free ? 0 : run + 1;
    longest = (std::max)(longest, run);
  }
  return longest;
}

// What a page with some masks holds
struct Page
{
  int width, height;
  Texel_mask taken;

  bool is_free(const Texel_mask& mask, int left, int bottom) const
  {
    for(int y = 0; y < mask.height(); ++y)
      for(int x = 0; x < mask.width(); ++x)
        if(mask.has(x, y) && taken.has(left + x, bottom + y))
          return false;
    return true;
  }

  std::optional<Texel> find_place(const Texel_mask& mask, int first_row, int last_row) const
  {
    for(int y = first_row; y <= (std::min)(last_row, height - mask.height()); ++y)
      for(int x = 0; x + mask.width() <= width; ++x)
        if(is_free(mask, x, y))
          return Texel{x, y};
    return std::nullopt;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(turned_masks)
{
  std::mt19937 random(1);
  for(int i = 0; i < 200; ++i) {
    const Texel_mask mask = random_mask(1 + below(150, random), 1 + below(150, random), 60, random);
    const Texel_mask turned = quarter_turn(mask);
    BOOST_REQUIRE_EQUAL(turned.width(), mask.height());
    BOOST_REQUIRE_EQUAL(turned.height(), mask.width());
    BOOST_REQUIRE_EQUAL(turned.number_of_texels(), mask.number_of_texels());
    int differ = 0;
    for(int y = 0; y < mask.height(); ++y)
      for(int x = 0; x < mask.width(); ++x)
        differ += mask.has(x, y) != turned.has(mask.height() - 1 - y, x);
    BOOST_TEST(differ == 0);
  }
}

BOOST_AUTO_TEST_CASE(runs_of_texels)
{
  std::mt19937 random(2);
  for(int i = 0; i < 200; ++i) {
    const Texel_mask mask = random_mask(1 + below(300, random), 1 + below(20, random), 1 + i % 40, random);
    for(int y = 0; y < mask.height(); ++y)
      for(const bool is_free : {false, true})
        BOOST_TEST(mask.longest_run(y, is_free, mask.width()) == longest_run(mask, y, is_free));
    const std::vector<TA::internal::Row_run> runs = longest_runs(mask);
    BOOST_TEST(!runs.empty());
    for(const TA::internal::Row_run& run : runs) {
      BOOST_TEST(run.length == longest_run(mask, run.y, false));
      BOOST_TEST(run.length <= runs.front().length);
    }
  }
}

BOOST_AUTO_TEST_CASE(first_free_places)
{
  std::mt19937 random(3);
  int found = 0, cases = 0;
  for(int i = 0; i < 60; ++i) {
    const int width = 20 + below(180, random), height = 20 + below(100, random), margin = below(3, random);
    Occupied_cells cells(width, height, margin);
    Page page{width, height, Texel_mask(width, height)};
    for(int j = 0; j < 25; ++j, ++cases) {
      const Texel_mask mask =
          random_mask(1 + below(width / 2, random), 1 + below(height / 2, random), 30, random);
      const int first_row = below(3, random) * 5, last_row = j % 4 == 0 ? height / 3 : height;
      const auto place = cells.find_place(mask, longest_runs(mask), first_row, last_row),
                 expected = page.find_place(mask, first_row, last_row);
      BOOST_REQUIRE_EQUAL(place.has_value(), expected.has_value());
      if(!place)
        continue;
      ++found;
      BOOST_TEST(place->x == expected->x);
      BOOST_TEST(place->y == expected->y);
      const Texel_mask grown = dilated(mask, margin);
      cells.add(grown, place->x, place->y);
      for(int y = 0; y < grown.height(); ++y)
        for(int x = 0; x < grown.width(); ++x)
          if(const int column = place->x - margin + x, row = place->y - margin + y;
             grown.has(x, y) && column >= 0 && column < width && row >= 0 && row < height)
            page.taken.add(column, column + 1, row);
    }
  }
  BOOST_TEST(found > cases / 5);
  BOOST_TEST(found < cases * 4 / 5);
}

// A segment touches what a triangle without area touches.
BOOST_AUTO_TEST_CASE(texels_of_segments)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(0, 40), small(-1, 1);
  const double tolerance = 1. / 256;
  for(int i = 0; i < 2000; ++i) {
    const Planar_point p(coordinate(random), coordinate(random));
    const Planar_point q = i % 3 == 0   ? Planar_point(p + Planar_point(small(random), small(random)))
                           : i % 3 == 1 ? Planar_point(coordinate(random), p.y())
                                        : Planar_point(coordinate(random), coordinate(random));
    std::vector<std::tuple<int, int, int>> of_segment, of_triangle;
    TA::internal::visit_texels(p, q, tolerance,
                               [&](int y, int first, int last) { of_segment.emplace_back(y, first, last); });
    TA::internal::visit_texels(std::array<Planar_point, 3>{p, q, q}, tolerance,
                               [&](int y, int first, int last) { of_triangle.emplace_back(y, first, last); });
    BOOST_TEST((of_segment == of_triangle));
  }
}

// What covers no more than is wanted is given up, and what covers more is found.
BOOST_AUTO_TEST_CASE(wanted_shares)
{
  std::mt19937 random(5);
  CGAL::Texture_atlas::Packing_options options;
  options.resolution = 128;
  options.gutter = 0;
  for(int number : {1, 4, 12}) {
    const test_charts::Planar_charts charts = test_charts::random_charts(number, random);
    const double share = pack(charts, options).covered_share;
    const auto pack_if_more = [&](double least) {
      return TA::internal::pack(charts.corners, charts.chart, charts.area, charts.number, options, least);
    };
    for(const double least : {0.2 * share, 0.9 * share, 0.97 * share}) {
      const Packing packing = pack_if_more(least);
      BOOST_REQUIRE((packing.status == Packing::DONE));
      BOOST_TEST(packing.covered_share > least);
      BOOST_TEST(packing.covered_share > 0.9 * share);
    }
    BOOST_TEST((pack_if_more(1.1 * share).status == Packing::TOO_MANY_CHARTS));
  }
}

BOOST_AUTO_TEST_SUITE_END()
