// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_TEST_REFERENCE_MEASURES_H
#define ANGLE_BASED_FLATTENING_TEST_REFERENCE_MEASURES_H

#include "test_charts.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <vector>

namespace test_charts {

typedef CGAL::Surface_mesh_parameterization::Flattening_measures Measures;
typedef CGAL::Surface_mesh_parameterization::Flattening_face_measures Face_measures;

// The measures of a map and of its triangles.
struct Measured
{
  Measures map;
  std::vector<Face_measures> faces;
};

// The measures from lengths alone: the first fundamental form gives the planar edges of a triangle their lengths in
// space. Angles are computed by the law of cosines.
class Reference_measures
{
  typedef boost::multiprecision::cpp_bin_float_50 Real;

public:
  Reference_measures(const Chart& chart, const std::vector<Point_2>& uv) : m_chart(chart), m_uv(uv)
  {
    find_target_angles();
    for(int t = 0; t < chart.number_of_triangles(); ++t) {
      m_plane += abs(planar_area(t));
      m_surface += planar_area(t) * sqrt(determinant(form(t)));
    }
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      add(t);
  }

  Measured measured() const
  {
    Measured result;
    result.faces = m_faces;
    const double triangles = m_chart.number_of_triangles();
    for(const Face_measures& face : m_faces)
      result.map.angular_distortion += face.angular_distortion / triangles;
    result.map.l2_stretch = root(m_stretch);
    result.map.l2_shear = root(m_shear);
    result.map.l2_principal_shear = root(m_principal_shear);
    result.map.l2_equal_stretch_error = root(m_equal_stretch_error);
    result.map.l2_area_distortion = root(m_area_distortion);
    result.map.mean_quasi_conformal_ratio = static_cast<double>(m_ratio / m_surface);
    result.map.symmetric_dirichlet_energy = static_cast<double>(m_dirichlet / m_surface);
    const auto largest = [&](double Face_measures::*measure) {
      double most = 0;
      for(const Face_measures& face : m_faces)
        most = (std::max)(most, face.*measure);
      return most;
    };
    result.map.linf_stretch = largest(&Face_measures::linf_stretch);
    result.map.max_quasi_conformal_ratio = largest(&Face_measures::quasi_conformal_ratio);
    result.map.smallest_angle = CGAL_PI;
    for(const Face_measures& face : m_faces)
      result.map.smallest_angle = (std::min)(result.map.smallest_angle, face.smallest_angle);
    return result;
  }

private:
  struct Form
  {
    Real e, f, g;
  };

  static Real determinant(const Form& form) { return form.e * form.g - form.f * form.f; }

  double root(const Real& sum) const { return static_cast<double>(sqrt(sum / m_surface)); }

  Real planar_squared_length(int c) const
  {
    return squared(m_uv[m_chart.edge_source(c)], m_uv[m_chart.edge_target(c)], 2);
  }

  Real squared_length(int c) const
  {
    return squared(m_chart.points[m_chart.edge_source(c)], m_chart.points[m_chart.edge_target(c)], 3);
  }

  template <typename Point>
  static Real squared(const Point& p, const Point& q, int dimension)
  {
    Real sum = 0;
    for(int i = 0; i < dimension; ++i)
      sum += (Real(p[i]) - q[i]) * (Real(p[i]) - q[i]);
    return sum;
  }

  template <typename Squared_length>
  static Real angle(int c, Squared_length&& squared_length)
  {
    const Real a = squared_length(c), b = squared_length(abf::next_corner(c)),
               d = squared_length(abf::previous_corner(c));
    return acos((b + d - a) / (2 * sqrt(b * d)));
  }

  void find_target_angles()
  {
    std::vector<Real> sum(m_chart.points.size(), 0);
    for(int c = 0; c < m_chart.number_of_corners(); ++c) {
      m_beta.push_back(angle(c, [this](int i) { return squared_length(i); }));
      sum[m_chart.vertex[c]] += m_beta.back();
    }
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      if(m_chart.interior[m_chart.vertex[c]] >= 0)
        m_beta[c] *= 2 * boost::math::constants::pi<Real>() / sum[m_chart.vertex[c]];
  }

  Real planar_area(int t) const
  {
    const Point_2 &p = m_uv[m_chart.vertex[3 * t]], &q = m_uv[m_chart.vertex[3 * t + 1]],
                  &r = m_uv[m_chart.vertex[3 * t + 2]];
    return ((Real(q.x()) - p.x()) * (Real(r.y()) - p.y()) - (Real(q.y()) - p.y()) * (Real(r.x()) - p.x())) /
           2;
  }

  // By Cramer's rule from x^2 e + 2 x y f + y^2 g = l^2 for the three edges (x, y).
  Form form(int t) const
  {
    Real x[3][4];
    for(int i = 0; i < 3; ++i) {
      const Point_2 &p = m_uv[m_chart.edge_source(3 * t + i)], &q = m_uv[m_chart.edge_target(3 * t + i)];
      const Real u = Real(q.x()) - p.x(), v = Real(q.y()) - p.y();
      x[i][0] = u * u;
      x[i][1] = 2 * u * v;
      x[i][2] = v * v;
      x[i][3] = squared_length(3 * t + i);
    }
    const auto determinant = [&x](int i, int j, int k) -> Real {
      return x[0][i] * (x[1][j] * x[2][k] - x[1][k] * x[2][j]) -
             x[0][j] * (x[1][i] * x[2][k] - x[1][k] * x[2][i]) +
             x[0][k] * (x[1][i] * x[2][j] - x[1][j] * x[2][i]);
    };
    const Real all = determinant(0, 1, 2);
    return {determinant(3, 1, 2) / all, determinant(0, 3, 2) / all, determinant(0, 1, 3) / all};
  }

  void add(int t)
  {
    const Form form = this->form(t);
    const Real area = planar_area(t) * sqrt(determinant(form)), scale = m_plane / m_surface;
    const Real trace = form.e + form.g;
    const Real difference = sqrt((form.e - form.g) * (form.e - form.g) + 4 * form.f * form.f);
    const Real largest = (trace + difference) / 2 * scale, smallest = (trace - difference) / 2 * scale;
    const Real shear = abs(form.f) / sqrt(form.e * form.g), principal_shear = difference / trace;
    const Real equal_stretch_error = abs(form.e - form.g) / trace;
    const Real area_distortion = abs(log(largest * smallest) / 2), ratio = sqrt(largest / smallest);
    const Real dirichlet = trace * scale + 1 / largest + 1 / smallest;
    m_stretch += area * trace * scale / 2;
    m_shear += area * shear * shear;
    m_principal_shear += area * principal_shear * principal_shear;
    m_equal_stretch_error += area * equal_stretch_error * equal_stretch_error;
    m_area_distortion += area * area_distortion * area_distortion;
    m_ratio += area * ratio;
    m_dirichlet += area * dirichlet;

    Face_measures face;
    face.area = static_cast<double>(area);
    face.l2_stretch = static_cast<double>(sqrt(trace * scale / 2));
    face.linf_stretch = static_cast<double>(sqrt(largest));
    face.shear = static_cast<double>(shear);
    face.principal_shear = static_cast<double>(principal_shear);
    face.equal_stretch_error = static_cast<double>(equal_stretch_error);
    face.quasi_conformal_ratio = static_cast<double>(ratio);
    face.area_distortion = static_cast<double>(area_distortion);
    face.symmetric_dirichlet_energy = static_cast<double>(dirichlet);
    set_angles(t, face);
    m_faces.push_back(face);
  }

  void set_angles(int t, Face_measures& face) const
  {
    Real distortion = 0, smallest_angle = CGAL_PI;
    for(int c = 3 * t; c < 3 * t + 3; ++c) {
      const Real alpha = angle(c, [this](int i) { return planar_squared_length(i); });
      distortion += (alpha / m_beta[c] - 1) * (alpha / m_beta[c] - 1) / 3;
      smallest_angle = (std::min)(smallest_angle, alpha);
    }
    face.angular_distortion = static_cast<double>(distortion);
    face.smallest_angle = static_cast<double>(smallest_angle);
  }

  const Chart& m_chart;
  const std::vector<Point_2>& m_uv;
  std::vector<Real> m_beta;
  Real m_plane = 0, m_surface = 0;
  Real m_stretch = 0, m_shear = 0, m_principal_shear = 0, m_equal_stretch_error = 0, m_area_distortion = 0,
       m_ratio = 0, m_dirichlet = 0;
  std::vector<Face_measures> m_faces;
};

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_TEST_REFERENCE_MEASURES_H
