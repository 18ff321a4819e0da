# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The unit of length does not matter. Surfaces times a power of two, which rounds nothing, have the same charts and the
same coordinates, bit for bit. Surfaces times another factor have the same charts.

Usage: test_units.py FLATTEN_MESH"""

import math
import random
import sys
import unittest

from program_case import Program_case
from shapes import terrain, torus

MODES = {  # options, and whether lengths in the plane are those on the surface
    "texture": ([], False),
    "few charts": (["--for", "few-charts"], False),
    "rows": (["--seams", "creases", "--no-pack"], True),
    "repacked": (["--repack"], False),
    "simplified and baked": (["--simplify", "200", "--bake-from", "INPUT"], False),
    "plain": (["--plain", "--cut", "auto"], True),
    "plain, injective": (["--plain", "--injective"], True),
    "plain, cones": (["--plain", "--cones", "6"], True),
}


class Units(Program_case):
    """What the program writes"""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        generator = random.Random(5)
        cls.surfaces = {"torus": torus(24, 10), "terrain": terrain(
            16, lambda i, j: generator.uniform(0, 0.8) + 3 * math.sin(i / 3) * math.cos(j / 4))}

    def flatten(self, surface, factor, options):
        """Exit status and diagnosis, charts, and the coordinates of the corners of each face"""
        points, *rest = surface
        model = self.write([[factor * x for x in p] for p in points], *rest)
        run, report, output = self.run_program(model, [model if word == "INPUT" else word for word in options])
        charts = [chart["triangles"] for chart in report["atlas"]["charts"]] if report.get("atlas") else None
        return (run.returncode, report["status"]), charts, self.uvs(output)

    def surface_for(self, mode, surface):
        """Only --repack needs one that has charts."""
        return (*surface, self.flatten(surface, 1, ["--for", "few-charts"])[2]) if mode == "repacked" else surface

    def test_powers_of_two_change_no_bit(self):
        for name, given in self.surfaces.items():
            for mode, (options, has_lengths) in MODES.items():
                surface = self.surface_for(mode, given)
                status, charts, uvs = self.flatten(surface, 1, options)
                self.assertIn(status, ((0, "OK"), (0, "STRETCH_BOUND_MISSED")), (name, mode))
                for factor in (2.0**-20, 2.0**9):
                    with self.subTest(surface=name, mode=mode, factor=factor):
                        unit = factor if has_lengths else 1
                        other = self.flatten(surface, factor, options)
                        self.assertEqual(other[:2], (status, charts))
                        self.assertTrue(other[2] == [[(unit * u, unit * v) for u, v in face] for face in uvs])

    def test_other_factors_give_the_same_charts(self):
        surface = self.surfaces["terrain"]
        for options in ([], ["--for", "few-charts"], ["--plain", "--injective"]):
            expected = self.flatten(surface, 1, options)[:2]
            for factor in (1 / 3, 1000):
                with self.subTest(options=options, factor=factor):
                    self.assertEqual(self.flatten(surface, factor, options)[:2], expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
