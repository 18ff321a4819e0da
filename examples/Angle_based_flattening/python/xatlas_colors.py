# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives a mesh with normals and colours texture coordinates, and writes it: xatlas_colors.py [FILE [FILE.obj]]

It is written for the module xatlas, and runs with it if the import is `import xatlas`.
"""

import sys
from pathlib import Path

import angle_based_flattening.xatlas as xatlas
import numpy as np
from mesh_files import read

data = Path(__file__).resolve().parents[1] / "data"
file, output = (sys.argv[1:] + [data / "egg.off", "textured.obj"][len(sys.argv) - 1:])[:2]
vertices, faces = read(file)
corners = vertices[faces]
normals = np.zeros_like(vertices)
for corner in range(3):
    np.add.at(normals, faces[:, corner], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
normals /= np.linalg.norm(normals, axis=1, keepdims=True)
colors = (normals + 1) / 2

vmapping, indices, uvs = xatlas.parametrize(vertices, faces, normals)
xatlas.export(str(output), vertices[vmapping], indices, uvs, normals[vmapping])
np.savez(Path(output).with_suffix(".npz"), positions=vertices[vmapping], normals=normals[vmapping],
         colors=colors[vmapping], uvs=uvs, indices=indices)
print(f"{len(vertices)} vertices, and {len(vmapping)} with coordinates")
print("same faces:", np.array_equal(vmapping[indices], faces))
