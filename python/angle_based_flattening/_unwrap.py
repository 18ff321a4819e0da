"""Meshes of other libraries get texture coordinates. A library is imported only when a mesh of it has come in."""

from __future__ import annotations

import copy
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arrays, _core, _gltf
from ._atlas import Atlas, atlas

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]



@dataclass
class _Taken:
    """What a library's mesh consists of, and how a copy of it gets coordinates of each corner."""

    vertices: Any
    faces: Any
    uv: Callable[[], Any]
    with_uv: Callable[[Array], Any]


def unwrap(mesh: Any, *, return_atlas: bool = False, **options: Any) -> Any:
    """Makes an atlas of a mesh of another library. The result is a new mesh of the same kind with its coordinates.

    Where a library has one coordinate for each vertex, vertices on seams are repeated, with all their data. Faces stay
    in their order, and polygons stay polygons.

    Args:
        mesh: one of these:

            - ``trimesh.Trimesh``: ``visual`` becomes ``TextureVisuals``; colours of vertices are its attribute
              ``"color"``, which GLB files have, and colours of faces the face attribute ``"color"``.
            - ``pyvista.PolyData``: `active_texture_coordinates`. Polygons of all sizes are taken as they are.
            - ``meshio.Mesh``: the point data ``"obj:vt"``, and ``"s"`` and ``"t"``, which its PLY writer needs.
              Triangles, quads and polygons get coordinates; all other cells stay.
            - ``open3d.t.geometry.TriangleMesh``: ``triangle.texture_uvs``, on each corner; vertices stay.
            - ``open3d.geometry.TriangleMesh``: `triangle_uvs`, likewise.
            - a pair ``(V, F)`` as of libigl, or any other object with `vertices` and `faces`: the result is the pair
              (uv, F_uv), as the arrays TC and FTC of ``igl.readOBJ()``.
            - ``pygltflib.GLTF2``: a scene, by the program ``flatten_mesh``: all its meshes share the atlas.
        return_atlas: whether the result is a pair of the new mesh and its `Atlas`; not for glTF.
        options: those of `atlas()`. With `given_charts`, `uv` is by default what the mesh has.

    Returns:
        The new mesh. The given one is not changed. Faces without chart have the coordinates (0, 0), with a warning.

    Raises:
        TypeError: the object is no such mesh; the message names the attribute that it lacks.
        ValueError, MeshError, TimeoutError, Cancelled: as of `atlas()`.

    >>> import angle_based_flattening as abf
    >>> uv, faces = abf.unwrap(([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    >>> uv.shape, faces.shape
    ((3, 2), (1, 3))
    """
    if _library_of(mesh)[0] == "pygltflib":
        if return_atlas:
            raise ValueError("return_atlas is True, and does not go with glTF: the program makes the atlas")
        return _gltf.unwrap(mesh, options)
    taken = _taken(mesh)
    if options.get("given_charts") in ("keep", "repair") and options.get("uv") is None:
        options["uv"] = taken.uv()
    result = atlas(taken.vertices, taken.faces, **options)
    if isinstance(result, list):
        raise ValueError("unwrap() takes one mesh; atlas() takes several")
    is_missing = np.isnan(result.uv).any(axis=1)
    if is_missing.any():
        _warn_of_missing(result, is_missing, options.get("ignored_faces"))
    unwrapped = taken.with_uv(np.where(is_missing[:, None], 0.0, result.uv))
    return (unwrapped, result) if return_atlas else unwrapped


def _warn_of_missing(result: Atlas, is_missing: Array, ignored_faces: Any) -> None:
    """Faces that were to be ignored need no warning."""
    firsts = result._offsets[:-1] if result._offsets is not None else np.arange(0, len(is_missing), 3)
    is_missing = is_missing[firsts] & (True if ignored_faces is None else ~np.asarray(ignored_faces))
    if is_missing.any():
        warnings.warn(f"{is_missing.sum()} of {len(is_missing)} faces have no chart, and the coordinates (0, 0): see "
                      'report["skipped"] of the atlas', stacklevel=3)


def _library_of(mesh: Any) -> tuple[str, str]:
    """The library of a mesh, also of one of a derived class, and the name of its class there."""
    known = {("trimesh", "Trimesh"), ("pyvista", "PolyData"), ("meshio", "Mesh"), ("open3d", "TriangleMesh"),
             ("pygltflib", "GLTF2")}
    for kind in type(mesh).__mro__:
        modules = kind.__module__.split(".")
        if (modules[0], kind.__name__) in known:
            return ("open3d.t" if modules[0] == "open3d" and "t" in modules else modules[0]), kind.__name__
    return "", ""


def _taken(mesh: Any) -> _Taken:
    """A mesh of any library."""
    functions = {"trimesh": _from_trimesh, "pyvista": _from_pyvista, "meshio": _from_meshio,
                 "open3d.t": _from_open3d_tensors, "open3d": _from_open3d}
    library = _library_of(mesh)[0]
    if library in functions:
        return functions[library](mesh)
    if isinstance(mesh, (tuple, list)):
        if len(mesh) != 2:
            raise TypeError(f"mesh is a {type(mesh).__name__} of {len(mesh)}, and must be a pair (vertices, faces)")
        return _from_pair(*mesh)
    if isinstance(mesh, str) or hasattr(mesh, "__fspath__"):
        raise TypeError("mesh is the name of a file: python -m angle_based_flattening FILE -o OUTPUT takes files")
    return _from_pair(_attribute(mesh, "vertices"), _attribute(mesh, "faces"))


def _attribute(mesh: Any, name: str) -> Any:
    if not hasattr(mesh, name):
        kind = type(mesh).__name__
        raise TypeError(f"mesh is {'an' if kind[0] in 'aeiouAEIO' else 'a'} {kind}: it has no attribute {name!r}")
    return getattr(mesh, name)


def _unshared(faces: Any, uv: Array) -> tuple[Array, Array, Array]:
    """As `Atlas.unshared()`, with flat indices of polygons."""
    indices = _arrays.polygons(faces)[1]
    vmapping, new, uvs = _core.unshared(indices, uv)
    return vmapping, new.reshape(indices.shape), uvs


def _unshared_and_rest(faces: Any, uv: Array, n: int) -> tuple[Array, Array, Array, Array]:
    """As `_unshared()`, with the points at the end that no face has; and a new vertex of each of the `n` old ones."""
    vmapping, indices, uvs = _unshared(faces, uv)
    is_used = np.zeros(n, bool)
    is_used[vmapping] = True
    rest = np.flatnonzero(~is_used)
    vmapping = np.concatenate([vmapping, rest]).astype(np.int64)
    new_of_old = np.zeros(n, np.int64)
    new_of_old[vmapping[::-1]] = np.arange(len(vmapping))[::-1]  # the first one stays
    return vmapping, indices.astype(np.int64), np.concatenate([uvs, np.zeros((len(rest), 2), np.float32)]), new_of_old


def _from_pair(vertices: Any, faces: Any) -> _Taken:
    def with_uv(uv: Array) -> tuple[Array, Any]:
        offsets, given = _arrays.polygons(faces)
        _, indices, _ = _unshared(faces, uv)
        own = np.zeros((indices.max() + 1, 2))
        own[indices.reshape(-1)] = uv  # which is not rounded
        indices = indices.astype(given.dtype)
        return own, indices if offsets is None else (offsets, indices)

    return _Taken(vertices, faces, lambda: None, with_uv)


def _from_trimesh(mesh: Any) -> _Taken:
    import trimesh

    faces = np.asarray(mesh.faces)

    def with_uv(uv: Array) -> Any:
        vmapping, indices, uvs = _unshared(faces, uv)
        old, visual = mesh.visual, trimesh.visual.TextureVisuals(uv=uvs)
        attributes = {name: np.array(values) for name, values in mesh.face_attributes.items()}
        colors = old.vertex_attributes.get("color") if old.kind == "texture" else None
        if old.kind == "vertex":
            colors = old.vertex_colors
        if colors is not None:
            visual.vertex_attributes["color"] = np.asarray(colors)[vmapping]
        if old.kind == "face":
            attributes["color"] = np.array(old.face_colors)
        return trimesh.Trimesh(
            np.asarray(mesh.vertices)[vmapping], indices, process=False, visual=visual, face_attributes=attributes,
            vertex_normals=np.asarray(mesh.vertex_normals)[vmapping],  # which are smooth across seams
            vertex_attributes={name: np.asarray(values)[vmapping] for name, values in mesh.vertex_attributes.items()},
            metadata=copy.deepcopy(mesh.metadata))

    def own() -> Array | None:
        uv = getattr(mesh.visual, "uv", None)
        return None if uv is None else np.asarray(uv)[faces.reshape(-1)]

    return _Taken(np.asarray(mesh.vertices), faces, own, with_uv)


def _from_pyvista(mesh: Any) -> _Taken:
    import pyvista

    if mesh.n_strips:
        raise ValueError("mesh has triangle strips, which triangulate() makes triangles of")
    polygons = mesh.GetPolys()
    faces = tuple(np.array(pyvista.convert_array(values), np.int64)
                  for values in (polygons.GetOffsetsArray(), polygons.GetConnectivityArray()))

    def padded(offsets: Array, indices: Array) -> Array:
        return np.insert(indices, offsets[:-1], np.diff(offsets))

    def with_uv(uv: Array) -> Any:
        vmapping, indices, uvs, new_of_old = _unshared_and_rest(faces, uv, mesh.n_points)
        new = pyvista.PolyData()
        new.points = np.asarray(mesh.points)[vmapping]
        new.faces = padded(faces[0], indices)
        for name, cells in ("verts", mesh.GetVerts()), ("lines", mesh.GetLines()):
            if cells.GetNumberOfCells():
                offsets, points = (np.array(pyvista.convert_array(values), np.int64)
                                   for values in (cells.GetOffsetsArray(), cells.GetConnectivityArray()))
                setattr(new, name, padded(offsets, new_of_old[points]))
        for name in mesh.point_data:
            new.point_data[name] = mesh.point_data[name][vmapping]
        for name in mesh.cell_data:
            new.cell_data[name] = mesh.cell_data[name].copy()
        for name in mesh.field_data:
            new.field_data[name] = mesh.field_data[name].copy()
        for old_data, data in (mesh.point_data, new.point_data), (mesh.cell_data, new.cell_data):
            for what in "active_scalars_name", "active_vectors_name", "active_normals_name":
                if getattr(old_data, what):
                    setattr(data, what, getattr(old_data, what))
        new.active_texture_coordinates = uvs
        return new

    def own() -> Array | None:
        uv = mesh.active_texture_coordinates
        return None if uv is None else np.asarray(uv)[faces[1]]

    return _Taken(np.asarray(mesh.points), faces, own, with_uv)


def _from_meshio(mesh: Any) -> _Taken:
    import meshio

    blocks = [i for i, block in enumerate(mesh.cells) if block.type in ("triangle", "quad", "polygon")]
    data = [np.asarray(mesh.cells[i].data) for i in blocks]
    sizes = [np.full(len(cells), cells.shape[1]) for cells in data]
    faces = (np.concatenate([[0], *sizes]).cumsum(), np.concatenate([np.zeros(0, np.int64), *map(np.ravel, data)]))

    def with_uv(uv: Array) -> Any:
        vmapping, indices, uvs, new_of_old = _unshared_and_rest(faces, uv, len(mesh.points))
        parts = np.split(indices, np.cumsum([cells.size for cells in data])[:-1])
        of_faces = {i: part.reshape(cells.shape) for i, part, cells in zip(blocks, parts, data)}
        cells = [(block.type, of_faces[i] if i in of_faces else new_of_old[np.asarray(block.data)])
                 for i, block in enumerate(mesh.cells)]
        of_points = {name: np.asarray(values)[vmapping] for name, values in mesh.point_data.items()}
        of_points |= {"obj:vt": uvs, "s": uvs[:, 0].copy(), "t": uvs[:, 1].copy()}
        point_sets = {name: np.flatnonzero(np.isin(vmapping, points)) for name, points in mesh.point_sets.items()}
        return meshio.Mesh(np.asarray(mesh.points)[vmapping], cells, of_points, copy.deepcopy(mesh.cell_data),
                           copy.deepcopy(mesh.field_data), point_sets, copy.deepcopy(mesh.cell_sets), info=mesh.info)

    def own() -> Array | None:
        uv = mesh.point_data.get("obj:vt")
        if uv is None and "s" in mesh.point_data and "t" in mesh.point_data:
            uv = np.column_stack([mesh.point_data["s"], mesh.point_data["t"]])
        return None if uv is None else np.asarray(uv)[faces[1], :2]  # VTK files have a third 0

    return _Taken(np.asarray(mesh.points), faces, own, with_uv)


def _from_open3d_tensors(mesh: Any) -> _Taken:
    import open3d

    for values, name, what in (mesh.vertex, "positions", "vertex"), (mesh.triangle, "indices", "triangle"):
        if name not in values:
            raise TypeError(f"mesh is a TriangleMesh: its attribute {what!r} has no {name!r}")

    def with_uv(uv: Array) -> Any:
        new = mesh.clone()
        new.triangle["texture_uvs"] = open3d.core.Tensor(uv.astype(np.float32).reshape(-1, 3, 2), device=mesh.device)
        return new

    def own() -> Array | None:
        found = "texture_uvs" in mesh.triangle
        return mesh.triangle["texture_uvs"].cpu().numpy().reshape(-1, 2) if found else None

    return _Taken(mesh.vertex.positions.cpu().numpy(), mesh.triangle.indices.cpu().numpy(), own, with_uv)


def _from_open3d(mesh: Any) -> _Taken:
    import open3d

    def with_uv(uv: Array) -> Any:
        new = open3d.geometry.TriangleMesh(mesh)
        new.triangle_uvs = open3d.utility.Vector2dVector(uv)
        if not new.has_triangle_material_ids():  # without, it takes textures for missing
            new.triangle_material_ids = open3d.utility.IntVector(np.zeros(len(new.triangles), np.int32))
        return new

    return _Taken(np.asarray(mesh.vertices), np.asarray(mesh.triangles),
                  lambda: np.asarray(mesh.triangle_uvs) if mesh.has_triangle_uvs() else None, with_uv)
