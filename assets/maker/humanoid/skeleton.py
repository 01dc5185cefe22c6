# assets/maker/humanoid/skeleton.py: the humanoid's bones in its bind pose, arms 45 degrees down (metres, +Y up, +Z front,
# +X its left).
from ..names import with_twins

HEIGHT = 1.80

# name, parent, origin. ".L" bones are given; their ".R" twins follow.
_CENTRE_AND_LEFT = [
    ("hips", None, (0.0, 0.965, 0.0)),
    ("spine", "hips", (0.0, 1.075, 0.004)),
    ("chest", "spine", (0.0, 1.235, -0.008)),
    ("neck", "chest", (0.0, 1.495, -0.030)),
    ("head", "neck", (0.0, 1.580, -0.012)),
    ("clavicle.L", "chest", (0.025, 1.440, 0.005)),
    ("upper_arm.L", "clavicle.L", (0.178, 1.445, -0.020)),
    ("forearm.L", "upper_arm.L", (0.380, 1.243, -0.028)),
    ("hand.L", "forearm.L", (0.560, 1.063, -0.006)),
    ("thigh.L", "hips", (0.095, 0.925, 0.0)),
    ("shin.L", "thigh.L", (0.103, 0.500, 0.008)),
    ("foot.L", "shin.L", (0.108, 0.085, -0.028)),
    ("toe.L", "foot.L", (0.114, 0.022, 0.105)),
]


def bones():
    """[(name, parent, origin)], parents before children: the middle, then left limb by limb, then the right twins."""
    return with_twins(_CENTRE_AND_LEFT)


NAMES = [name for name, _, _ in bones()]
ORIGIN = {name: origin for name, _, origin in bones()}
PARENT = {name: parent for name, parent, _ in bones()}
