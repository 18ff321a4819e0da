#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of a binary PLY file with a quadrangle and a triangle: three triangles, as of the same file in ASCII.
# What happens, with trimesh 5.2.0: ValueError, "PLY is unexpected length!". Lists of one length are read.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check trimesh==5.2.0
venv/bin/python - <<'END' | tee output
import importlib.metadata, struct, trimesh
points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)]
faces = [(0, 1, 2, 3), (1, 4, 2)]
print(importlib.metadata.version("trimesh"))
header = "ply\nformat {} 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n" \
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
with open("ascii.ply", "w") as file:
    file.write(header.format("ascii"))
    file.writelines(" ".join(map(str, row)) + "\n" for row in points + [(len(face), *face) for face in faces])
with open("binary.ply", "wb") as file:
    file.write(header.format("binary_little_endian").encode())
    file.writelines(struct.pack("<3f", *point) for point in points)
    file.writelines(struct.pack(f"<B{len(face)}i", len(face), *face) for face in faces)
for name in "ascii", "binary":
    try:
        print(name, len(trimesh.load(name + ".ply", process=False).faces))
    except ValueError as error:
        print(name, error)
END
diff output - <<'END'
5.2.0
ascii 3
binary PLY is unexpected length!
END
