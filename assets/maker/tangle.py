# assets/maker/tangle.py: a bending block with 40 overlapping ellipsoids in 8 partly linked groups: a trial for roots.
import math

from . import blocks, vec
from .clip import Clip
from .plain_glb import Scene, ellipsoid, rig_text

BONES = [("base", None, (0.0, 0.0, 0.0)), ("low", "base", (0.0, 0.25, 0.0)), ("high", "low", (0.0, 0.50, 0.0)),
         ("top", "high", (0.0, 0.75, 0.0))]
HALF = (0.26, 0.50, 0.20)  # of the block, about (0, 0.5, 0)
ROUND = 0.12               # radius of its edges

GROUPS = ["a", "b", "c", "d", "e", "f", "g", "alone"]
LINKS = [("a", "b"), ("a", "c"), ("a", "d"), ("b", "c"), ("b", "d"), ("c", "d"),  # a clique of four
         ("d", "e"), ("e", "f"), ("f", "g"), ("g", "d")]                          # a ring; d is a star's middle
COUNT = 40
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0


def _distance(p):
    """To the rounded block."""
    q = [abs(c - m) - h + ROUND for c, m, h in zip(p, (0.0, 0.5, 0.0), HALF)]
    outside = vec.length(tuple(max(c, 0.0) for c in q))
    return outside + min(max(q), 0.0) - ROUND


def _place(corner):
    i, j, k = corner
    return ((i - 2) * 0.13, j * 0.125, (k - 1.5) * 0.4 / 3.0)


def _bend():
    keys = 32
    clip = Clip("Bend", 2.0, keys)
    for n in range(keys):
        phase = 2.0 * math.pi * n / keys
        for bone, offset in (("low", 0.0), ("high", 0.7), ("top", 1.4)):
            turn = vec.euler(x=16.0 * math.sin(phase + offset), y=14.0 * math.sin(2.0 * phase + offset),
                             z=22.0 * math.cos(phase + offset))
            clip.key(bone, "rotation", turn)
    return clip.close()


def scene():
    cells = [(i, j, k) for i in range(4) for j in range(8) for k in range(3)]
    positions, triangles = blocks.Blocks(cells, _place).mesh()
    positions = [blocks.drawn_onto(p, _distance) for p in positions]
    positions = blocks.relaxed(positions, triangles, _distance, 1)
    segments = {name: blocks.Capsule(o, vec.add(o, (0.0, 0.25, 0.0)), 0.0) for name, _, o in BONES}
    weights = [blocks.weights((0.0, p[1], 0.0), segments, 0.05) for p in positions]
    return Scene("tangle", BONES, positions, blocks.normals(positions, triangles), triangles, weights, [_bend()],
                 [0.45, 0.52, 0.62])


def _spread(n, share):
    """The n-th of evenly spread numbers in [0, 1)."""
    return (0.5 + n * share) % 1.0


def rig():
    """Centres wind around the block a little over or under its skin; every tenth carves."""
    primitives = []
    for n in range(COUNT):
        height = 0.06 + 0.88 * (n + 0.5) / COUNT
        around = 2.0 * math.pi * _spread(n, GOLDEN)
        skin = blocks.drawn_onto((0.3 * math.sin(around), height, 0.24 * math.cos(around)), _distance)
        outwards = vec.unit((skin[0], 0.0, skin[2]))
        centre = vec.add(skin, vec.scale(outwards, -0.030 + 0.045 * _spread(n, 0.7548777)))
        rotation = vec.euler(x=360.0 * _spread(n, 0.5698403), y=360.0 * _spread(n, 0.3247180),
                             z=360.0 * _spread(n, 0.8191725))
        radii = tuple(0.055 + 0.075 * _spread(3 * n + c, 0.4142136) for c in range(3))
        bone = BONES[min(3, int(height / 0.25))][0]
        carves = n % 10 == 7
        primitives.append(ellipsoid("%s %02d" % ("carve" if carves else "muscle", n), bone, GROUPS[(n * 3) % 8], centre,
                                    rotation, radii, BONES, -1 if carves else 1))
    return rig_text("tangle.glb", "swell", 4, GROUPS, LINKS, primitives)
