#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of an OBJ file in which a point has two texture coordinates in different faces: the mesh.
# What happens, with meshio 5.3.5: it takes the list of `vt` for data of the points, whatever the faces say, and refuses
# the file if the number is another one. If the numbers happen to be equal, coordinates belong to wrong points.
# Needs python3 with venv, and pip. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check meshio==5.3.5
cat >seam.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 0.25 0
vt 0.25 0.25
vt 0.75 0.75
vt 1 1
vt 0.75 1
f 1/1 2/2 3/3
f 1/4 3/5 4/6
END
cat >order.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
vt 1 1
vt 1 0
vt 0 0
f 1/3 2/2 3/1
END
venv/bin/python - <<'END' | tee output
import meshio
print(meshio.__version__)
try:
    print(meshio.read("seam.obj"))
except ValueError as error:
    print(error)
print(meshio.read("order.obj").point_data["obj:vt"].tolist())
END
diff <(grep -v '^$' output) - <<'END'
5.3.5
len(points) = 4, but len(point_data["obj:vt"]) = 6
[[1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]
END
