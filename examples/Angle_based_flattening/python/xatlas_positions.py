# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bakes the position of each texel, where a generator evaluates colours: xatlas_positions.py [FILE [FILE.npy]]

It is written for the module xatlas, and runs with it if the import is `import xatlas`.
"""

import sys
from pathlib import Path

import angle_based_flattening.xatlas as xatlas
import numpy as np
from mesh_files import read


def rasterized(uvs, indices, values, width, height):
    """(height, width, 3), the values of vertices between them; NaN in texels without a triangle"""
    page = np.full((height, width, 3), np.nan)
    for face in indices:
        a, b, c = uvs[face] * [width, height] - .5  # centres of texels have whole numbers
        low = np.ceil(np.minimum(np.minimum(a, b), c)).astype(int)
        high = np.floor(np.maximum(np.maximum(a, b), c)).astype(int)
        x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if area == 0:
            continue
        of_b = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
        of_c = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
        weights = np.stack([1 - of_b - of_c, of_b, of_c], axis=-1)
        inside = (weights >= 0).all(axis=-1)
        page[y[inside], x[inside]] = weights[inside] @ values[face]
    return page


data = Path(__file__).resolve().parents[1] / "data"
file, output = (sys.argv[1:] + [data / "egg.off", "positions.npy"][len(sys.argv) - 1:])[:2]
vertices, faces = read(file)
atlas = xatlas.Atlas()
atlas.add_mesh(vertices, faces)
options = xatlas.PackOptions()
options.resolution = 256
options.padding = 2
atlas.generate(pack_options=options)
vmapping, indices, uvs = atlas[0]
page = rasterized(uvs, indices, vertices[vmapping], atlas.width, atlas.height)
np.save(output, page)
is_covered = np.isfinite(page[..., 0])
print(f"{is_covered.mean():.0%} of the page have positions; the utilization is {atlas.utilization:.0%}")
found = page[is_covered]
print("within the box of the mesh:", bool((found >= vertices.min(0) - 1e-6).all() and
                                          (found <= vertices.max(0) + 1e-6).all()))
