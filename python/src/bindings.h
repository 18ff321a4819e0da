// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_BINDINGS_H
#define ABF_PYTHON_BINDINGS_H

#include <pybind11/pybind11.h>

namespace abf_python {

// Each adds a group of functions, which are compiled by themselves.
void bind_atlas(pybind11::module_& module);
void bind_charts(pybind11::module_& module);
void bind_maps(pybind11::module_& module);
void bind_surfaces(pybind11::module_& module);

} // namespace abf_python

#endif // ABF_PYTHON_BINDINGS_H
