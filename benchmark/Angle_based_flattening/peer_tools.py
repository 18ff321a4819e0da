# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls one library, in a process of its own that peers.py starts in the environment with the libraries: peer_tools.py
TOOL IN OUT.npz. Each library has its default options, and pages of 1024 texels where pages have texels."""

import sys
import time

import numpy as np

TEXELS = 1024
SLIM_STEPS = 30


def of_module(vertices, faces):
    import angle_based_flattening as abf
    begin = time.process_time()
    _, indices, uvs = abf.parametrize(vertices, faces, threads=1)
    return uvs[indices], (1, 1), begin


def of_xatlas(vertices, faces):
    import xatlas
    begin = time.process_time()
    atlas = xatlas.Atlas()
    atlas.add_mesh(vertices.astype(np.float32), faces.astype(np.uint32))
    atlas.generate()
    _, indices, uvs = atlas.get_mesh(0)
    return uvs[indices], (atlas.width, atlas.height), begin


def of_uvunwrap(vertices, faces):
    import uvunwrap
    begin = time.process_time()
    atlas = uvunwrap.generate([uvunwrap.Mesh(vertices, faces.astype(np.uint32))], page_size=TEXELS)
    return np.array(atlas.meshes[0].corner_uvs).reshape(-1, 3, 2), (atlas.width, atlas.height), begin


def of_geotex(vertices, faces):
    import geotex
    begin = time.process_time()
    return geotex.make_atlas(vertices, faces.astype(np.uint32)).reshape(-1, 3, 2), (1, 1), begin


def of_open3d(vertices, faces):
    import open3d
    begin = time.process_time()
    mesh = open3d.t.geometry.TriangleMesh(open3d.core.Tensor(vertices.astype(np.float32)),
                                          open3d.core.Tensor(faces.astype(np.int64)))
    mesh.compute_uvatlas(size=TEXELS)
    return mesh.triangle.texture_uvs.numpy(), (1, 1), begin


def on_circle(igl, vertices, faces):
    """A harmonic map, or that with equal weights if triangles of it are flipped"""
    from scipy import sparse
    from scipy.sparse import linalg
    border = igl.boundary_loop(faces)
    points = np.asfortranarray(vertices)
    circle = np.ascontiguousarray(igl.map_vertices_to_circle(points, border.astype(np.int32)))
    uv = igl.harmonic(vertices, faces, border, circle, 1)
    p, q, r = (uv[faces[:, k]] for k in range(3))
    areas = (q - p)[:, 0] * (r - p)[:, 1] - (q - p)[:, 1] * (r - p)[:, 0]
    inner = np.setdiff1d(np.arange(len(vertices)), border)
    if len(inner) and not (areas > 0).all():
        edges = sparse.csr_matrix((np.ones(faces.size), (faces.ravel(), np.roll(faces, -1, 1).ravel())))
        edges = (edges + edges.T > 0).astype(float)
        laplacian = (sparse.diags(np.asarray(edges.sum(axis=1)).ravel()) - edges).tocsr()
        uv[border] = circle
        uv[inner] = linalg.spsolve(laplacian[inner][:, inner].tocsc(), -laplacian[inner][:, border] @ circle)
    return uv


def lscm(igl, vertices, faces):
    border = igl.boundary_loop(faces)
    fixed = border[[0, len(border) // 2]]
    return igl.lscm(vertices, faces, fixed, np.array([[0., 0.], [1., 0.]]))[0]


def arap(igl, vertices, faces):
    data = igl.ARAPData()
    data.max_iter = 100  # as in the tutorial
    start = on_circle(igl, vertices, faces)
    igl.arap_precomputation(vertices, faces, 2, np.zeros(1, np.int32), data)
    return igl.arap_solve(start[:1], data, start)


def slim(igl, vertices, faces):
    start = np.asfortranarray(on_circle(igl, vertices, faces))
    data = igl.slim_precompute(np.asfortranarray(vertices), np.asfortranarray(faces.astype(np.int32)), start,
                               igl.MappingEnergyType.SYMMETRIC_DIRICHLET, np.empty(0, np.int32),
                               np.empty((0, 2), order="F"), 0.)
    return igl.slim_solve(data, SLIM_STEPS)[:, :2]


def of_libigl(method, vertices, faces, sizes):
    """Each chart is a number of faces, with vertices of its own. Charts that cannot be mapped stay without map."""
    import igl
    from scipy.sparse import linalg  # noqa: F401, whose import is not timed
    begin, corners = time.process_time(), np.zeros((len(faces), 3, 2))
    for end, size in zip(np.cumsum(sizes), sizes):
        used, local = np.unique(faces[end - size:end], return_inverse=True)
        local = local.reshape(-1, 3).astype(np.int64)
        try:
            uv = method(igl, np.ascontiguousarray(vertices[used]), local)
        except (RuntimeError, ValueError, IndexError):
            continue
        corners[end - size:end] = uv[local] if np.isfinite(uv).all() else 0
    return corners, (1, 1), begin


TOOLS = {"module": of_module, "xatlas": of_xatlas, "uvunwrap": of_uvunwrap, "geotex": of_geotex, "open3d": of_open3d,
         "lscm": lambda *mesh: of_libigl(lscm, *mesh), "arap": lambda *mesh: of_libigl(arap, *mesh),
         "slim": lambda *mesh: of_libigl(slim, *mesh)}


def main():
    tool, file, output = sys.argv[1:]
    if tool == "read":  # a mesh in any format, of a size at which no library drops triangles
        import igl
        vertices, faces = igl.read_triangle_mesh(file)
        vertices = (vertices - vertices.min(axis=0)) * (100 / np.ptp(vertices, axis=0).max())
        np.savez(output, vertices=vertices, faces=faces)
        return
    mesh = np.load(file)
    corners, page, begin = TOOLS[tool](*(mesh[name] for name in mesh.files))
    seconds = time.process_time() - begin
    size = np.array(page) / max(page)
    np.savez(output, corners=corners * size, page=size.prod(), seconds=seconds)


if __name__ == "__main__":
    main()
