#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares sparse direct solvers on the matrices of ABF++, also in single precision."""

import argparse

import run
from report import Report, Table, cell, head, table

SOLVERS = {"superlu": "SuperLU, `CGAL::SuperLU_solver_traits`",
           "eigen-superlu": "SuperLU, `Eigen::SuperLU`",
           "eigen-ldlt": "`Eigen::SimplicialLDLT`",
           "cholmod": "CHOLMOD, `Eigen::CholmodSupernodalLLT`"}
MATRICES = {"block": "Scalar diagonal block of S", "full": "Full matrix S"}
COLUMNS = [("order of the matrix", "unknowns", ".0f"),
           *((name, name, "seconds") for name in ("order", "factor", "solve", "total", "again")),
           ("nonzeros", "millions_of_nonzeros", ".2f"), ("memory, MB", "megabytes", ".0f"),
           ("residual", "residual", ".1e")]
RATIOS = ["matrix", "triangles", "`Eigen::SuperLU` / ours, total", "ours / CHOLMOD, total",
          "ours / CHOLMOD, factor", "ours, second / first factorization", "ordering reused"]

SINGLE = [("unknowns", "unknowns", ".0f"),
          *((f"{name}: {solver}", f"{solver.lower()} {name}", "milliseconds")
            for name in ("order", "factor", "solve", "run") for solver in ("SuperLU", "Eigen")),
          ("run: Eigen / SuperLU", "ratio", ".2f"),
          *((f"residual: {solver}", f"{solver.lower()} residual", ".1e") for solver in ("SuperLU", "Eigen"))]

CAPTION = """Medians of {options.repeat} runs, each in a separate process on one thread \
(`OPENBLAS_NUM_THREADS=1`). S is the matrix of the first Newton step. Its scalar block is that of the planarity \
constraints. The right-hand side is that of the step. Times are in seconds. Again: a second factorization, with \
other values in the same pattern. Nonzeros of the factors are in millions: L and U for SuperLU, L alone for the \
others. Memory: peak resident size up to the first solution, without the matrix. Residual: |Ax - b| / |b|, the \
larger one of both factorizations; above 1e-08 the run counts as failed. `Eigen::SuperLU` orders in every \
factorization. Its ordering was timed separately, with the functions that it calls; factor is the rest. Limits of \
a process: {options.timeout:g} s, {options.memory:g} GB of memory.
"""
RATIOS_CAPTION = """
## Ratios

Ours is `CGAL::SuperLU_solver_traits`; total is order + factor + solve. Targets: `Eigen::SuperLU` / ours at least \
2 from 100,000 triangles on; ours / CHOLMOD at most 2.2 on the scalar block; a second factorization with the same \
pattern reuses the ordering.

"""
SINGLE_CAPTION = """
## Both scalar blocks in single precision

The counterpart of lower precision of `CGAL::SuperLU_solver_traits`, and `Eigen::SimplicialLLT`, in turn in one process.
Least processor times of {options.repeat} rounds, each for both blocks. Run: what the direct method takes of them, that
is, orders, three factorizations and 30 solutions.

"""


def measure_size(measure: run.Measure, options: argparse.Namespace, triangles: int) -> dict:
    """The results of each matrix and solver"""
    def solve(task: tuple[str, str]) -> run.Measurement:
        m = measure.one("solve", task[1], file, task[0])
        m["first"] = m["order"] + m["factor"]
        m["total"] = m["first"] + m["solve"]
        m["megabytes"] = m["bytes"] / 1e6
        m["millions_of_nonzeros"] = m["nonzeros"] / 1e6
        run.tell(f"{file.stem}, {', '.join(task)}", m, "total")
        return m

    file = measure.resized(options.mesh, triangles)
    tasks = [(matrix, solver) for matrix in MATRICES for solver in options.solvers]
    return dict(zip(tasks, run.interleaved(solve, tasks, options.repeat)))


def ratio_row(results: dict, matrix: str, triangles: int) -> list[str]:
    ours, eigens, cholmods = (results.get((matrix, solver), run.Measurement())
                              for solver in ("superlu", "eigen-superlu", "cholmod"))
    ratios = [eigens["total"] / ours["total"], ours["total"] / cholmods["total"],
              ours["factor"] / cholmods["factor"], ours["again"] / ours["first"]]
    return [MATRICES[matrix], str(ours.get("triangles", triangles)),
            *(cell(number, ".2f") for number in ratios), cell(ours["ordering_reused"], "yes")]


def measure_single(measure: run.Measure, options: argparse.Namespace, triangles: int) -> run.Measurement:
    """SuperLU and Eigen, whose ratio is of one process"""
    m = measure.one("scalar-blocks", measure.resized(options.mesh, triangles), "--repeat", options.repeat)
    m["ratio"] = m["eigen run"] / m["superlu run"]
    return m


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    run.add_mesh(parser, nargs="?")
    parser.add_argument("--sizes", type=run.numbers, default="20000,100000,400000,1500000", metavar="N,N,...",
                        help="numbers of triangles (%(default)s)")
    parser.add_argument("--solvers", type=run.words(SOLVERS), default=",".join(SOLVERS),
                        metavar="NAME,NAME,...", help="which (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)
    results = {size: measure_size(measure, options, size) for size in options.sizes}

    report = Report(options.output)
    report.add(head("Sparse direct solvers on the matrices of ABF++", measure) +
               CAPTION.format(options=options))
    for matrix, title in MATRICES.items():
        solvers = Table(["solver", "triangles"], COLUMNS)
        for size, measured in results.items():
            for (of, solver), m in measured.items():
                if of == matrix:
                    solvers.add([SOLVERS[solver], m.get("triangles", size)], m)
        report.add(f"\n## {title}\n\n{solvers}")
    single = Table(["triangles"], SINGLE)
    for size in options.sizes:
        m = measure_single(measure, options, size)
        single.add([m.get("triangles", size)], m)
    report.add(f"{SINGLE_CAPTION.format(options=options)}{single}")
    report.add(RATIOS_CAPTION + table(RATIOS, [ratio_row(measured, matrix, size) for matrix in MATRICES
                                               for size, measured in results.items()]))


if __name__ == "__main__":
    main()
