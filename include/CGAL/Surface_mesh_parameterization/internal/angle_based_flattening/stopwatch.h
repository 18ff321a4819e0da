// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STOPWATCH_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STOPWATCH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Real_timer.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The seconds since the last call, and since construction at the first.
class Stopwatch
{
public:
  Stopwatch() { m_timer.start(); }

  double lap()
  {
    const double elapsed = m_timer.time();
    m_timer.reset();
    return elapsed;
  }

private:
  Real_timer m_timer;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STOPWATCH_H
