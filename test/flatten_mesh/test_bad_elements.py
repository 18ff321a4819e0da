# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""One bad face does not condemn others: they have the charts and the coordinates that they have without it.
Usage: test_bad_elements.py FLATTEN_MESH"""

import math
import random
import sys
import unittest

from program_case import Program_case
from shapes import sphere


class Bad_elements(Program_case):
    """Faces added to a sphere"""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.points, cls.faces = sphere(8, 12)

    def flatten(self, points, faces, options=(), uvs=()):
        """Exit status, what is said, the report, and the coordinates of each face; None where it has none"""
        run, report, output = self.run_program(self.write(points, faces, uvs), options)
        return run.returncode, run.stderr, report, self.uvs(output)

    def options_and_uvs(self):
        """Ways to an atlas; --repack keeps one."""
        *_, uvs = self.flatten(self.points, self.faces)
        return [([], ()), (["--for", "few-charts"], ()), (["--repack"], uvs)]

    def with_flaps(self, corner):
        """The sphere with faces at 20 of its edges, whose third corner is a new point"""
        generator = random.Random(3)
        points, faces = list(self.points), list(self.faces)
        for a, b, _ in generator.sample(self.faces, 20):
            points.append(corner(self.points[a], self.points[b]))
            faces.append((a, len(points) - 1, b))
        return points, faces

    def check(self, corner, options, uvs):
        """Returns what happens with the flaps, after a look at the others."""
        _, _, expected, charts = self.flatten(self.points, self.faces, options, uvs)
        status, text, report, found = self.flatten(*self.with_flaps(corner), options, uvs)
        self.assertEqual(found[:len(charts)], charts)
        self.assertEqual(report["atlas"]["charts"], expected["atlas"]["charts"])
        return status, text, found[len(charts):]

    def test_faces_without_area_lie_on_an_edge(self):
        corners = {"the middle of an edge": lambda p, q: tuple((x + y) / 2 for x, y in zip(p, q)),
                   "an end of an edge": lambda p, q: p,
                   "beyond an edge": lambda p, q: tuple(2 * y - x for x, y in zip(p, q))}
        for options, uvs in self.options_and_uvs():
            for name, corner in corners.items():
                with self.subTest(options=options, corner=name):
                    status, text, flaps = self.check(corner, options, uvs)
                    self.assertEqual(status, 0, text)
                    self.assertRegex(text, f"20 faces without area, the first is face {len(self.faces) + 1}: ")
                    for (u1, v1), (u2, v2), (u3, v3) in flaps:
                        area = (u2 - u1) * (v3 - v1) - (u3 - u1) * (v2 - v1)
                        self.assertAlmostEqual(area, 0, delta=1e-15)
                        self.assertTrue(min(u1, u3) <= u2 <= max(u1, u3) and min(v1, v3) <= v2 <= max(v1, v3))

    def test_faces_without_area_elsewhere_do_not_matter_to_a_component(self):
        """Faces outside of the component that is asked for are never told to lack a chart."""
        points, faces = self.with_flaps(lambda p, q: p)
        points = points + [(0., 0., 9.), (1., 0., 9.), (0., 1., 9.)]
        status, text, _, found = self.flatten(points, faces + [tuple(len(points) - k for k in (3, 2, 1))],
                                              ["--component", "1"])
        self.assertEqual(status, 0, text)
        self.assertEqual([i for i, uv in enumerate(found) if uv], [len(faces)])

    def test_faces_at_wrong_points_are_left_out(self):
        corners = {"NON_FINITE_POINT": lambda p, q: (math.nan, 0., 0.), "FAR_POINT": lambda p, q: (0., -1e20, 1.)}
        for options, uvs in self.options_and_uvs():
            for name, corner in corners.items():
                with self.subTest(options=options, corner=name):
                    status, text, flaps = self.check(corner, options, uvs)
                    self.assertEqual(status, 2, text)
                    self.assertRegex(text, f"no chart for 20 faces, the first is face {len(self.faces) + 1}: {name}: ")
                    self.assertEqual(flaps, 20 * [None])

    def test_holes_at_bridges(self):
        """A plate of one face with a hole, which a bridge joins to the border: the triangles cover all but the hole."""
        points = [(x, y, 0.) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (1, 3), (3, 3), (3, 1))]
        status, text, _, found = self.flatten(points, [(0, 1, 2, 3, 0, 4, 5, 6, 7, 4)])
        self.assertEqual(status, 0, text)
        self.assertRegex(text, "1 face has a hole that a bridge joins to the border, .*; the first is face 1")
        areas = [((p[0] - o[0]) * (q[1] - o[1]) - (q[0] - o[0]) * (p[1] - o[1])) / 2 for o, p, q in found]
        self.assertEqual(len(areas), 8)
        u, v = ([corner[axis] for face in found for corner in face] for axis in (0, 1))
        self.assertGreater(min(areas), 0)
        self.assertAlmostEqual(sum(areas), (max(u) - min(u)) * (max(v) - min(v)) * 12 / 16, delta=1e-9)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
