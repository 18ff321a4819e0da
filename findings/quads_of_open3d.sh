#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of an OBJ file with a quadrangle and a triangle: three triangles, or an error.
# What happens, with Open3D 0.20.0: read_triangle_mesh() drops the quadrangle. It says nothing but a line of information,
# returns True for what is left in the mesh, and the mesh has one triangle. read_triangle_model() reads all three.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check open3d==0.20.0
cat >mixed.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 2 0 0
f 1 2 3 4
f 2 5 3
END
venv/bin/python - <<'END' | tee output
import open3d
mesh = open3d.io.read_triangle_mesh("mixed.obj")
model = open3d.io.read_triangle_model("mixed.obj")
print(open3d.__version__, len(mesh.triangles), sum(len(part.mesh.triangles) for part in model.meshes))
END
diff <(tail -n 1 output) - <<'END'
0.20.0 1 3
END
