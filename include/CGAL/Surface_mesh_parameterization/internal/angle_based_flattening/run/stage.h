// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_VISIT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_VISIT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Thrown when a visitor wants no more, and caught where the report is written.
struct Cancelled
{};

inline void visit_stage(Flattening_visitor* visitor, Flattening_visitor::Stage stage)
{
  if(visitor != nullptr && !visitor->start(stage))
    throw Cancelled();
}

inline void visit_step(Flattening_visitor* visitor, const ABF_plus_plus_step& step)
{
  if(visitor != nullptr && !visitor->step(step))
    throw Cancelled();
}

inline void visit_level(Flattening_visitor* visitor, int vertices, int all_vertices)
{
  if(visitor != nullptr && !visitor->level(vertices, all_vertices))
    throw Cancelled();
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_VISIT_H
