# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the add-on as a user does, from the arguments of a script in Blender: -- ADD-ON [FOLDER]. The add-on is a
zip file, or the folder of its sources; then FOLDER has the Python module."""

import sys
from pathlib import Path

import bpy


def install():
    """Returns the Python module."""
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    addon = Path(arguments[0])
    if addon.suffix == ".zip":
        bpy.ops.preferences.addon_install(filepath=str(addon))
        bpy.ops.preferences.addon_enable(module="abf_unwrap")
    else:
        sys.path[:0] = [str(addon.parent), *arguments[1:2]]
        import abf_unwrap

        abf_unwrap.register()
    from abf_unwrap import module

    return module.load()
