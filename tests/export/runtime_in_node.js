// tests/export/runtime_in_node.js: prints runtime_check.js's results. Usage: runtime_in_node.js FILE.glb ORACLE.json [three]
import fs from 'node:fs';

import { checkFormulas, checkGraph } from './runtime_check.js';
import * as runtime from './sinew_muscles.js';
import { withoutImages } from './without_images.mjs';

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
