# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that are generated from a seed."""

import numpy as np


def grid(columns, rows):
    """The triangles of a grid of quadrangles, whose vertices are numbered by rows."""
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).reshape(-1, 1)
    return np.concatenate([corner + [0, 1, columns + 1], corner + [0, columns + 1, columns]], axis=1).reshape(-1, 3)


def hill(n=12, seed=0, height=.3):
    """A disk of 2 (n - 1)^2 triangles."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))
    a, b = random.uniform(2, 6, 2)
    z = height * np.sin(a * x) * np.cos(b * y)
    vertices = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    return vertices + random.uniform(-.1, .1, vertices.shape) / n, grid(n, n)


def torus(n=16, m=10, seed=0):
    """A closed surface of 2 n m triangles, with a handle."""
    random = np.random.default_rng(seed)
    i, j = np.meshgrid(np.arange(n), np.arange(m))
    u, v = 2 * np.pi * i.ravel() / n, 2 * np.pi * j.ravel() / m
    vertices = np.column_stack([(2 + np.cos(v)) * np.cos(u), (2 + np.cos(v)) * np.sin(u), np.sin(v)])
    vertices += random.uniform(-.05, .05, vertices.shape)

    def at(di, dj):
        return ((j.ravel() + dj) % m) * n + (i.ravel() + di) % n

    faces = np.concatenate([np.column_stack([at(0, 0), at(1, 0), at(1, 1)]),
                            np.column_stack([at(0, 0), at(1, 1), at(0, 1)])])
    return vertices, faces


def sphere(levels=2, seed=0):
    """A bumpy sphere of 8 4^levels triangles."""
    random = np.random.default_rng(seed)
    vertices = [np.array(p, float) for p in ((1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1))]
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    for _ in range(levels):
        middles, finer = {}, []

        def middle(a, b):
            if (key := (min(a, b), max(a, b))) not in middles:
                middles[key] = len(vertices)
                p = vertices[a] + vertices[b]
                vertices.append(p / np.linalg.norm(p))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    vertices = np.array(vertices)
    return vertices * (1 + .1 * random.uniform(-1, 1, (len(vertices), 1))), np.array(faces)


def box():
    """A box of six quadrangles, as offsets and indices."""
    vertices = np.array([(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, (np.arange(0, 25, 4), np.array(quads).reshape(-1))


def soup(seed=0):
    """Two hills that share an edge with a third sheet, a sheet that is turned round, and an invalid face."""
    vertices, faces = hill(8, seed)
    n = len(vertices)
    turned = faces[:, ::-1] + n
    fin = [[0, 1, 2 * n]]
    invalid = [[5, 5, 6]]
    points = np.concatenate([vertices, vertices + [2, 0, 0], [[.1, 0, 1]]])
    return points, np.concatenate([faces, turned, fin, invalid])


def write_off(file, vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0", *(" ".join(map(repr, p)) for p in vertices.tolist())]
    file.write_text("\n".join(lines + ["3 " + " ".join(map(str, f)) for f in faces.tolist()]) + "\n")


ALL = {"hill": hill, "torus": torus, "sphere": sphere, "box": box, "soup": soup}
