// Copyright (c) 2026 The Angle_based_flattening authors.
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what a package of Node.js reads of each file, or makes of it, in a line of JSON, as the script `run` wants it.
// A face is the list of its corners: x, y, z, and u, v of each set of texture coordinates, in which v points upwards.
// Usage: node read_in_node.mjs 'READER [OPTION...]' FILE...
import fs from 'fs';
import os from 'os';
import path from 'path';

const [reader, ...options] = process.argv[2].split(' ');
const version = name => JSON.parse(fs.readFileSync(`node_modules/${name}/package.json`)).version;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'readers'));
const out = path.join(folder, 'out.glb');

// Triangles of points and of sets of coordinates, each a function of the number of a vertex
function triangles(indices, point, sets) {
  const corners = indices.map(v => [...point(v), ...sets.flatMap(uv => uv(v))]);
  return corners.flatMap((_, i) => i % 3 ? [] : [corners.slice(i, i + 3)]);
}

// The file, with the transformations of nodes and of textures
async function readGltf(file) {
  const {NodeIO} = await import('@gltf-transform/core');
  const {ALL_EXTENSIONS} = await import('@gltf-transform/extensions');
  const {default: draco} = await import('draco3dgltf');
  const {MeshoptDecoder} = await import('meshoptimizer');
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies(
    {'draco3d.decoder': await draco.createDecoderModule(), 'meshopt.decoder': MeshoptDecoder});
  const faces = [];
  for (const node of (await io.read(file)).getRoot().listNodes()) {
    const m = node.getWorldMatrix();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const position = primitive.getAttribute('POSITION'), material = primitive.getMaterial();
      const indices = primitive.getIndices()?.getArray() ?? Array(position.getCount()).keys();
      const infos = ['BaseColor', 'Occlusion', 'Emissive', 'Normal'] // all textures have the transform of their set
        .filter(kind => material?.[`get${kind}Texture`]()).map(kind => material[`get${kind}TextureInfo`]());
      const sets = primitive.listSemantics().filter(name => name.startsWith('TEXCOORD_')).map(name => {
        const uv = primitive.getAttribute(name), info = infos.find(info => info.getTexCoord() === Number(name.at(-1)));
        const move = info?.getExtension('KHR_texture_transform');
        const offset = move?.getOffset() ?? [0, 0], scale = move?.getScale() ?? [1, 1];
        return v => {
          const [a, b] = uv.getElement(v, []);
          return [offset[0] + scale[0] * a, 1 - (offset[1] + scale[1] * b)];
        };
      });
      faces.push(...triangles([...indices], v => {
        const p = position.getElement(v, []);
        return [0, 1, 2].map(i => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
      }, sets));
    }
  }
  return faces;
}

async function readThree(file) {
  const three = await import('three');
  const load = async name => (await import(`three/examples/jsm/loaders/${name}.js`))[name];
  const data = fs.readFileSync(file), text = data.toString();
  const kind = file.slice(-3), buffer = data.buffer.slice(data.byteOffset, data.byteOffset + data.length);
  let root;
  if (kind === 'obj') {
    root = new (await load('OBJLoader'))().parse(text);
  } else if (kind === 'ply') {
    root = new three.Mesh(new (await load('PLYLoader'))().parse(buffer));
  } else { // There is no browser that could load pictures.
    const loader = new (await load('GLTFLoader'))();
    loader.register(() => ({name: 'no_pictures', loadTexture: () => Promise.resolve(new three.Texture())}));
    root = (await loader.parseAsync(buffer, '')).scene;
  }
  const faces = [];
  root.updateMatrixWorld();
  root.traverse(mesh => {
    if (!mesh.isMesh) return;
    const {position, uv, uv1} = mesh.geometry.attributes;
    const indices = mesh.geometry.index ? mesh.geometry.index.array : Array(position.count).keys();
    const sets = [uv, uv1].filter(set => set)
      .map(set => v => [set.getX(v), kind === 'glb' ? 1 - set.getY(v) : set.getY(v)]);
    faces.push(...triangles([...indices], v => new three.Vector3().fromBufferAttribute(position, v)
      .applyMatrix4(mesh.matrixWorld).toArray(), sets));
  });
  return faces;
}

async function readBabylon(file) {
  const {LoadAssetContainerAsync, Logger, NullEngine, Scene} = await import('@babylonjs/core/index.js');
  const {OBJFileLoader} = await import('@babylonjs/loaders/OBJ/index.js');
  await import('@babylonjs/loaders/glTF/index.js');
  OBJFileLoader.SKIP_MATERIALS = true;
  Logger.LogLevels = Logger.NoneLogLevel;
  const scene = new Scene(new NullEngine()), kind = file.slice(-4), data = fs.readFileSync(file);
  scene.useRightHandedSystem = true;
  const source = kind === '.obj' ? 'data:' + data : new Uint8Array(data);
  const {meshes} = await LoadAssetContainerAsync(source, scene, {pluginExtension: kind});
  return meshes.filter(mesh => mesh.getTotalVertices()).flatMap(mesh => {
    const points = mesh.getVerticesData('position');
    const sets = ['uv', 'uv2'].map(name => mesh.getVerticesData(name)).filter(set => set)
      .map(set => v => [set[2 * v], kind === '.glb' ? 1 - set[2 * v + 1] : set[2 * v + 1]]);
    const indices = [...mesh.getIndices()];
    if (kind === '.obj') indices.reverse(); // The front of its own materials is where vertices are clockwise.
    return triangles(indices, v => [...points.slice(3 * v, 3 * v + 3)], sets);
  });
}

async function validate(file) {
  const {default: validator} = await import('gltf-validator');
  const {issues} = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
  return {issues: [issues.numErrors, issues.numWarnings], messages: issues.messages.slice(0, 3)};
}

// Tools that write another file, which is then read
const tools = {
  'gltf-transform': async file => {
    const {programReady} = await import('@gltf-transform/cli');
    const {program} = await import('@donmccurdy/caporal'); // what reads the command line, without starting it anew
    await programReady;
    await program.run([options[0], file, out, ...options.slice(1)]);
  },
  'gltfpack': async file => {
    const {pack} = await import('gltfpack/library.js');
    await pack(['-i', file, '-o', out, ...options],
               {read: name => fs.readFileSync(name), write: (name, data) => fs.writeFileSync(name, data)});
  },
  'obj2gltf': async file => {
    const {default: convert} = await import('obj2gltf');
    fs.writeFileSync(out, await convert(file, {binary: true}));
  },
};

const packages = {'gltf-transform': '@gltf-transform/cli', babylon: '@babylonjs/loaders'};
const readers = {three: readThree, babylon: readBabylon, 'gltf-validator': validate};
const print = process.stdout.write.bind(process.stdout);
process.stdout.write = process.stderr.write.bind(process.stderr); // what the packages say themselves
print(JSON.stringify({version: version(packages[reader] ?? reader)}) + '\n');
for (const file of process.argv.slice(3)) {
  let result;
  try {
    fs.rmSync(out, {force: true});
    await tools[reader]?.(file);
    const faces = await (readers[reader] ?? readGltf)(tools[reader] ? out : file);
    result = Array.isArray(faces) ? {faces} : faces;
  } catch (error) { // whatever a package throws
    result = {error: String(error?.message ?? error)};
  }
  print(JSON.stringify(result) + '\n');
}
fs.rmSync(folder, {recursive: true});
process.exit(0);
