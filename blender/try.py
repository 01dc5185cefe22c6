# blender/try.py: run by Blender for `./run.sh blender [RIG]`: the add-on from here, and a character that walks.
import pathlib
import sys

import addon_utils
import bpy

HERE = pathlib.Path(__file__).resolve().parent
RIG = HERE.parent / "assets" / "humanoid.rig.json"


def main():
    sys.path.append(str(HERE))
    addon_utils.enable("sinew_blender", default_set=True)
    if "Cube" in bpy.data.objects:
        bpy.data.objects.remove(bpy.data.objects["Cube"])
    rigs = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    bpy.ops.import_scene.sinew_rig(filepath=str(pathlib.Path(rigs[0] if rigs else RIG).resolve()))
    action = bpy.context.object.animation_data and bpy.context.object.animation_data.action
    if action:
        bpy.context.scene.frame_start, bpy.context.scene.frame_end = map(int, action.frame_range)
    if not bpy.app.background:
        bpy.ops.screen.animation_play()


main()
