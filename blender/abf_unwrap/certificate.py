# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether coordinates flip or overlap, as the module's exact predicates say. Nothing here needs Blender."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from . import module
from .islands import component_labels, island_of, joined_corners
from .mesh_arrays import BadInput, MeshArrays


def flipped_and_overlapping(mesh: MeshArrays, number: int) -> tuple[np.ndarray, np.ndarray]:
    """The chosen faces that are flipped, and those that overlap others. A face without area counts as flipped.
    Errors name faces of the mesh with this number."""
    labels = component_labels(len(mesh.uv), joined_corners(mesh, by_uv=True, tolerance=0))
    whole = island_of(mesh, np.flatnonzero(mesh.chosen), labels)
    abf = module.load()
    try:
        certificate = abf.certify(whole.vertices, whole.polygons, mesh.uv[whole.corners].astype(float))
    except abf.MeshError as error:
        # The module names the edge where orientations differ by its vertices, and its faces only in the message.
        at_vertices = np.add.reduceat(np.isin(whole.corner_vertices, error.vertices).astype(int), whole.offsets[:-1])
        faces = whole.faces[at_vertices == len(error.vertices)]
        raise BadInput(f"{mesh.name}: {error.message}", [(number, faces)]) from error
    return whole.faces[certificate.flipped], whole.faces[certificate.overlapping]


def faults(mesh: MeshArrays, uv: np.ndarray, shown_uv: np.ndarray) -> np.ndarray:
    """The faces that are flipped or overlap others with the coordinates shown_uv. Faces are joined, and those of a
    surface with opposite orientations turned, as the coordinates uv have it. Faces without these do not count."""
    has_uv = ~np.isnan(uv[:, 0])
    mesh = replace(mesh, uv=uv, chosen=has_uv[mesh.offsets[:-1]])
    labels = component_labels(len(uv), joined_corners(mesh, by_uv=True, tolerance=0))
    whole = island_of(mesh, np.flatnonzero(mesh.chosen), labels)
    turned = np.flatnonzero(whole.signed_areas(uv[whole.corners]) < 0)
    order = np.arange(len(whole.corners))
    in_turned = np.repeat(np.isin(np.arange(len(whole.faces)), turned), np.diff(whole.offsets))
    ends = np.repeat(whole.offsets[:-1] + whole.offsets[1:] - 1, np.diff(whole.offsets))
    order[in_turned] = (ends - order)[in_turned]
    abf = module.load()
    try:
        certificate = abf.certify(
            whole.vertices, (whole.offsets, whole.corner_vertices[order]), shown_uv[whole.corners][order].astype(float)
        )
    except abf.MeshError as error:
        return whole.faces[error.faces] if len(error.faces) else whole.faces
    return whole.faces[np.union1d(certificate.flipped, certificate.overlapping).astype(np.int64)]


def faults_of_rounding(mesh: MeshArrays, uv: np.ndarray) -> np.ndarray:
    """The faces of a certified atlas that are flipped or overlap others in single precision, which Blender has. The
    module may have divided polygons that are not planar otherwise than here; those do not count."""
    found = faults(mesh, uv, uv.astype(np.float32))
    return np.setdiff1d(found, faults(mesh, uv, uv)) if len(found) else found
