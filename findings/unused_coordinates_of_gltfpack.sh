#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected: -kv, which keeps attributes of vertices that no material uses, keeps their values, up to 12 bits.
# What happens, with gltfpack 1.3.0: texture coordinates from 0 to 1 that no texture uses are 0 to 0.0625 in the output,
# and all 0 if the mesh has no material. No transformation (KHR_texture_transform) takes that back, because there is no
# texture that could have it. With -vtf, which keeps type `float`, they stay.
# Needs node and npm. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund gltfpack@1.3.0 @gltf-transform/core@4.5.1 @gltf-transform/extensions@4.5.1
cat >write.mjs <<'END'
import {Document, NodeIO} from '@gltf-transform/core';
const document = new Document(), buffer = document.createBuffer(), n = 9;
const grid = f => new Float32Array([...Array(n * n).keys()].flatMap(k => f(Math.floor(k / n) / 8, k % n / 8)));
const numbers = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
const indices = [...Array(n * n).keys()].filter(k => k % n < 8 && k < n * 8)
  .flatMap(k => [k, k + n, k + n + 1, k, k + n + 1, k + 1]);
const material = process.argv[2] === 'material' ? document.createMaterial() : null;
const primitive = document.createPrimitive().setMaterial(material)
  .setIndices(numbers('SCALAR', new Uint32Array(indices)))
  .setAttribute('POSITION', numbers('VEC3', grid((x, y) => [x, y, Math.sin(5 * x) * y])))
  .setAttribute('TEXCOORD_0', numbers('VEC2', grid((x, y) => [x, y])));
document.createScene().addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
await new NodeIO().write('in.glb', document);
END
cat >read.mjs <<'END'
import {NodeIO} from '@gltf-transform/core';
import {KHRMeshQuantization, KHRTextureTransform} from '@gltf-transform/extensions';
const document = await new NodeIO().registerExtensions([KHRMeshQuantization, KHRTextureTransform]).read('out.glb');
const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
const uv = primitive.getAttribute('TEXCOORD_0');
console.log(...uv.getMinNormalized([]), 'to', ...uv.getMaxNormalized([]).map(x => x.toFixed(4)),
            document.getRoot().listExtensionsUsed().map(extension => extension.extensionName).join(' '));
END
for kind in material none; do
  node write.mjs $kind
  for options in -kv "-kv -vtf"; do
    # shellcheck disable=SC2086 # several options
    npx gltfpack -i in.glb -o out.glb $options
    echo "$kind, $options: $(node read.mjs)"
  done
done | tee output
diff output - <<'END'
material, -kv: 0 0 to 0.0625 0.0625 KHR_mesh_quantization
material, -kv -vtf: 0 0 to 1.0000 1.0000 KHR_mesh_quantization
none, -kv: 0 0 to 0.0000 0.0000 KHR_mesh_quantization
none, -kv -vtf: 0 0 to 1.0000 1.0000 KHR_mesh_quantization
END
