# assets/maker/horse/muscles.py: the horse's rig: 24 muscles that swell its skin; the right ones mirror the left.
from .. import vec
from ..names import mirror_name
from ..plain_glb import ellipsoid, rig_text
from .head import at
from .skeleton import ORIGIN, bones

GROUPS = ["head and neck", "shoulders", "barrel", "quarters", "forelegs", "hind legs"]
LINKS = [("head and neck", "shoulders"), ("shoulders", "barrel"), ("barrel", "quarters"), ("shoulders", "forelegs"),
         ("quarters", "hind legs")]

# name, bone, group, centre in the bind pose, (degrees the long z axis points down in front, degrees it turns outwards in
# front), radii (across, through, along), metres
_LEFT = [
    ("masseter", "head", "head and neck", at(0.040, 0.205, -0.110), (-42.0, 0.0), (0.052, 0.060, 0.066)),
    ("brachiocephalicus", "neck.2", "head and neck", (0.072, 1.500, 0.795), (-60.0, -8.0), (0.056, 0.075, 0.250)),
    ("trapezius", "neck.1", "head and neck", (0.022, 1.665, 0.630), (-38.0, -6.0), (0.058, 0.100, 0.230)),
    ("deltoid", "scapula", "shoulders", (0.120, 1.270, 0.500), (54.0, 8.0), (0.076, 0.090, 0.210)),
    ("triceps", "upper_arm", "shoulders", (0.190, 1.080, 0.390), (66.0, 0.0), (0.062, 0.100, 0.165)),
    ("forearm extensor", "forearm", "forelegs", (0.161, 0.775, 0.470), (86.0, 0.0), (0.056, 0.062, 0.150)),
    ("serratus", "spine.2", "barrel", (0.180, 1.150, 0.000), (4.0, 0.0), (0.095, 0.170, 0.300)),
    ("gluteus", "hips", "quarters", (0.096, 1.412, -0.580), (14.0, 0.0), (0.104, 0.104, 0.180)),
    ("biceps femoris", "thigh", "quarters", (0.172, 1.160, -0.730), (78.0, 0.0), (0.082, 0.100, 0.220)),
    ("quadriceps", "thigh", "quarters", (0.187, 1.110, -0.480), (70.0, 0.0), (0.072, 0.088, 0.180)),
    ("gaskin", "shin", "hind legs", (0.162, 0.835, -0.585), (-46.0, 0.0), (0.056, 0.070, 0.150)),
]
_MIDDLE = [
    ("pectorals", "chest", "shoulders", (0.0, 1.085, 0.590), (62.0, 0.0), (0.130, 0.075, 0.120)),
    ("longissimus", "spine.1", "barrel", (0.0, 1.452, -0.230), (0.0, 0.0), (0.140, 0.080, 0.270)),
]


def primitives(left, middle, territories=None, reach=None):
    """The rows as a rig's primitives: each left one followed by its mirror image, then those of the middle.

    territories: {name: bones whose skin it may move}, where that is not its own bone and the joints next to it; reach: of all."""
    made = []
    for name, bone, group, (x, y, z), (down, out), radii in left:
        own = bone + ".L" if bone + ".L" in ORIGIN else bone
        q = vec.euler(x=down, y=out)
        flipped = (q[0], -q[1], -q[2], q[3])
        made.append(ellipsoid(name + " L", own, group, (x, y, z), q, radii, bones()))
        made.append(ellipsoid(name + " R", mirror_name(own), group, (-x, y, z), flipped, radii, bones()))
        made[-2]["mirror"], made[-1]["mirror"] = name + " R", name + " L"
    for name, bone, group, centre, (down, out), radii in middle:
        made.append(ellipsoid(name, bone, group, centre, vec.euler(x=down, y=out), radii, bones()))
    for primitive in made:
        if reach:
            primitive["reach"] = reach
        if territories and primitive["name"] in territories:
            primitive["territory"] = territories[primitive["name"]]
    return made


def shapes():
    """[(centre in the bind pose, rotation into its own axes, radii)] of the left half and the middle, for the painter."""
    return [(centre, vec.inverse(vec.euler(x=down, y=out)), radii)
            for _, _, _, centre, (down, out), radii in _LEFT + _MIDDLE]


def _folded():
    """At a joint that folds far, a muscle leaves the skin on the other side alone: it would press through from behind."""
    own = {"gaskin": ["shin.", "cannon_hind."], "forearm extensor": ["forearm.", "cannon_front."],
           "biceps femoris": ["hips", "thigh."], "quadriceps": ["hips", "thigh."]}
    return {name + " " + side: [bone + side if bone.endswith(".") else bone for bone in bones_of]
            for name, bones_of in own.items() for side in "LR"}


def under_the_skin():
    """The 24 primitives of horse.rig.json."""
    return primitives(_LEFT, _MIDDLE, _folded())


def rig():
    return rig_text("horse.glb", "swell", 3, GROUPS, LINKS, under_the_skin(), adaptive=True)
