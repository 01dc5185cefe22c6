# blender/sinew_blender/preferences.py: where the Python module is, said in Blender's own preferences.
import bpy

from . import module


class SinewPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    module_folder: bpy.props.StringProperty(
        name="Folder of the module", subtype="DIR_PATH",
        description="The folder in which the Python package sinew lies; empty: where Python looks")

    def draw(self, _context):
        self.layout.prop(self, "module_folder")
        sinew, why = find()
        self.layout.label(text=why or "sinew %s, %s" % (sinew.__version__, sinew.__path__[0]),
                          icon="CHECKMARK" if sinew else "ERROR")


def find():
    """(the module, "") or (None, why not)."""
    addon = bpy.context.preferences.addons.get(__package__)
    return module.find(bpy.path.abspath(addon.preferences.module_folder) if addon and addon.preferences else "")


CLASSES = (SinewPreferences,)
