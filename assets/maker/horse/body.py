# assets/maker/horse/body.py: a horse of 412 triangles: the left half of trunk, legs and tail; head.py adds neck and head.
from ..cage import Cage
from . import head

# Half rings across the trunk, from the back's middle over the side: place, weights.
BREAST = [  # neck's base and breast; the last four close the front
    ((0.0, 1.655, 0.480), {"chest": 0.55, "neck.1": 0.45}),
    ((0.105, 1.440, 0.590), {"chest": 0.35, "neck.1": 0.35, "scapula.L": 0.3}),
    ((0.190, 1.125, 0.690), {"chest": 0.2, "scapula.L": 0.4, "upper_arm.L": 0.4}),
    ((0.160, 0.955, 0.590), {"chest": 0.25, "upper_arm.L": 0.5, "forearm.L": 0.25}),
    ((0.0, 0.920, 0.570), {"chest": 0.9, "upper_arm.L": 0.05, "upper_arm.R": 0.05}),
]
BREASTBONE = ((0.0, 1.190, 0.765), {"chest": 0.8, "neck.1": 0.2})
WITHERS = [
    ((0.0, 1.605, 0.270), {"chest": 1.0}),
    ((0.140, 1.440, 0.300), {"chest": 0.6, "scapula.L": 0.4}),
    ((0.222, 1.170, 0.450), {"chest": 0.25, "scapula.L": 0.35, "upper_arm.L": 0.4}),
    ((0.216, 0.960, 0.440), {"chest": 0.15, "upper_arm.L": 0.5, "forearm.L": 0.35}),
]
GIRTH = [
    ((0.0, 1.534, 0.020), {"spine.2": 0.5, "chest": 0.5}),
    ((0.178, 1.410, 0.040), {"spine.2": 0.5, "chest": 0.5}),
    ((0.272, 1.160, 0.080), {"spine.2": 0.4, "chest": 0.6}),
    ((0.200, 0.920, 0.250), {"chest": 0.6, "upper_arm.L": 0.4}),
    ((0.0, 0.842, 0.150), {"spine.2": 0.1, "chest": 0.9}),
]
FLANK = [
    ((0.0, 1.532, -0.330), {"hips": 0.3, "spine.1": 0.6, "spine.2": 0.1}),
    ((0.185, 1.432, -0.330), {"hips": 0.3, "spine.1": 0.6, "spine.2": 0.1}),
    ((0.275, 1.170, -0.250), {"hips": 0.1, "spine.1": 0.47, "spine.2": 0.26, "thigh.L": 0.17}),
    ((0.196, 0.990, -0.370), {"hips": 0.2, "spine.1": 0.25, "thigh.L": 0.45, "shin.L": 0.1}),
    ((0.0, 0.950, -0.390), {"hips": 0.45, "spine.1": 0.45, "thigh.L": 0.05, "thigh.R": 0.05}),
]
CROUP = [
    ((0.0, 1.580, -0.560), {"hips": 1.0}),
    ((0.188, 1.462, -0.530), {"hips": 0.9, "thigh.L": 0.1}),
    ((0.262, 1.200, -0.600), {"hips": 0.35, "thigh.L": 0.65}),
    ((0.228, 0.990, -0.600), {"hips": 0.08, "thigh.L": 0.62, "shin.L": 0.3}),
]
BUTTOCK = [
    ((0.0, 1.515, -0.820), {"tail.1": 1.0}),
    ((0.060, 1.440, -0.870), {"tail.1": 1.0}),
    ((0.168, 1.260, -0.895), {"hips": 0.55, "thigh.L": 0.45}),
    ((0.168, 1.010, -0.830), {"hips": 0.15, "thigh.L": 0.6, "shin.L": 0.25}),
    ((0.0, 1.000, -0.760), {"hips": 0.7, "thigh.L": 0.15, "thigh.R": 0.15}),
]
UNDER_TAIL = ((0.0, 1.360, -0.880), {"tail.1": 1.0})

# Rings about a leg: front (y, z), outer and inner (y, z), back (y, z), middle x, half width, weights.
FORELEG = [
    ((0.800, 0.555), (0.790, 0.455), (0.800, 0.340), 0.152, 0.066, {"upper_arm.L": 0.08, "forearm.L": 0.92}),
    ((0.505, 0.507), (0.490, 0.450), (0.490, 0.392), 0.138, 0.046, {"forearm.L": 0.5, "cannon_front.L": 0.5}),
    ((0.400, 0.483), (0.400, 0.448), (0.400, 0.403), 0.135, 0.029, {"cannon_front.L": 1.0}),
    ((0.235, 0.492), (0.225, 0.450), (0.205, 0.393), 0.132, 0.035, {"cannon_front.L": 0.5, "pastern_front.L": 0.5}),
    ((0.118, 0.585), (0.100, 0.530), (0.080, 0.452), 0.132, 0.054, {"pastern_front.L": 0.4, "hoof_front.L": 0.6}),
    ((0.000, 0.650), (0.000, 0.555), (0.000, 0.455), 0.132, 0.070, {"hoof_front.L": 1.0}),
]
HIND_LEG = [
    ((0.850, -0.430), (0.840, -0.570), (0.840, -0.735), 0.158, 0.066, {"thigh.L": 0.14, "shin.L": 0.86}),
    ((0.690, -0.650), (0.700, -0.705), (0.735, -0.780), 0.142, 0.036, {"shin.L": 1.0}),
    ((0.575, -0.705), (0.580, -0.765), (0.640, -0.875), 0.140, 0.046, {"shin.L": 0.5, "cannon_hind.L": 0.5}),
    ((0.460, -0.725), (0.460, -0.765), (0.470, -0.818), 0.138, 0.030, {"cannon_hind.L": 1.0}),
    ((0.250, -0.705), (0.240, -0.748), (0.220, -0.805), 0.135, 0.036, {"cannon_hind.L": 0.5, "pastern_hind.L": 0.5}),
    ((0.118, -0.608), (0.100, -0.665), (0.082, -0.745), 0.135, 0.052, {"pastern_hind.L": 0.4, "hoof_hind.L": 0.6}),
    ((0.000, -0.545), (0.000, -0.640), (0.000, -0.742), 0.135, 0.066, {"hoof_hind.L": 1.0}),
]

TAIL = [  # back (y, z), side (x, y, z), front (y, z), weights
    ((1.260, -1.015), (0.045, 1.250, -0.970), (1.240, -0.945), {"tail.1": 0.45, "tail.2": 0.55}),
    ((0.960, -1.090), (0.082, 0.950, -1.010), (0.950, -0.935), {"tail.3": 0.65, "tail.4": 0.35}),
    ((0.560, -1.045), (0.028, 0.550, -1.005), (0.545, -0.970), {"tail.4": 1.0}),
]


HOLLOW_OF_THE_STIFLE = {"thigh.L": 0.30, "shin.L": 0.70}  # skin that folds when the leg is drawn up


def build():
    cage = Cage()
    rings = [[cage.vertex(*row) for row in ring] for ring in (BREAST, WITHERS, GIRTH, FLANK, CROUP, BUTTOCK)]
    _trunk(cage, *rings)
    breast, withers, girth, flank, croup, buttock = rings
    _leg(cage, [breast[3], withers[3], girth[3], girth[4], breast[4]], FORELEG, "foreleg", "front hoof")
    _leg(cage, [flank[3], croup[3], buttock[3], buttock[4], flank[4]], HIND_LEG, "hind leg", "hind hoof",
         HOLLOW_OF_THE_STIFLE)
    breastbone = cage.vertex(*BREASTBONE)
    cage.single([breastbone, breast[4], breast[3], breast[2]], "trunk", 34)
    head.build(cage, [breast[0], breast[1], breast[2], breastbone])
    return cage


def _trunk(cage, breast, withers, girth, flank, croup, buttock):
    """The sides between the rings; the legs' roots stay open, between the lowest points."""
    for near, far in ((breast, withers), (withers, girth), (girth, flank), (flank, croup), (croup, buttock)):
        count = min(len(near), len(far))
        if (near, far) != (girth, flank):
            count = 4
        cage.tube([near[:count], far[:count]], "trunk", closed=False, pixels=46)
    under = cage.vertex(*UNDER_TAIL)
    cage.single([under, buttock[1], buttock[2]], "trunk", 30)
    cage.single([under, buttock[2], buttock[3], buttock[4]], "trunk", 34)
    _tail(cage, [buttock[0], buttock[1], under])


def _tail(cage, root):
    rings = [root]
    for (by, bz), side, (fy, fz), weights in TAIL:
        rings.append(cage.ring([(0.0, by, bz), side, (0.0, fy, fz)], weights))
    cage.tube(rings, "tail", closed=False, pixels=40)
    cage.single(rings[-1], "tail", 12)


def _leg(cage, root, rows, part, hoof, hollow=None):
    """Root: front, outer, back, back middle, front middle. Rings: front, inner, back, outer."""
    rings = []
    for (fy, fz), (sy, sz), (by, bz), x, half, weights in rows:
        rings.append(cage.ring([(x, fy, fz), (x - half, sy, sz), (x, by, bz), (x + half, sy, sz)], weights))
    front, outer, back, back_middle, front_middle = root
    top_front, top_inner, top_back, top_outer = rings[0]
    if hollow:
        cage.weights[top_back] = hollow
    cage.tube([[back, outer, front], [top_back, top_outer, top_front]], part, closed=False, pixels=40)
    cage.single([back_middle, back, top_back, top_inner], part, 30)
    cage.single([front, front_middle, top_inner, top_front], part, 30)
    cage.single([front_middle, back_middle, top_inner], part, 24)
    cage.tube(rings[:-1], part, closed=True, pixels=30)
    cage.tube(rings[-2:], hoof, closed=True, pixels=26)
    cage.cap(rings[-1], hoof, 12)
