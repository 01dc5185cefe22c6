# assets/maker/humanoid/body.py: the humanoid's left half: the trunk, and the limbs and head that grow from it.
from ..cage import Cage
from . import weights
from .body_arm import arm
from .body_head import head
from .body_leg import leg

# Rings of five points: front middle, front, side, back, back middle. Named by where the front lies.
TRUNK = [
    ("hip", [(0.0, 0.918, 0.096), (0.102, 0.908, 0.094), (0.175, 0.898, -0.006), (0.100, 0.890, -0.126),
             (0.0, 0.915, -0.106)]),
    ("belt", [(0.0, 1.015, 0.104), (0.092, 1.020, 0.096), (0.151, 1.024, 0.0), (0.088, 1.010, -0.100),
              (0.0, 1.012, -0.087)]),
    ("waist", [(0.0, 1.112, 0.100), (0.080, 1.112, 0.094), (0.131, 1.120, 0.002), (0.080, 1.112, -0.078),
               (0.0, 1.112, -0.060)]),
    ("ribs", [(0.0, 1.218, 0.106), (0.092, 1.212, 0.104), (0.155, 1.232, -0.006), (0.100, 1.228, -0.102),
              (0.0, 1.228, -0.082)]),
    ("chest", [(0.0, 1.320, 0.113), (0.112, 1.304, 0.124), (0.184, 1.352, -0.022), (0.124, 1.335, -0.132),
               (0.0, 1.335, -0.110)]),
    ("collar", [(0.0, 1.432, 0.084), (0.118, 1.424, 0.086), (0.158, 1.486, -0.024), (0.122, 1.446, -0.118),
                (0.0, 1.452, -0.108)]),
    ("neck", [(0.0, 1.476, 0.044), (0.046, 1.484, 0.032), (0.068, 1.522, -0.032), (0.045, 1.536, -0.080),
              (0.0, 1.540, -0.092)]),
]


# How the trunk's quads are cut, row by row from the hip, each row read from the front middle round to the back middle with up
# above: the cuts follow groin, arch of the ribs, breast muscle, broad muscle of the back and sacrum.
CUTS = ["//\\\\", "//\\\\", "\\\\\\\\", "\\\\\\\\", "\\  \\", "////"]


class Body(Cage):
    """A cage in which some quads say how they are cut."""

    def __init__(self):
        super().__init__()
        self.cuts = {}  # vertices of a quad -> two of them

    def cut(self, vertices):
        diagonal = self.cuts.get(frozenset(vertices))
        if not diagonal:
            return super().cut(vertices)
        return ((0, 1, 2), (0, 2, 3)) if vertices[0] in diagonal else ((1, 2, 3), (1, 3, 0))

    def cut_from(self, vertices, a, b):
        self.cuts[frozenset(vertices)] = (vertices[a], vertices[b])


def build():
    cage = Body()
    rings = {name: [cage.vertex(p, w) for p, w in zip(points, weights.TRUNK[name])] for name, points in TRUNK}
    rows = [rings[name] for name, _ in TRUNK]
    cage.tube(rows, "trunk", closed=False, holes={(1, 4), (2, 4)}, pixels=72, heights=[128, 92, 92, 92, 92, 70])
    for low, high, cuts in zip(rows, rows[1:], CUTS):
        for k in range(4):
            quad = [low[k], low[k + 1], high[k + 1], high[k]]
            cage.cut_from(quad, *((0, 2) if cuts[k] == "/" else (1, 3)))
    leg(cage, rings["hip"])
    arm(cage, rings["chest"], rings["collar"])
    head(cage, rings["neck"])
    return cage
