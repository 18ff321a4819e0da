# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""compare_results.py finds no difference between two runs of the program, and each kind of change.
Usage: test_compare_results.py FLATTEN_MESH"""

import json
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from program_case import Program_case

SCRIPT = Path(__file__).resolve().parent / "compare_results.py"


class Compare_results(Program_case):
    """Results of one model, made twice"""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name in ("old", "new"):
            subprocess.run([sys.executable, SCRIPT, "make", sys.argv[1], cls.folder / name, "--only", "octahedron",
                            "--jobs", "1"], check=True, stdout=subprocess.DEVNULL)

    def differences(self, new="new"):
        """Exit status, and the lines of what differs"""
        run = subprocess.run([sys.executable, SCRIPT, "compare", self.folder / "old", self.folder / new],
                             capture_output=True, text=True, check=False)
        return run.returncode, run.stdout.splitlines()[:-1]

    def change(self, name, function):
        """What differs when one file of the new results is changed"""
        changed = self.folder / "changed"
        shutil.rmtree(changed, ignore_errors=True)
        shutil.copytree(self.folder / "new", changed)
        function(changed / "octahedron" / name)
        status, lines = self.differences("changed")
        self.assertEqual(status, 1)
        self.assertEqual([line.split(": ")[0] for line in lines], [f"octahedron/{name}"])
        return lines[0]

    def test_same(self):
        """Seconds differ, and do not count."""
        self.assertEqual(self.differences(), (0, []))

    def test_changes(self):
        """A file, a coordinate, a status, a message, and a member of a report"""
        def scaled(file):
            text = file.read_text()
            line = next(line for line in text.split("\n") if line.startswith("vt "))
            number = float(line.split()[1])
            file.write_text(text.replace(line, line.replace(line.split()[1], repr(number + 1e-8)), 1))

        def without_charts(file):
            report = json.loads(file.read_text())
            report["atlas"]["charts"].pop()
            file.write_text(json.dumps(report))

        self.assertIn("only in", self.change("plain/o.selection.txt", Path.unlink))
        self.assertIn("a number", self.change("texture/o.obj", scaled))
        self.assertIn("a number", self.change("texture/status.txt", lambda f: f.write_text("1" + f.read_text()[1:])))
        self.assertIn("words", self.change("texture/status.txt", lambda f: f.write_text(f.read_text() + "note")))
        self.assertIn("/atlas/charts", self.change("texture/o.json", without_charts))
        self.assertIn("other", self.change("few-charts/o.glb", lambda f: f.write_bytes(f.read_bytes()[:-4] + b"abcd")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
