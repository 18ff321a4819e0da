// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_RELAXED_MAP_H
#define ABF_BENCHMARK_RELAXED_MAP_H

#include "Map_energy.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>

#include <string>
#include <vector>

namespace ABF_benchmark {

// Our ABF++, the start of all relaxations.
inline bool flatten_by_abf_plus_plus(const Chart& chart, std::vector<Point_2>& uv, Run_report& report)
{
  const auto no_rounding = [](std::vector<Point_2>&) {};
  const auto start = abf::flatten_chart(chart, SMP::ABF_plus_plus_options(), Solver(), no_rounding);
  uv = start.uv;
  return start.succeeded() || fail(report, "no start: " + start.report.message);
}

// Minimizes an energy of the map, including its border, by Newton's method with a line search that lets no triangle
// flip. Starts from a valid map. The authors of these energies moved one vertex at a time; the minima are the same.
template <typename Energy>
struct Relaxed_map
{
  double tolerance = 1e-7; // stops when a step promises to lower the energy by less than this part of it
  int max_iterations = 500;

  // Starts from our ABF++.
  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    return flatten_by_abf_plus_plus(chart, uv, report) && relax(chart, uv, report);
  }

  // Starts from `uv`, which must have no flipped triangle.
  bool relax(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    Eigen::VectorXd x(2 * uv.size());
    for(std::size_t v = 0; v < uv.size(); ++v)
      x.segment<2>(2 * v) << uv[v].x(), uv[v].y();
    const bool converged = minimize(chart, x, report);
    for(std::size_t v = 0; v < uv.size(); ++v)
      uv[v] = Point_2(x[2 * v], x[2 * v + 1]);
    if(!finish(chart, uv, report) || !converged)
      return false;
    if(const std::size_t flips = abf::flipped_triangles(chart, uv).size())
      return fail(report, std::to_string(flips) + " triangles are too thin for coordinates in doubles");
    return true;
  }

private:
  bool minimize(const Chart& chart, Eigen::VectorXd& x, Run_report& report) const
  {
    Map_energy<Energy> energy(chart);
    abf::Symmetric_system<Solver> system{Solver()};
    Eigen::VectorXd gradient, step;
    report.energy = energy.value(x);
    for(; report.iterations < max_iterations; ++report.iterations) {
      if(!system.set_matrix(definite(energy.derivatives(x, gradient))) || !system.solve(-gradient, step))
        return fail(report, "a linear system was not solved");
      const double slope = gradient.dot(step);
      report.residual = -slope / 2 / report.energy;
      if(report.residual <= tolerance)
        return true;
      if(!search(energy, slope, step, x, report))
        return fail(report, "no part of a step lowers the energy");
    }
    return fail(report, "no convergence in " + std::to_string(max_iterations) + " steps");
  }

  // Motions of the plane, and similarities for some energies, do not change the energy. A small weight fixes them.
  static Eigen::SparseMatrix<double> definite(Eigen::SparseMatrix<double> hessian)
  {
    hessian.diagonal() *= 1 + 1e-9;
    return hessian;
  }

  static bool search(const Map_energy<Energy>& energy, double slope, const Eigen::VectorXd& step,
                     Eigen::VectorXd& x, Run_report& report)
  {
    // The energy is infinite where a triangle is flipped.
    for(double length = 1; length > 1e-12; length /= 2) {
      const Eigen::VectorXd next = x + length * step;
      const double value = energy.value(next);
      if(value <= report.energy + 1e-4 * length * slope) {
        x = next;
        report.energy = value;
        return true;
      }
    }
    return false;
  }
};

typedef Relaxed_map<MIPS_energy> MIPS;
typedef Relaxed_map<Stretch_energy> Stretch_minimizer;

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_RELAXED_MAP_H
