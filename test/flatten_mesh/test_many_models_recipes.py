#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes of the manual for several machines. A worker is killed half way, and a second run does what is left.
Usage: test_many_models_recipes.py parallel|slurm"""

import os
import re
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "many_models"))
# pylint: disable=wrong-import-position
from folder import FLATTEN_MESH, LIMIT, OUTPUTS, QUICK, SCRIPT, Folder, children, wait_until
from slurm import Cluster

SKIPPED = 77  # what CTest takes for it
PROGRAMS = {"parallel": ["parallel"], "slurm": ["sbatch", "sinfo", "slurmctld", "slurmd"]}


class Recipe(Folder):
    """Two workers share the six models. A recipe is a command that waits for both."""

    environment = None

    def setUp(self):
        super().setUp()
        (self.folder / "models.txt").write_text("\n".join(self.names))

    def check(self, recipe):
        self.run_program(*self.names, *OUTPUTS)
        expected = self.files()
        shutil.rmtree(self.folder / "out")
        hanging = self.folder / self.names[2]
        text = hanging.read_text()
        self.make_pipe(self.names[2])
        with self.started(recipe) as process:
            writer = wait_until(lambda: self.open_for_writing(self.names[2]))
            wait_until((self.folder / "out/a/model 0.json").exists)
            os.kill(self.worker("1/2"), signal.SIGKILL)
            self.assertNotEqual(process.wait(LIMIT), 0, self.told())
            os.close(writer)
        done = self.times_of_reports()
        self.assertLessEqual({"a/model 0", "b/model 0", "b/model 1", "b/model 2"}, done.keys())  # the other's, too
        self.assertNotIn("a/model 1", done)
        hanging.unlink()
        hanging.write_text(text)
        self.finish(recipe)
        self.assertEqual(self.files(), expected)
        times = self.times_of_reports()
        self.assertEqual({name: times[name] for name in done}, done)  # only what was left
        self.finish(recipe)
        self.assertEqual(self.times_of_reports(), times)

    def started(self, recipe):
        with open(self.folder / "told.out", "ab") as log:
            return subprocess.Popen(recipe, cwd=self.folder, stdout=log, stderr=log, env=self.environment)

    def finish(self, recipe):
        with self.started(recipe) as process:
            self.assertEqual(process.wait(LIMIT), 0, self.told())

    def told(self):
        return "\n".join(file.read_text() for file in self.folder.glob("*.out"))

    def times_of_reports(self):
        out = self.folder / "out"
        return {str(file.relative_to(out).with_suffix("")): file.stat().st_mtime_ns for file in out.rglob("*.json")}

    def worker(self, shard):
        """The process of the program for a shard, which has started those for its inputs."""
        processes = []
        for file in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                is_here = os.readlink(file.parent / "cwd") == str(self.folder)
                if is_here and shard.encode() in file.read_bytes().split(b"\0"):
                    processes.append(int(file.parent.name))
            except OSError:  # has ended
                pass
        return next(process for process in processes if children(process))


class Parallel(Recipe):
    def test(self):
        self.check(["parallel", "--will-cite", "-j2", str(FLATTEN_MESH), *QUICK, "--list", "models.txt", "--shard",
                    "{}/2", *OUTPUTS, "--resume", "--quiet", ":::", "1", "2"])


class Slurm(Recipe):
    def test(self):
        """The script, with two tasks and quick options; .glb needs tinygltf."""
        text, count = re.subn(r"\b32\b", "2", SCRIPT.read_text())
        self.assertEqual(count, 2)
        script = self.folder / "flatten_many.slurm"
        script.write_text(text.replace("%.glb", f"%.obj {' '.join(QUICK)}"))
        (self.folder / "bin").mkdir()
        (self.folder / "bin/flatten_mesh").symlink_to(FLATTEN_MESH)
        with Cluster() as cluster:
            self.environment = {**cluster.environment, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"}
            self.check(["sbatch", "--wait", script.name, "models.txt", "out"])
            self.assertTrue(cluster.processes())
        self.assertEqual(cluster.processes(), [])


if __name__ == "__main__":
    name = sys.argv.pop(1)
    missing = [program for program in PROGRAMS[name] if shutil.which(program) is None]
    if missing:
        print(f"skipped: no {', '.join(missing)}")
        sys.exit(SKIPPED)
    unittest.main(defaultTest=name.capitalize())
