#!/usr/bin/env python3
"""Runs flatten_mesh on dirty files, each written here with what has to come of it.

Each case is a row `add(name, content, ...)` below. For each, the program must end in time with the expected status, not
by a signal; its report must be strict JSON in UTF-8; standard error must have whole lines of the program, one of which
says what is wrong and where; and the OBJ that it writes, if any, must be well-formed and have the faces of the input.

Usage: test_dirt.py FLATTEN_MESH [NAME...]    (only the cases with these names)
       test_dirt.py --seeds FOLDER            (writes the contents for fuzz_readers, after a byte for the format)
"""
import base64
import concurrent.futures
import gzip
import json
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
import threading

SECONDS = 60  # for a case, on any machine

cases = []


def add(name, content, status=0, says=None, skipped=(), faces=None, file=None, options=(), setup=None):
    """A case: the content of a file, and what is expected.

    status: exit status. says: pattern of a line on standard error (of the message, if something is wrong as a whole).
    skipped: (diagnosis, number of faces) of each part that is left out. faces: lines 'f' in the OBJ output; none if
    not given and the status is not 0. file: name of the file, otherwise made of NAME, whose first word is the format.
    setup: called with the path and the content in place of writing it.
    """
    if isinstance(content, str):
        content = content.encode()
    assert name not in [case["name"] for case in cases], name
    cases.append(dict(name=name, content=content, status=status, says=says, skipped=list(skipped), faces=faces,
                      file=file or re.sub(r"\W+", "_", name) + "." + name.split()[0], options=list(options),
                      setup=setup))


# ---- surfaces and formats ------------------------------------------------------------------------------------------

POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
FACES = [(0, 1, 2), (0, 2, 3)]
# A sheet, and apart from it a second one
TWO_POINTS = POINTS + [(x + 5, y, z) for x, y, z in POINTS]
TWO_FACES = FACES + [tuple(v + 4 for v in face) for face in FACES]
NONE = [("NON_FINITE_POINT", 2)]


def row(numbers):
    return " ".join(str(n) for n in numbers)


def off(points=POINTS, faces=FACES, header=None):
    lines = [header if header is not None else f"OFF\n{len(points)} {len(faces)} 0"]
    lines += [row(p) for p in points] + [row((len(f),) + tuple(f)) for f in faces]
    return "\n".join(lines) + "\n"


def obj(points=POINTS, faces=FACES):
    return "".join(f"v {row(p)}\n" for p in points) + "".join(f"f {row(v + 1 for v in f)}\n" for f in faces)


def ply_header(vertices=4, faces=2, kind="ascii", count="uchar", index="int", more=""):
    return (f"ply\nformat {kind} 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {faces}\nproperty list {count} {index} vertex_indices\n{more}end_header\n")


def ply(points=POINTS, faces=FACES, **header):
    lines = [row(p) for p in points] + [row((len(f),) + tuple(f)) for f in faces]
    return ply_header(len(points), len(faces), **header) + "\n".join(lines) + "\n"


CODES = dict(char="b", uchar="B", short="h", ushort="H", int="i", uint="I", float="f", double="d", int64="q")


def binary_ply(points=POINTS, faces=FACES, order="<", count="uchar", index="int", vertices=None, number=None):
    kind = "binary_little_endian" if order == "<" else "binary_big_endian"
    header = ply_header(len(points) if vertices is None else vertices, len(faces) if number is None else number, kind,
                        count, index)
    data = b"".join(struct.pack(order + "3f", *map(float, p)) for p in points)
    for face in faces:
        data += struct.pack(order + CODES[count], len(face))
        data += struct.pack(order + str(len(face)) + CODES[index], *face)
    return header.encode() + data


def stl(points=POINTS, faces=FACES, name="sheet"):
    text = f"solid {name}\n"
    for face in faces:
        text += "facet normal 0 0 1\nouter loop\n"
        text += "".join(f"vertex {row(points[v])}\n" for v in face) + "endloop\nendfacet\n"
    return text + f"endsolid {name}\n"


def binary_stl(points=POINTS, faces=FACES, header=b"", count=None):
    data = header.ljust(80, b" ") + struct.pack("<I", len(faces) if count is None else count)
    for face in faces:
        data += struct.pack("<3f", 0, 0, 1) + b"".join(struct.pack("<3f", *map(float, points[v])) for v in face)
        data += b"\0\0"
    return data


def ts(points=POINTS, faces=FACES, first=1, end="END\n"):
    return ("GOCAD TSurf 1\nHEADER {\nname: sheet\n}\nTFACE\n"
            + "".join(f"VRTX {i + first} {row(p)}\n" for i, p in enumerate(points))
            + "".join(f"TRGL {row(v + first for v in f)}\n" for f in faces) + end)


WRITERS = dict(off=off, obj=obj, ply=ply, stl=stl, ts=ts)


def replaced(points, index, point):
    return points[:index] + [point] + points[index + 1:]


# Content that can be read once only
def pipe(path, content):
    def feed():
        with open(path, "wb") as file:
            file.write(content)

    os.mkfifo(path)
    threading.Thread(target=feed, daemon=True).start()


def junk(seed, size=5000):
    return random.Random(seed).randbytes(size)


# ---- what every format has -----------------------------------------------------------------------------------------

for form, write in WRITERS.items():
    text = write()
    add(f"{form} plain", text, faces=2)
    add(f"{form} of 0 bytes", "", 2, "is empty")
    add(f"{form} of blanks", " \n\t\n\n", 2, rf"{form}")
    add(f"{form} of comments only", "# nothing\n# here\n", 2, rf"{form}")
    add(f"{form} with Windows line ends", text.replace("\n", "\r\n"), faces=2)
    add(f"{form} with Mac line ends", text.replace("\n", "\r"), faces=2)
    add(f"{form} with mixed line ends", text.replace("\n", "\r\n", 3).replace("\n", "\r", 2), faces=2)
    add(f"{form} with a byte order mark", b"\xef\xbb\xbf" + text.encode(), faces=2)
    add(f"{form} of junk", junk(1), 2, rf"{form}")
    add(f"{form} of NUL bytes", b"\0" * 500, 2, rf"{form}")
    add(f"{form} of one NUL byte", b"\0", 2, rf"{form}")
    add(f"{form} of bytes 255", b"\xff" * 500, 2, rf"{form}")
    add(f"{form} with junk after the first half", text[:len(text) // 2].encode() + junk(2), 2, rf"{form}")
    add(f"{form} compressed by gzip", gzip.compress(text.encode(), mtime=0), 2, "looks compressed")
    add(f"{form} in UTF-16", text.encode("utf-16"), 2, "looks UTF-16")
    add(f"{form} of one long line", "x" * 3000000, 2, rf"{form}")
    add(f"{form} that is a folder", "", 2, "is a folder", setup=lambda path, content: os.mkdir(path))
    add(f"{form} with blanks in its name", text, faces=2, file=f"my  own sheet.{form}")
    add(f"{form} with quotes in its name", text, faces=2, file=f"my \"own\" 'sheet'.{form}")
    add(f"{form} with a line end in its name", text[:20], 2, r"my\\x0asheet", file=f"my\nsheet.{form}")
    add(f"{form} with bytes that are no UTF-8 in its name", text[:20], 2, "sheet",
        file=os.fsdecode(b"\xff\xc3 sheet." + form.encode()))
    add(f"{form} with an extension in capitals", text, faces=2, file=f"capitals.{form.upper()}")
    for word in ["nan", "NaN", "-nan(ind)", "inf", "-Infinity", "1.#QNAN", "-1.#IND", "1.#INF", "1e999"]:
        add(f"{form} with the coordinate {word}", write(replaced(TWO_POINTS, 6, (6, word, 0)), TWO_FACES), 2,
            "vertex .* not all finite numbers", NONE, faces=4)
    add(f"{form} with NaN at a corner of one face", write(replaced(TWO_POINTS, 5, (6, "nan", 0)), TWO_FACES), 2,
        "vertex .* not all finite numbers", [("NON_FINITE_POINT", 1)], faces=4)
    add(f"{form} with NaN at two corners", write([(1, "nan", 0), ("inf", 1, 0)] + TWO_POINTS,
                                                 [(0, 3, 4), (1, 2, 4)] + [tuple(v + 2 for v in f) for f in TWO_FACES]),
        2, "vertex .* and 1 other have coordinates that are not all finite", [("NON_FINITE_POINT", 2)], faces=6)
    add(f"{form} with a corner far away", write(replaced(TWO_POINTS, 5, (6, 1e20, 0)), TWO_FACES), 2,
        "vertex .* is more than a billion times as far", [("FAR_POINT", 1)], faces=4)
    for word in ["1,5", "zero", "0x1p3", "1.0f", "--1", "1.2.3"]:
        add(f"{form} with the coordinate {word}", write(replaced(POINTS, 2, (1, word, 0))), 2,
            rf"line \d+: .*'{re.escape(word)}'")
    add(f"{form} with tiny and large numbers", write(replaced(POINTS, 2, ("1e-999", "1.5e0", "+1"))), faces=2)
    add(f"{form} with a coordinate missing", write(replaced(POINTS, 1, (1, 0))), 2, r"line \d+: .*(fewer|not)")
    add(f"{form} from a pipe", text, faces=2, setup=pipe)
    add(f"{form} from an empty pipe", "", 2, "is empty", setup=pipe)
    add(f"{form} with plain options", text, faces=2, options=["--plain"])

for form, other in [("obj", "ply"), ("ply", "obj"), ("off", "stl"), ("stl", "off"), ("obj", "off"), ("off", "ply"),
                    ("ts", "ply"), ("stl", "ply")]:
    add(f"{form} that is {other}", WRITERS[other](), 2, rf"{form}", file=f"is_{other}.{form}")
add("xyz is no format", off(), 2, "must end with .off")
add("vtp is not read by every build", "<VTKFile/>", 2, "vtp")
add("off whose name has no extension", off(), 2, "must end with", file="no_extension")
if os.geteuid() != 0:
    add("off without permission", "", 2, "check its permissions", setup=lambda path, content: os.mkfifo(path, 0))
add("off that is not there", "", 2, "there is no file", setup=lambda path, content: None)

add("off behind a pipe without extension and format", off(), 2, "--format", file="pipe",
    setup=lambda path, content: os.mkfifo(path))
add("off from a pipe without extension", off(), faces=2, file="pipe", options=["--format", "off"], setup=pipe)
add("obj from a pipe that is said to be OFF", off(), faces=2, options=["--format", "off"], setup=pipe)

# ---- OFF -----------------------------------------------------------------------------------------------------------

add("off with counts in the first line", off(header="OFF 4 2 0"), faces=2)
add("off with the first count in the same word", off(header="OFF4 2 0"), faces=2)
add("off with another word before the counts", off(header="OFFER 4 2 0"), 2, "begins with OFF")
add("off with a count in each line", off(header="OFF\n4\n2\n0"), faces=2)
add("off with empty lines and comments", "\n# a\n  \n" + off().replace("\n", " # b\n\n#c\n"), faces=2)
add("off with leading blanks", "  " + off().replace("\n", "\n\t "), faces=2)
add("off with faces over several lines", off(POINTS, []).replace(" 0 0\n", " 1 0\n", 1) + "4 0\n1\n\n2 3\n", faces=1)
add("off with a word in each line", off().replace(" ", "\n"), faces=2)
for kind, numbers in [("COFF", "255 0 0"), ("COFF", "255 0 0 255"), ("COFF", "0.5 0 1.0 0.5"), ("COFF", "3"),
                      ("COFF", ""), ("NOFF", "0 0 1"), ("CNOFF", "0 0 1 255 0 0"), ("NCOFF", "0 0 1 255 0 0 9"),
                      ("STOFF", "0.5 0.25"), ("STCOFF", "1 2 3 0.5 0.5"), ("STCNOFF", "0 0 1 1 2 3 4 0.5 0.5"),
                      ("4OFF", "2")]:
    add(f"off {kind} with '{numbers}'", off([p + (numbers,) for p in POINTS], header=f"{kind}\n4 2 0"), faces=2)
add("off with colours of faces", off(faces=[f + (255, 0, 0) for f in FACES]).replace("\n6 ", "\n3 "), faces=2)
add("off with normals missing", off(header="NOFF\n4 2 0"), 2, r"line \d+: vertex \d has fewer")
add("off that is binary", b"OFF BINARY\n" + b"\0" * 40, 2, "binary OFF files are not read")
add("off without its keyword", off(header="4 2 0"), 2, "line 1: an OFF file begins with OFF")
add("off with two counts", off(header="OFF\n4 2"), 2, "line 2: an OFF file begins with OFF and the numbers")
add("off with negative counts", off(header="OFF\n-4 -2 0"), 2, "line 2: .*numbers of its vertices")
add("off with half counts", off(header="OFF\n4.5 2 0"), 2, "line 2: .*numbers of its vertices")
add("off with its header twice", "OFF\n4 2 0\n" + off(), 2, r"line 3: .*'OFF' of vertex 1")
add("off with too many vertices promised", off(header="OFF\n5 2 0"), 2, "promises 5 vertices and 2 faces.*with 5 and|"
    "names vertex|begins with|fewer")
add("off with 4000000000000000000 vertices promised", off(header="OFF\n4000000000000000000 1 0"), 2,
    "promises 4000000000000000000 vertices and 1 face, but the file ends after line 8")
add("off with 4000000000 vertices promised", off(POINTS, [], "OFF\n4000000000 4000000000 0"), 2,
    "promises 4000000000 vertices and 4000000000 faces, but the file ends after line 6 with 4 and 0")
add("off with too many faces promised", off(header="OFF\n4 3 0"), 2, "promises 4 vertices and 3 faces.*with 4 and 2")
add("off with a face of 2 billion corners", off(faces=[], header="OFF\n4 1 0") + "2000000000 0 1 2\n", 2,
    "line 7: face 1 has fewer vertices than its count, 2000000000")
add("off with counts beyond all numbers", off(header="OFF\n99999999999999999999 1 0"), 2, "line 2")
add("off with a vertex that does not exist", off(faces=[(0, 1, 4)]), 2, "line 7: face 1 names vertex '4'")
add("off with a negative vertex", off(faces=[(0, 1, -1)]), 2, "line 7: face 1 names vertex '-1'")
add("off with floating indices", off(faces=[("0.0", "1.0", "2.0")]), 2, r"line 7: face 1 names vertex '0.0'")
add("off with a face of 0 corners", off(faces=[(0, 1, 2), ()]), 2, "line 8: face 2 has no vertices")
add("off with a face of 1 corner", off(faces=[(0, 1, 2), (0,)]), 2, "face 2 has fewer than three",
    [("DEGENERATE_FACE", 1)], faces=2)
add("off with a face of 2 corners", off(faces=[(0, 1), (0, 1, 2)]), 2, "face 1 has fewer than three",
    [("DEGENERATE_FACE", 1)], faces=2)
add("off with no face", off(faces=[]), 2, "vertices but no faces")
add("off with no vertex", off([], []), 2, "no vertices")
add("off cut short in a vertex", off()[:24], 2, "cut short")
add("off cut short in a face", off()[:-4], 2, "line 8: .*cut short")
add("off with a vertex whose rest comes later", off(replaced(POINTS, 1, (1, 0))), 2, "line 4: vertex 2 has fewer")

# ---- OBJ -----------------------------------------------------------------------------------------------------------

V = obj(POINTS, [])
add("obj with vertex 0", V + "f 0 1 2\n", 2, "line 5: the face names vertex 0")
add("obj with a vertex too large", V + "f 1 2 5\n", 2, "line 5: the face names vertex 5")
add("obj with a huge vertex", V + "f 1 2 4000000000000\n", 2, "line 5: .*4000000000001?.*does not exist")
add("obj with a vertex beyond all numbers", V + "f 1 2 99999999999999999999\n", 2, "line 5: .*99999999999999999999")
add("obj with relative vertices", V + "f -4 -3 -2\nf -4 -2 -1\n", faces=2)
add("obj with relative vertices too far", V + "f -5 -3 -2\n", 2, "line 5: .*vertex -5")
add("obj with floating indices", V + "f 1.0 2.0 3.0\n", 2, r"line 5: .*'1\.0'")
add("obj with a face of 0 corners", V + "f\nf 1 2 3\n", 2, "line 5: the face has no vertices")
add("obj with a face of 1 corner", V + "f 1\nf 1 2 3\n", 2, "face 1 has fewer", [("DEGENERATE_FACE", 1)], faces=2)
add("obj with a face of 2 corners", V + "f 1 2\nf 1 2 3\n", 2, "face 1 has fewer", [("DEGENERATE_FACE", 1)], faces=2)
add("obj with lines that go on", V.replace("v 1 1 0", "v 1 \\\n1 \\\r\n 0") + "f 1 \\\n2 3\\\n 4\n", faces=1)
add("obj with a backslash at the end", V + "f 1 2 3 \\", faces=1)
add("obj with backslashes only", "\\\n" * 1000, 2, "no vertices")
add("obj with slashes only", V + "f / / /\n", 2, "line 5: .*'/'")
add("obj with too many slashes", V + "f 1//// 2//// 3////\n", says="not understood|note", faces=1)
add("obj with attributes that do not exist", V + "f 1/9/9 2/9/9 3/9/9\n", says="do not exist", faces=1)
add("obj with unknown words", "call other.obj\n" + V + "f 1 2 3\ncurv 0 1 1 2\n", says="line 1.*'call'", faces=1)
add("obj with names that are no UTF-8", V.encode() + b"g gr\xfcn\nusemtl \xff\xfe\nf 1 2 3\n", faces=1)
add("obj with words that are no UTF-8", b"\xff\xfe 1 2\n" + V.encode() + b"f 1 2 3\n", says="line 1", faces=1)
add("obj with a coordinate that is no UTF-8", b"v 0 \xff\x01 0\n", 2, r"line 1: .*\\x01.* is not a number")
add("obj with NUL bytes in it", V.encode() + b"f 1 2 3\0\n", 2, "line 5")
add("obj with three faces without area apart", obj(POINTS + [(10 * k + i, 0, 0) for k in (1, 2, 3) for i in range(3)],
                                                   FACES + [(4, 5, 6), (7, 8, 9), (10, 11, 12)]), 2,
    "no chart for 3 faces, the first is face 3: NO_AREA: ", [("NO_AREA", 3)], faces=5)
add("obj with two parts turned inside out", obj(TWO_POINTS, [(0, 1, 2), (0, 3, 2), (4, 5, 6), (4, 7, 6)]) +
    obj([(0, 9, 9), (0, 8, 9), (0, 9, 8)], []) + "f 9 10 11\n", 2,
    "no chart for 2 parts with 4 faces, the first is face 1: ", [("INCONSISTENT_ORIENTATION", 2)] * 2, faces=5,
    options=["--repair", "off"])
for options in ([], ["--plain"]):
    add(f"obj with vertices twice in a row {options}", V + "f 1 2 2 3 3\nf 1 1 3 4 1\n", faces=2, options=options,
        says="2 faces name a vertex twice in a row, .* the first is face 1")
add("obj with a face of two vertices, each twice", V + "f 1 1 2 2\nf 1 2 3\n", 2, "face 1 names vertex",
    [("DEGENERATE_FACE", 1)], faces=2)
add("obj with a long line", V + "f " + "1 2 3 " * 200000 + "\n", 2, "face 1 names vertex 1 .0, 0, 0. twice",
    [("DEGENERATE_FACE", 1)])
add("obj with a long comment", "#" + "x" * 1000000 + "\n" + V + "f 1 2 3\n", faces=1)
add("obj with faces before vertices", "f 1 2 3\nf 1 3 4\n" + V, faces=2)
add("obj with points only", V, 2, "vertices but no faces")
add("obj with lines only", V + "l 1 2 3\n", 2, "vertices but no faces")
add("obj with two coordinates", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", 2, "line 1: .*fewer than three")
add("obj with weights", V.replace(" 0\n", " 0 1.0\n") + "f 1 2 3\n", faces=1)
add("obj with colours that are none", V.replace(" 0\n", " 0 1 nan x\n") + "f 1 2 3\n", says="colour", faces=1)
add("obj with a material file that is a folder", "mtllib .\nusemtl a\n" + V + "f 1 2 3\n", faces=1)

# Polygons with an edge of no length, of which more than two meet at other edges
BENT_POINTS = [(1, 1, -1), (0, 1, 0), (1, 0, 0), (-1, -1, 0), (0, 0, 1), (-1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, -1),
               (0, 0, -1), (0, 2, -1), (1, -1, -1), (0, 1, 1)]
BENT_FACES = [(3, 9, 12), (5, 0, 12, 3), (9, 11, 5, 6, 4), (6, 11, 7, 8, 4), (9, 0, 2, 4), (5, 0, 9, 6), (2, 12, 4, 3),
              (3, 1, 7, 9, 11), (11, 7, 1, 10, 0)]
add("obj of polygons with an edge of no length", obj(BENT_POINTS, BENT_FACES), faces=16)

# ---- PLY -----------------------------------------------------------------------------------------------------------

for order in "<>":
    end = "little" if order == "<" else "big"
    add(f"ply binary, {end} end first", binary_ply(order=order), faces=2, file=f"binary_{end}.ply")
    for count, index in [("int", "uint"), ("ushort", "short"), ("char", "uchar"), ("uint", "int64"),
                         ("uchar", "ushort")]:
        add(f"ply binary, {end}, lists of {count} and {index}", binary_ply(order=order, count=count, index=index),
            faces=2)
    add(f"ply binary, {end}, with NaN", binary_ply(replaced(TWO_POINTS, 6, (6, "nan", 0)), TWO_FACES, order), 2,
        "vertex 7 .*not all finite", NONE, faces=4)
    add(f"ply binary, {end}, with a list of 4000000000", binary_ply(order=order, count="uint")[:-16]
        + struct.pack(order + "I", 4000000000) + b"\0" * 12, 2, "promises 2 of 'face', but the file ends in face 2")
    add(f"ply binary, {end}, with a negative list", binary_ply(order=order, count="int")[:-16]
        + struct.pack(order + "i", -3) + b"\0" * 12, 2, "face 2 has a list of -3 numbers")
    add(f"ply binary, {end}, with too many vertices", binary_ply(order=order, vertices=4000000000), 2,
        "promises 4000000000 of 'vertex'")
    add(f"ply binary, {end}, with too many faces", binary_ply(order=order, number=9), 2,
        "promises 9 of 'face', but the file ends in face 3")
    add(f"ply binary, {end}, with a negative vertex", binary_ply(faces=[(0, 1, -1)], order=order), 2,
        "face 1 names vertex '-1'")
add("ply binary with a Mac header", binary_ply().replace(b"\n", b"\r", 10), faces=2)
add("ply binary with a Mac header, then a byte like a line end",
    binary_ply([(struct.unpack("<f", b"\n\0\0\0")[0], 0, 0)] + POINTS[1:]).replace(b"\n", b"\r", 9), faces=2)
add("ply binary with a Windows header", binary_ply().replace(b"\n", b"\r\n", 9), faces=2)
add("ply binary, cut short", binary_ply()[:-5], 2, "ends in face 2: it was cut short")
add("ply binary, cut short in the header", binary_ply().split(b"end_header")[0], 2, "header of the file has no end")
add("ply with strips", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n",
    faces=2)
add("ply with strips that begin again", ply(TWO_POINTS, [(0, 1, 3, 2, -1, 4, 5, 7, 6, -1, -1, 0)]).replace(
    "element face", "element tristrips").replace("uchar", "int"), faces=4)
add("ply with a strip to nowhere", ply(faces=[(0, 1, 3, 9)]).replace("element face", "element tristrips"), 2,
    "line 14: item 1 of 'tristrips' names vertex '9'")
add("ply with further elements",
    ply(more="element edge 1\nproperty int a\nproperty list uchar float b\n") + "1 2 0 0\n", faces=2)
add("ply with a further element without properties", ply(more="element nothing 4000000000\n"), faces=2)
add("ply with vertices after faces", ply_header().replace("element vertex 4\nproperty float x\nproperty float y\n"
    "property float z\n", "").replace("end_header\n", "element vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nend_header\n") + "3 0 1 2\n3 0 2 3\n" + "".join(row(p) + "\n" for p in POINTS), faces=2)
add("ply with vertices twice", ply(more="element vertex 1\nproperty float x\nproperty float y\nproperty float z\n")
    + "0 0 0\n", 2, "vertices twice")
add("ply with a header twice", ply_header() + ply(), 2, "line 10: the value 'ply' of vertex 1")
add("ply without format", ply().replace("format ascii 1.0\n", ""), 2, "no line 'format'")
add("ply with an unknown format", ply().replace("ascii", "morse"), 2, "line 2: the format 'morse'")
add("ply with an unknown type", ply().replace("float y", "complex y"), 2, "line 5: the type 'complex'")
add("ply with an unknown word", ply().replace("property float y", "propertyfloaty"), 2, "line 5: 'propertyfloaty'")
add("ply with a property before elements", ply().replace("format", "property float a\nformat"), 2, "line 2: a property")
add("ply with a negative count", ply_header(vertices=-4), 2, "line 3: '-4' is not a number of elements")
add("ply without coordinates", ply().replace("float z", "float w"), 2, "no properties 'x', 'y' and 'z'")
add("ply without a list of vertices", ply().replace("vertex_indices", "corners"), 2, "no list 'vertex_indices'")
add("ply whose vertices of faces are no list", ply().replace("list uchar int", "int"), 2, "no list 'vertex_indices'")
add("ply with lists as coordinates", ply().replace("float z", "list uchar float z"), 2, "no properties")
add("ply of points", ply(faces=[]), 2, "vertices but no faces")
add("ply with too few numbers in a line", ply(replaced(POINTS, 1, (1, 0))), 2, "line 11: vertex 2 has fewer numbers")
add("ply with too few numbers in the last line", ply()[:-3] + "\n", 2, "ends after line 15 in face 2")
add("ply with too many numbers in a line", ply(replaced(POINTS, 1, (1, 0, 0, 7))), faces=2)
add("ply with floating indices", ply(faces=[(0, 1, "1.5")]), 2, "line 14: face 1 names vertex '1.5'")
add("ply with a negative list", ply_header(4, 1) + "".join(row(p) + "\n" for p in POINTS) + "-3 0 1 2\n", 2,
    "line 14: face 1 has a list of -3")
add("ply with a vertex that does not exist", ply(faces=[(0, 1, 9)]), 2, "line 14: face 1 names vertex '9'")
add("ply with a face of 0 corners", ply(faces=[(0, 1, 2), ()]), 2, "line 15: face 2 has no vertices")
add("ply with a face of 2 corners", ply(faces=[(0, 1, 2), (0, 1)]), 2, "face 2 has fewer", [("DEGENERATE_FACE", 1)],
    faces=2)
add("ply with 4000000000 faces promised", ply().replace("element face 2", "element face 4000000000"), 2,
    "promises 4000000000 of 'face', but the file ends after line 15")
add("ply of a header only", ply_header(0, 0), 2, "no vertices")
add("ply of its first word", "ply", 2, "line 2: the header of the file has no end|line 1")

# ---- STL -----------------------------------------------------------------------------------------------------------

add("stl binary", binary_stl(), faces=2)
add("stl binary whose header begins with solid", binary_stl(header=b"solid sheet"), faces=2)
add("stl binary that begins with solid, and a wrong count", binary_stl(header=b"solid sheet", count=7), 2,
    "promises 7 triangles, but the file ends after 2")
add("stl binary with 4000000000 triangles promised", binary_stl(count=4000000000), 2, "promises 4000000000 triangles")
add("stl binary with too few triangles promised", binary_stl(count=1), 2, "promises 1 triangle, .*room for 2")
add("stl binary with no triangle promised", binary_stl(count=0), 2, "promises 0 triangles, .*room for 2")
add("stl binary with no triangle", binary_stl(faces=[]), 2, "no vertices")
add("stl binary, cut short", binary_stl()[:-7], 2, "promises 2 triangles, but the file ends after 1")
add("stl binary, cut short in the header", binary_stl()[:50], 2, "84 bytes")
add("stl binary with padding", binary_stl() + b"\0" * 30, faces=2)
add("stl binary with NaN", binary_stl(replaced(TWO_POINTS, 6, (6, "nan", 0)), TWO_FACES), 2,
    "vertex 7 .6, nan, 0.* not all finite", NONE, faces=4)
add("stl with words in capitals", stl().upper(), faces=2)
add("stl in one line for each facet",
    stl().replace("\nouter", " outer").replace("\nvertex", " vertex").replace("\nend", " end"), faces=2)
add("stl of several solids", stl() + stl([(x, y, 5) for x, y, z in POINTS], name="other"), faces=4)
add("stl with a facet of two vertices", stl(faces=[(0, 1)]), 2, "line 7: the facet has fewer than three")
add("stl with a facet of four vertices", stl(faces=[(0, 1, 2, 3)]), faces=1)
add("stl without endfacet", stl().replace("endfacet\n", ""), faces=2)
add("stl with 'end loop' and 'end facet'", stl().replace("\nend", "\nend "), faces=2)
add("stl with remarks after the vertices", stl().replace("endloop", "close 1 2"), faces=2)
add("stl with endfacet twice", stl().replace("endfacet", "endfacet\nendfacet"), 2,
    "line 9: the facet has fewer than three")
add("stl without endsolid", stl().replace("endsolid sheet\n", ""), 2, "without 'endsolid', so it was cut short")
add("stl cut short in a facet", stl().split("endloop")[0], 2, "line 7: .*cut short")
add("stl cut short in a word", stl().split("er loop")[0], 2, "line 3: 'out' is not a keyword")
add("stl with no facet", stl(faces=[]), 2, "no vertices")
add("stl with a foreign word", stl().replace("outer", "inner"), 2, "line 3: 'inner' is not a keyword")
add("stl of the same corner thrice", stl(faces=[(0, 0, 0), (0, 1, 2)]), 2, "face 1 names vertex 1 .0, 0, 0. twice",
    [("DEGENERATE_FACE", 1)], faces=2)

# ---- GOCAD ---------------------------------------------------------------------------------------------------------

add("ts that counts from 0", ts(first=0), faces=2)
add("ts that counts from 1000", ts(first=1000), faces=2)
add("ts without END", ts(end=""), 2, "without END, so it was cut short")
add("ts of two surfaces", ts() + ts([(x, y, 5) for x, y, z in POINTS]), faces=4)
add("ts with a vertex that does not exist", ts(faces=[(0, 1, 8)]), 2, "line 10: vertex 9 does not exist")
add("ts with a vertex twice", ts().replace("VRTX 2", "VRTX 1"), 2, "line 7: there are two vertices 1")
add("ts with a short triangle", ts(faces=[(0, 1)]), 2, "line 10: TRGL has fewer than 3")
add("ts with atoms", ts(faces=[], end="") + "ATOM 5 1\nTRGL 5 2 3\nTRGL 5 3 4\nEND\n", faces=2)
add("ts with properties", ts().replace("VRTX", "PVRTX").replace(" 0\n", " 0 17.5 -99999\n"), faces=2)


# ---- the runs ------------------------------------------------------------------------------------------------------

class Fault(Exception):
    pass


def require(condition, what):
    if not condition:
        raise Fault(what)


def check_obj(path, faces):
    """Every vertex and texture coordinate that a face names exists, and there are as many faces as expected."""
    counts = {b"v": 0, b"vt": 0, b"vn": 0}
    corners = []
    with open(path, "rb") as file:
        for line in file.read().split(b"\n"):
            words = line.split()
            if words and words[0] in counts:
                counts[words[0]] += 1
            elif words and words[0] == b"f":
                corners.append(words[1:])
    require(len(corners) == faces, f"{len(corners)} faces in the output instead of {faces}")
    for face in corners:
        require(face, "a face without corners in the output")
        for corner in face:
            for index, kind in zip(corner.split(b"/"), (b"v", b"vt", b"vn")):
                require(index == b"" and kind != b"v" or 1 <= int(index) <= counts[kind],
                        f"corner {corner} in the output")


def check_errors(case, errors, report):
    lines = errors.decode("utf-8", "replace").split("\n")
    require(lines.pop() == "", f"standard error does not end with a line end: {errors!r}")
    for line in lines:
        require(line.startswith("flatten_mesh: ") and line.isprintable(), f"on standard error: {line!r}")
    is_wrong = case["status"] != 0 and not case["skipped"]
    require(not is_wrong or len([line for line in lines if ": note: " not in line]) == 1,
            f"not one line on standard error: {lines}")
    if case["says"]:
        texts = lines + ([report["message"]] if is_wrong else [])
        require(any(re.search(case["says"], line) for line in lines), f"nobody says '{case['says']}': {texts}")


def run(program, folder, number, case):
    place = os.path.join(folder, str(number))
    os.mkdir(place)
    path, output, report_file = (os.path.join(place, name) for name in (case["file"], "out.obj", "out.json"))
    if case["setup"]:
        case["setup"](path, case["content"])
    else:
        with open(path, "wb") as file:
            file.write(case["content"])
    command = [program, path, "--output", output, "--json", report_file] + case["options"]
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
    try:
        result = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS,
                                env=environment)
    except subprocess.TimeoutExpired:
        raise Fault("does not end")
    require(result.returncode == case["status"], f"status {result.returncode}: {result.stderr!r}")
    with open(report_file, "rb") as file:
        report = json.loads(file.read().decode("utf-8"), parse_constant=lambda word: require(False, word))
    check_errors(case, result.stderr, report)
    skipped = sorted((part["diagnosis"], part["faces"]) for part in report.get("skipped", []))
    require(skipped == sorted(case["skipped"]), f"skipped: {skipped}")
    require(os.path.exists(output) == (case["faces"] is not None), "an output, or none")
    if case["faces"] is not None:
        check_obj(output, case["faces"])


def gltf(is_binary):
    """Two meshes of one sheet, with coordinates and a texture, and a node that shows the first twice."""
    positions = b"".join(struct.pack("<3f", *p) for p in POINTS)
    data = positions + b"".join(struct.pack("<2f", *p[:2]) for p in POINTS) + struct.pack("<6H", *sum(FACES, ()))
    uri = {} if is_binary else {"uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}
    content = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}, {"mesh": 1, "scale": [-1, 1, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]},
                   {"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}],
        "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": offset, "byteLength": length}
                        for offset, length in ((0, 48), (48, 32), (80, 12))],
        "buffers": [{"byteLength": len(data), **uri}]}
    text = json.dumps(content).encode()
    if not is_binary:
        return text
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def write_seeds(folder):
    for is_binary in (False, True):
        with open(os.path.join(folder, f"gltf{int(is_binary)}"), "wb") as file:
            file.write(bytes([len(WRITERS)]) + gltf(is_binary))
    for number, case in enumerate(cases):
        form = case["name"].split()[0]
        if form in WRITERS and len(case["content"]) < 2000:
            with open(os.path.join(folder, f"seed{number}"), "wb") as file:
                file.write(bytes([list(WRITERS).index(form)]) + case["content"])


def main():
    if sys.argv[1] == "--seeds":
        return write_seeds(sys.argv[2])
    program, names = sys.argv[1], sys.argv[2:]
    chosen = [case for case in cases if not names or case["name"] in names]
    faults = 0
    with tempfile.TemporaryDirectory(prefix="test_dirt_") as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        runs = [pool.submit(run, program, folder, number, case) for number, case in enumerate(chosen)]
        for case, one in zip(chosen, runs):
            try:
                one.result()
            except (Fault, OSError, ValueError, KeyError) as fault:
                faults += 1
                print(f"{case['name']}: {type(fault).__name__}: {fault}")
    print(f"{len(chosen)} cases, {faults} wrong")
    return 1 if faults or not chosen else 0


if __name__ == "__main__":
    sys.exit(main())
