# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user is told when a task fails, and the faces to select. Nothing here needs Blender."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .mesh_arrays import BadInput

CANCELLED = "Cancelled: the coordinates are as before"


@dataclass
class Failure:
    message: str
    is_error: bool = True
    faces: list[tuple[int, np.ndarray]] = field(default_factory=list)  # the number of a mesh, and faces of it


def failure_of(error: BaseException) -> Failure:
    """Mistakes of the add-on itself are not hidden: they are raised again."""
    if isinstance(error, BadInput):
        return Failure(str(error), True, error.faces)
    if type(error).__name__ == "Cancelled":
        return Failure(CANCELLED, False)
    if isinstance(error, (ValueError, TimeoutError)):
        return Failure(str(error))
    if isinstance(error, MemoryError):
        return Failure("Not enough memory: the coordinates are as before")
    if isinstance(error, ImportError):
        return Failure(f"The Python module angle_based_flattening cannot be loaded: {error}")
    raise error
