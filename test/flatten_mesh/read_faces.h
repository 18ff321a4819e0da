// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces as readers of files give them, to be compared with those expected.

#ifndef TEST_READ_FACES_H
#define TEST_READ_FACES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// Each attribute is empty where there is none.
struct Read_corner
{
  std::vector<double> point, uv, normal, color;
};

struct Read_face
{
  std::string material;
  std::vector<Read_corner> corners;
};

inline bool is_near(const std::vector<double>& a, const std::vector<double>& b, const double tolerance)
{
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [tolerance](double x, double y) {
           return std::abs(x - y) <= tolerance * (std::max)(1., std::abs(x));
         });
}

// What is not compared
struct Left_out
{
  bool material = false, normal = false, color = false;
};

inline bool is_same_face(const Read_face& a, const Read_face& b, const double tolerance,
                         const Left_out& left_out)
{
  if(a.corners.size() != b.corners.size() || (!left_out.material && a.material != b.material))
    return false;
  // the same corners in the same order, from any first one
  for(std::size_t shift = 0; shift < a.corners.size(); ++shift) {
    bool is_same = true;
    for(std::size_t i = 0; i < a.corners.size() && is_same; ++i) {
      const Read_corner &c = a.corners[i], &d = b.corners[(i + shift) % b.corners.size()];
      is_same = is_near(c.point, d.point, tolerance) && is_near(c.uv, d.uv, tolerance) &&
                (left_out.normal || is_near(c.normal, d.normal, tolerance)) &&
                (left_out.color || is_near(c.color, d.color, tolerance));
    }
    if(is_same)
      return true;
  }
  return false;
}

// How many of the faces expected are not among those found, or the other way round. Each is found once.
inline std::size_t missing_faces(const std::vector<Read_face>& expected, const std::vector<Read_face>& found,
                                 const double tolerance, const Left_out& left_out = {})
{
  std::vector<bool> is_taken(found.size(), false);
  std::size_t missing = 0;
  for(const Read_face& face : expected) {
    bool is_found = false;
    for(std::size_t i = 0; i < found.size() && !is_found; ++i)
      if(!is_taken[i] && is_same_face(face, found[i], tolerance, left_out))
        is_taken[i] = is_found = true;
    missing += !is_found;
  }
  return missing + static_cast<std::size_t>(std::count(is_taken.begin(), is_taken.end(), false));
}

#endif // TEST_READ_FACES_H
