# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tasks read of a mesh, and what they give back, as NumPy arrays. Nothing here needs Blender."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional

import numpy as np


@dataclass
class MeshArrays:
    """A mesh of polygons. The corners of face f are those from offsets[f] to offsets[f + 1]."""

    name: str
    vertices: np.ndarray  # (n, 3)
    offsets: np.ndarray  # (m + 1,)
    corner_vertices: np.ndarray  # (c,)
    corner_edges: np.ndarray  # (c,): the edge from each corner to the next one of its face
    edges: np.ndarray  # (e, 2)
    seams: np.ndarray  # (e,) bool
    chosen: np.ndarray  # (m,) bool: the faces that take part
    uv: Optional[np.ndarray] = None  # (c, 2), or None without a UV layer
    pinned: Optional[np.ndarray] = None  # (c,) bool

    @property
    def polygons(self) -> tuple[np.ndarray, np.ndarray]:
        """The faces in the form that the module takes."""
        return self.offsets, self.corner_vertices

    @property
    def number_of_faces(self) -> int:
        return len(self.offsets) - 1

    def corner_faces(self) -> np.ndarray:
        """The face of each corner."""
        return np.repeat(np.arange(self.number_of_faces), np.diff(self.offsets))

    def next_corners(self) -> np.ndarray:
        """The corner after each one, around its face."""
        following = np.arange(1, len(self.corner_vertices) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        return following

    def areas(self) -> np.ndarray:
        """The areas of the faces. Those of polygons that are not planar are those of their shadows."""
        first = np.repeat(self.vertices[self.corner_vertices[self.offsets[:-1]]], np.diff(self.offsets), axis=0)
        here = self.vertices[self.corner_vertices].astype(float) - first
        return np.linalg.norm(np.add.reduceat(np.cross(here, here[self.next_corners()]), self.offsets[:-1]), axis=1) / 2

    def marked_seams(self) -> np.ndarray:
        """The seams as pairs of vertices."""
        return self.edges[self.seams]


@dataclass
class MeshResult:
    """What becomes of a mesh. Corners whose coordinates stay as they are have NaN."""

    uv: Optional[np.ndarray]  # (c, 2), or None if all stay
    seams: Optional[np.ndarray] = None  # (e,) bool, or None if they stay
    left_out: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int64))  # chosen faces without coordinates
    faulty: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int64))  # faces that flip or overlap
    selected: Optional[np.ndarray] = None  # the faces to select, or None if the selection stays


@dataclass
class TaskResult:
    """What becomes of all meshes of a call, and what to tell the user."""

    meshes: list[MeshResult]
    message: str
    notes: list[str] = field(default_factory=list)


class BadInput(Exception):
    """A mesh that a task cannot do, with the faces to select: pairs of the number of a mesh, or of its object if it
    could not be read, and the faces."""

    def __init__(self, message: str, faces: Optional[list[tuple[Any, np.ndarray]]] = None):
        super().__init__(message)
        self.faces = faces or []


def edge_flags(edges: np.ndarray, pairs: np.ndarray, number_of_vertices: int) -> np.ndarray:
    """A flag for each edge: whether it is one of the pairs of vertices, in either direction."""

    def keys(ends: np.ndarray) -> np.ndarray:
        ends = np.sort(np.asarray(ends, np.int64).reshape(-1, 2), axis=1)
        return ends[:, 0] * number_of_vertices + ends[:, 1]

    return np.isin(keys(edges), keys(pairs))
