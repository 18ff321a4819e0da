# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The code of the manual prints what is written there, and the examples run."""

import contextlib
import importlib.util
import inspect
import io
import os
import re
import subprocess
import sys
from pathlib import Path

import angle_based_flattening as abf
import meshes
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


def test_example_of_an_atlas(tmp_path):
    needs("matplotlib")
    meshes.write_off(tmp_path / "sphere.off", *meshes.sphere(3))
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
