#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected, of an OBJ file in which one of two triangles has no `vt`, as the format allows: both triangles.
# What happens, with Babylon.js 9.28.0 (loaders; core 9.35.0): the loader fails, and there is no mesh.
# Needs node and npm. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @babylonjs/core@9.35.0 @babylonjs/loaders@9.28.0
cat >read.mjs <<'END'
import {LoadAssetContainerAsync, Logger, NullEngine, Scene} from '@babylonjs/core/index.js';
import {OBJFileLoader} from '@babylonjs/loaders/OBJ/index.js';
OBJFileLoader.SKIP_MATERIALS = true;
Logger.LogLevels = Logger.NoneLogLevel;
const scene = new Scene(new NullEngine());
for (const face of ['f 1/1 3/3 4/2', 'f 1 3 4']) {
  const text = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n' + face + '\n';
  try {
    const {meshes} = await LoadAssetContainerAsync('data:' + text, scene, {pluginExtension: '.obj'});
    console.info('triangles', ...meshes.map(mesh => mesh.getTotalIndices() / 3));
  } catch (error) {
    console.info(error.message.split(': ').at(-1));
  }
}
process.exit(0);
END
node read.mjs 2>messages | tee output
cat messages >&2
diff output - <<'END'
triangles 2
Unable to unwrap data while parsing OBJ data.
END
