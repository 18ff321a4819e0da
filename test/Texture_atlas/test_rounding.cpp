// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates are certified as the caller's map stores them. This is compiled at -O2, where g++ 12 is known to omit a
// conversion to float and back.

#include <boost/test/unit_test.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>

#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_rounding)

BOOST_AUTO_TEST_CASE(rounding_to_floats)
{
  typedef CGAL::Simple_cartesian<float>::Point_2 Float_point;
  namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
  std::vector<abf::Chart::Point_2> uv;
  for(int i = 1; i <= 7; ++i)
    uv.push_back(abf::Chart::Point_2(1. / (3 * i), 1e10 / (7 * i)));
  const std::vector<abf::Chart::Point_2> exact = uv;
  abf::round_to_points<Float_point>(uv);
  for(std::size_t i = 0; i < uv.size(); ++i) {
    const volatile float x = static_cast<float>(exact[i].x()), y = static_cast<float>(exact[i].y());
    BOOST_TEST(uv[i].x() == double(x));
    BOOST_TEST(uv[i].y() == double(y));
  }
}

BOOST_AUTO_TEST_SUITE_END()
