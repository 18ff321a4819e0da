# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of triangles that are thinner than target angles may be are as isometric as others, if they can be unfolded.
Usage: test_needles.py FLATTEN_MESH"""

import math
import sys
import unittest

from program_case import Program_case

RATIOS = [1e-3, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10]  # of height and length


def strip(ratio, triangles, fold):
    """Needles side by side, each turned by an angle `fold` about the edge to the one before"""
    points, turn, y, z = [(0., 0., 0.), (1., 0., 0.)], 0., 0., 0.
    for i in range(triangles):
        y, z = y + ratio * math.cos(turn), z + ratio * math.sin(turn)
        points.append((0.2 + 0.5 * (i % 2), y, z))
        turn += fold
    return points, [(i, i + 1, i + 2) if i % 2 == 0 else (i + 1, i, i + 2) for i in range(triangles)]


def polygon(ratio, corners):
    """A thin polygon, as a fan around one of its corners"""
    points = [(0., 0., 0.)] + [(1 - t * t, ratio * (t + 0.1), 0.) for t in (i / corners for i in range(corners + 1))]
    return points, [(0, i, i + 1) for i in range(1, corners + 1)]


def wheel(ratio, spokes):
    """A flat fan around its middle, with a needle beside each other triangle"""
    angles = [a for i in range(spokes) for a in (2 * math.pi * i / spokes, 2 * math.pi * i / spokes + ratio)]
    points = [(0., 0., 0.)] + [(math.cos(a), math.sin(a), 0.) for a in angles]
    return points, [(0, i + 1, (i + 1) % len(angles) + 1) for i in range(len(angles))]


class Needles(Program_case):
    """Maps of them"""

    def stretch(self, surface, options):
        """L2 and L-infinity stretch"""
        run, content, _ = self.run_program(self.write(*surface), options)
        self.assertEqual((run.returncode, content["status"]), (0, "OK"), run.stderr)
        measures = content if "--plain" in options else content["atlas"]
        return measures["l2_stretch"], measures["linf_stretch"]

    def check(self, surface, ratio):
        for options in [], ["--for", "few-charts"], ["--plain"]:
            with self.subTest(ratio=ratio, options=options):
                l2, largest = self.stretch(surface, options)
                self.assertAlmostEqual(l2, 1, delta=1e-6)
                self.assertAlmostEqual(largest, 1, delta=max(1e-6, 1e-15 / ratio))

    def test_one_triangle(self):
        for ratio in RATIOS:
            for x in (-0.4, 0., 0.5, 0.9):
                self.check(([(0., 0., 0.), (1., 0., 0.), (x, 0., ratio)], [(0, 1, 2)]), ratio)

    def test_some_triangles(self):
        for ratio in RATIOS:
            for triangles, fold in [(2, 0), (2, 0.7), (3, 0), (3, -1.1), (9, 0)]:
                self.check(strip(ratio, triangles, fold), ratio)

    def test_polygons(self):
        for ratio in RATIOS:
            self.check(polygon(ratio, 7), ratio)
            self.check(wheel(ratio, 5), ratio)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
