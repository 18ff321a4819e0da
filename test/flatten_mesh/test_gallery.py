# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a gallery of small generated meshes, and compares the page and its pictures with what is known of them. Looks at the page of the
manual, too: all its pictures are there. Usage: test_gallery.py SOURCE_FOLDER FLATTEN_MESH DRAW_ATLASES"""

import json
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from PIL import Image

source, program, draw = Path(sys.argv[1]), sys.argv[2], sys.argv[3]


def torus(n, m):
    points = [((2 + math.cos(v)) * math.cos(u), (2 + math.cos(v)) * math.sin(u), math.sin(v))
              for u in (2 * math.pi * i / n for i in range(n)) for v in (2 * math.pi * j / m for j in range(m))]
    corner = lambda i, j: i % n * m + j % m
    faces = [face for i in range(n) for j in range(m)
             for face in ((corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)), (corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)))]
    return points, faces


def strip_and_ring_with_turned_face():
    """Two components with three borders, one of them flat"""
    points = [(x, y, 4) for x in range(6) for y in range(2)]
    faces = [face for i in range(0, 10, 2) for face in ((i, i + 2, i + 3), (i, i + 3, i + 1))]
    first, n = len(points), 8
    for i in range(n):
        angle = 2 * math.pi * i / n
        points += [(radius * math.cos(angle), radius * math.sin(angle), 0) for radius in (1, 2)]
    ring = lambda i: first + i % (2 * n)
    for i in range(0, 2 * n, 2):
        faces += [(ring(i), ring(i + 1), ring(i + 3)), (ring(i), ring(i + 3), ring(i + 2))]
    faces[-1] = faces[-1][::-1]
    return points, faces


def write_off(file, mesh):
    points, faces = mesh
    lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [" ".join(map(str, p)) for p in points]
    file.write_text("\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in faces]) + "\n")


def share_of_paper(picture, left, right, top, bottom):
    """The share of white pixels"""
    colors = picture.crop((left, top, right, bottom)).getdata()
    return sum(color == (255, 255, 255) for color in colors) / len(colors)


def rows_of_tables(page):
    """Of each mesh, the columns by their names"""
    found, names = {}, None
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        if line.startswith("| mesh |"):
            names = cells
        elif line.startswith("| `"):
            found[cells[0].strip("`")] = dict(zip(names, cells))
    return found


class Gallery(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        write_off(cls.folder / "torus.off", torus(24, 12))
        write_off(cls.folder / "two.off", strip_and_ring_with_turned_face())
        (cls.folder / "points.off").write_text("OFF\n1 0 0\n0 0 0\n")
        meshes = [{"file": f"{name}.off", "text": "Some text", "eye": "0.5,-1,0.8", "up": "0,0,1"} for name in ("torus", "two")]
        sections = [{"title": "First", "text": "Text.", "meshes": meshes[:1]}, {"title": "Second", "text": "Text.", "meshes": meshes[1:]}]
        cls.result = cls.make({"sections": sections, "row": meshes})
        cls.page = (cls.folder / "gallery.txt").read_text()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def make(cls, contents):
        (cls.folder / "list.json").write_text(json.dumps(contents))
        script = source / "doc" / "standalone" / "gallery.py"
        return subprocess.run([sys.executable, script, cls.folder / "list.json", "--program", program, "--draw", draw,
                               "--meshes", cls.folder, "--doc", cls.folder], stderr=subprocess.PIPE, text=True)

    def test_figures_are_those_of_the_surfaces(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        rows = rows_of_tables(self.page)
        known = {"torus.off": "576 triangles, 1 component, 0 borders, 1 handle", "two.off": "26 triangles, 2 components, 3 borders, 0 handles"}
        self.assertEqual(set(rows), set(known))
        captions = dict(re.findall(r"`(\S+)`: Some text\.<br>(.*?)</td>", self.page.replace("&nbsp;", " ")))
        self.assertEqual(captions, known)
        for name, charts in (("torus.off", "1"), ("two.off", "2")):
            self.assertEqual([rows[name][key] for key in ("charts", "flips", "overlaps")], [charts, "0", "none"])
        change = {name: float(row["angle change"].removesuffix("&deg;")) for name, row in rows.items()}
        self.assertLess(3 * change["two.off"], change["torus.off"]) # the first is flat
        self.assertIn("1 face turned", self.page)

    def test_figures_are_those_of_the_report(self):
        report = self.folder / "report.json"
        subprocess.run([program, self.folder / "torus.off", "--for", "few-charts", "--quiet", "--json", report], check=True)
        atlas = json.loads(report.read_text())["atlas"]
        row = rows_of_tables(self.page)["torus.off"]
        self.assertEqual(row["angle change"], f"{math.degrees(atlas['mean_angle_change']):.2f}&deg;")
        self.assertEqual(row["covered"], f"{100 * atlas['packing']['covered_share']:.0f}&nbsp;%")
        self.assertEqual(row["L2 stretch"], f"{atlas['l2_stretch']:.2f}")

    def test_pictures_show_surface_and_atlas(self):
        picture = Image.open(self.folder / "fig" / "gallery" / "torus_off.png")
        width, height = picture.size
        self.assertEqual(width, 2 * height)
        for left in (0, height): # the surface, the atlas: neither is blank, and around both is paper
            self.assertTrue(0.1 < share_of_paper(picture, left + 8, left + height - 8, 8, height - 8) < 0.95)
            self.assertEqual(share_of_paper(picture, left, left + height, 0, 5), 1)
        picture = Image.open(self.folder / "fig" / "readme.png")
        width, height = picture.size
        self.assertEqual(width, height)
        for left in (0, width // 2):
            for top in (0, height // 2):
                self.assertLess(share_of_paper(picture, left + 8, left + width // 2 - 8, top + 8, top + height // 2 - 8), 0.95)

    def test_a_mesh_without_atlas_is_named(self):
        mesh = {"file": "points.off", "text": "", "eye": "0,-1,0", "up": "0,0,1"}
        run = self.make({"sections": [{"title": "", "text": "", "meshes": [mesh]}], "row": [mesh]})
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("points.off", run.stderr)
        self.assertIn("no faces", run.stderr)

    def test_readme_tells_the_figures_of_its_picture(self):
        rows = rows_of_tables((source / "doc" / "guides" / "gallery.txt").read_text())
        contents = json.loads((source / "doc" / "standalone" / "gallery.json").read_text())
        changes = [float(rows[mesh["file"]]["angle change"].removesuffix("&deg;")) for mesh in contents["row"]]
        readme = " ".join((source / "README.md").read_text().split())
        self.assertIn(f"Angles change by {min(changes):.1f} to {max(changes):.1f} degrees", readme)

    def test_pictures_of_pages_exist(self):
        manual = source / "doc" / "guides"
        contents = json.loads((source / "doc" / "standalone" / "gallery.json").read_text())
        meshes = [mesh["file"] for section in contents["sections"] for mesh in section["meshes"]]
        for page, doc in ((self.page, self.folder), ((manual / "gallery.txt").read_text(), manual)):
            named = re.findall(r"<img src=\"([^\"]*)\"", page)
            self.assertEqual(sorted(named), sorted(file.name for file in (doc / "fig" / "gallery").iterdir()))
        self.assertEqual(list(rows_of_tables((manual / "gallery.txt").read_text())), meshes)
        self.assertTrue((manual / "fig" / "readme.png").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
