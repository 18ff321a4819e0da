# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Several meshes share an atlas, with as many texels for each unit of length: xatlas_meshes.py [FILE...]

It is written for the module xatlas, and runs with it if the import is `import xatlas`.
"""

import sys
from pathlib import Path

import angle_based_flattening.xatlas as xatlas
import numpy as np
from mesh_files import read

data = Path(__file__).resolve().parents[1] / "data"
meshes = [read(file) for file in sys.argv[1:] or [data / "egg.off", data / "mask.off"]]
atlas = xatlas.Atlas()
for vertices, faces in meshes:
    atlas.add_mesh(vertices, faces)
atlas.generate()


def texels_per_unit(vertices, faces, uvs):
    """The square root of the ratio of areas"""
    def area(points):
        a, b = points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]]
        return (np.linalg.norm(np.cross(a, b), axis=1) if points.shape[1] == 3 else
                np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])).sum()
    return np.sqrt(area(uvs * [atlas.width, atlas.height]) / area(vertices))


print(f"{len(atlas)} meshes, {atlas.chart_count} charts, {atlas.atlas_count} page")
for (vertices, faces), (vmapping, indices, uvs) in zip(meshes, atlas):
    ratio = texels_per_unit(vertices[vmapping], indices, uvs) / atlas.texels_per_unit
    print(f"{len(faces)} faces with coordinates from {uvs.min():.2f} to {uvs.max():.2f}, density {ratio:.2f}")
