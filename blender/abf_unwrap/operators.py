# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators. Each gathers its options, and leaves the rest to a task."""

from __future__ import annotations

import math

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from . import atlas_tasks, disk_tasks
from .session import Task
from .task_operator import PackingOptions, TaskOperator


class PurposeOption:
    """What the map is for, which decides between angles and areas"""

    purpose: EnumProperty(
        name="For",
        items=[
            ("texture", "Texture", "Little stretch"),
            ("few-charts", "Few islands", "Few islands with short seams"),
            ("conformal", "Angles", "Angles are kept, whatever becomes of areas"),
        ],
    )


class UV_OT_abf_unwrap(PurposeOption, PackingOptions, TaskOperator, bpy.types.Operator):
    """Unwrap the selected faces along their seams, without flips and overlaps, and pack the islands"""

    bl_idname = "uv.abf_unwrap"
    bl_label = "Unwrap (ABF++)"

    def task(self) -> Task:
        purpose, packing = self.purpose, self.packing()
        return lambda meshes, progress: atlas_tasks.unwrap(meshes, purpose, packing, progress)


class UV_OT_abf_auto_seams(PurposeOption, PackingOptions, TaskOperator, bpy.types.Operator):
    """Mark seams on the selected faces, unwrap along them, and pack the islands"""

    bl_idname = "uv.abf_auto_seams"
    bl_label = "Auto Seams and Unwrap"

    seams: EnumProperty(
        name="Seams",
        items=[
            ("auto", "Automatic", "As suits the purpose"),
            ("length", "Short", "As short as can be"),
            ("near-creases", "Prefer creases", "On creases where that is not much longer"),
            ("creases", "On creases", "Along all creases, and elsewhere where needed"),
            ("hidden", "Hide", "Where few directions see them"),
        ],
    )
    crease_angle: FloatProperty(
        name="Crease angle",
        description="Edges that bend more are creases, for seams on creases; 0 chooses the angle for the mesh",
        default=0,
        min=0,
        max=math.pi,
        subtype="ANGLE",
    )
    stretch_bound: FloatProperty(
        name="Stretch bound",
        description="Seams are added until the stretch is at most this; 1 is none, 0 takes the bound of the purpose",
        default=0,
        min=0,
        soft_max=2,
    )
    keep_marked: BoolProperty(
        name="Keep marked seams", description="Edges that are marked as seams stay seams", default=True
    )

    def task(self) -> Task:
        seams = self.seams
        if seams == "creases" and self.crease_angle > 0:
            seams = f"creases:{math.degrees(self.crease_angle):g}"
        choice = atlas_tasks.SeamChoice(self.purpose, seams, self.stretch_bound, self.keep_marked)
        packing = self.packing()
        return lambda meshes, progress: atlas_tasks.find_seams_and_unwrap(meshes, choice, packing, progress)


class UV_OT_abf_unfold(PackingOptions, TaskOperator, bpy.types.Operator):
    """Unwrap islands that flip or overlap again, so that they do neither, and pack all selected islands"""

    bl_idname = "uv.abf_unfold"
    bl_label = "Unfold Without Overlap"

    def task(self) -> Task:
        packing = self.packing()
        return lambda meshes, progress: atlas_tasks.unfold(meshes, packing, progress)


class UV_OT_abf_pack(PackingOptions, TaskOperator, bpy.types.Operator):
    """Pack the selected islands of all objects into one square, and prove that none overlap"""

    bl_idname = "uv.abf_pack"
    bl_label = "Pack (Certified)"

    def task(self) -> Task:
        packing = self.packing()
        return lambda meshes, progress: atlas_tasks.pack(meshes, packing, progress)


class UV_OT_abf_straighten(TaskOperator, bpy.types.Operator):
    """Make a rectangle of each selected island; four pinned vertices become its corners"""

    bl_idname = "uv.abf_straighten"
    bl_label = "Straighten to Rectangle"

    def task(self) -> Task:
        return disk_tasks.straighten


CLASSES = (UV_OT_abf_unwrap, UV_OT_abf_auto_seams, UV_OT_abf_unfold, UV_OT_abf_pack, UV_OT_abf_straighten)
