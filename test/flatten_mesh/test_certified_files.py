# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is certified is what files hold. GLB and PLY files have numbers of type float: with these, which are compared
exactly, each triangle and each fan of a polygon has its orientation, no two triangles overlap, and stretch is what the
report says.

Usage: test_certified_files.py FLATTEN_MESH"""

import collections
import fractions
import itertools
import math
import random
import re
import struct
import sys
import unittest

from program_case import Program_case
from read_models import numbers_of, read_glb, read_ply

UNIT = 2**149  # all floats are multiples of its inverse

# Each once: a triangle that was flat in float, and quads of which some were not convex in float
STRIPS = ([(441.71411133, 494.12988281, 228.03190613), (441.71411133, 582.43426514, 228.03190613),
           (441.71411133, 852.87988281, 218.0320282), (449.71411133, 582.43426514, 228.03190613),
           (449.71411133, 494.12988281, 228.03190613), (449.71411133, 852.87988281, 218.0320282),
           (449.71411133, 484.12988281, 228.03215027), (449.71411133, 605.37994385, 228.0320282),
           (449.71411133, 507.59753418, 275.24743652), (449.71411133, 494.12988281, 269.73223877),
           (449.71411133, 605.37994385, 315.29003906), (449.71411133, 610.37988281, 328.14355469),
           (105.52676392, 298.87023926, 228.03831482), (180.52676392, 298.87023926, 228.03833008),
           (195.15641785, 298.87023926, 228.03833008)],
          [(0, 1, 2), (3, 4, 5), (4, 6, 5), (3, 7, 8), (8, 9, 3), (8, 10, 11), (12, 13, 14)])
FOLDED_QUADS = ([(x + dx, y, z) for x in (-0.95, -0.75, -0.55, -0.35, -0.15, 0.05, 0.25, 0.45, 0.65, 0.85)
                 for dx, y, z in ((0, -0.75, -0.9), (-0.05, -0.8, -0.9), (-0.05, -0.75, -0.9), (-0.05, -0.8, -0.95))],
                [(i, i + 1, i + 2, i + 3) for i in range(0, 40, 4)])


def exact(x):
    """A float as a multiple of the smallest one"""
    product = fractions.Fraction(x) * UNIT
    assert product.denominator == 1
    return product.numerator


def area(p, q, r):
    """Twice that of a triangle in the plane, with its sign"""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def triangles_of_glb(path):
    """Of each triangle with texture coordinates: points, places in the plane, and the numbers of its vertices"""
    gltf, data = read_glb(path)
    triangles = []
    for m, mesh in enumerate(gltf["meshes"]):
        for k, primitive in enumerate(mesh["primitives"]):
            attributes = primitive["attributes"]
            if "TEXCOORD_0" in attributes:
                points, texture = (numbers_of(gltf, data, attributes[key]) for key in ("POSITION", "TEXCOORD_0"))
                uvs = [(exact(u), UNIT - exact(v)) for u, v in texture]
                for t in zip(*[iter(numbers_of(gltf, data, primitive["indices"]))] * 3):
                    triangles.append(([points[v] for v in t], [uvs[v] for v in t], [(m, k, v) for v in t]))
    return triangles


def polygons_of_ply(path):
    """Places in the plane of the corners of each polygon with texture coordinates"""
    exact_numbers = [[exact(x) for x in face["texcoord"] if any(face["texcoord"])] for face in read_ply(path)]
    return [list(zip(uv[::2], uv[1::2])) for uv in exact_numbers if uv]


def is_beside(p, q):
    """Whether a side of the first of two convex polygons has the second on its other side"""
    return any(all(area(p[i - 1], p[i], r) <= 0 for r in q) for i in range(len(p)))


def overlaps(polygons):
    """The number of pairs of convex polygons with interior points in common"""
    xs, ys = ([p[axis] for polygon in polygons for p in polygon] for axis in (0, 1))
    cells, size = collections.defaultdict(list), max(max(xs) - min(xs), max(ys) - min(ys)) // 64 + 1
    for number, polygon in enumerate(polygons):
        columns, rows = (range(min(p[axis] for p in polygon) // size, max(p[axis] for p in polygon) // size + 1)
                         for axis in (0, 1))
        for cell in itertools.product(columns, rows):
            cells[cell].append(number)
    pairs = {pair for members in cells.values() for pair in itertools.combinations(members, 2)}
    boxes = [(min(p[0] for p in q), max(p[0] for p in q), min(p[1] for p in q), max(p[1] for p in q)) for q in polygons]
    count = 0
    for a, b in pairs:
        (l, r, d, u), (m, s, e, v) = boxes[a], boxes[b]
        if l < s and m < r and d < v and e < u:
            count += not is_beside(polygons[a], polygons[b]) and not is_beside(polygons[b], polygons[a])
    return count


def stretch_of_charts(triangles, aspect):
    """The L2 stretch of each chart, in rising order, on pages with this ratio of height and width. Charts share no
    vertex."""
    chart = {}

    def root(v):
        while chart.setdefault(v, v) != v:
            v = chart[v]
        return v

    for _, _, (a, b, c) in triangles:
        chart[root(b)] = chart[root(c)] = root(a)
    sums = collections.defaultdict(lambda: [0, 0, 0])
    for points, uvs, vertices in triangles:
        p, q, r = ([exact(x) for x in point] for point in points)  # sides of needles leave few digits
        sides, plane = [[y - x for x, y in zip(p, end)] for end in (q, r)], area(*uvs)
        first, mixed, second = (sum(x * y for x, y in zip(*pair)) for pair in
                                ((sides[0], sides[0]), (sides[0], sides[1]), (sides[1], sides[1])))
        surface = math.isqrt(first * second - mixed * mixed) / UNIT**2
        (u1, v1), (u2, v2) = ((x - uvs[0][0], (y - uvs[0][1]) * fractions.Fraction(aspect)) for x, y in uvs[1:])
        double = plane / UNIT**2 * aspect
        trace = float((first * (u2 * u2 + v2 * v2) - 2 * mixed * (u1 * u2 + v1 * v2) + second * (u1 * u1 + v1 * v1))
                      / UNIT**4)
        total = sums[root(vertices[0])]
        for i, number in enumerate((surface, double, surface * trace / double**2 / 2)):  # of two triangles
            total[i] += number
    return sorted(math.sqrt(energy * plane) / surface for surface, plane, energy in sums.values())


def rounded(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def grid(generator, n, is_quads):
    """Bumpy, with lines that are far apart, or very close"""
    lines = [list(itertools.accumulate(10**generator.uniform(-6, 0) for _ in range(n))) for _ in (0, 1)]
    points = [(x, y, 0.3 * math.sin(3 * x) * math.cos(2 * y)) for x in lines[0] for y in lines[1]]
    corners = [(a, a + n, a + n + 1, a + 1) for i in range(n - 1) for a in range(i * n, i * n + n - 1)]
    return points, corners if is_quads else [t for a, b, c, d in corners for t in ((a, b, c), (a, c, d))]


def gaps(generator, n, least, most):
    """Growing numbers whose differences grow, so that floats tell them apart"""
    return list(itertools.accumulate(sorted(10**generator.uniform(least, most) for _ in range(n))))


def fan(generator, n):
    """Needles around a point"""
    points = [(0, 1, 0.5)] + [(x, 0, 0) for x in gaps(generator, n, -9, -1)]
    return points, [(0, i, i + 1) for i in range(1, n)]


def stack(generator, n):
    """Needles on one another, as strips of a bent sheet"""
    points = [(x, h, h * h) for h in gaps(generator, n, -9, -2) for x in (0, 1)]
    return points, [t for a in range(0, 2 * n - 2, 2) for t in ((a, a + 1, a + 3), (a, a + 3, a + 2))]


def flat_quads(generator, n):
    """A sheet of quads with a corner that is nearly straight"""
    points = [(i + generator.uniform(-0.3, 0.3), j, 0.2 * math.sin(i)) for i in range(n) for j in range(n)]
    for i, j in itertools.product(range(1, n - 1), range(1, n - 1, 2)):  # at the middle of a diagonal, up to rounding
        ends = [points[(i - 1) * n + j], points[i * n + j + 1]]
        points[i * n + j] = tuple((a + b) / 2 + generator.uniform(-1e-8, 1e-8) for a, b in zip(*ends))
    return points, [(a, a + n, a + n + 1, a + 1) for i in range(n - 1) for a in range(i * n, i * n + n - 1)]


def crumbs(generator, n):
    """Many small surfaces of very different sizes"""
    points, faces = [], []
    for i in range(n):
        size, first = 10**generator.uniform(-5, 0), len(points)
        points += [tuple(2 * (i % 10 if axis == 0 else i // 10 if axis == 1 else 0) + size * generator.random()
                         for axis in range(3)) for _ in range(4)]
        faces += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return points, faces


def family():
    """Surfaces by name"""
    generator = random.Random(11)
    surfaces = {"strips": STRIPS, "folded quads": FOLDED_QUADS}
    for i in range(3):
        surfaces[f"grid {i}"] = grid(generator, 14, False)
        surfaces[f"quads {i}"] = grid(generator, 14, True)
        surfaces[f"fan {i}"] = fan(generator, 40)
        surfaces[f"stack {i}"] = stack(generator, 40)
        surfaces[f"flat quads {i}"] = flat_quads(generator, 12)
        surfaces[f"crumbs {i}"] = crumbs(generator, 60)
    return {name: ([tuple(map(rounded, p)) for p in points], faces) for name, (points, faces) in surfaces.items()}


class Certified_files(Program_case):
    """What the program writes"""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.surfaces = family()

    def flatten(self, surface, form, options):
        """The output, the report, and what is said. An atlas is whole, or says what it lacks."""
        return self.flatten_file(self.write(*surface), form, options)

    def flatten_file(self, model, form, options):
        """The same of a file"""
        run, said, output = self.run_program(model, options, "out." + form)
        self.assertIn(run.returncode, (0, 2), run.stderr)
        self.assertEqual(run.returncode > 0, said["status"] not in ("OK", "STRETCH_BOUND_MISSED"), run.stderr)
        return output if output.exists() else None, said, run.stderr

    def check_polygons(self, polygons, without_area):
        """All are convex and apart, but for as many as a note says to have no area on the surface."""
        good = [uvs for uvs in polygons if all(area(*corners) > 0 for corners in itertools.combinations(uvs, 3))]
        self.assertLessEqual(len(polygons) - len(good), without_area)
        if without_area == 0:
            self.assertEqual(overlaps(polygons), 0)

    def check(self, surface, options, aspect=1):
        """Returns how many of the two outputs have all faces."""
        whole = 0
        for form in ("glb", "ply"):
            output, said, text = self.flatten(surface, form, options)
            if output is None:
                self.assertEqual(said["status"], "PRECISION_EXCEEDED", text)
                continue
            faces = triangles_of_glb(output) if form == "glb" else polygons_of_ply(output)
            polygons = [face[1] for face in faces] if form == "glb" else faces
            notes = [re.match(r"(\d+) faces? without area", note) for note in said["notes"]]
            without_area = sum(int(note[1]) for note in notes if note)
            self.check_polygons(polygons, without_area)
            skipped = sum(part["faces"] for part in said["skipped"])
            if "--plain" not in options:
                self.assertGreaterEqual(len(faces), len(surface[1]) - skipped)
            if form == "glb" and without_area == 0 and not {"--units", "--no-pack"} & set(options):
                charts = [said] if "--plain" in options else said["atlas"]["charts"]
                expected = sorted(chart["l2_stretch"] for chart in charts)
                for found, told in itertools.zip_longest(stretch_of_charts(faces, aspect), expected):
                    self.assertAlmostEqual(found / told, 1, 7)
            whole += skipped == 0
        return whole

    def test_all_surfaces(self):
        whole = 0
        for name, surface in self.surfaces.items():
            with self.subTest(surface=name):
                whole += self.check(surface, [])
        self.assertGreater(whole, len(self.surfaces))

    def test_all_options(self):
        whole = 0
        for name, options in itertools.product(
                ("grid 0", "quads 1", "fan 0", "flat quads 0", "crumbs 0"),
                ("--for few-charts", "--resolution 512x256", "--texels-per-unit 200", "--units world", "--no-pack",
                 "--plain")):
            with self.subTest(surface=name, options=options):
                whole += self.check(self.surfaces[name], options.split(), 1 / 2 if "512x256" in options else 1)
        self.assertGreater(whole, 30)

    def test_equal_polygons_are_treated_alike(self):
        output, said, _ = self.flatten(FOLDED_QUADS, "ply", [])
        sizes = {len(polygon) for polygon in polygons_of_ply(output)}
        self.assertEqual(len(sizes), 1, said["notes"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
