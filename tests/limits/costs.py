# tests/limits/costs.py: what the largest inputs that are allowed cost. Usage: costs.py PROGRAM [INPUT...]
"""Prints the seconds that processors worked and the peak memory of the program for each; not a test. The inputs are made here, in a
temporary folder. Exit status 1 if one is refused."""
import array
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

from hostile_post import Post, rig


def many_triangles():
    """2,000,000 triangles: a sheet of 1000 x 1000 cells."""
    post, side = Post(), 1001
    floats = array.array("f")
    for row in range(side):
        for column in range(side):
            floats.extend((column / side, row / side, 0.01 * ((row + column) % 2)))
    indices = array.array("I")
    for row in range(side - 1):
        for column in range(side - 1):
            a = row * side + column
            indices.extend((a, a + 1, a + side, a + 1, a + side + 1, a + side))
    views = post.json["bufferViews"]
    for data in (floats, indices):
        views.append({"buffer": 0, "byteOffset": len(post.bytes), "byteLength": len(data.tobytes())})
        post.bytes += data.tobytes()
    accessors = post.json["accessors"]
    accessors.append({"bufferView": len(views) - 2, "componentType": 5126, "count": side * side, "type": "VEC3"})
    accessors.append({"bufferView": len(views) - 1, "componentType": 5125, "count": len(indices), "type": "SCALAR"})
    post.json["meshes"] = [{"primitives": [{"attributes": {"POSITION": len(accessors) - 2}, "indices": len(accessors) - 1}]}]
    post.json["nodes"][0].pop("skin")
    return post


def many_joints():
    """4,096 joints, in chains of 64."""
    post = Post()
    nodes = post.json["nodes"]
    while len(nodes) < 4097:
        parent = nodes[1] if len(nodes) % 64 == 0 else nodes[-1]
        parent.setdefault("children", []).append(len(nodes))
        nodes.append({"name": "j%d" % len(nodes), "translation": [0, 0.001, 0]})
    post.json["skins"][0]["joints"] = list(range(1, 4097))
    return post


def many_clips():
    """1,000 clips of 2 minutes, 60 keys a second, that share their keys."""
    post = Post()
    keys = 7200
    sampler = {"input": post.accessor([k / 60 for k in range(keys)], "SCALAR"), "output": post.accessor([0, 0, 0, 1] * keys, "VEC4")}
    clip = dict(post.json["animations"][0], samplers=[sampler])
    post.json["animations"] = [dict(clip, name="clip %d" % i) for i in range(1000)]
    return post


def many_muscles():
    """65,536 muscles."""
    text = json.loads(rig("many_muscles.glb"))
    one = text["primitives"][0]
    text["primitives"] = [dict(one, name="m%d" % i, radii=[0.01, 0.01, 0.01]) for i in range(65536)]
    return Post(), json.dumps(text)


def whole_file():
    """A file of 1 GiB, nearly all of it bytes that nothing refers to."""
    post = Post()
    post.bytes += bytes((1 << 30) - len(post.glb()) - 64)
    return post


def many_values():
    """Nearly 4,000,000 JSON values."""
    post = Post()
    post.json["extras"] = [0] * 3_999_000
    return post


def many_nodes():
    """200,000 nodes."""
    post = Post()
    nodes = post.json["nodes"]
    nodes.extend({"translation": [0, 0, 0]} for _ in range(200_000 - len(nodes)))
    return post


def many_morphs():
    """1,024 morph targets of 2,004 vertices."""
    post = Post(500)
    primitive = post.json["meshes"][0]["primitives"][0]
    target = post.accessor([0, 0.01, 0] * 2004, "VEC3")
    primitive["targets"] = [{"POSITION": target} for _ in range(1024)]
    return post


def compressed():
    """16 MB of compressed bytes that become 1 GiB: zeros, of which the codec needs one byte for 64."""
    post = Post()
    stride, count = 16, (1 << 30) // 16 - 256
    data = b"\xa0" + bytes(count // 256 * 4 * stride) + bytes(32)
    post.bytes += bytes(-len(post.bytes) % 4)
    view = {"buffer": 0, "byteOffset": len(post.bytes), "byteLength": len(data), "byteStride": stride, "count": count, "mode": "ATTRIBUTES"}
    post.json["bufferViews"].append({"buffer": 1, "byteLength": stride * count, "byteStride": stride,
                                     "extensions": {"EXT_meshopt_compression": view}})
    post.json["extensionsUsed"] = post.json["extensionsRequired"] = ["EXT_meshopt_compression"]
    post.fallback = stride * count
    post.bytes += data
    return post


def refined():
    """15,900,000 refined vertices, of 124,000 triangles at depth 16, and one muscle."""
    return Post(15500), rig("refined.glb", depth=16)


def hour():
    """A clip of an hour, ten keys a second."""
    post, keys = Post(), 36000
    turned = [[0, 0, 0, 1], [math.sin(0.6), 0, 0, math.cos(0.6)]]
    post.json["animations"][0]["samplers"] = [{
        "input": post.accessor([k / 10 for k in range(keys + 1)], "SCALAR"),
        "output": post.accessor([number for k in range(keys + 1) for number in turned[k % 2]], "VEC4")}]
    return post, rig("hour.glb", depth=1)


INSPECT = ["inspect", "--json"]
INPUTS = ((many_triangles, INSPECT), (many_joints, INSPECT), (many_clips, INSPECT), (many_muscles, INSPECT), (whole_file, INSPECT),
          (many_values, INSPECT), (many_nodes, INSPECT), (many_morphs, INSPECT), (compressed, INSPECT),
          (refined, ["smooth", "-o", "out.ply"]), (hour, ["export", "--as", "skinned", "-o", "out.glb"]))


def written(make, folder):
    """What the program opens. A process of its own makes it: peak memory counts what its starter held before."""
    name = make.__name__
    child = os.fork()
    if child == 0:
        made = make()
        post, text = made if isinstance(made, tuple) else (made, None)
        (folder / (name + ".glb")).write_bytes(post.glb())
        if text:
            (folder / (name + ".rig.json")).write_text(text)
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0, name
    rig_file = folder / (name + ".rig.json")
    return rig_file.name if rig_file.exists() else name + ".glb"


def measured(command, folder):
    """Exit status, seconds on processors and peak MiB."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, cwd=folder)
    _, status, usage = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    refused = 0
    for make, (verb, *options) in INPUTS:
        if sys.argv[2:] and make.__name__ not in sys.argv[2:]:
            continue
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            name = written(make, folder)
            size = sum(file.stat().st_size for file in folder.iterdir()) / 1e6
            status, seconds, peak = measured([program, verb, name, *options], folder)
            refused += status != 0
            print("%-15s %7.1f MB, %s: exit %d, %6.1f s, %7.0f MiB" % (make.__name__, size, verb, status, seconds, peak), flush=True)
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
