# tests/support/awkward_gltf.py: a character with what files of others may hold, for tests of exports.
"""Names with spaces, dots, quotes, other letters, digits first, given twice; two skins that bind a joint differently, a
mesh without a skin; nodes above joints that scale, stretch and move."""
import base64
import math
import random
import struct

import usd_reader

NAMES = ["Armature", "h\u00fcfte 1.0", "knee", "knee", "mover", "9 toe", "stretch", 'a/b "q"\\', "", "second skin", "loose"]


def turn(axis, degrees):
    """x, y, z, w"""
    half = math.radians(degrees) / 2
    return [math.sin(half) * (axis == i) for i in range(3)] + [math.cos(half)]


class Data:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, rows, kind, letter="f"):
        flat = [number for row in rows for number in row]
        data = struct.pack("<%d%s" % (len(flat), letter), *flat)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data + bytes(-len(data) % 4)
        accessor = {"bufferView": len(self.views) - 1, "type": kind, "count": len(rows),
                    "componentType": {"f": 5126, "H": 5123, "B": 5121}[letter]}
        if kind in ("VEC3", "SCALAR") and letter == "f":
            accessor.update(min=list(map(min, zip(*rows))), max=list(map(max, zip(*rows))))
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def nodes():
    made = [{"name": name} if name else {} for name in NAMES]
    made[0].update(rotation=turn(0, -90), scale=[100.0] * 3, children=[1, 6])
    made[1].update(scale=[0.01] * 3, children=[2, 3, 4], rotation=turn(0, 90))
    made[2].update(translation=[0.0, 1.0, 0.0], rotation=turn(2, 20))
    made[3].update(translation=[0.5, 1.0, 0.0])
    made[4].update(translation=[0.0, 0.5, 0.25], children=[5], scale=[2.0] * 3)
    made[5].update(translation=[0.0, 0.25, 0.0])
    made[6].update(scale=[0.01, 0.02, 0.01], children=[7])
    made[7].update(translation=[0.0, 0.3, 0.0], rotation=turn(2, 40))
    made[10].update(translation=[0.0, 0.2, 1.0])
    return made


def world_of(made):
    parents = {child: index for index, node in enumerate(made) for child in node.get("children", [])}

    def world(index):
        node = made[index]
        x, y, z, w = node.get("rotation", [0.0, 0.0, 0.0, 1.0])
        own = usd_reader.local(node.get("translation", [0.0] * 3), (w, x, y, z), node.get("scale", [1.0] * 3))
        return usd_reader.times(own, world(parents[index])) if index in parents else own
    return [world(index) for index in range(len(made))]


def awkward(clips=True, scales=False, resting=False):
    """The JSON of a .gltf. @param scales  some change over time  @param resting  the clip's keys are the rest pose"""
    chance, data, made = random.Random(7), Data(), nodes()
    world = world_of(made)
    skins = []
    for number, joints in enumerate(([1, 2, 3, 5, 7], [2, 1])):
        matrices = [usd_reader.inverse(world[joint]) for joint in joints]
        if number == 1:
            matrices[0][3][0] += 0.1  # The knee, bound elsewhere.
        rows = [[e for row in matrix for e in row] for matrix in matrices]
        skins.append({"joints": joints, "inverseBindMatrices": data.add(rows, "MAT4")})
    meshes = []
    for number, node in enumerate((8, 9, 10)):
        points = [[chance.uniform(-0.5, 0.5), chance.uniform(0.0, 2.0), chance.uniform(-0.5, 0.5)] for _ in range(24)]
        attributes = {"POSITION": data.add(points, "VEC3")}
        made[node]["mesh"] = number
        if node != 10:
            made[node]["skin"] = number
            width = len(skins[number]["joints"])
            weights = [[chance.random() for _ in range(4)] for _ in points]
            weights = [[w / sum(row) for w in row] for row in weights]
            attributes["WEIGHTS_0"] = data.add(weights, "VEC4")
            numbers = [chance.sample(range(width), min(width, 4)) for _ in points]
            attributes["JOINTS_0"] = data.add([(row + [0, 0])[:4] for row in numbers], "VEC4", "B")
        else:
            attributes["COLOR_0"] = data.add([[chance.random() for _ in range(3)] for _ in points], "VEC3")
        meshes.append({"primitives": [{"attributes": attributes, "material": number,
                                       "indices": data.add([[i] for i in range(24)], "SCALAR", "H")}]})
    materials = [{"name": 'skin "A" \u00df', "doubleSided": True}, {"name": 'skin "A" \u00df', "alphaMode": "MASK"},
                 {"name": "3", "alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.5, 0.25, 0.5]}}]
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 8, 9, 10]}], "nodes": made, "skins": skins,
            "meshes": meshes, "materials": materials}
    if clips:
        moves = [(1, "rotation", turn(2, 30)), (2, "rotation", turn(0, 70)), (4, "rotation", turn(1, 50)),
                 (4, "translation", [0.1, 0.6, 0.3]), (6, "rotation", turn(0, 25)), (10, "translation", [0.3, 0.1, 0.9])]
        if scales:
            moves += [(7, "scale", [1.5, 0.75, 1.25]), (2, "scale", [1.3] * 3), (6, "scale", [0.015, 0.01, 0.01])]
        samplers, channels = [], []
        for node, path, end in moves:
            otherwise = {"rotation": turn(0, 0), "scale": [1.0] * 3, "translation": [0.0] * 3}[path]
            start = made[node].get(path, otherwise)
            values = [start, start if resting else end]
            samplers.append({"input": data.add([[0.0], [0.99]], "SCALAR"),
                             "output": data.add(values, "VEC4" if path == "rotation" else "VEC3")})
            channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})
        root["animations"] = [{"name": '1st "clip"', "samplers": samplers, "channels": channels}]
    uri = "data:application/octet-stream;base64," + base64.b64encode(data.bytes).decode()
    root.update(buffers=[{"byteLength": len(data.bytes), "uri": uri}], bufferViews=data.views, accessors=data.accessors)
    return root
