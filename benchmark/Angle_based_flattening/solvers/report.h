// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_REPORT_H
#define SOLVERS_REPORT_H

#include "Command_line.h"
#include "Measurement.h"
#include "Results.h"
#include "measure.h"

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
         format_number("more than %.0e counts as failed. ", Measurement::largest_residual) +
         "`CGAL::SuperLU_solver_traits` orders in its first factorization, `Eigen::SuperLU` in every one: "
         "order was timed apart, with the functions that they call, and factor is the rest, which for the "
         "former includes the checks of the matrix and of a first solution. "
         "A process was stopped after " +
         std::to_string(command.limits.seconds) + " s, and had " +
         format_number("%g GB of memory.", command.limits.gigabytes);
}

inline std::string measurement_row(const Mesh_results& mesh, const Matrix_results& matrix,
                                   const Solver& solver)
{
  std::vector<std::string> cells = {solver.title, std::to_string(mesh.triangles),
                                    std::to_string(matrix.order)};
  const Measurement m = matrix.of(solver.name);
  if(m.failure.empty()) {
    for(const double seconds : {m.order, m.factor, m.solve, m.total()}) {
      cells.push_back(format_seconds(seconds));
    }
    cells.push_back(m.again < 0 ? "–" : format_seconds(m.again));
    cells.push_back(format_number("%.2f", m.nonzeros / 1e6));
    cells.push_back(format_number("%.0f MB", m.bytes / 1e6));
    cells.push_back(format_number("%.1e", m.residual));
  } else {
    cells.insert(cells.end(), 7, "–");
    cells.push_back("FAILED: " + m.failure);
  }
  return markdown_row(cells);
}

inline std::string table(const std::vector<Mesh_results>& meshes, const Matrix_kind kind)
{
  std::string text = markdown_head({"solver", "triangles", "order of the matrix", "order", "factor", "solve",
                                    "total", "again", "nonzeros", "memory", "residual"},
                                   1);
  for(const Mesh_results& mesh : meshes) {
    for(const Solver& solver : all_solvers()) {
      text += measurement_row(mesh, mesh.matrices[kind], solver);
    }
  }
  return text;
}

// A ratio of two numbers of two solvers, if neither failed
template <class Number>
std::string ratio(const Matrix_results& matrix, const char* a, const char* b, const Number& number)
{
  if(!matrix.has(a) || !matrix.has(b) || matrix.has_failed(a) || matrix.has_failed(b)) {
    return "–";
  }
  return format_number("%.2f", number(matrix.of(a)) / number(matrix.of(b)));
}

inline std::string ratios(const std::vector<Mesh_results>& meshes, const Matrix_kind kind)
{
  const auto total = [](const Measurement& m) { return m.total(); };
  const auto factor = [](const Measurement& m) { return m.factor; };
  std::string text;
  for(const Mesh_results& mesh : meshes) {
    const Matrix_results& matrix = mesh.matrices[kind];
    const bool known = !matrix.has_failed(cgal_superlu);
    const Measurement ours = matrix.of(cgal_superlu);
    text += markdown_row(
        {title(kind), std::to_string(mesh.triangles), ratio(matrix, eigen_superlu, cgal_superlu, total),
         ratio(matrix, cgal_superlu, cholmod, total), ratio(matrix, cgal_superlu, cholmod, factor),
         known ? format_number("%.2f", ours.again / ours.first()) : "–",
         known ? (ours.ordering_reused ? "yes" : "no") : "–"});
  }
  return text;
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
  text += markdown_head({"matrix", "triangles", "`Eigen::SuperLU` / ours, total", "ours / CHOLMOD, total",
                         "ours / CHOLMOD, factor", "ours, second / first factorization", "ordering reused"},
                        1);
  for(const Matrix_kind kind : matrix_kinds) {
    text += internal::ratios(meshes, kind);
  }
  return text;
}

} // namespace solvers

#endif // SOLVERS_REPORT_H
