# assets/maker/humanoid/muscles.py: the humanoid's rigs: 41 muscles under the skin, and 41 ellipsoids that wrap the body.
from .. import laid
from .skeleton import ORIGIN

GROUPS = ["neck", "torso", "shoulders", "upper arms", "forearms", "hips", "thighs", "calves"]
LINKS = [("neck", "torso"), ("torso", "shoulders"), ("shoulders", "upper arms"), ("upper arms", "forearms"), ("torso", "hips"),
         ("hips", "thighs"), ("thighs", "calves")]


def _along(bone, child, t):
    return tuple(a + (b - a) * t for a, b in zip(ORIGIN[bone], ORIGIN[child]))


def _arm(t):
    return _along("upper_arm.L", "forearm.L", t)


def _fore(t):
    return _along("forearm.L", "hand.L", t)


def _thigh(t):
    return _along("thigh.L", "shin.L", t)


def _shin(t):
    return _along("shin.L", "foot.L", t)


FRONT, BACK = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
# name, bone, group, (inside, towards) of one end and of the other, length factor, half width, half thickness, depth of the middle
_PAIRS = [
    ("pectoralis", "chest", "torso", ((0.030, 1.315, 0.0), FRONT), ((0.125, 1.365, 0.0), (0.35, 0.0, 1.0)), 1.15, 0.056, 0.030, 0.60),
    ("pectoralis, upper", "chest", "torso", ((0.030, 1.395, 0.0), FRONT), ((0.125, 1.410, 0.0), (0.25, 0.0, 1.0)), 1.05, 0.030, 0.024, 0.65),
    ("trapezius", "clavicle.L", "torso", ((0.055, 1.450, -0.03), (0.25, 1.0, -0.3)), ((0.120, 1.430, -0.03), (0.10, 1.0, -0.3)), 1.2, 0.040, 0.028, 0.66),
    ("rhomboideus", "chest", "torso", ((0.040, 1.420, -0.02), BACK), ((0.050, 1.270, -0.02), BACK), 1.10, 0.040, 0.026, 0.70),
    ("infraspinatus", "chest", "torso", ((0.075, 1.370, -0.02), BACK), ((0.130, 1.385, -0.03), (0.4, 0.0, -1.0)), 1.15, 0.038, 0.026, 0.58),
    ("latissimus", "chest", "torso", ((0.060, 1.200, 0.0), (0.5, 0.0, -1.0)), ((0.110, 1.330, -0.02), (1.0, 0.0, -0.75)), 1.10, 0.050, 0.030, 0.60),
    ("serratus", "chest", "torso", ((0.060, 1.215, 0.01), (1.0, 0.0, 0.50)), ((0.080, 1.285, 0.01), (1.0, 0.0, 0.42)), 1.10, 0.030, 0.018, 0.62),
    ("rectus abdominis, upper", "spine", "torso", ((0.036, 1.230, 0.0), FRONT), ((0.034, 1.140, 0.0), FRONT), 1.05, 0.032, 0.024, 0.66),
    ("rectus abdominis, lower", "spine", "torso", ((0.034, 1.115, 0.0), FRONT), ((0.030, 0.990, 0.0), FRONT), 1.05, 0.030, 0.022, 0.68),
    ("obliquus", "spine", "torso", ((0.060, 1.030, 0.0), (1.0, 0.0, 0.30)), ((0.060, 1.165, 0.0), (1.0, 0.0, 0.35)), 1.05, 0.050, 0.028, 0.70),
    ("erector spinae", "spine", "torso", ((0.032, 1.030, -0.01), BACK), ((0.036, 1.200, -0.01), BACK), 1.05, 0.026, 0.022, 0.62),
    ("teres", "chest", "torso", ((0.110, 1.290, -0.02), (0.8, 0.0, -1.0)), ((0.140, 1.345, -0.02), (1.0, 0.0, -0.6)), 1.20, 0.030, 0.022, 0.60),
    ("deltoideus", "upper_arm.L", "shoulders", (_arm(0.02), (0.55, 1.0, 0.12)), (_arm(0.42), (0.8, 0.8, 0.10)), 1.15, 0.056, 0.038, 0.55),
    ("biceps", "upper_arm.L", "upper arms", (_arm(0.42), (-0.10, -0.10, 1.0)), (_arm(0.86), (-0.10, -0.10, 1.0)), 1.05, 0.030, 0.030, 0.55),
    ("triceps", "upper_arm.L", "upper arms", (_arm(0.30), (0.15, 0.10, -1.0)), (_arm(0.82), (0.15, 0.10, -1.0)), 1.10, 0.034, 0.030, 0.55),
    ("forearm", "forearm.L", "forearms", (_fore(0.05), (0.60, 0.60, 0.55)), (_fore(0.55), (0.60, 0.60, 0.35)), 1.10, 0.032, 0.026, 0.55),
    ("gluteus", "hips", "hips", ((0.080, 0.985, 0.0), (0.45, 0.0, -1.0)), ((0.085, 0.905, 0.0), (0.20, 0.0, -1.0)), 1.40, 0.070, 0.052, 0.76),
    ("quadriceps", "thigh.L", "thighs", (_thigh(0.20), (0.25, 0.0, 1.0)), (_thigh(0.86), (0.05, 0.0, 1.0)), 1.05, 0.056, 0.036, 0.58),
    ("hamstrings", "thigh.L", "thighs", (_thigh(0.22), (0.05, 0.0, -1.0)), (_thigh(0.84), (0.0, 0.0, -1.0)), 1.05, 0.046, 0.034, 0.58),
    ("calf", "shin.L", "calves", (_shin(0.10), (0.05, 0.0, -1.0)), (_shin(0.48), (0.05, 0.0, -1.0)), 1.10, 0.044, 0.034, 0.55),
]
_MIDDLE = [
    ("nape", "neck", "neck", ((0.0, 1.490, -0.03), BACK), ((0.0, 1.545, -0.03), BACK), 1.0, 0.030, 0.020, 0.75),
]
REACH = 1.42
SURFACE = {"mode": "swell", "iso": 0.25, "skin_blend": 0.026}
SMOOTHING = {"depth": 3, "patch": "pn", "projection": "newton"}


def swell_rig(mesh):
    """humanoid.rig.json: muscles under the skin."""
    skin = laid.Skin(mesh)
    rows = []
    for name, bone, group, a, b, longer, width, thick, sink in _PAIRS:
        rows += laid.pair(name, bone, group, *laid.ellipsoid(skin, a, b, longer, width, thick, sink), ORIGIN, REACH)
    for name, bone, group, a, b, longer, width, thick, sink in _MIDDLE:
        centre, rotation, radii = laid.ellipsoid(skin, a, b, longer, width, thick, sink)
        rows.append(laid.primitive(name, bone, group, centre, rotation, radii, ORIGIN[bone], "", REACH))
    return laid.rig_text("humanoid.glb", SURFACE, SMOOTHING, GROUPS, LINKS, rows)


# What wraps the body: fitted to its skin by least squares of F - T, then rounded. Name, bone, group, centre and rotation
# in the bind pose, radii (metres).
_WRAP = [
    ("ribs, upper", "chest", "torso", (0.065, 1.381, -0.005), (0.0000, 0.0000, 0.0000, 1.0000), (0.114, 0.125, 0.088)),
    ("ribs, lower", "chest", "torso", (0.066, 1.266, 0.007), (0.0000, 0.0000, 0.0000, 1.0000), (0.090, 0.126, 0.119)),
    ("pectoralis", "chest", "torso", (0.085, 1.350, 0.076), (0.0000, 0.0000, 0.1305, 0.9914), (0.107, 0.074, 0.051)),
    ("latissimus", "chest", "torso", (0.098, 1.273, -0.046), (0.0000, 0.0000, -0.1045, 0.9945), (0.045, 0.097, 0.059)),
    ("trapezius", "clavicle.L", "torso", (0.085, 1.445, -0.045), (0.0000, 0.0000, -0.1305, 0.9914), (0.080, 0.035, 0.050)),
    ("scapula", "chest", "torso", (0.092, 1.386, -0.082), (0.0000, 0.0000, -0.0872, 0.9962), (0.096, 0.107, 0.056)),
    ("abdomen, upper", "spine", "torso", (0.038, 1.166, 0.050), (0.0000, 0.0000, 0.0000, 1.0000), (0.061, 0.077, 0.058)),
    ("abdomen, lower", "spine", "torso", (0.037, 1.070, 0.054), (0.0000, 0.0000, 0.0000, 1.0000), (0.056, 0.079, 0.054)),
    ("flank", "spine", "torso", (0.074, 1.093, -0.001), (0.0000, 0.0000, 0.0000, 1.0000), (0.069, 0.105, 0.078)),
    ("loin", "spine", "torso", (0.041, 1.118, -0.032), (0.0000, 0.0000, 0.0000, 1.0000), (0.045, 0.105, 0.045)),
    ("pelvis", "hips", "torso", (0.051, 0.980, 0.012), (0.0000, 0.0000, 0.0000, 1.0000), (0.093, 0.118, 0.095)),
    ("gluteus", "hips", "torso", (0.066, 0.933, -0.046), (0.0000, 0.0000, 0.0000, 1.0000), (0.069, 0.093, 0.091)),
    ("axilla", "clavicle.L", "torso", (0.137, 1.388, -0.013), (0.0000, 0.0000, 0.0000, 1.0000), (0.043, 0.054, 0.063)),
    ("deltoideus", "upper_arm.L", "shoulders", (0.234, 1.417, -0.024), (0.0000, 0.0152, -0.3826, 0.9238), (0.095, 0.066, 0.070)),
    ("biceps", "upper_arm.L", "arms", (0.299, 1.318, -0.007), (0.0000, 0.0152, -0.3826, 0.9238), (0.077, 0.043, 0.052)),
    ("triceps", "upper_arm.L", "arms", (0.300, 1.330, -0.047), (0.0000, 0.0152, -0.3826, 0.9238), (0.091, 0.045, 0.049)),
    ("forearm", "forearm.L", "arms", (0.419, 1.208, -0.019), (0.0000, -0.0466, -0.3816, 0.9232), (0.142, 0.049, 0.052)),
    ("thigh, front", "thigh.L", "legs", (0.096, 0.732, 0.021), (-0.0094, 0.0000, 0.0094, 0.9999), (0.069, 0.220, 0.089)),
    ("thigh, back", "thigh.L", "legs", (0.102, 0.796, -0.024), (-0.0094, 0.0000, 0.0094, 0.9999), (0.077, 0.220, 0.092)),
    ("calf", "shin.L", "legs", (0.105, 0.383, -0.022), (0.0432, 0.0000, 0.0060, 0.9990), (0.059, 0.149, 0.075)),
    ("nape", "neck", "torso", (0.000, 1.508, -0.054), (0.1736, 0.0000, 0.0000, 0.9848), (0.074, 0.074, 0.052)),
]
WRAP_GROUPS = ["neck", "torso", "shoulders", "arms", "legs"]
WRAP_LINKS = [("neck", "torso"), ("torso", "shoulders"), ("shoulders", "arms"), ("torso", "legs")]


def wrapped_rig():
    """humanoid-wrapped.rig.json: the paper's way, a body that its primitives hold whole."""
    rows = []
    for name, bone, group, centre, rotation, radii in _WRAP:
        own = ["upper_arm.L", "forearm.L"] if group == "arms" else None  # the arm hangs beside the chest
        if centre[0] == 0.0:
            rows.append(laid.primitive(name, bone, group, centre, rotation, radii, ORIGIN[bone]))
        else:
            rows += laid.pair(name, bone, group, centre, rotation, radii, ORIGIN, territory=own)
    return laid.rig_text("humanoid.glb", {"mode": "replace", "iso": 0.25, "skin_blend": 0.04},
                         {**SMOOTHING, "projection": "analytic"}, WRAP_GROUPS,
                         WRAP_LINKS, rows)
