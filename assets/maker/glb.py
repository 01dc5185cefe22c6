# assets/maker/glb.py: mesh, skeleton, texture and clips as one binary glTF 2.0 file.
import json
import struct

from . import vec

FLOAT, USHORT, UBYTE = 5126, 5123, 5121


class Buffer:
    def __init__(self):
        self.data, self.views, self.accessors = bytearray(), [], []

    def view(self, data, target=None):
        while len(self.data) % 4:
            self.data.append(0)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)})
        if target:
            self.views[-1]["target"] = target
        self.data += data
        return len(self.views) - 1

    def accessor(self, rows, kind, code, component, target=None, bounds=False):
        flat = [x for row in rows for x in row]
        data = struct.pack("<%d%s" % (len(flat), code), *flat)
        entry = {"bufferView": self.view(data, target), "componentType": component, "count": len(rows), "type": kind}
        if bounds:
            kept = [struct.unpack("<%df" % len(row), struct.pack("<%df" % len(row), *row)) for row in rows]
            entry["min"] = [min(column) for column in zip(*kept)]
            entry["max"] = [max(column) for column in zip(*kept)]
        self.accessors.append(entry)
        return len(self.accessors) - 1


def _mesh(buffer, mesh, skeleton, size):
    corners, order = {}, []
    for triangle in mesh.triangles:
        for vertex, key in triangle:
            uv = mesh.cage.uv(key, size)
            if (vertex, uv) not in corners:
                corners[(vertex, uv)] = len(order)
                order.append((vertex, uv))
    normals = mesh.normals()
    joints, weights = [], []
    for vertex, _ in order:
        best = sorted(mesh.weights[vertex].items(), key=lambda item: (-item[1], item[0]))[:4]
        best += [(None, 0.0)] * (4 - len(best))
        total = sum(w for _, w in best)
        joints.append([skeleton.NAMES.index(bone) if bone else 0 for bone, _ in best])
        weights.append([w / total for _, w in best])
    index = [[corners[(v, mesh.cage.uv(key, size))]] for t in mesh.triangles for v, key in t]
    vertices = 34962
    return {"attributes": {
        "POSITION": buffer.accessor([mesh.positions[v] for v, _ in order], "VEC3", "f", FLOAT, vertices, bounds=True),
        "NORMAL": buffer.accessor([normals[v] for v, _ in order], "VEC3", "f", FLOAT, vertices),
        "TEXCOORD_0": buffer.accessor([uv for _, uv in order], "VEC2", "f", FLOAT, vertices),
        "JOINTS_0": buffer.accessor(joints, "VEC4", "B", UBYTE, vertices),
        "WEIGHTS_0": buffer.accessor(weights, "VEC4", "f", FLOAT, vertices)},
        "indices": buffer.accessor(index, "SCALAR", "H", USHORT, 34963), "material": 0}


def _animation(buffer, clip, skeleton):
    samplers, channels = [], []
    times = buffer.accessor([[t] for t in clip.times], "SCALAR", "f", FLOAT, bounds=True)
    for (bone, path), values in clip.tracks.items():
        output = buffer.accessor(values, "VEC4" if path == "rotation" else "VEC3", "f", FLOAT)
        channels.append({"sampler": len(samplers), "target": {"node": skeleton.NAMES.index(bone), "path": path}})
        samplers.append({"input": times, "interpolation": "LINEAR", "output": output})
    return {"name": clip.name, "samplers": samplers, "channels": channels}


def _nodes(name_of_mesh, skeleton):
    nodes = []
    for name in skeleton.NAMES:
        parent = skeleton.PARENT[name]
        offset = vec.sub(skeleton.ORIGIN[name], skeleton.ORIGIN[parent]) if parent else skeleton.ORIGIN[name]
        node = {"name": name, "translation": [round(c, 6) for c in offset]}
        children = [i for i, child in enumerate(skeleton.NAMES) if skeleton.PARENT[child] == name]
        if children:
            node["children"] = children
        nodes.append(node)
    nodes.append({"name": name_of_mesh, "mesh": 0, "skin": 0})
    return nodes


def pack(name, generator, mesh, skeleton, image, size, clips):
    """GLB bytes. skeleton: a module with NAMES, ORIGIN, PARENT; size: texels of the square image."""
    buffer = Buffer()
    primitive = _mesh(buffer, mesh, skeleton, size)
    turned = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]  # not at all
    inverse_bind = [turned + [-c for c in skeleton.ORIGIN[bone]] + [1] for bone in skeleton.NAMES]
    document = {
        "asset": {"version": "2.0", "generator": generator},
        "scene": 0,
        "scenes": [{"nodes": [0, len(skeleton.NAMES)]}],
        "nodes": _nodes(name, skeleton),
        "meshes": [{"name": name, "primitives": [primitive]}],
        "skins": [{"inverseBindMatrices": buffer.accessor(inverse_bind, "MAT4", "f", FLOAT), "skeleton": 0,
                   "joints": list(range(len(skeleton.NAMES)))}],
        "materials": [{"name": "skin", "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0}, "metallicFactor": 0.0, "roughnessFactor": 0.7}}],
        "animations": [_animation(buffer, clip, skeleton) for clip in clips],
        "images": [{"name": "skin", "bufferView": buffer.view(image), "mimeType": "image/png"}],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}],
        "textures": [{"sampler": 0, "source": 0}],
    }
    while len(buffer.data) % 4:
        buffer.data.append(0)
    document.update(bufferViews=buffer.views, accessors=buffer.accessors, buffers=[{"byteLength": len(buffer.data)}])
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(buffer.data)) +
            struct.pack("<II", len(text), 0x4E4F534A) + text +
            struct.pack("<II", len(buffer.data), 0x004E4942) + bytes(buffer.data))
