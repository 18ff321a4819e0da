// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OPTION_TABLE_H
#define FLATTEN_MESH_OPTION_TABLE_H

#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/options/option_table.h>

#include <boost/algorithm/string/replace.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace flatten_mesh {

namespace internal {

namespace po = boost::program_options;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace abf = CGAL::Texture_atlas::internal;

using Values = po::variables_map;

inline bool is_given(const Values& values, const std::string& option)
{
  return values.count(option) != 0 && !values[option].defaulted();
}

inline void check_name(const std::string& option, const std::string& name,
                       const std::vector<std::string>& known)
{
  if(std::find(known.begin(), known.end(), name) == known.end()) {
    throw Usage_error("--" + option + " is '" + name + "', and must be " + abf::Option_words{known}.text());
  }
}

// All options of the program: the name of each, where its value goes, which values it takes, and what it does. What the
// library has options for, its table describes.
class Option_table
{
public:
  // Begins a group of options under a heading.
  void begin(const std::string& heading) { m_groups.emplace_back(heading, 100, 60); }

  // Names of files and other texts, which are checked elsewhere
  template <class Value>
  void text(const std::string& names, Value& value, const std::string& placeholder, const std::string& help)
  {
    add(names, po::value(&value)->value_name(placeholder), help);
  }

  void text_with_default(const std::string& names, std::string& value, const std::string& placeholder,
                         const std::string& help)
  {
    add(names, po::value(&value)->value_name(placeholder)->default_value(value), help);
  }

  void word(const std::string& names, std::string& value, const std::vector<std::string>& words,
            const std::string& help)
  {
    text_with_default(names, value, "NAME", help);
    m_steps.push_back([name = last_name(), &value, words](const Values&) { check_name(name, value, words); });
  }

  template <class Number>
  void number(const std::string& names, Number& value, const std::string& placeholder,
              const abf::Option_range& range, const std::string& help)
  {
    text(names, value, placeholder, help);
    check_range(value, range);
  }

  template <class Number>
  void number_with_default(const std::string& names, Number& value, const std::string& placeholder,
                           const abf::Option_range& range, const std::string& help)
  {
    add(names, po::value(&value)->value_name(placeholder)->default_value(value), help);
    check_range(value, range);
  }

  void flag(const std::string& names, bool& value, const std::string& help)
  {
    add(names, po::bool_switch(&value), help);
  }

  // An option of the library, by the name of its member. `more` is what else the program has to say on it.
  template <class Options, class... Others>
  void of_library(const std::string& member, const std::string& placeholder, const std::string& more,
                  Options& options, Others&... others)
  {
    using abf::visit_options; // of parameterizers; others are found by their argument
    visit_options(options, [&](const std::string& name, auto& value, const auto& values,
                               const std::string& help) {
      if(name == member) {
        using Described = std::conditional_t<std::is_base_of_v<TA::Atlas_options, Options>, TA::Atlas_options,
                                             Options>; // their defaults depend on a purpose
        const std::string given = abf::text_of_default<Described>(name);
        const bool is_shown = given.find(':') == std::string::npos;
        add(flag_of(name), value_of_library(placeholder, value, is_shown ? given : "", values),
            with_flags(help) + (is_shown ? "" : ". " + given) + (more.empty() ? "" : ". " + more));
      }
    });
    take_of_library(member, options);
    (take_of_library(member, others), ...);
  }

  // Results do not depend on the last option.
  void changes_no_result() { m_unrecorded.insert(last_name()); }

  // Sets the options of the library that are given, and throws a `Usage_error` for a value out of its range.
  void take(const Values& values) const
  {
    for(const auto& step : m_steps) {
      step(values);
    }
  }

  bool is_recorded(const std::string& name) const { return m_unrecorded.count(name) == 0; }

  po::options_description description() const
  {
    po::options_description all;
    for(const po::options_description& group : m_groups) {
      all.add(group);
    }
    return all;
  }

  std::vector<std::string> names_of_last_group() const
  {
    std::vector<std::string> names;
    for(const auto& option : m_groups.back().options()) {
      names.push_back(option->long_name());
    }
    return names;
  }

private:
  static std::string flag_of(const std::string& member)
  {
    static const std::map<std::string, std::string> shorter = {{"separate_overlaps", "separate"},
                                                               {"isometric_charts", "isometric"},
                                                               {"equal_seam_lengths", "equal-seams"},
                                                               {"number_of_rotations", "rotations"},
                                                               {"quantization_bits", "quantize"}};
    const auto found = shorter.find(member);
    return found != shorter.end() ? found->second : boost::replace_all_copy(member, "_", "-");
  }

  // "`coarse_triangles`" becomes "--coarse-triangles".
  static std::string with_flags(const std::string& help)
  {
    std::string text;
    for(std::size_t begin = 0, i = 0; begin <= help.size(); ++i) {
      const std::size_t end = (std::min)(help.find('`', begin), help.size());
      const std::string part = help.substr(begin, end - begin);
      text += i % 2 == 0 ? part : "--" + flag_of(part);
      begin = end + 1;
    }
    return text;
  }

  void add(const std::string& names, po::value_semantic* value, const std::string& help)
  {
    m_groups.back().add_options()(names.c_str(), value, help.c_str());
  }

  std::string last_name() const { return m_groups.back().options().back()->long_name(); }

  template <class Number>
  void check_range(const Number& value, const abf::Option_range& range)
  {
    m_steps.push_back([name = last_name(), &value, range](const Values& values) {
      if(is_given(values, name)) {
        check(abf::wrong_value("--" + name, value, range));
      }
    });
  }

  static void check(const std::string& wrong)
  {
    if(!wrong.empty()) {
      throw Usage_error(wrong + "; see --help");
    }
  }

  // Without a placeholder, an option of the library is on if its name is given.
  template <class Member, class Kind>
  static po::value_semantic* value_of_library(const std::string& placeholder, const Member&,
                                              const std::string& shown, const Kind&)
  {
    if constexpr(std::is_same_v<Kind, abf::Option_range>) {
      using Number =
          std::conditional_t<std::is_same_v<Member, double> || std::is_same_v<Member, std::optional<double>>,
                             double, int>;
      auto* const value = po::value<Number>()->value_name(placeholder);
      return shown.empty() ? value : value->default_value(Number(std::stod(shown)), shown);
    } else {
      if(placeholder.empty()) {
        return po::bool_switch();
      }
      auto* const value = po::value<std::string>()->value_name(placeholder);
      return shown.empty() ? value : value->default_value(shown);
    }
  }

  template <class Options>
  void take_of_library(const std::string& member, Options& options)
  {
    m_steps.push_back([flag = last_name(), member, &options](const Values& given) {
      if(is_given(given, flag)) {
        using abf::visit_options; // of parameterizers; others are found by their argument
        visit_options(options, [&](const std::string& name, auto& value, const auto& values, const char*) {
          if(name == member) {
            set(flag, given[flag], value, values);
          }
        });
      }
    });
  }

  template <class Member>
  static void set(const std::string& flag, const po::variable_value& given, Member& member,
                  const abf::Option_range& range)
  {
    using Number = std::decay_t<decltype(std::optional(member).value())>;
    member = given.as<Number>();
    check(abf::wrong_value("--" + flag, member, range));
  }

  template <class Member>
  static void set(const std::string& flag, const po::variable_value& given, Member& member,
                  const abf::Option_words& known)
  {
    const std::string& word = given.as<std::string>();
    check_name(flag, word, known.words);
    member =
        static_cast<Member>(std::find(known.words.begin(), known.words.end(), word) - known.words.begin());
  }

  template <class Member>
  static void set(const std::string& flag, const po::variable_value& given, Member& member,
                  const abf::Option_switch&)
  {
    if(given.value().type() == typeid(bool)) {
      member = true;
    } else {
      check_name(flag, given.as<std::string>(), {"on", "off"});
      member = given.as<std::string>() == "on";
    }
  }

  std::vector<po::options_description> m_groups;
  std::vector<std::function<void(const Values&)>> m_steps;
  std::set<std::string> m_unrecorded;
};

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OPTION_TABLE_H
