# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes wheels for pip: by scikit-build-core if it is there, and otherwise by CMake and setuptools.

build_backend.py BUILD_FOLDER WHEEL_FOLDER makes the wheel of a module that CMake has built in BUILD_FOLDER."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parent
TARGET = "angle_based_flattening_core"
OTHER_PARTS = ("EXAMPLES", "TESTS")


def _version():
    text = (TOP / "CMakeLists.txt").read_text()
    return re.search(r"^project\(Angle_based_flattening VERSION ([\d.]+)", text, re.M)[1]


def _build(folder):
    """Compiles the module."""
    options = [f"-DABF_BUILD_{part}=OFF" for part in OTHER_PARTS]
    options += ["-DABF_BUILD_PYTHON=ON", "-DABF_INSTALL_CORE=OFF", f"-DPython3_EXECUTABLE={sys.executable}"]
    if importlib.util.find_spec("pybind11") is not None:
        import pybind11
        options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
    printed = subprocess.run(["cmake", "-S", TOP, "-B", folder, *options], check=True, stdout=subprocess.PIPE,
                             text=True).stdout
    if "the Python module is left out" in printed:
        sys.exit(f"{printed}\npybind11 2.10 and the headers of Python are needed, as of Debian's packages pybind11-dev "
                 "and python3-dev")
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "2")  # each takes up to 2 GB of memory
    subprocess.run(["cmake", "--build", folder, "--target", TARGET, "--parallel", jobs], check=True)


def _project(folder, libraries):
    """A project for setuptools in `folder`, of what CMake has installed there. Libraries are no part of it."""
    shutil.move(folder / "angle_based_flattening.libs", libraries)
    for name in ("pyproject.toml", "README.md", "THIRD_PARTY.md", "LICENSE.GPL"):
        shutil.copy(HERE / name, folder)
    (folder / "VERSION").write_text(_version())


def _pack_project(folder, wheel_folder):
    """The wheel that setuptools makes. It has compiled parts, which setuptools did not compile."""
    from setuptools import build_meta
    from setuptools.dist import Distribution
    Distribution.has_ext_modules = lambda self: True
    before = os.getcwd()
    os.chdir(folder)
    try:
        return wheel_folder / build_meta.build_wheel(str(wheel_folder))
    finally:
        os.chdir(before)


def pack(build_folder, wheel_folder):
    """Makes the wheel of a module that is compiled, and returns its name."""
    wheel_folder = Path(wheel_folder).resolve()
    wheel_folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        stage, libraries, unpacked = (Path(work) / name for name in ("stage", "libraries", "unpacked"))
        elsewhere = {name: value for name, value in os.environ.items() if name != "DESTDIR"}
        subprocess.run(["cmake", "--install", build_folder, "--component", "python", "--prefix", stage], check=True,
                       env=elsewhere)
        _project(stage, libraries)
        wheel = _pack_project(stage, Path(work))
        subprocess.run([sys.executable, "-m", "wheel", "unpack", "--dest", unpacked, wheel], check=True)
        content, = unpacked.iterdir()
        shutil.move(libraries, content / "angle_based_flattening.libs")
        subprocess.run([sys.executable, "-m", "wheel", "pack", "--dest-dir", wheel_folder, content], check=True)
        return wheel.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    if importlib.util.find_spec("scikit_build_core") is not None:
        from scikit_build_core import build
        return build.build_wheel(wheel_directory, config_settings, metadata_directory)
    folder = TOP / "build-wheel"
    _build(folder)
    return pack(folder, wheel_directory)


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("the module is built from the whole repository: make a wheel of it")


if __name__ == "__main__":
    print("written:", Path(sys.argv[2]) / pack(Path(sys.argv[1]), sys.argv[2]))
