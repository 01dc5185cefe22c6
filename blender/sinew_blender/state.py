# blender/sinew_blender/state.py: what a surface remembers in the .blend file: its rig, its armature, its joints.
import bpy

from . import follow

DETAIL = {"name": "Detail", "default": "RIG", "items": (
    ("RIG", "As in the rig", "What the rig file says"), ("UNIFORM", "Uniform", "Every triangle split alike"))}
DEPTH = {"name": "Depth", "default": 3, "min": 1, "max": 16, "description": "Every triangle becomes depth x depth"}


def _changed(self, _context):
    follow.rebuild(self.id_data)


class SinewOther(bpy.types.PropertyGroup):
    """An object besides the armature whose place or pose the surface follows."""

    object: bpy.props.PointerProperty(type=bpy.types.Object)


class SinewState(bpy.types.PropertyGroup):
    """Of an object that shows a surface; rig is empty on all others."""

    rig: bpy.props.StringProperty(name="Rig", subtype="FILE_PATH", description="The rig file", update=_changed)
    live: bpy.props.BoolProperty(
        name="Live", default=True, description="The surface follows the armature", update=_changed)
    detail: bpy.props.EnumProperty(update=_changed, **DETAIL)
    depth: bpy.props.IntProperty(update=_changed, **DEPTH)
    armature: bpy.props.PointerProperty(type=bpy.types.Object, name="Armature")
    others: bpy.props.CollectionProperty(type=SinewOther)
    muscles: bpy.props.PointerProperty(type=bpy.types.Collection, name="Muscles")
    joints: bpy.props.StringProperty()  # joints.text_of them.


def surface_of(context):
    """The surface of the active object: itself, or the one that follows it."""
    active = context.object
    if active is None or follow.is_surface(active):
        return active
    return next((each for each in follow.surfaces_in(context.scene) if each.sinew.armature == active), None)


def attach():
    bpy.types.Object.sinew = bpy.props.PointerProperty(type=SinewState)


def detach():
    del bpy.types.Object.sinew


CLASSES = (SinewOther, SinewState)
