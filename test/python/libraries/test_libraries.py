# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""unwrap() with the real libraries, and the files that these then write. A library that is not there is skipped."""

import copy
import os
import subprocess
import sys
import warnings

import angle_based_flattening as abf
import numpy as np
import pytest
from angle_based_flattening import _core

import meshes  # of the folder above: see conftest.py
from common import PYPROJECT, check


def mixed():
    """Quads and triangles: a box whose last side is divided."""
    vertices, (_, indices) = meshes.box()
    quads = indices.reshape(-1, 4)
    a, b, c, d = quads[-1]
    return vertices, quads[:-1], np.array([(a, b, c), (a, c, d)])


class TestTrimesh:
    @pytest.fixture
    def trimesh(self):
        return pytest.importorskip("trimesh")

    @pytest.mark.parametrize("colored", ["vertex", "face", None])
    def test_all_is_kept(self, trimesh, torus, colored):
        colors = {"vertex": {"vertex_colors": torus.colors}, "face": {"face_colors": torus.colors[:1].repeat(768, 0)}}
        mesh = trimesh.Trimesh(torus.vertices, torus.faces, process=False, metadata={"name": "ring"},
                               face_attributes={"q": np.arange(768)}, vertex_attributes={"t": torus.vertices[:, :2]},
                               **colors.get(colored, {}))
        before = hash(mesh), mesh.visual.kind, mesh.vertex_normals.copy()
        new, atlas = abf.unwrap(mesh, return_atlas=True)
        assert type(new) is trimesh.Trimesh and (hash(mesh), mesh.visual.kind) == before[:2]
        check(atlas, torus.faces, torus.faces, torus.vertices, new.vertices, new.faces,
              new.visual.uv[new.faces.ravel()])
        corners, old = new.faces.ravel(), torus.faces.ravel()
        assert np.allclose(new.vertex_normals[corners], before[2][old])
        assert np.array_equal(new.vertex_attributes["t"][corners], torus.vertices[old, :2])
        assert np.array_equal(new.face_attributes["q"], np.arange(768)) and new.metadata["name"] == "ring"
        if colored == "vertex":
            assert np.array_equal(new.visual.vertex_attributes["color"][corners], torus.colors[old])
        if colored == "face":
            assert np.array_equal(new.face_attributes["color"], mesh.visual.face_colors)

    def test_files(self, trimesh, torus, tmp_path):
        new = abf.unwrap(trimesh.Trimesh(torus.vertices, torus.faces, process=False, vertex_colors=torus.colors))
        for kind in ("glb", "obj", "ply"):
            new.export(tmp_path / f"a.{kind}")
            again, = trimesh.load_scene(tmp_path / f"a.{kind}", process=False).geometry.values()
            assert np.abs(again.visual.uv[again.faces] - new.visual.uv[new.faces]).max() < 1e-5, kind
            if kind == "glb":  # which is the kind that has colours beside coordinates
                assert np.array_equal(again.visual.vertex_attributes["color"], torus.colors[matching(new, torus)])

    def test_own_coordinates(self, trimesh, torus):
        """The charts that a mesh has already are kept, if that is wanted."""
        first, atlas = abf.unwrap(trimesh.Trimesh(torus.vertices, torus.faces, process=False), return_atlas=True)
        _, kept = abf.unwrap(first, return_atlas=True, given_charts="keep", resolution=256)
        assert kept.face_chart.max() == atlas.face_chart.max()
        with pytest.raises(ValueError, match="uv is not given"):
            abf.unwrap(trimesh.creation.box(), given_charts="keep")

    def test_derived_class(self, trimesh):
        class Own(trimesh.Trimesh):
            pass

        box = trimesh.creation.box()
        assert abf.unwrap(Own(box.vertices, box.faces)).visual.kind == "texture"

    def test_scene(self, trimesh):
        with pytest.raises(TypeError, match="mesh is a Scene: it has no attribute 'vertices'"):
            abf.unwrap(trimesh.Scene([trimesh.creation.box()]))

    def test_faces_without_chart(self, trimesh, torus):
        faces = np.concatenate([torus.faces, [[5, 5, 6]]])
        mesh = trimesh.Trimesh(torus.vertices, faces, process=False)
        with pytest.warns(UserWarning, match="1 of 769 faces have no chart"):
            new = abf.unwrap(mesh)
        assert not new.visual.uv[new.faces[-1]].any() and np.isfinite(new.visual.uv).all()
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # for faces that were to be left out
            abf.unwrap(mesh, ignored_faces=np.arange(769) == 768)


def matching(new, old):
    """The old vertex at each new one's place"""
    places = {tuple(p): i for i, p in enumerate(old.vertices.tolist())}
    return [places[tuple(p)] for p in np.asarray(new.vertices).tolist()]


class TestPyVista:
    @pytest.fixture
    def pv(self):
        return pytest.importorskip("pyvista")

    @pytest.fixture
    def mesh(self, pv):
        """With polygons of two sizes, a line, a point that no face has, and data of all kinds"""
        vertices, quads, triangles = mixed()
        faces = np.concatenate([np.insert(quads, 0, 4, axis=1).ravel(), np.insert(triangles, 0, 3, axis=1).ravel()])
        mesh = pv.PolyData(np.concatenate([vertices, [[9, 9, 9]]]), faces=faces, lines=[2, 0, 8])
        mesh.point_data["height"] = mesh.points[:, 2]
        mesh.point_data["name"] = [f"p{i}" for i in range(9)]
        mesh.cell_data["number"] = np.arange(mesh.n_cells)
        mesh.field_data["who"] = ["a", "b"]
        mesh.point_data.active_scalars_name = "height"
        return mesh

    def test_all_is_kept(self, pv, mesh):
        before = mesh.copy()
        new, atlas = abf.unwrap(mesh, return_atlas=True)
        assert mesh == before and type(new) is pv.PolyData
        offsets = np.array([0, 4, 8, 12, 16, 20, 23, 26])
        points = np.delete(mesh.faces, offsets[:-1] + np.arange(7))
        indices = np.delete(new.faces, offsets[:-1] + np.arange(7))
        assert [len(f) for f in new.irregular_faces] == [4] * 5 + [3] * 2
        check(atlas, (offsets, points), points, mesh.points, new.points, indices,
              new.active_texture_coordinates[indices])
        assert np.array_equal(new.point_data["height"], new.points[:, 2]) and new.active_scalars_name == "height"
        assert [new["name"][i] for i in indices] == [mesh["name"][i] for i in points]
        assert np.array_equal(new.cell_data["number"], np.arange(8)) and list(new.field_data["who"]) == ["a", "b"]
        assert np.array_equal(new.points[new.lines[1:]], mesh.points[[0, 8]])
        assert new.points.dtype == mesh.points.dtype

    def test_files(self, pv, mesh, tmp_path):
        triangles = abf.unwrap(pv.Sphere(theta_resolution=12, phi_resolution=12))
        for kind in ("vtp", "vtk", "ply", "obj"):
            for new in (triangles, abf.unwrap(mesh)):
                new.save(tmp_path / f"a.{kind}")
                again = pv.read(tmp_path / f"a.{kind}")
                if kind in ("vtp", "vtk"):
                    assert np.array_equal(again.active_texture_coordinates, new.active_texture_coordinates), kind
                elif new is triangles:
                    mine, theirs = (m.active_texture_coordinates[m.regular_faces] for m in (new, again))
                    assert np.abs(mine - theirs).max() < 1e-5, kind

    def test_own_coordinates(self, pv):
        plane = pv.Plane(i_resolution=3, j_resolution=3)  # which comes with them
        new = abf.unwrap(plane, given_charts="keep")
        assert len(new.active_texture_coordinates) == plane.n_points == new.n_points

    def test_strips(self, pv):
        strips = pv.Sphere().strip()
        with pytest.raises(ValueError, match="triangulate"):
            abf.unwrap(strips)
        assert abf.unwrap(strips.triangulate()).active_texture_coordinates is not None

    def test_accessor(self, pv, mesh):
        if not hasattr(pv, "register_dataset_accessor"):
            pytest.skip("no accessors in this PyVista")
        import angle_based_flattening.pyvista  # noqa: F401, as without an installed package
        new, atlas = mesh.abf.unwrap(return_atlas=True, resolution=64)
        assert new.active_texture_coordinates is not None and len(atlas.uv) == 26
        assert mesh.abf.atlas(resolution=64).report["atlas"]["injective"]


    def test_entry_point(self, pv, tmp_path):
        """Where the package is installed, PyVista finds the accessor by itself."""
        if not hasattr(pv, "register_dataset_accessor"):
            pytest.skip("no accessors in this PyVista")
        tomllib = pytest.importorskip("tomllib")
        points = tomllib.loads(PYPROJECT.read_text())["project"]["entry-points"]
        information = tmp_path / "angle_based_flattening-0.dist-info"  # as an installation has it
        information.mkdir()
        (information / "METADATA").write_text("Metadata-Version: 2.1\nName: angle-based-flattening\nVersion: 0\n")
        (information / "entry_points.txt").write_text("".join(
            f"[{group}]\n" + "".join(f"{name} = {module}\n" for name, module in names.items())
            for group, names in points.items()))
        code = "import pyvista\nprint(pyvista.Sphere().abf.unwrap().active_texture_coordinates.shape[1])"
        path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
        done = subprocess.run([sys.executable, "-c", code], env={**os.environ, "PYTHONPATH": path}, capture_output=True,
                              text=True)
        assert done.stdout == "2\n", done.stderr


class TestMeshio:
    @pytest.fixture
    def meshio(self):
        return pytest.importorskip("meshio")

    @pytest.fixture
    def mesh(self, meshio):
        vertices, quads, triangles = mixed()
        cells = [("triangle", triangles[:1]), ("line", np.array([[0, 8]])), ("quad", quads),
                 ("triangle", triangles[1:])]
        points = np.concatenate([vertices, [[9, 9, 9]]])
        return meshio.Mesh(points, cells, {"height": points[:, 2]}, {"n": [np.arange(len(c)) for _, c in cells]},
                           point_sets={"ends": np.array([0, 8])})

    def test_all_is_kept(self, mesh):
        before = copy.deepcopy(mesh)
        new, atlas = abf.unwrap(mesh, return_atlas=True)
        assert np.array_equal(mesh.points, before.points) and list(mesh.point_data) == ["height"]
        assert [(c.type, len(c)) for c in new.cells] == [("triangle", 1), ("line", 1), ("quad", 5), ("triangle", 1)]
        points, indices = (np.concatenate([m.cells[i].data.ravel() for i in (0, 2, 3)]) for m in (mesh, new))
        check(atlas, (np.array([0, 3, 7, 11, 15, 19, 23, 26]), points), points, mesh.points, new.points, indices,
              new.point_data["obj:vt"][indices])
        assert np.array_equal(new.point_data["height"], new.points[:, 2])
        assert [c.tolist() for c in new.cell_data["n"]] == [c.tolist() for c in mesh.cell_data["n"]]
        assert np.array_equal(new.points[new.cells[1].data], mesh.points[mesh.cells[1].data])
        assert {tuple(p) for p in new.points[new.point_sets["ends"]].tolist()} == {(0, 0, 0), (9, 9, 9)}

    @pytest.mark.parametrize("kind", ["obj", "vtk", "vtu", "ply"])
    def test_files(self, meshio, mesh, tmp_path, kind):
        mesh.cells, mesh.cell_data = mesh.cells[2:3], {}
        new = abf.unwrap(mesh)
        meshio.write(tmp_path / f"a.{kind}", new)
        again = meshio.read(tmp_path / f"a.{kind}")
        quads = again.cells_dict["quad"]
        uv = again.point_data.get("obj:vt")
        if kind == "ply":
            uv = np.column_stack([again.point_data["s"], again.point_data["t"]])
        assert np.abs(uv[quads][..., :2] - new.point_data["s"][new.cells[0].data][..., None] * [1, 0]
                      - new.point_data["t"][new.cells[0].data][..., None] * [0, 1]).max() < 1e-6
        assert abf.unwrap(again, given_charts="keep").point_data["obj:vt"].shape == (len(new.points), 2)

    def test_no_faces(self, meshio):
        with pytest.raises(abf.MeshError) as raised:
            abf.unwrap(meshio.Mesh(np.eye(3), [("line", [[0, 1]])]))
        assert raised.value.status == "EMPTY_MESH"


class TestPairs:
    def test_igl(self, torus, tmp_path):
        """The arrays are what libigl reads of a file, and its functions take them."""
        igl = pytest.importorskip("igl")
        (uv, indices), atlas = abf.unwrap((torus.vertices, torus.faces), return_atlas=True)
        assert np.array_equal(uv[indices].reshape(-1, 2), atlas.uv) and indices.dtype == torus.faces.dtype
        assert (igl.doublearea(uv, indices) > 0).all()
        assert igl.boundary_facets(indices)[0].shape[0] > 0
        igl.writeOBJ(str(tmp_path / "a.obj"), torus.vertices, torus.faces, np.zeros((0, 3)),
                     np.zeros((0, 3), torus.faces.dtype), uv, indices)
        v, tc, _, f, ftc, _ = igl.readOBJ(str(tmp_path / "a.obj"))
        assert np.array_equal(f, torus.faces) and np.array_equal(ftc, indices) and np.abs(tc - uv).max() < 1e-6

    def test_pairs_and_objects(self, torus):
        uv, indices = abf.unwrap([torus.vertices.tolist(), torus.faces.tolist()])
        assert abf.certify(torus.vertices, torus.faces, uv[indices].reshape(-1, 2))
        assert np.array_equal(abf.unwrap(torus)[0], uv)  # which has `vertices` and `faces`
        vertices, (offsets, points) = meshes.box()
        uv, (new_offsets, indices) = abf.unwrap((vertices, (offsets, points)))
        assert np.array_equal(new_offsets, offsets) and abf.certify(vertices, (offsets, points), uv[indices])

    def test_errors(self, torus):
        class Foo:
            vertices = torus.vertices

        for mesh, text in ((Foo(), "mesh is a Foo: it has no attribute 'faces'"), (3, "mesh is an int: it has no "),
                           ((1, 2, 3), "a tuple of 3"), ("a.obj", "python -m angle_based_flattening")):
            with pytest.raises(TypeError, match=text):
                abf.unwrap(mesh)
        with pytest.raises(ValueError, match="there are 384 vertices"):
            abf.unwrap((torus.vertices, torus.faces + 1))
        with pytest.raises(TypeError, match="resolutoin"):
            abf.unwrap(torus, resolutoin=3)
        with pytest.raises(abf.MeshError) as raised:
            abf.unwrap((torus.vertices, [[0, 0, 1]]))
        assert raised.value.faces.tolist() == [0]


@pytest.fixture
def program(monkeypatch):
    """Where the compiled part is without run_program(), the program takes its place."""
    if not hasattr(_core, "run_program"):
        if not os.environ.get("ABF_FLATTEN_MESH"):
            pytest.skip("no run_program(), and ABF_FLATTEN_MESH, the path of the program, is not set")
        monkeypatch.setattr(_core, "run_program", lambda words: subprocess.run(
            [os.environ["ABF_FLATTEN_MESH"], *words], stderr=subprocess.DEVNULL).returncode, raising=False)


class TestGltf:
    @pytest.fixture
    def scene(self, torus, tmp_path):
        pygltflib = pytest.importorskip("pygltflib")
        trimesh = pytest.importorskip("trimesh")
        ring = trimesh.Trimesh(torus.vertices, torus.faces, process=False)
        trimesh.Scene({"ring": ring, "box": trimesh.creation.box()}).export(tmp_path / "a.glb")
        scene = pygltflib.GLTF2().load(tmp_path / "a.glb")
        scene.materials = [pygltflib.Material()]  # without one, trimesh reads no coordinates
        for mesh in scene.meshes:
            mesh.primitives[0].material = 0
        return scene

    def test_scene(self, program, scene, torus, tmp_path):
        import trimesh
        before, blob = scene.to_json(), scene.binary_blob()
        new = abf.unwrap(scene, resolution=256)
        assert type(new) is type(scene) and scene.to_json() == before and scene.binary_blob() == blob
        assert [mesh.name for mesh in new.meshes] == [mesh.name for mesh in scene.meshes]
        assert all(p.attributes.TEXCOORD_0 is not None for mesh in new.meshes for p in mesh.primitives)
        new.save(tmp_path / "b.glb")
        ring = trimesh.load(tmp_path / "b.glb", process=False).geometry["ring"]
        assert np.abs(ring.triangles - torus.vertices[torus.faces]).max() < 1e-6
        corners = ring.visual.uv[ring.faces].reshape(-1, 2)
        assert abf.certify(torus.vertices, torus.faces, corners) and 0 <= corners.min() <= corners.max() <= 1

    def test_files_beside_it(self, program, torus, tmp_path):
        """Buffers and pictures that a scene names are found in its own folder."""
        pygltflib = pytest.importorskip("pygltflib")
        trimesh = pytest.importorskip("trimesh")
        image = pytest.importorskip("PIL.Image").new("RGB", (4, 4), (255, 0, 0))
        visual = trimesh.visual.TextureVisuals(uv=torus.vertices[:, :2], image=image)
        mesh = trimesh.Trimesh(torus.vertices, torus.faces, process=False, visual=visual)
        (tmp_path / "scene").mkdir()
        for name, data in trimesh.exchange.gltf.export_gltf(trimesh.Scene([mesh])).items():
            (tmp_path / "scene" / name).write_bytes(data)
        scene = pygltflib.GLTF2().load(tmp_path / "scene/model.gltf")
        new = abf.unwrap(scene)
        assert len(new.images) == 1 and new.meshes[0].primitives[0].attributes.TEXCOORD_1 is not None  # the old one

    def test_errors(self, program, scene):
        with pytest.raises(ValueError, match="marked_seams is given, and does not go with glTF"):
            abf.unwrap(scene, marked_seams=[[0, 1]])
        with pytest.raises(ValueError, match="return_atlas"):
            abf.unwrap(scene, return_atlas=True)
        with pytest.raises(ValueError, match="resolution is 0, and must be from 1"):
            abf.unwrap(scene, resolution=0)
        scene.meshes[0].primitives.clear()
        scene.meshes[1].primitives.clear()
        with pytest.raises(abf.MeshError):
            abf.unwrap(scene)

    def test_options(self):
        from angle_based_flattening._gltf import arguments
        assert arguments({"resolution": 64, "height": 32, "given_charts": "repair", "isometric_charts": False,
                          "weld": True, "quantization_bits": 12, "timeout": None}) == [
            "--repack", "--repair-charts", "--resolution=64x32", "--isometric=off", "--weld=on", "--quantize=12"]


def test_no_library_is_imported():
    """Importing the package, and pairs of arrays, need numpy only."""
    code = ("import sys, angle_based_flattening as abf\nabf.unwrap(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))\n"
            "print({'trimesh', 'pyvista', 'meshio', 'open3d', 'pygltflib', 'matplotlib', 'tqdm'} & set(sys.modules))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"
