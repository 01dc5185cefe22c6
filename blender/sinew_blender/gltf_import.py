# blender/sinew_blender/gltf_import.py: Blender's glTF importer, and what each node of the file became.
import contextlib
from typing import NamedTuple

import bpy
import numpy
from mathutils import Matrix

from . import clips


class Joint(NamedTuple):
    """What a node of the file is in Blender."""

    object: str  # Name of the object that it is, or of the armature that has its bone.
    bone: str  # "" for an object.
    bind: Matrix  # Node -> armature as Blender bound it, in Blender's axes; of an object the identity.
    at_rest: Matrix  # Bone -> armature as the file has it at rest, before any clip; of an object the identity.


class Imported:
    """What an import made. Nothing of it is kept longer than an operator runs."""

    def __init__(self):
        self.joints = {}  # By number of the node.
        self.world = {}  # Matrices to the world of what became objects as the file has them at rest, by name.
        self.materials = {}  # Material by its number in the file.
        self.objects = []


_made = None  # What the running import is recorded in.


class NodeRecorder:
    """Blender's importer calls these while it works."""

    def gather_import_scene_after_nodes_hook(self, _gltf_scene, _scene, gltf):
        if _made is None:
            return
        bpy.context.view_layer.update()
        for number, node in gltf.vnodes.items():
            if node.type == 2:  # The root that the importer adds.
                continue
            if node.type == 1:
                arma = gltf.vnodes[node.bone_arma].blender_object
                at_rest = arma.pose.bones[node.blender_bone_name].matrix.copy()
                joint = Joint(arma.name, node.blender_bone_name, node.bind_arma_mat.copy(), at_rest)
            else:
                joint = Joint(node.blender_object.name, "", Matrix(), Matrix())
                _made.world[node.blender_object.name] = _at_rest(gltf, node)
            if isinstance(number, int):
                _made.joints[number] = joint
        for number, material in enumerate(gltf.data.materials or []):
            names = list(material.blender_material.values())
            if names:
                _made.materials[number] = names[0]

    def gather_import_animation_after_hook(self, number, _track, gltf):
        """The actions that one clip became."""
        name = gltf.data.animations[number].name
        if _made is not None and name:
            for action in gltf.action_cache.values():
                clips.mark(action, name, bpy.context.scene.render.fps)


def _at_rest(gltf, node):
    world = Matrix()
    while node.type == 0:
        where, turn, size = node.trs()
        world = Matrix.LocRotScale(where, turn, size) @ world
        node = gltf.vnodes.get(node.parent)
        if node is None:
            break
    return world


@contextlib.contextmanager
def _numpy_of_old():
    """The importer of Blender 3.4 asks NumPy for `bool` by a name that NumPy 1.24 dropped."""
    missing = "bool" not in vars(numpy)
    if missing:
        numpy.bool = bool
    try:
        yield
    finally:
        if missing:
            del numpy.bool


def import_gltf(path):
    """Opens a file by Blender's importer. Raises RuntimeError with a sentence."""
    global _made
    _made, before = Imported(), set(bpy.data.objects)
    try:
        with _numpy_of_old():
            done = bpy.ops.import_scene.gltf(filepath=path)
        made = _made
    except AttributeError:
        raise RuntimeError("Blender's glTF importer is switched off: Preferences > Add-ons > glTF 2.0 format") from None
    finally:
        _made = None
    if "FINISHED" not in done:
        raise RuntimeError("%s: Blender's glTF importer cannot open it" % path)
    made.objects = [each for each in bpy.data.objects if each not in before]
    bpy.context.view_layer.update()
    return made
