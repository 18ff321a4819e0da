# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Islands of a mesh: faces that are joined across edges. Nothing here needs Blender."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .mesh_arrays import MeshArrays

SAME_UV = 1e-5  # as near as Blender takes two coordinates for one vertex of an island


@dataclass
class Island:
    """Some faces of a mesh as a mesh of its own, cut open along the border of the island and along its seams."""

    faces: np.ndarray  # of the mesh
    corners: np.ndarray  # of the mesh, face by face
    vertices: np.ndarray  # (n, 3)
    offsets: np.ndarray
    corner_vertices: np.ndarray  # of the island's vertices, for each of its corners

    @property
    def polygons(self) -> tuple[np.ndarray, np.ndarray]:
        return self.offsets, self.corner_vertices

    def signed_areas(self, corner_uv: np.ndarray) -> np.ndarray:
        """The areas of the faces in the plane, of coordinates of the island's corners; negative for clockwise ones."""
        following = np.arange(1, len(corner_uv) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        # Relative to the first corner of each face, so that nothing cancels.
        first = np.repeat(corner_uv[self.offsets[:-1]], np.diff(self.offsets), axis=0)
        here, there = corner_uv - first, corner_uv[following] - first
        return np.add.reduceat(here[:, 0] * there[:, 1] - here[:, 1] * there[:, 0], self.offsets[:-1]) / 2


def component_labels(number: int, pairs: np.ndarray) -> np.ndarray:
    """The connected components of a graph: for each node the smallest node of its component."""
    labels = np.arange(number)
    while len(pairs):
        parents = np.arange(number)
        np.minimum.at(parents, pairs.max(axis=1), pairs.min(axis=1))
        while not np.array_equal(parents, roots := parents[parents]):
            parents = roots
        labels, pairs = parents[labels], parents[pairs]
        pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    return labels


def joined_corners(mesh: MeshArrays, by_uv: bool, tolerance: float = SAME_UV) -> np.ndarray:
    """Pairs of corners at one vertex of an island: on both sides of an edge between two chosen faces that is no seam,
    or by_uv, whose sides have the same coordinates."""
    following = mesh.next_corners()
    chosen = mesh.chosen[mesh.corner_faces()]
    corners = np.flatnonzero(chosen)
    corners = corners[np.argsort(mesh.corner_edges[corners], kind="stable")]
    edges, first, counts = np.unique(mesh.corner_edges[corners], return_index=True, return_counts=True)
    two = counts == 2
    if not by_uv:
        two &= ~mesh.seams[edges]
    one, other = corners[first[two]], corners[first[two] + 1]
    same_direction = mesh.corner_vertices[one] == mesh.corner_vertices[other]
    opposite = np.where(same_direction, other, following[other])
    opposite_of_next = np.where(same_direction, following[other], other)
    if by_uv:
        near = (np.abs(mesh.uv[one] - mesh.uv[opposite]).max(axis=1, initial=0) <= tolerance) & (
            np.abs(mesh.uv[following[one]] - mesh.uv[opposite_of_next]).max(axis=1, initial=0) <= tolerance
        )
        one, opposite, opposite_of_next = one[near], opposite[near], opposite_of_next[near]
    return np.concatenate([np.stack([one, opposite], 1), np.stack([following[one], opposite_of_next], 1)])


def islands_of(mesh: MeshArrays, by_uv: bool = False) -> list[Island]:
    """The islands of the chosen faces, in the order of their first faces."""
    joined = joined_corners(mesh, by_uv)
    corner_faces = mesh.corner_faces()
    corner_labels = component_labels(len(mesh.corner_vertices), joined)
    face_labels = component_labels(mesh.number_of_faces, np.unique(corner_faces[joined], axis=0))
    chosen = np.flatnonzero(mesh.chosen)
    order = chosen[np.argsort(face_labels[chosen], kind="stable")]
    borders = np.flatnonzero(np.diff(face_labels[order])) + 1
    return [island_of(mesh, faces, corner_labels) for faces in np.split(order, borders) if len(faces)]


def island_of(mesh: MeshArrays, faces: np.ndarray, corner_labels: np.ndarray) -> Island:
    """Faces as a mesh of its own, with a vertex for each label of their corners."""
    sizes = np.diff(mesh.offsets)[faces]
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    corners = np.repeat(mesh.offsets[faces] - offsets[:-1], sizes) + np.arange(offsets[-1])
    labels, corner_vertices = np.unique(corner_labels[corners], return_inverse=True)
    return Island(faces, corners, mesh.vertices[mesh.corner_vertices[labels]], offsets, corner_vertices)
