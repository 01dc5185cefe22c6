# tests/blender/motion_in_blender.py: run by Blender: everything that may pose an armature, one after the other.
import json
import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402
import numpy  # noqa: E402
from mathutils import Quaternion, Vector  # noqa: E402

rig, rest, folder = inside.ARGUMENTS
scene = bpy.context.scene


def seen(what, holds, value=""):
    print("seen: " + json.dumps({"what": what, "holds": bool(holds), "seen": str(value)}))


def turned(armature, name, angle):
    bone = armature.pose.bones[name]
    bone.rotation_quaternion = bone.rotation_quaternion @ Quaternion((1, 0.3, 0.1), angle)
    return bone


def key(armature, frame, random):
    inside.pose(armature, moments.bases, random, 0.7)
    for bone in armature.pose.bones:
        bone.keyframe_insert("rotation_quaternion", frame=frame)
        bone.keyframe_insert("location", frame=frame)


def play(surface, label):
    for frame in (1, 4, 8, 10):
        scene.frame_set(frame, subframe=0.25 if frame == 4 else 0.0)
        moments.add(surface, label)


def keyed(surface, random):
    armature = inside.still(surface)
    key(armature, 1, random)
    key(armature, 10, random)
    play(surface, "keyed")


def ik(surface):
    """A hand pulled after an empty, which is keyed; nothing else moves."""
    armature = surface.sinew.armature
    armature.animation_data_clear()
    target = bpy.data.objects.new("target", None)
    scene.collection.objects.link(target)
    bone = armature.pose.bones["forearm.L"]
    hand = armature.matrix_world @ bone.tail
    constraint = bone.constraints.new("IK")
    constraint.target, constraint.chain_count = target, 2
    for frame, way in ((1, (0, 0, 0.1)), (10, (-0.2, -0.3, 0.2))):
        target.location = hand + Vector(way)
        target.keyframe_insert("location", frame=frame)
    play(surface, "IK target")
    bone.constraints.remove(constraint)
    bpy.data.objects.remove(target)


def second_action(surface):
    """As the importer made it from another clip of the file."""
    armature = surface.sinew.armature
    action = next(each for each in bpy.data.actions if each.name.startswith("Dance"))
    armature.animation_data_create().action = action
    play(surface, "second action")
    armature.animation_data_clear()


def undo(surface):
    """The surface goes back with the pose, and forth."""
    armature = surface.sinew.armature
    names = surface.name, armature.name
    bpy.ops.ed.undo_push(message="begin")
    turned(armature, "upper_arm.L", 0.5)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="turned once")
    once = inside.vertices(surface)
    turned(armature, "upper_arm.L", 0.5)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="turned twice")
    twice = inside.vertices(surface)
    bpy.ops.ed.undo()
    surface = bpy.data.objects[names[0]]
    back = inside.vertices(surface)
    moments.add(surface, "undo")
    seen("undo takes the surface back", numpy.abs(back - once).max() < 1e-6 < numpy.abs(back - twice).max())
    bpy.ops.ed.redo()
    surface = bpy.data.objects[names[0]]
    moments.add(surface, "redo")
    seen("redo brings it again", numpy.abs(inside.vertices(surface) - twice).max() < 1e-6)
    return surface


def two(surface, random):
    """The same rig a second time: each follows its own armature."""
    other = inside.open_rig(rig, detail="UNIFORM", depth=2)
    inside.still(other).location.x += 2
    for _ in range(2):
        inside.pose(surface.sinew.armature, moments.bases, random)
        inside.pose(other.sinew.armature, moments.bases, random)
        moments.add(surface, "two characters: the first")
        moments.add(other, "two characters: the second")
    shared = bpy.data.objects.new("shares", surface.data)
    scene.collection.objects.link(shared)
    shared.sinew.rig, shared.sinew.joints, shared.sinew.armature = rig, other.sinew.joints, other.sinew.armature
    turned(other.sinew.armature, "upper_arm.R", 0.4)
    bpy.context.view_layer.update()
    said = inside.problems().get("shares", "")
    seen("a mesh that two armatures would pose is left to the first", "shares its mesh" in said, said)
    bpy.data.objects.remove(shared)
    inside.problems().clear()
    return other


def hidden(surface):
    surface.sinew.armature.hide_viewport = True
    turned(surface.sinew.armature, "thigh.L", 0.6)
    moments.add(surface, "hidden armature")
    surface.sinew.armature.hide_viewport = False


def moved(surface):
    surface.sinew.armature.location = (0.3, -0.7, 0.2)
    surface.sinew.armature.rotation_mode = "XYZ"
    surface.sinew.armature.rotation_euler = (0.2, 0.4, -1.1)
    moments.add(surface, "object moved")


def another_scene(surface):
    """The armature and the surface are in two scenes."""
    second = bpy.data.scenes.new("second")
    for item in (surface, surface.sinew.armature):
        second.collection.objects.link(item)
    window = bpy.context.window
    window.scene = second
    turned(surface.sinew.armature, "shin.L", 0.7)
    moments.add(surface, "another scene")
    window.scene = scene


def renamed(surface):
    surface.name, surface.sinew.armature.name = "somebody", "skeleton"
    turned(surface.sinew.armature, "spine", 0.3)
    moments.add(surface, "renamed")


def detail(surface):
    surface.sinew.depth = 3
    finer = len(surface.data.vertices)
    surface.sinew.depth = 2
    seen("another depth is another mesh", finer > 2 * len(surface.data.vertices), finer)
    slots = [slot.material.name for slot in surface.material_slots]
    seen("its materials stay", slots and len(surface.data.uv_layers) == 1, slots)
    moments.add(surface, "uniform detail again")


def muscles_fit(surface):
    """In the pose that is shown: the middle of each, and the end of each of its axes."""
    import sinew
    read = sinew.load_rig(rig)
    action = surface.sinew.armature.animation_data.action
    clip, _ = max(read.character.clips.items(), key=lambda each: action.name.startswith(each[0]))
    scene.frame_set(5)
    bones = read.character.sample(clip, 5 / scene.render.fps)
    names = {bone.name: bone.number for bone in read.character.bones}
    for muscle in read.muscles:
        empty = surface.sinew.muscles.objects[muscle.name]
        x, y, z, w = muscle.rotation
        turn = numpy.array(Quaternion((w, x, y, z)).to_matrix())
        for axis in numpy.vstack([numpy.eye(3), numpy.zeros(3)]):
            point = bones[names[muscle.bone]] @ [*(muscle.center + turn @ (axis * muscle.radii)), 1.0]
            shown = empty.matrix_world @ Vector((axis[0], -axis[2], axis[1]))
            if numpy.abs(numpy.array(shown) - (point[0], -point[2], point[1])).max() > 1e-3:
                return False
    return len(read.muscles) == len(surface.sinew.muscles.objects) > 30


def saved(surface):
    name = surface.name
    bpy.ops.wm.save_as_mainfile(filepath=folder + "/saved.blend")
    turned(surface.sinew.armature, "upper_arm.L", 1.0)
    bpy.ops.wm.open_mainfile(filepath=folder + "/saved.blend")
    surface = bpy.data.objects[name]
    turned(surface.sinew.armature, "head", 0.4)
    moments.add(surface, "saved and opened")
    return surface


def file_gone(surface):
    """Whoever moves the rig is told which file is missing; back in its place, it is followed again."""
    own = folder + "/gone.rig.json"
    with open(rig, encoding="utf-8") as read, open(own, "w", encoding="utf-8") as copied:
        copied.write(read.read().replace('"humanoid.glb"', '"%s"' % (os.path.dirname(rig) + "/humanoid.glb")))
    surface.sinew.rig = own
    os.rename(own, own + "~")
    turned(surface.sinew.armature, "head", 0.1)
    bpy.context.view_layer.update()
    said = inside.problems().get(surface.name, "")
    seen("a rig file that is gone is named", said == own + ": No such file or directory", said)
    os.rename(own + "~", own)
    turned(surface.sinew.armature, "head", 0.1)
    moments.add(surface, "its file is back")
    surface.sinew.rig = rig


def linked(surface):
    """From another file: both linked, both overrides, and the surface local."""
    names = [surface.name, surface.sinew.armature.name]
    key(surface.sinew.armature, 1, random)
    key(surface.sinew.armature, 10, random)
    bpy.ops.wm.save_as_mainfile(filepath=folder + "/linked.blend")
    bpy.ops.wm.read_homefile(use_empty=True)
    with bpy.data.libraries.load(folder + "/linked.blend", link=True) as (_, wanted):
        wanted.objects = list(names)
    for item in wanted.objects:
        bpy.context.scene.collection.objects.link(item)
    surface = wanted.objects[0]
    for frame in (5, 9):
        bpy.context.scene.frame_set(frame)
        moments.add(surface, "linked")
    seen("its mesh is in the other file", surface.data.library is not None)
    surface = surface.override_create(remap_local_usages=True)
    armature = wanted.objects[1].override_create(remap_local_usages=True)
    seen("its override follows that of the armature", surface.sinew.armature == armature, surface.sinew.armature)
    armature.animation_data.action = None
    turned(armature, "upper_arm.R", 0.6)
    moments.add(surface, "override")
    surface.sinew.depth = 3
    said = inside.problems().get(surface.name, "")
    seen("other detail of a linked mesh is refused", "its own file" in said, said)
    surface.sinew.depth = 2
    surface.make_local()
    surface.data.make_local()
    turned(armature, "upper_arm.R", 0.3)
    moments.add(surface, "local, the armature an override")


inside.install()
moments = inside.Moments(rest)
inside.clear()
body = inside.open_rig(rig, detail="UNIFORM", depth=2, show_muscles=True)
random = numpy.random.default_rng(3)
others = [item for item in bpy.data.objects if item.type == "MESH" and item != body]
seen("the file's own mesh is out of sight", len(others) == 1 and not others[0].visible_get(), others)
seen("every muscle is an empty where the module has it", muscles_fit(body), len(body.sinew.muscles.objects))
keyed(body, random)
ik(body)
second_action(body)
body = undo(body)
two(body, random)
hidden(body)
moved(body)
another_scene(body)
renamed(body)
detail(body)
file_gone(body)
linked(saved(body))
moments.save(folder + "/told.npz")
