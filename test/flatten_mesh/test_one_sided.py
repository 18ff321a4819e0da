# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""One-sided surfaces are cut along few edges, and two-sided ones are not cut, whatever the orientation of their faces.
Usage: test_one_sided.py FLATTEN_MESH"""

import math
import random
import re
import sys
import unittest

from program_case import Program_case
from shapes import strip


def klein_bottle(n, m):
    """A figure of eight that turns over once around"""
    points = []
    for i in range(n):
        u = 2 * math.pi * i / n
        for j in range(m):
            v = 2 * math.pi * j / m
            x, z = math.sin(v), math.sin(2 * v)
            r = 2.5 + math.cos(u / 2) * x - math.sin(u / 2) * z
            points.append((r * math.cos(u), r * math.sin(u), math.sin(u / 2) * x + math.cos(u / 2) * z))

    def number(i, j):
        return i * m + j % m if i < n else -j % m

    faces = []
    for i in range(n):
        for j in range(m):
            a, b, c, d = number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j)
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def shuffled(surface, seed):
    """The same with faces in any order and orientation"""
    generator = random.Random(seed)
    faces = [face if generator.random() < 0.5 else face[::-1] for face in surface[1]]
    generator.shuffle(faces)
    return surface[0], faces


class One_sided(Program_case):
    """Atlases of surfaces that no orientation of their faces fits"""

    def flatten(self, surface, options=()):
        """The number of edges that are cut to orient the surface, what is said, the report of the atlas, and the
        coordinates of the corners of each face"""
        run, report, output = self.run_program(self.write(*surface), options)
        self.assertEqual(run.returncode, 0, run.stderr)
        cut = re.search("one-sided, like a Moebius strip: it is cut along ([0-9]+) edge", run.stderr)
        atlas = report["atlas"]
        self.assertTrue(atlas["injective"])
        return int(cut[1]) if cut else 0, run.stderr, atlas, self.uvs(output)

    def test_a_strip_is_cut_across_once(self):
        for half_twists, n, m in [(1, 12, 1), (1, 60, 4), (1, 100, 8), (3, 40, 1), (3, 60, 4), (5, 60, 1), (5, 90, 4)]:
            for surface in [strip(half_twists, n, m), shuffled(strip(half_twists, n, m), n)]:
                with self.subTest(half_twists=half_twists, n=n, m=m):
                    edges, text, atlas, _ = self.flatten(surface, ["--for", "few-charts"])
                    self.assertEqual(edges, m)
                    self.assertNotIn("separated", text)
                    self.assertEqual(len(atlas["charts"]), 1)

    def test_a_strip_with_a_hole_is_cut_beside_it(self):
        surface = strip(1, 80, 8, lambda i, j: i // 10 == 3 and 2 <= j < 6)
        edges, _, atlas, _ = self.flatten(shuffled(surface, 1), ["--for", "few-charts"])
        self.assertEqual(edges, 4)
        self.assertEqual(len(atlas["charts"]), 1)

    def test_a_closed_surface_is_cut_along_one_loop(self):
        for seed in range(3):
            edges, _, atlas, _ = self.flatten(shuffled(klein_bottle(30, 20), seed), ["--for", "few-charts"])
            self.assertEqual(edges, 20)
            self.assertLessEqual(len(atlas["charts"]), 3)

    def test_two_sided_surfaces_are_not_cut(self):
        """Beside a Moebius strip or not, with faces that are oriented alike or not"""
        surface = strip(2, 40, 3)
        edges, text, expected, charts = self.flatten(surface)
        self.assertEqual((edges, text), (0, ""))
        edges, text, atlas, _ = self.flatten(shuffled(surface, 5))
        self.assertEqual(edges, 0)
        self.assertAlmostEqual(atlas["seams"]["length"], expected["seams"]["length"], delta=1e-12)
        self.assertNotIn("separated", text)
        points, faces = shuffled(strip(1, 60, 4), 6)
        both = surface[0] + [(x + 3, y, z) for x, y, z in points], surface[1] + [
            tuple(v + len(surface[0]) for v in face) for face in faces]
        edges, _, atlas, found = self.flatten(both, ["--component", "1"])
        self.assertEqual(edges, 4)
        self.assertEqual(found[:len(charts)], charts)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
