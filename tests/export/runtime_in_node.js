// tests/export/runtime_in_node.js: prints runtime_check.js's results. Usage: runtime_in_node.js FILE.glb ORACLE.json [three]
import fs from 'node:fs';

import { checkFormulas, checkGraph } from './runtime_check.js';
import * as runtime from './sinew_muscles.js';

// Pictures need a browser; nothing here looks at them.
function withoutImages(glb) {
  const size = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + size).toString());
  for (const key of ['images', 'textures', 'samplers', 'materials']) delete json[key];
  for (const mesh of json.meshes) for (const primitive of mesh.primitives) delete primitive.material;
  let text = JSON.stringify(json);
  text += ' '.repeat((4 - (Buffer.byteLength(text) % 4)) % 4);
  const head = Buffer.alloc(20), rest = glb.subarray(20 + size);
  glb.copy(head, 0, 0, 8);
  head.writeUInt32LE(20 + Buffer.byteLength(text) + rest.length, 8);
  head.writeUInt32LE(Buffer.byteLength(text), 12);
  head.writeUInt32LE(0x4e4f534a, 16);
  const whole = Buffer.concat([head, Buffer.from(text), rest]);
  return { json, data: whole.buffer.slice(whole.byteOffset, whole.byteOffset + whole.length) };
}

const { json, data } = withoutImages(fs.readFileSync(process.argv[2]));
const oracle = JSON.parse(fs.readFileSync(process.argv[3]));
const result = { formulas: checkFormulas(json, oracle, runtime) };
if (process.argv[4]) {
  const three = await import('three');
  const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
  const { clone } = await import('three/examples/jsm/utils/SkeletonUtils.js');
  const gltf = await new Promise((done, failed) => new GLTFLoader().parse(data, '', done, failed));
  result.graph = checkGraph(gltf, oracle, three, clone, runtime.SinewMuscles);
}
console.log(JSON.stringify(result));
