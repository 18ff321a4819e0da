#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the CPU time of `flatten_mesh` on what is slow for its size: thousands of small parts, a few parts of some triangles,
and scaffolds with many handles."""

import argparse
import json
import math
import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import run
from report import Report, Table, Targets, head

Point, Face = tuple[float, float, float], tuple[int, int, int]
Part = tuple[list[Point], list[Face]]
COLUMNS = [("charts", "charts", ",.0f"), ("covered", "covered", ".1%"), ("CPU s", "cpu", "seconds"), ("ms a part", "each", ".2f"),
           ("s per 100k triangles", "rate", ".1f"), ("peak MB", "memory", ".0f")]


def icosahedron(_: int) -> Part:
    g = (1 + math.sqrt(5)) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
              (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    return points, faces


def cube(_: int) -> Part:
    points = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    return points, [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
                    (1, 3, 7), (1, 7, 5)]


def fan(number: int) -> Part:
    """A cone of 3 to 80 long triangles"""
    n = 3 + number * 37 % 78
    rim = [(math.cos(math.tau * i / n), math.sin(math.tau * i / n), 0.0) for i in range(n)]
    return [(0, 0, 0.5 + number % 7 / 7), *rim], [(0, 1 + i, 1 + (i + 1) % n) for i in range(n)]


def many(shape: Callable[[int], Part], number: int) -> Iterator[Part]:
    """On a grid, in ten sizes"""
    for i in range(number):
        points, faces = shape(i)
        size, shift = 0.5 + i % 10 / 10, (4 * (i % 100), 4 * (i // 100 % 100), 4 * (i // 10000))
        yield [tuple(size * x + d for x, d in zip(p, shift)) for p in points], faces


def scaffold(n: int) -> Iterator[Part]:
    """The surface of bars of unit cubes along the edges of a grid of n^3 cells"""
    def is_solid(cell: tuple[int, ...]) -> bool:
        return all(0 <= x <= 2 * n for x in cell) and sum(x % 2 for x in cell) <= 1

    index: dict[Point, int] = {}
    faces: list[Face] = []
    size = range(2 * n + 1)
    for cell in ((x, y, z) for x in size for y in size for z in size):
        for axis in range(3) if is_solid(cell) else ():
            for side in (0, 1):
                if is_solid(tuple(x + (2 * side - 1) * (k == axis) for k, x in enumerate(cell))):
                    continue
                corners = []
                for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = list(cell)
                    p[axis] += side
                    p[(axis + 1) % 3] += u
                    p[(axis + 2) % 3] += v
                    corners.append(index.setdefault(tuple(p), len(index)))
                a, b, c, d = corners if side else reversed(corners)
                faces += [(a, b, c), (a, c, d)]
    yield list(index), faces


def write(file: Path, parts: Iterator[Part]) -> None:
    points, faces = [], []
    for p, f in parts:
        faces += [[v + len(points) for v in face] for face in f]
        points += p
    with file.open("w", encoding="ascii") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in points)
        out.writelines(f"3 {a} {b} {c}\n" for a, b, c in faces)


def measure_file(options: argparse.Namespace, file: Path, resolution: int) -> run.Measurement:
    process = subprocess.Popen([options.program, file, "--for", "few-charts", "--threads", "1", "--resolution", str(resolution), "--json", "-"],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    text = process.stdout.read()
    _, _, usage = os.wait4(process.pid, 0)
    result = json.loads(text)
    if result["status"] != "OK":
        return run.Measurement(failure=result["message"])
    seconds, triangles = usage.ru_utime + usage.ru_stime, result["triangles"]
    return run.Measurement(seconds=seconds, cpu=seconds, triangles=triangles, rate=1e5 * seconds / triangles, parts=result["components"],
                           charts=len(result["atlas"]["charts"]), each=1e3 * seconds / result["components"],
                           covered=result["atlas"]["packing"]["covered_share"], memory=result["peak_memory_mb"])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--parts", type=run.numbers, default="1000,10000,100000", metavar="N,N,...", help="small parts (%(default)s)")
    parser.add_argument("--cells", type=run.numbers, default="2,4,8", metavar="N,N,...", help="along a scaffold (%(default)s)")
    parser.add_argument("--program", type=Path, metavar="PROGRAM", help="what flattens (%(default)s)",
                        default=run.ROOT / "build/apps/flatten_mesh/flatten_mesh")
    run.add_options(parser, repeat=1)
    options = parser.parse_args()
    measure = run.measure_of(options)

    cases = [("2 cubes", many(cube, 2), 1024)]
    for number in options.parts:
        resolution = 1024 if number <= 10000 else 4096
        cases += [(f"{number:,} {name}", many(shape, number), resolution)
                  for name, shape in (("icosahedra", icosahedron), ("cubes", cube), ("fans of 3 to 80 triangles", fan))]
    cases += [(f"scaffold of {n}^3 cells", scaffold(n), 1024) for n in options.cells]
    table, targets = Table(["surface", "triangles", "resolution"], COLUMNS, 1), Targets()
    for name, parts, resolution in cases:
        file = Path(run.FOLDER.name) / "parts.off"
        write(file, parts)
        m = measure_file(options, file, resolution)
        run.tell(name, m)
        table.add([name, f"{m['triangles']:,.0f}", f"{resolution:,}"], m)
        if name == "2 cubes":
            targets.add(f"{name}, CPU s", ".2f", m["cpu"], most=0.1)
        elif "icosahedra" in name:
            targets.add(f"{name}, ms a part", ".2f", m["each"], most=0.4)
        else:
            targets.add(f"{name}, s per 100k triangles", ".1f", m["rate"], most=10)
    Report(options.output).add(head("Many parts and handles", measure) +
                               "CPU seconds of whole runs of `flatten_mesh` on one thread, with reading and without writing.\n\n"
                               f"{table}{targets}")


if __name__ == "__main__":
    main()
