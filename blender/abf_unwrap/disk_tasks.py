# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tasks that flatten islands one by one: into rectangles, and with pins. Nothing here needs Blender."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import module
from .islands import Island, islands_of
from .job import Progress, part_of
from .mesh_arrays import BadInput, MeshArrays, MeshResult, TaskResult


@dataclass
class PinnedIslands:
    """Islands that were unwrapped where their pins are."""

    faces: np.ndarray  # (m,) bool
    uv: np.ndarray  # (c, 2), NaN elsewhere
    number: int = 0
    faulty: list[np.ndarray] = field(default_factory=list)  # faces of islands that flip or overlap


def flatten_island(
    mesh: MeshArrays, number: int, island: Island, progress: Progress, **keywords: Any
) -> tuple[np.ndarray, bool]:
    """The coordinates of the island's vertices, and whether they neither flip nor overlap. Errors name faces of the
    mesh with this number."""
    abf = module.load()
    try:
        made = abf.flatten(island.vertices, island.polygons, progress=progress, **keywords)
    except abf.MeshError as error:
        at_vertices = np.isin(island.corner_vertices, error.vertices)
        of_corners = np.repeat(np.arange(len(island.faces)), np.diff(island.offsets))
        faces = np.union1d(error.faces, of_corners[at_vertices]).astype(np.int64)
        faces = island.faces[faces] if len(faces) else island.faces
        raise BadInput(f"{mesh.name}: {error.message}", [(number, faces)]) from error
    return np.array(made.uv, float), made.report["border_is_simple"] and made.report["flipped_triangles"] == 0


def pins_of(mesh: MeshArrays, island: Island) -> tuple[np.ndarray, np.ndarray]:
    """The pinned vertices of an island, and their coordinates."""
    if mesh.uv is None or mesh.pinned is None:
        return np.zeros(0, np.int64), np.zeros((0, 2))
    pinned_corners = mesh.pinned[island.corners] & np.isfinite(mesh.uv[island.corners]).all(axis=1)
    vertices, first = np.unique(island.corner_vertices[pinned_corners], return_index=True)
    return vertices, mesh.uv[island.corners[pinned_corners][first]].astype(float)


def flatten_pinned_islands(mesh: MeshArrays, number: int, progress: Progress) -> PinnedIslands:
    """Unwraps the islands between seams that have pins at two places or more."""
    done = PinnedIslands(np.zeros(mesh.number_of_faces, bool), np.full((len(mesh.corner_vertices), 2), np.nan))
    if mesh.uv is None or mesh.pinned is None or not mesh.pinned[mesh.chosen[mesh.corner_faces()]].any():
        return done
    pins = [(island, *pins_of(mesh, island)) for island in islands_of(mesh)]
    pins = [(island, vertices, places) for island, vertices, places in pins if len(np.unique(places, axis=0)) >= 2]
    for k, (island, vertices, places) in enumerate(pins):
        uv, is_injective = flatten_island(
            mesh, number, island, part_of(progress, k, len(pins)), pins=(vertices, places)
        )
        done.uv[island.corners] = uv[island.corner_vertices]
        done.faces[island.faces] = True
        done.faulty += [] if is_injective else [island.faces]
    done.number = len(pins)
    return done


def rectangle_of(mesh: MeshArrays, number: int, island: Island) -> dict[str, Any]:
    """What the module is told of a rectangle: its corners are four pinned vertices, or else the vertices with a single
    face if there are four. Otherwise corners are chosen so that the ratio of the sides is that of the island."""
    pinned, _ = pins_of(mesh, island)
    if len(pinned) not in (0, 4):
        raise BadInput(
            f"{mesh.name}: an island has {len(pinned)} pinned vertices; pin its four corners or none",
            [(number, island.faces)],
        )
    in_one_face = np.flatnonzero(np.bincount(island.corner_vertices) == 1)
    for corners in (pinned, in_one_face):
        if len(corners) == 4:
            return {"corners": corners}
    size = np.zeros(2) if mesh.uv is None else np.ptp(mesh.uv[island.corners].astype(float), axis=0)
    return {"aspect_ratio": size[0] / size[1] if size.min() > 0 else 1.0}


def straighten(meshes: list[MeshArrays], progress: Progress) -> TaskResult:
    """Makes each island a rectangle. It keeps its centre and its area in the plane."""
    tasks = [
        (k, mesh, island) for k, mesh in enumerate(meshes) for island in islands_of(mesh, by_uv=mesh.uv is not None)
    ]
    if not tasks:
        raise BadInput("No face is selected")
    results = [MeshResult(np.full((len(mesh.corner_vertices), 2), np.nan)) for mesh in meshes]
    for i, (k, mesh, island) in enumerate(tasks):
        uv, is_injective = flatten_island(
            mesh,
            k,
            island,
            part_of(progress, i, len(tasks)),
            boundary="rectangle",
            holes="refuse",
            **rectangle_of(mesh, k, island),
        )
        results[k].uv[island.corners] = in_place(mesh, island, uv)[island.corner_vertices]
        if not is_injective:
            results[k].faulty = np.union1d(results[k].faulty, island.faces)
    return TaskResult(results, f"Straightened {len(tasks)} island{'s' if len(tasks) != 1 else ''}")


def in_place(mesh: MeshArrays, island: Island, uv: np.ndarray) -> np.ndarray:
    """The coordinates of an island's vertices, with the area and the centre that the island had before. An island
    without area before fills the unit square."""
    size = np.ptp(uv, axis=0)
    uv = uv - uv.min(axis=0)
    before = 0.0 if mesh.uv is None else abs(island.signed_areas(mesh.uv[island.corners].astype(float)).sum())
    if before > 0:
        scale = np.sqrt(before / abs(island.signed_areas(uv[island.corner_vertices]).sum()))
        old = mesh.uv[island.corners]
        return uv * scale + (old.min(axis=0) + old.max(axis=0) - size * scale) / 2
    return uv / size.max()
