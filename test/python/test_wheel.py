# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel, installed into a fresh environment. ABF_BUILD_FOLDER is where CMake has built the module."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
USES = """
import pathlib, angle_based_flattening as abf
folder = pathlib.Path(abf.__file__).parents[1]
atlas = abf.atlas([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2]])
assert atlas.report["atlas"]["injective"], atlas.report
maps = pathlib.Path("/proc/self/maps").read_text()
for library in (folder / "angle_based_flattening.libs").glob("*.so*"):
    print(library.name, str(library.resolve()) in maps)
print(abf.__version__, folder)
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    for module in ("setuptools", "wheel"):
        pytest.importorskip(module)
    if not os.environ.get("ABF_BUILD_FOLDER"):
        pytest.skip("ABF_BUILD_FOLDER is not set")
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run([sys.executable, ROOT / "python/build_backend.py", os.environ["ABF_BUILD_FOLDER"], folder],
                   check=True, capture_output=True)
    file, = folder.glob("*.whl")
    return file


def test_content(wheel):
    package = ROOT / "python/angle_based_flattening"
    with zipfile.ZipFile(wheel) as content:
        names = set(content.namelist())
        metadata = content.read(next(name for name in names if name.endswith("METADATA"))).decode()
    for file in [*package.glob("*.py"), *package.glob("*.pyi"), package / "py.typed"]:
        assert f"angle_based_flattening/{file.name}" in names
    for name in ("LICENSE.GPL", "THIRD_PARTY.md", "RECORD"):
        assert any(entry.split(".dist-info/")[-1] in (name, f"licenses/{name}") for entry in names), name
    assert any(name.startswith("angle_based_flattening.libs/libsuperlu.so") for name in names)
    assert not any(name.startswith("angle_based_flattening.libs/libc.so") for name in names)
    assert "License: GPL-3.0-or-later\n" in metadata and "Requires-Dist: numpy\n" in metadata


def test_fresh_environment(wheel, tmp_path):
    """The module runs with the libraries of the wheel, and without PYTHONPATH."""
    folder = tmp_path / "environment"
    if subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder], capture_output=True).returncode:
        pytest.skip("no module venv with pip")
    python = folder / "bin/python"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    install = [python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", wheel]
    subprocess.run(install, check=True, env=environment)
    done = subprocess.run([python, "-c", USES], env=environment, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    *libraries, last = done.stdout.splitlines()
    loaded = dict(line.split() for line in libraries)
    superlu, = (name for name in loaded if name.startswith("libsuperlu.so"))
    assert loaded[superlu] == "True", done.stdout
    version, place = last.split()
    assert f"-{version}-" in wheel.name and Path(place).is_relative_to(folder)
