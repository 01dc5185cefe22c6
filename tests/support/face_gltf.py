# tests/support/face_gltf.py: a head with morph targets, for tests of shapes in the window and in exports.
"""A closed egg of 736 triangles on three joints, six targets in groups ("blink.L", "brow_up" ...), and a clip "talk" that
turns the head and moves the weights, with what face_rig adds between 0 and 1: Blender shows no others."""
import json
import math
import struct

COLUMNS, RINGS = 23, 17
RADII, CENTER = (0.22, 0.3, 0.25), (0.0, 0.7, 0.0)
SHAPES = {  # name: center on the unit sphere, width, displacement
    "smile": ((0.0, -0.45, 0.9), 0.35, (0.0, 0.05, -0.03)),
    "blink.L": ((0.4, 0.2, 0.9), 0.2, (0.0, -0.04, 0.01)),
    "blink.R": ((-0.4, 0.2, 0.9), 0.2, (0.0, -0.04, 0.01)),
    "jaw.open": ((0.0, -0.8, 0.6), 0.45, (0.0, -0.12, -0.02)),
    "brow_up": ((0.0, 0.45, 0.9), 0.3, (0.0, 0.05, 0.02)),
    "brow_down": ((0.0, 0.45, 0.9), 0.3, (0.0, -0.04, 0.02)),
}
JOINTS = {"root": (0.0, 0.0, 0.0), "neck": (0.0, 0.4, 0.0), "head": (0.0, 0.2, 0.0)}
TIMES = (0.0, 0.5, 1.0, 1.5, 2.0)


def _directions():
    out = [(0.0, 1.0, 0.0)]
    for ring in range(1, RINGS):
        polar = math.pi * ring / RINGS
        for column in range(COLUMNS):
            turn = 2 * math.pi * column / COLUMNS
            out.append((math.sin(polar) * math.sin(turn), math.cos(polar), math.sin(polar) * math.cos(turn)))
    return out + [(0.0, -1.0, 0.0)]


def _triangles():
    at = lambda ring, column: 1 + (ring - 1) * COLUMNS + column % COLUMNS
    last = 1 + (RINGS - 1) * COLUMNS
    out = [(0, at(1, c), at(1, c + 1)) for c in range(COLUMNS)]
    for ring in range(1, RINGS - 1):
        for c in range(COLUMNS):
            a, b, d, e = at(ring, c), at(ring + 1, c), at(ring + 1, c + 1), at(ring, c + 1)
            out += [(a, b, d), (a, d, e)]
    return out + [(last, at(RINGS - 1, c + 1), at(RINGS - 1, c)) for c in range(COLUMNS)]


class _Data:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, rows, kind, letter="f", target=None):
        flat = [number for row in rows for number in row]
        data = struct.pack("<%d%s" % (len(flat), letter), *flat)
        view = {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.views.append(view)
        self.bytes += data + bytes(-len(data) % 4)
        accessor = {"bufferView": len(self.views) - 1, "type": kind, "count": len(rows),
                    "componentType": {"f": 5126, "H": 5123, "B": 5121}[letter]}
        if letter == "f" and kind in ("VEC3", "SCALAR"):
            kept = [struct.unpack("<%df" % len(row), struct.pack("<%df" % len(row), *row)) for row in rows]
            accessor.update(min=list(map(min, zip(*kept))), max=list(map(max, zip(*kept))))
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def _delta(direction, shape):
    center, width, by = SHAPES[shape]
    length = math.sqrt(sum(c * c for c in center))
    square = sum((d - c / length) ** 2 for d, c in zip(direction, center))
    share = math.exp(-square / (2 * width * width))
    return tuple(share * each if share > 0.01 else 0.0 for each in by)


def _mesh(data):
    directions = _directions()
    positions = [tuple(c + r * d for c, r, d in zip(CENTER, RADII, direction)) for direction in directions]
    share = [min(max((p[1] - 0.45) / 0.2, 0.0), 1.0) for p in positions]
    attributes = {
        "POSITION": data.add(positions, "VEC3", target=34962),
        "JOINTS_0": data.add([(1, 2, 0, 0)] * len(positions), "VEC4", "B", 34962),
        "WEIGHTS_0": data.add([(1 - s, s, 0.0, 0.0) for s in share], "VEC4", target=34962)}
    targets = [{"POSITION": data.add([_delta(d, shape) for d in directions], "VEC3", target=34962)} for shape in SHAPES]
    indices = data.add([(i,) for triangle in _triangles() for i in triangle], "SCALAR", "H", 34963)
    return {"name": "face", "weights": [0.0] * len(SHAPES), "extras": {"targetNames": list(SHAPES)},
            "primitives": [{"attributes": attributes, "indices": indices, "targets": targets, "material": 0}]}


def _clip(data):
    times = data.add([(t,) for t in TIMES], "SCALAR")
    turns = [(0.0, math.sin(0.25 * math.sin(math.pi * t)), 0.0, math.cos(0.25 * math.sin(math.pi * t))) for t in TIMES]
    weights = [(0.25 + 0.25 * math.sin(2 * t + i),) for t in TIMES for i in range(len(SHAPES))]
    return {"name": "talk",
            "samplers": [{"input": times, "output": data.add(turns, "VEC4"), "interpolation": "LINEAR"},
                         {"input": times, "output": data.add(weights, "SCALAR"), "interpolation": "LINEAR"}],
            "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}},
                         {"sampler": 1, "target": {"node": 3, "path": "weights"}}]}


def write_face(path, expressions=None):
    """Nodes: the joints in order, then the mesh. expressions: {name: {shape: weight}}, of VRM 1.0."""
    data = _Data()
    world, binds = [0.0, 0.0, 0.0], []
    for offset in JOINTS.values():
        world = [a + b for a, b in zip(world, offset)]
        binds.append((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -world[0], -world[1], -world[2], 1))
    nodes = [{"name": name, "translation": list(offset)} for name, offset in JOINTS.items()]
    for parent in (0, 1):
        nodes[parent]["children"] = [parent + 1]
    nodes.append({"name": "face", "mesh": 0, "skin": 0})
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 3]}], "nodes": nodes,
            "meshes": [_mesh(data)], "materials": [{"name": "skin", "pbrMetallicRoughness": {
                "baseColorFactor": [0.8, 0.6, 0.5, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.7}}],
            "skins": [{"joints": [0, 1, 2], "inverseBindMatrices": data.add(binds, "MAT4")}],
            "animations": [_clip(data)]}
    if expressions:
        shapes = list(SHAPES)
        root["extensionsUsed"] = ["VRMC_vrm"]
        root["extensions"] = {"VRMC_vrm": {"specVersion": "1.0", "expressions": {"custom": {
            name: {"morphTargetBinds": [{"node": 3, "index": shapes.index(shape), "weight": weight}
                                        for shape, weight in binds.items()]} for name, binds in expressions.items()}}}}
    root.update(accessors=data.accessors, bufferViews=data.views, buffers=[{"byteLength": len(data.bytes)}])
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    binary = data.bytes
    with open(path, "wb") as file:
        file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(binary), 0x004E4942) + binary)
    return path


def face_rig(character):
    """The text of a rig for it: a muscle in each cheek, a shape that the turn of the head drives, another half on."""
    def cheek(side, x):
        return {"name": "cheek " + side, "bone": "head", "group": "face", "kind": "ellipsoid",
                "center": [x, 0.02, 0.17], "rotation": [0, 0, 0, 1], "radii": [0.06, 0.08, 0.05], "reach": 2}
    driver = {"input": {"kind": "axis", "bone": "head", "axis": [0, 1, 0]}, "curve": [[-30, 0.5], [0, 0], [30, 0.5]]}
    return json.dumps({
        "format": "sinew-rig", "version": 2, "character": character, "smoothing": {"depth": 3},
        "groups": [{"name": "face"}], "links": [], "primitives": [cheek("L", 0.1), cheek("R", -0.1)],
        "shapes": [{"name": "blink.L", "weight": 0, "animated": [{"parameter": "weight", "drivers": [driver]}]},
                   {"name": "smile", "weight": 0.5}]})
