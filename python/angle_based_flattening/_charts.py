"""Single charts: disks, and how good their maps are."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arrays, _core, _options

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

@dataclass(frozen=True)
class Flattening:
    """The map of a disk.

    Attributes:
        uv: (n, 2) float64, the coordinates of each vertex; NaN for vertices that are not in the chart.
        report: how the map was made.
    """

    uv: NDArray[np.float64]
    report: dict[str, Any]


@dataclass(frozen=True)
class Certificate:
    """Whether a map is injective, by exact predicates. It is true if the map is.

    Attributes:
        is_injective: whether no two points of the surface have the same image, and no triangle is flipped.
        flipped: the faces that are not positively oriented.
        overlapping: the faces that overlap others of their chart.
    """

    is_injective: bool
    flipped: NDArray[np.int64]
    overlapping: NDArray[np.int64]

    def __bool__(self) -> bool:
        return self.is_injective


def given_mesh(vertices: ArrayLike, faces: ArrayLike, marked_seams: ArrayLike | None = None,
               uv: _arrays.Array | None = None, mesh: str = "") -> tuple[_core.GivenMesh, _arrays.Array]:
    """A mesh as the compiled part takes it, and the indices of its faces."""
    vertices = _arrays.numbers(vertices, _arrays.name_of("vertices", mesh), 3)
    offsets, indices = _arrays.polygons(faces, mesh)
    _arrays.check_not_empty(offsets, indices, mesh)
    if marked_seams is not None:
        marked_seams = _arrays.integers(marked_seams, "marked_seams", 2)
    return _core.GivenMesh(vertices, offsets, indices, marked_seams, uv, None), indices


def corner_coordinates(uv: ArrayLike, vertices: ArrayLike, faces: ArrayLike) -> _arrays.Array:
    """Coordinates of each corner, of those of each vertex or corner."""
    coordinates = _arrays.numbers(uv, "uv", 2)
    indices = _arrays.polygons(faces)[1].reshape(-1)
    if len(coordinates) == len(indices):
        return coordinates
    n = len(np.asarray(vertices))
    if len(coordinates) != n:
        raise ValueError(f"uv has {len(coordinates)} rows, and must have one for each of the {n} vertices or of the "
                         f"{len(indices)} corners")
    if indices.size > 0 and (indices.min() < 0 or indices.max() >= n):
        return np.zeros((len(indices), 2))  # the compiled part names the wrong index
    of_corners: _arrays.Array = coordinates[indices]
    return of_corners


def _values_of_vertices(given: tuple[ArrayLike, ArrayLike] | None, what: str,
                        columns: int) -> tuple[_arrays.Array, _arrays.Array] | None:
    if given is None:
        return None
    vertices = _arrays.integers(given[0], f"the vertices of {what}", None)
    values = np.asarray(given[1], dtype=np.float64)
    shape = (len(vertices),) if columns == 1 else (len(vertices), columns)
    if values.shape != shape:
        raise ValueError(f"the values of {what} have the shape {values.shape}, and must have the shape {shape}")
    if not np.isfinite(values).all():
        raise ValueError(f"the values of {what} must be finite")
    if vertices.size > 0 and vertices.min() < 0:
        raise ValueError(f"the vertices of {what} must be at least 0")
    return vertices, values


class Flattener:
    """Flattens a mesh, and flattens it again when its vertices have moved.

    A call after the first one reuses what depends on the faces only. Each thread needs a `Flattener` of its own.

    Args:
        faces: (m, 3) integers, or a tuple (offsets, indices), as of `atlas()`.
        method: ``"direct"``, or ``"hierarchical"`` for large meshes.
        boundary: ``"free"``, or ``"rectangle"``: the border becomes a rectangle (direct method).
        corners: four vertices of the border, the corners of the rectangle.
        aspect_ratio: the ratio of the sides of the rectangle, if its corners are to be chosen. The map meets it
            approximately: scale a column of `uv` for the exact ratio.
        angles: a pair (vertices, radians): the sums of planar angles at some vertices (direct method).
        pins: a pair (vertices, positions (k, 2)) of vertices with given places (direct method).
        options: those of `flatten()`.
    """

    def __init__(self, faces: ArrayLike, *, method: str = "direct", boundary: str = "free",
                 corners: ArrayLike | None = None, aspect_ratio: float | None = None,
                 angles: tuple[ArrayLike, ArrayLike] | None = None,
                 pins: tuple[ArrayLike, ArrayLike] | None = None, **options: Any) -> None:
        _options.choice("method", method, ("direct", "hierarchical"))
        _options.choice("boundary", boundary, ("free", "rectangle"))
        if method == "hierarchical" and (boundary != "free" or angles is not None or pins is not None):
            raise ValueError('boundary, angles and pins need method="direct"')
        if boundary == "rectangle" and (corners is None) == (aspect_ratio is None):
            raise ValueError("a rectangle needs either corners or aspect_ratio")
        if boundary == "free" and (corners is not None or aspect_ratio is not None):
            raise ValueError('corners and aspect_ratio need boundary="rectangle"')
        if boundary == "rectangle" and angles is not None:
            raise ValueError('angles need boundary="free": a rectangle has its own')
        if corners is not None:
            corners = _arrays.integers(corners, "corners", None)
            if len(corners) != 4 or corners.min() < 0:
                raise ValueError(f"corners are {corners.tolist()}, and must be four vertices")
        ratio = 0.0 if aspect_ratio is None else _options.number("aspect_ratio", aspect_ratio, 0, open_below=True)
        given, _ = given_mesh(np.zeros((0, 3)), faces)
        self._flattener = _core.Flattener(given, method == "hierarchical", options, corners, ratio,
                                          _values_of_vertices(angles, "angles", 1),
                                          _values_of_vertices(pins, "pins", 2))

    def solve(self, vertices: ArrayLike, *, timeout: float | None = None,
              progress: _options.Progress | bool | None = None) -> Flattening:
        """Flattens the mesh with these vertices.

        Args:
            vertices: (n, 3) float32 or float64, as many in each call.
            timeout, progress: as of `atlas()`.

        Raises:
            MeshError: the mesh is not a disk, or no valid map was found.
        """
        vertices = _arrays.numbers(vertices, "vertices", 3)
        with _options.watching(progress, timeout) as watch:
            uv, text = self._flattener.solve(vertices, watch)
        return Flattening(uv, json.loads(text))


@_options.takes("direct", "hierarchical")
def flatten(vertices: ArrayLike, faces: ArrayLike, *, timeout: float | None = None,
            progress: _options.Progress | bool | None = None, **options: Any) -> Flattening:
    """Flattens a disk with ABF++. If the surface has several components, the one with the longest border is mapped.

    Args:
        vertices: (n, 3) float32 or float64.
        faces: (m, 3) integers, or a tuple (offsets, indices), as of `atlas()`.
        timeout, progress: as of `atlas()`.
        options: those of `Flattener`, and of its method:
        OPTIONS

    Raises:
        ValueError: an option or an array is wrong; the message names it.
        MeshError: the surface is closed, not a manifold, or not a disk; or no valid map was found.

    >>> import angle_based_flattening as abf
    >>> import numpy as np
    >>> vertices = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]])
    >>> faces = np.array([[0, 1, 2], [0, 2, 3]])
    >>> uv = abf.flatten(vertices, faces).uv
    >>> lengths = np.linalg.norm(uv[[1, 2]] - uv[[0, 1]], axis=1)
    >>> print(f"{lengths[0] / lengths[1]:.3f}")
    2.000
    """
    return Flattener(faces, **options).solve(vertices, timeout=timeout, progress=progress)


def hierarchical(vertices: ArrayLike, faces: ArrayLike, **options: Any) -> Flattening:
    """Flattens a disk with hierarchical ABF++: `flatten()` with ``method="hierarchical"``."""
    return flatten(vertices, faces, method="hierarchical", **options)


def lscm(vertices: ArrayLike, faces: ArrayLike) -> Flattening:
    """Flattens a disk with CGAL's least squares conformal maps, for comparison. Triangles may be flipped."""
    given, _ = given_mesh(vertices, faces)
    uv, text = _core.lscm(given, _options.watch())
    return Flattening(uv, json.loads(text))


def measure(vertices: ArrayLike, faces: ArrayLike, uv: ArrayLike) -> dict[str, Any]:
    """The distortion of a map, of one chart or of many.

    Args:
        vertices, faces: as of `flatten()`.
        uv: (n, 2), the coordinates of each vertex, or (c, 2), of each corner.

    Returns:
        The members of the C++ struct ``Flattening_measures``; angles are in radians. Infinity is ``None``.

    >>> import angle_based_flattening as abf
    >>> vertices, faces = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]
    >>> abf.measure(vertices, faces, [[0, 0], [3, 0], [0, 3]])["mean_angle_change"] < 1e-9
    True
    """
    uv = corner_coordinates(uv, vertices, faces)
    given, _ = given_mesh(vertices, faces, uv=uv)
    measures: dict[str, Any] = json.loads(_core.measure(given, _options.watch()))
    return measures


def certify(vertices: ArrayLike, faces: ArrayLike, uv: ArrayLike) -> Certificate:
    """Checks with exact predicates whether a map is injective; see `measure()` for the arguments.

    >>> import angle_based_flattening as abf
    >>> vertices, faces = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]
    >>> bool(abf.certify(vertices, faces, [[0, 0], [1, 0], [0, 1]]))
    True
    >>> abf.certify(vertices, faces, [[0, 0], [0, 1], [1, 0]]).flipped.tolist()
    [0]
    """
    uv = corner_coordinates(uv, vertices, faces)
    given, _ = given_mesh(vertices, faces, uv=uv)
    is_injective, flipped, overlapping = _core.certify(given, _options.watch())
    return Certificate(is_injective, flipped, overlapping)


@dataclass(frozen=True)
class Packing:
    """Packed charts.

    Attributes:
        uv: for each chart, (k, 2) float64, the new coordinates of its vertices.
        report: pages, the page and the relative scale of each chart, the share that charts cover, texels per unit, and
            the faces with a corner that found no place on the grid of `quantization_bits`, counted from 0 through all
            charts.
    """

    uv: list[NDArray[np.float64]]
    report: dict[str, Any]


@_options.takes("packing")
def pack(charts: Sequence[tuple[ArrayLike, ...]], **options: Any) -> Packing:
    """Packs charts into a page, or into as many as they take, at one density of texels.

    Args:
        charts: tuples (faces (m, 3), uv (k, 2)), or (faces, uv, vertices (k, 3)): with vertices, a chart gets as many
            texels as its area on the surface asks for, otherwise in the plane.
        OPTIONS

    Raises:
        MeshError: there is no chart, a chart has no area, or the pages cannot hold it.

    >>> import angle_based_flattening as abf
    >>> triangle = [[0, 1, 2]], [[0, 0], [1, 0], [0, 1]]
    >>> packing = abf.pack([triangle, triangle], resolution=64)
    >>> len(packing.uv), packing.report["pages"]
    (2, 1)
    """
    all_faces: list[_arrays.Array] = []
    all_uv: list[_arrays.Array] = []
    all_vertices: list[_arrays.Array] = []
    first_faces, first_vertices = [], [0]
    for i, chart in enumerate(charts):
        faces = _arrays.integers(chart[0], f"faces of chart {i}", 3).astype(np.int64)
        uv = _arrays.numbers(chart[1], f"uv of chart {i}", 2).astype(np.float64)
        vertices = (_arrays.numbers(chart[2], f"vertices of chart {i}", 3) if len(chart) > 2
                    else np.column_stack([uv, np.zeros(len(uv))]))
        if len(vertices) != len(uv):
            raise ValueError(f"chart {i} has {len(uv)} coordinates, and {len(vertices)} vertices")
        if faces.size > 0 and (faces.min() < 0 or faces.max() >= len(uv)):
            raise ValueError(f"faces of chart {i} have an index outside of its {len(uv)} vertices")
        first_faces.append(sum(len(each) for each in all_faces))
        all_faces.append(faces + first_vertices[-1])
        all_uv.append(uv[faces.reshape(-1)])
        all_vertices.append(vertices)
        first_vertices.append(first_vertices[-1] + len(uv))
    if not all_faces:
        raise ValueError("charts is empty")
    given, _ = given_mesh(np.concatenate(all_vertices), np.concatenate(all_faces), uv=np.concatenate(all_uv))
    uv, text = _core.pack(given, np.array(first_faces, np.int64), options, _options.watch())
    return Packing([uv[a:b] for a, b in zip(first_vertices, first_vertices[1:])], json.loads(text))
