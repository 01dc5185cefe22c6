# assets/maker/lizard/skeleton.py: the lizard's bones: names, parents, places in the bind pose (metres, +Y up, +Z front).
import math

from ..names import mirror_name

ARM = (math.cos(math.radians(40.0)), -math.sin(math.radians(40.0)), 0.0)  # the left arm's direction
SHOULDER = (0.158, 1.125, -0.008)
HIP, KNEE, ANKLE = (0.098, 0.705, 0.0), (0.112, 0.385, 0.022), (0.120, 0.075, -0.022)


def along_arm(t):
    """Point of the left arm's axis, t metres from the shoulder."""
    return tuple(s + t * d for s, d in zip(SHOULDER, ARM))


# name, parent, origin. ".L" bones are given; their ".R" twins follow.
_CENTRE_AND_LEFT = [
    ("hips", None, (0.0, 0.760, 0.0)),
    ("spine", "hips", (0.0, 0.900, 0.0)),
    ("chest", "spine", (0.0, 1.030, 0.0)),
    ("neck", "chest", (0.0, 1.215, -0.012)),
    ("head", "neck", (0.0, 1.310, 0.0)),
    ("shoulder.L", "chest", (0.045, 1.130, 0.0)),
    ("upper_arm.L", "shoulder.L", SHOULDER),
    ("forearm.L", "upper_arm.L", along_arm(0.235)),
    ("hand.L", "forearm.L", along_arm(0.450)),
    ("thigh.L", "hips", HIP),
    ("shin.L", "thigh.L", KNEE),
    ("foot.L", "shin.L", ANKLE),
    ("tail.1", "hips", (0.0, 0.735, -0.120)),
    ("tail.2", "tail.1", (0.0, 0.655, -0.300)),
    ("tail.3", "tail.2", (0.0, 0.590, -0.450)),
    ("tail.4", "tail.3", (0.0, 0.575, -0.610)),
]


def bones():
    """[(name, parent, origin)], parents before children."""
    result = []
    for name, parent, origin in _CENTRE_AND_LEFT:
        result.append((name, parent, origin))
        if name.endswith(".L") and name.split(".")[0] in ("hand", "foot"):
            side = {"hand": ("shoulder", "upper_arm", "forearm", "hand"), "foot": ("thigh", "shin", "foot")}
            for stem in side[name.split(".")[0]]:
                _, left_parent, (x, y, z) = next(b for b in _CENTRE_AND_LEFT if b[0] == stem + ".L")
                result.append((stem + ".R", mirror_name(left_parent), (-x, y, z)))
    return result


NAMES = [name for name, _, _ in bones()]
ORIGIN = {name: origin for name, _, origin in bones()}
PARENT = {name: parent for name, parent, _ in bones()}
