# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Notebooks, bars of progress, modules that are run, examples in docstrings, and types."""

import doctest
import importlib
import io
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import angle_based_flattening as abf
import numpy as np
import pytest
from angle_based_flattening import check

import meshes
from common import PYPROJECT, ROOT

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def plt():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    yield plt
    plt.close("all")


@pytest.mark.parametrize("name", sorted(meshes.ALL))
def test_show(plt, name):
    """Each face with a chart is drawn, at its place and in the colour of its chart."""
    atlas = abf.atlas(*meshes.ALL[name]())
    axes = atlas.show()
    drawn, = axes.collections
    paths, has_chart = drawn.get_paths(), atlas.face_chart >= 0
    assert len(paths) == has_chart.sum() and axes.get_xlim() == (0, 1)
    ends = np.concatenate([path.vertices[:-1] for path in paths])
    assert np.allclose(ends, atlas.uv[~np.isnan(atlas.uv[:, 0])])
    assert len(np.unique(drawn.get_facecolors(), axis=0)) == min(len(set(atlas.face_chart[has_chart])), 20)
    assert axes.get_title().startswith(f"{len(has_chart)} faces, ")
    other = plt.subplots()[1]
    assert atlas.show(other) is other
    axes.figure.savefig(io.BytesIO())


def test_show_without_matplotlib(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match="needs matplotlib: pip install matplotlib"):
        abf.atlas(*meshes.hill()).show()


def picture(atlas):
    text = atlas._repr_html_()
    root = ElementTree.fromstring(text)
    svg, line = root
    return text, [path for path in svg.iter(SVG + "path")], line.text


def area(path):
    """What a path of straight loops encloses, in square pixels"""
    total = 0
    for loop in path.get("d").strip("M").split("M"):
        x, y = np.array([point.split() for point in loop.rstrip("Z").split("L")], float).T
        total += (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
    return abs(total)


@pytest.mark.parametrize("name", sorted(meshes.ALL))
def test_notebooks(name):
    """Borders of charts enclose what charts cover."""
    atlas = abf.atlas(*meshes.ALL[name]())
    text, (*borders, edges), line = picture(atlas)
    assert len(borders) == len(set(atlas.face_chart[atlas.face_chart >= 0]))
    assert edges.get("d").count("M") == (atlas.face_chart >= 0).sum()
    share = sum(map(area, borders)) / 400**2
    assert share == pytest.approx(atlas.report["atlas"]["packing"]["texel_density"], abs=.03)
    assert "injective" in line and ("1 without chart" in line) == (name == "soup")


def test_large_notebooks():
    """The size is bounded, and holes are there."""
    vertices, faces = meshes.torus(150, 100)
    atlas = abf.atlas(vertices, faces)
    text, borders, _ = picture(atlas)
    assert len(text) < 300_000 and len(borders) == len(set(atlas.face_chart))
    vertices, faces = meshes.hill(30)
    ring = faces[~(np.abs(vertices[faces][..., :2] - .5) < .2).all(axis=(1, 2))]
    kept = abf.atlas(vertices, ring, uv=vertices[ring.ravel(), :2], given_charts="keep")
    _, (border, _), _ = picture(kept)
    assert border.get("d").count("M") == 2 and border.get("fill-rule") == "evenodd"


def test_pages_in_notebooks():
    atlas = abf.atlas(*meshes.sphere(2), texels_per_unit=200, resolution=256)
    _, _, line = picture(atlas)
    assert f"{atlas.report['atlas']['packing']['pages']} pages" in line
    assert "1 chart, injective" in picture(abf.atlas(*meshes.hill(), pack_into_square=False))[2]


def test_bar(capsys):
    pytest.importorskip("tqdm")
    vertices, faces = meshes.torus(60, 40)
    bare = abf.atlas(vertices, faces, progress=False)
    assert capsys.readouterr().err == ""
    assert np.array_equal(abf.atlas(vertices, faces, progress=True).uv, bare.uv)
    told = capsys.readouterr().err
    assert "charts" in told and "%|" in told
    abf.flatten(*meshes.hill(40), progress=True)
    with pytest.raises(abf.MeshError):
        abf.flatten(vertices, faces, progress=True)
    assert capsys.readouterr().err.rstrip(" ").endswith("\r")  # nothing is left of it


def test_bar_without_tqdm(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.raises(ImportError, match="progress=True needs tqdm: pip install tqdm"):
        abf.atlas(*meshes.hill(), progress=True)
    with pytest.raises(TypeError, match="or True for a bar"):
        abf.atlas(*meshes.hill(), progress=3)


def test_program(tmp_path):
    """The module is the program: it hands over its words, and the exit status."""
    vertices, faces = meshes.hill()
    lines = [f"v {x} {y} {z}" for x, y, z in vertices.tolist()] + [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    (tmp_path / "a.obj").write_text("\n".join(lines) + "\n")
    command = [sys.executable, "-m", "angle_based_flattening", "a.obj", "-o", "b.obj"]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True).returncode == 0
    assert "\nvt " in (tmp_path / "b.obj").read_text()
    command[3] = "missing.obj"
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 2 and "missing.obj" in done.stderr


def test_check(capsys, monkeypatch):
    done = subprocess.run([sys.executable, "-m", "angle_based_flattening.check"], capture_output=True, text=True)
    assert done.returncode == 0 and "all checks passed" in done.stdout and np.__version__ in done.stdout
    monkeypatch.setattr(abf, "certify", lambda *_: False)
    assert check.main() == 1
    told = capsys.readouterr()
    assert "check_atlas failed: AssertionError: the atlas is not injective" in told.err and "passed" not in told.out


@pytest.mark.parametrize("name", ["_atlas", "_charts", "_unwrap", "xatlas"])
def test_docstrings(name):
    result = doctest.testmod(importlib.import_module(f"angle_based_flattening.{name}"))
    assert result.attempted > 0 and result.failed == 0


USER = """
import numpy as np
from numpy.typing import NDArray
from typing import Any
import angle_based_flattening as abf

v = np.eye(3)
f = np.array([[0, 1, 2]])
one: abf.Atlas = abf.atlas(v, f, resolution=256)
several: list[abf.Atlas] = abf.atlas([v, v], [f, f])
uv: NDArray[np.float64] = abf.flatten(v, f).uv
vmapping, indices, uvs = abf.parametrize(v, f)
faces: NDArray[np.int64] = abf.certify(v, f, uv).flipped
charts: list[NDArray[np.float64]] = abf.pack([(f, uv)]).uv
wrong: str = one.uv
"""


def test_types(tmp_path):
    """The package is typed, and so is what a user writes with it."""
    pytest.importorskip("mypy")
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path / "cache")]
    settings = ["--config-file", str(PYPROJECT)]
    done = subprocess.run([*mypy, *settings, "python/angle_based_flattening"], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout
    (tmp_path / "user.py").write_text(USER)
    done = subprocess.run([*mypy, *settings, "user.py"], cwd=tmp_path, capture_output=True, text=True)
    assert "Found 1 error in 1 file" in done.stdout and "user.py:15: error" in done.stdout, done.stdout
