# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texel density: texels per unit of length on the surface. Nothing here needs Blender."""

from __future__ import annotations

import numpy as np

from .atlas_tasks import need_uv
from .islands import Island, islands_of
from .job import Progress
from .mesh_arrays import BadInput, MeshArrays, MeshResult, TaskResult


def density_of(mesh: MeshArrays, island: Island, areas: np.ndarray) -> float:
    """Of an island, in sides of the square per unit of length; areas are those of the mesh's faces."""
    area = areas[island.faces].sum()
    in_plane = np.abs(island.signed_areas(mesh.uv[island.corners].astype(float))).sum()
    return float(np.sqrt(in_plane / area)) if area > 0 else 0.0


def measured(meshes: list[MeshArrays], resolution: int, unit: float, progress: Progress) -> TaskResult:
    """The densities of islands, in texels per metre; a unit of length has so many metres."""
    need_uv(meshes)
    densities = [
        density_of(mesh, island, areas)
        for mesh, areas in ((mesh, mesh.areas()) for mesh in meshes if mesh.chosen.any())
        for island in islands_of(mesh, by_uv=True)
    ]
    if not densities:
        raise BadInput("No face is selected")
    least, middle, most = np.quantile(densities, [0, 0.5, 1]) * resolution / unit
    text = f"{middle:.4g} texels per metre in the median of {len(densities)} islands, from {least:.4g} to {most:.4g}"
    return TaskResult([MeshResult(None) for _ in meshes], text)


def set_density(
    meshes: list[MeshArrays], density: float, resolution: int, unit: float, progress: Progress
) -> TaskResult:
    """Scales each island about its centre, so that it has this density in texels per metre."""
    need_uv(meshes)
    results, number = [], 0
    for k, mesh in enumerate(meshes):
        uv = np.full((len(mesh.corner_vertices), 2), np.nan)
        areas = mesh.areas()
        for island in islands_of(mesh, by_uv=True) if mesh.chosen.any() else []:
            before = density_of(mesh, island, areas)
            if before == 0:
                raise BadInput(f"{mesh.name}: an island has no area at face {island.faces[0]}", [(k, island.faces)])
            old = mesh.uv[island.corners].astype(float)
            centre = (old.min(axis=0) + old.max(axis=0)) / 2
            uv[island.corners] = centre + (old - centre) * (density * unit / resolution / before)
            number += 1
        results.append(MeshResult(uv))
    if number == 0:
        raise BadInput("No face is selected")
    islands = f"{number} island{'s' if number != 1 else ''}"
    return TaskResult(results, f"Scaled {islands} to {density:.4g} texels per metre")
