// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_NEWTON_SYSTEMS_H
#define SOLVERS_NEWTON_SYSTEMS_H

#include "Linear_system.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/newton_step.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/target_angles.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace solvers {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

inline Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    throw std::runtime_error("cannot read a triangle mesh from '" + file + "'");
  }
  return mesh;
}

// Stops a simplification at a number of faces.
struct Face_count
{
  std::size_t faces;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_faces() <= faces;
  }
};

// Makes a mesh of about that many triangles: simplifies it until some number of subdivisions brings it there.
inline Mesh resize_mesh(Mesh mesh, const std::size_t triangles)
{
  int subdivisions = 0;
  std::size_t coarse = triangles;
  for(; coarse > 1.05 * static_cast<double>(mesh.number_of_faces()); coarse /= 4) {
    ++subdivisions;
  }
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, Face_count{coarse});
  mesh.collect_garbage();
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  return mesh;
}

// The matrix of the planarity multipliers alone, which are those of even numbers
inline Linear_system planarity_block(const Linear_system& full)
{
  Linear_system block;
  const int n = full.order() / 2;
  Linear_system::Columns& columns = block.columns();
  columns.resize(n, n);
  columns.reserve(static_cast<Eigen::Index>(full.nonzeros() / 4));
  for(int j = 0; j < n; ++j) {
    columns.startVec(j);
    for(Linear_system::Columns::InnerIterator it(full.columns(), 2 * j); it; ++it) {
      if(it.row() % 2 == 0) {
        columns.insertBack(it.row() / 2, j) = it.value();
      }
    }
  }
  columns.finalize();
  block.right_side.eigen_object() =
      Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>(full.right_side.eigen_object().data(), n);
  return block;
}

// The linear system of the first Newton step: Eq. 16 at the angles where the solver starts.
inline Linear_system first_newton_system(const Mesh& mesh)
{
  namespace abf = CGAL::Surface_mesh_parameterization::internal;
  abf::Chart_reader<Mesh> reader(mesh);
  if(const auto defect = reader.read(CGAL::Polygon_mesh_processing::longest_border(mesh).first)) {
    throw std::runtime_error("the mesh cannot be flattened: " + defect.message);
  }
  const abf::Chart& chart = reader.chart;
  const std::vector<double> beta = abf::target_angles(chart);
  const std::vector<double> alpha = abf::starting_angles(beta);
  const abf::Constraint_vector residuals = abf::constraint_residuals(chart, alpha);
  const abf::Constraint_vector no_multipliers = abf::Constraint_vector::Zero(residuals.size());

  const CGAL::Surface_mesh_parameterization::ABF_plus_plus_options options;
  abf::Newton_system<CGAL::Eigen_solver_traits<>> newton(chart, beta, abf::Angle_energy{options.barrier},
                                                         true, CGAL::Eigen_solver_traits<>());
  Linear_system system;
  system.right_side.eigen_object() = newton.assemble(alpha, no_multipliers, residuals);
  system.columns() = newton.matrix();
  return system;
}

} // namespace solvers

#endif // SOLVERS_NEWTON_SYSTEMS_H
