// tests/export/without_images.mjs: a .glb as node can load it in three.js.

// Pictures need a browser; nothing here looks at them.
export function withoutImages(glb) {
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
