// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares sparse direct solvers on the matrices of ABF++: SuperLU through CGAL and through Eigen, Eigen's own, and
// CHOLMOD. Prints Markdown tables. `solvers --sizes 20000,100000 --output results.md`; see `--help`.

#include "solvers/measure.h" // first: it includes <Eigen/SuperLUSupport>

#include "solvers/Command_line.h"
#include "solvers/Results.h"
#include "solvers/newton_systems.h"
#include "solvers/report.h"

#include "common/Report.h"
#include "common/Temporary_folder.h"
#include "common/measure_in_child.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace solvers {

std::string matrix_file(const Temporary_folder& folder, const Matrix_kind kind)
{
  return folder.file(kind == PLANARITY_BLOCK ? "planarity_block" : "full_matrix");
}

void write_matrix(const Linear_system& system, const Temporary_folder& folder, const Matrix_kind kind,
                  Mesh_results& results)
{
  results.matrices[kind].order = system.order();
  write_system(system, matrix_file(folder, kind));
}

// Makes both matrices of a mesh of that size. They and the mesh are out of memory again when this returns.
Mesh_results write_matrices(const Mesh& base, const std::size_t triangles, const Temporary_folder& folder)
{
  Mesh_results results;
  const Mesh mesh = resize_mesh(base, triangles);
  results.asked_triangles = triangles;
  results.triangles = mesh.number_of_faces();
  const Linear_system full = first_newton_system(mesh);
  write_matrix(full, folder, FULL_MATRIX, results);
  write_matrix(planarity_block(full), folder, PLANARITY_BLOCK, results);
  return results;
}

void tell(const Mesh_results& mesh, const Matrix_kind kind, const Solver& solver, const Measurement& m)
{
  std::cerr << mesh.triangles << " triangles, order " << mesh.matrices[kind].order << ", " << solver.name
            << ": " << outcome_text(m, total_seconds(m)) << std::endl;
}

// Solver by solver, and then all of them again, so that a disturbance does not hit one solver only.
void measure_matrix(const Command_line& command, const std::string& file, const Matrix_kind kind,
                    Mesh_results& results)
{
  Matrix_results& matrix = results.matrices[kind];
  for(int run = 0; run < command.repeat; ++run) {
    for(const Solver& solver : all_solvers()) {
      if(!matrix.has_failed(solver.name)) {
        const Measurement measurement =
            measure_in_child({"--measure", solver.name, "--matrix", file}, command.limits);
        matrix.measurements[solver.name].push_back(measurement);
        tell(results, kind, solver, measurement);
      }
    }
  }
}

Mesh_results measure_mesh(const Command_line& command, const Mesh& base, const std::size_t triangles)
{
  const Temporary_folder folder;
  Mesh_results results = write_matrices(base, triangles, folder);
  for(const Matrix_kind kind : matrix_kinds) {
    measure_matrix(command, matrix_file(folder, kind), kind, results);
  }
  return results;
}

void run(const Command_line& command)
{
  const Mesh base = read_mesh(command.mesh);
  std::vector<Mesh_results> results;
  for(const std::size_t triangles : command.triangles()) {
    results.push_back(measure_mesh(command, base, triangles));
  }
  Report(command.output).add(report(results, command));
}

} // namespace solvers

int main(int argc, char* argv[])
{
  using namespace solvers;
  try {
    const Command_line command = parse_command_line(argc, argv);
    if(command.help) {
      std::cout << help_text();
    } else if(!command.measure.empty()) {
      std::cout << to_text(measure(command.measure, command.matrix)) << std::flush;
    } else {
      run(command);
    }
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "solvers: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
