# tests/export/godot_in_python.py: examples/godot/sinew_muscles.gd run line by line as Python, with stubs of Godot's types.
# GDScript's types and Godot itself are not checked by this; the formulas, the Importer and the way through bones are.
import math
import re


class Vector3:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __add__(self, o):
        return Vector3(self.x + o.x, self.y + o.y, self.z + o.z)

    def __sub__(self, o):
        return Vector3(self.x - o.x, self.y - o.y, self.z - o.z)

    def __mul__(self, t):
        return Vector3(self.x * t, self.y * t, self.z * t)

    def __truediv__(self, t):
        return self * (1.0 / t)

    def dot(self, o):
        return self.x * o.x + self.y * o.y + self.z * o.z

    def cross(self, o):
        return Vector3(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)

    def length(self):
        return math.sqrt(self.dot(self))

    def normalized(self):
        return self / self.length()

    def limit_length(self, most):
        return self * (most / self.length()) if self.length() > most else self


Vector3.ONE = Vector3(1.0, 1.0, 1.0)


class Basis:
    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __mul__(self, o):
        if isinstance(o, Vector3):
            return self.x * o.x + self.y * o.y + self.z * o.z
        return Basis(self * o.x, self * o.y, self * o.z)

    def determinant(self):
        return self.x.dot(self.y.cross(self.z))

    def transposed(self):
        return Basis(*(Vector3(getattr(self.x, i), getattr(self.y, i), getattr(self.z, i)) for i in "xyz"))

    def inverse(self):
        volume = self.determinant()
        return Basis(self.y.cross(self.z) / volume, self.z.cross(self.x) / volume, self.x.cross(self.y) / volume).transposed()

    def get_rotation_quaternion(self):
        """Kept as a basis, which has to be a rotation."""
        axes = (self.x, self.y, self.z)
        assert all(abs(a.dot(b) - (a is b)) < 1e-6 for a in axes for b in axes) and self.determinant() > 0.0
        return self


class Transform3D:
    def __init__(self, basis, origin):
        self.basis, self.origin = basis, origin

    def __mul__(self, o):
        if isinstance(o, Vector3):
            return self.basis * o + self.origin
        return Transform3D(self.basis * o.basis, self * o.origin)

    def affine_inverse(self):
        inverse = self.basis.inverse()
        return Transform3D(inverse, inverse * self.origin * -1.0)


class PackedInt32Array(list):
    def is_empty(self):
        return not self


class Skeleton3D:
    """Bones in reverse order of the file's nodes, so that numbers of nodes and of bones are never taken for each other."""

    def __init__(self, names, parents):
        count = len(names)
        self.names = names[::-1]
        self.parents = [-1 if parents[node] is None else count - 1 - parents[node] for node in range(count)][::-1]
        self.poses, self.local, self.meta = [None] * count, {}, {}

    def find_bone(self, name):
        return self.names.index(name) if name in self.names else -1

    def set_meta(self, name, value):
        self.meta[name] = value

    def has_meta(self, name):
        return name in self.meta

    def get_meta(self, name):
        return self.meta[name]

    def get_bone_parent(self, bone):
        return self.parents[bone]

    def get_bone_global_pose(self, bone):
        return self.poses[bone]

    def set_bone_pose_position(self, bone, position):
        self.local.setdefault(bone, {})["position"] = position

    def set_bone_pose_rotation(self, bone, rotation):
        self.local.setdefault(bone, {})["rotation"] = rotation

    def set_bone_pose_scale(self, bone, scale):
        self.local.setdefault(bone, {})["scale"] = scale


class Record:
    def __init__(self, **members):
        self.__dict__.update(members)


RULES = [(r"^@tool$|^class_name .*|^extends .*", ""),
         (r"^@export_range\(.*\) ", ""),
         (r"^(\t*)class (\w+) extends \w+:", r"\1class \2:"),
         (r"^(\t*)(?:static )?func ", r"\1def "),
         (r"\bfrom\b", "first"),
         (r"(\w+) := ", r"\1 = "),
         (r"\bvar (\w+)(?:: \w+)? = ", r"\1 = "),
         (r"\bfor (\w+)(?:: \w+)? in ", r"for \1 in "),
         (r" in (\d+):$", r" in range(\1):"),
         (r" in (\w+)\.size\(\):$", r" in range(len(\1)):"),
         (r"(\w+)\.has\((\"\w+\")\)", r"(\2 in \1)"),
         (r"(\w+) is Dictionary", r"isinstance(\1, dict)")]


def script(text):
    """The script's functions and variables, as a module has them."""
    lines = []
    for line in text.splitlines():
        for pattern, replacement in RULES:
            line = re.sub(pattern, replacement, line)
        lines.append(line)
    names = {name: getattr(math, name) for name in ("exp", "log", "tanh", "sqrt", "sin", "cos", "atan2", "pow")}
    names.update(absf=abs, maxf=max, minf=min, clampf=lambda v, low, high: min(max(v, low), high),
                 signf=lambda v: (v > 0) - (v < 0), true=True, false=False, OK=0, Vector3=Vector3, Basis=Basis,
                 Transform3D=Transform3D, PackedInt32Array=PackedInt32Array)
    exec(compile("from __future__ import annotations\n" + "\n".join(lines), "sinew_muscles.gd", "exec"), names)
    return names


def transform(e):
    columns = [Vector3(*e[i:i + 3]) for i in (0, 4, 8, 12)]
    return Transform3D(Basis(*columns[:3]), columns[3])


def check(text, file, oracle):
    """How many joints were posed, and how far they are apart from the oracle's, of H."""
    godot = script(text)
    nodes = file["nodes"]
    parents = [None] * len(nodes)
    for i, node in enumerate(nodes):
        for child in node.get("children", []):
            parents[child] = i
    names = [node.get("name", "").replace(":", "_").replace("/", "_") for node in nodes]
    skeleton = Skeleton3D(names, parents)
    state = Record(json=file, get_nodes=lambda: [Record(resource_name=name) for name in names],
                   get_scene_node=lambda node: skeleton)
    assert godot["Importer"]._import_post(state, Record(find_children=lambda *_: [skeleton])) == 0
    godot["get_skeleton"] = lambda: skeleton
    count, worst, height = 0, 0.0, oracle["height"]
    for pose in oracle["poses"]:
        for node, matrix in pose["bones"].items():
            skeleton.poses[len(nodes) - 1 - int(node)] = transform(matrix)
        godot["flex"] = pose["flex"]
        skeleton.local = {}
        godot["_process_modification"]()
        for bone, local in skeleton.local.items():
            rotation, scale = local["rotation"], local["scale"]
            found = skeleton.poses[skeleton.parents[bone]] * Transform3D(
                Basis(rotation.x * scale.x, rotation.y * scale.y, rotation.z * scale.z), local["position"])
            expected = transform(pose["joints"][skeleton.names[bone]])
            reach = 0.2 * height / expected.basis.y.length()
            for point in ((0, 0, 0), (reach, 0, 0), (0, reach, 0), (0, 0, reach)):
                far = (found * Vector3(*point) - expected * Vector3(*point)).length() / height
                worst = max(worst, far if far == far else math.inf)
            count += 1
    return {"joints": count, "worst": worst}
