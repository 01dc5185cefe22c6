# tests/blender/missing_in_blender.py: run by Blender: opens a rig, and one whose character is missing.
import json
import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402

inside.install()
inside.clear()
rig, broken = inside.ARGUMENTS
assert bpy.ops.import_scene.sinew_rig(filepath=rig) == {"FINISHED"}
print("seen: " + json.dumps({"objects": [item.name for item in bpy.data.objects]}))
inside.clear()
refused = ""
try:
    bpy.ops.import_scene.sinew_rig(filepath=broken)
except RuntimeError as error:
    refused = str(error)
print("seen: " + json.dumps({"refused": refused, "objects": len(bpy.data.objects)}))
bpy.ops.preferences.addon_disable(module="sinew_blender")
bpy.ops.preferences.addon_enable(module="sinew_blender")
