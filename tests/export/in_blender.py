# tests/export/in_blender.py: run by Blender: opens a .glb or point cache, plays it, writes where every vertex is.
"""blender -b --factory-startup --python in_blender.py -- FILE ASKED.json OUT.json

ASKED.json: [[clip, [seconds, ...]], ...]. OUT.json: [[clip, seconds, {object: [[x, y, z], ...]}], ...] in glTF's axes.
FILE: a .glb, or an .obj with a .pc2 or .mdd of 30 frames a second beside it."""
import json
import os
import struct
import sys

import numpy

numpy.bool = bool  # Blender 3.4's importer asks for it by its old name.
import bpy


def placed():
    """{name: (what, its property)} of objects, bones and shapes."""
    items = {item.name: (item, "matrix_basis") for item in bpy.data.objects}
    items |= {(item.name, bone.name): (bone, "matrix_basis")
              for item in bpy.data.objects if item.pose for bone in item.pose.bones}
    return items | {(keys.name, key.name): (key, "value") for keys in bpy.data.shape_keys for key in keys.key_blocks}


def resting(file):
    """Where all stands while no clip plays. With clips the importer leaves the pose of one of them, so that the file is
    opened without."""
    data = open(file, "rb").read()
    size = struct.unpack_from("<I", data, 12)[0]
    root = json.loads(data[20:20 + size])
    root.pop("animations", None)
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    bare = file.removesuffix(".glb") + ".rest.glb"
    with open(bare, "wb") as out:
        total = 20 + len(text) + len(data) - 20 - size
        out.write(struct.pack("<4sIIII", b"glTF", 2, total, len(text), 0x4E4F534A) + text + data[20 + size:])
    show(bare)
    rest = {name: getattr(item, value) if value == "value" else getattr(item, value).copy()
            for name, (item, value) in placed().items()}
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return rest


def play(clip, rest):
    """Every object moves by its action of that clip, and by nothing else: what it does not move rests."""
    for name, (item, value) in placed().items():
        if name in rest:
            setattr(item, value, rest[name])
    shapes = [item.data.shape_keys for item in bpy.data.objects if item.type == "MESH" and item.data.shape_keys]
    for item in [*bpy.data.objects, *shapes]:
        if not item.animation_data:
            continue
        action = None
        for track in item.animation_data.nla_tracks:
            track.mute = True
            if track.name == clip:
                action = track.strips[0].action
        item.animation_data.action = action


def vertices():
    graph = bpy.context.evaluated_depsgraph_get()
    result = {}
    for item in bpy.data.objects:
        if item.type != "MESH":
            continue
        evaluated = item.evaluated_get(graph)
        mesh = evaluated.to_mesh()
        places = [evaluated.matrix_world @ vertex.co for vertex in mesh.vertices]
        result[item.name] = [[place.x, place.z, -place.y] for place in places]
        evaluated.to_mesh_clear()
    return result


def show(file):
    """A character, or a surface with a cache of its points beside it."""
    if not file.endswith(".obj"):
        bpy.ops.import_scene.gltf(filepath=file)
        return
    bpy.ops.wm.obj_import(filepath=file)
    cache = file.removesuffix(".obj") + (".pc2" if os.path.exists(file.removesuffix(".obj") + ".pc2") else ".mdd")
    modifier = bpy.context.object.modifiers.new("cache", "MESH_CACHE")
    modifier.cache_format = cache[-3:].upper()
    modifier.filepath = cache
    bpy.context.scene.render.fps = 30


def main():
    file, asked, out = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    rest = resting(file) if file.endswith(".glb") else {}
    show(file)
    scene = bpy.context.scene
    seen = []
    for clip, times in json.load(open(asked)):
        play(clip, rest)
        for seconds in times:
            frame = seconds * scene.render.fps / scene.render.fps_base
            scene.frame_set(int(frame), subframe=frame - int(frame))
            seen.append([clip, seconds, vertices()])
    json.dump(seen, open(out, "w"))


main()
