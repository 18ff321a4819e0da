#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of PLY and OBJ files with texture coordinates: a mesh with coordinates.
# What happens, with trimesh 5.2.0 as pip installs it: ModuleNotFoundError, "No module named 'PIL'". Pillow is no
# dependency, and there is no picture to read. With materials, an OBJ file is read.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check trimesh==5.2.0 numpy==2.4.6
triangle='v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n'
printf '%b' "$triangle" >plain.obj
printf '%b' "mtllib a.mtl\nusemtl a\n$triangle" >material.obj
printf 'newmtl a\nKd 1 1 1\n' >a.mtl
cat >s_t.ply <<'END'
ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float s
property float t
element face 1
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 1 0
0 1 0 0 1
3 0 1 2
END
venv/bin/python - <<'END' | tee output
import importlib.metadata
import trimesh
print(importlib.metadata.version("trimesh"))
for name in "material.obj", "plain.obj", "s_t.ply":
    try:
        print(name, len(trimesh.load_mesh(name, process=False).faces))
    except ModuleNotFoundError as error:
        print(name, error)
END
diff output - <<'END'
5.2.0
material.obj 1
plain.obj No module named 'PIL'
s_t.ply No module named 'PIL'
END
