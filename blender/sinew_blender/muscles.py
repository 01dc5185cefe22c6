# blender/sinew_blender/muscles.py: a rig's muscles as empties on the bones, to look at.
import bpy
from mathutils import Matrix, Quaternion, Vector

from . import axes


def add(collection, rig, joints, owners):
    """joints: joints.Joints; owners: the objects of its bones."""
    numbers = {bone.name: bone.number for bone in rig.character.bones}
    for muscle in rig.muscles:
        number = numbers.get(muscle.bone)
        if number is None:
            continue
        empty = bpy.data.objects.new(muscle.name, None)
        empty.empty_display_type = "SPHERE"
        empty.empty_display_size = 1.0
        empty.show_in_front = True
        collection.objects.link(empty)
        _hang(empty, owners[joints.owners[number]], joints.names[number], Matrix(joints.binds[number].tolist()))
        x, y, z, w = muscle.rotation
        place = Matrix.Translation(joints.unit * Vector(muscle.center))
        turn = Quaternion((w, x, y, z)).to_matrix().to_4x4()
        empty.matrix_basis = axes.TO_BLENDER @ place @ turn @ Matrix.Diagonal(
            joints.unit * Vector(muscle.radii)).to_4x4() @ axes.TO_GLTF


def _hang(empty, owner, bone, bind):
    """On the joint: what hangs on a bone of Blender is placed from its tail."""
    empty.parent = owner
    if bone:
        rest = owner.data.bones[bone]
        empty.parent_type, empty.parent_bone = "BONE", bone
        empty.matrix_parent_inverse = (rest.matrix_local @ Matrix.Translation((0, rest.length, 0))).inverted() @ bind
