# blender/sinew_blender/joint_import.py: File > Import > Sinew muscle joints: a helpers export with drivers.
import bpy
from bpy_extras.io_utils import ImportHelper

from . import gltf_import, line_data, line_drivers


class SinewImportJoints(bpy.types.Operator, ImportHelper):
    """Open a character that Sinew exported with helper joints; those of muscle lines move in any pose"""

    bl_idname = "import_scene.sinew_muscle_joints"
    bl_label = "Import muscle joints"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".glb"
    filter_glob: bpy.props.StringProperty(default="*.glb;*.gltf", options={"HIDDEN"})

    def execute(self, context):
        try:
            found = line_data.read(self.filepath)
            made = gltf_import.import_gltf(self.filepath)
            count = line_drivers.add(found, made.joints, 1.0 / context.scene.unit_settings.scale_length)
        except (RuntimeError, OSError, ValueError, LookupError) as error:
            self.report({"ERROR"}, " ".join(str(error).split()))
            return {"CANCELLED"}
        context.view_layer.update()
        self.report({"INFO"}, "%d muscle joints are driven" % count)
        return {"FINISHED"}


def draw_menu(self, _context):
    self.layout.operator(SinewImportJoints.bl_idname, text="Sinew muscle joints (.glb/.gltf)")


CLASSES = (SinewImportJoints,)
