# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A folder with models, in which the program runs. The program is $ABF_FLATTEN_MESH."""

import json
import os
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

FLATTEN_MESH = Path(os.environ["ABF_FLATTEN_MESH"]).resolve()
SCRIPT = Path(__file__).resolve().parents[3] / "examples/flatten_mesh/flatten_many.slurm"
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
