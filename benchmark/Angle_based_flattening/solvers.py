#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Compares sparse direct solvers on the matrices of ABF++."""

import argparse
import tempfile
from pathlib import Path

import run
from report import Report, cell, count, failure_row, head, ratio, seconds, table

SOLVERS = {"superlu": "SuperLU, `CGAL::SuperLU_solver_traits`",
           "eigen-superlu": "SuperLU, `Eigen::SuperLU`",
           "eigen-ldlt": "`Eigen::SimplicialLDLT`",
           "cholmod": "CHOLMOD, `Eigen::CholmodSupernodalLLT`"}
MATRICES = {"block": "Scalar diagonal block of S", "full": "Full matrix S"}
TITLES = ["solver", "triangles", "order of the matrix", "order", "factor", "solve", "total", "again",
          "nonzeros", "memory", "residual"]
RATIO_TITLES = ["matrix", "triangles", "`Eigen::SuperLU` / ours, total", "ours / CHOLMOD, total",
                "ours / CHOLMOD, factor", "ours, second / first factorization", "ordering reused"]


def caption(options: argparse.Namespace) -> str:
    return (
        f"Medians of {options.repeat} runs, each in a process of its own and on one thread "
        "(`OPENBLAS_NUM_THREADS=1`). S is the matrix of the first Newton step, its scalar block the "
        "one of the planarity constraints, and the right-hand side is that of the step. Times are in "
        "seconds. Again: a second factorization, other values in the same pattern. Nonzeros of the "
        "factors, in millions: L and U for SuperLU, L alone for the others. Memory: peak resident size "
        "beyond that of the matrix, up to the first solution. Residual: |Ax - b| / |b|, the larger one "
        "of both factorizations; more than 1e-08 counts as failed. `Eigen::SuperLU` orders in every "
        "factorization: order was timed apart, with the functions that it calls, and factor is the "
        "rest. A process was stopped after "
        f"{options.timeout:g} s, and had {options.memory:g} GB of memory.\n")


def measure_size(measure: run.Measure, options: argparse.Namespace, triangles: int) -> dict:
    """The results of each matrix and solver"""
    def solve(task: tuple[str, str]) -> run.Measurement:
        matrix, solver = task
        result = measure.one("solve", solver, file, matrix)
        if "failure" not in result:
            result["first"] = result["order"] + result["factor"]
            result["total"] = result["first"] + result["solve"]
        run.tell(f"{file.stem}, {matrix}, {solver}", {"seconds": result.get("total", 0)} | result)
        return result

    tasks = [(matrix, solver) for matrix in MATRICES for solver in options.solvers.split(",")]
    with tempfile.TemporaryDirectory() as folder:
        file = measure.resized(options.mesh, triangles, folder)
        return dict(zip(tasks, run.interleaved(solve, tasks, options.repeat)))


def solver_row(triangles: int, solver: str, m: run.Measurement) -> list[str]:
    cells = [SOLVERS[solver], count(m.get("triangles", triangles)), count(m.get("unknowns"))]
    if "failure" in m:
        return failure_row(cells, m, len(TITLES))
    times = [seconds(m.get(name)) for name in ("order", "factor", "solve", "total", "again")]
    return [*cells, *times, cell(m["nonzeros"] / 1e6, ".2f"), cell(m["bytes"] / 1e6, ".0f") + " MB",
            cell(m["residual"], ".1e")]


def ratio_row(results: dict, triangles: int, matrix: str) -> list[str]:
    ours, eigens, cholmods = (results.get((matrix, solver), {})
                              for solver in ("superlu", "eigen-superlu", "cholmod"))
    ratios = [ratio(eigens.get("total"), ours.get("total")), ratio(ours.get("total"), cholmods.get("total")),
              ratio(ours.get("factor"), cholmods.get("factor")), ratio(ours.get("again"), ours.get("first"))]
    reused = {1: "yes", 0: "no"}.get(ours.get("ordering_reused"), "–")
    return [MATRICES[matrix], count(ours.get("triangles", triangles)), *(cell(r, ".2f") for r in ratios), reused]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesh", nargs="?", type=Path, default=run.SHELL, help="a disk, which is "
                        "simplified or subdivided; by default the sea shell of the examples")
    parser.add_argument("--sizes", type=run.numbers, default="20000,100000,400000,1500000",
                        metavar="N,N,...", help="numbers of triangles (%(default)s)")
    parser.add_argument("--solvers", default=",".join(SOLVERS), help="which (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)
    results = {size: measure_size(measure, options, size) for size in options.sizes}

    report = Report(options.output)
    report.add(head("Sparse direct solvers on the matrices of ABF++", measure) + caption(options))
    for matrix, title in MATRICES.items():
        rows = [solver_row(size, solver, m) for size, measured in results.items()
                for (of, solver), m in measured.items() if of == matrix]
        report.add(f"\n## {title}\n\n" + table(TITLES, rows))
    report.add("\n## Ratios\n\nOurs is `CGAL::SuperLU_solver_traits`; total is order + factor + solve. "
               "Targets: `Eigen::SuperLU` / ours at least 2 from 100,000 triangles on; ours / CHOLMOD "
               "at most 2.2 on the scalar block at 1,500,000; a second factorization with the same "
               "pattern does not order again.\n\n" +
               table(RATIO_TITLES, [ratio_row(measured, size, matrix) for matrix in MATRICES
                                    for size, measured in results.items()]))


if __name__ == "__main__":
    main()
