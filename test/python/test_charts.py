# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single charts, their measures and certificates, seams, cones, packing and baking."""

import angle_based_flattening as abf
import meshes
import numpy as np
import program
import pytest

MAPS = [
    (dict(), []),
    (dict(method="hierarchical"), ["--method", "hierarchical"]),
    (dict(method="hierarchical", polish=True, sweeps=5), ["--method", "hierarchical", "--polish", "--sweeps", 5]),
    (dict(injective=True), ["--method", "direct", "--injective"]),
    (dict(injective=True, area_weight=.3), ["--method", "direct", "--injective", "--area-weight", .3]),
    (dict(boundary="rectangle", corners=[0, 11, 143, 132]), ["--rectangle", "1,12,144,133"]),
    (dict(barrier=0, layout="least-squares", step="sqp", linear_solver="direct"),
     ["--barrier", 0, "--layout", "least-squares", "--step", "sqp", "--linear-solver", "direct"]),
]


def signed_areas(uv, faces):
    a, b, c = (uv[faces[:, k]] for k in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


@pytest.mark.parametrize("given, words", MAPS)
def test_maps_of_the_program(given, words, tmp_path):
    vertices, faces = meshes.hill(12, 5)
    corners, report = program.run(tmp_path, vertices, faces, "--plain", *words)
    flattening = abf.flatten(vertices, faces, **given)
    assert program.same_bits(flattening.uv[faces.reshape(-1)], corners)
    assert flattening.report["flipped_triangles"] == 0
    measures = abf.measure(vertices, faces, flattening.uv)
    common = {name: value for name, value in report.items() if name in measures and isinstance(value, float)}
    assert len(common) > 10
    assert {name: measures[name] for name in common} == pytest.approx(common, rel=1e-9)


def test_hierarchical_is_a_method():
    mesh = meshes.hill(12, 6)
    assert program.same_bits(abf.hierarchical(*mesh).uv, abf.flatten(*mesh, method="hierarchical").uv)


def test_failed_coarse_charts():
    vertices, faces = meshes.hill(40, 6)
    report = abf.flatten(vertices, faces, method="hierarchical", fallbacks=False).report
    assert (report["start"], report["note"], report["failed_coarse_charts"]) == ("COARSE_PARAMETERIZER", "", [])
    noise = vertices + [0, 0, 1] * np.random.default_rng(2).uniform(-20, 20, (len(vertices), 1))
    report = abf.flatten(noise, faces, method="hierarchical").report
    assert report["start"] == "PROGRESSIVE_EMBEDDING" and "one triangle" in report["note"]
    assert len(report["failed_coarse_charts"]) > 0
    for chart in report["failed_coarse_charts"]:
        assert chart["triangles"] > chart["vertices"] > 0 and chart["message"] and chart["error"].startswith("ERROR_")
    with pytest.raises(abf.MeshError) as error:
        abf.flatten(noise, faces, method="hierarchical", fallbacks=False)
    assert error.value.status == "COARSE_CHART_FAILED"


def test_polygons():
    """The diagonals of quadrangles are chosen; all points of the map are where they are for any triangles."""
    vertices, _ = meshes.hill(10, 7)
    corner = (np.arange(9)[:, None] * 10 + np.arange(9)).reshape(-1, 1)
    quads = corner + [0, 1, 11, 10]
    faces = np.arange(0, quads.size + 1, 4), quads.reshape(-1)
    uv = abf.flatten(vertices, faces).uv
    assert uv.shape == (100, 2) and np.isfinite(uv).all()
    assert abf.certify(vertices, faces, uv)


def test_pins():
    vertices, faces = meshes.hill()
    places = [[0, 0], [2, 0]]
    uv = abf.flatten(vertices, faces, pins=([0, 11], places)).uv
    assert uv[[0, 11]] == pytest.approx(np.array(places))


def test_given_angles():
    """The corners of a square get a third of a turn, a sixth of a turn, and what is left."""
    vertices, faces = meshes.hill(height=0)
    uv = abf.flatten(vertices, faces, angles=([0, 11], [2 * np.pi / 3, np.pi / 3])).uv

    def angle(before, v, after):
        a, b = uv[after] - uv[v], uv[before] - uv[v]
        return np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b)

    assert angle(12, 0, 1) == pytest.approx(2 * np.pi / 3, abs=1e-4)
    assert angle(10, 11, 23) == pytest.approx(np.pi / 3, abs=1e-4)


def test_rectangle_with_a_ratio():
    uv = abf.flatten(*meshes.hill(height=0), boundary="rectangle", aspect_ratio=1).uv
    sides = np.ptp(uv, axis=0)
    assert max(sides) / min(sides) == pytest.approx(1, abs=.15)


def test_flattener_is_used_again():
    faces = meshes.hill()[1]
    flattener = abf.Flattener(faces)
    for seed in range(4):
        vertices, _ = meshes.hill(seed=seed)
        assert program.same_bits(flattener.solve(vertices).uv, abf.flatten(vertices, faces).uv)
    with pytest.raises(ValueError, match="4 vertices, and were 144 before"):
        flattener.solve(np.zeros((4, 3)))
    assert program.same_bits(flattener.solve(vertices).uv, abf.flatten(vertices, faces).uv)


def test_lscm():
    """A flat surface keeps its shape."""
    vertices, faces = meshes.hill(height=0)
    vertices[:, 2] = 0
    uv = abf.lscm(vertices, faces).uv
    assert abf.measure(vertices, faces, uv)["max_quasi_conformal_ratio"] == pytest.approx(1, abs=1e-6)


def test_measures_of_corners_and_vertices():
    vertices, faces = meshes.hill()
    uv = abf.flatten(vertices, faces).uv
    by_vertices = abf.measure(vertices, faces, uv)
    assert abf.measure(vertices, faces, uv[faces.reshape(-1)]) == by_vertices
    twice = abf.measure(vertices, faces, 2 * uv)
    assert twice["mean_angle_change"] == pytest.approx(by_vertices["mean_angle_change"])


@pytest.mark.parametrize("seed", range(3))
def test_certificates(seed):
    vertices, faces = meshes.hill(seed=seed)
    uv = abf.flatten(vertices, faces).uv
    assert abf.certify(vertices, faces, uv)
    random = np.random.default_rng(seed)
    moved = uv.copy()
    moved[random.integers(len(uv))] += [3, 3]
    certificate = abf.certify(vertices, faces, moved)
    assert not certificate and not certificate.is_injective
    assert np.array_equal(certificate.flipped, np.flatnonzero(signed_areas(moved, faces) <= 0))
    assert len(certificate.overlapping) > 0


def test_overlap_without_flips():
    """A strip that goes round twice"""
    turns = np.linspace(0, 4 * np.pi, 40)
    uv = np.concatenate([np.column_stack([r * np.cos(turns), r * np.sin(turns)]) for r in (1, 2)])
    faces = meshes.grid(40, 2)[:, ::-1]
    certificate = abf.certify(np.column_stack([uv, np.tile(turns, 2)]), faces, uv)
    assert not certificate and len(certificate.flipped) == 0 and len(certificate.overlapping) > 40


@pytest.mark.parametrize("along", ["length", "creases", "hidden"])
def test_seams(along, tmp_path):
    vertices, faces = meshes.torus(seed=2)
    seams = abf.seams(vertices, faces, along=along, marked_seams=[[0, 1]])
    assert seams.report["disks"] == 1
    edges = set(map(tuple, seams.edges.tolist()))
    assert (0, 1) in edges and edges == {(min(e), max(e)) for e in edges}


def test_seams_of_the_program(tmp_path):
    vertices, faces = meshes.torus(seed=2)
    file = tmp_path / "torus.selection.txt"
    program.run(tmp_path, vertices, faces, "--plain", "--seams-to", file, "--stretch-bound", 1.1, output=False)
    assert np.array_equal(program.read_seams(file), abf.seams(vertices, faces, stretch_bound=1.1).edges)


def test_cones_of_the_program(tmp_path):
    vertices, faces = meshes.sphere(seed=2)
    cones = abf.cones(vertices, faces, 8, flatten=True)
    _, report = program.run(tmp_path, vertices, faces, "--plain", "--cones", 8, output=False)
    assert (cones.vertices + 1).tolist() == [cone["vertex"] for cone in report["cones"]["cones"]]
    assert cones.angles.tolist() == [cone["angle"] for cone in report["cones"]["cones"]]
    assert (2 * np.pi - cones.angles).sum() == pytest.approx(4 * np.pi, rel=1e-3)
    assert cones.uv.shape == (faces.size, 2) and abf.certify(vertices, faces, cones.uv).flipped.size == 0
    alone = abf.cones(vertices, faces, 8)
    assert alone.uv is None and alone.seams is None


def test_quarter_turns():
    cones = abf.cones(*meshes.sphere(seed=1), 8, angle_multiple=np.pi / 2)
    quarters = cones.angles / (np.pi / 2)
    assert quarters == pytest.approx(quarters.round(), abs=1e-6)


def test_packing():
    """Charts change by similarities, lie in the square, and are apart."""
    charts = [meshes.hill(8, seed) for seed in range(5)]
    packing = abf.pack([(f, v[:, :2]) for v, f in charts], resolution=256, gutter=3)
    assert packing.report["pages"] == 1 and packing.report["page_of_chart"] == [0] * 5
    densities = set()
    for (vertices, faces), uv in zip(charts, packing.uv):
        assert uv.min() >= 0 and uv.max() <= 1
        before, after = signed_areas(vertices[:, :2], faces), signed_areas(uv, faces)
        assert after / before == pytest.approx(after[0] / before[0])
        densities.add(round(after[0] / before[0], 9))
    assert len(densities) == 1
    joined = np.concatenate([f + 64 * k for k, (_, f) in enumerate(charts)])
    points = np.concatenate([v for v, _ in charts])
    assert abf.certify(points, joined, np.concatenate(packing.uv))


def test_packing_by_surface():
    vertices, faces = meshes.hill(8, 1)
    small, large = abf.pack([(faces, vertices[:, :2], vertices), (faces, vertices[:, :2], 2 * vertices)]).uv
    assert signed_areas(large, faces).sum() / signed_areas(small, faces).sum() == pytest.approx(4, rel=1e-6)


def test_packing_errors():
    vertices, faces = meshes.hill(4)
    with pytest.raises(ValueError, match="charts is empty"):
        abf.pack([])
    with pytest.raises(ValueError, match="faces of chart 1 have an index outside of its 3 vertices"):
        abf.pack([(faces, vertices[:, :2]), (faces, vertices[:3, :2])])
    with pytest.raises(abf.MeshError, match="DEGENERATE_CHART"):
        abf.pack([(faces, np.zeros((16, 2)), vertices)])


def test_baking():
    """A flat square under a plane at a known height"""
    vertices, faces = meshes.hill(4, height=0)
    vertices[:, 2] = 0
    uv = vertices[:, :2] * .5 + .25
    fine = np.array([[-1, -1, .01], [2, -1, .01], [2, 2, .01], [-1, 2, .01]])
    colors = np.full((4, 3), 51, np.uint8)
    baked = abf.bake(vertices, faces, uv, fine, [[0, 1, 2], [0, 2, 3]], fine_colors=colors, resolution=32, height=16)
    assert baked.normals.shape == (16, 32, 3) and baked.colors.shape == (16, 32, 3)
    front = baked.texels == 2
    assert front.sum() == baked.report["chart_texels"] > 100
    assert baked.displacements[front] == pytest.approx(.01, rel=1e-5)
    assert baked.colors[front] == pytest.approx(.2, abs=1e-6)
    assert baked.normals[front] == pytest.approx(np.tile([0, 0, 1], (front.sum(), 1)), abs=1e-6)
    assert abf.bake(vertices, faces, uv, fine, [[0, 1, 2], [0, 2, 3]], resolution=32).colors is None


def stored(uv, bits):
    """Coordinates as programs store them: rounded to so many bits, of which the first are repeated in 16."""
    i = np.rint(uv * (2**bits - 1)).astype(np.int64)
    return (i << (16 - bits)) | (i >> (2 * bits - 16))


def test_packing_on_a_grid():
    charts = [meshes.hill(30, seed) for seed in range(5)]
    packing = abf.pack([(f, v[:, :2]) for v, f in charts], resolution=256, quantization_bits=10)
    faces_before = 0
    for (vertices, faces), uv in zip(charts, packing.uv):
        codes = stored(uv, 10)
        named = np.asarray(packing.report["faces_off_grid"], int) - faces_before
        faces_before += len(faces)
        held = np.ones(len(faces), bool)
        held[named[(0 <= named) & (named < len(faces))]] = False
        assert np.abs(uv - codes / 65535)[faces[held]].max() < 4e-8
        assert (signed_areas(codes.astype(float), faces[held]) > 0).all()
        assert held.mean() > 0.99
    with pytest.raises(ValueError, match="12 bits suffice"):
        abf.pack([(f, v[:, :2]) for v, f in charts], gutter=1, quantization_bits=8)


def test_atlas_on_a_grid():
    vertices, faces = meshes.sphere(seed=4)
    atlas = abf.atlas(vertices, faces, quantization_bits=12)
    codes = stored(atlas.uv, 12).reshape(-1, 3, 2)
    a, b = codes[:, 1] - codes[:, 0], codes[:, 2] - codes[:, 0]
    named = np.asarray(atlas.report["atlas"]["packing"]["faces_off_grid"], int) - 1
    assert (np.delete(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], named) > 0).all() and len(named) < len(faces) / 100
    with pytest.raises(ValueError, match="quantization_bits"):
        abf.atlas(vertices, faces, quantization_bits=12, pack_into_square=False)
