# tests/export/in_blender.py: run by Blender: opens a .glb or point cache, plays it, writes where every vertex is.
"""blender -b --factory-startup --python in_blender.py -- FILE ASKED.json OUT.json

ASKED.json: [[clip, [seconds, ...]], ...]. OUT.json: [[clip, seconds, {object: [[x, y, z], ...]}], ...] in glTF's axes.
FILE: a .glb, or an .obj with a .pc2 or .mdd of 30 frames a second beside it."""
import json
import os
import sys

import numpy

numpy.bool = bool  # Blender 3.4's importer asks for it by its old name.
import bpy


def resting():
    """Where the importer has put objects, bones and shapes."""
    placed = [bone for item in bpy.data.objects if item.pose for bone in item.pose.bones] + list(bpy.data.objects)
    keys = [key for each in bpy.data.shape_keys for key in each.key_blocks]
    return [(item, "matrix_basis", item.matrix_basis.copy()) for item in placed] + [(key, "value", key.value) for key in keys]


def play(clip, rest):
    """Every object moves by its action of that clip, and by nothing else: what it does not move rests."""
    for item, name, value in rest:
        setattr(item, name, value)
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
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    show(file)
    scene = bpy.context.scene
    seen, rest = [], resting()
    for clip, times in json.load(open(asked)):
        play(clip, rest)
        for seconds in times:
            frame = seconds * scene.render.fps / scene.render.fps_base
            scene.frame_set(int(frame), subframe=frame - int(frame))
            seen.append([clip, seconds, vertices()])
    json.dump(seen, open(out, "w"))


main()
