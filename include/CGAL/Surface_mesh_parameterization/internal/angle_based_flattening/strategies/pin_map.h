// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The last step of a method where vertices have given positions: moves its map there, and certifies it again.
// `run_parameterizer.h` calls it by a pointer that both parameterizers set. The bodies are in `pin_map_impl.h`, which
// the compiled library has.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PIN_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PIN_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_pins.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Moves the map `result` of a chart with pins to these, and rounds it.
CGAL_ANGLE_BASED_FLATTENING_INLINE void pin_map(const Chart& chart, const Flattening_options& options,
                                                const Linear_solvers& solvers, Rounding round,
                                                Flattening<ABF_plus_plus_report>& result);

CGAL_ANGLE_BASED_FLATTENING_INLINE void pin_map(const Chart& chart, const Flattening_options& options,
                                                const Linear_solvers& solvers, Rounding round,
                                                Flattening<Hierarchical_report>& result);

// Methods get it as a pointer: programs that never take the address do not optimize the bodies.
template <typename Report>
using Pin_function = void (*)(const Chart&, const Flattening_options&, const Linear_solvers&, Rounding,
                              Flattening<Report>&);

// The function for vertices with pins, which is `given` if none of them is parameterized beforehand
template <typename VertexParameterizedMap, typename Report>
Pin_function<Report> pin_function(Pin_function<Report> given)
{
  if constexpr(std::is_same<VertexParameterizedMap, None_parameterized>::value)
    return given;
  else
    return &pin_map;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/pin_map_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PIN_MAP_H
