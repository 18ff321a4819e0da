// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef UNFOLDING_PLOT_H
#define UNFOLDING_PLOT_H

#include "Closing_errors.h"

#include "../common/plot.h"

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace unfolding {

// What gnuplot is told: one data block and one curve for each layout and tolerance.
inline std::string plot_script(const std::vector<Closing_errors>& results,
                               const std::vector<double>& tolerances)
{
  std::ostringstream data, curves;
  int block = 0;
  for(const double tolerance : tolerances)
    for(std::size_t kind = 0; kind < layout_titles.size(); ++kind, ++block) {
      data << "$block" << block << " << END\n";
      for(const Closing_errors& errors : results)
        if(errors.tolerance == tolerance)
          data << errors.triangles << " " << errors.layouts[kind].closing_error << "\n";
      data << "END\n";
      curves << (block == 0 ? "plot " : ", ") << "$block" << block << " with linespoints linecolor "
             << kind + 1 << " pointtype " << block / layout_titles.size() + 4 << " title '"
             << layout_titles[kind] << ", |grad F| <= " << tolerance << "'";
    }
  return data.str() +
         "set logscale xy\nset format '10^{%T}'\nset grid\nset key below maxcols 3\n"
         "set xlabel 'triangles'\nset ylabel 'largest closing error, relative to the triangle'\n" +
         curves.str() + "\n";
}

inline void plot(const std::vector<Closing_errors>& results, const std::vector<double>& tolerances,
                 const std::string& file)
{
  const std::string failure = benchmarks::plot(plot_script(results, tolerances), file, "800,600");
  if(!failure.empty())
    throw std::runtime_error("no plot: " + failure);
}

} // namespace unfolding

#endif // UNFOLDING_PLOT_H
