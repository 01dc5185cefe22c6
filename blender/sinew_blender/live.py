# blender/sinew_blender/live.py: Blender calls these on every frame, and whenever something changes a pose.
import bpy
from bpy.app.handlers import persistent

from . import follow

_working = False  # Moving a mesh is a change, too.


def update_all(scene, depsgraph, again=False):
    """All surfaces of a scene that show another pose than the dependency graph has."""
    global _working
    if _working:
        return
    _working = True
    try:
        for surface in follow.surfaces_in(scene):
            follow.update(surface, depsgraph, again)
    finally:
        _working = False


@persistent
def on_frame(scene, depsgraph):
    """While rendering too, with the renderer's own graph; Blender evaluates the meshes again after this."""
    update_all(scene, depsgraph)


@persistent
def on_change(scene, depsgraph):
    update_all(scene, depsgraph)


@persistent
def on_other_data(*_):
    """After undo, redo and loading: every reference is another one, and meshes may be of another moment than poses."""
    follow.forget()
    update_all(bpy.context.scene, bpy.context.evaluated_depsgraph_get(), again=True)


HANDLERS = (("frame_change_post", on_frame), ("depsgraph_update_post", on_change), ("undo_post", on_other_data),
            ("redo_post", on_other_data), ("load_post", on_other_data))


def start():
    for place, handler in HANDLERS:
        getattr(bpy.app.handlers, place).append(handler)


def stop():
    for place, handler in HANDLERS:
        getattr(bpy.app.handlers, place).remove(handler)
    follow.forget()
