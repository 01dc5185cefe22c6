# tests/limits/costs.py: what the largest inputs that are allowed cost. Usage: costs.py PROGRAM
"""Prints seconds and peak memory of `sinew inspect` for each; not a test. The characters are made here, in a temporary folder."""
import array
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

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


def measured(command):
    """Exit status, seconds and peak MiB."""
    began = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), time.monotonic() - began, usage.ru_maxrss / 1024


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for make in (many_triangles, many_joints, many_clips, many_muscles):
            made = make()
            post, text = made if isinstance(made, tuple) else (made, None)
            file = folder / (make.__name__ + ".glb")
            file.write_bytes(post.glb())
            if text:
                file = folder / (make.__name__ + ".rig.json")
                file.write_text(text)
            status, seconds, peak = measured([program, "inspect", str(file), "--json"])
            print("%-16s %8.1f MB file: exit %d, %6.2f s, %7.0f MiB" % (make.__name__, file.stat().st_size / 1e6, status, seconds, peak),
                  flush=True)
            file.unlink()


if __name__ == "__main__":
    main()
