# tests/gui/rigs.py: what two saved rigs have in common and how they differ, in numbers.
import math

PARTS = ("center", "rotation", "radii")


def only_primitive(rig):
    """The one muscle of a rig."""
    assert len(rig["primitives"]) == 1, rig["primitives"]
    return rig["primitives"][0]


def changed_parts(before, after):
    """Which of a muscle's parts differ at all: PARTS, or any other key by its name."""
    return {key for key in set(before) | set(after) if before.get(key) != after.get(key)}


def changed_axes(before, after, tolerance):
    """Of two vectors: the axes on which they differ by more than a tolerance."""
    return {i for i in range(len(before)) if abs(before[i] - after[i]) > tolerance}


def product(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz]


def turn_between(before, after):
    """(unit axis, degrees) of the turn that leads from one rotation to the other, in the space both are given in."""
    x, y, z, w = product(after, [-before[0], -before[1], -before[2], before[3]])
    length = math.sqrt(x * x + y * y + z * z)
    if length < 1e-9:
        return (0.0, 0.0, 0.0), 0.0
    return (x / length, y / length, z / length), math.degrees(2.0 * math.atan2(length, w))


def turned(rotation, vector):
    x, y, z, _ = product(product(rotation, [*vector, 0.0]), [-rotation[0], -rotation[1], -rotation[2], rotation[3]])
    return [x, y, z]


def pole(primitive, axis, sign):
    """The end of an ellipsoid's semi-axis, bone space."""
    unit = [0.0, 0.0, 0.0]
    unit[axis] = sign * primitive["radii"][axis]
    return [c + d for c, d in zip(primitive["center"], turned(primitive["rotation"], unit))]
