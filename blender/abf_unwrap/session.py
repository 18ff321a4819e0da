# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of an operator on the meshes that the user works on: read, computed, written."""

from __future__ import annotations

from typing import Callable

import bpy
import numpy as np

from .blender_mesh import (
    can_have_layer,
    is_same_mesh,
    mesh_objects,
    read_mesh,
    select_faces,
    select_uv_faces,
    selection_of,
    writable_layer,
    write_result,
)
from .failures import CANCELLED, Failure, failure_of
from .job import Job, Progress
from .mesh_arrays import BadInput, MeshArrays, TaskResult

Task = Callable[[list[MeshArrays], Progress], TaskResult]


def listed(faces: np.ndarray) -> str:
    """The first faces, and how many there are."""
    return ", ".join(map(str, faces[:5])) + (f", ... ({len(faces)})" if len(faces) > 5 else "")


class Session:
    """The meshes are read when it begins. Object mode lasts from then to its end, for edit mode has its own copy of
    them."""

    def __init__(self, context: bpy.types.Context, task: Task, makes_new_layer: bool = False):
        self.makes_new_layer = makes_new_layer
        self.selection = selection_of(context)
        self.was_in_edit_mode = context.mode == "EDIT_MESH"
        self.objects: list[str] = []
        self.meshes: list[MeshArrays] = []
        found = mesh_objects(context)
        if self.was_in_edit_mode:
            bpy.ops.object.mode_set(mode="OBJECT")
        try:
            if not found:
                raise BadInput("No mesh is selected")
            self.objects = [each.name for each in found]
            self.meshes = [read_mesh(each, self.selection) for each in found]
            if not any(arrays.chosen.any() for arrays in self.meshes):
                raise BadInput("No face is selected" + (" in the UV editor" if self.selection == "UV" else ""))
        except BadInput as error:
            for each, faces in error.faces:
                select_faces(each.data, faces)
            self.leave()
            raise
        except BaseException:
            self.leave()
            raise
        self.job = Job(lambda progress: task(self.meshes, progress))

    def leave(self) -> None:
        """Returns to the mode of the beginning."""
        if self.was_in_edit_mode:
            bpy.ops.object.mode_set(mode="EDIT")

    def finish(self, report: Callable[[set[str], str], None]) -> set[str]:
        """Writes what the job found, or selects the faces that it failed on. Returns what the operator returns."""
        try:
            if self.job.is_cancelled:
                report({"INFO"}, CANCELLED)
                return {"CANCELLED"}
            if self.job.error is not None:
                return self.tell(failure_of(self.job.error), report)
            try:
                self.write()
            except BadInput as error:
                return self.tell(failure_of(error), report)
        finally:
            self.leave()
        for arrays, result in zip(self.meshes, self.job.result.meshes):
            if len(result.left_out):
                report(
                    {"WARNING"}, f"{arrays.name}: faces without a map keep their coordinates: {listed(result.left_out)}"
                )
            if len(result.faulty):
                report({"WARNING"}, f"{arrays.name}: faces flip or overlap: {listed(result.faulty)}")
        for note in self.job.result.notes:
            report({"WARNING"}, note)
        report({"INFO"}, self.job.result.message)
        return {"FINISHED"}

    def found_objects(self) -> list[bpy.types.Object]:
        found = [bpy.data.objects.get(name) for name in self.objects]
        if not all(is_same_mesh(each, arrays) for each, arrays in zip(found, self.meshes)):
            raise BadInput("A mesh was changed meanwhile: nothing was written")
        return found

    def write(self) -> None:
        """All meshes, or none of them"""
        found = self.found_objects()
        for each in found:
            if not can_have_layer(each.data, self.makes_new_layer):
                raise BadInput(f"{each.name} cannot have another UV layer")
        for each, result in zip(found, self.job.result.meshes):
            if result.selected is not None:
                (select_uv_faces if self.selection == "UV" else select_faces)(each.data, result.selected)
            if result.uv is not None:
                write_result(each.data, writable_layer(each.data, self.makes_new_layer), result)

    def tell(self, failure: Failure, report: Callable[[set[str], str], None]) -> set[str]:
        for number, faces in failure.faces:
            found = bpy.data.objects.get(self.objects[number])
            if is_same_mesh(found, self.meshes[number]):
                select_faces(found.data, faces)
        report({"ERROR"} if failure.is_error else {"INFO"}, failure.message)
        return {"FINISHED"} if failure.faces else {"CANCELLED"}  # a selection can be undone
