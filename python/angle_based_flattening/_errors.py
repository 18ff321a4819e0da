"""The exceptions of the package."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


class MeshError(ValueError):
    """The mesh, or a map of it, is not what the function needs, or no map was found.

    Attributes:
        status: the name of the diagnosis, such as ``"NO_BORDER"``; the C++ reference explains each.
        message: a sentence that says what is wrong, and where. It counts faces and vertices from 1, as OBJ files do,
            and names vertices with their points: ``vertex 17 (0.1, nan, 3)``.
        faces: the faces that the diagnosis is about, from 0; an empty array if it is about none.
        vertices: the vertices that it is about, from 0; an empty array if it is about none.
        mesh: the number of the mesh that these belong to, from 0.
    """

    def __init__(self, status: str, message: str, faces: Sequence[int] | NDArray[Any] = (),
                 vertices: Sequence[int] | NDArray[Any] = (), mesh: int = 0) -> None:
        super().__init__(status, message, faces, vertices, mesh)
        self.status = status
        self.message = message
        self.faces: NDArray[np.int64] = np.asarray(faces, dtype=np.int64)
        self.vertices: NDArray[np.int64] = np.asarray(vertices, dtype=np.int64)
        self.mesh = mesh

    def __str__(self) -> str:
        return f"{self.status}: {self.message}"


class Cancelled(Exception):
    """A ``progress`` function returned ``False``."""
