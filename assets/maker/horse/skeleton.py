# assets/maker/horse/skeleton.py: the horse's bones: names, parents, places in the bind pose (metres, +Y up, +Z front).
from ..names import with_twins

# Breastbone, girth, ribs, belly, flank, seat and muzzle have no skin of their own: they lead the skeleton to where the body is wide, so
# that every part of the skin has a point of it inside.
# name, parent, origin. ".L" bones are given; their ".R" twins follow.
_CENTRE_AND_LEFT = [
    ("hips", None, (0.0, 1.320, -0.580)),
    ("spine.1", "hips", (0.0, 1.340, -0.380)),
    ("spine.2", "spine.1", (0.0, 1.340, -0.100)),
    ("chest", "spine.2", (0.0, 1.340, 0.180)),
    ("belly", "spine.1", (0.0, 1.060, -0.280)),
    ("girth", "chest", (0.0, 1.030, 0.180)),
    ("breastbone", "chest", (0.0, 1.060, 0.500)),
    ("neck.1", "chest", (0.0, 1.370, 0.540)),
    ("neck.2", "neck.1", (0.0, 1.590, 0.735)),
    ("neck.3", "neck.2", (0.0, 1.780, 0.875)),
    ("head", "neck.3", (0.0, 1.925, 0.995)),
    ("muzzle", "head", (0.0, 1.595, 1.315)),
    ("ear.L", "head", (0.048, 2.005, 1.010)),
    ("tail.1", "hips", (0.0, 1.440, -0.860)),
    ("tail.2", "tail.1", (0.0, 1.290, -0.965)),
    ("tail.3", "tail.2", (0.0, 1.060, -1.005)),
    ("tail.4", "tail.3", (0.0, 0.820, -1.010)),
    ("scapula.L", "chest", (0.100, 1.450, 0.350)),
    ("upper_arm.L", "scapula.L", (0.165, 1.100, 0.610)),
    ("forearm.L", "upper_arm.L", (0.155, 0.915, 0.415)),
    ("cannon_front.L", "forearm.L", (0.138, 0.480, 0.445)),
    ("pastern_front.L", "cannon_front.L", (0.132, 0.225, 0.445)),
    ("hoof_front.L", "pastern_front.L", (0.132, 0.085, 0.535)),
    ("flank.L", "spine.1", (0.130, 1.120, -0.220)),
    ("ribs.L", "chest", (0.125, 1.040, 0.200)),
    ("seat.L", "hips", (0.095, 1.240, -0.790)),
    ("thigh.L", "hips", (0.125, 1.240, -0.620)),
    ("shin.L", "thigh.L", (0.165, 0.975, -0.430)),
    ("cannon_hind.L", "shin.L", (0.140, 0.570, -0.765)),
    ("pastern_hind.L", "cannon_hind.L", (0.135, 0.240, -0.750)),
    ("hoof_hind.L", "pastern_hind.L", (0.135, 0.090, -0.660)),
]


def bones():
    """[(name, parent, origin)], parents before children: the middle and left, then the right twins."""
    return with_twins(_CENTRE_AND_LEFT)


NAMES = [name for name, _, _ in bones()]
ORIGIN = {name: origin for name, _, origin in bones()}
PARENT = {name: parent for name, parent, _ in bones()}
