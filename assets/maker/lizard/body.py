# assets/maker/lizard/body.py: a small upright lizard, built from rings of vertices, left half only.
import math

from .. import vec
from ..cage import Cage
from .skeleton import ARM, along_arm

HEAD_PIVOT, HEAD_SCALE = (0.0, 1.310, 0.0), 1.12
TAIL = [  # y, z, half width, half height, weights
    (0.712, -0.215, 0.084, 0.080, {"hips": 0.2, "tail.1": 0.8}),
    (0.652, -0.312, 0.068, 0.066, {"tail.1": 0.55, "tail.2": 0.45}),
    (0.597, -0.440, 0.055, 0.053, {"tail.2": 0.6, "tail.3": 0.4}),
    (0.566, -0.575, 0.042, 0.041, {"tail.3": 0.65, "tail.4": 0.35}),
    (0.578, -0.705, 0.029, 0.029, {"tail.3": 0.1, "tail.4": 0.9}),
    (0.622, -0.805, 0.016, 0.017, {"tail.4": 1.0}),
]
TAIL_ROOT, TAIL_TIP = (0.745, -0.124), (0.646, -0.840)  # y, z

def build():
    cage = Cage()
    torso = _torso(cage)
    _tail(cage, torso)
    _leg(cage, torso)
    _arm(cage, torso)
    _head(cage, torso)
    return cage


def _half_ring(y, width, front, back, square=1.0):
    """Five points from the front middle over the left side to the back middle; `square` > 1 fills the corners."""
    points = []
    for degrees in (0.0, 45.0, 90.0, 135.0, 180.0):
        s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        corner = square if degrees in (45.0, 135.0) else 1.0
        middle = (front + back) / 2.0
        x = 0.0 if degrees in (0.0, 180.0) else width * s * corner
        points.append((x, y, middle + (front - back) / 2.0 * c * corner))
    return points


def _torso(cage):
    levels = [  # y, width, front, back, corners, weights
        (0.690, 0.160, 0.098, -0.118, 1.02, {"hips": 1.0}),
        (0.800, 0.168, 0.122, -0.130, 1.04, {"hips": 0.85, "spine": 0.15}),
        (0.925, 0.138, 0.122, -0.098, 1.04, {"hips": 0.25, "spine": 0.75}),
        (1.045, 0.158, 0.122, -0.112, 1.08, {"spine": 0.35, "chest": 0.65}),
        (1.165, 0.150, 0.098, -0.118, 1.08, {"chest": 1.0}),
        (1.235, 0.084, 0.062, -0.086, 1.02, {"chest": 0.6, "neck": 0.4}),
        (1.300, 0.078, 0.066, -0.080, 1.02, {"neck": 0.55, "head": 0.45}),
    ]
    rings = [cage.ring(_half_ring(y, w, f, b, c), weights) for y, w, f, b, c, weights in levels]
    for row in (3, 4):  # the arm's root follows the shoulder
        for column in (1, 2, 3):
            share = {1: 0.3, 2: 0.55, 3: 0.3}[column]
            kept = {bone: w * (1.0 - share) for bone, w in cage.weights[rings[row][column]].items()}
            cage.weights[rings[row][column]] = {**kept, "shoulder.L": share * 0.55, "upper_arm.L": share * 0.45}
    for column, share in ((1, 0.4), (2, 0.5), (3, 0.4)):  # the leg's root follows the thigh
        cage.weights[rings[0][column]] = {"hips": 1.0 - share, "thigh.L": share}
    cage.weights[rings[1][2]] = {"hips": 0.7, "spine": 0.1, "thigh.L": 0.2}
    cage.tube(rings, "body", closed=False, holes={(3, 0), (1, 3), (2, 3)}, pixels=28)
    return rings


def _tail(cage, torso):
    root = [torso[1][4], torso[1][3], torso[0][3], torso[0][4]]  # top, two on the side, bottom
    centres = [(0.0, s[0], s[1]) for s in TAIL] + [(0.0, *TAIL_TIP)]
    rings = [root]
    for k, (y, z, w, h, weights) in enumerate(TAIL):
        before = centres[k - 1] if k else (0.0, *TAIL_ROOT)
        along = vec.unit(vec.sub(centres[k + 1], before))
        up = vec.unit(vec.cross(along, (-1.0, 0.0, 0.0)))
        points = [vec.add(centres[k], vec.add(vec.scale(up, h * math.cos(a)), (w * math.sin(a), 0.0, 0.0)))
                  for a in (0.0, math.pi / 3.0, 2.0 * math.pi / 3.0)]
        points.append(vec.sub(centres[k], vec.scale(up, h)))
        rings.append(cage.ring(points, weights))
    cage.tube(rings, "tail", closed=False, pixels=22)
    tip = cage.vertex(centres[-1], {"tail.4": 1.0})
    for i in range(3):
        cage.single([rings[-1][i], rings[-1][i + 1], tip], "tail", pixels=8)


def _around(centre, hx, hz, y, turn=0.0):
    """Six points in a level plane: inner front, outer front, outer, outer back, inner back, inner."""
    return [(centre[0] + hx * math.sin(math.radians(a + turn)), y, centre[1] + hz * math.cos(math.radians(a + turn)))
            for a in (-30.0, 30.0, 90.0, 150.0, 210.0, 270.0)]


def _leg(cage, torso):
    fork = {"hips": 0.6, "thigh.L": 0.4}
    inner = cage.ring([(0.034, 0.662, 0.060), (0.034, 0.662, -0.062), (0.026, 0.655, 0.0)], fork)
    middle = cage.vertex((0.0, 0.676, -0.002), {"hips": 1.0})
    low = torso[0]
    cage.single([low[0], middle, inner[2], inner[0]], "crotch", 14)
    cage.single([middle, low[4], inner[1], inner[2]], "crotch", 14)
    cage.single([low[0], inner[0], low[1]], "crotch", 14)
    cage.single([low[3], inner[1], low[4]], "crotch", 14)
    root = [inner[0], low[1], low[2], low[3], inner[1], inner[2]]
    levels = [  # y, (x, z), half width, half depth, weights
        (0.575, (0.106, 0.004), 0.082, 0.097, {"hips": 0.12, "thigh.L": 0.88}),
        (0.475, (0.109, 0.012), 0.066, 0.076, {"thigh.L": 0.97, "shin.L": 0.03}),
        (0.405, (0.112, 0.022), 0.054, 0.060, {"thigh.L": 0.66, "shin.L": 0.34}),
        (0.350, (0.113, 0.016), 0.051, 0.056, {"thigh.L": 0.28, "shin.L": 0.72}),
        (0.262, (0.115, -0.006), 0.053, 0.062, {"shin.L": 1.0}),
        (0.140, (0.119, -0.022), 0.037, 0.041, {"shin.L": 0.85, "foot.L": 0.15}),
        (0.080, (0.121, -0.020), 0.044, 0.050, {"shin.L": 0.3, "foot.L": 0.7}),
        (0.000, (0.123, -0.014), 0.050, 0.062, {"foot.L": 1.0}),
    ]
    rings = [root] + [cage.ring(_around(c, hx, hz, y, 4.0), weights) for y, c, hx, hz, weights in levels]
    rings = [ring[::-1] for ring in rings]  # downwards the outside turns the other way
    last = len(rings) - 2
    cage.tube(rings, "leg", closed=True, holes={(4, last)}, pixels=20)
    cage.cap(rings[-1], "sole", 12)
    # The foot grows out of the front quad of the lowest segment.
    foot = [rings[-2][4], rings[-2][5], rings[-1][5], rings[-1][4]]  # outer top, inner top, inner low, outer low
    toes = [foot]
    for z, inside, outside, top in ((0.070, 0.070, 0.186, 0.066), (0.130, 0.064, 0.202, 0.050),
                                    (0.172, 0.090, 0.184, 0.026)):
        low_y = 0.0 if z < 0.15 else 0.006
        outline = [(outside, top, z), (inside, top, z + 0.008), (inside, low_y, z + 0.008), (outside, low_y, z)]
        toes.append(cage.ring(outline, {"foot.L": 1.0}))
    cage.tube(toes, "foot", closed=True, pixels=26)
    cage.cap(toes[-1], "foot", 26)


def _arm(cage, torso):
    low, high = torso[3], torso[4]
    # Front low, front high, top, back high, back low, bottom.
    root = [low[1], high[1], high[2], high[3], low[3], low[2]]
    up = (-ARM[1], ARM[0], 0.0)
    levels = [  # metres from the shoulder, half height, half depth, weights
        (0.050, 0.061, 0.064, {"chest": 0.06, "shoulder.L": 0.18, "upper_arm.L": 0.76}),
        (0.125, 0.049, 0.052, {"upper_arm.L": 1.0}),
        (0.205, 0.039, 0.041, {"upper_arm.L": 0.72, "forearm.L": 0.28}),
        (0.262, 0.038, 0.040, {"upper_arm.L": 0.26, "forearm.L": 0.74}),
        (0.325, 0.040, 0.043, {"forearm.L": 1.0}),
        (0.425, 0.027, 0.031, {"forearm.L": 0.75, "hand.L": 0.25}),
        (0.470, 0.026, 0.041, {"forearm.L": 0.2, "hand.L": 0.8}),
        (0.530, 0.028, 0.054, {"hand.L": 1.0}),
        (0.585, 0.023, 0.046, {"hand.L": 1.0}),
        (0.612, 0.011, 0.024, {"hand.L": 1.0}),
    ]
    rings = [root]
    for t, hu, hv, weights in levels:
        centre = along_arm(t)
        points = []
        for degrees in (-30.0, 30.0, 90.0, 150.0, 210.0, 270.0):
            s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
            points.append(vec.add(centre, vec.add(vec.scale(up, hu * s), (0.0, 0.0, hv * c))))
        rings.append(cage.ring(points, weights))
    rings = [ring[::-1] for ring in rings]
    cage.tube(rings, "arm", closed=True, holes={(4, 7)}, pixels=20)
    cage.cap(rings[-1], "arm", 12)
    # The thumb grows out of the front quad of the palm.
    wrist, palm = rings[7], rings[8]
    thumb = [[wrist[4], wrist[5], palm[5], palm[4]]]
    for t, z, half, size in ((0.515, 0.078, 0.017, 0.019), (0.545, 0.102, 0.010, 0.012)):
        centre = vec.add(along_arm(t), (0.0, 0.0, z))
        points = [vec.add(centre, vec.add(vec.scale(up, half * a), vec.scale(ARM, size * b)))
                  for a, b in ((1, -1), (-1, -1), (-1, 1), (1, 1))]
        thumb.append(cage.ring(points, {"hand.L": 1.0}))
    cage.tube(thumb, "arm", closed=True, pixels=14)
    cage.cap(thumb[-1], "arm", 12)


def enlarged(p, factor=HEAD_SCALE):
    """The head is modelled small and then grown about the neck's top."""
    return vec.add(HEAD_PIVOT, vec.scale(vec.sub(p, HEAD_PIVOT), factor))


def _head(cage, torso):
    first = len(cage.positions)
    _head_as_modelled(cage, torso)
    for v in range(first, len(cage.positions)):
        cage.positions[v] = enlarged(cage.positions[v])


def _head_as_modelled(cage, torso):
    only = {"head": 1.0}
    levels = [  # y, width, front, back, corners, weights
        (1.340, 0.125, 0.125, -0.098, 1.04, {"neck": 0.15, "head": 0.85}),
        (1.432, 0.158, 0.150, -0.138, 1.04, only),
        (1.535, 0.146, 0.132, -0.142, 1.03, only),
        (1.612, 0.092, 0.066, -0.102, 1.00, only),
    ]
    rings = [torso[-1]] + [cage.ring(_half_ring(y, w, f, b, c), weights) for y, w, f, b, c, weights in levels]
    cage.tube(rings, "head", closed=False, holes={(0, 1), (0, 2)}, pixels=38)
    top = cage.vertex((0.0, 1.640, -0.022), only)
    crown = rings[-1]
    chart = cage.chart("head", 2, 1, 32)
    cage.face([crown[0], crown[1], crown[2], top], chart, 0, 0)
    cage.face([top, crown[2], crown[3], crown[4]], chart, 1, 0)
    _snout(cage, rings[1][0], rings[1][1], rings[2][1], rings[2][0])
    _eye(cage, rings[2][0], rings[2][1], rings[3][1], rings[3][0])


def _snout(cage, *root):
    """Root: low middle, low side, top side, top middle."""
    rings = [list(root)]
    for z, half, top, low in ((0.205, 0.098, 1.424, 1.346), (0.268, 0.080, 1.418, 1.350), (0.305, 0.048, 1.404, 1.362)):
        points = [(0.0, low - 0.004, z), (half, low + 0.008, z - 0.010), (half, top - 0.008, z - 0.006),
                  (0.0, top + 0.006, z + 0.012)]
        rings.append(cage.ring(points, {"head": 1.0}))
    cage.tube(rings, "snout", closed=False, pixels=50)
    cage.single(rings[-1], "snout", 44)


def _eye(cage, low_middle, low_side, high_side, high_middle):
    """A dome on the quad above the snout."""
    facing = vec.unit((0.42, 0.16, 0.90))
    right = vec.unit(vec.cross((0.0, 1.0, 0.0), facing))
    up = vec.cross(facing, right)
    rings = [[low_middle, low_side, high_side, high_middle]]
    for out, half in ((0.010, 0.043), (0.034, 0.034)):
        centre = vec.add((0.070, 1.500, 0.120), vec.scale(facing, out))
        points = [vec.add(centre, vec.add(vec.scale(right, half * a), vec.scale(up, half * b)))
                  for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        rings.append(cage.ring(points, {"head": 1.0}))
    cage.tube(rings[:2], "head", closed=True, pixels=22)
    cage.tube(rings[1:], "eye", closed=True, pixels=26)
    cage.cap(rings[-1], "eye", 44)
