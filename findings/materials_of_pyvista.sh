#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of an OBJ file with two materials, each of whose triangles has texture coordinates: those of all.
# What happens, with VTK 9.7.2 and PyVista 0.49.1: there is an array for each material, with (-1, -1) at points of the
# other one. The active texture coordinates, which PyVista gives and draws with, are those of one material: a corner
# of the first triangle has (-1, -1).
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check pyvista==0.49.1 vtk==9.7.2
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
vt 0.25 0.75
usemtl a
f 1/1 2/2 3/3
usemtl b
f 1/1 3/3 4/4
END
venv/bin/python - <<'END' | tee output
import pyvista, vtk
mesh = pyvista.read("two.obj")
faces, uv = mesh.faces.reshape(-1, 4)[:, 1:], mesh.active_texture_coordinates
print(vtk.VTK_VERSION, pyvista.__version__, sorted(mesh.point_data.keys()))
print([[tuple(map(float, uv[v])) for v in face] for face in faces])
END
diff output - <<'END'
9.7.2 0.49.1 ['a', 'b']
[[(0.25, 0.25), (-1.0, -1.0), (0.75, 0.75)], [(0.25, 0.25), (0.75, 0.75), (0.25, 0.75)]]
END
