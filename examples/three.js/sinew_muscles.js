// examples/three.js/sinew_muscles.js: moves the muscle joints of `sinew export --as helpers` in any pose.
//
//   const muscles = new SinewMuscles(gltf);              // what GLTFLoader gave; for a clone: (gltf, clone)
//   mixer.update(seconds); muscles.update();             // each frame, after the animation, before rendering
//
// Formulas: docs/muscles.md; the numbers in skins[].extras.sinew: docs/export.md, "Line data". Vectors are arrays of
// three, matrices [x, y, z, origin]. Nothing is imported: poseLine and localOf are plain mathematics.
const add = (a, b, t = 1) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
const scaled = (a, t) => [a[0] * t, a[1] * t, a[2] * t];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.sqrt(dot(a, a));
const clamped = (v) => Math.min(Math.max(v, 0), 1);
const times = (m, v) => add(add(scaled(m[0], v[0]), m[1], v[1]), m[2], v[2]);
const placed = (m, point) => add(times(m, point), m[3]);
const square = (m) => [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];  // inverse, transposed, times volume
export const matrixOf = (e) => [0, 4, 8, 12].map((i) => [e[i], e[i + 1], e[i + 2]]);  // of 16 numbers, by columns

// The line's bind frame as a bone carries it: the nearest rotation (Higham), and how much the bone has grown.
function carried(bone, frame) {
  let m = [0, 3, 6].map((i) => times(bone, frame.slice(i, i + 3)));
  const growth = Math.cbrt(dot(m[0], cross(m[1], m[2])));
  m = m.map((axis) => scaled(axis, 1 / growth));
  for (let round = 0; round < 12; ++round) {
    const s = square(m);
    m = m.map((axis, i) => scaled(add(axis, s[i], 1 / dot(m[0], s[0])), 0.5));
  }
  return { frame: m, growth: Math.abs(growth) };
}

// Belly stretch, its softened logarithm and activation at a stretch of the line.
function contraction(line, stretch, flex) {
  const share = 1 - line.tendons[0] - line.tendons[1];
  const belly = Math.max(stretch - 1 + share, 0.1 * share) / share;
  const x = Math.log(belly), most = x < 0 ? -Math.log(line.limits[0]) : Math.log(line.limits[1]);
  const s = clamped((1 - stretch) / (1 - line.full));
  return { belly, soft: most * Math.tanh(x / most), share,
    activation: clamped(line.base + flex + line.gain * s * s * (3 - 2 * s)) };
}

// The height of a carried frame after the least turn that brings its direction onto the line.
function swung([, y, z], direction) {
  const opening = 1 + dot(y, direction);
  return opening < 1e-6 ? z : add(z, add(y, direction), -dot(z, direction) / opening);
}

// Between the heights a and b around the direction, as their quaternions mix.
function mixed(a, b, direction, share) {
  const beside = cross(direction, a), half = 0.5 * Math.atan2(dot(beside, b), dot(a, b));
  const c = 1 - share + share * Math.cos(half), s = share * Math.sin(half);
  return scaled(add(scaled(a, c * c - s * s), beside, 2 * c * s), 1 / (c * c + s * s));
}

// How far the middle of the belly lies beside the straight line.
function viaShift(origin, direction, via, tendon, belly) {
  const there = add(via, origin, -1), foot = dot(there, direction), half = 0.5 * belly;
  const y = Math.min(Math.abs((foot - tendon - half) / half), 1), t = (1 - y) / 0.4;
  const fade = t * t * (10 - t * (15 - 6 * t));
  const shift = scaled(add(there, direction, -foot), y < 0.6 ? 1 / (1 - y * y) : 1 + (fade * y * y) / (0.4 * (1 + y)));
  return length(shift) > half ? scaled(shift, half / length(shift)) : shift;
}

// Where a line's joints are: a matrix to the world for each. worldOf(node) gives the matrix of a node of the file.
export function poseLine(line, worldOf, flex = 0) {
  const from = worldOf(line.origin.node), to = worldOf(line.insertion.node);
  const origin = placed(from, line.origin.point), insertion = placed(to, line.insertion.point);
  const via = line.via && placed(worldOf(line.via.node), line.via.point);
  const byOrigin = carried(from, line.origin.frame), byInsertion = carried(to, line.insertion.frame);
  const along = add(insertion, origin, -1), straight = length(along);
  const size = Math.sqrt(byOrigin.growth * byInsertion.growth), rest = line.rest * line.length * size;
  const total = via ? length(add(via, origin, -1)) + length(add(insertion, via, -1)) : straight;
  const bind = contraction(line, 1 / line.rest, 0), now = contraction(line, total / rest, flex);
  const y = straight > 1e-6 * line.length ? scaled(along, 1 / straight) : byOrigin.frame[1];
  const z = mixed(swung(byOrigin.frame, y), swung(byInsertion.frame, y), y, line.twist);
  const turn = [cross(y, z), y, z], girth = size * Math.exp(-0.5 * line.volume * (now.soft - bind.soft));
  const thick = (flexed) => (girth * (1 + flexed * now.activation)) / (1 + flexed * bind.activation);
  const sizes = [thick(line.flex[1]), (size * now.belly) / bind.belly, thick(line.flex[0])];
  const m = turn.map((axis, i) => scaled(axis, sizes[i])), tendon = line.tendons[0] * rest;
  let start = add(add(origin, y, tendon), z, -size * line.depth);
  if (via) {
    start = add(start, viaShift(origin, y, via, tendon, now.belly * now.share * rest));
    start = add(start, times(turn, line.via.shift), -size);
  }
  return line.joints.map((joint) => [...m.map((axis) => scaled(axis, line.size)), add(start, times(m, joint.at))]);
}

// The same in its parent's space, as a joint can hold it: 16 numbers, by columns. The second axis keeps its direction.
export function localOf(parent, world, jointScale) {
  const rows = square(parent), inside = (v) => rows.map((row) => dot(row, v) / dot(parent[0], rows[0]));
  const m = world.slice(0, 3).map(inside), up = cross(m[0], m[1]);
  const y = scaled(m[1], 1 / length(m[1])), z = scaled(up, 1 / length(up));
  const [width, belly, height] = m.map(length), even = Math.sqrt(width * height);
  const s = { full: [width, belly, height], uniform: [even, even, even], none: [1, 1, 1] }[jointScale];
  return [...scaled(cross(y, z), s[0]), 0, ...scaled(y, s[1]), 0, ...scaled(z, s[2]), 0,
    ...inside(add(world[3], parent[3], -1)), 1];
}

export class SinewMuscles {
  constructor(gltf, root = gltf.scene) {
    const shown = [], shownFor = new Map();
    root.traverse((object) => shown.push(object));
    gltf.scene.traverse((object) => shownFor.set(object, shown[shownFor.size]));
    this.root = root;
    this.nodes = [];
    for (const [object, place] of gltf.parser.associations) {
      if (place?.nodes !== undefined) this.nodes[place.nodes] = shownFor.get(object);
    }
    this.data = (gltf.parser.json.skins ?? []).flatMap((skin) => skin.extras?.sinew ?? []);
  }

  update(flex = 0) {  // 0..1: added to every line's activation
    this.root.updateWorldMatrix(true, true);
    const worldOf = (node) => matrixOf(this.nodes[node].matrixWorld.elements);
    for (const data of this.data) {
      for (const line of data.lines) {
        poseLine(line, worldOf, flex).forEach((world, i) => {
          const joint = this.nodes[line.joints[i].node];
          const local = localOf(matrixOf(joint.parent.matrixWorld.elements), world, data.joint_scale);
          if (!local.every(Number.isFinite)) return;  // A bone flattened to nothing.
          joint.matrix.fromArray(local).decompose(joint.position, joint.quaternion, joint.scale);
        });
      }
    }
  }
}
