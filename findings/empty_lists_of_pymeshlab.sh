#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of a PLY file whose second triangle has an empty list `texcoord`: zeros, or no coordinates, there.
# What happens, with PyMeshLab 2025.7.post1: without a message, its corners get the coordinates of the face before.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check pymeshlab==2025.7.post1 numpy==2.4.6
cat >empty.ply <<'END'
ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
element face 3
property list uchar int vertex_indices
property list uchar float texcoord
end_header
0 0 0
1 0 0
1 1 0
0 1 0
2 0 0
3 0 1 2 6 0.125 0.125 0.25 0.125 0.25 0.25
3 0 2 3 0
3 1 4 2 6 0.5 0.5 0.75 0.5 0.75 0.75
END
venv/bin/python - <<'END' | tee output
import importlib.metadata
import pymeshlab
meshes = pymeshlab.MeshSet(verbose=False)
meshes.load_new_mesh("empty.ply")
print(importlib.metadata.version("pymeshlab"))
for corner in meshes.current_mesh().wedge_tex_coord_matrix().tolist():
    print(*corner)
END
diff output - <<'END'
2025.7.post1
0.125 0.125
0.25 0.125
0.25 0.25
0.125 0.125
0.25 0.125
0.25 0.25
0.5 0.5
0.75 0.5
0.75 0.75
END
