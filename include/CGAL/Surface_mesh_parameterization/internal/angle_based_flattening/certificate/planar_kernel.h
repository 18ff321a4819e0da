// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A kernel of doubles whose orientation of points in the plane is exact. All certificates take it, by way of
// `local_injectivity.h`; `chart_outline.h` finds convex hulls with it. CGAL's kernels with exact predicates have all of
// them, and add half the time that a program with LSCM takes to compile.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_KERNEL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_KERNEL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

// The order matters: neither header of static filters includes what it needs.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Filtered_kernel/internal/Static_filters/tools.h>
#include <CGAL/Filtered_kernel/internal/Static_filters/Orientation_2.h>

#include <CGAL/Kernel/Type_equality_wrapper.h>
#include <CGAL/MP_Float.h>
#include <CGAL/predicates/kernel_ftC2.h>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

template <typename Kernel>
using Kernel_of_doubles =
    CGAL::Type_equality_wrapper<CGAL::Cartesian_base_no_ref_count<double, Kernel>, Kernel>;

// Everything that follows from orientations and comparisons of coordinates is exact, too: whether points are collinear,
// in which order they are on a line, which are on their convex hull, and whether segments or triangles intersect. Other
// predicates are not.
struct Planar_kernel : Kernel_of_doubles<Planar_kernel>
{
  // In exact numbers, which are finite: other points count as collinear with any.
  struct Exact_orientation_2
  {
    typedef CGAL::Orientation result_type;

    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const;
  };

  struct Unfiltered_kernel : Kernel_of_doubles<Planar_kernel>
  {
    typedef Exact_orientation_2 Orientation_2;
  };

  // In exact numbers where rounding errors may be too large for doubles
  typedef CGAL::internal::Static_filters_predicates::Orientation_2<Unfiltered_kernel> Orientation_2;
  Orientation_2 orientation_2_object() const { return Orientation_2(); }

  // Of directions, also exactly
  struct Compare_angle_with_x_axis_2
  {
    typedef CGAL::Comparison_result result_type;

    CGAL::Comparison_result operator()(const Direction_2& d, const Direction_2& e) const;
  };

  Compare_angle_with_x_axis_2 compare_angle_with_x_axis_2_object() const { return {}; }
};

inline CGAL::Orientation Planar_kernel::Exact_orientation_2::operator()(const Point_2& p, const Point_2& q,
                                                                        const Point_2& r) const
{
  for(double coordinate : {p.x(), p.y(), q.x(), q.y(), r.x(), r.y()})
    if(!std::isfinite(coordinate))
      return CGAL::COLLINEAR;
  return CGAL::orientationC2(CGAL::MP_Float(p.x()), CGAL::MP_Float(p.y()), CGAL::MP_Float(q.x()),
                             CGAL::MP_Float(q.y()), CGAL::MP_Float(r.x()), CGAL::MP_Float(r.y()));
}

inline CGAL::Comparison_result
Planar_kernel::Compare_angle_with_x_axis_2::operator()(const Direction_2& d, const Direction_2& e) const
{
  const auto quadrant = [](const Direction_2& f) {
    return f.dy() < 0 ? (f.dx() < 0 ? 3 : 4) : (f.dx() < 0 ? 2 : 1);
  };
  if(const int difference = quadrant(d) - quadrant(e); difference != 0)
    return difference > 0 ? CGAL::LARGER : CGAL::SMALLER;
  const auto point = [](const Direction_2& f) { return Point_2(f.dx(), f.dy()); };
  return -CGAL::orientation(Point_2(0, 0), point(d), point(e));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_KERNEL_H
