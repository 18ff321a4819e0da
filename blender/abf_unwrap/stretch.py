# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much a map changes the angles and the areas of faces, as numbers and as colours. Nothing here needs Blender."""

from __future__ import annotations

import numpy as np

# From little to much; the second map has white in its middle, for faces that keep their size.
ANGLE_COLOURS = np.array([[0.05, 0.15, 0.60], [0.10, 0.65, 0.60], [0.95, 0.85, 0.20], [0.85, 0.10, 0.10]])
AREA_COLOURS = np.array([[0.10, 0.25, 0.80], [0.95, 0.95, 0.95], [0.85, 0.10, 0.10]])
FLIPPED_COLOUR = np.array([1.0, 0.0, 1.0])


def triangle_frames(points: np.ndarray) -> np.ndarray:
    """Triangles (t, 3, 3) in planes of their own: the two edges from the first corner as columns of (t, 2, 2)."""
    first, second = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    length = np.linalg.norm(first, axis=1)
    along = np.einsum("ij,ij->i", first, second) / np.maximum(length, np.finfo(float).tiny)
    across = np.linalg.norm(np.cross(first, second), axis=1) / np.maximum(length, np.finfo(float).tiny)
    return np.stack([np.stack([length, along], 1), np.stack([np.zeros_like(length), across], 1)], 1)


def singular_values(vertices: np.ndarray, triangles: np.ndarray, uv: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The largest and the smallest stretch of each triangle (t, 3) of vertices, whose corners have the coordinates uv
    (t, 3, 2). The smallest is negative where the map is flipped; both are NaN for triangles without area."""
    frames = triangle_frames(np.asarray(vertices, float)[triangles])
    uv = np.asarray(uv, float)
    flat = np.stack([uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]], 2)
    determinants = frames[:, 0, 0] * frames[:, 1, 1]
    frames[~(determinants > 0)] = np.nan
    with np.errstate(invalid="ignore", divide="ignore"):
        inverses = np.zeros_like(frames)
        inverses[:, 0, 0] = 1 / frames[:, 0, 0]
        inverses[:, 0, 1] = -frames[:, 0, 1] / determinants
        inverses[:, 1, 1] = 1 / frames[:, 1, 1]
        jacobians = flat @ inverses
        turned = np.hypot(jacobians[:, 0, 0] + jacobians[:, 1, 1], jacobians[:, 1, 0] - jacobians[:, 0, 1])
        mirrored = np.hypot(jacobians[:, 0, 0] - jacobians[:, 1, 1], jacobians[:, 1, 0] + jacobians[:, 0, 1])
    return (turned + mirrored) / 2, (turned - mirrored) / 2


def face_stretches(
    vertices: np.ndarray,
    triangles: np.ndarray,
    uv: np.ndarray,
    triangle_faces: np.ndarray,
    number_of_faces: int,
    chosen: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For each face the quasi-conformal ratio (at least 1), the logarithm of its change of scale relative to all chosen
    faces, and whether it is flipped. Means over the triangles of a face are weighted by area. Faces without area have 1
    and 0."""
    largest, smallest = singular_values(vertices, triangles, uv)
    frames = triangle_frames(np.asarray(vertices, float)[triangles])
    area = np.abs(frames[:, 0, 0] * frames[:, 1, 1]) / 2
    flipped = smallest < 0
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(np.isnan(largest), 1, largest / np.abs(smallest))
    ratio = np.minimum(np.nan_to_num(ratio, nan=1, posinf=1e6), 1e6)
    flat_area = np.nan_to_num(np.abs(largest * smallest)) * area

    def sums(values: np.ndarray) -> np.ndarray:
        return np.bincount(triangle_faces, values, number_of_faces)

    face_area, face_flat_area = sums(area), sums(flat_area)
    total, total_flat = face_area[chosen].sum(), face_flat_area[chosen].sum()
    has_area = face_area > 0
    ratios = np.divide(sums(area * ratio), face_area, out=np.ones(number_of_faces), where=has_area)
    scales = np.zeros(number_of_faces)
    if total > 0 and total_flat > 0:
        relative = face_flat_area[has_area] / face_area[has_area] * (total / total_flat)
        scales[has_area] = np.log(np.maximum(relative, 1e-12)) / 2
    return ratios, scales, sums(flipped) > 0


def ramp(positions: np.ndarray, colours: np.ndarray) -> np.ndarray:
    """Colours (k, 3) at positions between 0 and 1, linear between those of the ramp."""
    places = np.linspace(0, 1, len(colours))
    return np.stack([np.interp(positions, places, colours[:, channel]) for channel in range(3)], 1)


def angle_colours(ratios: np.ndarray, largest: float) -> np.ndarray:
    """Colours of quasi-conformal ratios from 1 to the largest that is told apart, on a logarithmic scale."""
    return ramp(np.clip(np.log(ratios) / np.log(largest), 0, 1), ANGLE_COLOURS)


def area_colours(scales: np.ndarray, largest: float) -> np.ndarray:
    """Colours of logarithms of scales, between 1 / largest (blue, shrunk) and largest (red)."""
    return ramp(np.clip(scales / np.log(largest) / 2 + 0.5, 0, 1), AREA_COLOURS)
