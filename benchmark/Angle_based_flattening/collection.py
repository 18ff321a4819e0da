#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes atlases of a collection of models, clean and broken ones: collection.py --program FLATTEN_MESH FOLDER, with the
Python module in PYTHONPATH. Models are generated surfaces and those of CGAL's demo, and what is made of them by random
cuts, unions and damage. Each written atlas is read again and checked by exact predicates."""

import argparse
import collections
import json
import os
import resource
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import angle_based_flattening as abf  # noqa: E402
import numpy as np  # noqa: E402

import isosurfaces  # noqa: E402
from evaluator import least_connected  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "test/python"), str(ROOT / "examples/Angle_based_flattening/python")]
import mesh_files  # noqa: E402
import meshes  # noqa: E402
import program  # noqa: E402

MOST_TRIANGLES = 4000  # of a model of the demo
PURPOSES = ("texture", "few-charts", "conformal")


def generated(random, seed):
    size = random.uniform(.3, 1.2)
    return [lambda: meshes.hill(int(24 * size) + 2, seed),
            lambda: meshes.torus(int(30 * size) + 3, int(14 * size) + 3, seed),
            lambda: meshes.sphere(int(random.integers(0, 4)), seed),
            lambda: isosurfaces.isosurface(int(10 * size) + 4, random.choice([0, .02, .1]), seed)][random.integers(4)]()


def turned(vertices, random):
    """By a random rotation, which may be a reflection, scaled and moved"""
    rotation, _ = np.linalg.qr(random.standard_normal((3, 3)))
    return vertices @ rotation * random.uniform(.5, 2) + random.standard_normal(3)


def cut(vertices, faces, random):
    """What is on one side of a plane, or all but some faces"""
    if random.random() < .5:
        heights = vertices @ random.standard_normal(3)
        kept = heights[faces].max(axis=1) < np.quantile(heights, random.uniform(.4, .95))
    else:
        kept = random.random(len(faces)) > random.choice([.002, .02, .2])
    return vertices, faces[kept] if kept.any() else faces


def united(vertices, faces, random, other):
    """Both surfaces in one file, which may meet in vertices"""
    points, others = other
    points = turned(points, random)
    if random.random() < .3:
        points[0] = vertices[0]
    return np.concatenate([vertices, points]), np.concatenate([faces, others + len(vertices)])


def damaged(vertices, faces, random):
    """With faces that are turned round, doubled, degenerate or joined to any vertex, and points that coincide"""
    vertices, faces, some = vertices.copy(), faces.copy(), random.choice([.002, .02, .2])
    chosen = random.random(len(faces)) < some
    kind = random.integers(5)
    if kind == 0:
        faces[chosen] = faces[chosen, ::-1]
    elif kind == 1:
        faces = np.concatenate([faces, faces[chosen]])
    elif kind == 2:
        faces[chosen, 1] = faces[chosen, 0]
    elif kind == 3:
        faces[chosen, 2] = random.integers(len(vertices), size=chosen.sum())
    else:
        moved = random.random(len(vertices)) < some
        vertices[moved] = vertices[random.integers(len(vertices), size=moved.sum())]
    return vertices, faces


def stretched(vertices, random):
    """Along the axes, and to another unit"""
    return vertices * 10**random.uniform(-1, 1, 3) * 10**random.uniform(-6, 6)


def model(seed, demo):
    """The model of a seed, and what was done to it"""
    random = np.random.default_rng(seed)
    if demo and random.random() < .3:
        vertices, faces = mesh_files.read(demo[random.integers(len(demo))])
    else:
        vertices, faces = generated(random, seed)
    done = []
    if random.random() < .4:
        done.append("cut")
        vertices, faces = cut(vertices, faces, random)
    if random.random() < .3:
        done.append("united")
        vertices, faces = united(vertices, faces, random, generated(random, seed + 1))
    if random.random() < .3:
        done.append("damaged")
        vertices, faces = damaged(vertices, faces, random)
    if random.random() < .2:
        done.append("stretched")
        vertices = stretched(vertices, random)
    return vertices, faces, "-".join(done) or "whole"


def write(folder, demo, seed):
    vertices, faces, done = model(seed, demo)
    program.write_obj(folder / f"{seed:05d}-{done}.obj", vertices, faces)


def small_models(folder):
    """Those of triangles only"""
    def is_small(file):
        lines = [line for line in file.read_text(errors="replace").splitlines()[1:] if line[:1] != "#"]
        try:
            numbers = np.array(" ".join(lines).split(), float)
            n, m = int(numbers[0]), int(numbers[1])
        except (IndexError, ValueError):
            return False
        rows = numbers[3 + 3 * n:]
        return m <= MOST_TRIANGLES and len(rows) == 4 * m > 0 and (rows[::4] == 3).all()

    return [file for file in sorted(folder.rglob("*.off")) if is_small(file)] if folder else []


def fans_of(faces):
    """The corners of faces, as the fans of faces around a vertex that edges join. So charts that touch in a vertex are
    apart."""
    sides = [faces[:, [k, (k + 1) % 3]] for k in range(3)]
    corners = np.arange(faces.size).reshape(-1, 3)
    ends = np.concatenate([np.column_stack([side, corners[:, [k, (k + 1) % 3]]]) for k, side in enumerate(sides)])
    turned = ends[:, 0] > ends[:, 1]
    ends[turned] = ends[turned][:, [1, 0, 3, 2]]
    ends = ends[np.lexsort((ends[:, 1], ends[:, 0]))]
    joined = np.flatnonzero((ends[1:, :2] == ends[:-1, :2]).all(axis=1))
    pairs = np.concatenate([np.column_stack([ends[joined, k], ends[joined + 1, k]]) for k in (2, 3)])
    return least_connected(faces.size, pairs).reshape(-1, 3)


def has_wrong_map(file):
    """Whether a chart of a written atlas has a triangle that is flipped or overlaps another, by exact predicates"""
    lines = [line.split() for line in file.read_text().splitlines()]
    uvs = np.array([line[1:3] for line in lines if line[:1] == ["vt"]], float)
    corners = [[corner.split("/") for corner in line[1:]] for line in lines if line[:1] == ["f"]]
    faces = [[c[1] for c in face if len(c) > 1] for face in corners]
    faces = np.array([face for face in faces if len(set(face)) > 1], int) - 1  # the same at all corners stand for none
    if not len(faces):
        return False
    uvs, place = np.unique(uvs, axis=0, return_inverse=True)  # the program joins vertices, and files keep them apart
    faces = place.reshape(-1)[faces]
    vertices, fans = np.unique(fans_of(faces), return_inverse=True)
    uvs = uvs[faces.reshape(-1)[vertices]]
    return not abf.certify(np.pad(uvs, ((0, 0), (0, 1))), fans.reshape(-1, 3), uvs)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="for models and results; models that are there are taken")
    parser.add_argument("--program", type=Path, required=True, help="flatten_mesh")
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--models", type=int, default=10000)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    models, results, demo = options.folder / "models", options.folder / "results", small_models(options.demo)
    models.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(options.jobs) as pool:
        present = {int(file.name[:5]) for file in models.iterdir()}
        list(pool.map(partial(write, models, demo), sorted(set(range(options.models)) - present), chunksize=20))
        begin = time.perf_counter()
        files = sorted(models.iterdir())
        for i, purpose in enumerate(PURPOSES):
            names = options.folder / f"{purpose}.txt"
            names.write_text("".join(f"{file}\n" for file in files[i::len(PURPOSES)]))
            subprocess.run([options.program, "--list", names, "--for", purpose, "--quiet", "--jobs", str(options.jobs),
                            "--threads", "1", "--timeout", "120", "--memory", "2G", "--resume", "--output-folder",
                            results, "--output", "%.obj", "--json", "%.json"], stderr=subprocess.DEVNULL)
        seconds, used = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
        atlases = sorted(results.rglob("*.obj"))
        are_wrong = pool.map(has_wrong_map, atlases, chunksize=20)
        wrong = [file.name for file, is_wrong in zip(atlases, are_wrong) if is_wrong]
    reports = [json.loads(file.read_text()) for file in results.rglob("*.json")]
    print(f"{len(files):,} models, {sum(report.get('triangles', 0) for report in reports):,} triangles, "
          f"{seconds:.0f} s, processor time {used.ru_utime + used.ru_stime:.0f} s with the making of models\n")
    print("| status | models |\n| --- | ---: |")
    for status, number in collections.Counter(report["status"] for report in reports).most_common():
        print(f"| {status} | {number:,} |")
    print(f"\nNo report: {len(files) - len(reports)}. Atlases: {len(atlases):,}; with a flipped or overlapping "
          f"triangle: {len(wrong)}{' (' + ', '.join(wrong) + ')' if wrong else ''}.")


if __name__ == "__main__":
    main()
