// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options in one expression: `with<Packing_options>(&Packing_options::resolution, 64, &Packing_options::gutter, 3)`

#ifndef ABF_TEST_OPTIONS_H
#define ABF_TEST_OPTIONS_H

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

#endif // ABF_TEST_OPTIONS_H
