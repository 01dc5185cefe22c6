# assets/maker/horse/head.py: the horse's neck and head, left half.
from .. import vec

# Half rings about the neck, from the crest over the side to the throat: place, weights.
NECK = [
    [((0.0, 1.815, 0.650), {"neck.1": 0.35, "neck.2": 0.65}), ((0.070, 1.680, 0.715), {"neck.1": 0.35, "neck.2": 0.65}),
     ((0.108, 1.450, 0.800), {"neck.1": 0.6, "neck.2": 0.4}), ((0.0, 1.380, 0.860), {"neck.1": 0.6, "neck.2": 0.4})],
    [((0.0, 1.955, 0.810), {"neck.2": 0.3, "neck.3": 0.7}), ((0.054, 1.860, 0.860), {"neck.2": 0.3, "neck.3": 0.7}),
     ((0.078, 1.660, 0.930), {"neck.2": 0.35, "neck.3": 0.65}), ((0.0, 1.585, 0.975), {"neck.2": 0.4, "neck.3": 0.6})],
    [((0.0, 2.030, 0.985), {"neck.3": 0.35, "head": 0.65}), ((0.056, 1.990, 0.985), {"neck.3": 0.35, "head": 0.65}),
     ((0.066, 1.808, 0.985), {"neck.3": 0.55, "head": 0.45}), ((0.0, 1.735, 1.010), {"neck.3": 0.6, "head": 0.4})],
]

POLL = (0.0, 2.000, 1.025)
DOWN_FACE = (0.0, -0.743, 0.669)   # from the poll to the nose
OFF_FACE = (0.0, 0.669, 0.743)     # out of the forehead

# x, metres down the face, metres off it.
FOREHEAD, BROW, CHEEK, JAW, JAW_MIDDLE = ((0.0, 0.150, 0.045), (0.094, 0.170, 0.005), (0.088, 0.250, -0.085),
                                          (0.060, 0.212, -0.208), (0.0, 0.245, -0.205))
BRIDGE, BRIDGE_SIDE, LIP_SIDE, CHIN_GROOVE = ((0.0, 0.400, 0.012), (0.044, 0.410, -0.010), (0.046, 0.420, -0.115),
                                              (0.0, 0.425, -0.128))
NOSE, NOSTRIL, MOUTH, CHIN = (0.0, 0.610, -0.012), (0.056, 0.590, -0.030), (0.046, 0.580, -0.110), (0.0, 0.592, -0.142)
EAR_INNER, EAR_OUTER, EAR_TIP = (0.022, 0.050, 0.032), (0.074, 0.055, 0.012), (0.062, -0.130, 0.075)


def at(x, down, off):
    """A point of the head in the bind pose."""
    return vec.add((x, POLL[1], POLL[2]), vec.add(vec.scale(DOWN_FACE, down), vec.scale(OFF_FACE, off)))


def build(cage, root):
    """Root: crest, side, point of the shoulder, breastbone."""
    rings = [root] + [[cage.vertex(*row) for row in ring] for ring in NECK]
    cage.tube(rings[::-1], "neck", closed=False, pixels=44)
    only = {"head": 1.0}
    poll, side, jowl, throat = rings[-1]
    forehead, brow, cheek, jaw, jaw_middle = cage.ring([at(*p) for p in (FOREHEAD, BROW, CHEEK, JAW, JAW_MIDDLE)], only)
    bridge = cage.ring([at(*p) for p in (BRIDGE, BRIDGE_SIDE, LIP_SIDE, CHIN_GROOVE)], only)
    muzzle = cage.ring([at(*p) for p in (NOSE, NOSTRIL, MOUTH, CHIN)], only)
    _ear(cage, poll, side, brow, forehead)
    cage.single([brow, cheek, jowl, side], "head", 60)
    cage.single([cheek, jaw, jowl], "head", 50)
    cage.single([jaw, jaw_middle, throat, jowl], "head", 36)
    cage.single([bridge[0], bridge[1], brow, forehead], "head", 64)
    cage.single([bridge[1], cheek, brow], "head", 60)
    cage.single([bridge[1], bridge[2], jaw, cheek], "head", 54)
    cage.single([bridge[2], bridge[3], jaw_middle, jaw], "head", 36)
    cage.tube([muzzle, bridge], "muzzle", closed=False, pixels=54)
    cage.single(muzzle[::-1], "muzzle", 50)


def _ear(cage, poll, side, brow, forehead):
    """A pyramid between poll and brow; `side` is its hind corner."""
    inner, outer = cage.ring([at(*EAR_INNER), at(*EAR_OUTER)], {"ear.L": 1.0})
    tip = cage.vertex(at(*EAR_TIP), {"ear.L": 1.0})
    cage.single([inner, side, poll], "head", 26)
    cage.single([forehead, inner, poll], "head", 34)
    cage.single([forehead, brow, outer, inner], "head", 50)
    cage.single([outer, brow, side], "head", 30)
    for a, b in ((inner, outer), (outer, side), (side, inner)):
        cage.single([a, b, tip], "ear", 30)
