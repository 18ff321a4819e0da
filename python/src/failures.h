// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_FAILURES_H
#define ABF_PYTHON_FAILURES_H

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

// Becomes a `MeshError` in Python.
struct Mesh_failure : std::exception
{
  std::string status; // the name of a `Diagnosis`
  std::string message;
  std::vector<std::int64_t> faces, vertices; // those that it is about, from 0
  int mesh = 0;                              // the one that these belong to

  Mesh_failure(std::string status, std::string message, std::vector<std::int64_t> faces = {},
               std::vector<std::int64_t> vertices = {}, const int mesh = 0)
      : status(std::move(status)), message(std::move(message)), faces(std::move(faces)),
        vertices(std::move(vertices)), mesh(mesh)
  {}

  const char* what() const noexcept override { return message.c_str(); }
};

// Becomes a `ValueError` in Python.
struct Wrong_value : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

// Becomes a `TypeError` in Python.
struct Wrong_type : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

} // namespace abf_python

#endif // ABF_PYTHON_FAILURES_H
