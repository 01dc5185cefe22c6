# blender/sinew_blender/follow.py: a surface takes the pose of its armature; its mesh is made anew with other detail.
import bpy

from . import clips, smoothers, surface_mesh
from .joints import joints_of
from .pose import bone_matrices, shape_weights

REFUSALS = (LookupError, RuntimeError, ValueError, OSError)  # sinew.Error is a ValueError.
problems = {}  # Why a surface does not follow, by name of the object.
_shown = {}  # What pose a mesh shows, by its name.


def is_surface(item):
    return item.type == "MESH" and bool(item.sinew.rig and item.sinew.joints)


def surfaces_in(scene):
    return [each for each in scene.objects if is_surface(each)]


def forget():
    """Blender may have put other places into meshes: by undo, or from a file."""
    _shown.clear()
    problems.clear()


def update(surface, depsgraph, again=False):
    """Moves a surface to the pose that the dependency graph has. again: though it shows that pose already."""
    armature = surface.sinew.armature
    if not surface.sinew.live or surface.mode != "OBJECT" or (armature is not None and armature.mode == "EDIT"):
        return
    try:
        _follow(surface, depsgraph, again)
        problems.pop(surface.name, None)
    except REFUSALS as error:
        _tell(surface, error)


def _tell(surface, error):
    line = " ".join(_reason(error).split())
    if problems.get(surface.name) != line:
        print("Sinew: %s: %s" % (surface.name, line))
    problems[surface.name] = line


def _reason(error):
    if isinstance(error, OSError) and error.filename:
        return "%s: %s" % (error.filename, error.strerror)
    return str(error.args[0] if isinstance(error, LookupError) else error)


def _follow(surface, depsgraph, again):
    mesh = surface.data
    rival = _rival(surface, depsgraph)
    if rival:
        raise LookupError('shares its mesh with "%s": make it single-user' % rival.name)
    smoother = smoothers.smoother_of(surface.sinew)
    bones, shapes = bone_matrices(surface, depsgraph), shape_weights(surface, depsgraph)
    frame = depsgraph.scene.frame_current_final
    clip, time = clips.moment(surface.sinew.armature, frame, smoother.character.clips)
    pose = (id(smoother), bones.tobytes(), tuple(shapes.items()), clip, time)
    if not again and _shown.get(mesh.name_full) == pose:
        return
    made = smoother(clip, time, bones=bones, shapes=shapes or None)
    if not _fits(mesh, made):
        raise LookupError("the rig has other triangles now: press Reload")
    surface_mesh.move(mesh, made, joints_of(surface.sinew.joints).unit)
    _shown[mesh.name_full] = pose


def _fits(mesh, made):
    return len(made.positions) == len(mesh.vertices) and len(made.triangles) == len(mesh.polygons)


def _rival(surface, depsgraph):
    """A surface with the same mesh that follows another armature, and comes first."""
    if surface.data.users < 2:
        return None
    same = [each for each in surfaces_in(depsgraph.scene) if each.data == surface.data and each.sinew.live]
    first = min(same, key=lambda each: each.name, default=surface)
    return first if first.sinew.armature != surface.sinew.armature else None


def rebuild(surface):
    """With the rig as its file is now, and the detail that is asked for."""
    state = surface.sinew
    if not state.rig or not state.joints or not state.live:
        return
    try:
        made = smoothers.smoother_of(state)()
    except REFUSALS as error:
        _tell(surface, error)
        return
    if not _fits(surface.data, made):
        if surface.data.library:
            _tell(surface, LookupError("its mesh is linked, and the rig has other triangles now: reload it in its own file"))
            return
        surface_mesh.refill(surface, made, joints_of(state.joints).unit)
    update(surface, bpy.context.evaluated_depsgraph_get(), again=True)
