# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""unwrap() with Open3D, which takes 450 MB, and is therefore apart."""

import angle_based_flattening as abf
import numpy as np
import pytest

from common import check

o3d = pytest.importorskip("open3d")


def test_tensors(torus, tmp_path):
    mesh = o3d.t.geometry.TriangleMesh(o3d.core.Tensor(torus.vertices.astype(np.float32)),
                                       o3d.core.Tensor(torus.faces))
    mesh.vertex["colors"] = o3d.core.Tensor(torus.colors[:, :3].copy())
    mesh.triangle["n"] = o3d.core.Tensor(np.arange(768))
    new, atlas = abf.unwrap(mesh, return_atlas=True)
    assert type(new) is type(mesh) and "texture_uvs" not in mesh.triangle
    uv = new.triangle["texture_uvs"].numpy()
    assert uv.shape == (768, 3, 2) and uv.dtype == np.float32
    points, indices = new.vertex.positions.numpy(), new.triangle.indices.numpy()
    assert np.array_equal(indices, torus.faces)
    check(atlas, torus.faces, torus.faces, torus.vertices.astype(np.float32), points, indices, uv.reshape(-1, 2))
    assert np.array_equal(new.vertex["colors"].numpy(), torus.colors[:, :3]) and "n" in new.triangle
    assert abf.unwrap(new, given_charts="keep").triangle["texture_uvs"].shape[0] == 768
    o3d.t.io.write_triangle_mesh(str(tmp_path / "a.npz"), new)
    again = o3d.t.io.read_triangle_mesh(str(tmp_path / "a.npz"))
    assert np.array_equal(again.triangle["texture_uvs"].numpy(), uv)


def test_legacy(torus, tmp_path):
    mesh = o3d.geometry.TriangleMesh(o3d.utility.Vector3dVector(torus.vertices),
                                     o3d.utility.Vector3iVector(torus.faces))
    mesh.vertex_colors = o3d.utility.Vector3dVector(torus.colors[:, :3] / 255)
    new, atlas = abf.unwrap(mesh, return_atlas=True)
    assert type(new) is type(mesh) and not mesh.has_triangle_uvs() and len(new.vertex_colors) == 384
    check(atlas, torus.faces, torus.faces, torus.vertices, new.vertices, new.triangles, new.triangle_uvs)
    assert abf.unwrap(new, given_charts="keep").has_triangle_uvs()
    assert o3d.io.write_triangle_mesh(str(tmp_path / "a.obj"), new)
    again = o3d.io.read_triangle_mesh(str(tmp_path / "a.obj"))
    assert np.abs(np.asarray(again.triangle_uvs) - np.asarray(new.triangle_uvs)).max() < 1e-5


def test_empty():
    with pytest.raises(TypeError, match="mesh is a TriangleMesh: its attribute 'vertex' has no 'positions'"):
        abf.unwrap(o3d.t.geometry.TriangleMesh())
    with pytest.raises(abf.MeshError):
        abf.unwrap(o3d.geometry.TriangleMesh())
