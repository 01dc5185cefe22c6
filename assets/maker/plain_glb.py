# assets/maker/plain_glb.py: a skinned, animated mesh in one colour as a binary glTF 2.0 file.
import json
import struct

from . import vec
from .glb import FLOAT, UBYTE, USHORT, Buffer


class Scene:
    """What a test scene is made of. bones: [(name, parent or None, origin)], parents first, none turned at bind."""

    def __init__(self, name, bones, positions, normals, triangles, weights, clips, colour):
        self.name, self.bones, self.positions, self.normals = name, bones, positions, normals
        self.triangles, self.weights, self.clips, self.colour = triangles, weights, clips, colour
        self.names = [bone[0] for bone in bones]


def _short(row, digits=6):
    return [round(c, digits) + 0.0 for c in row]  # + 0.0: no minus zero


def _mesh(buffer, scene):
    joints, weights = [], []
    for row in scene.weights:
        best = sorted(row.items(), key=lambda item: (-item[1], item[0])) + [(None, 0.0)] * (4 - len(row))
        joints.append([scene.names.index(bone) if bone else 0 for bone, _ in best])
        weights.append([share for _, share in best])
    index = [[v] for t in scene.triangles for v in t]
    vertices = 34962
    return {"attributes": {
        "POSITION": buffer.accessor([_short(p) for p in scene.positions], "VEC3", "f", FLOAT, vertices, bounds=True),
        "NORMAL": buffer.accessor([_short(n) for n in scene.normals], "VEC3", "f", FLOAT, vertices),
        "JOINTS_0": buffer.accessor(joints, "VEC4", "B", UBYTE, vertices),
        "WEIGHTS_0": buffer.accessor([_short(w) for w in weights], "VEC4", "f", FLOAT, vertices)},
        "indices": buffer.accessor(index, "SCALAR", "H", USHORT, 34963), "material": 0}


def _nodes(scene):
    origin = {name: place for name, _, place in scene.bones}
    nodes = []
    for name, parent, place in scene.bones:
        node = {"name": name, "translation": _short(vec.sub(place, origin[parent]) if parent else place)}
        children = [i for i, bone in enumerate(scene.bones) if bone[1] == name]
        if children:
            node["children"] = children
        nodes.append(node)
    nodes.append({"name": scene.name, "mesh": 0, "skin": 0})
    return nodes


def _animation(buffer, scene, clip):
    samplers, channels = [], []
    times = buffer.accessor([[t] for t in clip.times], "SCALAR", "f", FLOAT, bounds=True)
    for (bone, path), values in clip.tracks.items():
        output = buffer.accessor([_short(v) for v in values], "VEC4" if path == "rotation" else "VEC3", "f", FLOAT)
        channels.append({"sampler": len(samplers), "target": {"node": scene.names.index(bone), "path": path}})
        samplers.append({"input": times, "interpolation": "LINEAR", "output": output})
    return {"name": clip.name, "samplers": samplers, "channels": channels}


def pack(scene):
    """GLB bytes."""
    buffer = Buffer()
    primitive = _mesh(buffer, scene)
    not_turned = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]
    inverse_bind = [not_turned + _short(vec.scale(place, -1.0)) + [1] for _, _, place in scene.bones]
    document = {
        "asset": {"version": "2.0", "generator": "Sinew assets/make_scenes.py"},
        "scene": 0,
        "scenes": [{"nodes": [0, len(scene.bones)]}],
        "nodes": _nodes(scene),
        "meshes": [{"name": scene.name, "primitives": [primitive]}],
        "skins": [{"inverseBindMatrices": buffer.accessor(inverse_bind, "MAT4", "f", FLOAT), "skeleton": 0,
                   "joints": list(range(len(scene.bones)))}],
        "materials": [{"name": "plain", "pbrMetallicRoughness": {
            "baseColorFactor": scene.colour + [1.0], "metallicFactor": 0.0, "roughnessFactor": 0.7}}],
        "animations": [_animation(buffer, scene, clip) for clip in scene.clips],
    }
    while len(buffer.data) % 4:
        buffer.data.append(0)
    document.update(bufferViews=buffer.views, accessors=buffer.accessors, buffers=[{"byteLength": len(buffer.data)}])
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(buffer.data)) +
            struct.pack("<II", len(text), 0x4E4F534A) + text +
            struct.pack("<II", len(buffer.data), 0x004E4942) + bytes(buffer.data))


def ellipsoid(name, bone, group, centre, rotation, radii, bones, sign=1):
    """A rig's primitive; the centre in the bind pose, radii in metres."""
    origin = {each: place for each, _, place in bones}
    return {"name": name, "bone": bone, "group": group, "kind": "ellipsoid",
            "center": _short(vec.sub(centre, origin[bone])), "rotation": _short(rotation, 7),
            "radii": _short(radii), "reach": 1.4142135, "sign": sign}


def rig_text(character, mode, depth, groups, links, primitives, adaptive=False, along_normals=False):
    """The rig file, one primitive a line."""
    head = {"format": "sinew-rig", "version": 1, "character": character,
            "surface": {"mode": mode, "iso": 0.25, "skin_blend": 0.04},
            "smoothing": {"depth": depth, "patch": "pn", **({"projection": "analytic"} if along_normals else {}), **({"detail": "adaptive"} if adaptive else {})},
            "groups": [{"name": name} for name in groups], "links": [list(link) for link in links]}
    lines = ["  %s: %s" % (json.dumps(key), json.dumps(value)) for key, value in head.items()]
    rows = ",\n".join("    " + json.dumps(p) for p in primitives)
    return "{\n" + ",\n".join(lines) + ',\n  "primitives": [\n' + rows + "\n  ]\n}\n"
