# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operator that shows stretch as colours."""

from __future__ import annotations

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from .blender_mesh import mesh_objects, read_mesh, select_faces, selection_of, values, write_colours
from .mesh_arrays import BadInput, MeshArrays
from .stretch import FLIPPED_COLOUR, angle_colours, area_colours, face_stretches
from .task_operator import NeedsMesh

NAMES = {"ANGLE": "Angle stretch", "AREA": "Area stretch"}
NOT_CHOSEN = (0.3, 0.3, 0.3)


class UV_OT_abf_show_stretch(NeedsMesh, bpy.types.Operator):
    """Colour faces by how much the active UV layer changes their angles and areas"""

    bl_idname = "uv.abf_show_stretch"
    bl_label = "Show Stretch"
    bl_options = {"REGISTER", "UNDO"}

    measure: EnumProperty(
        name="Show",
        items=[
            ("ANGLE", "Angles", "From blue (kept) to red"),
            ("AREA", "Areas", "From blue (small) by white to red (large)"),
        ],
    )
    largest: FloatProperty(
        name="Largest", description="Stretch that has the last colour", default=2, min=1.01, soft_max=10
    )
    in_viewport: BoolProperty(name="In viewports", description="Let solid viewports show the colours", default=True)

    def execute(self, context: bpy.types.Context) -> set[str]:
        found, was_in_edit_mode = mesh_objects(context), context.mode == "EDIT_MESH"
        selection = selection_of(context)
        if was_in_edit_mode:
            bpy.ops.object.mode_set(mode="OBJECT")
        try:
            read = [read_mesh(each, selection) for each in found]
            for arrays in read:
                if arrays.uv is None:
                    raise BadInput(f"{arrays.name} has no UV layer: unwrap it first")
            flipped = sum(self.colour(each.data, arrays) for each, arrays in zip(found, read))
        except BadInput as error:
            for each, faces in error.faces:
                select_faces(each.data, faces)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            if was_in_edit_mode:
                bpy.ops.object.mode_set(mode="EDIT")
        if self.in_viewport:
            show_colours(context)
        if flipped:
            self.report({"WARNING"}, f"{flipped} faces are flipped (magenta)")
        return {"FINISHED"}

    def colour(self, mesh: bpy.types.Mesh, arrays: MeshArrays) -> int:
        """Writes both attributes, and returns the number of flipped faces."""
        mesh.calc_loop_triangles()
        corners = values(mesh.loop_triangles, "loops", np.int32, 3)
        ratios, scales, is_flipped = face_stretches(
            arrays.vertices,
            arrays.corner_vertices[corners],
            arrays.uv[corners],
            values(mesh.loop_triangles, "polygon_index", np.int32),
            arrays.number_of_faces,
            arrays.chosen,
        )
        colours = {"ANGLE": angle_colours(ratios, self.largest), "AREA": area_colours(scales, self.largest)}
        for measure in sorted(colours, key=lambda name: name == self.measure):  # the last one becomes the active one
            colours[measure][is_flipped] = FLIPPED_COLOUR
            colours[measure][~arrays.chosen] = NOT_CHOSEN
            write_colours(mesh, NAMES[measure], colours[measure])
        return int((is_flipped & arrays.chosen).sum())


def show_colours(context: bpy.types.Context) -> None:
    """Lets the solid viewports of the window show colour attributes."""
    for area in context.screen.areas if context.screen is not None else ():
        for space in area.spaces:
            if space.type == "VIEW_3D":
                space.shading.color_type = "VERTEX"


CLASSES = (UV_OT_abf_show_stretch,)
