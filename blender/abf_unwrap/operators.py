# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators. Each gathers its options, and leaves the rest to a task."""

from __future__ import annotations

import math
from typing import Any

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from . import atlas_tasks, density, disk_tasks, select_tasks
from .presets import PRESETS
from .session import Task
from .task_operator import DensityOption, LayerOption, PackingOptions, TaskOperator, metres_per_unit


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


PRESET_ITEMS = [("CUSTOM", "Custom", "The options below"), *((key, *PRESETS[key][:2]) for key in PRESETS)]


class PresetOption(PackingOptions):
    """A preset takes the place of the options that it sets."""

    preset: EnumProperty(name="Preset", items=PRESET_ITEMS)

    def value(self, name: str) -> Any:
        of_preset = {} if self.preset == "CUSTOM" else PRESETS[self.preset][2]
        return of_preset.get(name, super().value(name))

    def unused(self) -> set[str]:
        of_preset = set() if self.preset == "CUSTOM" else set(PRESETS[self.preset][2])
        return super().unused() | of_preset


class UV_OT_abf_unwrap(PurposeOption, PresetOption, TaskOperator, bpy.types.Operator):
    """Unwrap the selected faces along their seams, without flips and overlaps, and pack the islands"""

    bl_idname = "uv.abf_unwrap"
    bl_label = "Unwrap (ABF++)"

    def task(self) -> Task:
        purpose, packing = self.value("purpose"), self.packing()
        return lambda meshes, progress: atlas_tasks.unwrap(meshes, purpose, packing, progress)


class UV_OT_abf_auto_seams(PurposeOption, PresetOption, TaskOperator, bpy.types.Operator):
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
        seams = self.value("seams")
        if seams == "creases" and self.crease_angle > 0:
            seams = f"creases:{math.degrees(self.crease_angle):g}"
        choice = atlas_tasks.SeamChoice(
            self.value("purpose"), seams, self.value("stretch_bound"), self.keep_marked
        )
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


class UV_OT_abf_straighten(LayerOption, TaskOperator, bpy.types.Operator):
    """Make a rectangle of each selected island; four pinned vertices become its corners"""

    bl_idname = "uv.abf_straighten"
    bl_label = "Straighten to Rectangle"

    def task(self) -> Task:
        return disk_tasks.straighten


class ResolutionOption:
    """The texture that texels are those of"""

    resolution: IntProperty(
        name="Resolution", description="Texels along a side of the texture", default=1024, min=8, soft_max=32768
    )


class UV_OT_abf_show_density(ResolutionOption, TaskOperator, bpy.types.Operator):
    """Report the texel density of the selected islands"""

    bl_idname = "uv.abf_show_density"
    bl_label = "Show Texel Density"
    bl_options = {"REGISTER"}

    def task(self) -> Task:
        resolution, unit = self.resolution, metres_per_unit()
        return lambda meshes, progress: density.measured(meshes, resolution, unit, progress)


class UV_OT_abf_set_density(DensityOption, ResolutionOption, TaskOperator, bpy.types.Operator):
    """Scale each selected island about its centre to a texel density"""

    bl_idname = "uv.abf_set_density"
    bl_label = "Set Texel Density"

    def task(self) -> Task:
        wanted, resolution, unit = self.density, self.resolution, metres_per_unit()
        return lambda meshes, progress: density.set_density(meshes, wanted, resolution, unit, progress)


class UV_OT_abf_select_faults(TaskOperator, bpy.types.Operator):
    """Of the selected faces, keep those selected that overlap others, are flipped, or stretch"""

    bl_idname = "uv.abf_select_faults"
    bl_label = "Select Faulty Faces"

    what: EnumProperty(
        name="Select",
        options={"ENUM_FLAG"},
        default={"OVERLAPPING", "FLIPPED"},
        items=[
            ("OVERLAPPING", "Overlapping", "Faces that overlap others of their mesh"),
            ("FLIPPED", "Flipped", "Faces that are mirrored or have no area in the map"),
            ("STRETCHED", "Stretched", "Faces whose angles or areas stretch by more than the factor"),
        ],
    )
    largest: FloatProperty(
        name="Stretch factor", description="Faces that stretch more are selected", default=1.5, min=1.001, soft_max=10
    )

    def unused(self) -> set[str]:
        return set() if "STRETCHED" in self.what else {"largest"}

    def task(self) -> Task:
        what, largest = set(self.what), self.largest
        return lambda meshes, progress: select_tasks.select(meshes, what, largest, progress)


CLASSES = (
    UV_OT_abf_unwrap,
    UV_OT_abf_auto_seams,
    UV_OT_abf_unfold,
    UV_OT_abf_pack,
    UV_OT_abf_straighten,
    UV_OT_abf_show_density,
    UV_OT_abf_set_density,
    UV_OT_abf_select_faults,
)
