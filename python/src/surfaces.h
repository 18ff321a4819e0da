// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_SURFACES_H
#define ABF_PYTHON_SURFACES_H

#include "failures.h"
#include "interruptible.h"
#include "marked_edges.h"
#include "models.h"

#include "flatten_mesh/Failure.h"
#include "flatten_mesh/atlas/Atlas_input.h"

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

using flatten_mesh::Edge;
using flatten_mesh::Face;
using flatten_mesh::Halfedge;
using flatten_mesh::Mesh;
using flatten_mesh::Vertex;

// The surface of a mesh that has to be an oriented manifold. Its vertices are those of the model, in their order.
using Surface = flatten_mesh::Atlas_input;

// Calls a function that may throw exceptions of the program.
template <class Function>
auto with_failures(const Function& f)
{
  try {
    return f();
  } catch(const py::builtin_exception&) {
    throw;
  } catch(const Mesh_failure&) {
    throw;
  } catch(const std::bad_alloc&) {
    throw;
  } catch(const flatten_mesh::Input_error& error) {
    const flatten_mesh::Failure failure = flatten_mesh::current_failure();
    throw Mesh_failure(failure.name, failure.message, {error.faces.begin(), error.faces.end()},
                       {error.vertices.begin(), error.vertices.end()});
  } catch(...) {
    const flatten_mesh::Failure failure = flatten_mesh::current_failure();
    throw Mesh_failure(failure.name, failure.message);
  }
}

// The vertices of faces with a coordinate that is no finite number
inline std::vector<std::int64_t> non_finite_vertices(const Model& model)
{
  std::vector<std::int64_t> vertices;
  for(const Index v : model.vertices) {
    const Kernel::Point_3& p = model.points[v];
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
      vertices.push_back(v);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

inline Surface surface_of(Model&& model)
{
  return with_failures([&model] {
    flatten_mesh::Command_line quiet;
    quiet.quiet = true;
    flatten_mesh::Notes notes = notes_of(quiet);
    const std::vector<std::int64_t> non_finite = non_finite_vertices(model);
    Surface surface =
        flatten_mesh::atlas_input_of(std::move(model), false, notes, {flatten_mesh::Welding::NONE, 0});
    if(!surface.set_aside.empty()) {
      const flatten_mesh::Skipped_part& part = surface.set_aside.front();
      throw Mesh_failure(part.status, part.message, {static_cast<std::int64_t>(part.first_face)}, non_finite);
    }
    return surface;
  });
}

// The faces of the model, sorted, each once
template <class Faces>
std::vector<std::int64_t> faces_in_model(const Surface& surface, const Faces& faces)
{
  std::vector<std::int64_t> result;
  for(const Face f : faces) {
    result.push_back(static_cast<std::int64_t>(flatten_mesh::face_in_file(surface, f)));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Throws if a report says that something is wrong.
template <class Report>
void check_report(const Surface& surface, const Report& report)
{
  if(report.status == SMP::Diagnosis::WRONG_OPTION) {
    throw py::value_error(report.message);
  }
  if(!report) {
    std::vector<std::int64_t> vertices;
    for(const Vertex v : report.offending_vertices) {
      vertices.push_back(v.idx());
    }
    for(const Edge e : report.offending_edges) {
      vertices.push_back(surface.mesh.vertex(e, 0).idx());
      vertices.push_back(surface.mesh.vertex(e, 1).idx());
    }
    throw Mesh_failure(to_string(report.status), report.message,
                       faces_in_model(surface, report.offending_faces), std::move(vertices));
  }
}

// The coordinates of a model with one for each corner
inline Mesh::Property_map<Halfedge, Kernel::Point_2> corner_map(Surface& surface)
{
  const auto uv = surface.mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  for(const Halfedge h : surface.mesh.halfedges()) {
    if(!surface.mesh.is_border(h)) {
      uv[h] = surface.model.texture[surface.origins.corners[h.idx()]];
    }
  }
  return uv;
}

// The coordinates of each corner of the model
inline std::vector<Kernel::Point_2> corners_of(const Surface& surface,
                                               const Mesh::Property_map<Halfedge, Kernel::Point_2>& uv)
{
  std::vector<Kernel::Point_2> corners(surface.model.number_of_corners());
  for(const Halfedge h : surface.mesh.halfedges()) {
    if(!surface.mesh.is_border(h)) {
      corners[surface.origins.corners[h.idx()]] = uv[h];
    }
  }
  return corners;
}

// The marked edges of a mesh, as vertices
inline Vertex_pairs marked_pairs(const Mesh& mesh, const flatten_mesh::Edge_marks& marks)
{
  Vertex_pairs pairs;
  for(const Edge e : mesh.edges()) {
    if(marks[e]) {
      pairs.emplace_back(std::minmax<Index>(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx()));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace abf_python

#endif // ABF_PYTHON_SURFACES_H
