# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the benchmark `compare.py` makes of its figures, and what is told of processes that fail."""

import sys
import unittest
from math import exp, inf, log, nan
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmark" / "Angle_based_flattening"))
# pylint: disable=wrong-import-position
import run
from comparison import Results, distortions_table, growth, ratios_table
from relations import relations_table


def results_of(name: str, first: list[float], second: list[float], failure: str = "") -> Results:
    """Meshes of 1000, 4000, 16000 faces; a number of two methods, and a failure of the second one"""
    rows = []
    for number, values in enumerate(zip(first, second)):
        for method, value in zip(("abf++", "lscm"), values):
            rows.append({"number": number, "mesh": "mesh", "faces": 1000 * 4**number, "resized": True,
                         "method": method, name: value, "failure": failure * (method == "lscm")})
    return Results(rows)


def row(table: str, text: str) -> str:
    """That with the text in it"""
    return next(line for line in table.splitlines() if text in line)


class Comparison(unittest.TestCase):
    def test_power_laws_are_fitted(self) -> None:
        results = results_of("seconds", [1, 8, 64], [2, 3, nan])
        sizes, line = growth(results, "abf++")
        self.assertEqual(sizes, 3)
        self.assertAlmostEqual(line[1], 1.5)
        self.assertAlmostEqual(exp(line(log(4000))), 8)
        self.assertEqual(growth(results, "lscm"), (2, None))

    def test_relations_tell_on_how_many_meshes_they_are_seen(self) -> None:
        def seen(abf: list[float], lscm: list[float]) -> str:
            return row(relations_table(results_of("stretch", abf, lscm)), "LSCM stretches more than ABF++")

        self.assertIn("| 2 | 4 | 8 | 3 of 3 | yes |", seen([1, 1, 1], [2, 4, 8]))
        self.assertIn("| 0.5 | 1 | 2 | 2 of 3 | on some |", seen([1, 2, 1], [2, 1, 1]))
        self.assertIn("| 0 of 2 | NO |", seen([2, 4], [1, 1]))
        self.assertIn("| 3 | 3 | inf | 2 of 2 | yes |", seen([1, 1], [3, inf]))
        self.assertIn("| – | – | – | 0 of 0 | not measured |", seen([nan], [1]))

    def test_flips_are_counted(self) -> None:
        table = relations_table(results_of("flips", [0, 1], [0, 7]))
        self.assertIn("| 0 | – | 1 | 1 of 2 | on some |", row(table, "ABF++ flips nothing"))
        self.assertIn("| 0 | – | 7 | 1 of 2 | yes |", row(table, "| LSCM may flip"))

    def test_ratios_are_geometric_means_of_what_is_finite(self) -> None:
        results = results_of("stretch", [1, 4, 1], [2, 1, inf])
        self.assertEqual(row(ratios_table(results, "lscm"), "| ABF++"), "| ABF++ | 0 | – | – | – | 1.41 | 2 | – |")

    def test_nothing_is_said_of_meshes_without_distortion(self) -> None:
        results = results_of("energy", [1e-20, 1], [1e-20, 2])
        self.assertEqual(list(results.quotients("energy", "lscm", "abf++")), [2])

    def test_failures_are_told(self) -> None:
        for failure, told in (("no solution", "| FAILED: no solution |"),
                              ("stopped: took longer than 8 s", "| stopped: took longer than 8 s |")):
            results = results_of("seconds", [1], [nan], failure)
            self.assertIn(told, row(distortions_table(results, 0, 5000), "| LSCM"))
            self.assertTrue(results.csv().endswith(failure + "\n"))


class Processes(unittest.TestCase):
    def measure(self, script: str, seconds: float = 10) -> run.Measurement:
        """Of a shell in place of the program"""
        return run.Measure(Path("/bin/sh"), seconds, 1).one("-c", script)

    def test_measurements_are_found_among_other_output(self) -> None:
        script = """echo 'a library says'; echo '{"a": 1, "b": Infinity}'; echo more"""
        self.assertEqual(self.measure(script), {"a": 1, "b": inf})

    def test_failures_are_named(self) -> None:
        for script, failure in (("kill -11 $$", "killed by signal 11"), ("exit 3", "ended with status 3"),
                                ("true", "the process ended without a result"),
                                ("exec sleep 60", "took longer than 0.5 s")):
            self.assertEqual(self.measure(script, 0.5), {"failure": failure})

    def test_medians_are_those_of_runs_that_succeeded(self) -> None:
        self.assertEqual(run.median([{"a": 1}, {"a": 5}, {"a": 2}]), {"a": 2})
        self.assertEqual(run.median([{"a": 1}, {"failure": "why"}]), {"failure": "why"})


if __name__ == "__main__":
    unittest.main()
