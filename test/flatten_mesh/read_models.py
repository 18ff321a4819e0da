# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary glTF and PLY files, as their formats say"""

import json
import struct


def read_glb(path):
    """The JSON and the bytes"""
    data = path.read_bytes()
    magic, version, length = struct.unpack("<4sII", data[:12])
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack("<I4s", data[12:20])
    assert kind == b"JSON"
    size_of_bytes, kind = struct.unpack("<I4s", data[20 + size:28 + size])
    assert kind == b"BIN\0" and 28 + size + size_of_bytes == length
    return json.loads(data[20:20 + size]), data[28 + size:]


def numbers_of(gltf, data, number):
    """What an accessor reads: numbers, or a tuple for each vector"""
    accessor = gltf["accessors"][number]
    view = gltf["bufferViews"][accessor["bufferView"]]
    assert "byteStride" not in view
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
    code = {5125: "I", 5126: "f"}[accessor["componentType"]]
    first = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    numbers = struct.unpack_from(f"<{accessor['count'] * width}{code}", data, first)
    return numbers if width == 1 else list(zip(*[iter(numbers)] * width))


def write_glb(path, gltf, data):
    """A file of the JSON and the bytes"""
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sIII4s", b"glTF", 2, 28 + len(text) + len(data), len(text), b"JSON") + text +
                     struct.pack("<I4s", len(data), b"BIN\0") + data)


def read_ply(path, wanted="face"):
    """Of each face, or each vertex: the numbers of each of its properties, by name"""
    header, data = path.read_bytes().split(b"end_header\n", 1)
    codes = {"uchar": "B", "int": "i", "uint": "I", "float": "f", "double": "d"}
    elements = []
    for words in map(str.split, header.decode().splitlines()):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append((words[-1], [codes[word] for word in words[1:-1] if word in codes]))
    place, found = 0, []
    for element, number, properties in elements:
        for _ in range(number):
            values = {}
            for name, kinds in properties:
                count = 1
                if len(kinds) == 2:
                    count, = struct.unpack_from("<" + kinds[0], data, place)
                    place += struct.calcsize(kinds[0])
                values[name] = struct.unpack_from(f"<{count}{kinds[-1]}", data, place)
                place += count * struct.calcsize(kinds[-1])
            if element == wanted:
                found.append(values)
    assert place == len(data)
    return found
