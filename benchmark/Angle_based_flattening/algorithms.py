#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares SuperLU with the default solvers in other algorithms of CGAL: the heat method, fairing and deformation."""

import argparse
import math
from pathlib import Path

import run
from report import Report, Table, Targets, head

MODELS = ["cow", "homer", "bull", "fandisk", "camel", "armadillo"]
ALGORITHMS = {"heat": "heat method", "fairing": "fairing", "deformation": "deformation"}
SOLVERS = ["eigen", "superlu"]
COLUMNS = [("Eigen", "eigen", "milliseconds"), ("SuperLU", "superlu", "milliseconds"),
           ("SuperLU / Eigen", "ratio", ".2f"), ("difference", "difference", ".0e")]
MOST = 1.1  # of the time with Eigen
LARGEST_DIFFERENCE = 1e-6

CAPTION = """`SuperLU_solver_traits` against the default solver of each algorithm: `Eigen::SimplicialLDLT` of the heat \
method (`Direct`, from one vertex), `Eigen::SparseLU` of fairing (with continuity 1, the interior of a tenth of the \
vertices) and of `Surface_mesh_deformation` (spokes and rims, a region of three tenths of the vertices, 5 iterations). \
Times are CPU times of the whole algorithm, without reading the mesh: runs take milliseconds, so that other processes \
would disturb their wall times. Medians of {options.repeat} runs, each in a process of its own on one thread; each \
ratio is the median of those of two runs side by side. Difference: of the largest and of the mean distance, from the \
source or by which vertices moved, relative; above {limit:g} the row counts as failed.

"""


def difference(one: run.Measurement, other: run.Measurement) -> float:
    """The largest one of what tells of the result, relative"""
    return max(abs(one[name] / other[name] - 1) for name in ("largest", "mean"))


def side_by_side(measure: run.Measure, file: Path, algorithm: str) -> run.Measurement:
    """Both solvers, one after the other"""
    eigen, superlu = (measure.one("algorithm", algorithm, solver, file) for solver in SOLVERS)
    for solver, m in zip(SOLVERS, (eigen, superlu)):
        run.tell(f"{ALGORITHMS[algorithm]} of {file.stem}, {solver}", m)
        if "failure" in m:
            return run.Measurement(failure=f"{solver}: {m['failure']}")
    differs = difference(superlu, eigen)
    if not differs <= LARGEST_DIFFERENCE:
        return run.Measurement(failure=f"the results differ by {differs:.1e}")
    return run.Measurement(triangles=eigen["triangles"], eigen=eigen["cpu"], superlu=superlu["cpu"],
                           ratio=superlu["cpu"] / eigen["cpu"], difference=differs)


def add_targets(targets: Targets, algorithm: str, ratios: list[float]) -> None:
    """A ratio that was not measured makes both not measured."""
    mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
    largest = math.nan if math.isnan(mean) else max(ratios)
    targets.add(f"{algorithm}, SuperLU / Eigen, geometric mean", ".3f", mean, most=MOST)
    targets.add(f"{algorithm}, SuperLU / Eigen, largest", ".3f", largest, most=MOST)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo; without it, a "
                        "closed mesh and an open one of the repository are taken")
    parser.add_argument("--models", type=lambda text: text.split(","), default=MODELS, metavar="NAME,NAME,...",
                        help="of the demo (" + ",".join(MODELS) + ")")
    run.add_options(parser, repeat=5)
    options = parser.parse_args()
    measure = run.measure_of(options)
    files = [run.EXAMPLES / "egg.off", run.SHELL]
    if options.demo:
        files = [options.demo / f"{name}.off" for name in options.models]

    report, targets = Report(options.output), Targets()
    report.add(head("Solvers in other algorithms of CGAL", measure) +
               CAPTION.format(options=options, limit=LARGEST_DIFFERENCE))
    tasks = [(file, algorithm) for algorithm in ALGORITHMS for file in files]
    results = run.interleaved(lambda task: side_by_side(measure, *task), tasks, options.repeat)
    rows = Table(["algorithm", "mesh", "triangles"], COLUMNS, 2)
    for (file, algorithm), m in zip(tasks, results):
        rows.add([ALGORITHMS[algorithm], file.stem, f"{m['triangles']:,.0f}" if "triangles" in m else ""], m)
    for algorithm, name in ALGORITHMS.items():
        add_targets(targets, name, [m["ratio"] for (_, of), m in zip(tasks, results) if of == algorithm])
    report.add(f"{rows}{targets}")


if __name__ == "__main__":
    main()
