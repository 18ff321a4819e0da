// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_FORMAT_NUMBER_H
#define PICTURES_FORMAT_NUMBER_H

#include <cstdio>
#include <string>

namespace pictures {

inline std::string format_number(const char* format, const double number)
{
  char digits[64];
  std::snprintf(digits, sizeof(digits), format, number);
  return digits;
}

} // namespace pictures

#endif // PICTURES_FORMAT_NUMBER_H
