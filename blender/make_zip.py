# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the add-on as one zip file, which Blender 4.2 and later install as an extension and earlier ones as an add-on:
make_zip.py OUTPUT.zip [WHEEL...]. The wheels of the Python module, or those in folders, go inside: one for each
platform and version of Python."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path

SOURCES = Path(__file__).resolve().parent / "abf_unwrap"
LICENSE = SOURCES.parents[1] / "LICENSE.GPL"
PLATFORMS = {  # the end of a wheel's name: what Blender calls the platform
    "linux_x86_64": "linux-x64",
    "linux_aarch64": "linux-arm64",
    "win_amd64": "windows-x64",
    "win_arm64": "windows-arm64",
    "macosx_x86_64": "macos-x64",
    "macosx_arm64": "macos-arm64",
}


def platform_of(wheel: Path) -> str:
    """The platform of a wheel, such as that of x-1.0-cp311-cp311-manylinux_2_36_x86_64.whl."""
    tag = wheel.stem.split("-")[-1].split(".")[0].replace("many", "").replace("musl", "")
    system, machine = tag.split("_")[0], next(
        (each for each in ("x86_64", "aarch64", "arm64", "amd64") if tag.endswith(each)), ""
    )
    platform = PLATFORMS.get(f"{system}_{machine}")
    if platform is None:
        raise SystemExit(f"{wheel.name}: no platform that Blender knows")
    return platform


def manifest_with(wheels: list[Path]) -> str:
    text = (SOURCES / "blender_manifest.toml").read_text()
    if wheels:
        platforms = sorted({platform_of(wheel) for wheel in wheels})
        text += "platforms = [" + ", ".join(f'"{name}"' for name in platforms) + "]\n"
        text += "wheels = [" + ", ".join(f'"./wheels/{wheel.name}"' for wheel in wheels) + "]\n"
    return text


def write_zip(output: Path, wheels: list[Path]) -> None:
    """The same bytes from the same sources"""
    contents = {file.name: file.read_bytes() for file in SOURCES.glob("*.py")}
    contents["blender_manifest.toml"] = manifest_with(wheels).encode()
    contents["LICENSE"] = LICENSE.read_bytes()
    contents.update((f"wheels/{wheel.name}", wheel.read_bytes()) for wheel in wheels)
    with zipfile.ZipFile(output, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in sorted(contents.items()):
            entry = zipfile.ZipInfo(f"{SOURCES.name}/{name}")
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)


def wheels_of(path: Path) -> list[Path]:
    """A wheel, or those in a folder."""
    wheels = sorted(path.glob("*.whl")) if path.is_dir() else [path]
    if not wheels or not wheels[0].is_file():
        raise SystemExit(f"{path}: no wheel there")
    return wheels


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    write_zip(Path(sys.argv[1]), [wheel for path in sorted(sys.argv[2:]) for wheel in wheels_of(Path(path))])
