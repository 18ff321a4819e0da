# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Atlases for trimesh, PyVista and Open3D. A library that is not installed is skipped."""

from pathlib import Path

import angle_based_flattening as abf
import numpy as np
from mesh_files import read

vertices, faces = read(Path(__file__).resolve().parents[1] / "data" / "egg.off")


def with_trimesh():
    import trimesh
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    vmapping, indices, uvs = abf.parametrize(mesh.vertices, mesh.faces)
    textured = trimesh.Trimesh(mesh.vertices[vmapping], indices, process=False,
                               visual=trimesh.visual.TextureVisuals(uv=uvs))
    return len(textured.vertices)


def with_pyvista():
    import pyvista
    mesh = pyvista.PolyData(vertices, np.column_stack([np.full(len(faces), 3), faces]))
    vmapping, indices, uvs = abf.parametrize(mesh.points, mesh.faces.reshape(-1, 4)[:, 1:])
    textured = pyvista.PolyData(mesh.points[vmapping], np.column_stack([np.full(len(indices), 3), indices]))
    textured.point_data.active_t_coords = uvs
    return textured.n_points


def with_open3d():
    import open3d
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(vertices),
                                        open3d.utility.Vector3iVector(faces))
    atlas = abf.atlas(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    mesh.triangle_uvs = open3d.utility.Vector2dVector(atlas.uv)  # of each corner, as here
    return len(mesh.triangle_uvs)


for function in (with_trimesh, with_pyvista, with_open3d):
    name = function.__name__.removeprefix("with_")
    try:
        print(f"{name}: {function()} coordinates")
    except ImportError:
        print(f"{name}: skipped, it is not installed")
