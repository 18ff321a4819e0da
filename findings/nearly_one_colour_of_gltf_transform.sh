#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected: prune() removes what nothing refers to, and the model looks as before.
# What happens, with @gltf-transform/functions 4.5.1: it also removes textures of nearly one colour, and puts that colour
# into the factor of the material. A texture of 2 by 2 texels, 254 and 255 of gray in turn, makes a white material less
# white: baseColorFactor was [1, 1, 1, 1]. A texture of 0 and 255 stays.
# Needs node and npm. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1
cat >prune.mjs <<'END'
import {Document, Logger, VERSION} from '@gltf-transform/core';
import {prune} from '@gltf-transform/functions';
import zlib from 'zlib';

function png(rows) {
  const chunk = (kind, data) => {
    const content = Buffer.concat([Buffer.from(kind), data]), size = Buffer.alloc(4), check = Buffer.alloc(4);
    size.writeUInt32BE(data.length);
    let crc = 0xffffffff;
    for (const byte of content) {
      crc ^= byte;
      for (let k = 0; k < 8; ++k) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
    }
    check.writeUInt32BE((crc ^ 0xffffffff) >>> 0);
    return Buffer.concat([size, content, check]);
  };
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
    chunk('IHDR', Buffer.from([0, 0, 0, rows[0].length, 0, 0, 0, rows.length, 8, 0, 0, 0, 0])),
    chunk('IDAT', zlib.deflateSync(Buffer.from(rows.flatMap(row => [0, ...row])))), chunk('IEND', Buffer.alloc(0))]);
}

console.log(VERSION);
for (const rows of [[[0, 255], [255, 0]], [[254, 255], [255, 254]]]) {
  const document = new Document(), buffer = document.createBuffer();
  const numbers = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const texture = document.createTexture().setImage(new Uint8Array(png(rows))).setMimeType('image/png');
  const material = document.createMaterial().setBaseColorTexture(texture);
  const primitive = document.createPrimitive().setMaterial(material)
    .setAttribute('POSITION', numbers('VEC3', new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0])))
    .setAttribute('TEXCOORD_0', numbers('VEC2', new Float32Array([0, 0, 1, 0, 0, 1])));
  document.createScene().addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  await document.setLogger(new Logger(Logger.Verbosity.SILENT)).transform(prune());
  console.log(...rows.flat(), 'textures', document.getRoot().listTextures().length, 'factor',
              ...material.getBaseColorFactor().map(x => x.toFixed(3)), primitive.listSemantics().join(' '));
}
END
node prune.mjs | tee output
diff output - <<'END'
v4.5.1
0 255 255 0 textures 1 factor 1.000 1.000 1.000 1.000 POSITION TEXCOORD_0
254 255 255 254 textures 0 factor 0.996 0.996 0.996 1.000 POSITION TEXCOORD_0
END
