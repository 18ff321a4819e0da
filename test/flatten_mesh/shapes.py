# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for tests: points, and faces as numbers of points from 0"""

import math


def sphere(n, m):
    """Of radius 1, with two poles"""
    points = [(0, 0, 1), (0, 0, -1)]
    points += [(math.sin(math.pi * i / n) * math.cos(2 * math.pi * j / m),
                math.sin(math.pi * i / n) * math.sin(2 * math.pi * j / m), math.cos(math.pi * i / n))
               for i in range(1, n) for j in range(m)]
    faces = []
    for j in range(m):
        k = (j + 1) % m
        faces += [(0, 2 + j, 2 + k), (1, 2 + (n - 2) * m + k, 2 + (n - 2) * m + j)]
        for i in range(n - 2):
            a, b = 2 + i * m, 2 + (i + 1) * m
            faces += [(a + j, b + j, b + k), (a + j, b + k, a + k)]
    return points, faces


def torus(n, m):
    """A tube of radius 1 along a circle of radius 3"""
    points = [((3 + math.cos(v)) * math.cos(u), (3 + math.cos(v)) * math.sin(u), math.sin(v))
              for u in (2 * math.pi * i / n for i in range(n)) for v in (2 * math.pi * j / m for j in range(m))]
    return points, [face for i in range(n) for j in range(m) for a, b, k in [(i * m, (i + 1) % n * m, (j + 1) % m)]
                    for face in ((a + j, b + j, b + k), (a + j, b + k, a + k))]


def terrain(n, height):
    """Over a grid of squares; `height(i, j)` is called once for each point."""
    points = [(i, j, height(i, j)) for i in range(n) for j in range(n)]
    return points, [face for i in range(n - 1) for j in range(n - 1) for a in [n * i + j]
                    for face in ((a, a + n, a + n + 1), (a, a + n + 1, a + 1))]


def strip(half_twists, n, m, is_in_hole=lambda i, j: False):
    """A closed strip of n times m quads: Moebius' for one half twist"""
    points = []
    for i in range(n):
        u = 2 * math.pi * i / n
        for j in range(m + 1):
            s, turn = 0.6 * (j / m - 0.5), half_twists * u / 2
            r = 1 + s * math.cos(turn)
            points.append((r * math.cos(u), r * math.sin(u), s * math.sin(turn)))

    def number(i, j):
        return i * (m + 1) + j if i < n else m - j if half_twists % 2 else j

    faces = []
    for i in range(n):
        for j in range(m):
            a, b, c, d = number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j)
            faces += [] if is_in_hole(i, j) else [(a, b, c), (a, c, d)]
    return points, faces
