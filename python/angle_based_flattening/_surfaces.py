"""Surfaces of any topology: seams, cones, and textures of fine surfaces."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core, _options
from ._charts import corner_coordinates, given_mesh

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Seams:
    """Seams that cut a surface to disks.

    Attributes:
        edges: (k, 2) int64, the edges, as vertices.
        report: the number of disks, the length of the seams, the predicted stretch.
    """

    edges: NDArray[np.int64]
    report: dict[str, Any]


@_options.takes("seams")
def seams(vertices: ArrayLike, faces: ArrayLike, *, along: str = "length", marked_seams: ArrayLike | None = None,
          **options: Any) -> Seams:
    """Chooses seams that cut a surface to disks with little stretch, as the C++ function ``select_seams()`` does.

    Args:
        vertices, faces: as of `atlas()`.
        along: what makes an edge cheap: ``"length"``, ``"creases"`` or ``"hidden"``.
        marked_seams: (k, 2) integers, edges that are seams in any case.
        OPTIONS
    """
    given, _ = given_mesh(vertices, faces, marked_seams)
    edges, text = _core.seams(given, _options.choice("along", along, ("length", "creases", "hidden")), options,
                              _options.watch())
    return Seams(edges, json.loads(text))


@dataclass(frozen=True)
class Cones:
    """Cones of a surface, and a map with them if one is wanted.

    Attributes:
        vertices: (k,) int64, the cones, in the order in which they were chosen.
        angles: (k,) float64, the sum of the planar angles around each, in radians.
        predicted_stretch: the stretch that the scale predicts for a map with these cones.
        uv: (c, 2) float64, the coordinates of each corner; None without a map.
        seams: (k, 2) int64, the edges of seams through the cones; None without a map.
    """

    vertices: NDArray[np.int64]
    angles: NDArray[np.float64]
    predicted_stretch: float
    uv: NDArray[np.float64] | None
    seams: NDArray[np.int64] | None


def cones(vertices: ArrayLike, faces: ArrayLike, number: int, *, angle_multiple: float = 0, flatten: bool = False,
          threads: int = 0, timeout: float | None = None, progress: _options.Progress | bool | None = None) -> Cones:
    """Chooses cones of a connected surface, and flattens it with seams through them on demand.

    Args:
        vertices, faces: as of `atlas()`.
        number: how many cones, at most 1000.
        angle_multiple: if not 0, angles are multiples of this angle, in radians; 2 pi must be a multiple of it.
        flatten: whether a map is made. Both sides of its seams differ by a rotation and a translation.
        threads: as of `atlas()`.
        timeout, progress: as of `atlas()`. They end the map, and not the choice of cones.
    """
    given, _ = given_mesh(vertices, faces)
    number = _options.integer("number", number, 0, 1000)
    angle_multiple = _options.number("angle_multiple", angle_multiple, 0, 2 * math.pi)
    flatten, threads = _options.switch("flatten", flatten), _options.integer("threads", threads, 0, 1024)
    with _options.watching(progress, timeout) as watch:
        stretch, (cone_vertices, angles, *of_map) = _core.cones(given, number, angle_multiple, flatten, threads, watch)
    return Cones(cone_vertices, angles, stretch, *(of_map if flatten else (None, None)))


@dataclass(frozen=True)
class Baked:
    """Textures of a simple surface that show a fine one. The first row is at the top, at v = 1.

    Attributes:
        normals: (h, w, 3) float32, vectors of length 1, in tangent space as in glTF unless asked otherwise.
        displacements: (h, w) float32, the distance to the fine surface along the normal.
        colors: (h, w, 3) float32 from 0 to 1; None if the fine surface has no colours.
        texels: (h, w) uint8, where values come from: 0 nowhere, 1 gutter, 2 front face, 3 back face, 4 closest point.
        report: how many texels there are of each kind, and distances.
    """

    normals: NDArray[np.float32]
    displacements: NDArray[np.float32]
    colors: NDArray[np.float32] | None
    texels: NDArray[np.uint8]
    report: dict[str, Any]


@_options.takes("baking")
def bake(vertices: ArrayLike, faces: ArrayLike, uv: ArrayLike, fine_vertices: ArrayLike, fine_faces: ArrayLike, *,
         fine_colors: ArrayLike | None = None, **options: Any) -> Baked:
    """Bakes the normals, the distance and the colours of a fine surface into textures of a simple one.

    Args:
        vertices, faces: the simple surface, as of `atlas()`.
        uv: its coordinates in the unit square, of each vertex or corner; faces with NaN are left out.
        fine_vertices, fine_faces: the fine surface, in the same place.
        fine_colors: (n, 3) uint8, a colour of each vertex of the fine surface.
        OPTIONS
    """
    given, _ = given_mesh(vertices, faces, uv=corner_coordinates(uv, vertices, faces))
    fine, _ = given_mesh(fine_vertices, fine_faces, mesh="the fine mesh")
    colors = None
    if fine_colors is not None:
        colors = np.asarray(fine_colors)
        n = len(np.asarray(fine_vertices))
        if colors.dtype != np.uint8 or colors.shape != (n, 3):
            raise ValueError(f"fine_colors is an array of {colors.dtype} with the shape {colors.shape}, and must be "
                             f"one of uint8 with the shape ({n}, 3)")
    normals, displacements, found_colors, texels, text = _core.bake(given, fine, colors, options,
                                                                    _options.watch())
    return Baked(normals, displacements, found_colors, texels, json.loads(text))
