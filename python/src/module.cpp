// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The compiled part of the package `angle_based_flattening`. Its Python part checks arguments, and documents all.

#include "bindings.h"
#include "failures.h"
#include "interruptible.h"
#include "option_taker.h"

#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>

namespace abf_python {

namespace SMP = CGAL::Surface_mesh_parameterization;

namespace {

py::object errors()
{
  return py::module_::import("angle_based_flattening._errors");
}

void translate(const std::exception_ptr pointer)
{
  try {
    std::rethrow_exception(pointer);
  } catch(const Mesh_failure& failure) {
    const py::object type = errors().attr("MeshError");
    const py::object value =
        type(failure.status, failure.message, failure.faces, failure.vertices, failure.mesh);
    PyErr_SetObject(type.ptr(), value.ptr());
  } catch(const Cancelled& cancelled) {
    const py::object type = errors().attr("Cancelled");
    PyErr_SetString(type.ptr(), cancelled.what());
  } catch(const Timed_out& timed_out) {
    PyErr_SetString(PyExc_TimeoutError, timed_out.what());
  }
}

} // namespace

} // namespace abf_python

PYBIND11_MODULE(_core, module)
{
  using namespace abf_python;
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // prints nothing
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  module.attr("__version__") = ABF_VERSION;
  py::register_exception_translator(&translate);
  py::class_<Watch>(module, "Watch").def(py::init([](const py::object& progress, const double timeout) {
    return Watch{progress, timeout};
  }));
  py::dict options;
  options["atlas"] = rows_of_options<TA::Atlas_options>();
  options["direct"] = rows_of_options<SMP::ABF_plus_plus_options>();
  options["hierarchical"] = rows_of_options<SMP::Hierarchical_options>();
  options["packing"] = rows_of_options<TA::Packing_options>();
  options["seams"] = rows_of_options<TA::Seam_options>();
  options["baking"] = rows_of_options<TA::Baking_options>();
  module.attr("OPTIONS") = options;
  bind_atlas(module);
  bind_charts(module);
  bind_maps(module);
  bind_surfaces(module);
}
