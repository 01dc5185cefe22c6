# blender/sinew_blender/pose.py: the bones of a rig's character as Blender poses them.
import numpy

from . import axes
from .joints import joints_of


def bone_matrices(surface, depsgraph):
    """[bones, 4, 4] float32, bone -> world in glTF's axes, as the module takes them. May raise LookupError, a sentence.

    What moves the skin is the pose matrix times the inverse of the rest matrix. How a bone lies in Blender, its roll
    and its tail, is in both, and does not matter. The armature's own place is left out: the surface is its child.
    """
    state = surface.sinew
    if state.armature is None:
        raise LookupError("its armature is gone")
    joints = joints_of(state.joints)
    owners = [each.object for each in state.others] + [state.armature]
    if None in owners:
        raise LookupError("an object that it follows is gone")
    posed = [each.evaluated_get(depsgraph) for each in owners]
    local = posed[-1].matrix_world.inverted_safe()
    shown = [numpy.array(joints.world @ local @ each.matrix_world) for each in posed[:-1]] + [numpy.array(joints.world)]
    rest, now = numpy.empty((2, len(joints.names), 4, 4))
    for number, (name, owner) in enumerate(zip(joints.names, joints.owners)):
        if not name:
            rest[number] = now[number] = numpy.eye(4)
            continue
        bone = posed[owner].pose.bones.get(name)
        if bone is None:
            raise LookupError('the armature "%s" has no bone "%s" any more' % (owners[owner].name, name))
        rest[number], now[number] = bone.bone.matrix_local, bone.matrix
    world = numpy.stack(shown)[joints.owners] @ now @ numpy.linalg.inv(rest) @ joints.binds
    return axes.matrices_in_gltf(world, joints.unit).astype(numpy.float32)


def shape_weights(surface, depsgraph):
    """Weights by shape, as animated and driven."""
    keys = surface.data.shape_keys
    if keys is None:
        return {}
    return {key.name: key.value for key in keys.evaluated_get(depsgraph).key_blocks[1:]}
