"""Texture atlases of any surface."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, cast, overload

import numpy as np

from . import _arrays, _core, _drawing, _options

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Atlas:
    """The charts of a mesh.

    Attributes:
        uv: (c, 2) float64, the texture coordinates of each corner, in the order of the faces; NaN in faces without
            chart. Exact predicates certified that no triangle is flipped and none overlaps another.
        face_chart: (m,) int32, the number of the chart of each face; -1 for faces without chart. Charts of several
            meshes are numbered through.
        seams: (k, 2) int64, the edges where charts are cut open, as vertices.
        report: what ``flatten_mesh --json`` writes of the surface and its charts. It counts faces from 1, as OBJ files
            do.
    """

    uv: NDArray[np.float64]
    face_chart: NDArray[np.int32]
    seams: NDArray[np.int64]
    report: dict[str, Any]
    _indices: _arrays.Array = field(repr=False)
    _offsets: _arrays.Array | None = field(repr=False)

    def unshared(self) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]]:
        """Vertices that have one coordinate each, as graphics cards want them.

        Returns:
            ``vmapping`` (k,) uint32, the vertex of the mesh that each new vertex is; ``indices`` (m, 3) uint32, the
            faces in new vertices, or (c,) for the corners of polygons; ``uvs`` (k, 2) float32. Rounding to float32
            can flip triangles smaller than a millionth of the page; `uv` is not rounded.
        """
        vmapping, indices, uvs = _core.unshared(self._indices, self.uv)
        return vmapping, indices.reshape(self._indices.shape), uvs

    def show(self, axes: Any = None) -> Any:
        """Draws the page with matplotlib, each chart in a colour. Scripts then call ``matplotlib.pyplot.show()``.

        Args:
            axes: of matplotlib, where it is drawn; by default, those of a new figure.

        Returns:
            The axes.

        Raises:
            ImportError: matplotlib is not installed.
        """
        return _drawing.show(self, axes)

    def _repr_html_(self) -> str:
        """What notebooks show: the page, and a line on it."""
        return _drawing.as_html(self)


def _given_mesh(vertices: Any, faces: Any, marked_seams: Any, uv: Any, ignored_faces: Any, number: int | None,
                ) -> tuple[_core.GivenMesh, _arrays.Array | None, _arrays.Array]:
    """A mesh as the compiled part takes it. It has a number if there are several."""
    mesh = "" if number is None else f"mesh {number}"
    vertices = _arrays.numbers(vertices, _arrays.name_of("vertices", mesh), 3)
    offsets, indices = _arrays.polygons(faces, mesh)
    _arrays.check_not_empty(offsets, indices, mesh, number or 0)
    if marked_seams is not None:
        marked_seams = _arrays.integers(marked_seams, _arrays.name_of("marked_seams", mesh), 2)
    if uv is not None:
        uv = _arrays.numbers(uv, _arrays.name_of("uv", mesh), 2)
        if len(uv) != indices.size:
            raise ValueError(f"{_arrays.name_of('uv', mesh)} has {len(uv)} rows, and must have one for each of the "
                             f"{indices.size} corners")
    if ignored_faces is not None:
        ignored_faces = _arrays.flags(ignored_faces, _arrays.name_of("ignored_faces", mesh),
                                      _arrays.number_of_faces(offsets, indices))
    return _core.GivenMesh(vertices, offsets, indices, marked_seams, uv, ignored_faces), offsets, indices


_OF_PAGES = ("resolution", "height", "gutter", "block", "texels_per_unit", "number_of_rotations", "seam_price",
             "quantization_bits")
_OF_SEAMS = ("seams", "marked_seams", "seam_price", "symmetric")
_OF_MAPS = ("purpose", "separate_overlaps", "isometric_charts", "stretch_bound", "area_weight", "equal_seam_lengths")


def _check_together(options: dict[str, Any]) -> None:
    """Raises an error for an option that would have no effect with another one."""

    def exclude(names: Sequence[str], other: str, reason: str) -> None:
        for name in names:
            if options.get(name) is not None:
                raise ValueError(f"{name} is given, and goes without {other}: {reason}")

    charts = options.get("given_charts")
    if options.get("pack_into_square") is False:
        exclude(_OF_PAGES, "pack_into_square=False", "it says how charts are packed")
    if options.get("symmetric"):
        exclude(("marked_seams",), "symmetric=True", "seams that are given stay where they are")
    if charts in ("keep", "repair"):
        exclude(_OF_SEAMS, f'given_charts="{charts}"', "charts that are given are kept")
    if charts == "keep":
        exclude(_OF_MAPS, 'given_charts="keep"', "charts that are given are kept")


def _per_mesh(values: Any, what: str, count: int) -> list[Any]:
    if values is None:
        return [None] * count
    if not isinstance(values, (list, tuple)) or len(values) != count:
        raise ValueError(f"{what} must be a list with an entry for each of the {count} meshes")
    return list(values)


@overload
def atlas(vertices: _arrays.SupportsArray, faces: ArrayLike, **options: Any) -> Atlas: ...


@overload
def atlas(vertices: list[NDArray[Any]] | tuple[NDArray[Any], ...], faces: Sequence[ArrayLike], **options: Any,
          ) -> list[Atlas]: ...


@overload
def atlas(vertices: Sequence[Sequence[Any]], faces: ArrayLike | Sequence[ArrayLike], **options: Any,
          ) -> Atlas | list[Atlas]: ...


@_options.takes("atlas")
def atlas(vertices: ArrayLike | Sequence[ArrayLike], faces: ArrayLike | Sequence[ArrayLike], *,
          purpose: str = "texture", seams: str = "auto", marked_seams: ArrayLike | None = None,
          uv: ArrayLike | None = None, ignored_faces: ArrayLike | None = None, symmetric: bool = False,
          weld: bool = True, repair: bool = True, timeout: float | None = None,
          progress: _options.Progress | bool | None = None, **options: Any) -> Atlas | list[Atlas]:
    """Cuts any surface open, flattens it, and packs the charts, as ``flatten_mesh`` does.

    Args:
        vertices: (n, 3) float32 or float64, the points; read in place. For several meshes that share the atlas, a
            list of such arrays; then all other arguments that belong to a mesh are lists, too.
        faces: (m, 3) of any type of integers, or a tuple of two arrays (offsets, indices) for polygons: face ``i`` has
            the vertices ``indices[offsets[i]:offsets[i + 1]]``.
        purpose: ``"texture"``, ``"few-charts"`` or ``"conformal"``; it sets the defaults of the options below.
        seams: where seams run: ``"auto"``, ``"length"``, ``"near-creases"``, ``"creases"``, ``"creases:DEGREES"`` or
            ``"hidden"``.
        marked_seams: (k, 2) integers, edges that are seams in any case.
        uv: (c, 2), coordinates of each corner that the mesh has already.
        ignored_faces: (m,) bool, faces that get no chart. They keep the coordinates in `uv`.
        symmetric: whether seams are symmetric where the surface is; for one mesh without seams or charts of its own.
        weld: whether vertices at the same place are joined first.
        repair: whether faces that do not form a manifold are separated, turned or left out.
        timeout: seconds after which a `TimeoutError` is raised.
        progress: is called with the name of a stage and its share, from 0 to 1, twenty times a second, in the thread
            of the caller. If it returns ``False``, `Cancelled` is raised. ``True`` shows a bar, by the package tqdm.
        OPTIONS

    Returns:
        The atlas, or a list of atlases, one for each mesh. Parts that have no chart are in
        ``report["skipped"]``.

    Raises:
        ValueError: an option or an array is wrong; the message names it.
        MeshError: no face has a chart; or, with ``given_charts="keep"``, a chart is not injective.
        TimeoutError, Cancelled, MemoryError: see above.

    >>> import angle_based_flattening as abf
    >>> import numpy as np
    >>> vertices = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    >>> atlas = abf.atlas(vertices, [[0, 1, 2], [0, 2, 3]], resolution=256)
    >>> atlas.uv.shape, atlas.face_chart.tolist(), atlas.report["atlas"]["injective"]
    ((6, 2), [0, 0], True)
    """
    choices = {"purpose": purpose, "seams": seams, "symmetric": _options.switch("symmetric", symmetric),
               "weld": _options.switch("weld", weld), "repair": _options.switch("repair", repair)}
    _check_together(options | {
        "purpose": None if purpose == "texture" else purpose, "seams": None if seams == "auto" else seams,
        "marked_seams": marked_seams, "symmetric": choices["symmetric"] or None})
    meshes: list[Any] = [vertices]
    is_shared = isinstance(vertices, (list, tuple)) and len(vertices) > 0 and np.ndim(vertices[0]) == 2
    if isinstance(vertices, (list, tuple)) and is_shared:
        meshes = list(vertices)
    if is_shared and symmetric:
        raise ValueError("symmetric is True, and goes with one mesh only")
    of_meshes = {"faces": faces, "marked_seams": marked_seams, "uv": uv, "ignored_faces": ignored_faces}
    lists = {name: _per_mesh(values, name, len(meshes)) if is_shared else [values]
             for name, values in of_meshes.items()}
    if options.get("given_charts") == "keep" and any(each is None for each in lists["uv"]):
        raise ValueError('given_charts is "keep", and uv is not given')
    given = [_given_mesh(mesh, lists["faces"][i], lists["marked_seams"][i], lists["uv"][i], lists["ignored_faces"][i],
                         i if is_shared else None) for i, mesh in enumerate(meshes)]
    with _options.watching(progress, timeout) as watch:
        results, text = _core.atlas([each[0] for each in given], is_shared, choices, options, watch)
    report = json.loads(text)
    atlases = [Atlas(*result, report, indices, offsets)
               for result, (_, offsets, indices) in zip(results, given)]
    return atlases if is_shared else atlases[0]


def parametrize(vertices: ArrayLike, faces: ArrayLike, **options: Any,
                ) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]]:
    """Makes an atlas and returns `Atlas.unshared()`: what ``xatlas.parametrize()`` returns.

    Args:
        vertices, faces, options: as of `atlas()`, for one mesh.

    >>> import angle_based_flattening as abf
    >>> vmapping, indices, uvs = abf.parametrize([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    >>> vmapping[indices].tolist()
    [[0, 1, 2]]
    """
    result = atlas(cast(Sequence[Sequence[Any]], vertices), faces, **options)
    if isinstance(result, list):
        raise ValueError("parametrize() takes one mesh; atlas() takes several")
    return result.unshared()
