// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_PLOTS_H
#define COMPARE_PLOTS_H

#include "Results.h"
#include "growth.h"

#include "../common/format.h"
#include "../common/plot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace compare {

namespace internal {

// Gnuplot has eight colours of its own.
inline std::string colour(const std::size_t method)
{
  static const std::vector<const char*> colours = {"#d62728", "#ff9896", "#1f77b4", "#17becf", "#9467bd",
                                                   "#e377c2", "#8c564b", "#bcbd22", "#2ca02c", "#98df8a",
                                                   "#7f7f7f", "#ff7f0e", "#393b79", "#c49c94"};
  return colours[method % colours.size()];
}

inline std::string style(const std::size_t method)
{
  return "linecolor rgb '" + colour(method) + "' pointtype " + std::to_string(method % 13 + 1);
}

// Points of all meshes, and the fitted line of the resized ones
inline std::string times_script(const Results& results)
{
  std::ostringstream data, curves;
  for(std::size_t i = 0; i < results.methods.size(); ++i) {
    const Method_title& method = results.methods[i];
    data << "$method" << i << " << END\n";
    for(const Mesh_results& mesh : results.meshes) {
      const double seconds = mesh.number(method.name, "seconds");
      data << mesh.triangles << " " << (seconds > 0 ? format_number("%g", seconds) : "NaN") << "\n";
    }
    data << "END\n";
    const Growth growth = fit_growth(results, method.name);
    curves << (i == 0 ? "plot " : ", \\\n") << "$method" << i << " with points " << style(i) << " title '"
           << method.title << (growth.fitted() ? format_number(", n^{%.2f}", growth.exponent) : "") << "'";
    if(growth.fitted()) {
      curves << ", " << growth.factor << " * x**" << growth.exponent << " with lines linecolor rgb '"
             << colour(i) << "' notitle";
    }
  }
  return data.str() +
         "set logscale xy\nset format '10^{%T}'\nset grid\nset key below maxcols 3\n"
         "set xlabel 'faces'\nset ylabel 'seconds'\n" +
         curves.str() + "\n";
}

inline Results without_flat_meshes(Results results)
{
  const auto is_flat = [](const Mesh_results& mesh) { return mesh.is_flat(); };
  results.meshes.erase(std::remove_if(results.meshes.begin(), results.meshes.end(), is_flat),
                       results.meshes.end());
  return results;
}

inline std::string mesh_tics(const Results& results)
{
  std::string tics = "set xtics rotate by -40 (";
  for(std::size_t i = 0; i < results.meshes.size(); ++i) {
    tics += (i == 0 ? "\"" : ", \"") + results.meshes[i].title() + "\" " + std::to_string(i);
  }
  return tics + ") noenhanced\n";
}

// One diagram for each measure, the meshes beside each other. The excess of stretch is over the best value, which is 1.
inline std::string distortions_script(const Results& results)
{
  const std::vector<std::pair<std::string, std::string>> measures = {{"angular", "angular distortion"},
                                                                     {"principal_shear", "principal shear"},
                                                                     {"stretch", "L2 stretch - 1"}};
  std::ostringstream script;
  script << "set multiplot layout 3,1\nset logscale y\nset format y '10^{%T}'\nset grid\n"
            "set key outside right width -4\nset xrange [-0.5:"
         << results.meshes.size() << " - 0.5]\n"
         << mesh_tics(results);
  for(const auto& [name, title] : measures) {
    std::ostringstream curves;
    for(std::size_t i = 0; i < results.methods.size(); ++i) {
      script << "$" << name << i << " << END\n";
      for(std::size_t j = 0; j < results.meshes.size(); ++j) {
        const double number =
            results.meshes[j].number(results.methods[i].name, name) - (name == "stretch" ? 1 : 0);
        script << j << " " << (std::isfinite(number) && number > 0 ? format_number("%g", number) : "NaN")
               << "\n";
      }
      script << "END\n";
      curves << (i == 0 ? "plot $" : ", \\\n$") << name << i << " with linespoints linewidth 0.5 " << style(i)
             << " title '" << results.methods[i].title << "'";
    }
    script << "set ylabel '" << title << "'\n" << curves.str() << "\n";
  }
  return script.str() + "unset multiplot\n";
}

} // namespace internal

// Draws into the folder, and returns what the report says of it.
inline std::string draw_plots(const Results& results, const std::string& folder)
{
  const std::pair<const char*, std::string> failures[] = {
      {"time.svg", plot(internal::times_script(results), folder + "/time.svg", "900,900")},
      {"distortion.svg", plot(internal::distortions_script(internal::without_flat_meshes(results)),
                              folder + "/distortion.svg", "1200,1350")}};
  const std::string name_of_folder = std::filesystem::path(folder + "/").parent_path().filename().string();
  std::string text;
  for(const auto& [name, failure] : failures) {
    text += failure.empty() ? std::string("![") + name + "](" + name_of_folder + "/" + name + ")\n"
                            : std::string("There is no ") + name + ": " + failure + ".\n";
  }
  return text;
}

} // namespace compare

#endif // COMPARE_PLOTS_H
