# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel for this system, installed into a fresh environment. ABF_BUILD_FOLDER is where CMake has built the module,
and ABF_WHEEL_PYTHON has what packs it."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
USES = """
import pathlib, angle_based_flattening as abf
atlas = abf.atlas([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2]])
assert atlas.report["atlas"]["injective"], atlas.report
print(abf.__version__, pathlib.Path(abf.__file__).parents[1])
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    python = os.environ.get("ABF_WHEEL_PYTHON")
    if not python or not os.path.exists(python):
        pytest.skip("nothing that packs wheels is installed")
    folder = tmp_path_factory.mktemp("wheel")
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    subprocess.run([python, ROOT / "python/pack_wheel.py", os.environ["ABF_BUILD_FOLDER"], folder], check=True,
                   capture_output=True, env=environment)
    file, = folder.glob("*.whl")
    return file


def test_content(wheel):
    package = ROOT / "python/angle_based_flattening"
    with zipfile.ZipFile(wheel) as content:
        names = set(content.namelist())
        metadata = content.read(next(name for name in names if name.endswith("METADATA"))).decode()
    for name in [*(file.name for file in package.glob("*.py")), "py.typed", "libangle_based_flattening.so"]:
        assert f"angle_based_flattening/{name}" in names
    for name in ("LICENSE.GPL", "THIRD_PARTY.md"):
        assert any(entry.endswith(f".dist-info/licenses/{name}") or entry.endswith(f"/python/{name}")
                   for entry in names), name
    assert all(name.startswith(("angle_based_flattening/", "angle_based_flattening-")) for name in names), names
    assert "License-Expression: GPL-3.0-or-later\n" in metadata
    assert [line for line in metadata.splitlines() if line.startswith("Requires-Dist")] == ["Requires-Dist: numpy>=1.23"]


def test_fresh_environment(wheel, tmp_path):
    """The wheel installs, and runs without PYTHONPATH. It serves all versions of Python."""
    assert "-py3-none-" in wheel.name
    folder = tmp_path / "environment"
    if subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder], capture_output=True).returncode:
        pytest.skip("no module venv with pip")
    python = folder / "bin/python"
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    install = [python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", wheel]
    subprocess.run(install, check=True, env=environment)
    done = subprocess.run([python, "-c", USES], env=environment, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    version, place = done.stdout.split()
    assert f"-{version}-" in wheel.name and Path(place).is_relative_to(folder)
    done = subprocess.run([folder / "bin/flatten_mesh", "--version"], env=environment, capture_output=True, text=True)
    assert done.stdout == f"flatten_mesh {version}\n"
