# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the meshes of all libraries have to keep."""

from pathlib import Path

import angle_based_flattening as abf
import numpy as np

FLOAT = 1e-6
ROOT = Path(__file__).resolve().parents[3]
PYPROJECT = next(file for file in (ROOT / "pyproject.toml", ROOT / "python/pyproject.toml") if file.exists())


def check(atlas, faces, points, old_points, new_points, new_indices, uv):
    """What all libraries have to keep: faces in their order, with the same points, and the coordinates of the atlas;
    and what they hold is injective. `faces` and `new_indices` are flat, but for triangles."""
    assert np.array_equal(np.asarray(new_points)[np.ravel(new_indices)], np.asarray(old_points)[np.ravel(points)])
    corners = np.asarray(uv, float)
    assert corners.shape == atlas.uv.shape and np.abs(corners - atlas.uv).max() < FLOAT
    assert corners.min() >= 0 and corners.max() <= 1
    assert abf.certify(old_points, faces, corners)
