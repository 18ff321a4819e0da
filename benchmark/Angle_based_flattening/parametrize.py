#!/usr/bin/python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares parametrize() of the Python module with another library, on models and noisy isosurfaces: parametrize.py
--demo FOLDER, with the module in PYTHONPATH. The other library is Python's xatlas if it is there, or a program that is
called with an OBJ file to read and one to write. Both results are measured in the same way, from the triples."""

import argparse
import os
import tempfile
import time
from pathlib import Path

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import angle_based_flattening as abf  # noqa: E402
import numpy as np  # noqa: E402

import side_by_side  # noqa: E402
from evaluator import least_connected  # noqa: E402
from isosurfaces import isosurface  # noqa: E402
from side_by_side import row  # noqa: E402

MODELS = ("cow", "homer", "camel", "armadillo", "bunny00", "refined_elephant")


def measured(vertices, vmapping, indices, uvs):
    """Charts, seams and faults of a triple. Charts that are mirrored as a whole are turned first."""
    uvs, faces = uvs.astype(float), np.asarray(vmapping)[indices]
    chart = least_connected(len(uvs), indices)[indices[:, 0]]
    p, q, r = (uvs[indices[:, k]] for k in range(3))
    area = np.cross(q - p, r - p)
    mirrored = np.bincount(chart, area, len(uvs)) < 0
    corners = uvs[indices]
    corners[mirrored[chart], :, 0] *= -1
    certificate = abf.certify(vertices, faces, corners.reshape(-1, 2))
    ends, cut = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), indices[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    turned = ends[:, 0] > ends[:, 1]
    ends[turned], cut[turned] = ends[turned, ::-1], cut[turned, ::-1]
    sides = np.unique(np.column_stack([ends, cut]), axis=0)
    edges, count = np.unique(sides[:, :2], axis=0, return_counts=True)
    a, b = edges[count > 1].T
    p, q, r = (vertices[faces[:, k]] for k in range(3))
    surface = np.linalg.norm(np.cross(q - p, r - p), axis=1).sum() / 2
    seam = np.linalg.norm(vertices[a] - vertices[b], axis=1).sum() / surface**.5
    return len(np.unique(chart)), seam, len(certificate.flipped), len(certificate.overlapping)


def read_off(file):
    numbers = np.array(" ".join(line for line in file.read_text().splitlines()[1:] if not line.startswith("#")).split(),
                       float)
    n, m = int(numbers[0]), int(numbers[1])
    return numbers[3:3 + 3 * n].reshape(n, 3), numbers[3 + 3 * n:3 + 3 * n + 4 * m].reshape(m, 4)[:, 1:].astype(int)


def read_triple(file):
    """Of an OBJ file"""
    lines = [line.split() for line in file.read_text().splitlines()]
    uvs = np.array([line[1:3] for line in lines if line[:1] == ["vt"]], float)
    faces = [line[1:4] for line in lines if line[:1] == ["f"]]
    corners = np.array([[corner.split("/")[:2] for corner in face] for face in faces], int) - 1
    vmapping = np.zeros(len(uvs), int)
    vmapping[corners[..., 1]] = corners[..., 0]
    return vmapping, corners[..., 1], uvs


class Other:
    """Takes a mesh, and returns a triple and the processor time."""

    def __init__(self, path):
        self.path = path

    def __call__(self, vertices, faces):
        if self.path is None:
            import xatlas
            begin = time.process_time()
            triple = xatlas.parametrize(vertices, faces)
            return triple, time.process_time() - begin
        with tempfile.TemporaryDirectory() as folder:
            mesh, result = Path(folder) / "mesh.obj", Path(folder) / "atlas.obj"
            mesh.write_text("".join([*(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices.tolist()),
                                     *(f"f {a} {b} {c}\n" for a, b, c in (faces + 1).tolist())]))
            process, _, cpu = side_by_side.run(self.path, mesh, result)
            return (read_triple(result), cpu) if process.returncode == 0 else (None, None)


def ours(vertices, faces):
    begin = time.process_time()
    triple = abf.parametrize(vertices, faces)
    return triple, time.process_time() - begin


def meshes(options):
    for name in MODELS if options.demo else ():
        yield name, *read_off(options.demo / f"{name}.off")
    for size in options.sizes:
        for noise in (0, 1 / size):
            yield f"isosurface, {'noisy' if noise else 'smooth'}", *isosurface(size, noise)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, metavar="FOLDER", help="with the meshes of CGAL's demo")
    parser.add_argument("--other", type=Path, metavar="PROGRAM", help="of the other library: PROGRAM IN.obj OUT.obj")
    parser.add_argument("--sizes", type=lambda text: list(map(int, text.split(","))), default=[40],
                        help="of the grids of isosurfaces (%(default)s)")
    options = parser.parse_args()
    libraries = [("parametrize()", ours)]
    try:
        import xatlas  # noqa: F401
        libraries.append(("xatlas", Other(None)))
    except ImportError:
        if options.other:
            libraries.append((options.other.name, Other(options.other.resolve())))
        else:
            print("neither xatlas nor another program is there: only this library is measured")
    row("model", "triangles", "library", "CPU seconds", "charts", "seam", "flipped", "overlapping")
    row("---", "---:", "---", *["---:"] * 5)
    for name, vertices, faces in meshes(options):
        for library, run in libraries:
            triple, seconds = run(vertices, faces)
            if triple is None:
                row(name, f"{len(faces):,}", library, "failed", *[""] * 4)
                continue
            charts, seam, flipped, overlapping = measured(vertices, *triple)
            row(name, f"{len(faces):,}", library, f"{seconds:.2f}", f"{charts:,}", f"{seam:.1f}", f"{flipped:,}",
                f"{overlapping:,}")


if __name__ == "__main__":
    main()
