#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of a PLY file in which one of three triangles has an empty list `texcoord`: the coordinates
# of the others.
# What happens, with three.js 0.187.0: PLYLoader appends what there is. All coordinates after the empty list belong to
# earlier corners, and the last points have none: there are nine points, and six coordinates.
# Needs node and npm. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund three@0.187.0
cat >read.mjs <<'END'
import {REVISION} from 'three';
import {PLYLoader} from 'three/examples/jsm/loaders/PLYLoader.js';
const text = `ply
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
`;
const geometry = new PLYLoader().parse(text);
console.log(REVISION, geometry.attributes.position.count, geometry.attributes.uv.count);
console.log(...geometry.attributes.uv.array);
END
node read.mjs | tee output
diff output - <<'END'
187 9 6
0.125 0.125 0.25 0.125 0.25 0.25 0.5 0.5 0.75 0.5 0.75 0.75
END
