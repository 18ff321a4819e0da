# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the outputs of the program are like for programs that read them: where faces have no texture coordinates, as
triangles, with coordinates of vertices, and with pictures.
Usage: test_next_programs.py FLATTEN_MESH"""

import re
import struct
import sys
import unittest
import zlib

from program_case import Program_case
from read_models import numbers_of, read_glb, read_ply, write_glb

NO_COORDINATES = "no texture coordinates"


def hills(n=6, materials=("rock", "grass"), groups=True):
    """An OBJ text of n by n quadrangles with materials in turn, each with coordinates of its own"""
    lines = ["mtllib hills.mtl"] if materials else []
    lines += [f"v {i} {j} {0.2 * (i * i % 5) + 0.15 * (j * j % 7)}" for i in range(n + 1) for j in range(n + 1)]
    lines += [f"vt {(i + 0.25) / (n + 1)} {(j + 0.25) / (n + 1)}" for i in range(n + 1) for j in range(n + 1)]
    for i in range(n):
        if materials:
            lines += [f"g row_{i}"] * groups + [f"usemtl {materials[i % len(materials)]}"]
        for j in range(n):
            a = i * (n + 1) + j + 1
            lines.append("f " + " ".join(f"{v}/{v}" for v in (a, a + n + 1, a + n + 2, a + 1)))
    return "\n".join(lines) + "\n"


def read_obj(path):
    """Points, coordinates, and faces, each with the numbers of points and coordinates from 0; and other lines"""
    points, texture, faces, others = [], [], [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append(tuple(map(float, rest)))
        elif word == "vt":
            texture.append(tuple(map(float, rest)))
        elif word == "f":
            corners = [corner.split("/") for corner in rest]
            faces.append([(int(c[0]) - 1, int(c[1]) - 1 if len(c) > 1 and c[1] else None) for c in corners])
        elif not line.startswith("#"):
            others.append(line)
    return points, texture, faces, others


def area(a, b, c):
    """Twice that of a triangle in the plane"""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def gray_png(data):
    """The rows of a PNG file of gray values, of which none is interlaced"""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed, header = 8, b"", None
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place:place + 8])
        content = data[place + 8:place + 8 + size]
        crc, = struct.unpack(">I", data[place + 8 + size:place + 12 + size])
        assert crc == zlib.crc32(kind + content)
        header = struct.unpack(">2I5B", content) if kind == b"IHDR" else header
        packed += content if kind == b"IDAT" else b""
        place += 12 + size
    width, height, *rest = header
    assert rest == [8, 0, 0, 0, 0]
    raw, rows, before = zlib.decompress(packed), [], [0] * width
    for y in range(height):
        method, row = raw[y * (width + 1)], list(raw[y * (width + 1) + 1:(y + 1) * (width + 1)])
        for x in range(width):
            left, up, corner = (row[x - 1] if x else 0), before[x], (before[x - 1] if x else 0)
            nearest = min((abs(left + up - corner - v), i, v) for i, v in enumerate((left, up, corner)))[2]
            row[x] = (row[x] + (0, left, up, (left + up) // 2, nearest)[method]) % 256
        rows.append(row)
        before = row
    return rows


class Next_programs(Program_case):
    """Outputs of all kinds"""

    def hills(self, name="hills.obj", **kinds):
        """A file of them, with its materials"""
        (self.folder / "hills.mtl").write_text("newmtl rock\nKd 0.5 0.5 0.5\nnewmtl grass\nKd 0 1 0\nd 0.5\n")
        model = self.folder / name
        model.write_text(hills(**kinds))
        return model

    def output(self, model, options=(), output="out.obj", status=0):
        """What the program writes, and its messages"""
        run, _, result = self.run_program(model, options, output)
        self.assertEqual(run.returncode, status, run.stderr)
        return result, run.stderr

    def check_refused(self, model, options, output, words):
        """The program ends with one line, which contains all the words, and writes nothing."""
        before = set(self.folder.iterdir()) | {self.folder / "out.json"}
        run, _, result = self.run_program(model, options, output)
        self.assertEqual(run.returncode, 2, (options, run.stderr))
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertFalse(result.exists())
        self.assertLessEqual(set(self.folder.iterdir()), before)

    def check_obj(self, path, without):
        """All corners have coordinates; those of `without` faces are at a place that no other face has."""
        _, texture, faces, others = read_obj(path)
        self.assertTrue(all(t is not None for face in faces for _, t in face))
        common = [face for face in faces if len({t for _, t in face}) == 1]
        self.assertEqual(len(common), without)
        last = len(texture) - 1
        if without:
            self.assertEqual(texture[last], (0, 0))
            for face in faces:
                self.assertEqual(any(t == last for _, t in face), face in common)
        return faces, others

    def check_ply(self, path, without, lists=("texcoord",)):
        """All lists have full length; those of `without` faces are zeros."""
        faces, zeros = read_ply(path), 0
        for face in faces:
            for name in lists:
                self.assertEqual(len(face[name]), 2 * len(face["vertex_indices"]))
            is_zero = not any(face[lists[-1]])
            zeros += is_zero
            self.assertEqual(face["chart"] == (-1,), is_zero)
        self.assertEqual(zeros, without)

    def check_glb(self, path, without, key="TEXCOORD_0"):
        """Triangles without coordinates are primitives of their own."""
        gltf, data = read_glb(path)
        count = {True: 0, False: 0}
        for primitive in gltf["meshes"][0]["primitives"]:
            count[key in primitive["attributes"]] += len(numbers_of(gltf, data, primitive["indices"])) // 3
        self.assertEqual(count[False], without)
        self.assertGreater(count[True], 0)

    def test_left_out_faces(self):
        """Those have coordinates only if the input has some."""
        text = hills()
        bare = self.folder / "bare.obj"
        bare.write_text(re.sub(r"(\d+)/\d+", r"\1", "\n".join(l for l in text.splitlines() if l[:2] != "vt")) + "\n")
        for options in [], ["--texels-per-unit", "20", "--resolution", "64"], ["--units", "world"], ["--no-pack"]:
            with self.subTest(options=options):
                ignore = ["--ignore", "grass", *options]
                result, told = self.output(bare, ignore)
                self.assertIn(f"18 faces have {NO_COORDINATES}: other programs read (0, 0) at such corners", told)
                _, others = self.check_obj(result, 18)
                self.assertEqual([line for line in others if line[:6] != "mtllib"], read_obj(bare)[3][1:])
                result, told = self.output(bare, ignore, "out.ply")
                self.assertIn(f"18 faces have {NO_COORDINATES}: other", told)
                self.check_ply(result, 18)
                result, told = self.output(bare, ignore, "out.glb")
                self.assertIn(f"18 faces have {NO_COORDINATES}: such triangles are primitives", told)
                self.check_glb(result, 36)
        result, told = self.output(self.hills(), ["--ignore", "grass"])  # which keep theirs
        self.assertNotIn(NO_COORDINATES, told)
        self.check_obj(result, 0)

    def test_second_set(self):
        """Faces without one of both sets have zeros there."""
        model = self.hills()
        result, told = self.output(model, ["--uv-set", "1", "--ignore", "grass"], "out.ply")
        self.assertIn(f"18 faces have {NO_COORDINATES}", told)
        self.check_ply(result, 18, ("texcoord", "texcoord1"))
        self.assertTrue(all(any(face["texcoord"]) for face in read_ply(result)))
        result, _ = self.output(model, ["--uv-set", "1", "--ignore", "grass"], "out.glb")
        self.check_glb(result, 36, "TEXCOORD_1")

    def test_skipped_faces(self):
        """Invalid faces, and components without a chart"""
        model = self.hills()
        for options, status, without, more in [([], 2, 1, "f 1/1 1/1 2/2\n"), (["--plain"], 0, 1, ""),
                                               (["--component", "0"], 2, 2, "f 1/1 1/1 2/2\n")]:
            with self.subTest(options=options):
                model.write_text(hills() + more + "v 20 0 0\nv 21 0 0\nv 20 1 0\nf -3 -2 -1\n")
                result, told = self.output(model, options, status=status)
                self.assertIn(f"{without} face{'s have' if without > 1 else ' has'} {NO_COORDINATES}", told)
                _, texture, faces, _ = read_obj(result)
                last = len(texture) - 1
                self.assertEqual(sum(all(t == last for _, t in face) for face in faces), without)
                self.check_ply(self.output(model, options, "out.ply", status)[0], without)

    def test_they_are_read_as_none(self):
        """--repack says that faces have none, and their number, in each of the own formats."""
        bare = self.folder / "bare.obj"
        bare.write_text(re.sub(r"(\d+)/\d+", r"\1", hills()))
        for output, options in ("own.obj", []), ("own.ply", []), ("own.ply", ["--ply-coordinates", "vertex"]):
            with self.subTest(output=output, options=options):
                own, _ = self.output(bare, ["--ignore", "grass", *options], output)
                _, report, _ = self.run_program(own, ["--repack"], "again.obj")
                self.assertEqual(sum(part["faces"] for part in report["skipped"]), 18, report["skipped"])
        flat = self.folder / "palette.obj"  # of another program, where one place in the texture is the colour of a face
        flat.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.5\nf 1/1 2/1 3/1\nv 1 1 1\nf 2 4 3\n")
        result, _ = self.output(flat, ["--uv-set", "1"], "out.ply")
        self.assertEqual(read_ply(result)[0]["texcoord"], (0.5,) * 6)

    def test_all_faces_have_coordinates(self):
        """Nothing is told, and nothing is added."""
        result, told = self.output(self.hills())
        self.assertEqual(told, "")
        self.assertEqual(result.read_text().count("#"), 1)

    def test_triangles(self):
        """They are positive in the plane and in space, also those of polygons that are not convex."""
        points = [(x, y, 0) for y in range(3) for x in range(3)]
        points[4] = (0.49, 0.49, 0)  # of which one face is a dart
        faces = [(a, a + 1, a + 4, a + 3) for a in (0, 1, 3, 4)]
        points += [(5, 0, 0), (7, 0, 0), (7, 2, 0), (6, 0.5, 0), (5, 2, 0)]  # without a chart
        faces += [tuple(range(9, 14))]
        model = self.write(points, faces)
        options = ["--component", "0"]
        result, told = self.output(model, options)
        self.assertIn("--triangles divides all polygons", told)
        self.assertIn("2 polygons have a reflex corner", told)
        self.assertTrue(any(len(face) > 3 for face in read_obj(result)[2]))
        for output in "out.obj", "out.ply":
            for more in [], ["--plain"], ["--texture", "checkerboard"]:
                with self.subTest(output=output, more=more):
                    result, told = self.output(model, [*options, *more, "--triangles"], output)
                    self.assertNotIn("--triangles", told)
                    self.assertNotIn("divided into triangles", told)
                    if output == "out.obj":
                        found, texture, corners, _ = read_obj(result)
                        triangles = [[v for v, _ in face] for face in corners]
                        uvs = [[texture[t] for _, t in face] for face in corners]
                    else:
                        found = [tuple(v[axis][0] for axis in "xyz") for v in read_ply(result, "vertex")]
                        triangles = [face["vertex_indices"] for face in read_ply(result)]
                        uvs = [list(zip(*[iter(face["texcoord"])] * 2)) for face in read_ply(result)]
                    self.assertEqual([len(triangle) for triangle in triangles], [3] * (4 * 2 + 3))
                    for k, (triangle, uv) in enumerate(zip(triangles, uvs)):
                        self.assertGreater(area(*(found[v] for v in triangle)), 0)
                        if k < 8:
                            self.assertGreater(area(*uv), 0)
                        else:
                            self.assertEqual(set(uv), {(0, 0)})

    def test_triangles_keep_the_rest(self):
        """Groups and materials stay with their faces."""
        model = self.hills()
        result, _ = self.output(model, ["--triangles"])

        def faces_by_statement(path):
            number, statement = {}, None
            for line in path.read_text().splitlines():
                if line[:7] == "usemtl ":
                    statement = len(number), line
                elif line[:2] == "f ":
                    number[statement] = number.get(statement, 0) + len(line.split()) - 3
            return number
        self.assertEqual(faces_by_statement(result), faces_by_statement(model))
        self.assertEqual({len(face) for face in read_obj(result)[2]}, {3})
        self.assertEqual(read_obj(result)[0], read_obj(model)[0])

    def test_coordinates_of_vertices(self):
        """They are those of faces, under all names; the points of the input come first."""
        for options in [], ["--ignore", "row_3"], ["--plain"], ["--triangles"], ["--seams-from", "uv"]:
            with self.subTest(options=options):
                bare = self.folder / "closed.obj"
                bare.write_text("".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1)) +
                                "g box\nf 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\ng row_3\nf 1 3 7 5\nf 2 6 8 4\n")
                model = self.hills() if "uv" in options else bare
                by_face, _ = self.output(model, options, "faces.ply")
                by_vertex, _ = self.output(model, [*options, "--ply-coordinates", "vertex"], "vertices.ply")
                points, vertices = read_ply(by_face, "vertex"), read_ply(by_vertex, "vertex")
                place = [tuple(v[axis] for axis in "xyz") for v in vertices]
                self.assertEqual(place[:len(points)], [tuple(v[axis] for axis in "xyz") for v in points])
                self.assertEqual(len(vertices) > len(points), "uv" not in options)
                for v in vertices:
                    self.assertEqual((v["s"], v["t"]), (v["u"], v["v"]))
                    self.assertEqual((v["s"], v["t"]), (v["texture_u"], v["texture_v"]))
                for face, other in zip(read_ply(by_face), read_ply(by_vertex), strict=True):
                    self.assertEqual(list(other), ["vertex_indices"])
                    uv = tuple(x for i in other["vertex_indices"] for x in vertices[i]["s"] + vertices[i]["t"])
                    self.assertEqual(uv, face["texcoord"])
                    self.assertEqual([place[i] for i in other["vertex_indices"]],
                                     [place[i] for i in face["vertex_indices"]])
                again = [self.output(path, ["--repack", "--repair-charts"], "again.ply") for path in (by_face, by_vertex)]
                self.assertFalse(any("without these properties" in told for _, told in again), again)

    def test_texture(self):
        """OBJ and PLY files name a picture from where they are."""
        model = self.hills()
        (self.folder / "pictures").mkdir()
        (self.folder / "out").mkdir()
        picture = self.folder / "pictures" / "my bark.png"
        picture.write_bytes(b"")
        result, told = self.output(model, ["--texture", picture], "out/hills.obj")
        self.assertEqual(told, "")
        others = read_obj(result)[3]
        self.assertEqual(others[:2], ["mtllib hills.mtl", "usemtl textured"])
        self.assertEqual(others[2:], read_obj(model)[3][1:])
        name = "map_Kd ../pictures/my bark.png\n"
        self.assertEqual((self.folder / "out/hills.mtl").read_text().split("\n", 1)[1],
                         f"newmtl rock\nKd 1 1 1\nd 1\n{name}newmtl grass\nKd 1 1 1\nd 0.5\n{name}"
                         f"newmtl textured\nKd 1 1 1\nd 1\n{name}")
        for options in [], ["--ply-coordinates", "vertex"], ["--plain"]:
            result, _ = self.output(model, ["--texture", picture, *options], "out/hills.ply")
            self.assertIn(b"\ncomment TextureFile ../pictures/my bark.png\n", result.read_bytes())
        self.check_refused(self.hills("valley.obj"), ["--texture", picture], "hills.obj",
                           ["hills.mtl' would overwrite the material file of the input"])

    def test_picture_to_come(self):
        """A note says so, but not of the image that the same run writes."""
        model, picture = self.hills(), self.folder / "later.png"
        _, told = self.output(model, ["--texture", picture])
        self.assertIn(f"--texture: there is no file '{picture}' yet", told)
        _, told = self.output(model, ["--texture", picture, "--chart-image", picture])
        self.assertEqual(told, "")
        self.assertTrue(picture.exists())
        self.check_refused(model, ["--texture", picture, "--picture", picture], "other.obj", ["--picture", "--texture"])

    def test_checkerboard(self):
        """A picture with the sides of a page"""
        model = self.hills()
        for options, size in ([], (512, 512)), (["--resolution", "1024x256"], (512, 128)):
            result, told = self.output(model, ["--texture", "checkerboard", *options], "board.obj")
            self.assertEqual(told, "")
            rows = gray_png((self.folder / "board_checkerboard.png").read_bytes())
            self.assertEqual((len(rows[0]), len(rows)), size)
            self.assertEqual(len({value for row in rows for value in row}), 2)
            self.assertNotEqual(rows[0][0], rows[0][16])
            self.assertEqual(rows[0][0], rows[16][16])
            self.assertIn("map_Kd board_checkerboard.png\n", result.with_suffix(".mtl").read_text())
        run, _, _ = self.run_program(model, ["--texture", "checkerboard"], "%_board.ply")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn(b"comment TextureFile hills_board_checkerboard.png\n",
                      (self.folder / "hills_board.ply").read_bytes())

    def materials_of(self, gltf, data):
        """The sets of coordinates that each primitive's material refers to, with the picture of each"""
        found = []
        for primitive in gltf["meshes"][0]["primitives"]:
            material, sets = gltf["materials"][primitive["material"]], {}
            places = {"base": material.get("pbrMetallicRoughness", {}).get("baseColorTexture"),
                      "occlusion": material.get("occlusionTexture"), "emissive": material.get("emissiveTexture"),
                      "specular": material.get("extensions", {}).get("KHR_materials_specular", {})
                      .get("specularTexture")}
            for place, texture in places.items():
                if texture:
                    sets[place] = texture.get("texCoord", 0)
                    self.assertIn(f"TEXCOORD_{sets[place]}", primitive["attributes"])
                    view = gltf["bufferViews"][gltf["images"][gltf["textures"][texture["index"]]["source"]]["bufferView"]]
                    first = view.get("byteOffset", 0)
                    if place != "base":
                        self.assertEqual(gray_png(data[first:first + view["byteLength"]]), [[0, 255], [255, 0]])
            if "occlusion" in sets:
                self.assertEqual(material["occlusionTexture"]["strength"], 0)
            if "emissive" in sets:
                self.assertEqual(material.get("emissiveFactor", [0, 0, 0]), [0, 0, 0])
            found.append(sets)
        return found

    def test_placeholder(self):
        """A picture that shows nothing refers to each set that tools should keep."""
        model = self.hills()
        plain, _ = self.output(model, [], "plain.glb")
        self.assertNotIn("images", read_glb(plain)[0])
        for options, sets in ([], {"occlusion": 0}), (["--uv-set", "1"], {"emissive": 0, "occlusion": 1}), \
                (["--plain"], {"occlusion": 0}):
            result, _ = self.output(model, ["--placeholder-texture", *options], "out.glb")
            gltf, data = read_glb(result)
            self.assertEqual(self.materials_of(gltf, data), [sets] * 2)
            self.assertEqual(len(gltf["images"]), 1)
            for given, material in zip(read_glb(plain)[0]["materials"], gltf["materials"], strict=True):
                self.assertEqual(material["pbrMetallicRoughness"], given["pbrMetallicRoughness"])

    def test_placeholder_from_gltf(self):
        """It takes a free place of each material; faces without coordinates keep their material."""
        plain, _ = self.output(self.hills(), [], "plain.glb")
        gltf, data = read_glb(plain)
        gltf["images"], gltf["textures"] = [{"uri": "bark.png"}], [{"source": 0}]
        texture, occlusion = {"index": 0}, {"occlusionTexture": {"index": 0}}
        (self.folder / "bark.png").write_bytes(b"\x89PNG\r\n\x1a\n")
        cases = [({}, "occlusion"), (occlusion, "emissive"),
                 ({**occlusion, "emissiveFactor": [1, 0, 0]}, "specular"),
                 ({**occlusion, "emissiveTexture": texture}, "specular")]
        for more, place in cases:
            with self.subTest(more=more):
                gltf["materials"] = [{"name": "a", **more, "pbrMetallicRoughness": {"baseColorTexture": texture}},
                                     {"name": "b"}]
                write_glb(self.folder / "given.glb", gltf, data)
                result, _ = self.output(self.folder / "given.glb", ["--placeholder-texture"], "out.glb")
                after, _ = read_glb(result)
                material = after["materials"][0]
                self.assertEqual(material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1)  # as before
                specular = material.get("extensions", {}).get("KHR_materials_specular")
                chosen = specular["specularTexture"] if place == "specular" else material[place + "Texture"]
                self.assertEqual((chosen["index"], chosen.get("texCoord", 0)), (1, 0))
                self.assertEqual("KHR_materials_specular" in after.get("extensionsUsed", []), place == "specular")
                for key in more:
                    if key.endswith("Texture"):
                        self.assertEqual(material[key]["texCoord"], 1)
        gltf["materials"][0] = {"name": "a", **occlusion, "emissiveTexture": texture,
                                "extensions": {"KHR_materials_unlit": {}}}
        gltf["extensionsUsed"] = ["KHR_materials_unlit"]
        write_glb(self.folder / "given.glb", gltf, data)
        self.check_refused(self.folder / "given.glb", ["--placeholder-texture"], "out.glb",
                           ["material 1 \"a\"", "--placeholder-texture"])
        del gltf["extensionsUsed"]
        for primitive in gltf["meshes"][0]["primitives"]:  # one material for both, of a mesh for each, or none
            del primitive["attributes"]["TEXCOORD_0"]
        gltf["meshes"] = [{"name": name, "primitives": [primitive]}
                          for name, primitive in zip(("one", "two"), gltf["meshes"][0]["primitives"])]
        gltf["nodes"], gltf["scenes"] = [{"mesh": 0}, {"mesh": 1}], [{"nodes": [0, 1]}]
        for material in 0, None:
            gltf["materials"] = [{"name": "a"}]
            for mesh in gltf["meshes"]:
                mesh["primitives"][0].pop("material", None)
                if material is not None:
                    mesh["primitives"][0]["material"] = material
            write_glb(self.folder / "given.glb", gltf, data)
            result, _ = self.output(self.folder / "given.glb", ["--placeholder-texture", "--ignore", "two"], "out.glb")
            after, _ = read_glb(result)
            used = [mesh["primitives"][0].get("material") for mesh in after["meshes"]]
            self.assertEqual(used[1], material)
            self.assertIn("occlusionTexture", after["materials"][used[0]])
            self.assertEqual(after["materials"][0], {"name": "a"})

    def test_what_excludes_one_another(self):
        """Options without effect are refused, by their names."""
        model = self.hills()
        for options, output, words in [
                (["--triangles"], "no.glb", ["--triangles needs --output NAME.obj or NAME.ply"]),
                (["--ply-coordinates", "vertex"], "no.obj", ["--ply-coordinates vertex needs --output NAME.ply"]),
                (["--ply-coordinates", "corner"], "no.ply", ["--ply-coordinates is 'corner'", "face", "vertex"]),
                (["--ply-coordinates", "vertex", "--uv-set", "1"], "no.ply", ["--ply-coordinates vertex and --uv-set 1"]),
                (["--texture", "a.png"], "no.glb", ["--texture needs --output NAME.obj or NAME.ply"]),
                (["--texture", ""], "no.obj", ["--texture"]),
                (["--texture", "a.png", "--uv-set", "1"], "no.ply", ["--texture and --uv-set 1"]),
                (["--texture", "a.<UDIM>.png"], "no.ply", ["--texture with <UDIM> needs --output NAME.obj"]),
                (["--texture", "a.png", "--bake-from", model], "no.obj", ["--texture and --bake-from"]),
                (["--placeholder-texture"], "no.obj", ["--placeholder-texture needs --output NAME.glb"]),
                (["--placeholder-texture", "--bake-from", model], "no.glb", ["--placeholder-texture and --bake-from"])]:
            self.check_refused(model, options, output, words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
