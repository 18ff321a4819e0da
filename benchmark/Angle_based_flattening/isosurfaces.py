# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Isosurfaces by marching tetrahedra, smooth or as noisy as those of generated and scanned models."""

import numpy as np

CUBE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]])
TETRAHEDRA = np.array([[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]])


def cut_tetrahedra(corners, values):
    """(m, 3, 2): the corners of triangles, each as the ends of the edge that it lies on, the negative one first"""
    is_inner = values[corners] < 0
    triangles = []
    for case in range(1, 15):
        chosen = corners[(is_inner == [bool(case >> k & 1) for k in range(4)]).all(axis=1)]
        inner = [k for k in range(4) if case >> k & 1]
        outer = [k for k in range(4) if not case >> k & 1]
        loop = [(i, o) for i in inner for o in (outer if i == inner[0] else outer[::-1])]
        triangles += [np.stack([chosen[:, loop[i]] for i in (0, k, k + 1)], axis=1) for k in range(1, len(loop) - 1)]
    return np.concatenate(triangles)


def isosurface(size, noise, seed=1):
    """Where a sum of waves and noise is zero on a grid of cubes, by marching tetrahedra. All parts are closed."""
    random = np.random.default_rng(seed)
    x = np.stack(np.meshgrid(*[np.linspace(-1, 1, size)] * 3, indexing="ij"), axis=-1)
    field = np.linalg.norm(x, axis=-1) - .6
    for k in random.uniform(-4, 4, (6, 3)):
        field += .08 * np.sin(x @ k + random.uniform(0, 6))
    field += noise * random.standard_normal(field.shape)
    for axis in range(3):
        np.moveaxis(field, axis, 0)[[0, -1]] = 1
    first = np.arange(size**3).reshape(field.shape)[:-1, :-1, :-1].reshape(-1, 1)
    corners, values, points = first + CUBE @ [size * size, size, 1], field.ravel(), x.reshape(-1, 3)
    ends = np.concatenate([cut_tetrahedra(corners[:, tetrahedron], values) for tetrahedron in TETRAHEDRA])
    edges, faces = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
    (a, b), faces = edges.T, faces.reshape(-1, 3)
    share = (values[a] / (values[a] - values[b]))[:, None]
    vertices = (1 - share) * points[a] + share * points[b]
    outwards = (points[ends[:, :, 1]] - points[ends[:, :, 0]]).sum(axis=1)
    p, q, r = (vertices[faces[:, k]] for k in range(3))
    is_turned = (np.cross(q - p, r - p) * outwards).sum(axis=1) < 0
    faces[is_turned] = faces[is_turned, ::-1]
    return vertices, faces
