// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of functions that the methods call only on demand, so that simple programs need not compile them.
// `disk_strategies.h` and `all_strategies.h` fill it. `direct_strategies.h`, `hole_strategies.h` and both flattening
// bodies call what is there.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_OPTIONAL_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_OPTIONAL_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart fill_holes(const Chart& chart, double weight);

CGAL_ANGLE_BASED_FLATTENING_INLINE std::optional<std::vector<Chart::Point_2>>
progressive_embedding(Chart chart, const ABF_plus_plus_options& options);

CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<ABF_plus_plus_report>
made_injective(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
               Rounding round, Flattening<ABF_plus_plus_report> direct);

CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<Hierarchical_report>
flatten_injectively(Chart& chart, const Hierarchical_options& options, const Linear_solvers& solvers,
                    const std::vector<Chart::Point_2>* start);

struct Attempts;
struct Direct_flattening;
struct Direct_task;
class Direct_strategies;

// Functions that the methods call only if their options ask for it, or if their own map is not valid. Programs that
// need none of them do not compile them: <CGAL/Surface_mesh_parameterization/ABF_plus_plus_strategies.h> enters them
// here. The compiled library contains all of them.
struct Optional_strategies
{
  decltype(&ABF::fill_holes) fill_holes = nullptr;
  // fallbacks of the direct method
  Direct_flattening (*from_embedding)(Direct_strategies&, const Direct_task&, Attempts&) = nullptr;
  Direct_flattening (*solve_by_filling)(Direct_strategies&, const Direct_task&, Attempts&) = nullptr;
  // the direct method with `Flattening_options::FILL`
  Flattening<ABF_plus_plus_report> (*flatten_filled)(const Direct_task&) = nullptr;
  decltype(&ABF::made_injective) make_injective = nullptr;
  decltype(&ABF::flatten_injectively) flatten_injectively = nullptr;
};

inline Optional_strategies optional_strategies;

inline std::string needs_strategies(const std::string& what)
{
  return what + " needs #include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_strategies.h>";
}

// Returns which option cannot be served, or an empty string.
inline std::string missing_strategy(const Flattening_options& options)
{
  if(options.injective && optional_strategies.make_injective == nullptr)
    return needs_strategies("the option 'injective'");
  if(options.holes == Flattening_options::FILL && optional_strategies.fill_holes == nullptr)
    return needs_strategies("filling holes");
  return std::string();
}

// The weight of patches that hardly stiffen a chart. With 1e-2 and less Newton's method does not converge.
inline constexpr double soft_patch_weight = 0.1;

inline bool are_holes_filled(const Chart& chart, const Flattening_options& options)
{
  return options.holes == Flattening_options::FILL && chart.borders.size() > 1;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_OPTIONAL_STRATEGIES_H
