# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads OFF and OBJ files of triangles, and writes OBJ files with texture coordinates."""

import os
from pathlib import Path

import numpy as np


def read(file):
    """The points and the triangles of a file."""
    lines = [line.split("#")[0].split() for line in Path(file).read_text().splitlines()]
    lines = [words for words in lines if words]
    if Path(file).suffix == ".off":
        count = int(lines[1][0])
        vertices, faces = lines[2:2 + count], [words[1:4] for words in lines[2 + count:]]
        first = 0
    elif Path(file).suffix == ".obj":
        vertices = [words[1:4] for words in lines if words[0] == "v"]
        faces = [[word.split("/")[0] for word in words[1:]] for words in lines if words[0] == "f"]
        first = 1
    else:
        raise ValueError(f"{file} is neither .off nor .obj")
    return np.array(vertices, float), np.array(faces, int) - first


def write_obj(file, vertices, faces, uv):
    """Writes a file with coordinates of each corner. It is never there in part."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    lines += [f"vt {u!r} {v!r}" for u, v in uv.tolist()]
    corners = np.arange(faces.size).reshape(faces.shape) + 1
    lines += ["f {}/{} {}/{} {}/{}".format(*words) for words in np.dstack([faces + 1, corners]).reshape(-1, 6).tolist()]
    unfinished = Path(f"{file}.{os.getpid()}.part")
    unfinished.write_text("\n".join(lines) + "\n")
    unfinished.replace(file)
