# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples for Dask and Ray: with models that go wrong, workers that are killed, and a second run."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import angle_based_flattening as abf
import meshes
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples/Angle_based_flattening/python"
sys.path.append(str(EXAMPLES))
import mesh_files  # noqa: E402

COUNT, SECONDS, MEGABYTES = 30, 3, 700
TOOLS = {"distributed": ("atlases_of_folder.py", "KilledWorker"), "ray": ("atlases_of_folder_ray.py", "WorkerCrashedError")}


class Models:
    """A folder with small models, others that go wrong, and a pipe, at which a worker hangs"""

    def __init__(self, folder, script):
        self.script, self.models, self.out, self.expected = EXAMPLES / script, folder / "models", folder / "out", {}
        self.pipe = self.models / "pipe.off"
        self.models.mkdir()
        for k in range(COUNT):
            vertices, faces = meshes.hill(16, k)
            meshes.write_off(self.models / f"{k}.off", vertices, faces)
            mesh_files.write_obj(folder / "plain.obj", vertices, faces, abf.atlas(vertices, faces).uv)
            self.expected[f"{k}.obj"] = (folder / "plain.obj").read_text()
        meshes.write_off(self.models / "wrong.off", vertices, faces + 1)
        meshes.write_off(self.models / "slow.off", *meshes.torus(300, 200))
        meshes.write_off(self.models / "large.off", *meshes.hill(600))
        os.mkfifo(self.pipe)

    def run(self, at_reader):
        """What the script tells of each model. Calls the function for each worker that reads the pipe, when all other
        atlases are made."""
        command = [sys.executable, self.script, self.models, self.out, str(SECONDS), str(MEGABYTES)]
        with open(self.pipe, "r+b", buffering=0) as writer, \
                subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            seen, end = set(), time.monotonic() + 300
            while process.poll() is None:
                assert time.monotonic() < end
                if (reader := self.reader()) not in (None, *seen) and self.expected.keys() <= self.times().keys():
                    seen.add(reader)
                    at_reader(reader, writer)
                time.sleep(.05)
            output, errors = process.communicate()
        assert process.returncode == 0, errors
        return dict(re.findall(r"^(\w+\.off): (.*)$", output, re.M))  # Ray itself also prints

    def reader(self):
        for folder in Path("/proc").glob("[0-9]*/fd"):
            try:
                if folder.parent.name != str(os.getpid()) and \
                        any(os.readlink(file) == str(self.pipe) for file in folder.iterdir()):
                    return int(folder.parent.name)
            except OSError:  # has ended
                pass
        return None

    def atlases(self):
        return {file.name: file.read_text() for file in self.out.glob("*.obj")}

    def times(self):
        return {file.name: file.stat().st_mtime_ns for file in self.out.glob("*.obj")}


@pytest.mark.parametrize("tool", TOOLS)
def test_of_folder(tool, tmp_path):
    pytest.importorskip(tool)
    script, lost = TOOLS[tool]
    models = Models(tmp_path, script)

    told = models.run(lambda reader, _: os.kill(reader, signal.SIGKILL))
    assert told.pop("slow.off") == "TimeoutError: the computation took longer than the timeout"
    assert told.pop("large.off").startswith("MemoryError: ")
    assert told.pop("wrong.off") == "ValueError: faces[448, 2] is 256, but there are 256 vertices"
    assert told.pop("pipe.off") == lost
    # Dask asks again for results that only the killed worker had.
    assert len(told) == COUNT and all(result.endswith((" charts", "is there")) for result in told.values())
    assert models.atlases() == models.expected
    assert models.atlases() == models.expected

    # Again, with one worker that is killed. Nothing is done twice.
    for name in ("slow.off", "large.off", "wrong.off"):
        (models.models / name).unlink()
    text, times, killed = (models.models / "0.off").read_bytes(), models.times(), []

    def kill_once(reader, writer):
        if killed:
            writer.write(text)
            writer.close()
        else:
            os.kill(reader, signal.SIGKILL)
        killed.append(reader)

    told = models.run(kill_once)
    assert len(killed) == 2 and told.pop("pipe.off").endswith(" charts")
    assert len(told) == COUNT and set(told.values()) == {"is there"}
    assert models.atlases() == models.expected | {"pipe.obj": models.expected["0.obj"]}
    assert {name: models.times()[name] for name in times} == times


def test_hanging(tmp_path):
    """What has no timeout ends the worker."""
    os.mkfifo(tmp_path / "model.off")
    code = "import pathlib, one_model; one_model.make_atlas(pathlib.Path('model.off'), pathlib.Path('out.obj'), -4, 3000)"
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, timeout=60, check=False,
                          env=os.environ | {"PYTHONPATH": os.pathsep.join(map(str, [EXAMPLES, *sys.path]))})
    assert done.returncode == -signal.SIGALRM
