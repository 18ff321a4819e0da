# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The task that selects faces by what is wrong with their coordinates. Nothing here needs Blender."""

from __future__ import annotations

import numpy as np

from .atlas_tasks import need_uv
from .certificate import flipped_and_overlapping
from .job import Progress
from .mesh_arrays import BadInput, MeshArrays, MeshResult, TaskResult
from .stretch import face_stretches


def fans(mesh: MeshArrays) -> tuple[np.ndarray, np.ndarray]:
    """The corners (t, 3) and the faces (t,) of triangles that divide each face from its first corner."""
    sizes = np.diff(mesh.offsets)
    faces = np.repeat(np.arange(mesh.number_of_faces), sizes - 2)
    firsts = mesh.offsets[faces]
    places = np.arange(len(faces)) - np.repeat(np.cumsum(sizes - 2) - (sizes - 2), sizes - 2)
    return np.stack([firsts, firsts + places + 1, firsts + places + 2], 1), faces


def stretched_faces(mesh: MeshArrays, largest: float) -> np.ndarray:
    """The chosen faces whose angles or areas stretch by more than this factor."""
    corners, faces = fans(mesh)
    ratios, scales, _ = face_stretches(
        mesh.vertices, mesh.corner_vertices[corners], mesh.uv[corners], faces, mesh.number_of_faces, mesh.chosen
    )
    return np.flatnonzero(mesh.chosen & ((ratios > largest) | (np.abs(scales) > np.log(largest))))


def select(meshes: list[MeshArrays], what: set[str], largest: float, progress: Progress) -> TaskResult:
    """What has OVERLAPPING, FLIPPED and STRETCHED, or some of them."""
    need_uv(meshes)
    if not any(mesh.chosen.any() for mesh in meshes):
        raise BadInput("No face is selected")
    results, counts = [], dict.fromkeys(("OVERLAPPING", "FLIPPED", "STRETCHED"), 0)
    for number, mesh in enumerate(meshes):
        found = {}
        if mesh.chosen.any() and what & {"FLIPPED", "OVERLAPPING"}:
            found["FLIPPED"], found["OVERLAPPING"] = flipped_and_overlapping(mesh, number)
        if mesh.chosen.any() and "STRETCHED" in what:
            found["STRETCHED"] = stretched_faces(mesh, largest)
        found = {name: faces for name, faces in found.items() if name in what}
        for name, faces in found.items():
            counts[name] += len(faces)
        empty = np.zeros(0, np.int64)
        results.append(MeshResult(None, selected=np.unique(np.concatenate([empty, *found.values()]))))
    text = ", ".join(f"{count} {name.lower()}" for name, count in counts.items() if name in what)
    return TaskResult(results, f"Selected faces: {text}")
