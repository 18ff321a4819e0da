#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows how close `flatten_mesh --plain --method auto` comes to the direct method on large terrains, and what it takes:
hills of several heights, with normal noise of up to two edge lengths, on squares whose diagonals are parallel or
random."""

import argparse
import json
import math
import random
import subprocess
import tempfile
from itertools import product
from pathlib import Path

import run
from report import Report, Table, Targets

COLUMNS = [("RMS angle change, direct", "direct", ".3f"), ("auto", "auto", ".3f"),
           ("energy, auto / direct", "energy", ".3f"), ("time, auto / direct", "time", ".2f")]


def write_terrain(file: Path, squares: int, height: float, noise: float, regular: bool) -> None:
    """Waves of random lengths on the unit square, and normal noise in units of the edges"""
    chance = random.Random(1)
    waves = [(chance.uniform(1, 6), chance.uniform(1, 6), chance.uniform(0, 7), chance.uniform(0, 7))
             for _ in range(12)]

    def z(x: float, y: float) -> float:
        hills = sum(math.sin(math.tau * a * x + c) * math.sin(math.tau * b * y + d) / (a + b) for a, b, c, d in waves)
        return height * hills + chance.gauss(0, noise) / squares

    grid = [i / squares for i in range(squares + 1)]
    row = squares + 1
    corners = (j * row + i for j in range(squares) for i in range(squares))
    with file.open("w", encoding="ascii") as out:
        out.write(f"OFF\n{row * row} {2 * squares * squares} 0\n")
        out.writelines(f"{x!r} {y!r} {z(x, y)!r}\n" for y in grid for x in grid)
        for a in corners:
            b, c, d = a + 1, a + row + 1, a + row
            if not regular and chance.random() < 0.5:
                a, b, c, d = b, c, d, a
            out.write(f"3 {a} {b} {c}\n3 {a} {c} {d}\n")


def flatten(program: Path, mesh: Path, method: str) -> dict:
    done = subprocess.run([program, mesh, "--plain", "--method", method, "--json", "-"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, check=False)
    return json.loads(done.stdout)


def compare(program: Path, mesh: Path, repeat: int) -> run.Measurement:
    runs = [[flatten(program, mesh, method) for method in ("direct", "auto")] for _ in range(repeat)]
    for direct, auto in runs:
        if not direct["status"] == auto["status"] == "OK":
            return run.Measurement(failure=f"{direct['message']} {auto['message']}")
    direct, auto = runs[0]
    return run.Measurement(
        direct=math.degrees(direct["rms_angle_change"]), auto=math.degrees(auto["rms_angle_change"]),
        energy=auto["energy"] / direct["energy"], method=auto["method"],
        time=sorted(a["seconds"]["parameterize"] / d["seconds"]["parameterize"] for d, a in runs)[repeat // 2])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--squares", type=int, default=320, metavar="N",
                        help="along each side; twice the square is the number of triangles (%(default)s)")
    parser.add_argument("--heights", type=run.numbers, default="0,0.1,0.3", metavar="X,X,...",
                        help="of the hills (%(default)s)")
    parser.add_argument("--noises", type=run.numbers, default="0,0.1,0.3,1,1.5,2", metavar="X,X,...",
                        help="lengths of an edge (%(default)s)")
    parser.add_argument("--repeat", type=int, default=3, metavar="N", help="of which times are medians (%(default)s)")
    parser.add_argument("--program", type=Path, metavar="PROGRAM", help="what flattens (%(default)s)",
                        default=run.ROOT / "build/apps/flatten_mesh/flatten_mesh")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE.md", help="write the report there as well")
    options = parser.parse_args()

    table, targets, ratios = Table(["diagonals", "height", "noise"], COLUMNS, 3), Targets(), []
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "terrain.off"
        for diagonals, height, noise in product(["parallel", "random"], options.heights, options.noises):
            if height == noise == 0:
                continue
            write_terrain(mesh, options.squares, height, noise, diagonals == "parallel")
            m = compare(options.program, mesh, options.repeat)
            run.tell(f"{diagonals} diagonals, height {height}, noise {noise}", m, "time")
            table.add([diagonals, height, noise], m)
            ratios.append(m["energy"])
    targets.add("largest ratio of energies", ".3f", math.nan if any(map(math.isnan, ratios)) else max(ratios), most=1.2)
    Report(options.output).add(f"# Terrains\n\nThe method `auto` of `flatten_mesh` beside the direct method, on "
                               f"terrains of {2 * options.squares ** 2:,} triangles. Angles change by degrees; "
                               f"both energies are on the same target angles.\n\n{table}{targets}")


if __name__ == "__main__":
    main()
