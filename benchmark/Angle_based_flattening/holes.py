#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens surfaces with holes: disks with punched holes, rings and tubes, and scans. Their holes are solved as they are, or
filled; CGAL's LSCM is the third method."""

import argparse
import math
from pathlib import Path

import run
from report import Report, Table, head

PUNCHED = [("lionhead", 5, 8), ("bunny", 5, 20), ("bunny", 50, 6), ("bunny", 300, 3), ("horse", 300, 3),
           ("camel", 50, 3)]  # the disk, the number of holes, and the rings of triangles that each removes
SCANS = ["lion", "mech-holes-shark", "holes", "head", "pig"]
METHODS = {"abf++": "solved", "abf++-fill": "filled", "lscm": "LSCM (CGAL)"}
COLUMNS = [("energy", "energy", ".3e"), ("L2 stretch", "stretch", ".3f"), ("Newton steps", "newton_steps", ".0f"),
           ("CG steps", "cg_steps", ".0f"), ("seconds", "seconds", "seconds"), ("flips", "flips", ".0f")]


def write_tube(file: Path, around: int, rows: int, inner: float, height: float) -> None:
    """A ring between the radii `inner` and 1, or a tube where these are equal, of almost equilateral triangles"""
    with file.open("w", encoding="ascii") as out:
        out.write(f"OFF\n{around * (rows + 1)} {2 * around * rows} 0\n")
        for j in range(rows + 1):
            radius = inner + (1 - inner) * j / rows
            for i in range(around):
                angle = math.tau * (i + j / 2) / around
                out.write(f"{radius * math.cos(angle)!r} {radius * math.sin(angle)!r} {height * j / rows!r}\n")
        for j in range(rows):
            for i in range(around):
                a, b = j * around + i, j * around + (i + 1) % around
                out.write(f"3 {a} {a + around} {b}\n3 {b} {a + around} {b + around}\n")


def surfaces(options: argparse.Namespace, measure: run.Measure) -> list[tuple[str, Path]]:
    folder = Path(run.FOLDER.name)
    found = []
    for name, holes, rings in PUNCHED[:options.most]:
        disk = options.data / f"{name}_disk.ply" if options.data else run.SHELL
        file = folder / f"{name}_{holes}_{rings}.ply"
        m = measure.mesh(disk, "--holes", holes, "--rings", rings, "--output", file)
        if "failure" in m:
            raise SystemExit(f"{disk}: {m['failure']}")
        found.append((f"{name}, {m['holes']:.0f} holes of {rings} rings", file))
    for name, around, rows, inner, height in [("ring", 400, 100, 0.8, 0.05), ("tube as long as wide", 100, 116, 1, math.tau)]:
        file = folder / f"{name.split()[0]}.off"
        write_tube(file, around, rows, inner, height)
        found.append((name, file))
    if options.demo:
        found += [(name, options.demo / f"{name}.off") for name in SCANS]
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, metavar="FOLDER", help="with the disks; without it, the bundled one is punched")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--most", type=int, default=len(PUNCHED), metavar="N", help="punched disks (%(default)s)")
    parser.add_argument("--threads", type=int, default=1, metavar="N", help="of each process (%(default)s)")
    run.add_options(parser)
    options = parser.parse_args()
    measure = run.measure_of(options)

    table = Table(["surface", "triangles", "holes are"], COLUMNS, 3)
    for name, file in surfaces(options, measure):
        tasks = list(METHODS)
        results = run.interleaved(lambda method: measure.one("flatten", method, file, threads=options.threads),
                                  tasks, options.repeat)
        for method, m in zip(tasks, results):
            run.tell(f"{name}, {METHODS[method]}", m)
            table.add([name, f"{m['triangles']:,.0f}" if "triangles" in m else "", METHODS[method]], m)
    Report(options.output).add(head("Surfaces with holes", measure) +
                               "Each surface in three ways. The energy is that of the surface's own triangles.\n\n"
                               f"{table}")


if __name__ == "__main__":
    main()
