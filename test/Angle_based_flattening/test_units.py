# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The unit of length does not matter. Surfaces times a power of two, which rounds nothing, have the same charts and the
same coordinates, bit for bit. Surfaces times another factor have the same charts.

Usage: test_units.py FLATTEN_MESH"""

import json
import math
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv[1]
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


def torus(n, m):
    """A ring"""
    points = [((3 + math.cos(v)) * math.cos(u), (3 + math.cos(v)) * math.sin(u), math.sin(v))
              for u in (2 * math.pi * i / n for i in range(n)) for v in (2 * math.pi * j / m for j in range(m))]
    faces = [face for i in range(n) for j in range(m) for a, b in [(i * m, (i + 1) % n * m)] for k in [(j + 1) % m]
             for face in ((a + j, b + j, b + k), (a + j, b + k, a + k))]
    return points, [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]


def terrain(n):
    """Rough, with a border"""
    generator = random.Random(5)
    points = [(i, j, generator.uniform(0, 0.8) + 3 * math.sin(i / 3) * math.cos(j / 4))
              for i in range(n) for j in range(n)]
    faces = [face for i in range(n - 1) for j in range(n - 1) for a in [i * n + j + 1]
             for face in ((a, a + n, a + 1), (a + 1, a + n, a + n + 1))]
    return points, [f"f {a} {b} {c}" for a, b, c in faces]


class Units(unittest.TestCase):
    """What the program writes"""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.surfaces = {"torus": torus(24, 10), "terrain": terrain(16)}

    def flatten(self, surface, factor, options):
        """Exit status and diagnosis, lines of faces, and texture coordinates"""
        points, rest = surface
        model, output, report = (self.folder / name for name in ("in.obj", "out.obj", "out.json"))
        lines = ["v " + " ".join(repr(factor * x) for x in p) for p in points]
        model.write_text("\n".join(lines + rest) + "\n")
        output.unlink(missing_ok=True)
        command = [PROGRAM, model, "-o", output, "--json", report, "--quiet", "--threads", "1", *options]
        run = subprocess.run([model if word == "INPUT" else word for word in command], capture_output=True, check=False)
        text = output.read_text().splitlines() if output.exists() else []
        return ((run.returncode, json.loads(report.read_text())["status"]),
                [line for line in text if line.startswith("f ")],
                [tuple(map(float, line.split()[1:])) for line in text if line.startswith("vt ")])

    def surface_for(self, mode, surface):
        """Only --repack needs one that has charts."""
        if mode != "repacked":
            return surface
        _, faces, uvs = self.flatten(surface, 1, ["--for", "few-charts"])
        return surface[0], [f"vt {u!r} {v!r}" for u, v in uvs] + faces

    def test_powers_of_two_change_no_bit(self):
        for name, given in self.surfaces.items():
            for mode, (options, has_lengths) in MODES.items():
                surface = self.surface_for(mode, given)
                status, faces, uvs = self.flatten(surface, 1, options)
                self.assertIn(status, ((0, "OK"), (0, "STRETCH_BOUND_MISSED")), (name, mode))
                for factor in (2.0**-20, 2.0**9):
                    with self.subTest(surface=name, mode=mode, factor=factor):
                        unit = factor if has_lengths else 1
                        other = self.flatten(surface, factor, options)
                        self.assertEqual(other[:2], (status, faces))
                        self.assertTrue(other[2] == [(unit * u, unit * v) for u, v in uvs])

    def test_other_factors_give_the_same_charts(self):
        surface = self.surfaces["terrain"]
        for options in ([], ["--for", "few-charts"], ["--plain", "--injective"]):
            expected = self.flatten(surface, 1, options)[:2]
            for factor in (1 / 3, 1000):
                with self.subTest(options=options, factor=factor):
                    self.assertEqual(self.flatten(surface, factor, options)[:2], expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
