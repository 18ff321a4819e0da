"""Flattens triangulated surfaces with ABF++, and makes certified texture atlases of any mesh."""

from ._atlas import Atlas, atlas, parametrize
from ._charts import (Certificate, Flattener, Flattening, Packing, certify, flatten, hierarchical, lscm, measure,
                      pack)
from ._core import __version__
from ._errors import Cancelled, MeshError
from ._surfaces import Baked, Cones, Seams, bake, cones, seams
from ._unwrap import unwrap

__all__ = ["Atlas", "Baked", "Cancelled", "Certificate", "Cones", "Flattener", "Flattening", "MeshError", "Packing",
           "Seams", "__version__", "atlas", "bake", "certify", "cones", "flatten", "hierarchical", "lscm", "measure",
           "pack", "parametrize", "seams", "unwrap"]
