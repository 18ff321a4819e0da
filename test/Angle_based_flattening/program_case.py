# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of flatten_mesh share. The program is the first argument of each of them."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


class Program_case(unittest.TestCase):
    """Tests with a folder of their own"""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)

    def write(self, points, faces):
        """An OBJ file of a surface: its faces are numbers of points from 0"""
        model = self.folder / "in.obj"
        model.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points) +
                         "".join("f " + " ".join(str(v + 1) for v in face) + "\n" for face in faces))
        return model

    def run_program(self, model, options=(), output="out.obj"):
        """The run, its report, and the file that it writes, which is there if it succeeds"""
        result, report = self.folder / output, self.folder / "out.json"
        result.unlink(missing_ok=True)
        command = [sys.argv[1], model, "-o", result, "--json", report, "--threads", "1", *options]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        return run, json.loads(report.read_text()), result
