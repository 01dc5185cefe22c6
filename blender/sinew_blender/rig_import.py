# blender/sinew_blender/rig_import.py: File > Import > Sinew rig: Blender's own character, with the surface on it.
import json
import pathlib

import bpy
import numpy
from bpy_extras.io_utils import ImportHelper

from . import axes, follow, gltf_import, muscles, preferences, shape_keys, smoothers, state, surface_mesh
from .joints import joints_of, text_of

FILE_SUFFIX = " (file)"  # Of the collection with the character's own meshes.


class SinewImportRig(bpy.types.Operator, ImportHelper):
    """Open a rig of Sinew: the character by Blender's glTF importer, with a surface that follows its armature"""

    bl_idname = "import_scene.sinew_rig"
    bl_label = "Import Sinew rig"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".json"
    filter_glob: bpy.props.StringProperty(default="*.rig.json", options={"HIDDEN"})
    detail: bpy.props.EnumProperty(**state.DETAIL)
    depth: bpy.props.IntProperty(**state.DEPTH)
    show_muscles: bpy.props.BoolProperty(
        name="Show muscles", description="As empties on the bones; the tab Sinew shows and hides them later, too")

    def execute(self, context):
        sinew, why = preferences.find()
        if sinew is None:
            self.report({"ERROR"}, why)
            return {"CANCELLED"}
        try:
            rig = sinew.load_rig(self.filepath)
            made = gltf_import.import_gltf(rig.character.path)
            _build(context, self, rig, made)
            if rig.unattached:
                self.report({"WARNING"}, "Left out, since the character lacks their bones: " + ", ".join(rig.unattached))
        except (*follow.REFUSALS, json.JSONDecodeError) as error:
            self.report({"ERROR"}, " ".join(str(error).split()))
            return {"CANCELLED"}
        return {"FINISHED"}


def _build(context, options, rig, made):
    """Everything that the operator adds to what Blender's importer made."""
    joints = [made.joints[node] for node in rig.character.nodes()]
    owners = _owners(rig.character, joints)
    unit = 1.0 / context.scene.unit_settings.scale_length
    world = made.world[owners[-1].name]
    text = text_of(unit, world, _rows(rig.character, joints, owners, made, unit))
    name = pathlib.Path(options.filepath).name.removesuffix(".json").removesuffix(".rig")
    surface = _surface(name, options, owners, world)
    _fill(surface, rig.character, made, unit)
    _put_away(context, name, made.objects, {owner for owner in owners if owner.type == "MESH"})
    _add_muscles(context, surface, rig, joints_of(text), owners, options.show_muscles)
    context.scene.render.use_lock_interface = True  # A render moves meshes: nothing else may draw them meanwhile.
    surface.sinew.joints = text  # From here on it is live.
    context.view_layer.update()
    follow.update(surface, context.evaluated_depsgraph_get(), again=True)
    _select(context, surface, owners[-1])


def _surface(name, options, owners, world):
    """The object, as a child of the armature, which stood at `world` when its mesh was where the file has it."""
    armature = owners[-1]
    surface = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    armature.users_collection[0].objects.link(surface)
    surface.parent = armature
    surface.matrix_parent_inverse = world.inverted_safe()
    # Without groups of vertices the modifier moves nothing. Because of it Blender poses an armature that is hidden.
    surface.modifiers.new("Armature", "ARMATURE").object = armature
    own = surface.sinew
    own.detail, own.depth, own.armature = options.detail, options.depth, armature
    for owner in owners[:-1]:
        own.others.add().object = owner
    own.rig = str(pathlib.Path(options.filepath).resolve())
    return surface


def _fill(surface, character, made, unit):
    """Its mesh, with the looks and the shapes of the file's own meshes."""
    first = smoothers.smoother_of(surface.sinew)()
    surface_mesh.fill(surface.data, first, unit)
    surface_mesh.add_slots(surface.data, first, made.materials)
    surface_mesh.assign_slots(surface.data, first)
    keys = [each.data.shape_keys for each in made.objects if each.type == "MESH" and each.data.shape_keys]
    animation = next((found for found in map(shape_keys.animation_of, keys) if found), None)
    shape_keys.put_on(surface, (shape_keys.sliders_of(character.shapes, keys), animation))


def _add_muscles(context, surface, rig, joints, owners, shown):
    collection = bpy.data.collections.new(surface.name + " muscles")
    context.scene.collection.children.link(collection)
    muscles.add(collection, rig, joints, owners)
    collection.hide_viewport = not shown
    surface.sinew.muscles = collection


def _select(context, surface, armature):
    for each in context.selected_objects:
        each.select_set(False)
    surface.select_set(True)
    armature.select_set(True)
    context.view_layer.objects.active = armature


def _owners(character, joints):
    """The objects that have the bones, the armature last."""
    armature = next((joint.object for joint in joints if joint.bone), None)
    if armature is None:
        raise LookupError("%s: Blender made no armature of it" % character.path)
    others = dict.fromkeys(joint.object for joint in joints if joint.object != armature)
    return [bpy.data.objects[name] for name in [*others, armature]]


def _rows(character, joints, owners, made, unit):
    """(bone, owner, bind) of each bone.

    The bind takes bones as the importer leaves them to where the file has its joints at rest, to the last digit.
    Blender's own, which is in heads, tails and rolls, may be off by 1e-4 of the height where bones are short.
    """
    names = [owner.name for owner in owners[:-1]]
    at_rest = axes.matrices_in_blender(character.rest(), unit)
    for joint, world in zip(joints, at_rest):
        owner = names.index(joint.object) if joint.object in names else -1
        if not joint.bone:
            yield "", owner, numpy.eye(4)
            continue
        rest = numpy.array(bpy.data.objects[joint.object].data.bones[joint.bone].matrix_local)
        in_armature = numpy.linalg.inv(numpy.array(made.world[joint.object])) @ world
        yield joint.bone, owner, rest @ numpy.linalg.inv(numpy.array(joint.at_rest)) @ in_armature


def _put_away(context, name, objects, needed):
    """The file's own meshes, hidden in a collection. Those that are bones themselves stay in sight of Blender."""
    collection = bpy.data.collections.new(name + FILE_SUFFIX)
    context.scene.collection.children.link(collection)
    for item in objects:
        if item.type != "MESH":
            continue
        item.hide_render = True
        if item in needed:
            item.display_type = "BOUNDS"
            continue
        for each in item.users_collection:
            each.objects.unlink(item)
        collection.objects.link(item)
    collection.hide_viewport = collection.hide_render = True


def draw_menu(self, _context):
    self.layout.operator(SinewImportRig.bl_idname, text="Sinew rig (.rig.json)")


CLASSES = (SinewImportRig,)
