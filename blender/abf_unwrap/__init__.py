# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Unwrapping with ABF++, seams, and certified atlases in Blender. Blender 4.2 and later
take it for an extension, and read blender_manifest.toml; earlier ones from 3.4 on read bl_info."""

bl_info = {
    "name": "Unwrap (ABF++)",
    "author": "The Angle_based_flattening authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "UV Editor > UV, and its sidebar; 3D Viewport > Edit Mode > UV",
    "description": "Unwraps with ABF++, finds seams, and packs certified atlases",
    "category": "UV",
}


def register() -> None:
    from . import menus  # here, so that programs without Blender can import the other modules

    menus.register()


def unregister() -> None:
    from . import menus

    menus.unregister()
