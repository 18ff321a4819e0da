# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the add-on computes without Blender: test_arrays.py. Needs NumPy."""

import sys
import threading
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: no NumPy")
    sys.exit(77)

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from abf_unwrap.atlas_tasks import new_seams, usable_seams
from abf_unwrap.islands import component_labels, islands_of
from abf_unwrap.job import Job, part_of
from abf_unwrap.mesh_arrays import MeshArrays, edge_flags
from abf_unwrap.stretch import angle_colours, area_colours, face_stretches, singular_values


def mesh_of(vertices, faces, uv=None):
    """A mesh of polygons, each a list of vertices; edges are numbered as they come."""
    corner_vertices = np.array([v for face in faces for v in face])
    ends = [(face[k], face[(k + 1) % len(face)]) for face in faces for k in range(len(face))]
    numbers = {}
    corner_edges = np.array([numbers.setdefault(frozenset(pair), len(numbers)) for pair in ends])
    edges = np.array([sorted(pair) for pair in numbers])
    return MeshArrays(
        "mesh",
        np.asarray(vertices, float),
        np.cumsum([0] + [len(face) for face in faces]),
        corner_vertices,
        corner_edges,
        edges,
        np.zeros(len(edges), bool),
        np.ones(len(faces), bool),
        uv,
    )


def grid(columns, rows, random=None):
    """Quads, some of them divided into triangles, in any order."""
    vertices = [(x, y, 0) for y in range(rows + 1) for x in range(columns + 1)]
    faces = []
    for y in range(rows):
        for x in range(columns):
            k = y * (columns + 1) + x
            quad = [k, k + 1, k + columns + 2, k + columns + 1]
            divided = random is not None and random.random() < 0.3
            faces += [quad[:3], [quad[0], quad[2], quad[3]]] if divided else [quad]
    if random is not None:
        random.shuffle(faces)
    return mesh_of(vertices, faces)


class Islands(unittest.TestCase):
    def test_components_of_random_graphs(self):
        random = np.random.default_rng(1)
        for _ in range(50):
            number = int(random.integers(1, 60))
            pairs = random.integers(0, number, (int(random.integers(0, 60)), 2))
            expected = np.arange(number)
            for _ in range(number):  # the plain way
                for a, b in pairs:
                    expected[a] = expected[b] = min(expected[a], expected[b])
            self.assertEqual(component_labels(number, pairs).tolist(), expected.tolist())

    def test_a_long_path(self):
        order = np.random.default_rng(2).permutation(20000)
        self.assertFalse(component_labels(20000, np.stack([order[1:], order[:-1]], 1)).any())

    def test_seams_divide(self):
        for seed in range(20):
            random = np.random.default_rng(seed)
            mesh = grid(6, 4, random)
            x = mesh.vertices[mesh.edges][:, :, 0]
            mesh.seams = (x == 2).all(axis=1)
            islands = islands_of(mesh)
            self.assertEqual(len(islands), 2)
            self.assertEqual(sorted(len(island.vertices) for island in islands), [15, 25])
            self.assertEqual(
                sorted(np.concatenate([island.faces for island in islands])), list(range(mesh.number_of_faces))
            )
            for island in islands:
                at_corners = island.vertices[island.corner_vertices]
                self.assertTrue(np.array_equal(at_corners, mesh.vertices[mesh.corner_vertices[island.corners]]))

    def test_a_seam_that_ends_inside_cuts_open(self):
        mesh = grid(4, 2)
        middle = mesh.vertices[mesh.edges]
        mesh.seams = (middle[:, :, 1] == 1).all(axis=1) & (middle[:, :, 0] <= 2).all(axis=1)
        islands = islands_of(mesh)
        self.assertEqual(len(islands), 1)
        self.assertEqual(len(islands[0].vertices), len(mesh.vertices) + 2)  # the end of the seam is not doubled

    def test_coordinates_divide(self):
        mesh = grid(5, 3, np.random.default_rng(3))
        mesh.uv = mesh.vertices[mesh.corner_vertices][:, :2].astype(np.float32)
        centre = np.array([mesh.uv[a:b].mean(axis=0) for a, b in zip(mesh.offsets, mesh.offsets[1:])])
        mesh.uv[(centre[:, 0] > 3)[mesh.corner_faces()]] += 10
        self.assertEqual(sorted(len(island.vertices) for island in islands_of(mesh, by_uv=True)), [12, 16])

    def test_only_chosen_faces(self):
        mesh = grid(3, 1)
        mesh.chosen[1] = False
        self.assertEqual([island.faces.tolist() for island in islands_of(mesh)], [[0], [2]])
        mesh.chosen[:] = False
        self.assertEqual(islands_of(mesh), [])

    def test_faces_with_opposite_orientations_and_three_at_an_edge(self):
        vertices = np.random.default_rng(4).random((5, 3))
        self.assertEqual(len(islands_of(mesh_of(vertices, [[0, 1, 2], [0, 1, 3]]))[0].vertices), 4)
        self.assertEqual(len(islands_of(mesh_of(vertices, [[0, 1, 2], [1, 0, 3], [0, 1, 4]]))), 3)


class Seams(unittest.TestCase):
    def test_pairs_in_either_direction(self):
        edges = np.array([[0, 1], [1, 2], [3, 2]])
        self.assertEqual(edge_flags(edges, np.array([[1, 0], [2, 3], [0, 3]]), 4).tolist(), [True, False, True])
        self.assertFalse(edge_flags(edges, np.zeros((0, 2), int), 4).any())

    def test_seams_of_other_faces_stay(self):
        mesh = grid(4, 1)
        mesh.chosen[2:] = False
        x = mesh.vertices[mesh.edges][:, :, 0]
        first, last = (x == 1).all(axis=1), (x == 3).all(axis=1)
        mesh.seams = first | last
        self.assertEqual(usable_seams(mesh).tolist(), mesh.edges[first].tolist())
        self.assertTrue(np.array_equal(new_seams(mesh, np.zeros((0, 2), int)), last))
        border = (x == 0).all(axis=1)
        self.assertTrue(np.array_equal(new_seams(mesh, mesh.edges[border]), last | border))


class Stretch(unittest.TestCase):
    def test_singular_values_of_random_maps(self):
        random = np.random.default_rng(5)
        vertices = random.random((300, 3))
        triangles = np.arange(300).reshape(-1, 3)
        for _ in range(5):
            matrix = random.normal(size=(2, 2))
            normals = np.cross(vertices[1::3] - vertices[::3], vertices[2::3] - vertices[::3])
            first = vertices[1::3] - vertices[::3]
            first /= np.linalg.norm(first, axis=1)[:, None]
            second = np.cross(normals / np.linalg.norm(normals, axis=1)[:, None], first)
            frame = np.stack([first, second], 1)
            local = np.einsum("tij,tkj->tki", frame, vertices[triangles])
            largest, smallest = singular_values(vertices, triangles, local @ matrix.T)
            expected = np.linalg.svd(matrix, compute_uv=False)
            expected[1] *= np.sign(np.linalg.det(matrix))
            np.testing.assert_allclose(
                np.stack([largest, smallest], 1), np.tile(expected, (100, 1)), rtol=1e-6, atol=1e-8
            )

    def test_faces(self):
        mesh = grid(2, 1)
        triangles = np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]])
        uv = mesh.vertices[mesh.corner_vertices][:, :2]
        uv[4:] *= 4
        faces = np.array([0, 0, 1, 1])
        ratios, scales, flipped = face_stretches(
            mesh.vertices, mesh.corner_vertices[triangles], uv[triangles], faces, 2, np.ones(2, bool)
        )
        np.testing.assert_allclose(ratios, 1)
        np.testing.assert_allclose(np.exp(scales[1] - scales[0]), 4)
        self.assertFalse(flipped.any())
        uv[4:] *= [-3, 1]
        ratios, _, flipped = face_stretches(
            mesh.vertices, mesh.corner_vertices[triangles], uv[triangles], faces, 2, np.ones(2, bool)
        )
        np.testing.assert_allclose(ratios, [1, 3])
        self.assertEqual(flipped.tolist(), [False, True])

    def test_faces_without_area_and_collapsed_maps_have_colours(self):
        vertices = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]], float)
        triangles = np.array([[0, 1, 2], [0, 1, 3]])
        ratios, scales, _ = face_stretches(vertices, triangles, np.zeros((2, 3, 2)), np.arange(2), 2, np.ones(2, bool))
        for colours in (angle_colours(ratios, 2), area_colours(scales, 2)):
            self.assertTrue(((colours >= 0) & (colours <= 1)).all())

    def test_order_of_colours(self):
        red = area_colours(np.log([0.5, 1, 2]), 2)
        self.assertTrue(red[0, 2] > red[0, 0] and red[2, 0] > red[2, 2] and (red[1] > 0.9).all())


class Jobs(unittest.TestCase):
    def test_result_and_error(self):
        job = Job(lambda progress: (progress("half", 0.5), 7)[1])
        job.start()
        job._thread.join()
        self.assertEqual((job.result, job.error, job.stage, job.share), (7, None, "half", 0.5))
        job = Job(lambda progress: 1 // 0)
        job.run()
        self.assertIsInstance(job.error, ZeroDivisionError)

    def test_cancel(self):
        begun = threading.Event()

        def work(progress):
            while progress("forever", 0):
                begun.set()
            return "gave up"

        job = Job(work)
        job.start()
        begun.wait(10)
        self.assertFalse(job.is_done)
        job.cancel()
        job._thread.join(10)
        self.assertTrue(job.is_done and job.is_cancelled)
        self.assertEqual(job.result, "gave up")

    def test_parts(self):
        seen = []
        part_of(lambda stage, share: seen.append(share) or True, 1, 4)("stage", 0.5)
        self.assertEqual(seen, [0.375])


if __name__ == "__main__":
    unittest.main()
