# blender/sinew_blender/smoothers.py: rigs that are open, by file and detail. Made again when a file changes.
import os

import bpy

from . import preferences

MOST = 8  # Rigs kept open.
_open = {}


def files_of(rig):
    """What says whether a rig is still the same: its file and its character's."""
    return tuple((path, os.stat(path).st_mtime_ns) for path in rig)


def smoother_of(state):
    """The smoother for what a surface's state says. Raises sinew.Error, RuntimeError with a sentence, or OSError."""
    sinew, why = preferences.find()
    if sinew is None:
        raise RuntimeError(why)
    path = bpy.path.abspath(state.rig, library=state.id_data.library)
    wanted = (path, state.detail, state.depth if state.detail == "UNIFORM" else 0)
    found = _open.get(wanted)
    if found and found[0] == files_of([path, found[1].character.path]):
        return found[1]
    rig = sinew.load_rig(path)
    if state.detail == "UNIFORM":
        rig.detail, rig.depth = "uniform", state.depth
    smoother = sinew.Smoother(rig.character, rig, leave_out_missing=True)
    _open[wanted] = (files_of([path, rig.character.path]), smoother, rig)
    while len(_open) > MOST:
        del _open[next(iter(_open))]
    return smoother


def rig_of(state):
    """The rig beside the smoother."""
    smoother = smoother_of(state)
    return next(rig for _, each, rig in _open.values() if each is smoother)
