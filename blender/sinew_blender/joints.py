# blender/sinew_blender/joints.py: which bones of Blender are a character's, kept as text with the surface.
import functools
import json

import numpy
from mathutils import Matrix


class Joints:
    """The text read: bones by their number in the rig's character."""

    def __init__(self, text):
        told = json.loads(text)
        self.unit = told["unit"]  # Of Blender in one of the file's.
        self.world = Matrix(told["world"])  # Of the armature as imported: the surface's mesh is in this world.
        self.names = [row["bone"] for row in told["bones"]]  # "" for an object.
        self.owners = [row["owner"] for row in told["bones"]]  # Index of the state's others, or -1 for the armature.
        self.binds = numpy.array([row["bind"] for row in told["bones"]])  # Joint -> armature as bound.


def text_of(unit, world, rows):
    """rows: (bone, owner, bind) of each bone."""
    bones = [{"bone": bone, "owner": owner, "bind": [list(map(float, row)) for row in bind]}
             for bone, owner, bind in rows]
    return json.dumps({"unit": unit, "world": [list(row) for row in world], "bones": bones})


joints_of = functools.lru_cache(maxsize=32)(Joints)
