#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of an OBJ file with two triangles of different materials, of which one has no `vt`: three texture
# coordinates of the mesh for each triangle, so that has_triangle_uvs() holds.
# What happens, with Open3D 0.20.0: read_triangle_mesh() gives three coordinates for two triangles. The number of
# triangles before does not say to which they belong, and has_triangle_uvs() is false: all coordinates are lost.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check open3d==0.20.0
printf 'newmtl a\nKd 1 1 1\nnewmtl b\nKd 1 0 0\n' >two.mtl
cat >two.obj <<'END'
mtllib two.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0.25 0.25
vt 0.75 0.25
vt 0.75 0.75
usemtl a
f 1 3 4
usemtl b
f 1/1 2/2 3/3
END
venv/bin/python - <<'END' | tee output
import open3d
mesh = open3d.io.read_triangle_mesh("two.obj")
print(open3d.__version__, len(mesh.triangles), len(mesh.triangle_uvs), mesh.has_triangle_uvs())
END
diff <(tail -n 1 output) - <<'END'
0.20.0 2 3 False
END
