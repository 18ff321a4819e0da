// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_CHOOSE_CONES_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_CHOOSE_CONES_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/cones/choose_cones.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/cones/growing_cholesky.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/cones/round_charges.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/cones/scale_response.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/log_scale.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Where the log scale varies no more than that, there is nothing to choose.
inline constexpr double least_log_scale = 1e-9;

// Chooses cones, each where the scale that the others leave is farthest from 1. The charge of a cone is what it lacks of a full turn.
class Cone_chooser
{
public:
  Cone_chooser(const Chart& surface, const Cone_options& options, const Linear_solvers& solvers)
      : m_surface(surface), m_options(options), m_log_scale(surface, solvers),
        m_response(surface, m_log_scale, solvers), m_total(2 * pi * euler_characteristic(surface)),
        m_curvature(Eigen::Map<const Eigen::VectorXd>(m_log_scale.defects().data(), size())),
        m_area(Eigen::Map<const Eigen::VectorXd>(m_log_scale.areas().data(), size())), m_valence(size(), 0)
  {
    for(int v : surface.vertex)
      ++m_valence[v];
  }

  Chosen_cones run()
  {
    if(!choose() || !find_charges())
      return failure(Cone_report::LINEAR_SYSTEM_FAILED,
                     "the linear system that predicts the scale could not be solved");
    if(m_options.quantum > 0 && !round())
      return failure(Cone_report::INFEASIBLE_ANGLES,
                     "no multiples of the angle " + std::to_string(m_options.quantum) +
                         " are possible at these cones: more cones are needed");
    Chosen_cones result;
    result.vertices = m_cones;
    for(double charge : m_charges)
      result.angles.push_back(2 * pi - charge);
    complete_total(result.angles);
    if(m_options.are_free)
      result.angles.assign(m_cones.size(), free_cone_angle);
    else
      check(result);
    if(result.diagnosis == Cone_report::NOTHING_WRONG) {
      const std::optional<Eigen::VectorXd> u = scale();
      if(!u)
        return failure(Cone_report::LINEAR_SYSTEM_FAILED,
                       "the linear system that predicts the scale could not be solved");
      result.predicted_stretch = m_log_scale.stretch({u->begin(), u->end()});
    }
    return result;
  }

private:
  int size() const { return m_surface.number_of_vertices(); }
  int number_of_cones() const { return static_cast<int>(m_cones.size()); }
  bool is_closed() const { return m_surface.borders.empty(); }

  static int euler_characteristic(const Chart& surface)
  {
    const auto border_edges = std::count(surface.opposite.begin(), surface.opposite.end(), -1);
    return surface.number_of_vertices() - (surface.number_of_corners() + static_cast<int>(border_edges)) / 2 +
           surface.number_of_triangles();
  }

  static Chosen_cones failure(Cone_report::Diagnosis diagnosis, const std::string& message)
  {
    Chosen_cones result;
    result.diagnosis = diagnosis;
    result.message = message;
    return result;
  }

  // Returns `false` if the linear solver fails, as the following functions do.
  bool choose()
  {
    std::optional<Eigen::VectorXd> u = m_response(-m_curvature);
    if(!u)
      return false;
    m_base = *u;
    if(is_closed())
      u = scale_without_cones();
    while(u && m_cones.size() < m_options.number_of_cones) {
      int cone = -1;
      for(int v = 0; v < size(); ++v)
        if(is_free(v) && (cone < 0 || std::abs((*u)[v]) > std::abs((*u)[cone])))
          cone = v;
      if(cone < 0 || std::abs((*u)[cone]) <= least_log_scale)
        return true;
      if(!add(cone))
        return false;
      u = scale();
    }
    return u.has_value();
  }

  bool is_free(int v) const
  {
    return m_surface.interior[v] >= 0 && std::find(m_cones.begin(), m_cones.end(), v) == m_cones.end();
  }

  // That of a closed surface to one of constant curvature, away from its mean
  std::optional<Eigen::VectorXd> scale_without_cones()
  {
    if(!(m_log_scale.total_area() > 0))
      return m_base;
    std::optional<Eigen::VectorXd> u =
        m_response(m_curvature.sum() / m_log_scale.total_area() * m_area - m_curvature);
    if(u)
      u->array() -= m_area.dot(*u) / m_log_scale.total_area();
    return u;
  }

  // The scale that the cones have with their charges, but for a constant on a closed surface
  std::optional<Eigen::VectorXd> scale()
  {
    Eigen::VectorXd sources = -m_curvature;
    for(int i = 0; i < number_of_cones(); ++i)
      sources[m_cones[i]] += m_charges[i];
    std::optional<Eigen::VectorXd> u = m_response(sources);
    if(u && is_closed() && !m_cones.empty())
      u->array() -= (*u)[m_cones.front()];
    return u;
  }

  // Adds a cone, and finds the charges that make u vanish at all cones. The first one of a closed surface takes what the others leave of
  // the total.
  bool add(int cone)
  {
    const std::optional<Eigen::VectorXd> green = green_function(cone);
    if(!green)
      return false;
    m_cones.push_back(cone);
    if(is_closed() && number_of_cones() == 1) {
      m_base += m_total * *green;
      m_charges = Eigen::VectorXd::Constant(1, m_total);
      return true;
    }
    if(!m_green.append(at_cones(*green)))
      return false;
    set_charges(m_green.solve(-at_cones(m_base)));
    return m_charges.allFinite();
  }

  // The response to a unit at a cone, and to its opposite at the first one of a closed surface
  std::optional<Eigen::VectorXd> green_function(int cone)
  {
    Eigen::VectorXd unit = Eigen::VectorXd::Unit(size(), cone);
    if(number_of_bound_cones() == 1)
      unit[m_cones.front()] -= 1;
    return m_response(unit);
  }

  int number_of_bound_cones() const { return is_closed() && !m_cones.empty() ? 1 : 0; }

  // Of the cones with charges of their own; on a closed surface the differences from the first cone
  Eigen::VectorXd at_cones(const Eigen::VectorXd& u) const
  {
    const int bound = number_of_bound_cones();
    Eigen::VectorXd values(number_of_cones() - bound);
    for(int i = bound; i < number_of_cones(); ++i)
      values[i - bound] = u[m_cones[i]] - (bound == 1 ? u[m_cones.front()] : 0);
    return values;
  }

  void set_charges(const Eigen::VectorXd& own)
  {
    m_charges.resize(number_of_cones());
    if(number_of_bound_cones() == 1)
      m_charges << m_total - own.sum(), own;
    else
      m_charges = own;
  }

  // The charges as the options want them. Those that make u vanish at the cones are there.
  bool find_charges()
  {
    const int bound = number_of_bound_cones(), n = number_of_cones() - bound;
    if(m_options.angles == Cone_angles::PREDICTED || n == 0 || !(m_log_scale.total_area() > 0))
      return true;
    // The mean square of u = base + sum of charges * green functions is least where its gradient vanishes. The products of
    // these functions come from a second response to each.
    Eigen::MatrixXd products(n, n);
    for(int i = 0; i < n; ++i) {
      const std::optional<Eigen::VectorXd> green = green_function(m_cones[i + bound]),
                                           second = green ? m_response(weighted(*green)) : std::nullopt;
      if(!second)
        return false;
      products.col(i) = at_cones(*second);
    }
    const std::optional<Eigen::VectorXd> second = m_response(weighted(m_base));
    if(!second)
      return false;
    set_charges(products.partialPivLu().solve(-at_cones(*second)));
    return m_charges.allFinite();
  }

  // Times the areas, without the mean
  Eigen::VectorXd weighted(const Eigen::VectorXd& u) const
  {
    return m_area.cwiseProduct(u) - m_area * (m_area.dot(u) / m_log_scale.total_area());
  }

  // Rounds the charges to multiples of the quantum, and drops cones without charge. Returns whether that is possible.
  bool round()
  {
    const int turn = quanta_of_turn(m_options.quantum);
    const double quantum = 2 * pi / turn;
    std::vector<Quantized_charge> wanted;
    for(int i = 0; i < number_of_cones(); ++i) {
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
    for(int i = 0; i < number_of_cones(); ++i)
      if((*rounded)[i] != 0) {
        cones.push_back(m_cones[i]);
        charges.push_back((*rounded)[i] * quantum);
      }
    m_cones = std::move(cones);
    m_charges = Eigen::Map<const Eigen::VectorXd>(charges.data(), static_cast<int>(charges.size()));
    return true;
  }

  // What rounding left of the total of a closed surface goes to the largest angle.
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
        message << "the cone at " << position_text(m_surface, v) << " would have the angle "
                << result.angles[i] << ", which must be above 0 and below " << triangles
                << " pi: other cones are needed, or more of them";
      result.offending_vertices.push_back(v);
    }
    result.message = message.str();
    if(result.message.empty())
      return;
    result.diagnosis = Cone_report::INFEASIBLE_ANGLES;
    result.vertices.clear();
    result.angles.clear();
  }

  const Chart& m_surface;
  const Cone_options& m_options;
  const Log_scale m_log_scale;
  Scale_response m_response;
  const double m_total; // of the charges of a closed surface
  const Eigen::VectorXd m_curvature, m_area;
  Eigen::VectorXd
      m_base; // the response to the curvature, and to the whole charge of a closed surface at its first cone
  Growing_cholesky m_green;   // of the Green functions at the cones
  std::vector<int> m_valence; // of each vertex
  std::vector<int> m_cones;
  Eigen::VectorXd m_charges;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Chosen_cones choose_cones(const Chart& surface,
                                                             const Cone_options& options,
                                                             const Linear_solvers& solvers)
{
  return Cone_chooser(surface, options, solvers).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_CHOOSE_CONES_IMPL_H
