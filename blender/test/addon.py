# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs the add-on as a user does, from the arguments of a script in Blender: -- ADD-ON [FOLDER]. The add-on is a
zip file, or the folder of its sources; then FOLDER has the Python module."""

import sys
from pathlib import Path

import bpy

NAME = "abf_unwrap"


def install():
    """Returns the Python module."""
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    addon = Path(arguments[0])
    if addon.suffix != ".zip":
        sys.path[:0] = [str(addon.parent), *arguments[1:2]]
        import abf_unwrap

        abf_unwrap.register()
    elif bpy.app.version >= (4, 2):
        install_extension(addon)
    else:
        bpy.ops.preferences.addon_install(filepath=str(addon))
        bpy.ops.preferences.addon_enable(module=NAME)
    from abf_unwrap import module

    return module.load()


def install_extension(addon):
    """From 4.2 on, Blender gives the package a longer name. Tests import it by the short one."""
    bpy.ops.extensions.package_install_files(filepath=str(addon), repo="user_default", enable_on_install=True)
    package = f"bl_ext.user_default.{NAME}"
    if package not in bpy.context.preferences.addons:
        raise SystemExit(f"Blender {bpy.app.version_string} has not enabled {addon.name}")
    for name, loaded in list(sys.modules.items()):
        if name == package or name.startswith(package + "."):
            sys.modules[NAME + name[len(package) :]] = loaded
