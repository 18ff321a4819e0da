#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what the program costs for many small models: its start, the processor time of 1,000 models, what a second
process at once gains, and how exactly bounds are kept: many_models.py --program FLATTEN_MESH."""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import isosurfaces
import side_by_side
from side_by_side import head, row

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "test/python"))
import meshes  # noqa: E402
import program  # noqa: E402

WAYS = (("--plain",), ("--for", "few-charts"), ("--for", "texture"))


def model(seed):
    """Of about 1,264 triangles: a disk, a torus or a closed isosurface"""
    return [lambda: meshes.hill(26, seed), lambda: meshes.torus(32, 20, seed),
            lambda: isosurfaces.isosurface(12, 0, seed)][seed % 3]()


def run_program(options, *arguments):
    """The status, seconds and processor time of a call with one thread"""
    process, seconds, cpu = side_by_side.run(options.program, *arguments, "--threads", "1")
    return process.returncode, seconds, cpu


def peak_megabytes(*command):
    """The largest resident memory of a process and those that it starts"""
    watch = "import resource, subprocess, sys; null = subprocess.DEVNULL; " \
            "subprocess.run(sys.argv[1:], stdout=null, stderr=null); " \
            "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
    return int(subprocess.run([sys.executable, "-c", watch, *map(str, command)], check=True,
                              stdout=subprocess.PIPE).stdout) / 1024


def start(options):
    head("start", "ms", "processor time, ms", "MB")
    runs = [run_program(options, "--version") for _ in range(20)]
    row("--version", *(f"{1e3 * np.median([each[i] for each in runs]):.0f}" for i in (1, 2)),
        f"{peak_megabytes(options.program, '--version'):.1f}")


def collection(options, folder):
    triangles = []
    for seed in range(options.models):
        vertices, faces = model(seed)
        triangles.append(len(faces))
        program.write_obj(folder / f"{seed:04d}.obj", vertices, faces)
    names = folder / "models.txt"
    names.write_text("".join(f"{file}\n" for file in sorted(folder.glob("*.obj"))))
    print(f"\n{options.models} models, median of {np.median(triangles):,.0f} triangles")
    head("way", "processor time, one at once, s", "seconds, one at once", "seconds, two at once", "one / two")
    for way in WAYS:
        results = [run_program(options, "--list", names, *way, "--quiet", "--jobs", str(jobs), "--output-folder",
                       folder / f"results{jobs}", "--output", "%.obj", "--json", "%.json") for jobs in (1, 2)]
        (_, one, cpu), (_, two, _) = results
        row(" ".join(way), f"{cpu:.1f}", f"{one:.1f}", f"{two:.1f}", f"{one / two:.2f}")


def bounds(options, folder):
    """Bounds, and what was taken. Those of memory are shares of what the run takes without them."""
    file = folder / "hill.obj"
    program.write_obj(file, *meshes.hill(options.side, 1))
    head("bound", "status", "seconds")
    for seconds in (.2, .5, 1):
        status, taken, _ = run_program(options, file, "--quiet", "--timeout", str(seconds))
        row(f"{seconds} s", str(status), f"{taken:.2f}")
    head("bound", "status", "MB")
    free = peak_megabytes(options.program, file, "--quiet", "--threads", "1", "--memory", "100G")
    for share in (.5, .8, .95, 1.05):
        bound = round(share * free)
        arguments = (file, "--quiet", "--memory", f"{bound}M")
        status, _, _ = run_program(options, *arguments)
        row(f"{bound} MB", str(status), f"{peak_megabytes(options.program, *arguments, '--threads', '1'):.0f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True, help="flatten_mesh")
    parser.add_argument("--models", type=int, default=1000)
    parser.add_argument("--side", type=int, default=500, help="vertices along the sides of a large model (%(default)s)")
    options = parser.parse_args()
    options.program = options.program.resolve()
    print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    start(options)
    for part in (collection, bounds):
        with tempfile.TemporaryDirectory() as folder:
            part(options, Path(folder))


if __name__ == "__main__":
    main()
