# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Atlases of prisms, cylinders, frusta and boxes of few faces have no stretch, without options. Usage:
test_developable.py FLATTEN_MESH"""

import math
import sys
import unittest

from program_case import Program_case

LARGEST_ANGLE = 1e-10  # change of angles in the mean, in radians


def tube(sides, length, rings, top=1.):
    """A prism without caps, or a frustum with another radius on top: points, and triangles as numbers of points"""
    points, faces = [], []
    for i in range(rings + 1):
        r = 1 + (top - 1) * i / rings
        points += [(r * math.cos(2 * math.pi * j / sides), r * math.sin(2 * math.pi * j / sides), length * i / rings)
                   for j in range(sides)]
    for a in range(rings * sides):
        b = a + 1 if (a + 1) % sides else a + 1 - sides
        faces += [(a, b, b + sides), (a, b + sides, a + sides)]
    return points, faces


def caps(sides, surface, number, is_fan):
    """The same with so many caps: polygons, or fans around a point"""
    points, faces = surface
    rims = [list(range(sides))[::-1], list(range(len(points) - sides, len(points)))][:number]
    for rim in rims:
        if is_fan:
            points = points + [(0., 0., points[rim[0]][2])]
            faces = faces + [(rim[i - 1], rim[i], len(points) - 1) for i in range(sides)]
        else:
            faces = faces + [tuple(rim)]
    return points, faces


class Developable(Program_case):
    """Surfaces that unfold after some cuts"""

    def flatten(self, surface, options=()):
        """The report of the atlas"""
        run, report, _ = self.run_program(self.write(*surface), options)
        self.assertEqual(run.returncode, 0, run.stderr)
        return report["atlas"]

    def check(self, atlas):
        self.assertLess(atlas["mean_angle_change"], LARGEST_ANGLE)
        self.assertAlmostEqual(atlas["linf_stretch"], 1, delta=1e-9)

    def tubes(self):
        for sides in 4, 6, 12:
            for length in 0.2, 1, 5, 30:
                for rings in 1, 4:
                    for top in 1, 0.5:
                        yield {"sides": sides, "length": length, "rings": rings, "top": top}

    def test_open_tubes_are_cut_along_one_line(self):
        for shape in self.tubes():
            with self.subTest(**shape):
                self.check(self.flatten(tube(**shape)))
                atlas = self.flatten(tube(**shape), ["--for", "few-charts"])
                self.check(atlas)
                if shape["length"] >= 1:  # shorter ones would be ribbons
                    line = math.hypot(shape["length"], 1 - shape["top"])
                    self.assertEqual(len(atlas["charts"]), 1)
                    self.assertAlmostEqual(atlas["seams"]["length"], line, delta=1e-9 * line)

    def test_caps_are_cut_off(self):
        for shape in self.tubes():
            if shape["length"] < 1 and shape["top"] < 1:
                continue  # too flat for creases around the upper cap
            for number in 1, 2:
                for is_fan in False, True:
                    with self.subTest(caps=number, is_fan=is_fan, **shape):
                        atlas = self.flatten(caps(shape["sides"], tube(**shape), number, is_fan))
                        self.assertEqual(atlas["seams"]["way"], "creases")
                        self.check(atlas)

    def test_bent_surfaces_are_not_cut_along_creases(self):
        """A dome on a cylinder"""
        points, faces = caps(12, tube(12, 1, 1), 2, True)
        points[-1] = (0., 0., 1.5)
        self.assertNotEqual(self.flatten((points, faces))["seams"]["way"], "creases")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
