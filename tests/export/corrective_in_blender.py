# tests/export/corrective_in_blender.py: run by Blender: gives a character a shape key at its left elbow, writes a .glb.
"""blender -b --factory-startup --python corrective_in_blender.py -- IN.glb OUT.glb"""
import sys

import numpy

numpy.bool = bool  # Blender 3.4's importer asks for it by its old name.
import bpy

NAME = "elbow.L"


def main():
    source, out = sys.argv[sys.argv.index("--") + 1:]
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    bpy.ops.import_scene.gltf(filepath=source)
    mesh = max((item for item in bpy.data.objects if item.type == "MESH"), key=lambda item: len(item.data.vertices))
    armature = next(item for item in bpy.data.objects if item.type == "ARMATURE")
    elbow = armature.matrix_world @ armature.data.bones["forearm.L"].head_local
    mesh.shape_key_add(name="Basis")
    key = mesh.shape_key_add(name=NAME)
    moved = 0
    for vertex, point in zip(mesh.data.vertices, key.data):
        way = mesh.matrix_world @ vertex.co - elbow
        if way.length > 0.15:
            continue
        point.co = point.co + 0.25 * (0.15 - way.length) * vertex.normal
        moved += 1
    assert moved > 10, moved
    bpy.ops.export_scene.gltf(filepath=out, export_format="GLB", export_animations=True, export_nla_strips=True,
                              export_morph=True)


main()
