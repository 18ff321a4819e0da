# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the Python module `angle_based_flattening`. Nothing here needs Blender."""

from __future__ import annotations

import importlib
import sys
import zipfile
from pathlib import Path
from types import ModuleType

NAME = "angle_based_flattening"


def unpacked_wheel(folder: Path) -> Path | None:
    """A folder with the module, unpacked from the wheel in the folder. Blender 4.2 and later do this themselves for
    extensions; earlier ones do not."""
    wheels = sorted(folder.glob(f"{NAME}-*.whl"))
    if not wheels:
        return None
    place = folder / wheels[-1].stem
    if not (place / NAME).is_dir():
        with zipfile.ZipFile(wheels[-1]) as wheel:
            wheel.extractall(place)
    return place


def load() -> ModuleType:
    """The module, from Python's path or from the wheel that comes with the add-on. ImportError says why there is
    none."""
    try:
        return importlib.import_module(NAME)
    except ModuleNotFoundError as error:
        place = unpacked_wheel(Path(__file__).parent / "wheels") if error.name == NAME else None
        if place is None:
            raise
    sys.path.append(str(place))
    importlib.invalidate_caches()
    return importlib.import_module(NAME)
