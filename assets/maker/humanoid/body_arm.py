# assets/maker/humanoid/body_arm.py: arm and hand of the left half.
import math

from .. import vec
from . import weights
from .skeleton import ORIGIN

SHOULDER, ELBOW, WRIST = ORIGIN["upper_arm.L"], ORIGIN["forearm.L"], ORIGIN["hand.L"]
UPPER = vec.length(vec.sub(ELBOW, SHOULDER))
WHOLE = UPPER + vec.length(vec.sub(WRIST, ELBOW))
UP = (math.sqrt(0.5), math.sqrt(0.5), 0.0)  # to the back of the hand

# Rings of six points: (metres along the arm, towards UP, towards +Z from the bone). Top, then by the back round to the front.
ARM = [
    ("deltoid", [(0.032, 0.068, -0.006), (0.045, 0.040, -0.062), (0.068, -0.018, -0.060), (0.082, -0.048, -0.004),
                 (0.068, -0.018, 0.056), (0.045, 0.040, 0.060)]),
    ("biceps", [(0.145, 0.053, -0.006), (0.150, 0.028, -0.054), (0.155, -0.024, -0.054), (0.158, -0.049, -0.002),
                (0.155, -0.024, 0.054), (0.150, 0.028, 0.052)]),
    ("above elbow", [(0.238, 0.042, -0.004), (0.240, 0.022, -0.044), (0.240, -0.020, -0.044), (0.238, -0.041, -0.002),
                     (0.240, -0.020, 0.040), (0.240, 0.022, 0.042)]),
    ("elbow", [(0.284, 0.043, 0.000), (0.288, 0.018, -0.044), (0.288, -0.018, -0.044), (0.284, -0.042, 0.000)]),
    ("forearm", [(0.340, 0.049, 0.004), (0.346, 0.024, -0.040), (0.348, -0.022, -0.040), (0.348, -0.046, 0.002),
                 (0.346, -0.024, 0.048), (0.340, 0.026, 0.052)]),
    ("wrist", [(0.528, 0.024, 0.004), (0.530, 0.014, -0.026), (0.530, -0.014, -0.026), (0.532, -0.024, 0.002),
               (0.532, -0.015, 0.030), (0.530, 0.014, 0.032)]),
    ("knuckles", [(0.634, 0.018, 0.019), (0.624, 0.006, -0.043), (0.624, -0.014, -0.041), (0.632, -0.017, 0.017),
                  (0.628, -0.014, 0.042), (0.632, 0.008, 0.042)]),
]
# On from the knuckles: top front, top back, low back, low front.
FINGERS = [(0.719, 0.002, 0.015), (0.704, -0.006, -0.032), (0.704, -0.022, -0.030), (0.719, -0.017, 0.013)]
INDEX = [(0.713, 0.001, 0.037), (0.716, 0.003, 0.019), (0.716, -0.014, 0.019), (0.713, -0.012, 0.037)]
THUMB = [(0.630, 0.004, 0.0795), (0.648, 0.002, 0.0675), (0.645, -0.017, 0.0635), (0.626, -0.016, 0.0755)]
THUMB_TIP = (0.666, -0.011, 0.0825)
# Of the quads from the trunk to the deltoid, from the front round below: the corners each is cut from and to.
SHOULDER_CUTS = [(1, 3), (0, 2), (1, 3), (0, 2), (0, 2), (0, 2)]


def along(t):
    """Point of the arm's bones, t metres from the shoulder; beyond the wrist straight on."""
    if t < UPPER:
        return vec.mix(SHOULDER, ELBOW, t / UPPER)
    return vec.mix(ELBOW, WRIST, (t - UPPER) / (WHOLE - UPPER))


def place(t, up, z):
    return vec.add(along(t), vec.add(vec.scale(UP, up), (0.0, 0.0, z)))


def arm(cage, chest, collar):
    """Grows from the hole between the two rings."""
    ring = {"root": [collar[2], collar[3], chest[3], chest[2], chest[1], collar[1]][::-1]}
    for name, points in ARM:
        ring[name] = [cage.vertex(place(*p), w) for p, w in zip(points, weights.ARM[name])][::-1]
    upper = [ring[name] for name in ("root", "deltoid", "biceps", "above elbow")]
    cage.tube(upper, "arm", closed=True, pixels=38, heights=[48, 64, 56])
    for k, (a, b) in enumerate(SHOULDER_CUTS):
        m = (k + 1) % 6
        cage.cut_from([upper[0][k], upper[0][m], upper[1][m], upper[1][k]], a, b)
    _elbow(cage, ring["above elbow"], ring["elbow"], ring["forearm"])
    cage.tube([ring["forearm"], ring["wrist"]], "arm", closed=True, pixels=44, heights=[150])
    cage.tube([ring["wrist"], ring["knuckles"]], "hand", closed=True, holes={(0, 0)}, pixels=40, heights=[80])
    _hand(cage, ring["wrist"], ring["knuckles"])


def _elbow(cage, above, elbow, below):
    """Three loops outside; inside the bend, the first and the last meet."""
    cage.tube([above[2:], elbow, below[2:]], "arm", closed=False, pixels=38, heights=[30, 36])
    cage.single([above[0], above[1], below[1], below[0]], "arm", 34)
    for crease, side, middle in ((1, 2, elbow[0]), (0, 5, elbow[3])):
        for corners in ([above[crease], above[side], middle], [above[crease], middle, below[crease]],
                        [middle, below[side], below[crease]]):
            cage.single(corners if crease else corners[::-1], "arm", 26)


def _hand(cage, wrist, knuckles):
    top_front, low_front, low, low_back, top_back, top = knuckles

    def ring(points):
        return cage.ring([place(*p) for p in points], {"hand.L": 1.0})[::-1]

    for root, points in (([low, low_back, top_back, top], FINGERS), ([low_front, low, top, top_front], INDEX)):
        finger = ring(points)
        cage.tube([root, finger], "hand", closed=True, pixels=40, heights=[64])
        cage.cap(finger, "hand", 16)
    thumb = ring(THUMB)
    cage.tube([[wrist[1], low_front, top_front, wrist[0]], thumb], "hand", closed=True, pixels=28, heights=[40])
    tip = cage.vertex(place(*THUMB_TIP), {"hand.L": 1.0})
    for k in range(4):
        cage.single([thumb[k], thumb[(k + 1) % 4], tip], "hand", 16)
