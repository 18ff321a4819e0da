# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluator of the benchmark `peers.py`, on maps whose numbers are known, and the limits of its processes."""

import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

BENCHMARK = Path(__file__).parents[2] / "benchmark" / "Angle_based_flattening"
sys.path.insert(0, str(BENCHMARK))
# pylint: disable=wrong-import-position
from evaluator import common_areas, evaluate

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
HALVES = np.array([[0, 1, 2], [0, 2, 3]])
PLANE = np.pad(SQUARE, ((0, 0), (0, 1)))
CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
SIDES = np.array([[0, 2, 6, 4], [1, 5, 7, 3], [0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5]])
CUBE_FACES = SIDES[:, HALVES].reshape(-1, 3)


class Evaluator(unittest.TestCase):
    def check(self, numbers: dict, **expected: float) -> None:
        for name, number in expected.items():
            self.assertAlmostEqual(numbers[name], number, msg=name)

    def test_sides_of_a_cube(self) -> None:
        places = np.array([[i % 3, i // 3] for i in range(6)]) / 3
        corners = (SQUARE[HALVES] / 4 + places[:, None, None, None]).reshape(-1, 3, 2)
        for turned in (corners, corners * [-1, 1]):  # also with mirrored charts
            self.check(evaluate(CUBE, CUBE_FACES, turned), charts=6, seam=12 / math.sqrt(6), flipped=0, within=0,
                       between=0, density=.375, w05=.375, dirichlet=4, covered=.375, unmapped=0)
        self.check(evaluate(CUBE, CUBE_FACES, corners, .5), density=.75, w05=.75, covered=.75)

    def test_charts_alone_get_their_areas(self) -> None:
        corners = np.concatenate([SQUARE[HALVES] * (i + 1) for i in range(6)])
        vertices, faces = CUBE[SIDES].reshape(-1, 3), np.concatenate([HALVES + 4 * i for i in range(6)])
        self.check(evaluate(vertices, faces, corners, None), charts=6, within=0, between=0, density=1, w05=1,
                   dirichlet=4)

    def test_stretch(self) -> None:
        self.check(evaluate(PLANE, HALVES, SQUARE[HALVES] * [1, .5]), charts=1, seam=0, density=.4, w05=.25,
                   dirichlet=5, covered=.5)

    def test_flips_and_faces_without_map(self) -> None:
        corners = SQUARE[HALVES]
        corners[1, 2] = [.75, .5]
        self.check(evaluate(PLANE, HALVES, corners), flipped=1, within=0, unmapped=0)
        corners[1] = np.nan
        self.check(evaluate(PLANE, HALVES, corners), charts=1, flipped=0, unmapped=1, seam=math.sqrt(2), w05=0)

    def test_overlaps(self) -> None:
        triangle = SQUARE[None, [0, 1, 3]]
        for shift, area in (((.5, 0), .125), ((.25, .25), .125), ((0, 0), .5), ((1, 0), 0), ((.5, .5), 0)):
            self.assertAlmostEqual(common_areas(triangle, triangle + shift)[0], area)
        vertices, faces = np.concatenate([PLANE, PLANE + [0, 0, 1]]), np.concatenate([HALVES, HALVES + 4])
        corners = np.concatenate([SQUARE[HALVES], SQUARE[HALVES] + [.5, 0]])
        self.check(evaluate(vertices, faces, corners), charts=2, within=0, between=3)

    def test_a_chart_overlaps_itself(self) -> None:
        """Seven triangles around a vertex, of 60 degrees each"""
        angles = np.arange(8) * math.pi / 3
        plane = np.concatenate([[[0, 0]], np.column_stack([np.cos(angles), np.sin(angles)])])
        faces = np.array([[0, i, i + 1] for i in range(1, 8)])
        self.check(evaluate(np.column_stack([plane, np.arange(9)]), faces, plane[faces]), charts=1, within=1, between=0)

    def test_limits(self) -> None:
        def failure(seconds: float, gigabytes: float, program: str) -> str:
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "used.json"
                subprocess.run([sys.executable, BENCHMARK / "confined.py", str(seconds), str(gigabytes), file,
                                sys.executable, "-c", program], check=True)
                return json.loads(file.read_text(encoding="ascii"))["failure"]

        self.assertEqual(failure(9, 1, "print()"), "")
        self.assertEqual(failure(1, 1, "while True: pass"), "did not end in 1 s")
        self.assertEqual(failure(9, .05, "a = b'1' * 10**8\nwhile True: pass"), "did not end: more than 0.05 GB")
        self.assertEqual(failure(9, 1, "import os; os.kill(os.getpid(), 11)"), "crashed by signal 11")


if __name__ == "__main__":
    unittest.main()
