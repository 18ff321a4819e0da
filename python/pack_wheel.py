# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs what CMake has built into a wheel, and prints its name: pack_wheel.py BUILD_FOLDER WHEEL_FOLDER [PLATFORM].

The platform is that of this system, or another one that the library was compiled for."""

import os
import re
import subprocess
import sys
import tempfile
from contextlib import redirect_stdout
from pathlib import Path

from scikit_build_core.build import prepare_metadata_for_build_wheel

ROOT = Path(__file__).resolve().parents[1]


def pack(build: str, folder: Path, platform: str = "") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    environment = {name: value for name, value in os.environ.items() if name != "DESTDIR"}
    with tempfile.TemporaryDirectory() as work:
        content, packed = Path(work) / "content", Path(work) / "packed"
        packed.mkdir()
        subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", content], check=True,
                       env=environment, stdout=sys.stderr)
        os.chdir(ROOT)  # where the description of the project is
        info = content / prepare_metadata_for_build_wheel(str(content))
        if platform:
            text = (info / "WHEEL").read_text()
            (info / "WHEEL").write_text(re.sub("(?m)^Tag: .*$", f"Tag: py3-none-{platform}", text))
        subprocess.run([sys.executable, "-m", "wheel", "pack", "--dest-dir", packed, content], check=True,
                       stdout=sys.stderr)
        wheel, = packed.iterdir()
        (folder / wheel.name).write_bytes(wheel.read_bytes())
        return folder / wheel.name


if __name__ == "__main__":
    with redirect_stdout(sys.stderr):  # the standard output is for the name alone
        wheel = pack(os.path.abspath(sys.argv[1]), Path(sys.argv[2]).resolve(), *sys.argv[3:])
    print(wheel)
