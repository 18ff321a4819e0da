#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows how the error of the greedy unfolding accumulates (Section 4 of the paper), and that of our layouts does
not: the largest closing error against the number of triangles, for the same angles."""

import argparse
from pathlib import Path

import run
from report import Report, Table, head

LAYOUTS = {"greedy": "greedy unfolding", "least_squares": "least squares", "exact": "exact"}
COLUMNS = [("largest residual", "residual", ".1e"),
           *(column for name, title in LAYOUTS.items()
             for column in ((title, name, ".1e"), ("flips", name + "_flips", ".0f")))]


def plot(results: list[tuple[float, run.Measurement]], tolerances: list[float], file: Path) -> None:
    import matplotlib.pyplot as plt  # only where something is drawn
    figure, axes = plt.subplots(figsize=(9, 6), layout="constrained")
    for tolerance, marker in zip(tolerances, "os^vD*"):
        for k, (layout, title) in enumerate(LAYOUTS.items()):
            points = [(m["triangles"], m[layout]) for of, m in results if of == tolerance]
            axes.loglog(*zip(*points), color=f"C{k}", marker=marker,
                        label=f"{title}, |grad F| ≤ {tolerance:g}")
    axes.set(xlabel="triangles", ylabel="largest closing error, relative to the triangle")
    axes.grid(alpha=0.4)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=3, fontsize="small")
    figure.savefig(file)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    run.add_mesh(parser, "--mesh")
    parser.add_argument("--sizes", type=run.numbers, default="1000,3000,10000,30000,100000,300000",
                        metavar="N,N,...", help="numbers of triangles (%(default)s)")
    parser.add_argument("--tolerances", type=run.numbers, default="1,1e-3,1e-6", metavar="X,X,...",
                        help="where the solver of the angles stops: at that norm of grad F")
    parser.add_argument("--svg", type=Path, metavar="FILE", help="draw the errors into that file")
    run.add_options(parser, repeat=0)
    options = parser.parse_args()
    measure = run.measure_of(options)

    results, table = [], Table(["triangles", "norm of grad F"], COLUMNS, 0)
    for size in options.sizes:
        for tolerance in options.tolerances:
            m = measure.one("layouts", measure.resized(options.mesh, size), tolerance)
            results.append((tolerance, m))
            table.add([m.get("triangles", size), f"{tolerance:g}"], m)
    Report(options.output).add(head("Closing errors of layouts", measure) +
                               "The largest closing error of the triangles, relative to their size, of three "
                               f"layouts of the same angles.\n\n{table}")
    if options.svg:
        plot(results, options.tolerances, options.svg)


if __name__ == "__main__":
    main()
