# blender/sinew_blender/line_joints.py: where the joints of a muscle line are in a pose. docs/muscles.md, docs/export.md.
"""Kept in the .blend file as a text that registers itself, so that a file with such drivers needs no add-on.

A record describes one joint. "line" is as in the export's line data, but in the spaces of Blender's bones; "parent"
takes the parent's node to its bone, "turn" a local rotation of the file to the bone's own, "axes" are the bone's axes in the
joint's, "rest" is the bone in its parent's rest. Matrices are 4 x 4, by rows; inside, 3 x 3 are lists of columns.
"""
import json
import math

LAST = {}  # Of each record: the matrices of the bones that it was posed by, and what came out.
REST = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0)
ROUNDS = 12  # Of the polar decomposition.


def add(a, b, t=1.0):
    return [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]


def scaled(a, t):
    return [a[0] * t, a[1] * t, a[2] * t]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return math.sqrt(dot(a, a))


def clamped(value):
    return min(max(value, 0.0), 1.0)


def times(columns, v):
    """columns: of a 3 x 3 matrix."""
    return add(add(scaled(columns[0], v[0]), columns[1], v[1]), columns[2], v[2])


def columns_of(matrix):
    """x, y, z and origin of a 4 x 4 matrix given by rows."""
    return [[matrix[row][column] for row in range(3)] for column in range(4)]


def placed(columns, point):
    return add(times(columns, point), columns[3])


def cofactors(m):
    """Transposed inverse times the volume."""
    return [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]


def undone(columns, v):
    """The inverse of a 3 x 3 matrix times v."""
    rows = cofactors(columns)
    volume = dot(columns[0], rows[0])
    return [dot(row, v) / volume for row in rows]


def carried(bone, frame):
    """The bind frame as a bone carries it: the nearest rotation (Higham 1986), and how much the bone has grown."""
    m = [times(bone, axis) for axis in frame]
    volume = dot(m[0], cross(m[1], m[2]))
    growth = math.copysign(abs(volume) ** (1.0 / 3.0), volume)
    m = [scaled(axis, 1.0 / growth) for axis in m]
    for _ in range(ROUNDS):
        square = cofactors(m)
        part = dot(m[0], square[0])
        m = [scaled(add(axis, other, 1.0 / part), 0.5) for axis, other in zip(m, square)]
    return m, abs(growth)


def contraction(line, stretch, flex):
    """Belly stretch, its softened logarithm, the belly's share of the line, activation."""
    share = 1.0 - line["tendons"][0] - line["tendons"][1]
    belly = max(stretch - 1.0 + share, 0.1 * share) / share
    x = math.log(belly)
    most = -math.log(line["limits"][0]) if x < 0 else math.log(line["limits"][1])
    s = clamped((1.0 - stretch) / (1.0 - line["full"]))
    active = clamped(line["base"] + flex + line["gain"] * s * s * (3.0 - 2.0 * s))
    return belly, most * math.tanh(x / most), share, active


def swung(frame, direction):
    """The height of a carried frame after the least turn that brings its direction onto the line."""
    _, y, z = frame
    opening = 1.0 + dot(y, direction)
    return z if opening < 1e-6 else add(z, add(y, direction), -dot(z, direction) / opening)


def mixed(a, b, direction, share):
    """Between two heights around the direction, as their quaternions mix."""
    beside = cross(direction, a)
    half = 0.5 * math.atan2(dot(beside, b), dot(a, b))
    c, s = 1.0 - share + share * math.cos(half), share * math.sin(half)
    return scaled(add(scaled(a, c * c - s * s), beside, 2.0 * c * s), 1.0 / (c * c + s * s))


def via_shift(origin, direction, via, tendon, belly):
    """How far the middle of the belly lies beside the straight line."""
    there, half = add(via, origin, -1.0), 0.5 * belly
    foot = dot(there, direction)
    y = min(abs((foot - tendon - half) / half), 1.0)
    t = (1.0 - y) / 0.4
    fade = t * t * (10.0 - t * (15.0 - 6.0 * t))
    factor = 1.0 / (1.0 - y * y) if y < 0.6 else 1.0 + fade * y * y / (0.4 * (1.0 + y))
    shift = scaled(add(there, direction, -foot), factor)
    far = length(shift)
    return scaled(shift, half / far) if far > half else shift


def joint_at(line, bones, flex):
    """[x, y, z, origin] of the joint's node. bones: columns of those of origin, insertion and via."""
    start, end = placed(bones[0], line["origin"]["point"]), placed(bones[1], line["insertion"]["point"])
    via = placed(bones[2], line["via"]["point"]) if line["via"] else None
    one, grown = carried(bones[0], line["origin"]["frame"])
    other, too = carried(bones[1], line["insertion"]["frame"])
    along = add(end, start, -1.0)
    straight, size = length(along), math.sqrt(grown * too)
    rest = line["rest"] * line["length"] * size
    total = length(add(via, start, -1.0)) + length(add(end, via, -1.0)) if via else straight
    (belly0, soft0, _, active0), (belly, soft, share, active) = (
        contraction(line, 1.0 / line["rest"], 0.0), contraction(line, total / rest, flex))
    y = scaled(along, 1.0 / straight) if straight > 1e-6 * line["length"] * size else one[1]
    z = mixed(swung(one, y), swung(other, y), y, line["twist"])
    turn = [cross(y, z), y, z]
    girth = size * math.exp(-0.5 * line["volume"] * (soft - soft0))
    height, width = (girth * (1.0 + by * active) / (1.0 + by * active0) for by in line["flex"])
    m = [scaled(axis, by) for axis, by in zip(turn, (width, size * belly / belly0, height))]
    tendon = line["tendons"][0] * rest
    where = add(add(start, y, tendon), z, -size * line["depth"])
    if via:
        where = add(where, via_shift(start, y, via, tendon, belly * share * rest))
        where = add(where, times(turn, line["via"]["shift"]), -size)
    return [scaled(axis, line["size"]) for axis in m] + [add(where, times(m, line["at"]))]


def local_of(record, parent, joint):
    """Location, rotation w x y z, scale of the bone. parent: columns of its matrix. The second axis keeps its way."""
    above = [times(parent, axis) for axis in columns_of(record["parent"])[:3]]
    m = [undone(above, axis) for axis in joint[:3]]
    up = cross(m[0], m[1])
    y, z = scaled(m[1], 1.0 / length(m[1])), scaled(up, 1.0 / length(up))
    width, belly, height = map(length, m)
    even = math.sqrt(width * height)
    sizes = {"full": (width, belly, height), "uniform": (even, even, even), "none": (1.0, 1.0, 1.0)}
    sizes = sizes[record["joint_scale"]]
    own = [times(columns_of(record["turn"])[:3], axis) for axis in (cross(y, z), y, z)]
    axes = columns_of(record["axes"])[:3]  # Each the direction of an axis of the bone.
    scales = [sum(abs(part) * size for part, size in zip(axis, sizes)) for axis in axes]
    rest = columns_of(record["rest"])
    base = [times(parent, axis) for axis in rest[:3]]
    location = undone(base, add(joint[3], placed(parent, rest[3]), -1.0))
    return (*location, *quaternion([times(own, axis) for axis in axes]), *scales)


def quaternion(columns):
    """w, x, y, z of a rotation: the largest of the four is found by a root, the others by it."""
    (a, d, g), (b, e, h), (c, f, i) = columns
    squares = (1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i)
    which = squares.index(max(squares))
    s = 2.0 * math.sqrt(squares[which])
    four = ((0.25 * s, (h - f) / s, (c - g) / s, (d - b) / s), ((h - f) / s, 0.25 * s, (b + d) / s, (c + g) / s),
            ((c - g) / s, (b + d) / s, 0.25 * s, (f + h) / s), ((d - b) / s, (c + g) / s, (f + h) / s, 0.25 * s))[which]
    return four if four[0] >= 0 else tuple(-part for part in four)


def driven(bone, channel, flex):
    """What drivers call: location 0 to 2, rotation 3 to 6, scale 7 to 9 of a pose bone that has a record."""
    text = bone["sinew_line"]
    posed = bone.id_data.pose.bones
    last = LAST.get(text)
    record = last[0] if last else json.loads(text)
    matrices = tuple(tuple(map(tuple, posed[name].matrix)) for name in record["bones"])
    if last is None or last[1] != (matrices, flex):
        columns = [columns_of(matrix) for matrix in matrices]
        try:
            found = local_of(record, columns[-1], joint_at(record["line"], columns[:-1], flex))
        except (ZeroDivisionError, ValueError, OverflowError):  # A bone flattened to nothing.
            found = REST
        last = LAST[text] = (record, (matrices, flex), found)
    return last[2][channel]
