# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command of the tutorial, of the page on the program, and of README.md works as printed: test_tutorial.py
FLATTEN_MESH."""

import json
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from collections import namedtuple
from pathlib import Path
from xml.etree import ElementTree

FLATTEN_MESH = Path(sys.argv.pop(1)).resolve()
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "doc/standalone"))
import tutorial  # noqa: E402
from read_models import numbers_of, read_glb, read_ply  # noqa: E402

MANUAL = ROOT / "doc"
Model = namedtuple("Model", "triangles coordinates")
SIGNATURE = b"\x89PNG\r\n\x1a\n"


def check_png(data):
    """The size of a picture, all of whose pixels are there."""
    assert data.startswith(SIGNATURE), "no PNG file"
    place, pixels, header = len(SIGNATURE), b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        content = data[place + 8:place + 8 + length]
        assert zlib.crc32(kind + content) == struct.unpack(">I", data[place + 8 + length:place + 12 + length])[0]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", content)
        elif kind == b"IDAT":
            pixels += content
        place += 12 + length
    assert kind == b"IEND", "the end is missing"
    width, height, depth, color = header[:4]
    samples = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color]
    assert len(zlib.decompress(pixels)) == height * (1 + (width * depth * samples + 7) // 8)
    return width, height


def check_obj(file):
    """All corners have texture coordinates; pictures of materials are there."""
    lines = [line.split() for line in file.read_text().splitlines() if line]
    points = [line for line in lines if line[0] == "v"]
    coordinates = [tuple(map(float, line[1:3])) for line in lines if line[0] == "vt"]
    faces = [line[1:] for line in lines if line[0] == "f"]
    assert points and faces
    for corner in (corner for face in faces for corner in face):
        point, coordinate = map(int, corner.split("/")[:2])
        assert 1 <= point <= len(points) and 1 <= coordinate <= len(coordinates)
    for material in (file.parent / line[1] for line in lines if line[0] == "mtllib"):
        for line in material.read_text().splitlines():
            if re.match(r"\s*(map_|bump|norm|disp)", line, re.I):
                check_png((file.parent / line.split()[-1]).read_bytes())
    return Model(len(faces), [number for pair in coordinates for number in pair])


def check_ply(file):
    """A binary PLY file, all of whose faces have a list of texture coordinates."""
    faces = read_ply(file)
    assert faces and all(len(face["texcoord"]) == 2 * len(face["vertex_indices"]) for face in faces)
    return Model(len(faces), [number for face in faces for number in face["texcoord"]])


def check_glb(file):
    """All corners have texture coordinates; pictures are inside the file."""
    scene, data = read_glb(file)
    triangles, coordinates = 0, []
    for primitive in (p for mesh in scene["meshes"] for p in mesh["primitives"]):
        triangles += scene["accessors"][primitive["indices"]]["count"] // 3
        pairs = numbers_of(scene, data, primitive["attributes"]["TEXCOORD_0"])
        coordinates += [number for pair in pairs for number in pair]
    for image in scene.get("images", []):
        view = scene["bufferViews"][image["bufferView"]]
        check_png(data[view["byteOffset"]:view["byteOffset"] + view["byteLength"]])
    return Model(triangles, coordinates)


def check_html(file):
    """A report with its data inside, that loads nothing from elsewhere."""
    text = file.read_text(encoding="utf-8")
    report = json.loads(re.search(r'<script type="application/json" id="report">(.*?)</script>', text, re.S)[1])
    assert report["triangles"] > 0 and report["charts"]
    assert not re.search(r'<(script|link|img)[^>]* (src|href)="(?!data:)', text)


def check_seams(file):
    edges = file.read_text().splitlines()[2].split()
    assert edges and len(edges) % 2 == 0


def check_json(file):
    assert json.loads(file.read_text())["status"] == "OK"


CHECKS = {".png": lambda file: check_png(file.read_bytes()), ".obj": check_obj, ".ply": check_ply, ".glb": check_glb,
          ".html": check_html, ".txt": check_seams, ".json": check_json, ".svg": ElementTree.parse}


def inputs(words):
    """The words between the script and its first option."""
    options = [k for k, word in enumerate(words) if word.startswith("-")]
    return words[1:options[0] if options else None]


def output_files(words):
    """The names of the files that a command writes; `%` stands for each input. Of several pages, the first."""
    names = []
    for name in tutorial.outputs(words):
        name = name.replace("<UDIM>", "1001")
        names += [name.replace("%", Path(file).stem) for file in inputs(words)] if "%" in name else [name]
    return names


def commands_of(page):
    """The commands of a page of the manual, in its blocks of code, or of a Markdown file, where they are indented."""
    if page.suffix == ".md":
        blocks = re.findall(r"(?:^    .*\n)+", page.read_text(), re.M)
        commands = [words for block in blocks for words in tutorial.commands(block)]
    else:
        commands = [content for kind, content in tutorial.steps(page.read_text()) if kind == "command"]
    return [words for words in commands if words[0] == "scripts/flatten"]


def option_rows(page):
    """The names of options and what they do, from each row of a table that begins with an option."""
    return [(names, " ".join(effect.split())) for names, effect in
            re.findall(r"^<tr><td>(`--.*?)</td>\s*<td>(.*?)</td></tr>$", page, re.M | re.S)]


def same_line(printed, real):
    """Words alike, and numbers that differ by at most 2 % of their size, as between machines."""
    number = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
    if re.sub(number, "#", " ".join(printed.split())) != re.sub(number, "#", " ".join(real.split())):
        return False
    pairs = zip(map(float, re.findall(number, printed)), map(float, re.findall(number, real)))
    return all(abs(a - b) <= .02 * max(abs(a), abs(b)) for a, b in pairs)


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.clone = tutorial.Clone(folder.name, ROOT, FLATTEN_MESH)

    def run_command(self, words):
        """Checks a command and what it writes, and returns what it prints."""
        with self.subTest(command=" ".join(words)):
            before = {file: file.stat().st_mtime_ns for file in self.clone.folder.rglob("*")}
            status, output, errors = self.clone.run(words)
            self.assertEqual(status, 0, errors)
            for name in output_files(words):
                file = self.clone.folder / name
                self.assertTrue(file.is_file(), name)
                self.assertNotEqual(file.stat().st_mtime_ns, before.get(file), f"{name} was there before")
                model = CHECKS[file.suffix](file)
                if isinstance(model, Model) and not {"--plain", "--texels-per-unit"} & set(words):
                    self.assertTrue(all(0 <= number <= 1 for number in model.coordinates), f"{name} leaves the square")
            if "--bake-from" in words:
                self.check_baked(words)
            return output
        return ""

    def check_baked(self, words):
        """The model is as simple as asked for, and has the normals of the fine one as a picture."""
        file = self.clone.folder / words[words.index("--output") + 1]
        triangles = CHECKS[file.suffix](file).triangles
        if "--simplify" in words:
            wanted = int(words[words.index("--simplify") + 1])
            self.assertLessEqual(triangles, wanted)
            self.assertGreaterEqual(triangles, .9 * wanted)
        if file.suffix == ".glb":
            scene, _ = read_glb(file)
            self.assertTrue(any("normalTexture" in material for material in scene["materials"]))
            self.assertTrue(scene["images"])

    def test_tutorial(self):
        page = (MANUAL / "guides/tutorial.txt").read_text()
        steps = tutorial.steps(page)
        self.assertGreaterEqual(sum(kind == "command" for kind, _ in steps), 4)
        printed = ""
        for kind, content in steps:
            if kind == "command":
                printed = self.run_command(content)
                continue
            real = printed.splitlines()
            for line in content:
                self.assertTrue(any(same_line(line, other) for other in real), f"not printed: {line}\n{printed}")
        for name in re.findall(r"`([\w.]+\.(?:obj|glb|ply|png|html|svg|json|txt|off|mtl))`", page):
            self.assertTrue(list(self.clone.folder.rglob(name)), f"{name} is nowhere")

    def test_defaults(self):
        """The defaults in the tables of the page on the program are those of --help."""
        text = subprocess.run([FLATTEN_MESH, "--help"], check=True, capture_output=True, text=True).stdout
        options = re.split(r"\n  (?:-\w \[ )?--", text)[1:]
        defaults = {re.match(r"[\w-]+", option)[0]: re.search(r"\(=([^)]+)\)", option) for option in options}
        rows = option_rows((MANUAL / "guides/program.txt").read_text())
        checked = set()
        for names, effect in rows:
            found = re.findall(r"\(([\d.]+)\)", effect)
            for name, value in zip(re.findall(r"`--([\w-]+)", names), found):
                self.assertTrue(defaults[name], name)
                self.assertEqual(float(value), float(defaults[name][1]), name)
                checked.add(name)
        self.assertGreaterEqual(checked, {"resolution", "rotations"})
        # What depends on the purpose, in words
        for name, told, written in [
                ("stretch-bound", r"texture: (\d+(?:\.\d+)?); few-charts, conformal: (\d+(?:\.\d+)?)", "({1}; {0} for textures)"),
                ("area-weight", r"texture: (\d+(?:\.\d+)?); few-charts, conformal: (\d+(?:\.\d+)?)\. --plain: with --injective only, (\d+(?:\.\d+)?)",
                 "({0} for textures, {1} for other atlases; with `--plain --injective`, {2})"),
                ("seam-price", r"texture, conformal: (\d+(?:\.\d+)?)", "({0} for textures and conformal charts)")]:
            words = " ".join(next(option for option in options if option.startswith(name)).split())
            expected = written.format(*re.search(told, words).groups())
            self.assertTrue([row for row in rows if expected in " ".join(row[1].split())], expected)

    def test_readme(self):
        """The commands of README.md and of the page on the program, with meshes of the package in place of the reader's."""
        pages = {page: commands_of(page) for page in (ROOT / "README.md", MANUAL / "guides/program.txt")}
        for page, commands in pages.items():
            self.assertGreaterEqual(len(commands), 2, page.name)
        commands = [words for page in pages.values() for words in page]
        self.assertGreaterEqual(len(commands), 3)
        self.clone.make()
        for words in commands:
            names = [name for word in inputs(words) for name in self.make_inputs(word)]
            words[1:1 + len(inputs(words))] = names
            for name in output_files(words):
                (self.clone.folder / name).parent.mkdir(exist_ok=True)
            printed = self.run_command(words)
            if len(words) == 1:
                self.check_files_named_in(printed)
            else:
                self.assertTrue(output_files(words), f"{words} writes nothing")

    def check_files_named_in(self, printed):
        """scripts/flatten without arguments says what it has written."""
        files = [Path(name) for name in re.findall(r"(?:^written: | and )(/\S+)", printed, re.M)]
        self.assertEqual({file.suffix for file in files}, {".obj", ".svg"}, printed)
        for file in files:
            self.assertTrue(file.resolve().is_relative_to(self.clone.folder.resolve()), file)
            CHECKS[file.suffix](file)

    def make_inputs(self, pattern):
        """Makes files of this name, or two files that the shell would find."""
        mesh = self.clone.folder / tutorial.DATA / "egg.off"
        names = [pattern.replace("*", word) for word in (("left", "right") if "*" in pattern else ("",))]
        for file in (self.clone.folder / name for name in names):
            file.parent.mkdir(exist_ok=True)
            if file.suffix == ".stl":
                write_stl(mesh, file)
            else:
                subprocess.run([FLATTEN_MESH, mesh, "--quiet", "--output", file], check=True)
        return names


def write_stl(mesh, file):
    """The surface of an OFF file as STL."""
    numbers = re.sub("#.*", "", mesh.read_text()).split()[1:]
    vertices, faces = int(numbers[0]), int(numbers[1])
    points = [numbers[k:k + 3] for k in range(3, 3 + 3 * vertices, 3)]
    lines = ["solid mesh"]
    for k in range(faces):
        corners = numbers[3 + 3 * vertices + 4 * k:][1:4]
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(points[int(corner)]) for corner in corners]
        lines += ["endloop", "endfacet"]
    file.write_text("\n".join(lines + ["endsolid mesh", ""]))


class Helpers(unittest.TestCase):
    """What this test would not notice, it would not check."""

    def test_unknown_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            clone = tutorial.Clone(folder, ROOT, FLATTEN_MESH)
            for words in (["meshlab", "mask.obj"], ["git", "push"], ["cd", "elsewhere"], ["scripts/other"]):
                self.assertRaises(ValueError, clone.run, words)

    def test_printed_lines(self):
        self.assertTrue(same_line("covered   41.4 %", "covered  41.5 %"))
        self.assertFalse(same_line("covered   41.4 %", "covered  45 %"))
        self.assertFalse(same_line("covered   41.4 %", "charts  41.4 %"))
        self.assertFalse(same_line("charts  1", "charts  2"))

    def test_commands_of_pages(self):
        with tempfile.TemporaryDirectory() as folder:
            readme, page = Path(folder) / "a.md", Path(folder) / "a.txt"
            readme.write_text("Text\n\n    scripts/flatten a\n    cmake b\n\nscripts/flatten c\n")
            page.write_text("    scripts/flatten a\n\\code{.sh}\nscripts/flatten b \\\n  --quiet\n\\endcode\n")
            self.assertEqual(commands_of(readme), [["scripts/flatten", "a"]])
            self.assertEqual(commands_of(page), [["scripts/flatten", "b", "--quiet"]])

    def test_option_rows(self):
        page = ("<tr><td>`--a N`, `--b`</td>\n<td>x\n(1)</td></tr>\n<tr><td>`c`</td><td>`--d`</td></tr>\n"
                "<tr><td>`--e`</td><td>y</td></tr>\n")
        self.assertEqual(option_rows(page), [("`--a N`, `--b`", "x (1)"), ("`--e`", "y")])

    def test_steps(self):
        page = "\\code{.sh}\na b \\\n  'c d' # e\n\nf\n\\endcode text \\code{.unparsed}\ng  h\n\\endcode"
        self.assertEqual(tutorial.steps(page), [("command", ["a", "b", "c d"]), ("command", ["f"]), ("output", ["g  h"])])


class Options(unittest.TestCase):
    def test_options_exist(self):
        """Each option that README.md or the manual names for the program is in its help."""
        text = subprocess.run([FLATTEN_MESH, "--help"], capture_output=True, text=True, check=True).stdout
        known = set(re.findall(r"--[a-z][a-z-]*", text))
        for file in [ROOT / "README.md", *MANUAL.glob("*/*.txt")]:
            # Lines about programs with options of their own
            others = r"^.*(?:--target|gltf-transform|\.py|cmake|cpack|\bmypy\b|\bpip\b|\bvenv\b|scripts/(?!flatten)).*$"
            text = re.sub(others, "", file.read_text(), flags=re.M)
            for option in set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", text)):
                self.assertIn(option, known, f"in {file.name}")


if __name__ == "__main__":
    unittest.main()
