# tests/blender/bake_in_blender.py: run by Blender: renders and bakes a surface, and compares.
import json
import os
import struct
import sys
import time

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402
import numpy  # noqa: E402
from mathutils import Quaternion, Vector  # noqa: E402

rig, face, colored, folder = inside.ARGUMENTS
FRAMES = range(1, 25)
NEAR = 1e-5
scene = bpy.context.scene


def seen(what, holds, value=""):
    print("seen: " + json.dumps({"what": what, "holds": bool(holds), "seen": str(value)}))


def places(item):
    shown = []
    for frame in FRAMES:
        scene.frame_set(frame)
        shown.append(inside.vertices(item))
    return numpy.array(shown)


def off(one, other):
    return float(numpy.abs(one - other).max()) if one.shape == other.shape else "%s, %s" % (one.shape, other.shape)


def bake(surface, operator, **options):
    """The object that an operator makes."""
    before = set(bpy.data.objects)
    bpy.context.view_layer.objects.active = surface
    assert operator(**options) == {"FINISHED"}
    (made,) = set(bpy.data.objects) - before
    surface.hide_set(False)
    return made


def check_bakes(surface):
    live = places(surface)
    seen("the clip moves it", numpy.abs(live[11] - live[0]).max() > 0.1)
    scene.frame_set(7)
    keys = bake(surface, bpy.ops.sinew.bake_shape_keys)
    seen("the frame of the scene is again what it was", scene.frame_current == 7)
    seen("shape keys show every frame", off(places(keys), live) < NEAR, off(places(keys), live))
    scene.frame_set(7, subframe=0.5)
    mixed = off(inside.vertices(keys), (live[6] + live[7]) / 2)
    seen("and mix between", mixed < NEAR, mixed)
    cache = bake(surface, bpy.ops.sinew.bake_point_cache, filepath=folder + "/cache.pc2")
    seen("a point cache shows every frame", off(places(cache), live) < NEAR, off(places(cache), live))
    data = open(folder + "/cache.pc2", "rb").read()
    head = struct.unpack("<12siiffi", data[:32])
    stored = numpy.frombuffer(data[32:], "<f4").reshape(len(FRAMES), -1, 3)
    seen("its file is what its head says", head == (b"POINTCACHE2\0", 1, live.shape[1], 1.0, 1.0, 24)
         and off(stored, live) < NEAR, head)
    return live, keys, cache


def select(item):
    for each in bpy.context.selected_objects:
        each.select_set(False)
    item.select_set(True)


def check_fbx(live, keys):
    """Its exporter leaves animated keys out where it goes action by action."""
    select(keys)
    bpy.ops.export_scene.fbx(filepath=folder + "/keys.fbx", use_selection=True, bake_anim_simplify_factor=0,
                             bake_anim_use_all_actions=False, bake_anim_use_nla_strips=False)
    before = set(bpy.data.objects)
    bpy.ops.import_scene.fbx(filepath=folder + "/keys.fbx", anim_offset=0.0)
    (read,) = [item for item in bpy.data.objects if item not in before and item.type == "MESH"]
    away = off(places(read)[[0, 6, 17, 23]], live[[0, 6, 17, 23]])
    seen("FBX that Blender writes of the keys is read back alike", away < NEAR, away)
    bpy.data.objects.remove(read)


def check_alembic(live, cache):
    if not bpy.app.alembic.supported:
        print("left out: Alembic written and read back, this Blender is built without it")
        return
    select(cache)
    bpy.ops.wm.alembic_export(filepath=folder + "/cache.abc", selected=True, start=1, end=24, as_background_job=False)
    before = set(bpy.data.objects)
    bpy.ops.wm.alembic_import(filepath=folder + "/cache.abc", as_background_job=False)
    (read,) = [item for item in bpy.data.objects if item not in before and item.type == "MESH"]
    away = off(places(read), live)
    seen("Alembic that Blender writes of it is read back alike", away < NEAR, away)
    bpy.data.objects.remove(read)


def render(shown, hidden, prefix):
    """24 small pictures by Cycles on the processor: no window, no graphics card."""
    shown.hide_render = False
    for item in hidden:
        item.hide_render = True
    scene.render.filepath = "%s/%s_" % (folder, prefix)
    bpy.ops.render.render(animation=True)
    return [pixels("%s/%s_%04d.png" % (folder, prefix, frame)) for frame in FRAMES]


def pixels(path):
    picture = bpy.data.images.load(path)
    values = numpy.empty(4 * picture.size[0] * picture.size[1], numpy.float32)
    picture.pixels.foreach_get(values)
    bpy.data.images.remove(picture)
    return values


def check_render(surface, keys, cache):
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.device = 1, False, "CPU"
    scene.render.resolution_x = scene.render.resolution_y = 64
    scene.frame_start, scene.frame_end = 1, 24
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    light = bpy.data.objects.new("light", bpy.data.lights.new("light", "SUN"))
    scene.collection.objects.link(camera)
    scene.collection.objects.link(light)
    camera.location = Vector((0, -5, 1))
    camera.rotation_euler = light.rotation_euler = (1.5, 0, 0)
    scene.camera = camera
    live, baked = render(surface, [keys, cache], "live"), render(cache, [surface, keys], "baked")
    apart = [float(numpy.abs(one - other).mean()) for one, other in zip(live, baked)]
    between = [float(numpy.abs(one - other).mean()) for one, other in zip(live, live[1:])]
    seen("24 rendered frames show the pose of their frame, as those of the bake do", max(apart) < 0.1 * min(between),
         (max(apart), min(between)))


def check_looks():
    """Colors were written as uvs, and materials are those of the file's own mesh, place by place."""
    inside.clear()
    surface = inside.open_rig(colored, detail="UNIFORM", depth=1)
    mesh = surface.data
    uvs, colors = numpy.empty(2 * len(mesh.loops), numpy.float32), numpy.empty(4 * len(mesh.loops), numpy.float32)
    mesh.uv_layers[0].data.foreach_get("uv", uvs)
    mesh.color_attributes[0].data.foreach_get("color", colors)
    uvs, colors = uvs.reshape(-1, 2), colors.reshape(-1, 4)
    seen("colors lie where uvs do", numpy.abs(colors[:, :2] - (uvs * (1, -1) + (0, 1))).max() < 1e-5
         and numpy.abs(colors[:, 2:] - (0.25, 1)).max() < 1e-5 and numpy.ptp(uvs, axis=0).min() > 0.3)
    (own,) = [item for item in bpy.data.objects if item.type == "MESH" and item != surface]
    theirs = {_key(own.data, polygon): own.material_slots[polygon.material_index].name for polygon in own.data.polygons}
    ours = {_key(mesh, polygon): surface.material_slots[polygon.material_index].name for polygon in mesh.polygons}
    seen("materials and uvs are those of the file's own mesh, triangle by triangle", theirs == ours, len(ours))


def _key(mesh, polygon):
    """A triangle by its corners on the texture."""
    corners = [mesh.uv_layers[0].data[loop].uv for loop in polygon.loop_indices]
    return frozenset((round(u, 4), round(v, 4)) for u, v in corners)


def check_face():
    """The shapes of the file: sliders, clips, and what the module makes of the same weights."""
    import sinew
    inside.clear()
    surface = inside.open_rig(face)
    keys = surface.data.shape_keys.key_blocks
    rig_ = sinew.load_rig(face)
    names = list(dict.fromkeys(rig_.character.shapes))
    seen("a slider for each shape", [key.name for key in keys[1:]] == names, keys.keys())
    scene.frame_set(13)
    weights = {key.name: key.value for key in surface.data.shape_keys.evaluated_get(
        bpy.context.evaluated_depsgraph_get()).key_blocks[1:]}
    smoother = sinew.Smoother(rig_.character, rig_)
    live = smoother(clip="talk", time=13 / scene.render.fps).positions[:, [0, 2, 1]] * (1, -1, 1)
    away = off(inside.vertices(surface), live)
    seen("its clip moves them", max(weights.values()) > 0.05 and away < 1e-4, (away, weights))
    surface.sinew.armature.animation_data_clear()
    surface.data.shape_keys.animation_data_clear()
    before = inside.vertices(surface)
    keys["jaw.open"].value = 1.0
    bpy.context.view_layer.update()
    seen("a slider moves the surface", numpy.abs(inside.vertices(surface) - before).max() > 0.05)


def measure(detail, words):
    """One bone turns; each change goes through Blender, Sinew and Blender again."""
    inside.clear()
    surface = inside.open_rig(rig, detail=detail, depth=3)
    bone = inside.still(surface).pose.bones["upper_arm.L"]
    begin, count = time.perf_counter(), 90
    for number in range(count):
        bone.rotation_quaternion = Quaternion((1, 0, 0), 0.01 * number)
        bpy.context.view_layer.update()
    rate = count / (time.perf_counter() - begin)
    vertices = len(surface.data.vertices)
    seen("%.0f changes a second %s, %d vertices" % (rate, words, vertices), vertices > 1000)


inside.install()
inside.clear()
scene.frame_start, scene.frame_end = 1, 24
body = inside.open_rig(rig)
live_places, keys_object, cache_object = check_bakes(body)
check_fbx(live_places, keys_object)
check_alembic(live_places, cache_object)
check_render(body, keys_object, cache_object)
check_looks()
check_face()
measure("UNIFORM", "at depth 3")
measure("RIG", "with the detail of the rig")
