// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of all options: for each, its name, the values that it may have, and what it does. The checks of the
// library, options and help of the program, and keywords of the Python module are made of this table.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_OPTION_TABLE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_OPTION_TABLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>

#include <cstddef>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

inline std::string text_of_option(double value)
{
  char digits[32];
  std::snprintf(digits, sizeof(digits), "%.10g", value);
  return digits;
}

// The numbers that an option may have. Without a value, its default holds.
struct Option_range
{
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  bool has_least = true, has_most = true; // whether these two are in the range

  template <class Number>
  bool contains(const std::optional<Number>& number) const
  {
    return !number || contains(*number);
  }

  template <class Number>
  bool contains(Number number) const
  {
    const auto value = static_cast<double>(number);
    return (has_least ? value >= least : value > least) && (has_most ? value <= most : value < most);
  }

  template <class Number>
  std::string value_text(const Number& number) const
  {
    return text_of_option(static_cast<double>(number));
  }

  template <class Number>
  std::string value_text(const std::optional<Number>& number) const
  {
    return number ? value_text(*number) : "";
  }

  // "from 0 to 1", "at least 0", "above 0 and below 1", "finite and at least 0"
  std::string text() const
  {
    const bool is_bounded = most < std::numeric_limits<double>::infinity();
    if(is_bounded && has_least && has_most)
      return "from " + text_of_option(least) + " to " + text_of_option(most);
    return (is_bounded || has_most ? "" : "finite and ") + std::string(has_least ? "at least " : "above ") +
           text_of_option(least) +
           (is_bounded ? (has_most ? " and at most " : " and below ") + text_of_option(most) : "");
  }
};

// The words for the values of an enumeration, in their order
struct Option_words
{
  std::vector<std::string> words;

  template <class Value>
  bool contains(Value value) const
  {
    return static_cast<std::size_t>(value) < words.size();
  }

  template <class Value>
  std::string value_text(Value value) const
  {
    return contains(value) ? words[static_cast<std::size_t>(value)] : std::to_string(static_cast<int>(value));
  }

  std::string text() const
  {
    std::string result;
    for(const std::string& word : words)
      result += (result.empty() ? "one of " : ", ") + word;
    return result;
  }
};

// On or off. Without either, it depends on other options.
struct Option_switch
{
  template <class Value>
  bool contains(const Value&) const
  {
    return true;
  }

  std::string value_text(const std::optional<bool>& value) const
  {
    return value ? (*value ? "on" : "off") : "";
  }

  std::string text() const { return "on or off"; }
};

inline constexpr double no_bound = std::numeric_limits<double>::infinity();
inline constexpr Option_range finite_numbers{0, no_bound, true, false};
inline constexpr Option_range numbers_of_threads{0, 1024};
inline constexpr Option_range any_count{0, double((std::numeric_limits<int>::max)())};

// `visit(name, member, values, text)` is called for each option. In texts, names of options are in backquotes.

template <class Visit>
void visit_options(Flattening_options& options, const Visit& visit)
{
  visit("barrier", options.barrier, finite_numbers,
        "weight of the term that keeps angles away from zero; 0 is exactly the energy of the ABF++ paper");
  visit("threads", options.threads, numbers_of_threads,
        "number of threads; 0: one on each processor. It never changes the result");
  visit(
      "holes", options.holes, Option_words{{"solve", "fill", "refuse"}},
      "solve: holes take the shape that changes angles least. fill: soft triangles cover the holes while the "
      "surface is flattened, so that their borders stay simple. refuse: a surface with holes is an error");
  visit("fallbacks", options.fallbacks, Option_switch(),
        "whether something else may take the place of the method if it fails; otherwise, that is an error");
  visit("injective", options.injective, Option_switch(),
        "no two triangles of the map overlap, and no seam is added: the border is kept from touching itself, "
        "and "
        "angles change more. Holes are filled during the computation");
  visit("area_weight", options.area_weight, Option_range{0, 1},
        "how much injective maps preserve areas: 0 not at all, 1 as isometric as possible");
  visit("clearance", options.clearance, Option_range{0, 1, false},
        "the distance below which parts of the border of an injective map repel each other, in lengths of "
        "their "
        "edges");
  visit("pin_weight", options.pin_weight, Option_range{0, no_bound, false},
        "how much more than two pins count against angles; inf: they are exactly at their positions");
  visit("time_limit", options.time_limit, Option_range{}, "the longest time, in seconds");
}

template <class Visit>
void visit_options(ABF_plus_plus_options& options, const Visit& visit)
{
  visit_options(static_cast<Flattening_options&>(options), visit);
  // Rounding errors alone violate the constraints by 1e-14, even on meshes of few triangles.
  visit("tolerance", options.tolerance, Option_range{1e-14, no_bound, true, false},
        "largest violation of a constraint at a vertex");
  visit("energy_tolerance", options.energy_tolerance, Option_range{0, no_bound, false},
        "the last step lowers the energy by less than this fraction");
  visit("max_iterations", options.max_iterations, any_count, "largest number of Newton steps");
  visit("step", options.step, Option_words{{"newton", "sqp"}},
        "newton: full Newton steps. sqp: without the constraints' second derivatives, as in the paper");
  visit("linear_solver", options.linear_solver, Option_words{{"iterative", "direct"}},
        "of a Newton step. iterative: preconditioned by small factors. direct: as a whole, as in the paper");
  visit("layout", options.layout, Option_words{{"auto", "exact", "least-squares"}},
        "how coordinates are computed from angles. exact: along the border, then one Laplace equation; for "
        "charts "
        "with one border. least-squares: as in the paper. auto: exact where possible");
  visit("equal_seam_lengths", options.equal_seam_lengths, Option_switch(),
        "whether both sides of each edge on a seam get equal lengths");
  visit("warm_start", options.warm_start, Option_switch(),
        "whether a call starts from the angles of the last one");
}

template <class Visit>
void visit_options(Hierarchical_options& options, const Visit& visit)
{
  visit_options(static_cast<Flattening_options&>(options), visit);
  visit("simplification_rate", options.simplification_rate, Option_range{0, 1, false, false},
        "part of the vertices that the hierarchical method removes");
  visit("coarse_triangles", options.coarse_triangles, any_count,
        "number of triangles of the coarse chart; if not 0, it replaces `simplification_rate`");
  visit("extreme_angle", options.extreme_angle, Option_range{},
        "coarsening makes no angle smaller than this one, in radians");
  // More sweeps take time and change nothing.
  visit("sweeps", options.sweeps, Option_range{0, 1000},
        "sweeps of relaxation on each level of the hierarchical method");
  visit("angle_sweeps", options.angle_sweeps, Option_range{0, 1000},
        "final sweeps of the hierarchical method that lower the energy of the direct method");
  visit("energy_tolerance", options.energy_tolerance, Option_range{0, 1, true, false},
        "final sweeps end when one lowers the energy by less than this fraction");
  visit("max_retries", options.max_retries, any_count,
        "how often a coarse chart that cannot be flattened is replaced by a finer one");
  visit("polish", options.polish, Option_switch(),
        "lower the distortion of the hierarchical method to that of the direct method");
}

// "block is 0, and must be from 1 to 1024"; empty if the option may have this value
template <class Value, class Values>
std::string wrong_value(const std::string& name, const Value& value, const Values& values)
{
  return values.contains(value) ? std::string()
                                : name + " is " + values.value_text(value) + ", and must be " + values.text();
}

// The first option out of its range, or nothing
template <class Options>
std::string option_out_of_range(Options options)
{
  std::string wrong;
  visit_options(options, [&](const char* name, const auto& value, const auto& values, const char*) {
    if(wrong.empty())
      wrong = wrong_value(name, value, values);
  });
  return wrong;
}

// The value of an option as a text; empty if it has none
template <class Options>
std::string text_of_value(Options options, const std::string& wanted)
{
  std::string text;
  visit_options(options, [&](const std::string& name, const auto& value, const auto& values, const char*) {
    if(name == wanted)
      text = values.value_text(value);
  });
  return text;
}

template <class Options>
std::string text_of_default(const std::string& name)
{
  return text_of_value(Options(), name);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_OPTION_TABLE_H
