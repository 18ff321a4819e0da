# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Atlases are those of the program, with the same bits."""

import itertools
import json
import os
import subprocess

import angle_based_flattening as abf
import meshes
import numpy as np
import program
import pytest

# Options of the module, and of the program
OPTIONS = [
    (dict(), []),
    (dict(purpose="few-charts"), ["--for", "few-charts"]),
    (dict(purpose="conformal", resolution=512, height=256), ["--for", "conformal", "--resolution", "512x256"]),
    (dict(seams="creases", gutter=3, number_of_rotations=8), ["--seams", "creases", "--gutter", 3, "--rotations", 8]),
    (dict(seams="creases:25", block=4, resolution=256), ["--seams", "creases:25", "--block", 4, "--resolution", 256]),
    (dict(purpose="few-charts", seams="hidden", stretch_bound=1.2, area_weight=.5),
     ["--for", "few-charts", "--seams", "hidden", "--stretch-bound", 1.2, "--area-weight", .5]),
    (dict(texels_per_unit=60, resolution=128), ["--texels-per-unit", 60, "--resolution", 128]),
    (dict(pack_into_square=False, weld=False, repair=False), ["--no-pack", "--repair", "off"]),
    (dict(seam_price=.2), ["--seam-price", .2]),
    (dict(symmetric=True), ["--symmetric"]),
    (dict(separate_overlaps=False, isometric_charts=False, equal_seam_lengths=True, seam_price=float("inf")),
     ["--separate", "off", "--isometric", "off", "--equal-seams", "on", "--seam-price", "inf"]),
]


def check(atlas, corners, report):
    assert program.same_bits(atlas.uv, corners)
    assert program.comparable(atlas.report) == program.comparable(report)


@pytest.mark.parametrize("name", meshes.ALL)
def test_surfaces(name, tmp_path):
    vertices, faces = meshes.ALL[name]()
    check(abf.atlas(vertices, faces), *program.run(tmp_path, vertices, faces))


@pytest.mark.parametrize("given, words", OPTIONS)
def test_options(given, words, tmp_path):
    for seed, make in enumerate((meshes.hill, meshes.torus)):
        vertices, faces = make(seed=seed)
        check(abf.atlas(vertices, faces, **given), *program.run(tmp_path, vertices, faces, *words))


def test_charts_and_seams(tmp_path):
    vertices, faces = meshes.torus(seed=3)
    atlas = abf.atlas(vertices, faces)
    seams = tmp_path / "torus.selection.txt"
    program.run(tmp_path, vertices, faces, "--seams-to", seams)
    assert np.array_equal(program.read_seams(seams), atlas.seams)
    charts = atlas.report["atlas"]["charts"]
    counts = np.bincount(atlas.face_chart)
    assert counts.tolist() == [chart["triangles"] for chart in charts] and len(counts) > 1
    # An edge between two charts is a seam.
    corners = {(a, b): f for f, face in enumerate(faces) for a, b in zip(face, np.roll(face, -1))}
    borders = {(min(a, b), max(a, b)) for (a, b), f in corners.items()
               if atlas.face_chart[f] != atlas.face_chart[corners[b, a]]}
    assert borders <= set(map(tuple, atlas.seams.tolist())) and borders


def test_marked_seams(tmp_path):
    vertices, faces = meshes.hill(10, 4)
    marked = np.array([[11, 12], [13, 12], [13, 14]])
    file = tmp_path / "marked.selection.txt"
    file.write_text("\n\n" + " ".join(map(str, marked.reshape(-1))) + "\n")
    atlas = abf.atlas(vertices, faces, marked_seams=marked, seam_price=float("inf"))
    assert {(11, 12), (12, 13), (13, 14)} <= set(map(tuple, atlas.seams.tolist()))
    corners, report = program.run(tmp_path, vertices, faces, "--seams-from", file)
    assert program.same_bits(atlas.uv, corners)


def test_given_charts(tmp_path):
    vertices, faces = meshes.torus(seed=2)
    uv = abf.atlas(vertices, faces, pack_into_square=False).uv
    check(abf.atlas(vertices, faces, uv=uv, given_charts="keep"),
          *program.run(tmp_path, vertices, faces, "--repack", uv=uv))
    folded = uv.copy()
    folded[:3] = uv[0]
    with pytest.raises(abf.MeshError) as error:
        abf.atlas(vertices, faces, uv=folded, given_charts="keep")
    assert len(error.value.faces) > 0
    check(abf.atlas(vertices, faces, uv=folded, given_charts="repair"),
          *program.run(tmp_path, vertices, faces, "--repack", "--repair-charts", uv=folded))


def test_ignored_faces():
    vertices, faces = meshes.hill()
    uv = np.full((faces.size, 2), .25)
    ignored = np.arange(len(faces)) < 22
    atlas = abf.atlas(vertices, faces, ignored_faces=ignored, uv=uv)
    assert np.array_equal(atlas.face_chart < 0, ignored)
    assert np.array_equal(atlas.uv[:66], uv[:66])
    rest = abf.atlas(vertices, faces[22:])
    assert program.same_bits(atlas.uv[66:], rest.uv)


def test_several_meshes(tmp_path):
    models = [meshes.hill(8, 1), meshes.box(), meshes.sphere(1, 2)]
    atlases = abf.atlas([v for v, _ in models], [f for _, f in models])
    files = []
    for k, (vertices, faces) in enumerate(models):
        files.append(tmp_path / f"{k}.obj")
        program.write_obj(files[-1], vertices, faces)
    if not os.environ.get("ABF_FLATTEN_MESH"):
        pytest.skip("ABF_FLATTEN_MESH, the path of the program, is not set")
    subprocess.run([os.environ["ABF_FLATTEN_MESH"], *files, "--one-atlas", "--quiet", "--output",
                    tmp_path / "%_atlas.obj"], check=True)
    for k, ((_, faces), atlas) in enumerate(zip(models, atlases)):
        assert program.same_bits(atlas.uv, program.read_corners(tmp_path / f"{k}_atlas.obj", faces))
    charts = [set(atlas.face_chart.tolist()) for atlas in atlases]
    assert all(a.isdisjoint(b) for a, b in itertools.combinations(charts, 2))
    assert sorted(set.union(*charts)) == list(range(len(atlases[0].report["atlas"]["charts"])))
    assert json.dumps(atlases[0].report) == json.dumps(atlases[1].report)


def test_failures_of_several_meshes_name_the_mesh():
    hill, torus = meshes.hill(), meshes.torus()
    uv = [abf.atlas(*mesh, pack_into_square=False).uv for mesh in (hill, torus)]
    uv[1][:3] = uv[1][:3][::-1]
    with pytest.raises(abf.MeshError) as error:
        abf.atlas([hill[0], torus[0]], [hill[1], torus[1]], uv=uv, given_charts="keep")
    assert error.value.mesh == 1 and len(error.value.faces) > 0
    with pytest.raises(abf.MeshError) as error:
        abf.atlas([hill[0], torus[0]], [hill[1], torus[1][:0]])
    assert (error.value.mesh, error.value.status) == (1, "EMPTY_MESH")


@pytest.mark.parametrize("name", meshes.ALL)
def test_unshared(name):
    vertices, faces = meshes.ALL[name]()
    atlas = abf.atlas(vertices, faces)
    vmapping, indices, uvs = atlas.unshared()
    old = faces[1] if isinstance(faces, tuple) else faces
    assert (vmapping.dtype, indices.dtype, uvs.dtype) == (np.uint32, np.uint32, np.float32)
    assert indices.shape == old.shape and len(vmapping) == len(uvs)
    assert np.array_equal(vmapping[indices], old)
    assert np.array_equal(uvs[indices.reshape(-1)], atlas.uv.astype(np.float32), equal_nan=True)
    pairs = np.column_stack([vmapping, uvs.view(np.uint32).reshape(-1, 2)])
    assert len(np.unique(pairs, axis=0)) == len(pairs)  # no vertex is there twice


def test_parametrize():
    vertices, faces = meshes.torus()
    for a, b in zip(abf.parametrize(vertices, faces, resolution=256),
                    abf.atlas(vertices, faces, resolution=256).unshared()):
        assert np.array_equal(a, b)
    with pytest.raises(ValueError, match="takes one mesh"):
        abf.parametrize([vertices], [faces])


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_do_not_matter(threads):
    vertices, faces = meshes.sphere(3)
    assert program.same_bits(abf.atlas(vertices, faces, threads=threads).uv, abf.atlas(vertices, faces).uv)


def test_skipped_faces():
    atlas = abf.atlas(*meshes.soup())
    assert atlas.face_chart[-1] == -1 and np.isnan(atlas.uv[-3:]).all()
    assert (atlas.face_chart[:-1] >= 0).all() and np.isfinite(atlas.uv[:-3]).all()
    assert [part["diagnosis"] for part in atlas.report["skipped"]] == ["DEGENERATE_FACE"]
