// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What this package takes from the parameterizers: options, reports and diagnoses, whose names are its own as well, and
// the numerical layers, whose names its internals use.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PARAMETERIZATION_NAMES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PARAMETERIZATION_NAMES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>

namespace CGAL::Texture_atlas {

using Surface_mesh_parameterization::ABF_plus_plus_options;
using Surface_mesh_parameterization::ABF_plus_plus_report;
using Surface_mesh_parameterization::ABF_plus_plus_step;
using Surface_mesh_parameterization::Diagnosis;
using Surface_mesh_parameterization::Error_code;
using Surface_mesh_parameterization::Flattening_face_measures;
using Surface_mesh_parameterization::Flattening_measures;
using Surface_mesh_parameterization::Flattening_options;
using Surface_mesh_parameterization::Flattening_report;
using Surface_mesh_parameterization::Flattening_visitor;
using Surface_mesh_parameterization::Hierarchical_options;
using Surface_mesh_parameterization::Hierarchical_report;
using Surface_mesh_parameterization::Mesh_report;
using Surface_mesh_parameterization::Report;
using Surface_mesh_parameterization::operator<<;
using Surface_mesh_parameterization::to_string;

namespace internal {

using namespace Surface_mesh_parameterization::internal::ABF;
using Surface_mesh_parameterization::internal::ABF::
    wrong_option; // with overloads for the options of this package

} // namespace internal

} // namespace CGAL::Texture_atlas

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PARAMETERIZATION_NAMES_H
