// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_REPORT_H
#define SOLVERS_REPORT_H

#include "Command_line.h"
#include "Results.h"
#include "measure.h"

#include "../common/Measurement.h"
#include "../common/Table.h"
#include "../common/command_text.h"
#include "../common/describe_machine.h"
#include "../common/format.h"

#include <string>
#include <vector>

namespace solvers {

using namespace benchmarks;

namespace internal {

inline std::string title(const Matrix_kind kind)
{
  return kind == PLANARITY_BLOCK ? "Scalar diagonal block of S" : "Full matrix S";
}

inline std::string caption(const Command_line& command)
{
  return "Medians of " + std::to_string(command.repeat) +
         " runs, each in a process of its own and on one thread (`OPENBLAS_NUM_THREADS=1`). "
         "S is the matrix of the first Newton step, its scalar block the one of the planarity constraints, "
         "and the right-hand side is that of the step. Times are in seconds. "
         "Again: a second factorization, other values in the same pattern. "
         "Nonzeros of the factors, in millions: L and U for SuperLU, L alone for the others. "
         "Memory: peak resident size beyond that of the matrix, up to the first solution. "
         "Residual: |Ax - b| / |b|, the larger one of both factorizations; " +
         format_number("more than %.0e counts as failed. ", largest_residual) +
         "`CGAL::SuperLU_solver_traits` orders in its first factorization, `Eigen::SuperLU` in every one: "
         "order was timed apart, with the functions that they call, and factor is the rest, which for the "
         "former includes the checks of the matrix and of a first solution. "
         "A process was stopped after " +
         std::to_string(command.limits.seconds) + " s, and had " +
         format_number("%g GB of memory.", command.limits.gigabytes);
}

inline void add_row(Table& table, const Mesh_results& mesh, const Matrix_results& matrix,
                    const Solver& solver)
{
  std::vector<std::string> cells = {solver.title, std::to_string(mesh.triangles),
                                    std::to_string(matrix.order)};
  const Measurement m = matrix.of(solver.name);
  if(!m.succeeded()) {
    table.add_failure(cells, m);
    return;
  }
  for(const double seconds : {m["order"], m["factor"], m["solve"], total_seconds(m), m["again"]}) {
    cells.push_back(seconds_cell(seconds));
  }
  cells.push_back(cell("%.2f", m["nonzeros"] / 1e6));
  cells.push_back(cell("%.0f MB", m["bytes"] / 1e6));
  cells.push_back(cell("%.1e", m["residual"]));
  table.add(cells);
}

inline std::string table(const std::vector<Mesh_results>& meshes, const Matrix_kind kind)
{
  Table table({"solver", "triangles", "order of the matrix", "order", "factor", "solve", "total", "again",
               "nonzeros", "memory", "residual"},
              1);
  for(const Mesh_results& mesh : meshes) {
    for(const Solver& solver : all_solvers()) {
      add_row(table, mesh, mesh.matrices[kind], solver);
    }
  }
  return table.text();
}

inline void add_ratios(Table& table, const Mesh_results& mesh, const Matrix_kind kind)
{
  const Matrix_results& matrix = mesh.matrices[kind];
  const Measurement ours = matrix.of(cgal_superlu), eigens = matrix.of(eigen_superlu),
                    cholmods = matrix.of(cholmod);
  table.add(
      {title(kind), std::to_string(mesh.triangles), cell("%.2f", total_seconds(eigens) / total_seconds(ours)),
       cell("%.2f", total_seconds(ours) / total_seconds(cholmods)),
       cell("%.2f", ours["factor"] / cholmods["factor"]), cell("%.2f", ours["again"] / first_seconds(ours)),
       !ours.succeeded()              ? "–"
       : ours["ordering_reused"] == 1 ? "yes"
                                      : "no"});
}

} // namespace internal

// Everything, in Markdown.
inline std::string report(const std::vector<Mesh_results>& meshes, const Command_line& command)
{
  std::string text = "# Sparse direct solvers on the matrices of ABF++\n\n" + command_text() +
                     describe_machine() + "\n\n" + internal::caption(command) + "\n";
  for(const Matrix_kind kind : matrix_kinds) {
    text += "\n## " + internal::title(kind) + "\n\n" + internal::table(meshes, kind);
  }
  text +=
      "\n## Ratios\n\n"
      "Ours is `CGAL::SuperLU_solver_traits`; total is order + factor + solve. Targets: `Eigen::SuperLU` / "
      "ours "
      "at least 2 from 100,000 triangles on; ours / CHOLMOD at most 2.2 on the scalar block at 1,500,000; "
      "a second factorization with the same pattern does not order again.\n\n";
  Table ratios({"matrix", "triangles", "`Eigen::SuperLU` / ours, total", "ours / CHOLMOD, total",
                "ours / CHOLMOD, factor", "ours, second / first factorization", "ordering reused"},
               1);
  for(const Matrix_kind kind : matrix_kinds) {
    for(const Mesh_results& mesh : meshes) {
      internal::add_ratios(ratios, mesh, kind);
    }
  }
  return text + ratios.text();
}

} // namespace solvers

#endif // SOLVERS_REPORT_H
