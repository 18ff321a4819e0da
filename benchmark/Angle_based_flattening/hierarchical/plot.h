// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_PLOT_H
#define HIERARCHICAL_PLOT_H

#include <cstdio>
#include <cstdlib>
#include <string>

namespace hierarchical {

// Lets gnuplot draw a script to an SVG file. Returns why there is no file, or nothing if there is one.
inline std::string plot(const std::string& script, const std::string& file)
{
  if(std::system("command -v gnuplot > /dev/null") != 0) {
    return "gnuplot is not installed";
  }
  FILE* const gnuplot = popen("gnuplot", "w");
  if(gnuplot == nullptr) {
    return "gnuplot cannot be started";
  }
  const std::string text =
      "set terminal svg size 900,360 background 'white'\nset output '" + file + "'\n" + script;
  std::fputs(text.c_str(), gnuplot);
  return pclose(gnuplot) == 0 ? "" : "gnuplot failed";
}

} // namespace hierarchical

#endif // HIERARCHICAL_PLOT_H
