# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the operators have in common. The computation is in a thread, so that Blender shows its progress and Esc ends
it."""

from __future__ import annotations

from typing import Any, Optional

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty

from .atlas_tasks import Packing
from .blender_mesh import mesh_objects
from .mesh_arrays import BadInput
from .session import Session, Task

INTERVAL = 0.05  # seconds between two looks at the computation


class NeedsMesh:
    """What cannot run without a mesh"""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        if context.mode in {"OBJECT", "EDIT_MESH"} and mesh_objects(context):
            return True
        cls.poll_message_set("Select a mesh, or edit one")
        return False


class TaskOperator(NeedsMesh):
    """Subclasses return the computation from task(), with the values of their options."""

    bl_options = {"REGISTER", "UNDO"}
    session: Optional[Session] = None
    timer: Optional[bpy.types.Timer] = None

    def task(self) -> Task:
        raise NotImplementedError

    def value(self, name: str) -> Any:
        """Of an option, or None if the operator does not have it."""
        return getattr(self, name, None)

    def unused(self) -> set[str]:
        """The options that have no effect with the values of others. The redo panel does not show them."""
        return set()

    def draw(self, context: bpy.types.Context) -> None:
        self.layout.use_property_split = True
        unused = self.unused() | {"rna_type"}
        for name in self.bl_rna.properties.keys():
            if name in type(self).option_names() - unused:
                self.layout.prop(self, name)

    @classmethod
    def option_names(cls) -> set[str]:
        return {name for each in cls.__mro__ for name in vars(each).get("__annotations__", {})} - {"session", "timer"}

    def begin(self, context: bpy.types.Context) -> bool:
        try:
            self.session = Session(context, self.task(), self.value("uv_layer") == "NEW")
        except BadInput as error:
            self.report({"ERROR"}, str(error))
            return False
        return True

    def execute(self, context: bpy.types.Context) -> set[str]:
        """At once: from scripts, and where the redo panel changes an option."""
        if not self.begin(context):
            return {"CANCELLED"}
        self.session.job.run()
        return self.session.finish(self.report)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if context.window is None or bpy.app.background:
            return self.execute(context)
        if not self.begin(context):
            return {"CANCELLED"}
        self.session.job.start()
        self.timer = context.window_manager.event_timer_add(INTERVAL, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        job = self.session.job
        if event.type == "ESC" and event.value == "PRESS":
            job.cancel()
        if event.type == "TIMER" and job.is_done:
            self.stop_looking(context)
            return self.session.finish(self.report)
        context.workspace.status_text_set(f"{self.bl_label}: {'cancelling' if job.is_cancelled else job.status()}")
        return {"RUNNING_MODAL"}

    def cancel(self, context: bpy.types.Context) -> None:
        """Blender ends the operator, as when another file is opened."""
        self.session.job.cancel()
        self.stop_looking(context)

    def stop_looking(self, context: bpy.types.Context) -> None:
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)


class LayerOption:
    """Where coordinates go."""

    uv_layer: EnumProperty(
        name="UV layer",
        items=[
            ("ACTIVE", "Active", "The active UV layer"),
            ("NEW", "New", "A new UV layer, which becomes the active one"),
        ],
    )


class DensityOption:
    """How many texels a metre has. The unit of length is that of the scene."""

    density: FloatProperty(
        name="Texels per metre",
        description="Texels per metre on the surface, in the scene's scale of units",
        default=512,
        min=1e-3,
        soft_max=16384,
    )


def metres_per_unit() -> float:
    return bpy.context.scene.unit_settings.scale_length


class PackingOptions(DensityOption, LayerOption):
    """The options of operators that pack."""

    pack_into: EnumProperty(
        name="Pack into",
        items=[
            ("SQUARE", "One tile", "The islands fill one square"),
            ("TILES", "UDIM tiles", "The islands take as many tiles as their texel density needs"),
        ],
    )

    resolution: IntProperty(
        name="Resolution",
        description="Texels along a side of the texture",
        default=1024,
        min=8,
        max=32768,
        soft_min=256,
    )
    gutter: IntProperty(
        name="Margin",
        description="Free texels between islands; 0 takes a 256th of the resolution",
        default=0,
        min=0,
        max=256,
    )

    def unused(self) -> set[str]:
        return {"density"} if self.value("pack_into") == "SQUARE" else set()

    def packing(self) -> Packing:
        in_tiles = self.value("pack_into") == "TILES"
        density = self.value("density") * metres_per_unit() if in_tiles else 0
        return Packing(self.value("resolution"), self.value("gutter"), density, self.value("block") or 1)
