// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the benchmark `compare` makes of its figures.

#include <boost/test/unit_test.hpp>

#include "../../benchmark/Angle_based_flattening/compare/csv.h"
#include "../../benchmark/Angle_based_flattening/compare/growth.h"
#include "../../benchmark/Angle_based_flattening/compare/relations.h"
#include "../../benchmark/Angle_based_flattening/compare/tables.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_comparison)

using namespace compare;

namespace {

// Meshes of 1000, 4000, 16000 triangles; two methods, of which the second is given.
Results results_of(const std::string& number, const std::vector<double>& first,
                   const std::vector<double>& second)
{
  Results results = {{{"abf++", "ABF++"}, {"lscm", "LSCM"}}, {}};
  std::size_t triangles = 1000;
  for(std::size_t i = 0; i < first.size(); ++i, triangles *= 4) {
    results.meshes.push_back({"mesh", true, triangles, {}});
    results.meshes.back().measurements["abf++"] = {"", {{number, first[i]}}};
    results.meshes.back().measurements["lscm"] = {"", {{number, second[i]}}};
  }
  return results;
}

// The row of a table with that text in it
std::string row(const std::string& table, const std::string& text)
{
  const std::size_t found = table.find(text);
  BOOST_TEST_REQUIRE(found != std::string::npos);
  const std::size_t begin = table.rfind('\n', found) + 1;
  return table.substr(begin, table.find('\n', found) - begin);
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

} // namespace

BOOST_AUTO_TEST_CASE(power_laws_are_fitted)
{
  const Results results = results_of("seconds", {1, 8, 64}, {2, 3, nothing});
  const Growth growth = fit_growth(results, "abf++");
  BOOST_TEST_REQUIRE(growth.fitted());
  BOOST_TEST(std::abs(growth.exponent - 1.5) <= 1e-12);
  BOOST_TEST(std::abs(growth.seconds(4000) - 8) <= 1e-10);
  BOOST_TEST(!fit_growth(results, "lscm").fitted());
}

BOOST_AUTO_TEST_CASE(relations_tell_on_how_many_meshes_they_are_seen)
{
  const auto seen = [](const std::vector<double>& abf, const std::vector<double>& lscm) {
    return row(relations_table(results_of("stretch", abf, lscm)), "LSCM stretches more than ABF++");
  };
  BOOST_TEST(ends_with(seen({1, 1, 1}, {2, 4, 8}), "| 2 | 4 | 8 | 3 of 3 | yes |"));
  BOOST_TEST(ends_with(seen({1, 2, 1}, {2, 1, 1}), "| 0.5 | 1 | 2 | 2 of 3 | on some |"));
  BOOST_TEST(ends_with(seen({2, 4}, {1, 1}), "| 0 of 2 | NO |"));
  BOOST_TEST(ends_with(seen({1, 1}, {3, infinity}), "| 3 | 3 | inf | 2 of 2 | yes |"));
  BOOST_TEST(ends_with(seen({nothing}, {1}), "| – | – | – | 0 of 0 | not measured |"));
}

BOOST_AUTO_TEST_CASE(flips_are_counted)
{
  const std::string table = relations_table(results_of("flips", {0, 1}, {0, 7}));
  BOOST_TEST(ends_with(row(table, "ABF++ flips nothing"), "| 0 | – | 1 | 1 of 2 | on some |"));
  BOOST_TEST(ends_with(row(table, "| LSCM may flip"), "| 0 | – | 7 | 1 of 2 | yes |"));
}

BOOST_AUTO_TEST_CASE(ratios_are_geometric_means_of_what_is_finite)
{
  const Results results = results_of("stretch", {1, 4, 1}, {2, 1, infinity});
  const std::string table = ratios_table(results, "lscm");
  BOOST_TEST(row(table, "| ABF++") == "| ABF++ | 0 | – | – | – | 1.41 | 2 | – |");
}

BOOST_AUTO_TEST_CASE(failures_are_told)
{
  Results results = results_of("seconds", {1}, {1});
  results.meshes[0].measurements["lscm"] = failed_measurement("no solution");
  BOOST_TEST(ends_with(row(distortions_table(results, 0, 5000), "| LSCM"), "| FAILED: no solution |"));
  results.meshes[0].measurements["lscm"] = failed_measurement("stopped: took longer than 8 s");
  BOOST_TEST(
      ends_with(row(distortions_table(results, 0, 5000), "| LSCM"), "| stopped: took longer than 8 s |"));
  BOOST_TEST(ends_with(csv(results), "\"stopped: took longer than 8 s\"\n"));
}

BOOST_AUTO_TEST_SUITE_END()
