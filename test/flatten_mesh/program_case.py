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

    def write(self, points, faces, uvs=()):
        """An OBJ file of a surface. Its faces are numbers of points from 0; `uvs` are of corners of the first faces."""
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points] + [f"vt {u!r} {v!r}" for face in uvs for u, v in face]
        first = 1
        for i, face in enumerate(faces):
            if i < len(uvs):
                lines.append("f " + " ".join(f"{v + 1}/{c}" for c, v in enumerate(face, first)))
                first += len(face)
            else:
                lines.append("f " + " ".join(str(v + 1) for v in face))
        model = self.folder / "in.obj"
        model.write_text("\n".join(lines) + "\n")
        return model

    @staticmethod
    def uvs(file):
        """The coordinates of the corners of each face in an OBJ file; None where it has none, or the same at all corners"""
        lines = file.read_text().splitlines() if file.exists() else []
        texture = [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("vt ")]
        corners = [[corner.split("/") for corner in line.split()[1:]] for line in lines if line.startswith("f ")]
        return [[texture[int(c[1]) - 1] for c in face] if len({c[1] for c in face if len(c) > 1 and c[1]}) > 1 else None
                for face in corners]

    def run_program(self, model, options=(), output="out.obj"):
        """The run, its report, and the file that it writes, which is there if it succeeds"""
        result, report = self.folder / output, self.folder / "out.json"
        result.unlink(missing_ok=True)
        command = [sys.argv[1], model, "-o", result, "--json", report, "--threads", "1", *options]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        return run, json.loads(report.read_text()), result
