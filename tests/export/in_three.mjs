// tests/export/in_three.mjs: three.js plays a .glb; writes where every vertex is.
// Usage: node in_three.mjs FILE.glb ASKED.json OUT.json   (the shape of both: in_blender.py)
import fs from 'node:fs';

import * as three from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

import { withoutImages } from './without_images.mjs';

const [file, asked, out] = process.argv.slice(2);
const { json, data } = withoutImages(fs.readFileSync(file));
const gltf = await new Promise((done, failed) => new GLTFLoader().parse(data, '', done, failed));
const nodes = await gltf.parser.getDependencies('node');
const mixer = new three.AnimationMixer(gltf.scene);

// The file's node, its meshes in the order of the primitives.
function vertices() {
  gltf.scene.updateMatrixWorld(true);
  gltf.scene.traverse(item => { if (item.skeleton) item.skeleton.update(); });
  const places = {};
  json.nodes.forEach((node, number) => {
    if (node.mesh === undefined) return;
    const item = nodes[number];
    const own = places[node.name ?? json.meshes[node.mesh].name] = [];
    for (const mesh of item.isMesh ? [item] : item.children.filter(child => child.isMesh)) {
      const count = mesh.geometry.attributes.position.count;
      for (let v = 0; v < count; ++v) {
        own.push(mesh.getVertexPosition(v, new three.Vector3()).applyMatrix4(mesh.matrixWorld).toArray());
      }
    }
  });
  return places;
}

const seen = [];
for (const [clip, times] of JSON.parse(fs.readFileSync(asked))) {
  mixer.stopAllAction();
  const action = mixer.clipAction(gltf.animations.find(each => each.name === clip));
  action.setLoop(three.LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  for (const seconds of times) {
    mixer.setTime(seconds);
    seen.push([clip, seconds, vertices()]);
  }
}
fs.writeFileSync(out, JSON.stringify(seen));
