# examples/godot/sinew_muscles.gd: moves the muscle joints of `sinew export --as helpers` in any pose. Godot 4.3 or later.
#
# A child of the character's Skeleton3D: Godot runs it after the animation, before drawing. Godot's import drops the
# extras of skins; the Importer below keeps them as the skeleton's metadata (README.md says how to register it). The
# formulas are those of docs/muscles.md, the numbers those of docs/export.md, "Line data". Tests run this text translated
# into Python, with stubs of Godot's types; it was not run in Godot itself.
@tool
class_name SinewMuscles
extends SkeletonModifier3D

@export_range(0.0, 1.0) var flex := 0.0  # Added to every line's activation.

class Importer extends GLTFDocumentExtension:
	func _import_post(state: GLTFState, root: Node) -> Error:
		var found := []
		for skin: Dictionary in state.json.get("skins", []):
			var extras: Variant = skin.get("extras")
			if extras is Dictionary and extras.has("sinew"):
				found.append(extras["sinew"])
		var nodes := state.get_nodes()
		for skeleton in root.find_children("*", "Skeleton3D", true, false):
			var bones := []
			for i in nodes.size():
				bones.append(nodes[i].resource_name if state.get_scene_node(i) == skeleton else "")
			skeleton.set_meta("sinew", {"data": found, "bones": bones})
		return OK

var _bones := PackedInt32Array()  # Of the skeleton, by the file's nodes; -1: not one of its bones.

func _process_modification() -> void:
	var skeleton := get_skeleton()
	if not skeleton or not skeleton.has_meta("sinew"):
		return
	var meta: Dictionary = skeleton.get_meta("sinew")
	if _bones.is_empty():
		for bone: String in meta["bones"]:
			_bones.append(skeleton.find_bone(bone))
	for data: Dictionary in meta["data"]:
		for line: Dictionary in data["lines"]:
			_pose(line, data["joint_scale"], skeleton)

func _bone(place: Dictionary) -> int:
	return _bones[int(place["node"])]

static func _v(list: Array, from := 0) -> Vector3:
	return Vector3(list[from], list[from + 1], list[from + 2])

# The line's bind frame as a bone carries it: the nearest rotation (Higham). Divided by the bone's growth beforehand.
static func _carried(frame: Basis, growth: float) -> Basis:
	var m := Basis(frame.x / growth, frame.y / growth, frame.z / growth)
	for i in 12:
		var square := m.inverse().transposed()
		m = Basis((m.x + square.x) / 2.0, (m.y + square.y) / 2.0, (m.z + square.z) / 2.0)
	return m

# Cube root of a volume, with its sign.
static func _root(volume: float) -> float:
	return signf(volume) * pow(absf(volume), 1.0 / 3.0)

# Belly stretch, its softened logarithm and activation at a stretch of the line.
static func _contraction(line: Dictionary, stretch: float, added: float) -> Dictionary:
	var share: float = 1.0 - line["tendons"][0] - line["tendons"][1]
	var belly := maxf(stretch - 1.0 + share, 0.1 * share) / share
	var x := log(belly)
	var most := -log(line["limits"][0]) if x < 0.0 else log(line["limits"][1])
	var s := clampf((1.0 - stretch) / (1.0 - line["full"]), 0.0, 1.0)
	return {"belly": belly, "soft": most * tanh(x / most), "share": share,
			"activation": clampf(line["base"] + added + line["gain"] * s * s * (3.0 - 2.0 * s), 0.0, 1.0)}

# What flexing adds to a girth, beside the bind pose.
static func _flexed(most: float, now: float, bind: float) -> float:
	return (1.0 + most * now) / (1.0 + most * bind)

# The height of a carried frame after the least turn that brings its direction onto the line.
static func _swung(m: Basis, direction: Vector3) -> Vector3:
	var opening := 1.0 + m.y.dot(direction)
	return m.z if opening < 1e-6 else m.z - (m.y + direction) * (m.z.dot(direction) / opening)

# Between the heights a and b around the direction, as their quaternions mix.
static func _mixed(a: Vector3, b: Vector3, direction: Vector3, share: float) -> Vector3:
	var beside := direction.cross(a)
	var half := 0.5 * atan2(beside.dot(b), a.dot(b))
	var c := 1.0 - share + share * cos(half)
	var s := share * sin(half)
	return (a * (c * c - s * s) + beside * (2.0 * c * s)) / (c * c + s * s)

# How far the middle of the belly lies beside the straight line.
static func _via_shift(origin: Vector3, direction: Vector3, via: Vector3, tendon: float, belly: float) -> Vector3:
	var there := via - origin
	var foot := there.dot(direction)
	var half := 0.5 * belly
	var y := minf(absf((foot - tendon - half) / half), 1.0)
	var t := (1.0 - y) / 0.4
	var fade := t * t * (10.0 - t * (15.0 - 6.0 * t))
	var factor := 1.0 / (1.0 - y * y) if y < 0.6 else 1.0 + fade * y * y / (0.4 * (1.0 + y))
	return ((there - direction * foot) * factor).limit_length(half)

# Where a line's joints are.
func _pose(line: Dictionary, joint_scale: String, skeleton: Skeleton3D) -> void:
	if _bone(line["origin"]) < 0 or _bone(line["insertion"]) < 0:
		return
	var from := skeleton.get_bone_global_pose(_bone(line["origin"]))
	var to := skeleton.get_bone_global_pose(_bone(line["insertion"]))
	var origin := from * _v(line["origin"]["point"])
	var insertion := to * _v(line["insertion"]["point"])
	var via := origin
	if line.has("via"):
		via = skeleton.get_bone_global_pose(_bone(line["via"])) * _v(line["via"]["point"])
	var frame: Array = line["origin"]["frame"]
	var by_origin := from.basis * Basis(_v(frame), _v(frame, 3), _v(frame, 6))
	frame = line["insertion"]["frame"]
	var by_insertion := to.basis * Basis(_v(frame), _v(frame, 3), _v(frame, 6))
	var growth := _root(by_origin.determinant())
	var other := _root(by_insertion.determinant())
	if growth == 0.0 or other == 0.0:
		return  # A bone flattened to nothing.
	by_origin = _carried(by_origin, growth)
	by_insertion = _carried(by_insertion, other)
	var along := insertion - origin
	var straight := along.length()
	var size := sqrt(absf(growth * other))
	var rest: float = line["rest"] * line["length"] * size
	var total := (via - origin).length() + (insertion - via).length()  # Without a via point, via is the origin.
	var bind := _contraction(line, 1.0 / line["rest"], 0.0)
	var now := _contraction(line, total / rest, flex)
	var y := along / straight if straight > 1e-6 * line["length"] else by_origin.y
	var z := _mixed(_swung(by_origin, y), _swung(by_insertion, y), y, line["twist"])
	var turn := Basis(y.cross(z), y, z)
	var girth: float = size * exp(-0.5 * line["volume"] * (now["soft"] - bind["soft"]))
	var belly: float = size * now["belly"] / bind["belly"]
	var width := girth * _flexed(line["flex"][1], now["activation"], bind["activation"])
	var height := girth * _flexed(line["flex"][0], now["activation"], bind["activation"])
	var m := Basis(turn.x * width, y * belly, z * height)
	var tendon: float = line["tendons"][0] * rest
	var start: Vector3 = origin + y * tendon - z * (size * line["depth"])
	if line.has("via"):
		start += _via_shift(origin, y, via, tendon, now["belly"] * now["share"] * rest)
		start -= turn * _v(line["via"]["shift"]) * size
	for joint: Dictionary in line["joints"]:
		if _bone(joint) >= 0:
			var grown: float = line["size"]
			var world := Transform3D(Basis(m.x * grown, m.y * grown, m.z * grown), start + m * _v(joint["at"]))
			_set_local(_bone(joint), world, joint_scale, skeleton)

# The same in its parent's space, as a joint can hold it. The second axis keeps its direction.
static func _set_local(bone: int, world: Transform3D, joint_scale: String, skeleton: Skeleton3D) -> void:
	var parent := skeleton.get_bone_parent(bone)
	var local := world if parent < 0 else skeleton.get_bone_global_pose(parent).affine_inverse() * world
	var m := local.basis
	var y := m.y.normalized()
	var z := m.x.cross(m.y).normalized()
	var even := sqrt(m.x.length() * m.z.length())
	var scales := {"full": Vector3(m.x.length(), m.y.length(), m.z.length()), "uniform": Vector3.ONE * even,
			"none": Vector3.ONE}
	skeleton.set_bone_pose_position(bone, local.origin)
	skeleton.set_bone_pose_rotation(bone, Basis(y.cross(z), y, z).get_rotation_quaternion())
	skeleton.set_bone_pose_scale(bone, scales[joint_scale])
