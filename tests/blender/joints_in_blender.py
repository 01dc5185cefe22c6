# tests/blender/joints_in_blender.py: run by Blender: makes poses; plays them by keys and by drivers.
import json
import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402
import numpy  # noqa: E402

what, asked, count = inside.ARGUMENTS[0], json.load(open(inside.ARGUMENTS[1])), int(inside.ARGUMENTS[2])
RATE = 30


def make_poses(folder, seed):
    moments = inside.Moments(folder + "/rest.glb")
    armature = inside.plain_import(folder + "/rest.glb")
    random = numpy.random.default_rng(seed)
    for _ in range(count):
        inside.pose(armature, moments.bases, random, 1.2)
        bpy.context.view_layer.update()
        moments.poses.append(moments.bones(armature))
    moments.save(folder + "/told.npz")


def played(armature, names):
    """[poses, joints, 4, 4], four points of each joint's frame."""
    found = []
    for frame in range(count):
        bpy.context.scene.frame_set(frame)
        posed = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
        found.append([posed.matrix_world @ posed.pose.bones[name].matrix for name in names])
    return numpy.array(found)


def tell(folder, how, keyed, driven):
    moved = numpy.linalg.norm(keyed[..., :3, 3] - keyed[0][..., :3, 3], axis=-1).max()
    points = numpy.concatenate([0.2 * numpy.eye(4)[:3], [[0, 0, 0, 0]]]) + (0, 0, 0, 1)
    off = numpy.linalg.norm((keyed - driven) @ points.T, axis=-2).max()
    print("seen: " + json.dumps({"folder": folder, "how": how, "joints": keyed.shape[1], "poses": len(keyed),
                                 "off": float(off), "moved": float(moved)}))


def compare(folder):
    bpy.context.scene.render.fps = RATE
    armature = inside.plain_import(folder + "/hero.glb")
    before = set(bpy.data.objects)
    assert bpy.ops.import_scene.sinew_muscle_joints(filepath=folder + "/hero.glb") == {"FINISHED"}
    driven = next(item for item in bpy.data.objects if item not in before and item.type == "ARMATURE")
    names = [bone.name for bone in driven.pose.bones if "sinew_line" in bone]
    keyed = played(armature, names)
    own = driven.animation_data.action
    for curve in [each for each in own.fcurves if any('"%s"' % name in each.data_path for name in names)]:
        own.fcurves.remove(curve)  # The joints have no keys left: what moves them is the drivers.
    tell(folder, "by drivers", keyed, played(driven, names))
    name = driven.name
    bpy.ops.wm.save_as_mainfile(filepath=folder + "/driven.blend")
    bpy.ops.preferences.addon_disable(module="sinew_blender")
    bpy.ops.wm.open_mainfile(filepath=folder + "/driven.blend", use_scripts=True)
    assert not hasattr(bpy.types.Object, "sinew")
    tell(folder, "without the add-on, from the saved file", keyed, played(bpy.data.objects[name], names))


if what == "joints":
    inside.install()
for number, each in enumerate(asked):
    inside.clear()
    if what == "poses":
        make_poses(each, number)
        continue
    compare(each)
    bpy.ops.preferences.addon_enable(module="sinew_blender")
