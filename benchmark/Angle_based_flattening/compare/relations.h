// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_RELATIONS_H
#define COMPARE_RELATIONS_H

#include "Results.h"

#include "../common/Table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace compare {

// What the paper says of two methods: a quotient of numbers that lies between bounds
struct Relation
{
  const char* text;
  const char* number;
  const char *left, *right;
  double least, most;
  std::size_t least_triangles; // of meshes of which the paper says so
};

inline const std::vector<Relation>& relations()
{
  constexpr double any = 1e300;
  static const std::vector<Relation> list = {
      {"ABF++ is as little distorted as ABF (Section 1)", "angular", "abf++", "abf", 0.998, 1.002, 0},
      {"So it is if Newton's method stops at a gradient of norm 1 (Section 4)", "angular", "paper-abf++",
       "abf++", 0.998, 1.01, 0},
      {"ABF++ is up to ten times faster than ABF (Tables I, II: 4 to 15 times)", "seconds", "abf",
       "paper-abf++", 4, any, 1000},
      {"So is our ABF++", "seconds", "abf", "abf++", 4, any, 1000},
      {"ABF in logarithms is slower than ABF (Section 2.2)", "seconds", "log-abf", "abf", 1, any, 1000},
      {"LSCM stretches more than ABF++ (Section 6.2)", "stretch", "lscm", "abf++", 1, any, 0},
      {"HLSCM stretches more than ABF++ (Table II: 3 to 120 times)", "stretch", "hlscm", "abf++", 1, any, 0},
      {"HLSCM stretches more than HABF++ (Tables II, III: 3 to 120 times)", "stretch", "hlscm", "habf++", 1,
       any, 0},
      {"It stretches ten times more (Section 6.1)", "stretch", "hlscm", "habf++", 10, any, 0},
      {"LSCM has more angular distortion than ABF++ (Table II, of HLSCM)", "angular", "lscm", "abf++", 1, any,
       0},
      {"Shear of ABF++ and HLSCM is alike (Table II: 0.75 to 2.3)", "principal_shear", "hlscm", "abf++", 0.4,
       2.5, 0},
      {"HABF++ stretches only little more than ABF++ (Table II: at most 8 %)", "stretch", "habf++", "abf++",
       0.9, 1.08, 0},
      {"HABF++ has somewhat more angular distortion (Table II: 1.3 to 2 times)", "angular", "habf++", "abf++",
       1, 2, 0},
      {"ABF++ is slower than HLSCM (Table II)", "seconds", "abf++", "hlscm", 1, any, 50000},
      {"HABF++ is faster than HLSCM (Tables II, III: 3 to 7 times)", "seconds", "hlscm", "habf++", 1, any,
       50000},
      {"HABF++ is ten times faster than ABF++ (Table II: 7 to 30 times)", "seconds", "abf++", "habf++", 7,
       any, 50000},
      {"Stretch minimization stretches less than ABF++ (Table II)", "stretch", "stretch", "abf++", 0, 1, 0},
      {"It has more angular distortion (Table II: 800 times)", "angular", "stretch", "abf++", 1, any, 0},
      {"It is slower (Tables I, II: 2 to 6 times)", "seconds", "stretch", "abf++", 1, any, 1000},
      {"MIPS stretches less than LSCM (Section 6.2)", "stretch", "mips", "lscm", 0, 1, 0},
      {"A fixed border costs angular distortion (Section 1.1)", "angular", "conformal", "lscm", 1, any, 0}};
  return list;
}

// How many triangles a method flips: none on any mesh, or some on one of them at least
struct Flip_relation
{
  const char* text;
  const char* method;
  bool flips;
  std::size_t least_triangles;
};

inline const std::vector<Flip_relation>& flip_relations()
{
  static const std::vector<Flip_relation> list = {
      {"ABF++ flips nothing (Section 4)", "abf++", false, 0},
      {"HABF++ flips nothing (Section 5)", "habf++", false, 0},
      {"MIPS flips nothing (Section 1.1)", "mips", false, 0},
      {"LSCM may flip", "lscm", true, 0},
      {"HLSCM may flip", "hlscm", true, 0},
      {"The unfolding of ABF breaks above 30,000 triangles (Section 4)", "abf", true, 30000}};
  return list;
}

namespace internal {

inline std::string verdict(const std::size_t seen, const std::size_t all)
{
  return all == 0 ? "not measured" : seen == all ? "yes" : seen == 0 ? "NO" : "on some";
}

inline std::vector<double> quotients(const Results& results, const Relation& relation)
{
  std::vector<double> quotients;
  for(const Mesh_results& mesh : results.meshes) {
    const double quotient =
        mesh.number(relation.left, relation.number) / mesh.number(relation.right, relation.number);
    if(mesh.triangles >= relation.least_triangles && !mesh.is_flat() && !std::isnan(quotient)) {
      quotients.push_back(quotient);
    }
  }
  return quotients;
}

inline std::string described(const Results& results, const Relation& relation)
{
  const std::string number = relation.number == std::string("seconds")           ? "time"
                             : relation.number == std::string("angular")         ? "angular distortion"
                             : relation.number == std::string("principal_shear") ? "principal shear"
                                                                                 : relation.number;
  return number + ", " + results.title(relation.left) + " / " + results.title(relation.right);
}

inline void add_relation(Table& table, const Results& results, const Relation& relation)
{
  std::vector<double> all = quotients(results, relation), finite;
  std::sort(all.begin(), all.end());
  std::size_t seen = 0;
  for(const double quotient : all) {
    seen += quotient >= relation.least && quotient <= relation.most;
    seen += std::isinf(quotient) && relation.most == 1e300;
    if(std::isfinite(quotient) && quotient > 0) {
      finite.push_back(quotient);
    }
  }
  std::vector<std::string> cells = {relation.text, described(results, relation)};
  for(const double number : all.empty()
                                ? std::vector<double>(3, geometric_mean({}))
                                : std::vector<double>{all.front(), geometric_mean(finite), all.back()}) {
    cells.push_back(cell("%.4g", number));
  }
  cells.push_back(std::to_string(seen) + " of " + std::to_string(all.size()));
  cells.push_back(verdict(seen, all.size()));
  table.add(cells);
}

inline void add_relation(Table& table, const Results& results, const Flip_relation& relation)
{
  std::vector<double> flips;
  std::size_t seen = 0;
  for(const Mesh_results& mesh : results.meshes) {
    const double number = mesh.number(relation.method, "flips");
    if(mesh.triangles >= relation.least_triangles && !std::isnan(number)) {
      flips.push_back(number);
      seen += (number > 0) == relation.flips;
    }
  }
  std::sort(flips.begin(), flips.end());
  table.add({relation.text, "flips of " + results.title(relation.method),
             flips.empty() ? "–" : count_cell(flips.front()), "–",
             flips.empty() ? "–" : count_cell(flips.back()),
             std::to_string(seen) + " of " + std::to_string(flips.size()),
             verdict(relation.flips && seen > 0 ? flips.size() : seen, flips.size())});
}

} // namespace internal

inline std::string relations_table(const Results& results)
{
  Table table(
      {"the paper says", "measured", "smallest", "geometric mean", "largest", "seen on meshes", "seen"}, 2);
  for(const Relation& relation : relations()) {
    internal::add_relation(table, results, relation);
  }
  for(const Flip_relation& relation : flip_relations()) {
    internal::add_relation(table, results, relation);
  }
  return table.text();
}

} // namespace compare

#endif // COMPARE_RELATIONS_H
