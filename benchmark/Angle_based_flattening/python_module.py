#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what the Python module adds to the time of the program, and what two Python threads gain: python_module.py
--program FLATTEN_MESH, with the module in PYTHONPATH."""

import argparse
import json
import os
import statistics
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import angle_based_flattening as abf  # noqa: E402
import numpy as np  # noqa: E402

from side_by_side import head, row, run  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "test/python"), str(ROOT / "examples/Angle_based_flattening/python")]
import meshes  # noqa: E402
import program  # noqa: E402


def hill_of(triangles, seed=1):
    return meshes.hill(round((triangles / 2)**.5) + 1, seed)


def of_program(path, file):
    """The seconds of the program but for its start and for reading, and its processor time"""
    _, start, _ = run(path, "--version")
    process, seconds, cpu = run(path, file, "--quiet", "--threads", "1", "--json", "-")
    return seconds - start - json.loads(process.stdout)["seconds"]["read"], cpu


def of_module(vertices, faces):
    """The seconds of a call but for reading, all its seconds, and the processor time"""
    begin, cpu = time.perf_counter(), time.process_time()
    atlas = abf.atlas(vertices, faces, threads=1)
    seconds, cpu = time.perf_counter() - begin, time.process_time() - cpu
    return seconds - atlas.report["seconds"]["read"], seconds, cpu


def overhead(options):
    """Both in turn, so that other work disturbs them alike"""
    head("triangles", "program, ms", "module, ms", "difference, ms", "module / program",
         "processor time, module / program", "a whole call, ms")
    for size in options.sizes:
        mesh = hill_of(size)
        of_module(*mesh)  # what is loaded and allocated once
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "hill.obj"
            program.write_obj(file, *mesh)
            runs = [(*of_program(options.program, file), *of_module(*mesh)) for _ in range(options.repeat)]
        theirs, their_cpu, ours, call, cpu = map(np.array, zip(*runs))
        row(f"{len(mesh[1]):,}", *(f"{1e3 * np.median(s):.1f}" for s in (theirs, ours, ours - theirs)),
            f"{np.median(ours / theirs):.2f}", f"{np.median(cpu / their_cpu):.2f}", f"{1e3 * np.median(call):.1f}")


def threads(options):
    """Two meshes one after the other, and in two threads"""
    head("triangles of each mesh", "one thread, s", "two threads, s", "two / one")
    for size in options.sizes:
        pair = [hill_of(size, 1), hill_of(size, 2)]

        def one(mesh):
            return abf.atlas(*mesh, threads=1)

        def seconds(f):
            begin = time.perf_counter()
            f()
            return time.perf_counter() - begin

        with ThreadPoolExecutor(2) as pool:
            runs = [(seconds(lambda: list(map(one, pair))), seconds(lambda: list(pool.map(one, pair))))
                    for _ in range(options.repeat)]
        row(f"{len(pair[0][1]):,}", *(f"{statistics.median(times):.3f}" for times in zip(*runs)),
            f"{statistics.median(b / a for a, b in runs):.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True, help="flatten_mesh")
    parser.add_argument("--sizes", type=lambda text: list(map(int, text.split(","))), default=[1000, 10000, 100000])
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    for part in (overhead, threads):
        part(options)


if __name__ == "__main__":
    main()
