// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options in one expression: `with<Packing_options>(&Packing_options::resolution, 64, &Packing_options::gutter, 3)`

#ifndef ABF_TEST_OPTIONS_H
#define ABF_TEST_OPTIONS_H

#include <CGAL/Texture_atlas/Atlas_options.h>

// Options of atlases whose charts are cut little, and keep the angles of ABF++
struct Few_charts : CGAL::Texture_atlas::Atlas_options
{
  Few_charts() : Atlas_options(FEW_CHARTS) {}
};

template <typename Options>
Options with()
{
  return Options();
}

template <typename Options, typename Class, typename Member, typename Value, typename... Others>
Options with(Member Class::*member, const Value& value, const Others&... others)
{
  Options options = with<Options>(others...);
  options.*member = value;
  return options;
}

// The same, with other values of members
template <typename... Members>
CGAL::Texture_atlas::Atlas_options few_charts(const Members&... members)
{
  return with<Few_charts>(members...);
}

#endif // ABF_TEST_OPTIONS_H
