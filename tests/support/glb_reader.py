# tests/support/glb_reader.py: reads a .glb apart from the program, for the tests in Python.
import collections
import json
import struct


class Glb:
    def __init__(self, path):
        data = path.read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        self.json, self.data = json.loads(data[20:20 + size]), data[28 + size:]

    def rows(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
        letter = {5126: "f", 5125: "I", 5123: "H", 5121: "B"}[accessor["componentType"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = struct.unpack_from("<%d%s" % (accessor["count"] * width, letter), self.data, start)
        return [flat[i:i + width] for i in range(0, len(flat), width)]

    def triangles(self):
        """Corners as positions: texture seams do not count."""
        primitive = self.json["meshes"][0]["primitives"][0]
        positions = self.rows(primitive["attributes"]["POSITION"])
        index = [i for (i,) in self.rows(primitive["indices"])]
        return [tuple(positions[i] for i in index[k:k + 3]) for k in range(0, len(index), 3)]


def open_edges(triangles):
    """Directed edges that do not meet exactly one opposite edge."""
    edges = collections.Counter((t[k], t[(k + 1) % 3]) for t in triangles for k in range(3))
    return [e for e, count in edges.items() if count != 1 or edges[(e[1], e[0])] != 1]
