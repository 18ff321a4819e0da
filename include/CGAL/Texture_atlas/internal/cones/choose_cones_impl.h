// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Turns the charges of cones into angles that are possible: multiples of a quantum if asked for, for example for
// patterns that a quarter turn does not change, with the total that topology demands. Included by `choose_cones.h`, or
// by the source file of the compiled library.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/cones/choose_cones.h>
#include <CGAL/Texture_atlas/internal/cones/cone_charges.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The charge of a cone, in quanta: a full turn minus its angle, with its bounds
struct Quantized_charge
{
  double wanted;
  int least, largest;
};

// Rounds charges to whole numbers between the bounds: each to the nearest, or, given their total, those with the
// largest remainders up. Returns nothing if this is not possible.
inline std::optional<std::vector<int>> round_charges(const std::vector<Quantized_charge>& charges,
                                                     const std::optional<int>& total)
{
  std::vector<int> rounded;
  int missing = total.value_or(0);
  for(const Quantized_charge& charge : charges) {
    if(charge.least > charge.largest)
      return std::nullopt;
    const double whole = total ? std::floor(charge.wanted) : std::round(charge.wanted);
    rounded.push_back(static_cast<int>(
        std::clamp(whole, static_cast<double>(charge.least), static_cast<double>(charge.largest))));
    missing -= rounded.back();
  }
  while(total && missing != 0) {
    const int step = missing > 0 ? 1 : -1;
    int best = -1;
    double best_remainder = 0;
    for(std::size_t i = 0; i < charges.size(); ++i) {
      const int next = rounded[i] + step;
      const double remainder = step * (charges[i].wanted - rounded[i]);
      if(next >= charges[i].least && next <= charges[i].largest && (best < 0 || remainder > best_remainder)) {
        best = static_cast<int>(i);
        best_remainder = remainder;
      }
    }
    if(best < 0)
      return std::nullopt;
    rounded[best] += step;
    missing -= step;
  }
  return rounded;
}

// Chooses cones, and gives them angles that are possible.
class Cone_chooser
{
public:
  Cone_chooser(const Chart& surface, std::size_t number_of_cones, const Cone_options& options,
               const Linear_solvers& solvers)
      : m_surface(surface), m_number_of_cones(number_of_cones), m_options(options),
        m_solution(surface, solvers), m_total(m_solution.total()), m_valence(surface.points.size(), 0)
  {
    for(int v : surface.vertex)
      ++m_valence[v];
  }

  Chosen_cones run()
  {
    if(!m_solution.choose(m_number_of_cones) ||
       (m_options.angles == Cone_angles::LEAST_SQUARES && !m_solution.balance()))
      return unsolved();
    m_cones = m_solution.cones();
    m_charges.assign(m_solution.charges().begin(), m_solution.charges().end());
    if(m_options.angle_multiple > 0 && !round())
      return failure(Diagnosis::INFEASIBLE_ANGLE_SUMS, "no multiples of the angle " +
                                                           std::to_string(m_options.angle_multiple) +
                                                           " are possible at these cones: take more cones");
    Chosen_cones result;
    result.vertices = m_cones;
    for(double charge : m_charges)
      result.angles.push_back(2 * pi - charge);
    complete_total(result.angles);
    if(m_options.angles == Cone_angles::FREE)
      result.angles.assign(m_cones.size(), Surface_mesh_parameterization::free_cone_angle);
    else
      check(result);
    if(result.status != Diagnosis::NOTHING_WRONG)
      return result;
    const std::optional<double> stretch = m_solution.stretch(m_cones, m_charges);
    if(!stretch)
      return unsolved();
    result.predicted_stretch = *stretch;
    return result;
  }

private:
  bool is_closed() const { return m_surface.borders.empty(); }

  static Chosen_cones failure(Diagnosis diagnosis, const std::string& message)
  {
    Chosen_cones result;
    result.status = diagnosis;
    result.message = message;
    return result;
  }

  static Chosen_cones unsolved()
  {
    return failure(Diagnosis::LINEAR_SYSTEM_FAILED,
                   "the linear system that predicts the scale could not be solved");
  }

  // Rounds the charges to multiples of the quantum, and drops cones without charge. Returns whether that is possible.
  bool round()
  {
    const int turn = quanta_of_turn(m_options.angle_multiple);
    const double quantum = 2 * pi / turn;
    std::vector<Quantized_charge> wanted;
    for(std::size_t i = 0; i < m_cones.size(); ++i) {
      // an angle of at least one quantum, and of less than pi for each triangle
      const int most = (m_valence[m_cones[i]] * turn - 1) / 2;
      wanted.push_back({m_charges[i] / quantum, turn - most, turn - 1});
    }
    std::optional<int> total;
    if(is_closed())
      total = euler_characteristic(m_surface) * turn;
    const std::optional<std::vector<int>> rounded = round_charges(wanted, total);
    if(!rounded)
      return false;
    std::vector<int> cones;
    std::vector<double> charges;
    for(std::size_t i = 0; i < m_cones.size(); ++i)
      if((*rounded)[i] != 0) {
        cones.push_back(m_cones[i]);
        charges.push_back((*rounded)[i] * quantum);
      }
    m_cones = std::move(cones);
    m_charges = std::move(charges);
    return true;
  }

  // On a closed surface, the largest angle is corrected by the rounding error of the total.
  void complete_total(std::vector<double>& angles) const
  {
    if(!is_closed() || angles.empty())
      return;
    const double sum = std::accumulate(angles.begin(), angles.end(), 0.);
    *std::max_element(angles.begin(), angles.end()) +=
        2 * pi * static_cast<double>(angles.size()) - m_total - sum;
  }

  void check(Chosen_cones& result) const
  {
    std::ostringstream message;
    if(is_closed() && m_cones.empty() && m_total != 0)
      message << "a closed surface of this genus needs cones, but there is none";
    for(std::size_t i = 0; i < result.vertices.size(); ++i) {
      const int v = result.vertices[i], triangles = m_valence[v];
      if(result.angles[i] > 0 && result.angles[i] < triangles * pi)
        continue;
      if(result.offending_vertices.empty())
        message << "the cone at " << vertex_text(m_surface, v) << " would have the angle " << result.angles[i]
                << ", which must be above 0 and below " << triangles << " pi: try another number of cones";
      result.offending_vertices.push_back(v);
    }
    result.message = message.str();
    if(result.message.empty())
      return;
    result.status = Diagnosis::INFEASIBLE_ANGLE_SUMS;
    result.vertices.clear();
    result.angles.clear();
  }

  const Chart& m_surface;
  const std::size_t m_number_of_cones;
  const Cone_options& m_options;
  Cone_charges m_solution;
  const double m_total;       // of the charges of a closed surface
  std::vector<int> m_valence; // of each vertex
  std::vector<int> m_cones;
  std::vector<double> m_charges;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Chosen_cones choose_cones(const Chart& surface,
                                                             std::size_t number_of_cones,
                                                             const Cone_options& options,
                                                             const Linear_solvers& solvers)
{
  return Cone_chooser(surface, number_of_cones, options, solvers).run();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_IMPL_H
