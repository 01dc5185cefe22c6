// tests/export/runtime_check.js: examples/three.js/sinew_muscles.js held against the core's poses, in node and browsers.
const moved = (e, p) => [0, 1, 2].map((i) => e[i] * p[0] + e[4 + i] * p[1] + e[8 + i] * p[2] + e[12 + i]);
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

// Fraction of H by which two matrices move the joint's origin, and points H / 5 from it in the joint at rest, apart.
export function apart(a, b, size, height) {
  const r = (0.2 * height) / size;
  const points = [[0, 0, 0], [r, 0, 0], [0, r, 0], [0, 0, r]];
  const far = Math.max(...points.map((p) => distance(moved(a, p), moved(b, p)))) / height;
  return Number.isFinite(far) ? far : Infinity;
}

// A local of 16 numbers under a parent [x, y, z, origin].
function inWorld(parent, e) {
  const turned = (v) => [0, 1, 2].map((k) => parent[0][k] * v[0] + parent[1][k] * v[1] + parent[2][k] * v[2]);
  const [x, y, z, t] = [0, 4, 8, 12].map((c) => turned(e.slice(c, c + 3)));
  return [...x, 0, ...y, 0, ...z, 0, ...t.map((v, k) => v + parent[3][k]), 1];
}

// The local of a joint that nothing moves.
function restOf(node) {
  const [x, y, z, w] = node.rotation, t = node.translation;
  return [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0,
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0,
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0, ...t, 1];
}

function parentsOf(nodes) {
  const parents = [];
  nodes.forEach((node, i) => (node.children ?? []).forEach((child) => (parents[child] = i)));
  return parents;
}

// The formulas alone: world matrices of bones in, locals of joints out.
export function checkFormulas(json, oracle, { poseLine, localOf, matrixOf }) {
  const result = { joints: 0, vias: 0, worst: 0, moved: 0, bind: 0 };
  const parents = parentsOf(json.nodes);
  for (const [number, pose] of oracle.poses.entries()) {
    const worldOf = (node) => matrixOf(pose.bones[node]);
    for (const data of json.skins.flatMap((skin) => skin.extras?.sinew ?? [])) {
      for (const line of data.lines) {
        result.vias += line.via ? 1 : 0;
        poseLine(line, worldOf, pose.flex).forEach((world, i) => {
          const node = line.joints[i].node;
          const parent = worldOf(parents[node]);
          const e = localOf(parent, world, data.joint_scale);
          const expected = pose.joints[json.nodes[node].name];
          const off = (local) => apart(inWorld(parent, local), expected, line.size, oracle.height);
          result.worst = Math.max(result.worst, off(e));
          const fromRest = off(restOf(json.nodes[node]));
          result.moved = Math.max(result.moved, fromRest);
          if (number === 0) result.bind = Math.max(result.bind, fromRest);
          ++result.joints;
        });
      }
    }
  }
  return result;
}

// The class, on what GLTFLoader made of the file: random poses, under a turned, moved and larger parent, on a clone.
export function checkGraph(gltf, oracle, three, clone, SinewMuscles) {
  const result = { joints: 0, worst: 0, keyed: 0, keys: 0 };
  const json = gltf.parser.json;
  const root = clone(gltf.scene);
  const place = new three.Group();
  place.position.set(0.3, -0.2, 0.5).multiplyScalar(oracle.height);
  place.quaternion.set(0.5, -0.1, 0.7, 0.3).normalize();
  place.scale.setScalar(1.7);
  place.add(root);
  const muscles = new SinewMuscles(gltf, root);
  const lines = muscles.data.flatMap((data) => data.lines);
  for (const pose of oracle.poses.slice(1)) {  // The nodes of a file need not stand in the bind pose.
    for (const [node, local] of Object.entries(pose.nodes)) {
      const object = muscles.nodes[node];
      object.position.fromArray(local.translation);
      object.quaternion.fromArray(local.rotation);
      if (local.scale) object.scale.fromArray(local.scale);
      else object.scale.fromArray(json.nodes[node].scale ?? [1, 1, 1]);
    }
    muscles.update(pose.flex);
    place.updateMatrixWorld(true);
    const away = place.matrixWorld.clone().invert();
    for (const line of lines) {
      for (const joint of line.joints) {
        const found = away.clone().multiply(muscles.nodes[joint.node].matrixWorld).elements;
        const expected = pose.joints[json.nodes[joint.node].name];
        result.worst = Math.max(result.worst, apart(found, expected, line.size, oracle.height));
        ++result.joints;
      }
    }
  }
  return { ...result, ...checkKeys(gltf, oracle, three, SinewMuscles) };
}

// Where a clip has keys for the joints, the runtime finds the same.
function checkKeys(gltf, oracle, three, SinewMuscles) {
  const muscles = new SinewMuscles(gltf);
  const joints = muscles.data.flatMap((data) => data.lines.flatMap((line) => line.joints.map((j) => [j.node, line.size])));
  let keyed = 0, keys = 0;
  for (const clip of gltf.animations) {
    const mixer = new three.AnimationMixer(gltf.scene);
    mixer.clipAction(clip).play();
    for (let frame = 0; frame / 30 <= clip.duration; ++frame) {
      mixer.setTime(frame / 30);
      gltf.scene.updateMatrixWorld(true);
      const before = joints.map(([node]) => muscles.nodes[node].matrixWorld.elements.slice());
      muscles.update();
      gltf.scene.updateMatrixWorld(true);
      joints.forEach(([node, size], i) => {
        const now = muscles.nodes[node].matrixWorld.elements;
        keyed = Math.max(keyed, apart(now, before[i], size, oracle.height));
        ++keys;
      });
    }
  }
  return { keyed, keys };
}
