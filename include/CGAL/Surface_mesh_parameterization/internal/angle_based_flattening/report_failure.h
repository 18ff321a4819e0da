// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_REPORT_FAILURE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_REPORT_FAILURE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <string>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

template <typename Report>
void fail(Report& report, Error_code status, ABF_plus_plus_report::Diagnosis diagnosis,
          const std::string& message)
{
  report.status = status;
  report.diagnosis = diagnosis;
  report.message = message;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_REPORT_FAILURE_H
