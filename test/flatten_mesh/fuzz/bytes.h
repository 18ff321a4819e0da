// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_FUZZ_BYTES_H
#define ANGLE_BASED_FLATTENING_FUZZ_BYTES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace fuzz {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;

// Interprets the fuzzer's bytes. They are read from the front; zeros follow the end.
class Bytes
{
public:
  Bytes(const unsigned char* data, std::size_t size) : m_next(data), m_end(data + size) {}

  bool is_empty() const { return m_next == m_end; }

  int byte() { return is_empty() ? 0 : *m_next++; }

  // In [0, n).
  int below(int n) { return byte() % n; }

  // If `extreme`, sometimes all coordinates are extreme.
  double coordinate(bool extreme)
  {
    const double largest = (std::numeric_limits<double>::max)();
    const double extremes[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(),
                               largest,
                               -largest,
                               std::numeric_limits<double>::denorm_min(),
                               1e300,
                               -1e300,
                               1e160,
                               1e-160,
                               1e-300};
    const int which = byte();
    if(extreme && which < 3) // spoils the whole mesh
      return extremes[which];
    if(extreme && which < 128)
      return extremes[3 + which % 8];
    return (which - 128) / 16.;
  }

  // A new point, or one of `points` again.
  Point_3 point(const std::vector<Point_3>& points, bool extreme)
  {
    const int kind = byte();
    if(kind < 8 && !points.empty())
      return points[kind % points.size()];
    const double x = coordinate(extreme), y = coordinate(extreme);
    return Point_3(x, y, kind < 64 ? 0 : coordinate(extreme));
  }

private:
  const unsigned char* m_next;
  const unsigned char* m_end;
};

} // namespace fuzz

#endif // ANGLE_BASED_FLATTENING_FUZZ_BYTES_H
