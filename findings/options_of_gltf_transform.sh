#!/usr/bin/env bash
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What was expected: the program that @gltf-transform/cli exports runs a command with an option, as its command line
# does.
# What happens, with @gltf-transform/cli 4.5.1: program.exec() takes options of one word only. An option with a hyphen
# is unknown, written as pruneAttributes or as prune-attributes, and the message suggests the same name.
# Needs node and npm. Changes nothing outside of its temporary folder. Fails if the behaviour changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts @gltf-transform/cli@4.5.1
cat >run.mjs <<'END'
import {program, programReady} from '@gltf-transform/cli';
import {Document, NodeIO, VERSION} from '@gltf-transform/core';
const document = new Document();
document.createScene().addChild(document.createNode('a'));
await new NodeIO().write('in.glb', document);
await programReady;
console.info = () => {};
console.log(VERSION);
for (const options of [{simplify: false}, {'prune-attributes': false}, {pruneAttributes: false}]) {
  try {
    await program.exec(['optimize', 'in.glb', 'out.glb'], options);
    console.log(...Object.keys(options), 'works');
  } catch (error) { // with the colours of terminals
    console.log(...Object.keys(options), error.message.replace(/\x1b\[[0-9;]*m/g, '').match(/Unknown.*/)[0].trim());
  }
}
process.exit(0);
END
node run.mjs | grep -E '^(v4|simplify|prune)' | grep -v 'ms$' | tee output
diff output - <<'END'
v4.5.1
simplify works
prune-attributes Unknown option --prune-attributes. Did you mean --prune-attributes ?
pruneAttributes Unknown option --prune-attributes. Did you mean --prune-attributes ?
END
