# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what a module of Python reads of each file, in a line of JSON, as the script `run` wants it. A face is the
list of its corners: x, y, z, and u, v of each set of texture coordinates, in which v points upwards.
Usage: read_in_python.py MODULE FILE..."""

import contextlib
import importlib
import json
import os
import subprocess
import sys
import tempfile
from importlib import metadata
from pathlib import Path

import numpy


def of_vertices(points, faces, *sets):
    """Faces whose coordinates are those of vertices. A set that is not there is None."""
    table = numpy.hstack([numpy.asarray(a, float)[:, :columns] for a, columns in
                          [(points, 3), *((uv, 2) for uv in sets if uv is not None and len(uv) == len(points))]])
    return [[table[v].tolist() for v in face] for face in faces]


def of_corners(points, faces, uv):
    """Faces whose coordinates are those of corners, one after the other"""
    rest = iter(uv)
    return [[[*map(float, points[v]), *map(float, next(rest, ()))] for v in face] for face in faces]


def read_trimesh(module, path):
    """Scenes and single meshes"""
    scene = module.load_scene(path, process=False)
    for mesh in scene.dump():
        uv = getattr(mesh.visual, "uv", None)
        yield from of_vertices(mesh.vertices, mesh.faces, uv)


def read_meshio(module, path):
    """Coordinates of vertices, whatever their name is"""
    mesh = module.read(path)
    data = mesh.point_data
    uv = data.get("obj:vt", numpy.column_stack([data["s"], data["t"]]) if "s" in data else None)
    for block in mesh.cells:
        yield from of_vertices(mesh.points, block.data, uv)


def read_pygltflib(module, path):
    """The library gives access to buffers only: what is read here is what its structures say."""
    gltf = module.GLTF2().load(path)
    assert all(node.matrix is None and node.translation is None for node in gltf.nodes)
    data = gltf.binary_blob()

    def numbers(index):
        accessor = gltf.accessors[index]
        view = gltf.bufferViews[accessor.bufferView]
        kind = {module.FLOAT: "f4", module.UNSIGNED_INT: "u4", module.UNSIGNED_SHORT: "u2"}[accessor.componentType]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor.type]
        return numpy.frombuffer(data, "<" + kind, accessor.count * width,
                                view.byteOffset + (accessor.byteOffset or 0)).reshape(-1, width)

    for mesh in gltf.meshes:
        for primitive in mesh.primitives:
            keys = primitive.attributes
            sets = [numbers(k) * (1, -1) + (0, 1) for k in (keys.TEXCOORD_0, keys.TEXCOORD_1) if k is not None]
            yield from of_vertices(numbers(keys.POSITION), numbers(primitive.indices).reshape(-1, 3), *sets)


def read_open3d(module, path):
    """`read_triangle_model()` for glTF files, which its documentation names for them"""
    if path.endswith(".glb"):
        for part in module.io.read_triangle_model(path).meshes:
            mesh = module.t.geometry.TriangleMesh.from_legacy(part.mesh)
            triangles, points = mesh.triangle.indices.numpy(), mesh.vertex.positions.numpy()
            uv = mesh.triangle.texture_uvs.numpy().reshape(-1, 2) if "texture_uvs" in mesh.triangle else []
            yield from of_corners(points, triangles, uv)
    else:
        mesh = module.io.read_triangle_mesh(path)
        yield from of_corners(mesh.vertices, mesh.triangles, mesh.triangle_uvs if mesh.has_triangle_uvs() else [])


def read_pymeshlab(module, path):
    """Coordinates of corners, or else of vertices"""
    meshes = module.MeshSet(verbose=False)
    meshes.load_new_mesh(path)
    for mesh in meshes:
        if mesh.has_wedge_tex_coord():
            yield from of_corners(mesh.vertex_matrix(), mesh.face_matrix(), mesh.wedge_tex_coord_matrix())
        else:
            uv = mesh.vertex_tex_coord_matrix() if mesh.has_vertex_tex_coord() else None
            yield from of_vertices(mesh.vertex_matrix(), mesh.face_matrix(), uv)


def vtk_faces(polygons):
    """The numbers of the vertices of each face of a vtkPolyData"""
    for i in range(polygons.GetNumberOfCells()):
        cell = polygons.GetCell(i)
        yield [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]


def read_vtk(module, path):
    """The reader for each format, and the coordinates that it makes active"""
    reader = {".obj": module.vtkOBJReader, ".ply": module.vtkPLYReader, ".glb": module.vtkGLTFReader}[path[-4:]]()
    reader.SetFileName(path)
    reader.Update()
    result, parts = reader.GetOutputDataObject(0), []
    if path.endswith(".glb"):
        tree = result.NewIterator()
        while not tree.IsDoneWithTraversal():
            parts.append(tree.GetCurrentDataObject())
            tree.GoToNextItem()
    else:
        parts.append(result)
    for part in parts:
        data = part.GetPointData()
        arrays = [data.GetArray(f"TEXCOORD_{k}") for k in range(2)] if path.endswith(".glb") else [data.GetTCoords()]
        sets = [[array.GetTuple(i) for i in range(array.GetNumberOfTuples())] for array in arrays if array]
        if path.endswith(".glb"):  # the numbers of the file
            sets = [[(u, 1 - v) for u, v in uv] for uv in sets]
        yield from of_vertices([part.GetPoint(i) for i in range(part.GetNumberOfPoints())], vtk_faces(part), *sets)


def read_pyvista(module, path):
    """Its active texture coordinates"""
    result = module.read(path)
    for part in result.recursive_iterator() if isinstance(result, module.MultiBlock) else [result]:
        uv = part.active_texture_coordinates
        yield from of_vertices(part.points, vtk_faces(part),
                               uv * (1, -1) + (0, 1) if path.endswith(".glb") and uv is not None else uv)


def read_cloudcompare(_, path):
    """What it writes to an OBJ file of what it has read"""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "out.obj"
        subprocess.run(["CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-O", path, "-M_EXPORT_FMT", "OBJ",
                        "-SAVE_MESHES", "FILE", copy], env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
                       capture_output=True, timeout=60, check=True)
        points, uv = [], []
        for word, *rest in (line.split() for line in copy.read_text().splitlines() if line.strip()):
            if word == "v":
                points.append([*map(float, rest)])
            elif word == "vt":
                uv.append([*map(float, rest)])
            elif word == "f":
                corners = [corner.split("/") for corner in rest]
                yield [points[int(c[0]) - 1] + (uv[int(c[1]) - 1] if len(c) > 1 and c[1] else []) for c in corners]


def main():
    """What goes to the standard output of the modules themselves becomes part of their messages."""
    output = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    name, *paths = sys.argv[1:]
    module = None if name == "cloudcompare" else importlib.import_module(name)
    if module:
        version = module.VTK_VERSION if name == "vtk" else metadata.version(name)
        print(json.dumps({"version": version}), file=output, flush=True)
    for path in paths:
        try:
            with contextlib.redirect_stdout(sys.stderr):
                result = {"faces": list(globals()["read_" + name](module, path))}
        except Exception as error:  # whatever a module throws
            result = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(result), file=output, flush=True)


main()
