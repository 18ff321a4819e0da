"""The interface of the module ``xatlas`` 0.0.11, with our atlases: ``import angle_based_flattening.xatlas as xatlas``.

What it makes is injective, and has fewer charts with shorter seams. It differs in these respects:

- Options that mean nothing here have an effect on nothing. If they are set to other values than their defaults, a
  warning names them. Normals and coordinates of meshes are checked; coordinates count with
  ``use_input_mesh_uvs`` only: charts of them that are injective then keep their shapes.
- Meshes are those of `atlas()`: wrong ones are a ``ValueError``, and meshes without any chart a `MeshError`. Faces
  without chart have the coordinates (0, 0), and their vertices the chart and the page 4294967295, as in xatlas.
- Without `resolution`, the page is a square of 1024 texels or, with `texels_per_unit`, about as large as charts need.
"""

from __future__ import annotations

import dataclasses
import enum
import math
import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arrays
from ._atlas import Atlas as _Result
from ._atlas import atlas as _atlas

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Atlas", "Chart", "ChartOptions", "ChartType", "PackOptions", "export", "parametrize"]

_NONE = np.uint32(0xFFFFFFFF)


class ChartOptions:
    """How charts are found. Only `use_input_mesh_uvs` has an effect. Faces are always turned as with `fix_winding`."""

    __slots__ = ("max_chart_area", "max_boundary_length", "normal_deviation_weight", "roundness_weight",
                 "straightness_weight", "normal_seam_weight", "texture_seam_weight", "max_cost", "max_iterations",
                 "use_input_mesh_uvs", "fix_winding")

    def __init__(self) -> None:
        self.max_chart_area = 0.0
        self.max_boundary_length = 0.0
        self.normal_deviation_weight = 2.0
        self.roundness_weight = 0.01
        self.straightness_weight = 6.0
        self.normal_seam_weight = 4.0
        self.texture_seam_weight = 0.5
        self.max_cost = 2.0
        self.max_iterations = 1
        self.use_input_mesh_uvs = False
        self.fix_winding = False


class PackOptions:
    """How charts are packed.

    Attributes:
        padding: texels around each chart, so that twice as many are between two.
        bilinear: whether there is another one for bilinear filtering.
        blockAlign: whether no block of 4 x 4 texels belongs to two charts.
        resolution: texels along each side of a page.
        texels_per_unit: with `resolution`, there are as many pages as charts take.
        create_image: whether there is a `chart_image`.
        max_chart_size, bruteForce, rotate_charts_to_axis, rotate_charts: without effect.
    """

    __slots__ = ("max_chart_size", "padding", "texels_per_unit", "resolution", "bilinear", "blockAlign", "bruteForce",
                 "create_image", "rotate_charts_to_axis", "rotate_charts")

    def __init__(self) -> None:
        self.max_chart_size = 0
        self.padding = 0
        self.texels_per_unit = 0.0
        self.resolution = 0
        self.bilinear = True
        self.blockAlign = False
        self.bruteForce = False
        self.create_image = False
        self.rotate_charts_to_axis = True
        self.rotate_charts = True


_USED = {"use_input_mesh_uvs", "fix_winding", "padding", "texels_per_unit", "resolution", "bilinear", "blockAlign",
         "create_image"}


def _warn_of_unused(options: ChartOptions | PackOptions) -> None:
    default = type(options)()
    for name in options.__slots__:
        if name not in _USED and getattr(options, name) != getattr(default, name):
            warnings.warn(f"{type(options).__name__}.{name} is {getattr(options, name)!r}, and has no effect here",
                          stacklevel=3)


class ChartType(enum.IntEnum):
    """The kinds of charts of xatlas. Ours are `LSCM` throughout: the nearest one, of maps that an energy determines."""

    Planar = 0
    Ortho = 1
    LSCM = 2
    Piecewise = 3
    Invalid = 4


@dataclass(frozen=True)
class Chart:
    """A chart: its page, its faces (k,) uint32 in its mesh."""

    atlas_index: int
    faces: NDArray[np.uint32]
    material: int = 0
    type: ChartType = ChartType.LSCM


@dataclass
class _Mesh:
    """A mesh that was added, and what becomes of it."""

    positions: NDArray[Any]
    indices: NDArray[np.int64]
    uvs: NDArray[Any] | None
    is_plane: bool = False
    result: tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]] | None = None
    pages: NDArray[np.uint32] = dataclasses.field(default_factory=lambda: np.zeros(0, np.uint32))
    charts: NDArray[np.uint32] = dataclasses.field(default_factory=lambda: np.zeros(0, np.uint32))
    face_charts: NDArray[np.int32] = dataclasses.field(default_factory=lambda: np.zeros(0, np.int32))


def _checked(values: ArrayLike, what: str, columns: int, count: int | None = None) -> NDArray[Any]:
    array: NDArray[Any] = _arrays.numbers(values, what, columns)
    if count is not None and len(array) != count:
        raise ValueError(f"{what} has {len(array)} rows, and must have one for each of the {count} vertices")
    return array


def _indices(values: ArrayLike) -> NDArray[np.int64]:
    array = np.asarray(values)
    if array.dtype.kind == "f":  # as xatlas takes them
        array = array.astype(np.int64)
    return _arrays.integers(array, "indices", 3).astype(np.int64)


class Atlas:
    """Meshes that share an atlas. ``len(atlas)`` is their number, and ``atlas[i]`` is `get_mesh(i)`."""

    def __init__(self) -> None:
        self._meshes: list[_Mesh] = []
        self._made: list[_Mesh] = []
        self._chart_pages: list[int] = []
        self._images: list[NDArray[np.uint8]] | None = None
        self._utilizations: list[float] = []
        self.width = self.height = 0
        self.texels_per_unit = 0.0

    def add_mesh(self, positions: ArrayLike, indices: ArrayLike, normals: ArrayLike | None = None,
                 uvs: ArrayLike | None = None) -> None:
        """Adds a mesh: `positions` (n, 3), `indices` (m, 3), `normals` (n, 3), which have no effect, `uvs` (n, 2)."""
        positions = _checked(positions, "positions", 3)
        if normals is not None:
            _checked(normals, "normals", 3, len(positions))
        if uvs is not None:
            uvs = _checked(uvs, "uvs", 2, len(positions))
        self._meshes.append(_Mesh(positions, _indices(indices), uvs))

    def add_uv_mesh(self, uvs: ArrayLike, indices: ArrayLike, face_materials: ArrayLike | None = None) -> None:
        """Adds charts that are only packed: `uvs` (n, 2), `indices` (m, 3). They do not go with other meshes."""
        uvs = _checked(uvs, "uvs", 2)
        if face_materials is not None:
            warnings.warn("face_materials have no effect here", stacklevel=2)
        self._meshes.append(_Mesh(np.column_stack([uvs, np.zeros(len(uvs))]), _indices(indices), uvs, True))

    def generate(self, chart_options: ChartOptions | None = None, pack_options: PackOptions | None = None,
                 verbose: bool = False) -> None:
        """Makes the atlas."""
        chart_options, pack_options = chart_options or ChartOptions(), pack_options or PackOptions()
        _warn_of_unused(chart_options)
        _warn_of_unused(pack_options)
        if not self._meshes:
            warnings.warn("there are no meshes", stacklevel=2)
            return
        planes = sum(mesh.is_plane for mesh in self._meshes)
        if planes not in (0, len(self._meshes)):
            raise ValueError("some of the meshes are charts of add_uv_mesh(), and must not go with others")
        charts = "keep" if planes else "repair" if chart_options.use_input_mesh_uvs else "replace"
        results = self._results(pack_options, charts)
        self._take(results)
        self._images = [self._image(page) for page in range(self.atlas_count)] if pack_options.create_image else None
        if verbose:
            print(f"--- Generated Atlas ---\nUtilization: {100 * self.utilization:f}%\nCharts: {self.chart_count}\n"
                  f"Size: {self.width}x{self.height}\n")

    def _results(self, options: PackOptions, charts: str) -> list[_Result]:
        """Those of `atlas()`."""
        block = 4 if options.blockAlign else 1
        resolution = -(-(options.resolution or 1024) // block) * block
        gutter = 2 * options.padding + (2 if options.bilinear else 0)
        settings: dict[str, Any] = {"block": block, "gutter": max(gutter, 1)}

        def make(**more: Any) -> list[_Result]:
            made = _atlas([mesh.positions for mesh in self._meshes], [mesh.indices for mesh in self._meshes],
                          **settings, **more)
            return made if isinstance(made, list) else [made]

        uv = None if charts == "replace" else [
            None if mesh.uvs is None else mesh.uvs[mesh.indices.reshape(-1)] for mesh in self._meshes]
        if options.resolution > 0:
            return make(resolution=resolution, texels_per_unit=options.texels_per_unit, uv=uv, given_charts=charts)
        results = make(resolution=resolution, uv=uv, given_charts=charts)
        for _ in range(3 if options.texels_per_unit > 0 else 0):  # a single page; the gutter is no part of the scale
            wanted = resolution * options.texels_per_unit / results[0].report["atlas"]["packing"]["texels_per_unit"]
            resolution = min(max(math.ceil(wanted / block), 1) * block, 32768)
            results = make(resolution=resolution, uv=[result.uv for result in results], given_charts="keep")
        return results

    def _take(self, results: list[_Result]) -> None:
        packing, charts = results[0].report["atlas"]["packing"], results[0].report["atlas"]["charts"]
        self._made = list(self._meshes)
        self._chart_pages = [chart["page"] for chart in charts]
        self.width, self.height = packing["resolution"], packing["height"]
        self.texels_per_unit = packing["texels_per_unit"]
        areas = np.zeros(packing["pages"])
        pages = np.array(self._chart_pages)
        for mesh, result in zip(self._made, results):
            has_chart = result.face_chart >= 0
            uv = result.uv.reshape(-1, 3, 2)
            page = np.where(has_chart, pages[result.face_chart], 0)
            uv = np.where(has_chart[:, None, None], uv - np.stack([page % 10, page // 10], 1)[:, None], 0)  # UDIM
            a, b = (uv[:, i] - uv[:, 0] for i in (1, 2))
            np.add.at(areas, page, abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2)
            # Vertices are split by the coordinates before pages lie over one another.
            given = dataclasses.replace(result, uv=np.where(np.isnan(result.uv), 0, result.uv))
            vmapping, indices, _ = given.unshared()
            uvs = np.zeros((len(vmapping), 2), np.float32)
            uvs[indices] = uv
            mesh.charts, mesh.pages = np.full((2, len(vmapping)), _NONE)
            mesh.charts[indices[has_chart]] = result.face_chart[has_chart, None]
            mesh.pages[indices[has_chart]] = page[has_chart, None]
            mesh.result, mesh.face_charts = (vmapping, indices, uvs), result.face_chart
        self._utilizations = areas.tolist()

    def _of(self, index: int) -> _Mesh:
        if not 0 <= index < len(self._made):
            raise IndexError(f"Mesh index {index} out of bounds for atlas with {len(self._made)} meshes.")
        return self._made[index]

    def _page(self, index: int) -> int:
        if not 0 <= index < self.atlas_count:
            raise IndexError(f"Atlas index {index} out of bounds.")
        return index

    def get_mesh(self, mesh_index: int) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]]:
        """``vmapping`` (k,), ``indices`` (m, 3) and ``uvs`` (k, 2) of a mesh."""
        result = self._of(mesh_index).result
        assert result is not None
        return result

    __getitem__ = get_mesh

    def __len__(self) -> int:
        return len(self._made)

    def get_mesh_chart_count(self, mesh_index: int) -> int:
        """The number of charts of a mesh."""
        numbers = self._of(mesh_index).face_charts
        return len(np.unique(numbers[numbers >= 0]))

    def get_mesh_chart(self, mesh_index: int, chart_index: int) -> Chart:
        """A chart of a mesh. Charts are counted from 0 in each mesh."""
        numbers = self._of(mesh_index).face_charts
        own = np.unique(numbers[numbers >= 0])
        if not 0 <= chart_index < len(own):
            raise IndexError(f"Chart index {chart_index} out of bounds for mesh with {len(own)} charts.")
        chart = own[chart_index]
        return Chart(self._chart_pages[chart], np.flatnonzero(numbers == chart).astype(np.uint32))

    def get_mesh_vertex_assignment(self, mesh_index: int) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """The page and the chart of each vertex of `get_mesh()`. Charts of several meshes are numbered through."""
        mesh = self._of(mesh_index)
        return mesh.pages, mesh.charts

    def get_utilization(self, atlas_index: int) -> float:
        """The share of a page that charts cover."""
        return self._utilizations[self._page(atlas_index)]

    def get_chart_image(self, atlas_index: int) -> NDArray[np.uint8]:
        """(height, width, 3), the chart of each texel as a colour. As in xatlas, v = 0 is the first row."""
        self._page(atlas_index)
        if self._images is None:
            raise RuntimeError("The atlas does not have an image.")
        return self._images[atlas_index]

    def _image(self, page: int) -> NDArray[np.uint8]:
        image = np.zeros((self.height, self.width, 3), np.uint8)
        colors = np.random.default_rng(0).integers(64, 256, (self.chart_count, 3), np.uint8)
        for number, mesh in enumerate(self._made):
            _, indices, uvs = self.get_mesh(number)
            for face in np.flatnonzero(mesh.face_charts >= 0):
                if mesh.pages[indices[face, 0]] == page:
                    corners = uvs[indices[face]].astype(float) * [self.width, self.height] - .5
                    low, high = np.ceil(corners.min(0)).astype(int), np.floor(corners.max(0)).astype(int) + 1
                    x, y = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
                    sides = np.stack([(b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
                                      for a, b in zip(corners, np.roll(corners, -1, axis=0))])
                    inside = (sides >= 0).all(axis=0) | (sides <= 0).all(axis=0)  # some faces are turned
                    image[y[inside], x[inside]] = colors[mesh.face_charts[face]]
        return image

    @property
    def mesh_count(self) -> int:
        return len(self._made)

    @property
    def chart_count(self) -> int:
        return len(self._chart_pages)

    @property
    def atlas_count(self) -> int:
        return len(self._utilizations)

    @property
    def utilization(self) -> float:
        return self.get_utilization(0)

    @property
    def chart_image(self) -> NDArray[np.uint8]:
        return self.get_chart_image(0)


def parametrize(positions: ArrayLike, indices: ArrayLike, normals: ArrayLike | None = None,
                uvs: ArrayLike | None = None) -> tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]]:
    """The atlas of a mesh: ``vmapping`` (k,), ``indices`` (m, 3) and ``uvs`` (k, 2).

    >>> import numpy as np
    >>> from angle_based_flattening import xatlas
    >>> vmapping, indices, uvs = xatlas.parametrize(np.eye(3), [[0, 1, 2]])
    >>> vmapping[indices]
    array([[0, 1, 2]], dtype=uint32)
    """
    atlas = Atlas()
    atlas.add_mesh(positions, indices, normals, uvs)
    atlas.generate()
    return atlas[0]


def export(path: str | os.PathLike[str], positions: ArrayLike, indices: ArrayLike | None = None,
           uvs: ArrayLike | None = None, normals: ArrayLike | None = None) -> None:
    """Writes an OBJ file, in which a vertex has one coordinate and one normal."""
    positions = _checked(positions, "positions", 3)
    lines = []
    for word, values, columns in ("v", positions, 3), ("vn", normals, 3), ("vt", uvs, 2):
        if values is not None:
            rows = _checked(values, {"v": "positions", "vn": "normals", "vt": "uvs"}[word], columns, len(positions))
            lines += [f"{word} {' '.join(f'{x:.9g}' for x in row)}" for row in rows.tolist()]
    form = {(False, False): "{0}", (True, False): "{0}/{0}", (False, True): "{0}//{0}", (True, True): "{0}/{0}/{0}"}[
        uvs is not None, normals is not None]
    faces = _indices(indices).tolist() if indices is not None else []
    lines += ["f " + " ".join(form.format(v + 1) for v in face) for face in faces]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
