# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The entries of the UV menus, and the panel in the sidebar of the UV editor."""

from __future__ import annotations

import bpy

from . import operators, show_stretch

OPERATORS = (*operators.CLASSES, *show_stretch.CLASSES)


def draw_operators(layout: bpy.types.UILayout) -> None:
    for operator in OPERATORS:
        layout.operator(operator.bl_idname)


def draw_menu(self: bpy.types.Menu, context: bpy.types.Context) -> None:
    self.layout.separator()
    draw_operators(self.layout)


class IMAGE_PT_abf_unwrap(bpy.types.Panel):
    bl_label = "ABF++"
    bl_category = "ABF++"
    bl_space_type = "IMAGE_EDITOR"
    bl_region_type = "UI"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.area.ui_type == "UV"

    def draw(self, context: bpy.types.Context) -> None:
        draw_operators(self.layout.column(align=True))


CLASSES = (*OPERATORS, IMAGE_PT_abf_unwrap)
MENUS = ("IMAGE_MT_uvs", "VIEW3D_MT_uv_map")  # of the UV editor, and of edit mode


def register() -> None:
    for each in CLASSES:
        bpy.utils.register_class(each)
    for menu in MENUS:
        getattr(bpy.types, menu).append(draw_menu)


def unregister() -> None:
    for menu in MENUS:
        getattr(bpy.types, menu).remove(draw_menu)
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
