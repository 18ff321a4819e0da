# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program `flatten_mesh`, with which the module is compared. Its OBJ files have all digits of numbers."""

import json
import os
import re
import subprocess

import numpy as np


def polygons(faces):
    """Lists of vertices."""
    if isinstance(faces, tuple):
        offsets, indices = faces
        return [indices[a:b].tolist() for a, b in zip(offsets, offsets[1:])]
    return faces.tolist()


def write_obj(file, vertices, faces, uv=None):
    lines = ["v " + " ".join(map(repr, p)) for p in vertices.tolist()]
    if uv is not None:
        lines += ["vt " + " ".join(map(repr, p)) for p in uv.tolist()]
    corner = 0
    for polygon in polygons(faces):
        words = []
        for v in polygon:
            corner += 1
            words.append(f"{v + 1}/{corner}" if uv is not None else f"{v + 1}")
        lines.append("f " + " ".join(words))
    file.write_text("\n".join(lines) + "\n")


def read_corners(file, faces):
    """The coordinates of each corner of faces, which the program may have turned; NaN where there are none."""
    lines = [line.split() for line in file.read_text().splitlines()]
    coordinates = [tuple(map(float, line[1:3])) for line in lines if line[:1] == ["vt"]]
    written = [[word.split("/") for word in line[1:]] for line in lines if line[:1] == ["f"]]
    corners = []
    for polygon, words in zip(polygons(faces), written, strict=True):
        found = {int(w[0]) - 1: coordinates[int(w[1]) - 1] for w in words if len(w) > 1 and w[1]}
        if len({w[1] for w in words if len(w) > 1}) == 1:  # stands for none
            found = {}
        assert set(polygon) == {int(w[0]) - 1 for w in words}
        corners += [found.get(v, (np.nan, np.nan)) for v in polygon]
    return np.array(corners)


def run(folder, vertices, faces, *options, uv=None, output=True):
    """The coordinates of each corner, if they are wanted, and the report of flatten_mesh."""
    program = os.environ.get("ABF_FLATTEN_MESH")
    if not program:
        import pytest  # which the benchmark does without
        pytest.skip("ABF_FLATTEN_MESH, the path of the program, is not set")
    write_obj(folder / "in.obj", vertices, faces, uv)
    words = [program, folder / "in.obj", "--json", folder / "out.json", "--quiet", *map(str, options)]
    words += ["--output", folder / "out.obj"] if output else []
    done = subprocess.run(words, capture_output=True, text=True)
    report = json.loads((folder / "out.json").read_text())
    assert "atlas" in report or report["status"] == "OK", done.stderr
    return (read_corners(folder / "out.obj", faces) if output else None), report


def read_seams(file):
    """The edges in a selection file, sorted."""
    edges = np.array(file.read_text().splitlines()[2].split(), int).reshape(-1, 2)
    edges.sort(axis=1)
    return edges[np.lexsort(edges.T[::-1])]


def same_bits(a, b):
    return a.shape == b.shape and np.array_equal(a, b, equal_nan=True)


# What differs: times, and what concerns files and runs
VOLATILE = {"seconds", "peak_memory_mb", "input", "options", "exit_status", "version", "baking", "models"}


def comparable(report):
    """What two runs have to agree on."""
    if isinstance(report, dict):
        return {name: comparable(value) for name, value in report.items() if name not in VOLATILE}
    if isinstance(report, list):  # the module writes no files, and has no notes on what others read of them
        return [comparable(value) for value in report if not (isinstance(value, str) and "other programs" in value)]
    return re.sub(r"^'[^']*': ", "", report) if isinstance(report, str) else report
