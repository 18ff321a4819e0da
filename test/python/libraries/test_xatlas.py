# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""angle_based_flattening.xatlas does what the module xatlas does, which runs beside it if it is there."""

import inspect
import re
import subprocess
import sys
import warnings
from pathlib import Path

import angle_based_flattening as abf
import angle_based_flattening.xatlas as ours
import numpy as np
import pytest

import meshes

EXAMPLES = Path(__file__).resolve().parents[3] / "examples/Angle_based_flattening/python"


@pytest.fixture(params=["ours", "theirs"])
def xatlas(request):
    return ours if request.param == "ours" else pytest.importorskip("xatlas")


@pytest.fixture
def theirs():
    return pytest.importorskip("xatlas")


def public(thing):
    return {name for name in dir(thing) if not name.startswith("_")}


def test_names(theirs):
    """All that xatlas has is here, with the same defaults and the same parameters."""
    assert public(theirs) == set(ours.__all__)
    for name in ("Atlas", "Chart", "ChartOptions", "PackOptions"):
        instances = [getattr(module, name)() for module in (ours, theirs)] if name != "Chart" else []
        assert public(instances[0] if instances else ours.Chart(0, np.zeros(0))) == public(getattr(theirs, name))
        if name.endswith("Options"):
            for field in public(instances[0]):
                assert getattr(instances[0], field) == pytest.approx(getattr(instances[1], field)), field
            with pytest.raises(AttributeError):
                instances[0].unknown = 1
    told = {"parametrize": theirs.parametrize, "export": theirs.export}
    told |= {name: getattr(theirs.Atlas, name) for name in public(theirs.Atlas)
             if callable(getattr(theirs.Atlas, name))}
    for name, function in told.items():
        words = re.search(r"\((.*)\) ->", function.__doc__)[1]
        names = [word for word in re.findall(r"(\w+): ", re.sub(r"\[.*?\]|<.*?>", "", words)) if word != "self"]
        own = inspect.signature(getattr(ours, name, None) or getattr(ours.Atlas, name))
        assert [word for word in own.parameters if word != "self"] == names, name
    for kind in ours.ChartType:
        assert int(getattr(theirs.ChartType, kind.name)) == kind


def check_mesh(vertices, faces, result):
    vmapping, indices, uvs = result
    assert (vmapping.dtype, indices.dtype, uvs.dtype) == (np.uint32, np.uint32, np.float32)
    assert np.array_equal(vmapping[indices], faces) and len(uvs) == len(vmapping)
    assert uvs.min() >= 0 and uvs.max() <= 1


def test_several_meshes(xatlas, capsys):
    models = [meshes.sphere(2), meshes.torus(), meshes.hill()]
    atlas = xatlas.Atlas()
    for vertices, faces in models:
        atlas.add_mesh(vertices, faces, normals=vertices)
    with pytest.raises(IndexError):
        atlas.get_mesh(0)
    assert len(atlas) == 0
    options = xatlas.PackOptions()
    options.padding, options.resolution, options.create_image = 2, 256, True
    atlas.generate(xatlas.ChartOptions(), options, True)
    assert len(atlas) == atlas.mesh_count == 3 and atlas.atlas_count == 1
    for (vertices, faces), result in zip(models, atlas):
        check_mesh(vertices, faces, result)
    assert abs(atlas.width - 256) < 50 and abs(atlas.height - 256) < 50 and atlas.texels_per_unit > 0
    assert .3 < atlas.utilization == atlas.get_utilization(0) < 1
    assert atlas.chart_image.shape == (atlas.height, atlas.width, 3) and atlas.chart_image.dtype == np.uint8
    if xatlas is ours:  # the other one counts its padding
        assert np.any(atlas.chart_image > 0, axis=2).mean() == pytest.approx(atlas.utilization, abs=.02)
        assert f"Charts: {atlas.chart_count}\nSize: 256x256\n" in capsys.readouterr().out
    counts = [atlas.get_mesh_chart_count(i) for i in range(3)]
    assert sum(counts) == atlas.chart_count
    for i, (_, faces) in enumerate(models):
        pages, charts = atlas.get_mesh_vertex_assignment(i)
        assert pages.dtype == charts.dtype == np.uint32 and not pages.any()
        assert charts.min() == sum(counts[:i]) and charts.max() == sum(counts[:i + 1]) - 1
        of_faces = charts[atlas[i][1]]
        assert (of_faces == of_faces[:, :1]).all()
        parts = [atlas.get_mesh_chart(i, k) for k in range(counts[i])]
        assert sorted(np.concatenate([part.faces for part in parts])) == list(range(len(faces)))
        assert all(part.faces.dtype == np.uint32 and part.atlas_index == 0 == part.material for part in parts)
    for call in (lambda: atlas[3], lambda: atlas.get_utilization(1), lambda: atlas.get_mesh_chart(0, 99),
                 lambda: atlas.get_mesh_chart_count(3), lambda: atlas.get_chart_image(1)):
        with pytest.raises(IndexError):
            call()


def test_certificate():
    """Each page is injective, also in float32."""
    vertices, faces = meshes.torus(40, 30)
    _, indices, uvs = ours.parametrize(vertices, faces)
    assert abf.certify(vertices, faces, uvs[indices].reshape(-1, 2).astype(float))


def test_pages(xatlas):
    """With a resolution and texels per unit, there are several pages, each of which is a unit square."""
    vertices, faces = meshes.sphere(2)
    atlas = xatlas.Atlas()
    atlas.add_mesh(vertices, faces)
    options = xatlas.PackOptions()
    options.resolution, options.texels_per_unit = 256, 150
    atlas.generate(pack_options=options)
    assert atlas.atlas_count > 1 and atlas.texels_per_unit == pytest.approx(150)
    check_mesh(vertices, faces, atlas[0])
    pages, charts = atlas.get_mesh_vertex_assignment(0)
    assert set(pages) == set(range(atlas.atlas_count))
    assert all(0 < atlas.get_utilization(i) <= 1 for i in range(atlas.atlas_count))
    _, indices, uvs = atlas[0]
    if xatlas is ours:
        for page in set(pages):
            own = np.flatnonzero(pages[indices[:, 0]] == page)
            assert abf.certify(vertices, faces[own], uvs[indices[own]].reshape(-1, 2).astype(float))


def test_size_of_one_page(xatlas):
    """With texels per unit alone, the page is as large as it has to be."""
    vertices, faces = meshes.sphere(2)
    atlas = xatlas.Atlas()
    atlas.add_mesh(vertices, faces)
    options = xatlas.PackOptions()
    options.texels_per_unit, options.blockAlign = 60, True
    atlas.generate(pack_options=options)
    assert atlas.atlas_count == 1 and atlas.texels_per_unit == pytest.approx(60, rel=.02)
    assert 200 < atlas.width < 500 and (xatlas is not ours or atlas.width % 4 == 0)
    with pytest.raises(RuntimeError, match="does not have an image"):
        atlas.chart_image


def test_given_charts():
    """Charts of given coordinates keep their shapes."""
    vertices, faces = meshes.torus()
    vmapping, indices, uvs = ours.parametrize(vertices, faces)
    atlas = ours.Atlas()
    atlas.add_mesh(vertices[vmapping], indices, uvs=uvs)
    options = ours.ChartOptions()
    options.use_input_mesh_uvs = True
    atlas.generate(options)
    (a, b), (c, d) = ((t[:, i] - t[:, 0] for i in (1, 2)) for t in (atlas[0][2][atlas[0][1]], uvs[indices]))
    ratios = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / (c[:, 0] * d[:, 1] - c[:, 1] * d[:, 0])
    assert np.allclose(ratios, np.median(ratios), rtol=1e-2)


def test_uv_meshes(xatlas):
    _, indices, uvs = ours.parametrize(*meshes.torus())
    atlas = xatlas.Atlas()
    atlas.add_uv_mesh(uvs, indices)
    atlas.generate()
    check_mesh(None, indices, atlas[0])
    assert atlas.chart_count >= 1


def test_faces_without_chart(xatlas):
    vertices, faces = meshes.sphere(2)
    faces = np.concatenate([faces, [[0, 0, 1]]])
    atlas = xatlas.Atlas()
    atlas.add_mesh(vertices, faces)
    atlas.generate()
    check_mesh(vertices, faces, atlas[0])
    vmapping, indices, uvs = atlas[0]
    assert not uvs[indices[-1]].any()
    if xatlas is ours:
        pages, charts = atlas.get_mesh_vertex_assignment(0)
        assert (pages[indices[-1]] == 2**32 - 1).all() and (charts[indices[-1]] == 2**32 - 1).all()


def test_wrong_arrays(xatlas):
    vertices, faces = meshes.sphere(1)
    for words in ({"positions": vertices[:, :2]}, {"indices": faces[:, :2]}, {"normals": vertices[:5]},
                  {"uvs": vertices}, {"uvs": vertices[:5, :2]}):
        with pytest.raises(ValueError):
            xatlas.parametrize(**{"positions": vertices, "indices": faces, **words})
    with pytest.raises((ValueError, RuntimeError)):
        xatlas.parametrize(vertices, faces + 1000)
    check_mesh(vertices, faces, xatlas.parametrize(vertices.tolist(), faces.astype(float)))


def test_warnings():
    """Options that have no effect are named, and only if they are set."""
    atlas = ours.Atlas()
    atlas.add_mesh(*meshes.sphere(1))
    charts, packing = ours.ChartOptions(), ours.PackOptions()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        atlas.generate(charts, packing)
    charts.max_cost, packing.bruteForce = 8, True
    with pytest.warns(UserWarning) as told:
        atlas.generate(charts, packing)
    assert [str(w.message) for w in told] == ["ChartOptions.max_cost is 8, and has no effect here",
                                              "PackOptions.bruteForce is True, and has no effect here"]
    with pytest.warns(UserWarning, match="no meshes"):
        ours.Atlas().generate()


def test_added_later():
    """A mesh may be added after others have their atlas, which stays until the next one is made."""
    atlas = ours.Atlas()
    atlas.add_mesh(*meshes.sphere(1))
    atlas.generate()
    atlas.add_mesh(*meshes.hill())
    assert len(atlas) == 1
    atlas.generate()
    assert len(atlas) == 2


@pytest.mark.parametrize("has_normals", [False, True])
@pytest.mark.parametrize("has_uvs", [False, True])
def test_export(theirs, tmp_path, has_normals, has_uvs):
    """Files say the same."""
    vertices, faces = meshes.sphere(1)
    more = {"normals": vertices} if has_normals else {}
    more |= {"uvs": vertices[:, :2]} if has_uvs else {}
    texts = []
    for module in ours, theirs:
        module.export(str(tmp_path / "a.obj"), vertices, faces, **more)
        texts.append([line.split() for line in (tmp_path / "a.obj").read_text().splitlines() if line.strip()])
    assert [line[0] for line in texts[0]] == [line[0] for line in texts[1]]
    for a, b in zip(*texts):
        assert a == b if a[0] == "f" else np.allclose(np.array(a[1:], float), np.array(b[1:], float), atol=1e-5)
    ours.export(tmp_path / "points.obj", vertices)
    assert (tmp_path / "points.obj").read_text().count("v ") == len(vertices)


@pytest.mark.parametrize("name", ["colors", "positions", "meshes"])
def test_scripts(xatlas, tmp_path, name):
    """Scripts of pipelines run with either module; one import differs."""
    text = (EXAMPLES / f"xatlas_{name}.py").read_text()
    own = "import angle_based_flattening.xatlas as xatlas"
    assert text.count(own) == 1
    if xatlas is not ours:
        text = text.replace(own, "import xatlas").replace("Path(__file__)", f"Path({str(EXAMPLES / 'x')!r})")
        (tmp_path / "script.py").write_text(f"import sys\nsys.path.insert(0, {str(EXAMPLES)!r})\n{text}")
    script = EXAMPLES / f"xatlas_{name}.py" if xatlas is ours else tmp_path / "script.py"
    done = subprocess.run([sys.executable, script], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    if name == "colors":
        assert lines[1] == "same faces: True" and "\nvt " in (tmp_path / "textured.obj").read_text()
        made = np.load(tmp_path / "textured.npz")
        assert np.allclose(made["colors"], (made["normals"] + 1) / 2) and len(made["uvs"]) == len(made["positions"])
    elif name == "positions":
        assert lines[1] == "within the box of the mesh: True"
        assert np.load(tmp_path / "positions.npy").shape[2] == 3
    else:
        assert lines[0].startswith("2 meshes, ") and [line[-4:] for line in lines[1:]] == ["1.00"] * 2
