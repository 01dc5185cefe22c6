# tests/limits/hostile_post.py: a small character with two joints, as a .glb or .gltf, for tests to bend.
import json
import math
import struct

TYPES = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}
LETTERS = {5126: "f", 5123: "H", 5121: "B"}


class Post:
    """A square post of rings, bent by "knee". `json` is open for a test to bend."""

    fallback = 0  # Bytes of a second buffer that no file has.

    def __init__(self, rings=8):
        self.json = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": []}
        self.bytes = b""
        positions, joints, weights, indices = [], [], [], []
        for ring in range(rings + 1):
            for corner in range(4):
                positions += [-0.5 if corner in (0, 3) else 0.5, 2 * ring / rings, 0.5 if corner < 2 else -0.5]
                joints += [0, 1, 0, 0]
                weights += [1 - ring / rings, ring / rings, 0, 0]
        for ring in range(rings):
            for corner in range(4):
                a, b = 4 * ring + corner, 4 * ring + (corner + 1) % 4
                indices += [a, b, b + 4, a, b + 4, a + 4]
        top = 4 * rings
        indices += [3, 2, 1, 3, 1, 0, top, top + 1, top + 2, top, top + 2, top + 3]
        attributes = {"POSITION": self.accessor(positions, "VEC3"), "JOINTS_0": self.accessor(joints, "VEC4", 5121),
                      "WEIGHTS_0": self.accessor(weights, "VEC4")}
        self.json["meshes"] = [{"primitives": [{"attributes": attributes,
                                                "indices": self.accessor(indices, "SCALAR", 5123)}]}]
        self.json["nodes"] = [{"mesh": 0, "skin": 0}, {"name": "hip", "children": [2]},
                              {"name": "knee", "translation": [0, 1, 0]}]
        self.json["skins"] = [{"joints": [1, 2]}]
        turned = [0, 0, 0, 1, math.sin(0.6), 0, 0, math.cos(0.6)]
        self.json["animations"] = [{
            "name": "bend", "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
            "samplers": [{"input": self.accessor([0, 1], "SCALAR"), "output": self.accessor(turned, "VEC4")}]}]
        self.json["scene"], self.json["scenes"] = 0, [{"nodes": [0, 1]}]

    def accessor(self, numbers, kind, component=5126):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        data = struct.pack("<%d%s" % (len(numbers), LETTERS[component]), *numbers)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.json["accessors"].append({"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component,
                                       "count": len(numbers) // TYPES[kind], "type": kind})
        self.bytes += data
        return len(self.json["accessors"]) - 1

    def glb(self):
        buffers = [{"byteLength": len(self.bytes)}]
        if self.fallback:
            buffers.append({"byteLength": self.fallback, "extensions": {"EXT_meshopt_compression": {"fallback": True}}})
        text = json.dumps(dict(self.json, buffers=buffers)).encode()
        text += b" " * (-len(text) % 4)
        data = self.bytes + b"\0" * (-len(self.bytes) % 4)
        return (b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)) + struct.pack("<I", len(text)) + b"JSON" + text
                + struct.pack("<I", len(data)) + b"BIN\0" + data)


def rig(character, radius=0.6, depth=2):
    """A muscle on the knee, as the text of a rig file."""
    return json.dumps({
        "format": "sinew-rig", "version": 1, "character": character,
        "surface": {"mode": "swell", "iso": 0.25, "skin_blend": 0.04},
        "smoothing": {"depth": depth, "patch": "flat"}, "groups": [{"name": "all"}], "links": [],
        "primitives": [{"name": "calf", "bone": "knee", "group": "all", "kind": "ellipsoid", "center": [0, 0.3, 0],
                        "rotation": [0, 0, 0, 1], "radii": [radius, 0.5, radius], "reach": 1.4, "sign": 1}]})
