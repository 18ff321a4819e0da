// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// g++ 12 warns of an optional in CGAL's code, which it takes for uninitialized.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "flatten_mesh/bake/simplify_input.h"

#include "flatten_mesh/texts.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <string>
#include <utility>

namespace flatten_mesh {

namespace {

// Quicker than with exact predicates, which the placement of vertices does not need
using Quick_kernel = CGAL::Simple_cartesian<double>;
using Quick_mesh = CGAL::Surface_mesh<Quick_kernel::Point_3>;

Quick_mesh simplified(const Mesh& mesh, const std::size_t triangles)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  Quick_mesh result;
  CGAL::copy_face_graph(mesh, result);
  SMS::edge_collapse(
      result,
      [&result, triangles](const auto&, const auto&, auto, auto) {
        return result.number_of_faces() <= triangles;
      },
      CGAL::parameters::filter(SMS::Bounded_normal_change_filter<>()));
  result.collect_garbage();
  return result;
}

} // namespace

void simplify_input(const std::size_t triangles, Atlas_input& input, Notes& notes)
{
  const std::size_t before = input.mesh.number_of_faces();
  if(before <= triangles) {
    notes.add("the surface has " + count_text(before, "triangle") + ": --simplify does not change it");
    return;
  }
  const Quick_mesh mesh = simplified(input.mesh, triangles);
  const std::size_t after = mesh.number_of_faces();
  Atlas_input result = atlas_input_of(model_of_mesh(mesh, input.model.name), true, notes, {Welding::NONE, 0});
  result.set_aside.insert(result.set_aside.begin(), input.set_aside.begin(), input.set_aside.end());
  input = std::move(result);
  notes.add("simplified from " + count_text(before, "triangle") + " to " + std::to_string(after) +
            (after > triangles ? ", and no further, so that no face is flipped and no part is lost" : "") +
            ": the output is this surface, without groups, materials, normals and colours of the file");
}

} // namespace flatten_mesh
