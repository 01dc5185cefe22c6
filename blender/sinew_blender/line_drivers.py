# blender/sinew_blender/line_drivers.py: drivers on the joints of muscle lines, and the text that they need.
"""The formulas of a line are longer than a driver's expression may be, so it calls a function. That is in a text of the
.blend file which Blender runs when the file is opened: neither the add-on nor the Python module is needed then."""
import json
import pathlib

import bpy
from mathutils import Matrix, Vector

from . import axes

TEXT = "sinew_line_joints.py"
FUNCTION = "sinew_line_joint"
FLEX = "sinew_flex"  # A number of the armature's object: added to the activation of all its lines.
REGISTER = '\n\nimport bpy  # noqa: E402\n\nbpy.app.driver_namespace["%s"] = driven\n' % FUNCTION
CHANNELS = (("location", 3), ("rotation_quaternion", 4), ("scale", 3))


def add(lines, joints, unit):
    """lines: line_data.read(); joints: of gltf_import. Returns how many joints are driven."""
    register_text()
    count = 0
    for data, line in lines:
        for joint in line["joints"]:
            count += _drive(data["joint_scale"], line, joint, joints, unit)
    return count


def register_text():
    """The text, made or brought up to date, and what it registers."""
    text = bpy.data.texts.get(TEXT) or bpy.data.texts.new(TEXT)
    text.clear()
    text.write(pathlib.Path(__file__).with_name("line_joints.py").read_text(encoding="utf-8") + REGISTER)
    text.use_module = True
    text.as_module()


def _drive(joint_scale, line, joint, joints, unit):
    target = joints[joint["node"]]
    armature = bpy.data.objects[target.object]
    bone = armature.pose.bones[target.bone]
    anchors = [line[key] for key in ("origin", "insertion", "via") if line.get(key)]
    names = [joints[anchor["node"]].bone for anchor in anchors] + [bone.parent.name]
    if not all(joints[anchor["node"]].object == target.object and name for anchor, name in zip(anchors, names)):
        raise LookupError('the bones of the line "%s" are not in one armature' % line["name"])
    for key, value in _in_bones(line, joints, unit).items():
        line = {**line, key: value}
    parent = next(each for each in joints.values() if (each.object, each.bone) == (target.object, bone.parent.name))
    bone["sinew_line"] = json.dumps(
        {"bones": names, "joint_scale": joint_scale, **_of_joint(bone, target, parent),
         "line": {**line, "via": line.get("via"), "joints": None, "at": [unit * part for part in joint["at"]]}})
    if FLEX not in armature:
        armature[FLEX] = 0.0
        armature.id_properties_ui(FLEX).update(min=0.0, max=1.0, description="Added to the activation of muscle lines")
    _add_drivers(armature, bone, names)
    return 1


def _node_in_bone(joint):
    """The file's node, in glTF's axes -> the bone of Blender."""
    rest = bpy.data.objects[joint.object].data.bones[joint.bone].matrix_local
    return rest.inverted() @ joint.bind @ axes.TO_BLENDER


def _in_bones(line, joints, unit):
    """What of a line is in the spaces of nodes, in those of Blender's bones; lengths in Blender's units."""
    moved = {key: unit * line[key] for key in ("length", "depth")}
    for key in ("origin", "insertion", "via"):
        if not line.get(key):
            continue
        anchor = dict(line[key])
        into = _node_in_bone(joints[anchor["node"]])
        anchor["point"] = list(into @ (unit * Vector(anchor["point"])))
        if "frame" in anchor:
            turn = into.to_3x3()
            anchor["frame"] = [list(turn @ Vector(anchor["frame"][i:i + 3])) for i in (0, 3, 6)]
        if "shift" in anchor:
            anchor["shift"] = [unit * part for part in anchor["shift"]]
        moved[key] = anchor
    return moved


def _of_joint(bone, joint, parent):
    above, own = _node_in_bone(parent), _node_in_bone(joint)
    rest = bone.parent.bone.matrix_local.inverted() @ bone.bone.matrix_local
    turn = rest.to_3x3().inverted() @ above.to_3x3()
    into = own.to_3x3().inverted()
    return {"parent": _rows(above), "rest": _rows(rest), "turn": _rows(turn.to_4x4()), "axes": _rows(into.to_4x4())}


def _rows(matrix: Matrix):
    return [list(row) for row in matrix]


def _add_drivers(armature, bone, names):
    """The variables are not read: because of them Blender poses the bones first that the function looks at."""
    bone.rotation_mode = "QUATERNION"
    channel = 0
    for path, count in CHANNELS:
        for index in range(count):
            driver = bone.driver_add(path, index).driver
            driver.type, driver.use_self = "SCRIPTED", True
            for number, name in enumerate(dict.fromkeys(names)):
                variable = driver.variables.new()
                variable.name, variable.type = "bone%d" % number, "TRANSFORMS"
                variable.targets[0].id, variable.targets[0].bone_target = armature, name
            flex = driver.variables.new()
            flex.name = "flex"
            flex.targets[0].id, flex.targets[0].data_path = armature, '["%s"]' % FLEX
            driver.expression = "%s(self, %d, flex)" % (FUNCTION, channel)
            channel += 1
