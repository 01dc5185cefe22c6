# tests/blender/poses_in_blender.py: run by Blender: every rig that is asked for, in poses made here.
import json
import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
import inside  # noqa: E402
import numpy  # noqa: E402
from mathutils import Euler, Matrix  # noqa: E402

inside.install()
asked, count = json.load(open(inside.ARGUMENTS[0])), int(inside.ARGUMENTS[1])
for number, (rig, rest, out) in enumerate(asked):
    inside.clear()
    moments = inside.Moments(rest)
    surface = inside.open_rig(rig, detail="UNIFORM", depth=2)  # What adaptive detail is depends on the clips there are.
    armature = inside.still(surface)
    random = numpy.random.default_rng(number)
    for each in range(count):
        inside.pose(armature, moments.bases, random)
        if each >= count // 2:  # The whole character is somewhere else.
            armature.matrix_world = Matrix.Translation(random.uniform(-1, 1, 3)) @ Euler(
                random.uniform(-3, 3, 3)).to_matrix().to_4x4() @ armature.matrix_world
        moments.add(surface)
    moments.save(out)
