# blender/sinew_blender/__init__.py: the add-on as Blender finds it: what it is, what it registers. docs/blender.md.
"""Sinew's muscles in Blender: a rig's surface follows the armature, whatever poses it."""
bl_info = {
    "name": "Sinew: muscles for glTF characters",
    "author": "Sinew contributors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "File > Import; 3D View > Sidebar > Sinew",
    "description": "A surface with muscles that follows the armature; bakes; muscle joints with drivers",
    "category": "Import-Export",
}

import bpy  # noqa: E402: Blender reads bl_info alone where an add-on is off.

from . import bake, joint_import, live, panel, preferences, rig_import, state  # noqa: E402
from .gltf_import import NodeRecorder as glTF2ImportUserExtension  # noqa: E402, F401: Blender's importer asks for it

PARTS = (preferences, state, rig_import, joint_import, bake, panel)


def register():
    for part in PARTS:
        for each in part.CLASSES:
            bpy.utils.register_class(each)
    state.attach()
    bpy.types.TOPBAR_MT_file_import.append(rig_import.draw_menu)
    bpy.types.TOPBAR_MT_file_import.append(joint_import.draw_menu)
    live.start()


def unregister():
    live.stop()
    bpy.types.TOPBAR_MT_file_import.remove(joint_import.draw_menu)
    bpy.types.TOPBAR_MT_file_import.remove(rig_import.draw_menu)
    state.detach()
    for part in reversed(PARTS):
        for each in reversed(part.CLASSES):
            bpy.utils.unregister_class(each)
