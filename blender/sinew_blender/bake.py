# blender/sinew_blender/bake.py: what a surface does from frame to frame, as shape keys or as a point cache.
import contextlib
import os
import struct

import bpy
import numpy
from bpy_extras.io_utils import ExportHelper

from . import follow, state

MOST_KEYS = 1000  # Blender keeps every one whole.


def frames_of(context, surface):
    """(frame, places in the world [V, 3]) of the scene's frames, each as it is shown."""
    scene, before = context.scene, context.scene.frame_current_final
    try:
        for frame in range(scene.frame_start, scene.frame_end + 1):
            scene.frame_set(frame)
            if surface.name in follow.problems:
                raise LookupError("%s: %s" % (surface.name, follow.problems[surface.name]))
            yield frame, _in_world(surface)
    finally:
        scene.frame_set(int(before), subframe=before % 1)


def _in_world(surface):
    places = numpy.empty(3 * len(surface.data.vertices), numpy.float32)
    surface.data.vertices.foreach_get("co", places)
    to_world = numpy.array(surface.matrix_world)
    return (places.reshape(-1, 3) @ to_world[:3, :3].T + to_world[:3, 3]).astype(numpy.float32)


def _baked_object(context, surface, suffix):
    """A plain object with the surface's mesh, where the surface is now, without an armature."""
    mesh = surface.data.copy()
    item = bpy.data.objects.new(surface.name + suffix, mesh)
    item.shape_key_clear()
    surface.users_collection[0].objects.link(item)
    return item


class _Bake:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        surface = state.surface_of(context)
        return surface is not None and follow.is_surface(surface) and context.mode in ("OBJECT", "POSE")

    def execute(self, context):
        surface = state.surface_of(context)
        if not surface.sinew.live:
            self.report({"ERROR"}, "%s is not live: it would not move" % surface.name)
            return {"CANCELLED"}
        try:
            self.bake(context, surface)
        except (LookupError, OSError) as error:
            self.report({"ERROR"}, " ".join(str(error.args[-1] if isinstance(error, LookupError) else error).split()))
            return {"CANCELLED"}
        surface.hide_render = True
        surface.hide_set(True)
        return {"FINISHED"}


class SinewBakeShapeKeys(_Bake, bpy.types.Operator):
    """Make a plain mesh with a shape key for each frame of the scene, that plays without Sinew"""

    bl_idname = "sinew.bake_shape_keys"
    bl_label = "To shape keys"

    def bake(self, context, surface):
        scene = context.scene
        if scene.frame_end - scene.frame_start >= MOST_KEYS:
            raise LookupError("more than %d frames: bake to a point cache, or choose fewer" % MOST_KEYS)
        frames = list(frames_of(context, surface))
        item = _baked_object(context, surface, " shape keys")
        item.data.vertices.foreach_set("co", frames[0][1].ravel())
        item.shape_key_add(name="Basis", from_mix=False)
        for frame, places in frames:
            key = item.shape_key_add(name="frame %d" % frame, from_mix=False)
            key.data.foreach_set("co", places.ravel())
        _key_frames(item.data.shape_keys, [frame for frame, _ in frames])
        item.data.update()


def _key_frames(keys, frames):
    """Each key is whole in its frame and gone in its neighbours', and between frames two of them mix."""
    action = bpy.data.actions.new(keys.id_data.name + " frames")
    keys.animation_data_create().action = action
    for frame in frames:
        curve = action.fcurves.new('key_blocks["frame %d"].value' % frame)
        points = [(at, float(at == frame)) for at in (frame - 1, frame, frame + 1) if frames[0] <= at <= frames[-1]]
        curve.keyframe_points.add(len(points))
        curve.keyframe_points.foreach_set("co", [number for point in points for number in point])
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
        curve.update()


class SinewBakePointCache(_Bake, bpy.types.Operator, ExportHelper):
    """Write the scene's frames as a point cache, and make a plain mesh that plays it"""

    bl_idname = "sinew.bake_point_cache"
    bl_label = "To a point cache"

    filename_ext = ".pc2"
    filter_glob: bpy.props.StringProperty(default="*.pc2", options={"HIDDEN"})

    def bake(self, context, surface):
        scene = context.scene
        count, samples = len(surface.data.vertices), scene.frame_end - scene.frame_start + 1
        unfinished = self.filepath + ".part"  # What was there stays until all is written.
        try:
            with open(unfinished, "wb") as file:
                file.write(struct.pack("<12siiffi", b"POINTCACHE2", 1, count, float(scene.frame_start), 1.0, samples))
                for _, places in frames_of(context, surface):
                    file.write(places.astype("<f4").tobytes())
            os.replace(unfinished, self.filepath)
        except BaseException:
            with contextlib.suppress(OSError):
                os.remove(unfinished)
            raise
        item = _baked_object(context, surface, " point cache")
        modifier = item.modifiers.new("Point cache", "MESH_CACHE")
        modifier.cache_format, modifier.filepath = "PC2", self.filepath
        modifier.frame_start = scene.frame_start
        modifier.forward_axis, modifier.up_axis = "POS_Y", "POS_Z"


CLASSES = (SinewBakeShapeKeys, SinewBakePointCache)
