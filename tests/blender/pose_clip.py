# tests/blender/pose_clip.py: poses that Blender showed, as a clip that `sinew smooth` plays: the second opinion.
"""It shares nothing with the add-on. Blender tells where its bones are in the world, in the poses and in the file's own
rest, in which its importer leaves them; how a bone lies in Blender is the same in both and cancels. That says where the
file's nodes are, which become a glTF with one key a pose, and `sinew smooth --clips` makes the surfaces."""
import base64
import json
import pathlib
import struct

import numpy

from tools import run

TO_GLTF = numpy.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
CLIP = "poses made in Blender"
RATE = 30


def root_of(path):
    """The JSON of a .glb or .gltf, and what follows it."""
    data = pathlib.Path(path).read_bytes()
    if data[:4] != b"glTF":
        return json.loads(data), b""
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + size]), data[20 + size:]


def write_at_rest(path, out):
    """The file without its clips, each node numbered: Blender keeps that with the bone."""
    root, rest = root_of(path)
    root.pop("animations", None)
    for number, node in enumerate(root["nodes"]):
        node["extras"] = {"node": number}
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    if rest:
        text = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest
    out.write_bytes(text)


def turn_of(q):
    x, y, z, w = numpy.array(q, float) / numpy.linalg.norm(q)
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def quaternion_of(turn):
    """The eigenvector of the greatest eigenvalue of Bar-Itzhack's matrix."""
    m = turn
    k = numpy.array([[m[0, 0] - m[1, 1] - m[2, 2], m[1, 0] + m[0, 1], m[2, 0] + m[0, 2], m[2, 1] - m[1, 2]],
                     [0, m[1, 1] - m[0, 0] - m[2, 2], m[2, 1] + m[1, 2], m[0, 2] - m[2, 0]],
                     [0, 0, m[2, 2] - m[0, 0] - m[1, 1], m[1, 0] - m[0, 1]],
                     [0, 0, 0, m[0, 0] + m[1, 1] + m[2, 2]]])
    return numpy.linalg.eigh(k / 3, UPLO="U")[1][:, 3]


def local_of(node):
    if "matrix" in node:
        return numpy.array(node["matrix"], float).reshape(4, 4).T
    matrix = numpy.eye(4)
    matrix[:3, :3] = turn_of(node.get("rotation", (0, 0, 0, 1))) * numpy.array(node.get("scale", (1, 1, 1)))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def worlds_at_rest(nodes):
    parents = {child: number for number, node in enumerate(nodes) for child in node.get("children", ())}
    worlds = {}

    def world(number):
        if number not in worlds:
            above = world(parents[number]) if number in parents else numpy.eye(4)
            worlds[number] = above @ local_of(nodes[number])
        return worlds[number]
    return {number: world(number) for number in range(len(nodes))}, parents


def local_poses(path, told):
    """{node: [poses, 4, 4] to its parent}. told: numbers [bones], rest [bones, 4, 4], poses [poses, bones, 4, 4]."""
    nodes = root_of(path)[0]["nodes"]
    at_rest, parents = worlds_at_rest(nodes)
    moved = {}
    for place, number in enumerate(told["numbers"]):
        turned = told["poses"][:, place].astype(float) @ numpy.linalg.inv(told["rest"][place].astype(float))
        moved[int(number)] = TO_GLTF @ turned @ TO_GLTF.T @ at_rest[int(number)]
    at_rest[None] = numpy.eye(4)  # The parent of roots.
    above = {number: parents.get(number) for number in moved}
    return {number: numpy.linalg.inv(moved.get(above[number], at_rest[above[number]])) @ world
            for number, world in moved.items()}


def write_clip(path, told, out):
    nodes = root_of(path)[0]["nodes"]
    count = len(told["poses"])
    binary, accessors, views, samplers, channels = b"", [], [], [], []

    def add(rows, kind):
        nonlocal binary
        data = numpy.ascontiguousarray(rows, "<f4")
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": data.nbytes})
        accessors.append({"bufferView": len(views) - 1, "componentType": 5126, "count": data.size // {
            "SCALAR": 1, "VEC3": 3, "VEC4": 4}[kind], "type": kind})
        binary += data.tobytes()
        return len(accessors) - 1

    times = numpy.arange(count) / RATE
    accessors_of_times = add(times, "SCALAR")
    accessors[0].update(min=[0.0], max=[float(numpy.float32(times[-1]))])
    for number, locals_ in local_poses(path, told).items():
        scales = numpy.linalg.norm(locals_[:, :3, :3], axis=1)
        turns = numpy.array([quaternion_of(matrix[:3, :3] / scale) for matrix, scale in zip(locals_, scales)])
        for rows, kind, key in ((locals_[:, :3, 3], "VEC3", "translation"), (turns, "VEC4", "rotation"),
                                (scales, "VEC3", "scale")):
            samplers.append({"input": accessors_of_times, "output": add(rows, kind)})
            channels.append({"sampler": len(samplers) - 1, "target": {"node": number, "path": key}})
    kept = ("name", "children", "matrix", "translation", "rotation", "scale")
    plain = [{key: node[key] for key in kept if key in node} for node in nodes]
    uri = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": root_of(path)[0]["scenes"][:1], "nodes": plain,
            "buffers": [{"byteLength": len(binary), "uri": uri}], "bufferViews": views, "accessors": accessors,
            "animations": [{"name": CLIP, "samplers": samplers, "channels": channels}]}
    out.write_text(json.dumps(root))


def surfaces(rig, character, told, folder, *options):
    """[poses, V, 3] by the command line, in glTF's axes."""
    write_clip(character, told, folder / "poses.gltf")
    run("smooth", rig, "--clips", folder / "poses.gltf", "--clip", CLIP, "--fps", RATE, "--frames",
        "0:%d" % (len(told["poses"]) - 1), *options, "-o", folder / "live_%04d.obj")
    made = []
    for file in sorted(folder.glob("live_*.obj")):
        rows = [line.split()[1:4] for line in file.read_text().splitlines() if line.startswith("v ")]
        made.append(numpy.array(rows, float))
        file.unlink()
    return numpy.array(made)


def farthest(shown, made):
    """Largest distance of a vertex; shown: [poses, V, 3] in Blender's axes."""
    assert len(shown) == len(made) and shown[0].shape == made[0].shape, (shown.shape, made.shape)
    return float(numpy.linalg.norm(shown.astype(float) @ TO_GLTF[:3, :3].T - made, axis=2).max())
