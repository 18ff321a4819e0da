# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of all kinds give the same result, and wrong arguments are errors that name them."""

import angle_based_flattening as abf
import meshes
import numpy as np
import program
import pytest

VERTICES, FACES = meshes.hill(7)
UV = abf.flatten(VERTICES, FACES).uv
ATLAS = abf.atlas(VERTICES, FACES)


def read_only(array):
    result = array.copy()
    result.flags.writeable = False
    return result


def strided(array):
    """Every second row and column of a larger array, from the end"""
    larger = np.zeros((2 * array.shape[0], 2 * array.shape[1]), array.dtype)
    larger[::-2, ::-2] = array
    return larger[::-2, ::-2]


LAYOUTS = {"read-only": read_only, "strided": strided, "columns first": np.asfortranarray, "lists": np.ndarray.tolist,
           "big-endian": lambda a: a.astype(a.dtype.newbyteorder(">"))}


@pytest.mark.parametrize("change", LAYOUTS.values(), ids=LAYOUTS)
def test_layouts(change):
    vertices, faces = change(VERTICES), change(FACES)
    atlas = abf.atlas(vertices, faces)
    assert program.same_bits(atlas.uv, ATLAS.uv) and np.array_equal(atlas.seams, ATLAS.seams)
    uv = abf.flatten(vertices, faces).uv
    assert program.same_bits(uv, UV)
    assert abf.certify(vertices, faces, change(uv))
    assert abf.measure(vertices, faces, change(uv)) == abf.measure(VERTICES, FACES, UV)


@pytest.mark.parametrize("kind", np.typecodes["AllInteger"])
def test_integers(kind):
    faces = FACES.astype(kind)
    assert program.same_bits(abf.atlas(VERTICES, faces).uv, ATLAS.uv)
    assert abf.parametrize(VERTICES, faces)[1].dtype == np.uint32


def test_floats():
    single = VERTICES.astype(np.float32)
    uv = abf.flatten(single, FACES).uv
    assert uv.dtype == np.float64 and program.same_bits(uv, abf.flatten(single.astype(np.float64), FACES).uv)
    assert program.same_bits(uv, abf.flatten(single.astype(">f4"), FACES).uv)
    whole = np.round(100 * VERTICES)
    assert program.same_bits(abf.flatten(whole.astype(int), FACES).uv, abf.flatten(whole, FACES).uv)


def test_arguments_do_not_change():
    arrays = [VERTICES.copy(), FACES.copy(), ATLAS.uv.copy()]
    abf.atlas(arrays[0], arrays[1], uv=arrays[2], given_charts="keep")
    assert all(np.array_equal(a, b) for a, b in zip(arrays, (VERTICES, FACES, ATLAS.uv)))


def test_polygons_of_any_integers():
    vertices, (offsets, indices) = meshes.box()
    expected = abf.atlas(vertices, (offsets, indices)).uv
    for kind in (np.uint8, np.int16, np.uint64, ">i4"):
        assert program.same_bits(abf.atlas(vertices, (offsets.astype(kind), indices.astype(kind))).uv, expected)


@pytest.mark.parametrize("function", [abf.atlas, abf.flatten, abf.lscm, abf.seams, abf.parametrize])
def test_empty(function):
    for vertices in (VERTICES, np.zeros((0, 3))):
        for faces in (np.zeros((0, 3), int), []):
            with pytest.raises(abf.MeshError, match="EMPTY_MESH"):
                function(vertices, faces)


@pytest.mark.parametrize("function", [abf.flatten, abf.seams])
def test_points_that_are_no_numbers(function):
    for bad in (np.nan, np.inf):
        vertices = VERTICES.copy()
        vertices[17, 1] = bad
        with pytest.raises(abf.MeshError) as error:
            function(vertices, FACES)
        assert error.value.vertices.tolist() == [17]


def test_faces_at_points_that_are_no_numbers_have_no_chart():
    vertices = VERTICES.copy()
    vertices[17, 1] = np.nan
    atlas = abf.atlas(vertices, FACES)
    assert ((atlas.face_chart < 0) == (FACES == 17).any(axis=1)).all()


@pytest.mark.parametrize("function", [abf.flatten, abf.seams])
def test_sheets_that_meet_in_a_vertex(function):
    vertex = len(VERTICES) - 1
    vertices, faces = np.concatenate([VERTICES, VERTICES[1:] + 2]), np.concatenate([FACES, FACES + vertex])
    with pytest.raises(abf.MeshError) as error:
        function(vertices, faces)
    assert error.value.vertices.tolist() == [vertex]


WRONG_ARRAYS = [
    (dict(vertices=VERTICES[:, :2]), r"vertices has the shape \(49, 2\), and must have the shape \(n, 3\)"),
    (dict(vertices=VERTICES.ravel()), r"vertices has the shape \(147,\)"),
    (dict(vertices=[[0, 0, 0], [1, 1]]), "vertices is not an array of numbers"),
    (dict(vertices=VERTICES.astype(complex)), "vertices has elements of type complex128, and needs numbers"),
    (dict(vertices=VERTICES.astype(str)), "vertices has elements of type <U"),
    (dict(faces=FACES[:, :2]), r"faces has the shape \(72, 2\)"),
    (dict(faces=FACES.astype(float)), "faces has elements of type float64, and needs integers"),
    (dict(faces=np.where(FACES == 8, 49, FACES)), r"faces\[0, 2\] is 49, but there are 49 vertices"),
    (dict(faces=np.where(FACES == 8, -1, FACES)), r"faces\[0, 2\] is -1, but there are 49 vertices"),
    (dict(faces=np.where(FACES == 8, 2**40, FACES)), r"faces\[0, 2\] is 1099511627776, but there are 49 vertices"),
    (dict(faces=(np.array([0, 3, 7]), FACES[:2].ravel())), r"offsets\[2\] is 7"),
    (dict(faces=(np.array([0, 3, 5]), FACES[:2].ravel())), "offsets must begin with 0 and end with the number"),
    (dict(faces=(np.array([0, 6, 3]), FACES[:2].ravel())), r"offsets\[2\] is less than the one before"),
    (dict(faces=(np.array([], int), FACES[:2].ravel())), "offsets is empty"),
]
OF_ATLASES = [
    (dict(uv=UV), "uv has 49 rows, and must have one for each of the 216 corners"),
    (dict(marked_seams=[[0, 1, 2]]), r"marked_seams has the shape \(1, 3\)"),
    (dict(marked_seams=[[0, 49]]), r"marked_seams\[0, 1\] is 49, but there are 49 vertices"),
    (dict(marked_seams=[[0, 1], [0, 48]]), r"marked_seams\[1\]: vertices 0 and 48 are not the ends of an edge"),
    (dict(ignored_faces=np.zeros(5, bool)), r"ignored_faces is an array of bool with the shape \(5,\)"),
    (dict(ignored_faces=np.zeros(72)), "ignored_faces is an array of float64"),
]


@pytest.mark.parametrize("given, message", WRONG_ARRAYS)
@pytest.mark.parametrize("function", [abf.atlas, abf.flatten])
def test_wrong_arrays(function, given, message):
    with pytest.raises(ValueError, match=message):
        function(**{"vertices": VERTICES, "faces": FACES, **given})


@pytest.mark.parametrize("given, message", OF_ATLASES)
def test_wrong_arrays_of_atlases(given, message):
    with pytest.raises(ValueError, match=message):
        abf.atlas(VERTICES, FACES, **given)


def test_several_meshes_are_named():
    with pytest.raises(ValueError, match=r"faces of mesh 1\[0, 0\] is 50, but there are 49 vertices"):
        abf.atlas([VERTICES, VERTICES], [FACES, FACES + 50])
    with pytest.raises(ValueError, match="faces must be a list with an entry for each of the 2 meshes"):
        abf.atlas([VERTICES, VERTICES], [FACES])


WRONG_OPTIONS = [
    (dict(purpose="film"), ValueError, "purpose is 'film', and must be one of texture, few-charts, conformal"),
    (dict(seams="creases:200"), ValueError, "seams is 'creases:200', and must be one of auto, length"),
    (dict(seams="nowhere"), ValueError, "seams is 'nowhere'"),
    (dict(given_charts="keep"), ValueError, "uv is not given"),
    (dict(given_charts="burn"), ValueError, "given_charts is 'burn'"),
    (dict(resolution=0), ValueError, "resolution is 0, and must be from 1 to 32768"),
    (dict(resolution=40000), ValueError, "resolution is 40000"),
    (dict(resolution=10**30), ValueError, "resolution is 1e.30"),
    (dict(resolution=1024.5), TypeError, "resolution is a float, and must be an integer"),
    (dict(height=-1), ValueError, "height is -1"),
    (dict(gutter=257), ValueError, "gutter is 257, and must be from 0 to 256"),
    (dict(block=0), ValueError, "block is 0"),
    (dict(block=7), ValueError, "block of 7 texels does not divide the 1024 texels"),
    (dict(number_of_rotations=0), ValueError, "number_of_rotations is 0"),
    (dict(threads=-1), ValueError, "threads is -1, and must be from 0 to 1024"),
    (dict(stretch_bound=.9), ValueError, "stretch_bound is 0.9, and must be at least 1"),
    (dict(stretch_bound=float("nan")), ValueError, "stretch_bound is nan"),
    (dict(area_weight=1.5), ValueError, "area_weight is 1.5, and must be from 0 to 1"),
    (dict(seam_price="high"), TypeError, "seam_price is a str, and must be a number"),
    (dict(texels_per_unit=-1), ValueError, "texels_per_unit is -1"),
    (dict(weld=1), TypeError, "weld is a int, and must be True or False"),
    (dict(isometric_charts="on"), TypeError, "isometric_charts is a str"),
    (dict(timeout=0), ValueError, "timeout is 0, and must be above 0"),
    (dict(time_limit=1), TypeError, "time_limit"),
    (dict(progress=3), TypeError, "progress must be a function"),
    (dict(colour="red"), TypeError, "colour"),
    (dict(pack_into_square=False, seam_price=.1), ValueError, "seam_price is given, and goes without"),
    (dict(pack_into_square=False, texels_per_unit=3), ValueError, "texels_per_unit is given, and goes without"),
    (dict(uv=ATLAS.uv, given_charts="keep", stretch_bound=1.2), ValueError, "stretch_bound is given, and goes without"),
    (dict(uv=ATLAS.uv, given_charts="repair", seams="length"), ValueError, "seams is given, and goes without"),
]


@pytest.mark.parametrize("given, kind, message", WRONG_OPTIONS)
def test_wrong_options(given, kind, message):
    with pytest.raises(kind, match=message) as error:
        abf.atlas(VERTICES, FACES, **given)
    assert not isinstance(error.value, abf.MeshError)


WRONG_OPTIONS_OF_MAPS = [
    (dict(method="magic"), ValueError, "method is 'magic'"),
    (dict(sweeps=3), TypeError, "'sweeps' is not an option of the direct method"),
    (dict(method="hierarchical", tolerance=1e-3), TypeError, "'tolerance' is not an option of the hierarchical method"),
    (dict(method="hierarchical", sweeps=2000), ValueError, "sweeps is 2000, and must be from 0 to 1000"),
    (dict(max_iterations=-1), ValueError, "max_iterations is -1"),
    (dict(holes="ignore"), ValueError, "holes is 'ignore'"),
    (dict(area_weight=.5), ValueError, "area_weight would have no effect"),
    (dict(pin_weight=.5), ValueError, "pin_weight would have no effect"),
    (dict(equal_seam_lengths=True), ValueError, "equal_seam_lengths would have no effect"),
    (dict(injective=True, area_weight=.5, tolerance=1e-3), ValueError, "tolerance would have no effect"),
    (dict(method="hierarchical", energy_tolerance=.5), ValueError, "energy_tolerance would have no effect"),
    (dict(method="hierarchical", injective=True, coarse_triangles=500), ValueError,
     "coarse_triangles would have no effect"),
    (dict(boundary="rectangle"), ValueError, "a rectangle needs either corners or aspect_ratio"),
    (dict(boundary="rectangle", corners=[0, 1, 2]), ValueError, r"corners are \[0, 1, 2\], and must be four vertices"),
    (dict(boundary="rectangle", corners=[0, 6, 48, 490]), ValueError, "490"),
    (dict(pins=([0, 1], [[0, 0]])), ValueError, r"the values of pins have the shape \(1, 2\)"),
    (dict(pins=([0, 100], [[0, 0], [1, 1]])), ValueError, "100, but there are 49 vertices"),
]


@pytest.mark.parametrize("given, kind, message", WRONG_OPTIONS_OF_MAPS)
def test_wrong_options_of_maps(given, kind, message):
    with pytest.raises(kind, match=message) as error:
        abf.flatten(VERTICES, FACES, **given)
    assert not isinstance(error.value, abf.MeshError)


def test_surfaces_that_are_no_disks():
    with pytest.raises(abf.MeshError, match="NO_BORDER"):
        abf.flatten(*meshes.torus())
    with pytest.raises(abf.MeshError) as error:
        abf.flatten(np.concatenate([VERTICES, [[0, 0, 1]]]), np.concatenate([FACES, [[0, 8, 49]]]))
    assert error.value.status == "NON_MANIFOLD_EDGE" and error.value.faces.size > 0
    with pytest.raises(abf.MeshError) as error:
        abf.flatten(VERTICES, np.concatenate([FACES, [[5, 5, 6]]]))
    assert error.value.status == "DEGENERATE_FACE" and error.value.faces.tolist() == [72]
    with pytest.raises(abf.MeshError):
        abf.atlas(VERTICES, [[5, 5, 6]])


def test_vertices_are_named_by_number_and_point():
    """Messages count from 1 and arrays from 0, whichever part of the package finds the fault."""
    wrong = VERTICES.copy()
    wrong[16] = (0.5, np.nan, 3)
    flattener = abf.Flattener(FACES)
    flattener.solve(VERTICES)
    for function in (lambda: abf.flatten(wrong, FACES), lambda: flattener.solve(wrong),
                     lambda: abf.seams(wrong, FACES)):
        with pytest.raises(abf.MeshError, match=r"vertex 17 \(0.5, nan, 3\) has coordinates") as error:
            function()
        assert error.value.status == "NON_FINITE_POINT" and error.value.vertices.tolist() == [16]
    with pytest.raises(abf.MeshError, match=r"vertex 17 \([^()]*\) is a corner"):
        abf.flatten(VERTICES, FACES, boundary="rectangle", corners=[0, 16, 48, 42])

    atlas = abf.atlas(wrong, FACES)
    [part] = atlas.report["skipped"]
    assert part["vertices"] == [17] and part["message"].startswith("vertex 17 (0.5, nan, 3) has coordinates")
    assert np.array_equal(atlas.face_chart < 0, (np.asarray(FACES) == 16).any(axis=1))
    with pytest.raises(abf.MeshError) as error:
        abf.atlas(np.full_like(VERTICES, np.nan), FACES)
    assert error.value.status == "NON_FINITE_POINT" and error.value.vertices.tolist() == list(range(49))


def test_random_faces():
    """Any indices give a result or an error that is documented."""
    random = np.random.default_rng(1)
    results = 0
    for _ in range(40):
        points = random.normal(size=(random.integers(3, 12), 3))
        faces = random.integers(-1 if random.random() < .1 else 0, len(points), (random.integers(1, 20), 3))
        try:
            atlas = abf.atlas(points, faces, resolution=64)
        except ValueError as error:
            assert str(error)
            continue
        results += 1
        assert np.array_equal(np.isfinite(atlas.uv.reshape(-1, 6)).all(axis=1), atlas.face_chart >= 0)
    assert results > 20
