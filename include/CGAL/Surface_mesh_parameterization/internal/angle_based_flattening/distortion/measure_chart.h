// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of a map, triangle by triangle and in total: those of the paper (Eqs. 1, 23 and 24), and others for
// comparison. `measure_flattening.h` and `certify_atlas.h` report them. They hold for the maps of any method.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_MEASURE_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_MEASURE_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Computes the measures of one triangle that depend on derivatives. `scale` enlarges the plane to the area of the
// surface.
inline void measure_differential(const Triangle_differential& map, double scale,
                                 Flattening_face_measures& face)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if(!map.has_area()) {
    face.scale = 0;
    face.shear = face.principal_shear = face.equal_stretch_error = 1;
    face.l2_stretch = face.linf_stretch = face.quasi_conformal_ratio = infinity;
    face.area_distortion = face.symmetric_dirichlet_energy = infinity;
    return;
  }
  const double largest = map.largest_stretch() / scale, smallest = map.smallest_stretch() / scale;
  const double squares = largest * largest + smallest * smallest;
  face.shear = map.shear();
  face.principal_shear = map.principal_shear();
  face.equal_stretch_error = map.equal_stretch_error();
  face.quasi_conformal_ratio = largest / smallest;
  face.scale = scale / std::sqrt(map.area_stretch());
  face.area_distortion = std::abs(std::log(map.area_stretch() / (scale * scale)));
  face.l2_stretch = std::sqrt(squares / 2);
  face.linf_stretch = largest;
  face.symmetric_dirichlet_energy = squares + 1 / (largest * largest) + 1 / (smallest * smallest);
}

// Computes the measures of one triangle that depend on angles.
inline void measure_angles(const Chart& chart, const Target_angles& target,
                           const std::vector<Chart::Point_2>& uv, int t, Flattening_face_measures& face)
{
  face.smallest_angle = pi;
  double squares = 0;
  for(int c = 3 * t; c < 3 * t + 3; ++c) {
    const double alpha = planar_angle(chart, uv, c), angle = surface_angle(chart, c),
                 change = std::abs(alpha - angle);
    face.mean_angle_change += change / 3;
    squares += change * change / 3;
    face.angular_distortion += Angle_energy{0}.value(alpha, target(c, angle)) / 3;
    face.smallest_angle = (std::min)(face.smallest_angle, alpha);
  }
  face.rms_angle_change = std::sqrt(squares);
}

inline void set_not_a_number(Flattening_face_measures& face)
{
  typedef Flattening_face_measures Face;
  for(double Face::*measure :
      {&Face::mean_angle_change, &Face::rms_angle_change, &Face::scale, &Face::angular_distortion,
       &Face::l2_stretch, &Face::linf_stretch, &Face::shear, &Face::principal_shear,
       &Face::equal_stretch_error, &Face::quasi_conformal_ratio, &Face::area_distortion,
       &Face::symmetric_dirichlet_energy, &Face::smallest_angle})
    face.*measure = (std::numeric_limits<double>::quiet_NaN)();
}

// The smaller and the larger of two numbers, or NaN if one of them is.
inline double least_of(double a, double b)
{
  return a <= b || std::isnan(a) ? a : b;
}

inline double largest_of(double a, double b)
{
  return a >= b || std::isnan(a) ? a : b;
}

// Combines the measures of the triangles to those of the map.
class Measure_totals
{
public:
  Measure_totals(int triangles, double surface) : m_triangles(triangles), m_surface(surface)
  {
    m_totals.smallest_angle = pi;
    m_totals.min_scale = std::numeric_limits<double>::infinity();
    m_ratios.reserve(triangles);
  }

  void add(const Flattening_face_measures& face)
  {
    m_totals.angular_distortion += face.angular_distortion / m_triangles;
    m_totals.mean_corner_angle_change += face.mean_angle_change / m_triangles;
    m_totals.rms_corner_angle_change += CGAL::square(face.rms_angle_change) / m_triangles;
    m_totals.smallest_angle = least_of(m_totals.smallest_angle, face.smallest_angle);
    m_totals.flipped_triangles += face.flipped;

    const double weight = m_surface > 0 ? face.area / m_surface : 1. / m_triangles;
    if(weight == 0)
      return; // infinity times 0 would be NaN
    m_totals.mean_angle_change += weight * face.mean_angle_change;
    m_totals.rms_angle_change += weight * CGAL::square(face.rms_angle_change);
    m_totals.l2_stretch += weight * CGAL::square(face.l2_stretch);
    m_totals.l2_shear += weight * CGAL::square(face.shear);
    m_totals.l2_principal_shear += weight * CGAL::square(face.principal_shear);
    m_totals.l2_equal_stretch_error += weight * CGAL::square(face.equal_stretch_error);
    m_totals.l2_area_distortion += weight * CGAL::square(face.area_distortion);
    m_totals.mean_quasi_conformal_ratio += weight * face.quasi_conformal_ratio;
    m_totals.symmetric_dirichlet_energy += weight * face.symmetric_dirichlet_energy;
    m_totals.linf_stretch = largest_of(m_totals.linf_stretch, face.linf_stretch);
    m_totals.max_quasi_conformal_ratio =
        largest_of(m_totals.max_quasi_conformal_ratio, face.quasi_conformal_ratio);
    m_totals.min_scale = least_of(m_totals.min_scale, face.scale);
    m_totals.max_scale = largest_of(m_totals.max_scale, face.scale);
    m_ratios.emplace_back(face.quasi_conformal_ratio, weight);
  }

  // The measures of the map, after all triangles were added.
  Flattening_measures measures()
  {
    Flattening_measures result = m_totals;
    result.quasi_conformal_ratio_95 =
        std::isnan(result.max_quasi_conformal_ratio) ? result.max_quasi_conformal_ratio : ratio_of_part(0.95);
    for(double* mean_square :
        {&result.rms_angle_change, &result.rms_corner_angle_change, &result.l2_stretch, &result.l2_shear,
         &result.l2_principal_shear, &result.l2_equal_stretch_error, &result.l2_area_distortion})
      *mean_square = std::sqrt(*mean_square);
    return result;
  }

private:
  // The least ratio that is not exceeded on this fraction of the area
  double ratio_of_part(double part)
  {
    std::sort(m_ratios.begin(), m_ratios.end());
    double sum = 0, result = 0;
    for(auto it = m_ratios.begin(); it != m_ratios.end() && sum < part; ++it) {
      result = it->first;
      sum += it->second;
    }
    return result;
  }

  int m_triangles;
  double m_surface;
  Flattening_measures m_totals;                    // sums of squares for root mean squares
  std::vector<std::pair<double, double>> m_ratios; // quasi-conformal ratios and weights
};

// `scale` enlarges the plane to the area of the surface.
inline Flattening_face_measures measure_triangle(const Chart& chart, const Target_angles& target,
                                                 const std::vector<Chart::Point_2>& uv, double scale, int t)
{
  const int* v = &chart.vertex[3 * t];
  Flattening_face_measures face;
  face.area = surface_area(chart, t);
  face.flipped = !is_positively_oriented(exact_point(uv[v[0]]), exact_point(uv[v[1]]), exact_point(uv[v[2]]));
  if(!std::isfinite(planar_area(chart, uv, t))) {
    set_not_a_number(face);
    return face;
  }
  measure_angles(chart, target, uv, t, face);
  measure_differential(Triangle_differential(chart, uv, t), scale, face);
  return face;
}

// Adds the measures of all triangles `t` to the totals, and calls `visit(t, measures)`, in order. Triangles are
// measured in parallel, in batches whose measures take a few megabytes.
template <typename Visitor>
void measure_triangles(const Chart& chart, const std::vector<Chart::Point_2>& uv, double scale,
                       Measure_totals& totals, Visitor&& visit)
{
  const Target_angles target(chart);
  const int triangles = chart.number_of_triangles(), batch = 64 * block_size;
  std::vector<Flattening_face_measures> faces((std::min)(triangles, batch));
  for(int first = 0; first < triangles; first += batch) {
    const int size = (std::min)(batch, triangles - first);
    parallel_for_blocks(size, [&](int begin, int end) {
      for(int i = begin; i < end; ++i)
        faces[i] = measure_triangle(chart, target, uv, scale, first + i);
    });
    for(int i = 0; i < size; ++i) {
      totals.add(faces[i]);
      visit(first + i, faces[i]);
    }
  }
}

template <typename Visitor>
Flattening_measures measure_chart(const Chart& chart, const std::vector<Chart::Point_2>& uv, Visitor&& visit)
{
  const Total_areas areas = total_areas(chart, uv);
  Measure_totals totals(chart.number_of_triangles(), areas.surface);
  measure_triangles(chart, uv, std::sqrt(areas.surface / areas.plane), totals, visit);
  Flattening_measures measures = totals.measures();
  measures.border_is_simple = is_border_simple(chart, uv);
  return measures;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_MEASURE_CHART_H
