# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The code of the manual prints what is written there, and the examples run."""

import contextlib
import importlib.util
import inspect
import io
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import angle_based_flattening as abf
import meshes
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "doc/guides/python.txt"
EXAMPLES = ROOT / "examples/Angle_based_flattening/python"


def blocks(text):
    """Each piece of code with the lines that it prints."""
    found = re.findall(r"\\code\{\.py\}\n(.*?)\\endcode\n(?:\\code\{\.unparsed\}\n(.*?)\\endcode\n)?", text, re.S)
    return [(code, output.splitlines()) for code, output in found]


def same_line(printed, real):
    """Words alike, and numbers that differ by at most 2 %, as between machines."""
    number = r"[-+]?\d+(?:\.\d+)?"
    if re.sub(number, "#", printed) != re.sub(number, "#", real):
        return False
    pairs = zip(map(float, re.findall(number, printed)), map(float, re.findall(number, real)))
    return all(abs(a - b) <= .02 * max(abs(a), abs(b)) for a, b in pairs)


def run_page(text):
    """Runs the code of a page, and yields each piece, what it should print, and what it prints."""
    names = {}
    for code, expected in blocks(text):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, "python.txt", "exec"), names)
        yield code, expected, printed.getvalue().splitlines()


def needs(*modules):
    for module in modules:
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"no {module}")


def test_page(monkeypatch, tmp_path):
    needs("matplotlib")
    os.symlink(EXAMPLES.parent / "data", tmp_path / "data")
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    monkeypatch.syspath_prepend(str(EXAMPLES))
    pieces = list(run_page(PAGE.read_text()))
    assert len(pieces) > 8
    for code, expected, printed in pieces:
        assert len(expected) == len(printed) and all(map(same_line, expected, printed)), "\n".join([code, *printed])
    assert Path("python.png").read_bytes().startswith(b"\x89PNG")


def test_output_is_compared():
    page = ("\\code{.py}\nprint(1)\nprint('a')\n\\endcode\n\\code{.unparsed}\n1\na\n\\endcode\n"
            "\\code{.py}\n1\n\\endcode\n")
    assert [(expected, printed) for _, expected, printed in run_page(page)] == [(["1", "a"], ["1", "a"]), ([], [])]
    assert same_line("about 41.4 %", "about 41.5 %") and not same_line("about 41 %", "about 45 %")
    assert not same_line("a 1", "b 1")


def test_functions_of_the_page():
    """The page names each function and class, and nothing else of the module."""
    text = PAGE.read_text()
    named = set(re.findall(r"`(\w+)\(\)`", text)) | set(re.findall(r"abf\.(\w+)", text))
    results = {"Atlas", "Baked", "Certificate", "Cones", "Flattening", "Packing", "Seams", "__version__"}
    assert set(abf.__all__) - results - {"Cancelled"} <= named
    assert {name for name in re.findall(r"abf\.(\w+)", text)} <= set(abf.__all__)
    for name in set(abf.__all__) - {"__version__"}:
        assert inspect.getdoc(getattr(abf, name)), name


def test_interface():
    """_core.py calls the functions of interface.h with as many arguments as these have."""
    from angle_based_flattening import _core
    text = (ROOT / "python/src/interface.h").read_text()
    functions = re.findall(r"ABF_PYTHON_API [^;]*?abf_(\w+)\(([^;]*)\);", text)
    assert len(functions) > 15
    for name, parameters in functions:
        assert len(getattr(_core, f"_{name}").argtypes) == len([p for p in parameters.split(",") if p.strip()]), name


def run_example(folder, name, *words):
    command = [sys.executable, EXAMPLES / name, *map(str, words)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def write_off(file, vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0", *(" ".join(map(repr, p)) for p in vertices.tolist())]
    file.write_text("\n".join(lines + ["3 " + " ".join(map(str, f)) for f in faces.tolist()]) + "\n")


def test_example_of_an_atlas(tmp_path):
    needs("matplotlib")
    write_off(tmp_path / "sphere.off", *meshes.sphere(3))
    line, = run_example(tmp_path, "make_atlas.py", "sphere.off")
    assert re.fullmatch(r"512 faces, \d+ charts, \d\d% of the square covered", line)
    assert (tmp_path / "atlas.obj").read_text().count("\nvt ") == 3 * 512
    assert (tmp_path / "atlas.png").read_bytes().startswith(b"\x89PNG")
    assert run_example(tmp_path, "make_atlas.py", "atlas.obj", "again.obj") == [line]  # OBJ files are read, too
    assert (tmp_path / "again.obj").read_text() == (tmp_path / "atlas.obj").read_text()


def test_example_of_a_morph(tmp_path):
    lines = run_example(tmp_path, "flatten_morph.py")
    assert len(lines) == 6 and all("angles change by" in line for line in lines)


def test_example_of_other_libraries(tmp_path):
    lines = run_example(tmp_path, "other_libraries.py")
    assert [line.split(":")[0] for line in lines] == ["trimesh", "pyvista", "meshio", "open3d"]
    for line in lines:
        name = line.split(":")[0]
        assert ("skipped" in line) == (importlib.util.find_spec(name) is None)


def test_example_of_a_folder(tmp_path):
    needs("distributed")
    models, out = tmp_path / "models", tmp_path / "out"
    models.mkdir()
    out.mkdir()
    triangle = np.eye(3), np.array([[0, 1, 2]])
    for name in ("triangle", "done"):
        write_off(models / f"{name}.off", *triangle)
    (out / "done.obj").write_text("made before")
    write_off(models / "wrong.off", triangle[0], triangle[1] + 1)
    write_off(models / "slow.off", *meshes.torus(60, 40))

    def make(seconds):
        return dict(line.split(": ", 1) for line in run_example(tmp_path, "atlases_of_folder.py", models, out, seconds))

    first = make(1e-6)
    assert first["slow.off"].startswith("TimeoutError: ") and not (out / "slow.obj").exists()
    assert first["wrong.off"] == "ValueError: faces[0, 2] is 3, but there are 3 vertices"
    assert first["done.off"] == "is there" and (out / "done.obj").read_text() == "made before"
    (models / "slow.off").unlink()
    assert make(600)["triangle.off"] in ("1 charts", "is there")
    assert sorted(file.name for file in out.iterdir()) == ["done.obj", "triangle.obj"]


class Models:
    """A folder with six models and one for their atlases. At one of the models, whoever reads it hangs."""

    def __init__(self, folder, monkeypatch):
        monkeypatch.syspath_prepend(str(EXAMPLES))
        import mesh_files
        self.folder, self.models, self.out, self.expected = folder, folder / "models", folder / "out", {}
        self.models.mkdir()
        vertices, faces = meshes.torus(20, 15)
        for k in range(6):
            write_off(self.models / f"{k}.off", vertices * (1 + k), faces)
            file = folder / f"{k}.obj"
            mesh_files.write_obj(file, vertices * (1 + k), faces, abf.atlas(vertices * (1 + k), faces).uv)
            self.expected[file.name] = file.read_text()
        self.pipe = self.models / "3.off"
        self.text = self.pipe.read_text()
        self.pipe.unlink()
        os.mkfifo(self.pipe)

    def start(self, **environment):
        return subprocess.Popen([sys.executable, EXAMPLES / "atlases_of_folder.py", self.models, self.out],
                                cwd=self.folder, env={**os.environ, **environment}, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True, start_new_session=True)

    def atlases(self):
        return {file.name: file.read_text() for file in self.out.glob("*.obj")}

    def times(self):
        return {file.name: file.stat().st_mtime_ns for file in self.out.glob("*.obj")}

    def reader(self, process):
        """The worker of the program that hangs, half way"""
        end = time.monotonic() + 120
        while not (self.times() and (found := self.find_reader(process))):
            assert process.poll() is None and time.monotonic() < end
            time.sleep(.02)
        return found

    def find_reader(self, process):
        for number in Path("/proc").glob("[0-9]*"):
            try:
                if os.getpgid(int(number.name)) == process.pid:
                    if any(os.readlink(file) == str(self.pipe) for file in (number / "fd").iterdir()):
                        return int(number.name)
            except OSError:  # has ended, or is not ours
                pass
        return None


def test_example_of_a_folder_goes_on_without_a_worker(tmp_path, monkeypatch):
    needs("distributed")
    models = Models(tmp_path, monkeypatch)
    with models.start() as process:
        with open(models.pipe, "r+b", buffering=0) as writer:
            killed = models.reader(process)
            os.kill(killed, signal.SIGKILL)
            while models.reader(process) == killed:
                pass
            writer.write(models.text.encode())
        lines = process.communicate(timeout=300)[0].splitlines()
    assert process.returncode == 0 and len(lines) == 6
    assert all(line.endswith(("charts", "is there")) for line in lines)
    assert models.atlases() == models.expected


def test_example_of_a_folder_finishes_the_rest(tmp_path, monkeypatch):
    """A first run gives a model up because its worker was killed; a second run does only what is left."""
    needs("distributed")
    models = Models(tmp_path, monkeypatch)
    with models.start(DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES="0") as process:
        with open(models.pipe, "r+b", buffering=0):
            os.kill(models.reader(process), signal.SIGKILL)
            lines = process.communicate(timeout=300)[0].splitlines()
    assert process.returncode == 0 and len(lines) == 6 and "3.off: KilledWorker" in lines
    times = models.times()
    assert times and "3.obj" not in times
    models.pipe.unlink()
    models.pipe.write_text(models.text)
    told = dict(line.split(": ") for line in run_example(tmp_path, "atlases_of_folder.py", models.models, models.out))
    assert {name for name, result in told.items() if result == "is there"} == {f"{name[0]}.off" for name in times}
    assert models.atlases() == models.expected
    assert {name: models.times()[name] for name in times} == times
