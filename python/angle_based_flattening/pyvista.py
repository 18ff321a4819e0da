"""The accessor ``abf`` of PyVista's meshes: ``mesh.abf.unwrap()``.

PyVista finds it by itself where this package is installed; otherwise, ``import angle_based_flattening.pyvista``
registers it. It needs PyVista 0.48.
"""

from __future__ import annotations

from typing import Any

import pyvista

from ._atlas import Atlas, atlas
from ._unwrap import _taken, unwrap


@pyvista.register_dataset_accessor("abf", pyvista.PolyData)
class Accessor:
    """What `angle_based_flattening` does with a mesh of PyVista."""

    def __init__(self, mesh: pyvista.PolyData) -> None:
        self._mesh = mesh

    def unwrap(self, **options: Any) -> Any:
        """A new mesh with texture coordinates; see `angle_based_flattening.unwrap()`."""
        return unwrap(self._mesh, **options)

    def atlas(self, **options: Any) -> Atlas:
        """Its `Atlas`; see `angle_based_flattening.atlas()`."""
        taken = _taken(self._mesh)
        result: Atlas = atlas(taken.vertices, taken.faces, **options)
        return result
