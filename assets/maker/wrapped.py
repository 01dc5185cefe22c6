# assets/maker/wrapped.py: a walking body of capsules with ellipsoids around its torso and limbs, as the paper's Fig. 6.
import math

from . import blocks, vec
from .clip import Clip
from .plain_glb import Scene, ellipsoid, rig_text

SHOULDER, ELBOW, WRIST, FINGERS = (0.20, 1.36, 0.0), (0.40, 1.24, 0.0), (0.60, 1.12, 0.0), (0.74, 1.036, 0.0)
HIP, KNEE, ANKLE, TOE = (0.115, 0.86, 0.0), (0.155, 0.49, 0.0), (0.170, 0.11, 0.0), (0.180, 0.06, 0.16)


def _both(rows):
    """Left rows, each followed by its mirror image."""
    out = []
    for name, parent, (x, y, z) in rows:
        out.append((name, parent, (x, y, z)))
        if name.endswith(".L"):
            above = parent[:-2] + ".R" if parent.endswith(".L") else parent
            out.append((name[:-2] + ".R", above, (-x, y, z)))
    return out


BONES = _both([
    ("pelvis", None, (0.0, 0.92, 0.0)), ("belly", "pelvis", (0.0, 1.08, 0.0)), ("chest", "belly", (0.0, 1.24, 0.0)),
    ("head", "chest", (0.0, 1.50, 0.0)),
    ("upper_arm.L", "chest", SHOULDER), ("forearm.L", "upper_arm.L", ELBOW), ("hand.L", "forearm.L", WRIST),
    ("thigh.L", "pelvis", HIP), ("shin.L", "thigh.L", KNEE), ("foot.L", "shin.L", ANKLE)])

_LEFT_CAPSULES = {
    "upper_arm": (SHOULDER, ELBOW, 0.056), "forearm": (ELBOW, WRIST, 0.048), "hand": (WRIST, FINGERS, 0.046),
    "thigh": (HIP, KNEE, 0.072), "shin": (KNEE, ANKLE, 0.058), "foot": (ANKLE, TOE, 0.052)}
_MIDDLE_CAPSULES = {
    "pelvis": ((-0.05, 0.92, 0.0), (0.05, 0.92, 0.0), 0.118), "belly": ((0.0, 1.00, 0.0), (0.0, 1.16, 0.0), 0.118),
    "chest": ((-0.075, 1.32, 0.0), (0.075, 1.32, 0.0), 0.112), "head": ((0.0, 1.57, 0.0), (0.0, 1.62, 0.02), 0.118)}


def _capsules():
    capsules = {bone: blocks.Capsule(*row) for bone, row in _MIDDLE_CAPSULES.items()}
    for bone, (a, b, radius) in _LEFT_CAPSULES.items():
        capsules[bone + ".L"] = blocks.Capsule(a, b, radius)
        capsules[bone + ".R"] = blocks.Capsule((-a[0], a[1], a[2]), (-b[0], b[1], b[2]), radius)
    return capsules


# The heap of boxes: 5 cells across the torso, of which the middle one parts the legs; arms grow out of the sides.
_X = [0.04, 0.12, 0.20, 0.30, 0.41, 0.52, 0.63, 0.75]  # planes right and left of the middle
_Y = [0.02, 0.10, 0.22, 0.36, 0.51, 0.68, 0.85, 0.98, 1.10, 1.22, 1.33, 1.42, 1.54, 1.70]
_LEG_TOP, _TORSO_TOP, _ARM_LOW, _HEAD_LOW = 6, 11, 9, 11  # rows of cells


def _cells():
    """(i, j, k): i = 0 the middle cell, +-1, +-2 beside it; arms from +-3 on; k = 0 behind, 1 in front, 2 the feet."""
    cells = set()
    for k in (0, 1):
        for i in (1, 2, -1, -2):
            cells |= {(i, j, k) for j in range(_LEG_TOP)}
        for i in range(-2, 3):
            cells |= {(i, j, k) for j in range(_LEG_TOP, _TORSO_TOP)}
        for i in range(3, 8):
            cells |= {(side * i, j, k) for j in (_ARM_LOW, _ARM_LOW + 1) for side in (1, -1)}
        for i in (-1, 0, 1):
            cells |= {(i, j, k) for j in range(_HEAD_LOW, len(_Y) - 1)}
    return cells | {(side * i, 0, 2) for i in (1, 2) for side in (1, -1)}


def _place(corner):
    """Corner i lies left of cell i (towards -x): planes 1.. are +x, 0.. are -x."""
    i, j, k = corner
    x = _X[i - 1] if i > 0 else -_X[-i]
    y, z = _Y[j], (k - 1) * 0.09
    if abs(x) > 0.21:  # the arm droops and is slimmer than the shoulder
        middle = SHOULDER[1] - 0.6 * (abs(x) - 0.2)
        y = middle + (j - _ARM_LOW - 1) * 0.06
        z = (k - 1) * 0.06
    return (x, y, z)


def _walk():
    keys = 24
    clip = Clip("Walk", 1.2, keys)
    wave = lambda phase, offset=0.0: math.sin(2.0 * math.pi * (phase + offset))  # noqa: E731
    for n in range(keys):
        phase = n / keys
        clip.key("pelvis", "translation", (0.0, 0.92 + 0.02 * wave(2.0 * phase), 0.0))
        clip.key("pelvis", "rotation", vec.euler(y=8.0 * wave(phase)))
        clip.key("belly", "rotation", vec.euler(x=4.0, y=-6.0 * wave(phase)))
        clip.key("chest", "rotation", vec.euler(x=3.0, y=-9.0 * wave(phase), z=3.0 * wave(phase)))
        clip.key("head", "rotation", vec.euler(x=-5.0, y=6.0 * wave(phase)))
        for side, sign, offset in ((".L", 1.0, 0.0), (".R", -1.0, 0.5)):
            swing = wave(phase, offset)
            bend = 0.5 - 0.5 * wave(phase, offset + 0.15)
            lowered = vec.turn((0, 0, 1), -32.0 * sign)
            clip.key("thigh" + side, "rotation", vec.euler(x=-30.0 * swing))
            clip.key("shin" + side, "rotation", vec.euler(x=8.0 + 44.0 * bend))
            clip.key("foot" + side, "rotation", vec.euler(x=-10.0 * bend))
            clip.key("upper_arm" + side, "rotation", vec.times(vec.turn((1, 0, 0), 32.0 * swing), lowered))
            clip.key("forearm" + side, "rotation", vec.turn((0, 1, 0), -sign * (28.0 + 18.0 * -swing)))
            clip.key("hand" + side, "rotation", vec.turn((0, 1, 0), -sign * 10.0))
    return clip.close()


def scene():
    capsules = _capsules()
    parts = list(capsules.values())
    distance = lambda p: blocks.blended_distance(parts, p, 0.012)  # noqa: E731
    positions, triangles = blocks.Blocks(_cells(), _place).mesh()
    positions = [blocks.drawn_onto(p, distance) for p in positions]
    positions = blocks.relaxed(positions, triangles, distance, 3)
    weights = []
    for p in positions:
        other = ".R" if p[0] > 0.0 else ".L"
        near = {bone: c for bone, c in capsules.items() if not bone.endswith(other)}
        weights.append(blocks.weights(p, near, 0.014))
    return Scene("wrapped", BONES, positions, blocks.normals(positions, triangles), triangles, weights, [_walk()],
                 [0.62, 0.50, 0.42])


def _limb(name, group, a, b, share, thick):
    """An ellipsoid about a limb from a to b: its long axis is `share` of the limb's length."""
    along = vec.sub(b, a)
    return (name, group, vec.mix(a, b, 0.5), vec.shortest_arc((0.0, 1.0, 0.0), along),
            (thick, share * vec.length(along), thick))


def rig():
    rows = [("pelvis", "torso", (0.0, 0.93, 0.0), vec.IDENTITY, (0.215, 0.125, 0.160)),
            ("belly", "torso", (0.0, 1.09, 0.005), vec.IDENTITY, (0.165, 0.165, 0.150)),
            ("chest", "torso", (0.0, 1.30, 0.0), vec.IDENTITY, (0.235, 0.165, 0.158))]
    primitives = [ellipsoid(name, name, *row, BONES) for name, *row in rows]
    left = [_limb("upper_arm", "arms", SHOULDER, ELBOW, 0.66, 0.083),
            _limb("forearm", "arms", ELBOW, WRIST, 0.64, 0.072),
            _limb("thigh", "legs", HIP, KNEE, 0.56, 0.098), _limb("shin", "legs", KNEE, ANKLE, 0.58, 0.084)]
    for name, group, (x, y, z), q, radii in left:
        flipped = (q[0], -q[1], -q[2], q[3])
        primitives.append(ellipsoid(name + " L", name + ".L", group, (x, y, z), q, radii, BONES))
        primitives.append(ellipsoid(name + " R", name + ".R", group, (-x, y, z), flipped, radii, BONES))
        primitives[-2]["mirror"], primitives[-1]["mirror"] = name + " R", name + " L"
    return rig_text("wrapped.glb", "replace", 3, ["torso", "arms", "legs"], [("torso", "arms"), ("torso", "legs")],
                    primitives)
