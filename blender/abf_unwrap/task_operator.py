# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the operators have in common. The computation is in a thread, so that Blender shows its progress and Esc ends
it."""

from __future__ import annotations

from typing import Optional

import bpy
from bpy.props import EnumProperty, IntProperty

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

    uv_layer: EnumProperty(
        name="UV layer",
        items=[
            ("ACTIVE", "Active", "The active UV layer"),
            ("NEW", "New", "A new UV layer, which becomes the active one"),
        ],
    )

    def task(self) -> Task:
        raise NotImplementedError

    def begin(self, context: bpy.types.Context) -> bool:
        try:
            self.session = Session(context, self.task(), self.uv_layer == "NEW")
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


class PackingOptions:
    """The options of operators that pack."""

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

    def packing(self) -> Packing:
        return Packing(self.resolution, self.gutter)
