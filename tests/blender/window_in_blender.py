# tests/blender/window_in_blender.py: run by Blender with a window: opens a rig, poses it, undoes.
import json
import os
import subprocess
import sys
import traceback

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402
import numpy  # noqa: E402

rig, picture = inside.ARGUMENTS
TAB = (1043, 322)  # Of the window of 1280 x 800: the tab "Sinew" of the sidebar.
AT = {}


def seen(what, holds, value=""):
    print("seen: " + json.dumps({"what": what, "holds": bool(holds), "seen": str(value)}), flush=True)


def view():
    area = next(area for area in bpy.context.window.screen.areas if area.type == "VIEW_3D")
    return area, next(region for region in area.regions if region.type == "WINDOW")


def step_open():
    inside.install()
    inside.clear()
    menu = "\n".join(function.__module__ for function in bpy.types.TOPBAR_MT_file_import._dyn_ui_initialize())
    both = "sinew_blender.rig_import" in menu and "sinew_blender.joint_import" in menu
    seen("File > Import has both lines", both, menu)
    AT["surface"] = inside.open_rig(rig).name
    bpy.ops.ed.undo_push(message="open")


def step_frame():
    area, region = view()
    area.spaces[0].show_region_ui = True
    area.spaces[0].shading.type = "MATERIAL"
    with bpy.context.temp_override(area=area, region=region):
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_all()
    AT["before"] = inside.vertices(bpy.data.objects[AT["surface"]])


def step_render():
    """As F12 does it: beside the window, which goes on."""
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.location, camera.rotation_euler = (0, -5, 1), (1.5, 0, 0)
    scene.camera, scene.frame_end = camera, 6
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.render.resolution_x = scene.render.resolution_y = 128
    scene.render.filepath = picture + "_"
    bpy.ops.render.render("INVOKE_DEFAULT", animation=True)


def step_rendered():
    last = picture + "_0006.png"
    if bpy.app.is_job_running("RENDER") or not os.path.exists(last):
        return STEPS.insert(0, step_rendered)
    shown = {open("%s_%04d.png" % (picture, frame), "rb").read() for frame in range(1, 7)}
    seen("six rendered frames are six pictures", len(shown) == 6 and not inside.problems(), len(shown))
    bpy.data.objects.remove(bpy.context.scene.camera)
    bpy.context.scene.render.engine = "BLENDER_EEVEE"


def step_pose():
    """As a hand does it: in pose mode, by the rotate operator."""
    surface = bpy.data.objects[AT["surface"]]
    armature = inside.still(surface)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="POSE")
    bone = armature.pose.bones["forearm.L"]
    bone.rotation_mode = "QUATERNION"
    for each in armature.pose.bones:
        each.bone.select = each.name == "forearm.L"
    area, region = view()
    with bpy.context.temp_override(area=area, region=region):
        bpy.ops.transform.rotate(value=1.2, orient_axis="Y")
    bpy.ops.ed.undo_push(message="turned")


def step_look():
    surface = bpy.data.objects[AT["surface"]]
    AT["turned"] = inside.vertices(surface)
    seen("a turned bone takes the surface along", numpy.abs(AT["turned"] - AT["before"]).max() > 0.1)
    from sinew_blender import panel
    seen("the tab is there for the armature", panel.state.surface_of(bpy.context) == surface and not inside.problems())
    shown = panel.SINEW_PT_surface.draw

    def draw(self, context):
        AT["drawn"] = True
        shown(self, context)
    panel.SINEW_PT_surface.draw = draw
    x, y = TAB
    words = ["mousemove", str(x - 5), str(y), "sleep", "0.2", "mousemove", str(x), str(y)]
    subprocess.run(["xdotool", *words], check=True)


def step_click():
    subprocess.run(["xdotool", "mousedown", "1", "sleep", "0.1", "mouseup", "1"], check=True)


def step_picture():
    bpy.ops.screen.screenshot(filepath=picture)
    seen("a click on the tab draws it", AT.get("drawn"))
    seen("the picture is one of a window", os.path.getsize(picture) > 20000, os.path.getsize(picture))


def step_undo():
    bpy.ops.ed.undo()
    back = inside.vertices(bpy.data.objects[AT["surface"]])
    seen("undo takes it back", numpy.abs(back - AT["turned"]).max() > 0.1, numpy.abs(back - AT["turned"]).max())


STEPS = [step_open, step_frame, step_render, step_rendered, step_pose, step_look, step_click, step_picture, step_undo]


def go_on():
    """A step each time that Blender is idle, so that the window is drawn between."""
    try:
        STEPS.pop(0)()
    except BaseException:
        traceback.print_exc()
        os._exit(3)
    if STEPS:
        return 1.0
    os._exit(0)


if bpy.app.background:
    print("left out: no window")
else:
    bpy.context.preferences.view.show_splash = False
    bpy.app.timers.register(go_on, first_interval=1.0)
