# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip file of the add-on: test_zip.py."""

import ast
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zipfile
from pathlib import Path

ADDON = Path(__file__).resolve().parents[1]
WHEEL = "angle_based_flattening-0.1.0-cp311-cp311-linux_x86_64.whl"


def make(output, *wheels):
    return subprocess.run([sys.executable, ADDON / "make_zip.py", output, *wheels], capture_output=True, text=True)


class Zip(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def wheel(self, name=WHEEL):
        with zipfile.ZipFile(self.folder / name, "w") as wheel:
            wheel.writestr("angle_based_flattening/__init__.py", "answer = 42\n")
        return self.folder / name

    def test_contents(self):
        wheels = [self.wheel(), self.wheel("angle_based_flattening-0.1.0-cp310-cp310-manylinux_2_28_aarch64.whl")]
        self.assertEqual(make(self.folder / "a.zip", *wheels).returncode, 0)
        with zipfile.ZipFile(self.folder / "a.zip") as archive:
            names = archive.namelist()
            manifest = tomllib.loads(archive.read("abf_unwrap/blender_manifest.toml").decode())
        self.assertTrue(all(name.startswith("abf_unwrap/") for name in names))
        self.assertFalse([name for name in names if "__pycache__" in name])
        for file in (ADDON / "abf_unwrap").glob("*.py"):
            self.assertIn(f"abf_unwrap/{file.name}", names)
        self.assertEqual(
            sorted(f"abf_unwrap/{wheel[2:]}" for wheel in manifest["wheels"]),
            [name for name in names if name.endswith(".whl")],
        )
        self.assertEqual(manifest["platforms"], ["linux-arm64", "linux-x64"])
        self.assertEqual(manifest["license"], ["SPDX:GPL-3.0-or-later"])
        self.assertNotIn("permissions", manifest)

    def test_versions_agree(self):
        tree = ast.parse((ADDON / "abf_unwrap/__init__.py").read_text())
        info = next(ast.literal_eval(node.value) for node in tree.body if isinstance(node, ast.Assign))
        manifest = tomllib.loads((ADDON / "abf_unwrap/blender_manifest.toml").read_text())
        project = re.search(r"project\(\w+ VERSION ([\d.]+)", (ADDON.parent / "CMakeLists.txt").read_text())[1]
        self.assertEqual({".".join(map(str, info["version"])), manifest["version"]}, {project})
        self.assertEqual(info["name"], manifest["name"])
        self.assertEqual(info["description"], manifest["tagline"])

    def test_same_bytes_again(self):
        wheel = self.wheel()
        for name in ("a.zip", "b.zip"):
            make(self.folder / name, wheel)
        self.assertEqual((self.folder / "a.zip").read_bytes(), (self.folder / "b.zip").read_bytes())

    def test_a_folder_of_wheels(self):
        wheel = self.wheel()
        self.assertEqual(make(self.folder / "a.zip", self.folder).returncode, 0)
        make(self.folder / "b.zip", wheel)
        self.assertEqual((self.folder / "a.zip").read_bytes(), (self.folder / "b.zip").read_bytes())

    def test_bad_wheels(self):
        (self.folder / "empty").mkdir()
        unknown = self.wheel("angle_based_flattening-0.1.0-cp311-cp311-plan9_mips.whl")
        wrong = (
            (unknown, "plan9_mips.whl: no platform"),
            ("missing.whl", "missing.whl: no wheel there"),
            (self.folder / "empty", "empty: no wheel there"),
        )
        for wheel, expected in wrong:
            done = make(self.folder / "a.zip", wheel)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(expected, done.stderr)
            self.assertFalse((self.folder / "a.zip").exists())

    def test_the_module_is_loaded_from_the_wheel(self):
        program = (
            "import sys, importlib.util; sys.path.insert(0, sys.argv[1]); from abf_unwrap import module\n"
            "print(module.load().answer)"
        )
        for wheels, expected in (([self.wheel()], "42\n"), ([], "")):
            make(self.folder / "a.zip", *wheels)
            with tempfile.TemporaryDirectory() as place:
                with zipfile.ZipFile(self.folder / "a.zip") as archive:
                    archive.extractall(place)
                # Isolated, so that no installed module is found.
                done = subprocess.run(
                    [sys.executable, "-I", "-S", "-c", program, place], capture_output=True, text=True
                )
            self.assertEqual(done.stdout, expected)
            self.assertEqual("No module named 'angle_based_flattening'" in done.stderr, not wheels)


if __name__ == "__main__":
    unittest.main()
