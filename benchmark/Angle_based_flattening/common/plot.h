// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_PLOT_H
#define BENCHMARKS_COMMON_PLOT_H

#include <cstdio>
#include <cstdlib>
#include <string>

namespace benchmarks {

// Lets gnuplot draw a script to an SVG file of that size. Returns why there is no file, or nothing if there is one.
inline std::string plot(const std::string& script, const std::string& file,
                        const std::string& size = "900,360")
{
  if(std::system("command -v gnuplot > /dev/null") != 0) {
    return "gnuplot is not installed (scripts/install-dependencies gnuplot-nox)";
  }
  if(file.find('\'') != std::string::npos) {
    return "the name of the file has quotes in it";
  }
  FILE* const gnuplot = popen("gnuplot", "w");
  if(gnuplot == nullptr) {
    return "gnuplot cannot be started";
  }
  const std::string text =
      "set terminal svg size " + size + " background 'white'\nset output '" + file + "'\n" + script;
  std::fputs(text.c_str(), gnuplot);
  return pclose(gnuplot) == 0 ? "" : "gnuplot failed";
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_PLOT_H
