#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs flatten_mesh on many models: processes that crash or hang, shards, runs that go on where others ended, and the
table of all reports."""

import csv
import io
import json
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
from folder import FLATTEN_MESH, LIMIT, OUTPUTS, QUICK, SCRIPT, Folder


class Processes(Folder):
    def test_one_crashes(self):
        """The others go on, and messages keep the order of the inputs."""
        self.make_pipe(self.names[1])
        for jobs in ("1", "2"):
            process = self.start(*self.names, "absent.off", *OUTPUTS, "--quiet", "--jobs", jobs)
            os.kill(self.child_at_pipe(process, self.names[1]), signal.SIGSEGV)
            self.assertEqual(process.wait(LIMIT), 5)
            lines = process.stderr.read().splitlines()
            self.assertEqual(len(lines), 2, lines)
            self.assertRegex(lines[0], r"'in/b/model 0.off': CRASHED: ended by signal 11")
            self.assertRegex(lines[1], "absent.off")
            statuses = [self.report(name)["status"] for name in self.names]
            self.assertEqual(statuses, ["OK", "CRASHED"] + 4 * ["OK"])
            self.assertFalse((self.folder / "out/in/b/model 0.obj").exists())
            shutil.rmtree(self.folder / "out")

    def test_time_is_over(self):
        self.make_pipe(self.names[0])
        for inputs, seconds in ((self.names[:1], "0.5"), (self.names[:3], "3")):
            result = self.run_program(*inputs, *OUTPUTS, "--quiet", "--timeout", seconds, status=3)
            self.assertRegex(result.stderr, f"^flatten_mesh: 'in/a/model 0.off': TIMED_OUT: not done after {seconds} s")
            self.assertEqual(len(list(self.folder.glob("out/**/*.obj"))), len(inputs) - 1)
        self.assertEqual([self.report(name[3:])["status"] for name in self.names[:3]], ["TIMED_OUT", "OK", "OK"])

    def test_memory_is_used_up(self):
        rows = 150
        points = "".join(f"{i % rows} {i // rows} {i % 7}\n" for i in range(rows * rows))
        faces = "".join(f"4 {i} {i + 1} {i + rows + 1} {i + rows}\n" for i in range(rows * (rows - 1)) if (i + 1) % rows)
        (self.folder / self.names[1]).write_text(f"OFF\n{rows * rows} {(rows - 1)**2} 0\n{points}{faces}")
        result = self.run_program(*self.names[:3], *OUTPUTS, "--quiet", "--memory", "30M", status=4)
        self.assertRegex(result.stderr, "^flatten_mesh: 'in/b/model 0.off': OUT_OF_MEMORY: .*30M")
        self.assertEqual([self.report(name[3:])["status"] for name in self.names[:3]], ["OK", "OUT_OF_MEMORY", "OK"])
        self.assertFalse((self.folder / "out/in/b/model 0.obj").exists())
        self.run_program(self.names[0], *OUTPUTS, "--memory", "100G")

    def test_interrupted(self):
        """No process and no unfinished file remains."""
        self.make_pipe(self.names[0])
        self.make_pipe(self.names[1])
        for number in (signal.SIGTERM, signal.SIGINT):
            process = self.start(*self.names, *OUTPUTS, "--jobs", "2")
            known = [self.child_at_pipe(process, name) for name in self.names[:2]]
            process.send_signal(number)
            self.assertEqual(process.wait(LIMIT), -number)
            for child in known:
                self.assertFalse(Path(f"/proc/{child}").exists())
            self.assertEqual([*self.folder.rglob("*.unfinished"), *self.folder.rglob("*.json")], [])


class Parts(Folder):
    def test_shards_and_lists(self):
        """However the inputs are given, and by however many runs, the files are the same."""
        self.run_program(*self.names, *OUTPUTS)
        expected = self.files()
        self.assertEqual(len(expected), 2 * len(self.names))
        self.assertIn("a/model 0.obj", expected)
        lines, nulls = "\n".join(self.names) + "\n", "\0".join(self.names)
        (self.folder / "list").write_text(lines.replace("\n", "\r\n\n"))
        for runs in ([["--list", "list", "--jobs", "3"]], [["--list", "-", "-0"]],
                     [["--list", "-", "-0", "--shard", "1/2"], ["--list", "-", "-0", "--shard", "2/2"]],
                     [["--list", "list", "--shard", f"{k}/7"] for k in range(1, 8)]):
            shutil.rmtree(self.folder / "out")
            for arguments in runs:
                self.run_program(*arguments, *OUTPUTS, text=nulls)
            self.assertEqual(self.files(), expected)

    def test_wrong_usage(self):
        (self.folder / "empty").write_text("\n")
        for arguments, message in ((["--shard", "0/2"], "I/N"), (["--shard", "3/2"], "I/N"), (["--shard", "1"], "I/N"),
                                   (["--jobs", "0"], "--jobs"), (["--timeout", "0"], "--timeout"),
                                   (["--timeout", "nan"], "--timeout"), (["--memory", "4X"], "4X"),
                                   (["--memory", "-1"], "-1"), (["--memory", "1M"], "1M"),
                                   (["--resume"], "--json"), (["-0"], "--list"),
                                   (["--list", "absent"], "absent"), (["--list", "empty"], "no name"),
                                   (["--summary", "in"], "without --"), (["--json", "%.json"], "--output-folder")):
            result = self.run_program(*self.names, *arguments, status=2)
            self.assertIn(message, result.stderr)
        self.run_program(*self.names, "--one-atlas", "--shard", "1/2", status=2)
        self.run_program("--shard", "1/2", status=2)
        for k in range(1, 4):  # with equal names, whether or not these are in one shard
            result = self.run_program(*self.names, "--json", "%.json", "--shard", f"{k}/3", status=2)
            self.assertIn("--output-folder", result.stderr)
            result = self.run_program(*self.names, "--json", "one.json", "--shard", f"{k}/6", status=2)
            self.assertIn("'%'", result.stderr)


class Resumed(Folder):
    def test_resume(self):
        def skipped(*arguments, status=0):
            text = self.run_program(*self.names, *OUTPUTS, "--resume", *arguments, status=status).stderr
            return int(re.search(r"(\d+) of 6 inputs skipped", text)[1])

        self.assertEqual(skipped(), 0)
        expected = self.files()
        self.assertEqual(skipped("--threads", "2", "--jobs", "2", "--timeout", "50"), 6)
        (self.folder / self.names[1]).touch()  # newer than its report
        file = self.folder / "out/a/model 1.json"
        file.write_text(file.read_text()[:-10])  # not whole
        file = self.folder / "out/a/model 2.json"
        file.write_text(file.read_text().replace('"OK"', '"TIMED_OUT"', 1))  # may succeed now
        self.assertEqual(skipped(), 3)
        self.assertEqual(self.files(), expected)
        self.assertEqual(skipped("--block", "4"), 0)
        self.assertEqual(skipped("--block", "4"), 6)
        (self.folder / self.names[0]).write_text("OFF\n")  # wrong for good
        self.assertEqual(skipped("--block", "4", status=2), 5)
        self.assertEqual(skipped("--block", "4", status=2), 6)

    def test_slurm_script(self):
        """The tasks of an array do all models, and again those that are missing."""
        self.run_program(*self.names, *OUTPUTS)
        (self.folder / "models.txt").write_text("\n".join(self.names))
        (self.folder / "bin").mkdir()
        (self.folder / "bin/flatten_mesh").symlink_to(FLATTEN_MESH)
        script = SCRIPT.read_text().replace("%.glb", f"%.obj {' '.join(QUICK)}")  # .glb needs tinygltf
        path = f"{self.folder / 'bin'}:{os.environ['PATH']}"
        for tasks in (range(1, 8), [2]):
            for task in tasks:
                subprocess.run(["bash", "-c", script, "script", "models.txt", "array"], cwd=self.folder, check=True,
                               timeout=LIMIT, env={**os.environ, "PATH": path, "SLURM_ARRAY_TASK_ID": str(task)})
            self.assertEqual(self.files("array"), self.files())
            (self.folder / "array/b/model 0.json").unlink()


class Summary(Folder):
    def test_summary(self):
        (self.folder / "in/a/bad,name.off").write_text("OFF\n")
        self.run_program(*self.names, "in/a/bad,name.off", *OUTPUTS, status=2)
        whole = (self.folder / "out/a/model 0.json").read_text()
        others = {"other": "{}", "nothing": "", "half": whole[:len(whole) // 2], "deep": 1000000 * "[",
                  "deeper": 300000 * '{"status": ', "empty": whole.replace('"OK"', '""', 1),
                  "bytes": bytes(range(256)).decode("latin-1")}
        for name, text in others.items():
            (self.folder / f"out/{name}.json").write_text(text)
        result = self.run_summary("--summary", "out")
        for name in others:
            self.assertIn(f"{name}.json' is no report", result.stderr)
        self.assertRegex(result.stderr, "7 reports: 6 OK, 1 WRONG_INPUT\n$")
        rows = {row["name"]: row for row in csv.DictReader(io.StringIO(result.stdout))}
        self.assertEqual(len(rows), 7)
        for name in self.names:
            row, report = rows[name[3:-4]], self.report(name[3:])
            self.assertEqual((row["status"], row["input"], row["message"]), ("OK", name, ""))
            self.assertEqual(int(row["triangles"]), report["triangles"])
            self.assertEqual(int(row["charts"]), len(report["atlas"]["charts"]))
            self.assertEqual(float(row["covered"]), report["atlas"]["packing"]["covered_share"])
            self.assertEqual(float(row["stretch"]), report["atlas"]["l2_stretch"])
            self.assertEqual(float(row["seam"]), report["atlas"]["seams"]["relative_length"])
            self.assertAlmostEqual(float(row["seconds"]), sum(report["seconds"].values()), places=2)
        self.assertEqual(rows["a/bad,name"]["status"], "WRONG_INPUT")
        self.assertEqual(rows["a/bad,name"]["triangles"], "")
        self.run_summary("--summary", "out", "--output", "table.csv", "--quiet")
        self.assertEqual((self.folder / "table.csv").read_text(), result.stdout)
        self.run_summary("--summary", "out", "--report", "page.html", "--output", "again.csv", "--quiet")
        self.assertEqual((self.folder / "again.csv").read_text(), result.stdout)
        page = self.run_summary("--summary", "out", "--report", "-").stdout  # without the table
        self.assertEqual((self.folder / "page.html").read_text(), page)
        self.assertIn('<script type="application/json" id="summary">', page)
        self.run_summary("--summary", "in", status=2)
        self.run_summary("--summary", "absent", status=2)
        self.run_summary("--summary", "out", "--output", "table.obj", status=2)
        for arguments in (["page.csv"], ["-", "--output", "-"], ["absent/page.html"]):
            self.assertIn(arguments[0], self.run_summary("--summary", "out", "--report", *arguments, status=2).stderr)

    def run_summary(self, *arguments, status=0):
        result = subprocess.run([str(FLATTEN_MESH), *arguments], cwd=self.folder, capture_output=True, text=True,
                                check=False)
        self.assertEqual(result.returncode, status, result.stderr)
        return result


if __name__ == "__main__":
    unittest.main()
