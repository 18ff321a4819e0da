// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves maps to their pins: two by a similarity, more by `layout/pinned_layout.h`, stiffer where triangles flip
// otherwise. `run_parameterizer.h` calls it by `flatten_chart.h`. Certificates and reports are those of the moved map.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PIN_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PIN_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/pinned_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A map on its way to its pins
class Map_with_pins
{
  typedef std::vector<Chart::Point_2> Layout;

public:
  Map_with_pins(const Chart& chart, const Flattening_options& options, const Linear_solvers& solvers,
                const Layout& free)
      : m_chart(chart), m_options(options), m_solvers(solvers), m_free(complex_numbers(free))
  {
    normalize();
    std::vector<Complex> points, positions;
    for(const Chart::Pin& pin : chart.pins) {
      points.push_back(m_free[pin.vertex]);
      positions.emplace_back(pin.position.x(), pin.position.y());
    }
    fit = fit_similarity(points, positions);
    if(chart.pins.size() == 1)
      fit.similarity.factor = m_size;
    for(const Complex& position : positions)
      m_positions.push_back(fit.similarity.inverse(position));
  }

  // Returns `false` if the linear solver fails. Otherwise `uv` is the moved map, which may be invalid if there are more
  // than two pins.
  bool move()
  {
    m_moved = m_free;
    if(m_chart.pins.size() <= 2) {
      place();
      return true;
    }
    // Angles change least with the first one; the others spread what is asked of a few triangles.
    for(double stiffness : {1e-4, 1e-3, 1e-2}) {
      std::optional<std::vector<Complex>> z =
          Pinned_layout(m_chart, m_free, stiffness, m_options.pin_weight).solve(m_positions, m_solvers);
      if(!z)
        return false;
      m_moved = std::move(*z);
      place();
      if(is_valid(uv))
        break;
    }
    return true;
  }

  bool is_valid(const Layout& map) const
  {
    return is_valid_map(m_chart, map) && (!m_options.injective || is_border_simple(m_chart, map));
  }

  // What is reported, of the coordinates after rounding
  void report(const Layout& rounded, Flattening_report& report) const
  {
    report.pins = static_cast<int>(m_chart.pins.size());
    report.largest_pin_distance = 0;
    for(const Chart::Pin& pin : m_chart.pins) {
      const auto way = rounded[pin.vertex] - pin.position;
      report.largest_pin_distance = (std::max)(report.largest_pin_distance, std::hypot(way.x(), way.y()));
    }
    double sum = 0;
    report.largest_pin_angle_change = 0;
    for(int c = 0; c < m_chart.number_of_corners(); ++c) {
      const double change = std::abs(angle(m_moved, c) - angle(m_free, c));
      sum += change;
      report.largest_pin_angle_change = (std::max)(report.largest_pin_angle_change, change);
    }
    report.mean_pin_angle_change = sum / m_chart.number_of_corners();
  }

  // The pins to blame: all if they are mirrored, otherwise the one that is farthest from where the map without change
  // has it
  std::vector<int> offenders() const
  {
    std::vector<int> vertices;
    double largest = -1;
    for(std::size_t i = 0; i < m_positions.size(); ++i) {
      const int v = m_chart.pins[i].vertex;
      const double distance = std::abs(m_positions[i] - m_free[v]);
      if(distance > largest && !fit.is_mirrored)
        vertices.clear();
      if(distance > largest || fit.is_mirrored)
        vertices.push_back(v);
      largest = (std::max)(largest, distance);
    }
    return vertices;
  }

  Layout uv;
  Fit fit;

private:
  // Squares of coordinates must neither overflow nor vanish.
  void normalize()
  {
    double size = 0;
    const Complex origin = m_free.front();
    for(Complex& z : m_free) {
      z -= origin;
      size = (std::max)(size, std::abs(z));
    }
    m_size = power_of_two(size);
    for(Complex& z : m_free)
      z /= m_size;
  }

  void place()
  {
    uv.clear();
    for(const Complex& z : m_moved) {
      const Complex p = fit.similarity(z);
      uv.emplace_back(p.real(), p.imag());
    }
    if(m_chart.pins.size() <= 2 || std::isinf(m_options.pin_weight))
      for(const Chart::Pin& pin : m_chart.pins)
        uv[pin.vertex] = pin.position;
  }

  double angle(const std::vector<Complex>& z, int c) const
  {
    const Complex p = z[m_chart.vertex[c]];
    return std::abs(std::arg((z[m_chart.edge_target(c)] - p) * std::conj(z[m_chart.edge_source(c)] - p)));
  }

  const Chart& m_chart;
  const Flattening_options& m_options;
  const Linear_solvers& m_solvers;
  std::vector<Complex> m_free;      // the map without pins, of about the size 1
  std::vector<Complex> m_moved;     // in the same frame
  std::vector<Complex> m_positions; // of the pins, in the same frame
  double m_size = 1;
};

// Says why a map with pins is not valid.
inline void fail_with_pins(const Chart& chart, const Flattening_options& options, const Map_with_pins& map,
                           const Certificate& certificate, const std::vector<Chart::Point_2>& rounded,
                           Flattening_report& report)
{
  const std::string defect =
      certificate.is_valid() ? describe_touching_edges(chart, rounded) : describe_invalid(chart, certificate);
  if(map.is_valid(map.uv) || chart.pins.size() <= 2) {
    fail(report, Diagnosis::PRECISION_EXCEEDED,
         "the map is valid, but with the pins at their positions and rounded it has " + defect);
    return;
  }
  std::string message = "with the pins at their positions the map has " + defect;
  if(map.fit.is_mirrored)
    message += "; a mirrored map would be nearer to these positions";
  else if(std::isinf(options.pin_weight))
    message += "; with a finite Flattening_options::pin_weight they may give way";
  fail(report, Diagnosis::INFEASIBLE_PINS, message);
}

template <typename Report>
void pin_any_map(const Chart& chart, const Flattening_options& options, const Linear_solvers& solvers,
                 Rounding round, Flattening<Report>& result)
{
  Map_with_pins map(chart, options, solvers, result.uv);
  {
    const Stage stage(options.visitor, Flattening_visitor::LAYOUT, result.report.seconds.layout);
    if(!map.move()) {
      fail(result.report, Diagnosis::LINEAR_SYSTEM_FAILED,
           "the linear system of the layout with pins could not be solved");
      return;
    }
  }
  const Stage stage(options.visitor, Flattening_visitor::CERTIFY, result.report.seconds.certify);
  result.uv = map.uv;
  round(result.uv);
  Certificate certificate = certify(chart, result.uv);
  take_certificate(certificate, result.report);
  map.report(result.uv, result.report);
  result.report.injective = options.injective && certificate.is_valid() && certificate.border_is_simple;
  if(!certificate.is_valid() || (options.injective && !certificate.border_is_simple)) {
    fail_with_pins(chart, options, map, certificate, result.uv, result.report);
    result.offending_vertices = map.offenders();
  }
  result.invalid = std::move(certificate.invalid);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void pin_map(const Chart& chart, const Flattening_options& options,
                                                const Linear_solvers& solvers, Rounding round,
                                                Flattening<ABF_plus_plus_report>& result)
{
  pin_any_map(chart, options, solvers, round, result);
  report_seams(chart, result.uv, result.report);
  report_prescribed_angles(chart, result.uv, result.report);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void pin_map(const Chart& chart, const Flattening_options& options,
                                                const Linear_solvers& solvers, Rounding round,
                                                Flattening<Hierarchical_report>& result)
{
  pin_any_map(chart, options, solvers, round, result);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PIN_MAP_H
