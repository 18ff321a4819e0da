# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Atlases for meshes of trimesh, PyVista, meshio and Open3D. A library that is not installed is skipped."""

from pathlib import Path

import angle_based_flattening as abf
from mesh_files import read

vertices, faces = read(Path(__file__).resolve().parents[1] / "data" / "egg.off")


def with_trimesh():
    import trimesh
    return abf.unwrap(trimesh.Trimesh(vertices, faces, process=False)).visual.uv


def with_pyvista():
    import pyvista
    return abf.unwrap(pyvista.PolyData.from_regular_faces(vertices, faces)).active_texture_coordinates


def with_meshio():
    import meshio
    return abf.unwrap(meshio.Mesh(vertices, [("triangle", faces)])).point_data["obj:vt"]


def with_open3d():
    import open3d
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(vertices),
                                        open3d.utility.Vector3iVector(faces))
    return abf.unwrap(mesh).triangle_uvs  # of each corner


for function in (with_trimesh, with_pyvista, with_meshio, with_open3d):
    name = function.__name__.removeprefix("with_")
    try:
        print(f"{name}: {len(function())} coordinates")
    except ImportError:
        print(f"{name}: skipped, it is not installed")
