#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs flatten_mesh on many models: processes that crash or hang, shards, runs that go on where others ended, and the
table of all reports. Usage: test_many_models.py FLATTEN_MESH"""

import csv
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

FLATTEN_MESH = Path(sys.argv.pop(1)).resolve()
SCRIPT = Path(__file__).resolve().parents[2] / "examples/Angle_based_flattening/flatten_many.slurm"
QUICK = ["--for", "few-charts", "--resolution", "64", "--rotations", "1"]
OUTPUTS = ["--output-folder", "out", "--output", "%.obj", "--json", "%.json"]
DIFFERENT = ("seconds", "peak_memory_mb", "options")  # between two runs
LIMIT = 60  # seconds, on any machine


def pyramid(sides, height):
    """The text of a pyramid without its base."""
    points = "".join(f"{x} {y} 0\n" for x, y in ((k, (k * (sides - k)) ** 0.5) for k in range(sides + 1)))
    faces = "".join(f"3 {k} {k + 1} {sides + 1}\n" for k in range(sides))
    return f"OFF\n{sides + 2} {sides} 0\n{points}{sides / 2} 0 {height}\n{faces}"


def children(process):
    """The processes that a process has started."""
    return [int(child) for child in Path(f"/proc/{process}/task/{process}/children").read_text().split()]


def wait_until(condition):
    end = time.monotonic() + LIMIT
    while not (result := condition()):
        assert time.monotonic() < end, "it does not happen"
        time.sleep(0.01)
    return result


def reads(process, name):
    """Whether a process has a file open, or waits for the other end of a pipe."""
    try:
        return any(os.readlink(file).endswith(name) for file in Path(f"/proc/{process}/fd").iterdir())
    except OSError:
        return False


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.names = []
        for k in range(6):
            name = f"in/{'ab'[k % 2]}/model {k // 2}.off"  # equal names in two folders
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(pyramid(4 + k, 1 + k))
            self.names.append(name)

    def command(self, *arguments):
        return [str(FLATTEN_MESH), *QUICK, *map(str, arguments)]

    def run_program(self, *arguments, status=0, text=None):
        result = subprocess.run(self.command(*arguments), cwd=self.folder, input=text, capture_output=True, text=True,
                                timeout=LIMIT, check=False)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def start(self, *arguments):
        process = subprocess.Popen(self.command(*arguments), cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        return process

    def report(self, name, folder="out"):
        return json.loads((self.folder / folder / name).with_suffix(".json").read_text())

    def files(self, folder="out"):
        """The texts of all files, but for what differs between two runs."""
        result = {}
        for file in sorted((self.folder / folder).rglob("*.*")):
            text = file.read_text()
            if file.suffix == ".json":
                report = json.loads(text)
                text = json.dumps({key: report[key] for key in report if key not in DIFFERENT})
            result[str(file.relative_to(self.folder / folder))] = text
        return result

    def make_pipe(self, name):
        """A model at which the program hangs, because nobody writes it."""
        (self.folder / name).unlink(missing_ok=True)
        os.mkfifo(self.folder / name)

    def child_at_pipe(self, process, name):
        """The process that waits for the pipe, once the pipe has a reader."""
        writer = wait_until(lambda: self.open_for_writing(name))
        self.addCleanup(os.close, writer)
        return wait_until(lambda: [child for child in children(process.pid) if reads(child, name)])[0]

    def open_for_writing(self, name):
        try:
            return os.open(self.folder / name, os.O_WRONLY | os.O_NONBLOCK)
        except OSError:
            return None


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
        result = self.run_program(self.names[0], *OUTPUTS, "--memory", "1M", status=4)
        self.assertRegex(result.stderr, "not enough memory")
        self.assertEqual(self.report("model 0")["status"], "OUT_OF_MEMORY")
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
                                   (["--memory", "-1"], "-1"), (["--resume"], "--json"), (["-0"], "--list"),
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

    @unittest.skipUnless(shutil.which("parallel"), "no GNU parallel")
    def test_killed_worker(self):
        """The recipe of the manual. A worker is killed half way, and a second run does what is left."""
        self.run_program(*self.names, *OUTPUTS)
        expected = self.files()
        shutil.rmtree(self.folder / "out")
        text = (self.folder / self.names[2]).read_text()
        self.make_pipe(self.names[2])
        (self.folder / "models.txt").write_text("\n".join(self.names))
        recipe = ["parallel", "--will-cite", "-j2", str(FLATTEN_MESH), *QUICK, "--list", "models.txt", "--shard",
                  "{}/2", *OUTPUTS, "--resume", "--quiet", ":::", "1", "2"]
        with subprocess.Popen(recipe, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            writer = wait_until(lambda: self.open_for_writing(self.names[2]))
            os.kill(self.worker("1/2"), signal.SIGKILL)
            process.wait(LIMIT)
            os.close(writer)
        self.assertNotEqual(process.returncode, 0)
        self.assertFalse((self.folder / "out/a/model 1.json").exists())
        done = {file: file.stat().st_mtime_ns for file in self.folder.glob("out/b/*.json")}
        self.assertEqual(len(done), 3)  # those of the other worker
        (self.folder / self.names[2]).unlink()
        (self.folder / self.names[2]).write_text(text)
        subprocess.run(recipe, cwd=self.folder, check=True, timeout=LIMIT, capture_output=True)
        self.assertEqual(self.files(), expected)
        subprocess.run(recipe, cwd=self.folder, check=True, timeout=LIMIT, capture_output=True)

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


class Summary(Folder):
    def test_summary(self):
        (self.folder / "in/a/bad,name.off").write_text("OFF\n")
        self.run_program(*self.names, "in/a/bad,name.off", *OUTPUTS, status=2)
        (self.folder / "out/other.json").write_text("{}")
        result = self.run_summary("--summary", "out")
        self.assertRegex(result.stderr, "other.json' is no report")
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
        self.run_summary("--summary", "in", status=2)
        self.run_summary("--summary", "absent", status=2)
        self.run_summary("--summary", "out", "--output", "table.obj", status=2)

    def run_summary(self, *arguments, status=0):
        result = subprocess.run([str(FLATTEN_MESH), *arguments], cwd=self.folder, capture_output=True, text=True,
                                check=False)
        self.assertEqual(result.returncode, status, result.stderr)
        return result


if __name__ == "__main__":
    unittest.main()
