# blender/sinew_blender/panel.py: the tab "Sinew" in the sidebar of the 3D view.
import bpy

from . import follow, state


class SinewReload(bpy.types.Operator):
    """Read the rig again from its file"""

    bl_idname = "sinew.reload"
    bl_label = "Reload"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        surface = state.surface_of(context)
        return surface is not None and follow.is_surface(surface)

    def execute(self, context):
        surface = state.surface_of(context)
        follow.rebuild(surface)
        if surface.name in follow.problems:
            self.report({"ERROR"}, follow.problems[surface.name])
            return {"CANCELLED"}
        return {"FINISHED"}


class SINEW_PT_surface(bpy.types.Panel):
    bl_label = "Sinew"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Sinew"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        surface = state.surface_of(context)
        if surface is None or not follow.is_surface(surface):
            layout.operator("import_scene.sinew_rig", text="Open a rig", icon="IMPORT")
            layout.operator("import_scene.sinew_muscle_joints", text="Open muscle joints", icon="BONE_DATA")
            return
        if surface.name in follow.problems:
            layout.label(text=follow.problems[surface.name], icon="ERROR")
        own = surface.sinew
        layout.prop(own, "live")
        layout.prop(own, "rig")
        layout.prop(own, "detail")
        if own.detail == "UNIFORM":
            layout.prop(own, "depth")
        if own.muscles:
            layout.prop(own.muscles, "hide_viewport", text="Muscles", invert_checkbox=True)
        layout.operator("sinew.reload", icon="FILE_REFRESH")
        _draw_shapes(layout, surface)
        column = layout.column(align=True)
        column.operator("sinew.bake_shape_keys", text="Bake to shape keys", icon="SHAPEKEY_DATA")
        column.operator("sinew.bake_point_cache", text="Bake to a point cache", icon="FILE_CACHE")


def _draw_shapes(layout, surface):
    if surface.data.shape_keys:
        column = layout.column(heading="Shapes")
        for key in surface.data.shape_keys.key_blocks[1:]:
            column.prop(key, "value", text=key.name)


CLASSES = (SinewReload, SINEW_PT_surface)
