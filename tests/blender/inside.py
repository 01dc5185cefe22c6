# tests/blender/inside.py: what the tests' scripts share, inside Blender.
import os
import sys

import bpy
import numpy
from mathutils import Quaternion

ARGUMENTS = sys.argv[sys.argv.index("--") + 1:]


def install():
    """By Blender's own preferences, from the zip that the build makes."""
    bpy.ops.preferences.addon_install(filepath=os.environ["SINEW_ADDON"])
    bpy.ops.preferences.addon_enable(module="sinew_blender")
    assert "sinew_blender" in bpy.context.preferences.addons


def clear():
    """An empty scene; the add-on stays."""
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    for each in list(bpy.data.collections):
        bpy.data.collections.remove(each)
    bpy.ops.outliner.orphans_purge(do_recursive=True)


def plain_import(path):
    """By Blender's importer alone. Returns the armature."""
    missing = "bool" not in vars(numpy)
    if missing:
        numpy.bool = bool
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path)
    if missing:
        del numpy.bool
    bpy.context.view_layer.update()
    return next(item for item in bpy.data.objects if item not in before and item.type == "ARMATURE")


def open_rig(path, **options):
    """The surface."""
    before = set(bpy.data.objects)
    assert bpy.ops.import_scene.sinew_rig(filepath=str(path), **options) == {"FINISHED"}
    surface = next(item for item in bpy.data.objects if item not in before and item.sinew.rig)
    assert not problems(), problems()
    return surface


def problems():
    from sinew_blender import follow
    return follow.problems


def vertices(item, depsgraph=None):
    """[V, 3] in the world, as Blender evaluates them."""
    shown = item.evaluated_get(depsgraph or bpy.context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    places = numpy.empty(3 * len(mesh.vertices), numpy.float32)
    mesh.vertices.foreach_get("co", places)
    world = numpy.array(shown.matrix_world)
    shown.to_mesh_clear()
    return places.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]


class Moments:
    """Where bones and vertices are, for pose_clip.py."""

    def __init__(self, rest_file):
        armature = plain_import(rest_file)
        self.bases = {bone.name: bone.matrix_basis.copy() for bone in armature.pose.bones}
        self.names = [bone.name for bone in armature.pose.bones if "node" in bone]
        self.numbers = [armature.pose.bones[name]["node"] for name in self.names]
        self.rest = self.bones(armature)
        self.poses, self.shown, self.labels = [], [], []
        clear()

    def bones(self, armature):
        posed = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
        return numpy.array([posed.matrix_world @ posed.pose.bones[name].matrix for name in self.names])

    def add(self, surface, label=""):
        bpy.context.view_layer.update()
        assert not problems(), problems()
        self.poses.append(self.bones(surface.sinew.armature))
        self.shown.append(vertices(surface))
        self.labels.append(label)

    def save(self, path):
        numpy.savez(path, numbers=self.numbers, rest=self.rest, poses=self.poses, shown=self.shown, labels=self.labels)


def still(surface):
    """No clip plays, no shape weighs anything. Returns the armature."""
    armature = surface.sinew.armature
    armature.animation_data_clear()
    if surface.data.shape_keys:
        surface.data.shape_keys.animation_data_clear()
        for key in surface.data.shape_keys.key_blocks:
            key.value = 0.0
    return armature


def pose(armature, bases, random, most=0.7):
    """Every bone turned by up to so many radians from the file's rest, some moved, some grown unevenly."""
    heads = numpy.array([bone.head_local for bone in armature.data.bones])
    reach = 0.02 * numpy.ptp(heads, axis=0).max()
    for bone in armature.pose.bones:
        turn, angle = random.normal(size=3), random.uniform(-most, most)
        axis = numpy.sin(angle / 2) * turn / numpy.linalg.norm(turn)
        bone.rotation_mode = "QUATERNION"
        bone.matrix_basis = bases[bone.name]
        bone.rotation_quaternion = bone.rotation_quaternion @ Quaternion((numpy.cos(angle / 2), *axis))
        if random.uniform() < 0.1:
            bone.location = numpy.array(bone.location) + random.uniform(-reach, reach, 3)
        if random.uniform() < 0.1:
            bone.scale = numpy.array(bone.scale) * random.uniform(0.85, 1.2, 3)
