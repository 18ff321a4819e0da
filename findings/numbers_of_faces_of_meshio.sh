#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of a PLY file whose faces have a number beside the list of their vertices: the mesh, with the number
# as data of its cells.
# What happens, with meshio 5.3.5: TypeError, "object of type 'numpy.int32' has no len()", if the file is binary.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check meshio==5.3.5
venv/bin/python - <<'END' | tee output
import struct
import meshio
print(meshio.__version__)
header = "ply\nformat {} 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" \
    "element face 1\nproperty list uchar int vertex_indices\nproperty int chart\nend_header\n"
with open("ascii.ply", "w") as file:
    file.write(header.format("ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n")
with open("binary.ply", "wb") as file:
    file.write(header.format("binary_little_endian").encode() + struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) +
               struct.pack("<B4i", 3, 0, 1, 2, 7))
for name in "ascii", "binary":
    try:
        print(name, [data[0].tolist() for data in meshio.read(name + ".ply").cell_data["chart"]])
    except (KeyError, TypeError) as error:
        print(name, type(error).__name__, error)
END
diff <(grep -v '^$' output) - <<'END'
5.3.5
ascii [7]
binary TypeError object of type 'numpy.int32' has no len()
END
