# tests/blender/missing_in_blender.py: run by Blender: opens rigs, and prints the refusal of each and what was made.
import json
import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402

inside.install()
inside.clear()
for rig in inside.ARGUMENTS:
    refused = ""
    try:
        assert bpy.ops.import_scene.sinew_rig(filepath=rig) == {"FINISHED"}
    except RuntimeError as error:
        refused = str(error)
    print("seen: " + json.dumps({"refused": refused, "objects": [item.name for item in bpy.data.objects]}))
    inside.clear()
bpy.ops.preferences.addon_disable(module="sinew_blender")
bpy.ops.preferences.addon_enable(module="sinew_blender")
