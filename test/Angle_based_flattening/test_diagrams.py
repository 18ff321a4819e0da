# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagrams of the manual are those that their script draws from the benchmarks' figures."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "benchmark/Angle_based_flattening/RESULTS.md"


def draw(results, folder):
    return subprocess.run([sys.executable, ROOT / "doc/standalone/draw_diagrams.py", results, folder], capture_output=True,
                          text=True)


class Diagrams(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_they_are_up_to_date(self):
        self.assertEqual(draw(RESULTS, self.folder).returncode, 0)
        drawn = sorted(self.folder.glob("*.svg"))
        self.assertTrue(drawn)
        for file in drawn:
            ElementTree.parse(file)
            committed = ROOT / "doc/Angle_based_flattening/fig" / file.name
            self.assertEqual(file.read_text(), committed.read_text(), f"draw {file.name} again: scripts/doc --pictures")

    def test_missing_figures_are_an_error(self):
        results = self.folder / "results.md"
        results.write_text(RESULTS.read_text().replace("| hierarchical ABF++ | 1 |", "| another method | 1 |", 1))
        done = draw(results, self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("three methods", done.stderr)


if __name__ == "__main__":
    unittest.main()
