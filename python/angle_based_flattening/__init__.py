"""Flattens triangulated surfaces with ABF++, and makes certified texture atlases of any mesh."""

from ._atlas import Atlas, atlas, parametrize
from ._errors import Cancelled, MeshError

__all__ = ["Atlas", "Cancelled", "MeshError", "atlas", "parametrize"]
