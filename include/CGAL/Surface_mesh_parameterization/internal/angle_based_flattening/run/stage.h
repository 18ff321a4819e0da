// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a visitor hears of a run: the start of a stage, Newton's steps, levels. It also times stages, asks for the
// memory of the process, and ends the run if the visitor or the deadline says so. `solve_angles.h`, `coarsen.h`,
// `flatten_injectively.h`, the strategies and the stages of an atlas report through it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_STAGE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_STAGE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <CGAL/Real_timer.h>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Runs `f`, and returns what ended it, if anything did.
template <typename Function>
Report run_bounded(double time_limit, const Function& f)
{
  const Deadline deadline(time_limit);
  try {
    f();
  } catch(const Cancelled&) {
    return {Diagnosis::CANCELLED, "a visitor stopped the computation"};
  } catch(const Deadline::Passed& passed) {
    if(passed.deadline != &deadline)
      throw;
    return {Diagnosis::TIMED_OUT, passed.message};
  }
  return {};
}

// Tells a visitor that a stage starts, and adds the time until the end of the scope to `seconds`.
template <typename Visitor>
class Visited_stage
{
public:
  Visited_stage(Visitor* visitor, typename Visitor::Stage stage, double& seconds)
      : m_stage(to_string(stage)), m_seconds(seconds)
  {
    if(visitor != nullptr && !visitor->start(stage))
      throw Cancelled();
    Deadline::ask();
    m_timer.start();
  }

  ~Visited_stage() { m_seconds += m_timer.time(); }

  Visited_stage(const Visited_stage&) = delete;
  Visited_stage& operator=(const Visited_stage&) = delete;

private:
  const Deadline::Stage m_stage;
  double& m_seconds;
  Real_timer m_timer;
};

typedef Visited_stage<Flattening_visitor> Stage;

inline void visit_step(Flattening_visitor* visitor, const ABF_plus_plus_step& step)
{
  if(visitor != nullptr && !visitor->step(step))
    throw Cancelled();
  Deadline::ask();
}

inline void visit_level(Flattening_visitor* visitor, int vertices, int all_vertices)
{
  if(visitor != nullptr && !visitor->level(vertices, all_vertices))
    throw Cancelled();
  Deadline::ask();
}

// The largest resident size of the process so far, in bytes; 0 if the system does not tell. On Linux, the count starts
// with the size of the parent process.
inline std::size_t peak_resident_size()
{
#if defined(__unix__) || defined(__APPLE__)
#ifdef __APPLE__
  const std::size_t unit = 1;
#else
  const std::size_t unit = 1024;
#endif
  rusage usage;
  if(getrusage(RUSAGE_SELF, &usage) == 0)
    return static_cast<std::size_t>(usage.ru_maxrss) * unit;
#endif
  return 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_STAGE_H
