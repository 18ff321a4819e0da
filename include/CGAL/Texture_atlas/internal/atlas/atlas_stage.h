// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ATLAS_STAGE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ATLAS_STAGE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

namespace CGAL::Texture_atlas::internal {

class Atlas_stage : public Visited_stage<Atlas_visitor>
{
public:
  Atlas_stage(Atlas_visitor* visitor, Atlas_visitor::Stage stage, double& seconds)
      : Visited_stage(visitor, stage, names[stage], seconds)
  {}

private:
  static constexpr const char* names[] = {"READ", "CHARTS", "PACK", "CERTIFY", "MEASURE", "WRITE"};
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ATLAS_STAGE_H
