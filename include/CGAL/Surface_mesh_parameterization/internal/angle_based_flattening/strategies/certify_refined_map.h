// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The last stage of the hierarchical and the injective method: scales, rounds and certifies the map, and says why it
// fails. `flatten_chart_hierarchically.h` calls it. A map that was valid before can fail here only by rounding.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_CERTIFY_REFINED_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_CERTIFY_REFINED_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Why a map that was computed to be valid is not, after it was scaled and rounded
inline void fail_to_certify(const Chart& chart, const Hierarchical_options& options,
                            const Certificate& certificate, bool was_valid,
                            Flattening<Hierarchical_report>& result)
{
  const std::string defect = certificate.is_valid() ? describe_touching_edges(chart, result.uv)
                                                    : describe_invalid(chart, certificate);
  if(was_valid)
    fail(result.report, Diagnosis::PRECISION_EXCEEDED,
         "the map is valid, but after rounding to the coordinates' number type it has " + defect);
  else if(options.injective)
    fail(result.report, Diagnosis::PRECISION_EXCEEDED,
         "the map has " + defect +
             ", as its range of scale is too large for double precision; a larger area weight may help");
  else
    fail(result.report, Diagnosis::FLIPPED_TRIANGLES, "the refined map has " + defect);
}

inline void certify(const Chart& chart, const Hierarchical_options& options, Rounding round,
                    Flattening<Hierarchical_report>& result)
{
  const Stage stage(options.visitor, Flattening_visitor::CERTIFY, result.report.seconds.certify);
  scale_to_surface_area(chart, result.uv);
  const std::vector<Chart::Point_2> not_rounded = result.uv;
  round(result.uv);
  Certificate certificate = certify(chart, result.uv);
  take_certificate(certificate, result.report);
  result.report.injective = options.injective && certificate.is_valid() && certificate.border_is_simple;
  if(!certificate.is_valid() || (options.injective && !certificate.border_is_simple))
    fail_to_certify(chart, options, certificate,
                    is_valid_map(chart, not_rounded) &&
                        (!options.injective || is_border_simple(chart, not_rounded)),
                    result);
  result.invalid = std::move(certificate.invalid);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_CERTIFY_REFINED_MAP_H
