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
    ("pectoralis", "chest", "torso", ((0.028, 1.324, 0.0), FRONT), ((0.106, 1.350, 0.0), (0.28, 0.0, 1.0)), 1.24, 0.054, 0.028, 0.50),
    ("pectoralis, upper", "chest", "torso", ((0.032, 1.385, 0.0), FRONT), ((0.118, 1.400, 0.0), (0.25, 0.0, 1.0)), 1.15, 0.036, 0.026, 0.74),
    ("trapezius", "clavicle.L", "torso", ((0.030, 1.500, -0.035), (1.0, 0.6, -0.3)), ((0.130, 1.430, -0.03), (0.10, 1.0, -0.3)), 1.25, 0.044, 0.030, 0.95),
    ("rhomboideus", "chest", "torso", ((0.044, 1.420, -0.02), BACK), ((0.050, 1.260, -0.02), BACK), 1.10, 0.040, 0.028, 0.80),
    ("infraspinatus", "chest", "torso", ((0.070, 1.370, -0.02), BACK), ((0.118, 1.385, -0.03), (0.4, 0.0, -1.0)), 1.15, 0.042, 0.030, 0.72),
    ("latissimus", "chest", "torso", ((0.060, 1.200, 0.0), (0.5, 0.0, -1.0)), ((0.105, 1.310, -0.02), (1.0, 0.0, -0.85)), 1.10, 0.048, 0.030, 0.62),
    ("serratus", "chest", "torso", ((0.060, 1.205, 0.01), (1.0, 0.0, 0.62)), ((0.080, 1.262, 0.01), (1.0, 0.0, 0.56)), 1.10, 0.026, 0.020, 0.52),
    ("rectus abdominis, upper", "spine", "torso", ((0.033, 1.228, 0.0), FRONT), ((0.033, 1.172, 0.0), FRONT), 1.20, 0.031, 0.026, 0.52),
    ("rectus abdominis, lower", "spine", "torso", ((0.031, 1.078, 0.0), FRONT), ((0.026, 0.985, 0.0), FRONT), 1.10, 0.029, 0.026, 0.58),
    ("obliquus", "spine", "torso", ((0.060, 1.040, 0.0), (1.0, 0.0, 0.45)), ((0.060, 1.165, 0.0), (1.0, 0.0, 0.45)), 1.10, 0.044, 0.034, 0.74),
    ("erector spinae", "spine", "torso", ((0.034, 1.010, -0.01), BACK), ((0.038, 1.200, -0.01), BACK), 1.08, 0.030, 0.024, 0.72),
    ("rectus abdominis, middle", "spine", "torso", ((0.033, 1.155, 0.0), FRONT), ((0.032, 1.100, 0.0), FRONT), 1.20, 0.030, 0.026, 0.52),
    ("deltoideus", "upper_arm.L", "shoulders", (_arm(0.02), (0.55, 1.0, 0.12)), (_arm(0.42), (0.8, 0.8, 0.10)), 1.15, 0.056, 0.038, 0.55),
    ("biceps", "upper_arm.L", "upper arms", (_arm(0.36), (-0.10, -0.10, 1.0)), (_arm(0.74), (-0.10, -0.10, 1.0)), 1.10, 0.035, 0.036, 0.58),
    ("triceps", "upper_arm.L", "upper arms", (_arm(0.30), (0.15, 0.10, -1.0)), (_arm(0.82), (0.15, 0.10, -1.0)), 1.10, 0.034, 0.030, 0.55),
    ("forearm", "forearm.L", "forearms", (_fore(0.16), (0.60, 0.60, 0.50)), (_fore(0.56), (0.60, 0.60, 0.35)), 1.15, 0.034, 0.027, 0.58),
    ("gluteus", "hips", "hips", ((0.080, 0.985, 0.0), (0.45, 0.0, -1.0)), ((0.085, 0.905, 0.0), (0.20, 0.0, -1.0)), 1.40, 0.070, 0.052, 0.76),
    ("quadriceps", "thigh.L", "thighs", (_thigh(0.22), (0.25, 0.0, 1.0)), (_thigh(0.84), (0.10, 0.0, 1.0)), 1.05, 0.050, 0.040, 0.50),
    ("hamstrings", "thigh.L", "thighs", (_thigh(0.22), (0.05, 0.0, -1.0)), (_thigh(0.78), (0.0, 0.0, -1.0)), 1.05, 0.048, 0.036, 0.64),
    ("calf", "shin.L", "calves", (_shin(0.18), (0.05, 0.0, -1.0)), (_shin(0.50), (0.05, 0.0, -1.0)), 1.12, 0.046, 0.032, 0.64),
]
_MIDDLE = [
    ("nape", "neck", "neck", ((0.0, 1.490, -0.03), BACK), ((0.0, 1.545, -0.03), BACK), 1.0, 0.030, 0.020, 0.75),
]
# A bent elbow or knee brings the skin of the other side close, which must not be lifted.
_OWN_SKIN = {"biceps": ["upper_arm.L"], "forearm": ["forearm.L"], "hamstrings": ["thigh.L"], "calf": ["shin.L"]}
REACH = 1.42
# Broad and flat ones end softly.
_SOFT = {"pectoralis": 1.6, "pectoralis, upper": 1.8}
SURFACE = {"mode": "swell", "iso": 0.25, "skin_blend": 0.026}
SMOOTHING = {"depth": 3, "patch": "pn"}
ADAPTIVE = {**SMOOTHING, "detail": "adaptive"}


def _off(place, x, y, z):
    return (place[0] + x, place[1] + y, place[2] + z)


# Bellies that are another in the bind pose, as in _PAIRS: a biceps that shortens may be as long as the arm lets it.
_ON_LINE = {
    "biceps": ("biceps", "upper_arm.L", "upper arms", (_arm(0.34), (-0.10, -0.10, 1.0)), (_arm(0.84), (-0.10, -0.10, 1.0)), 1.15, 0.034, 0.036, 0.58),
}
# Muscles that span a joint. Name; origin, insertion and via point as bone and place; settings of docs/muscles.md.
_LINES = [
    ("biceps", ("upper_arm.L", _off(_arm(0.16), 0.0, 0.0, 0.020)), ("forearm.L", _off(_fore(0.05), 0.0, 0.0, 0.014)), None,
     {"tendons": [0.32, 0.04], "volume": 0.8, "flex": [0.22, 0.15], "activation": {"full": 0.88}}),
    ("triceps", ("upper_arm.L", _off(_arm(0.08), 0.0, 0.0, -0.022)), ("forearm.L", _off(_fore(0.02), 0.0, 0.0, -0.026)),
     ("upper_arm.L", _off(_arm(0.72), 0.0, 0.0, -0.034)), {"rest": 1.12, "tendons": [0.1, 0.2], "activation": {"gain": 0.6, "full": 0.85}}),
    ("forearm", ("upper_arm.L", _off(_arm(0.92), 0.016, 0.010, 0.010)), ("hand.L", _off(_fore(0.98), 0.006, 0.008, 0.006)), None,
     {"tendons": [0.14, 0.2], "volume": 0.6, "flex": [0.04, 0.04], "activation": {"full": 0.85}}),
    ("gluteus", ("hips", (0.070, 0.990, -0.060)), ("thigh.L", _off(_thigh(0.22), 0.020, 0.0, -0.030)), None,
     {"rest": 1.1, "tendons": [0.05, 0.15], "flex": [0.1, 0], "activation": {"full": 0.8}}),
    ("quadriceps", ("thigh.L", _off(_thigh(0.06), 0.0, 0.0, 0.045)), ("shin.L", _off(_shin(0.05), 0.0, 0.0, 0.032)),
     ("thigh.L", _off(_thigh(0.62), 0.0, 0.0, 0.045)), {"tendons": [0.1, 0.22], "flex": [0.2, 0], "activation": {"full": 0.85}}),
    ("hamstrings", ("hips", (0.080, 0.900, -0.045)), ("shin.L", _off(_shin(0.09), 0.0, 0.0, -0.028)), None,
     {"tendons": [0.1, 0.22], "flex": [0.18, 0], "activation": {"full": 0.8}}),
    ("calf", ("thigh.L", _off(_thigh(0.95), 0.0, 0.0, -0.030)), ("foot.L", _off(ORIGIN["foot.L"], 0.0, -0.020, -0.045)), None,
     {"tendons": [0.06, 0.42], "volume": 0.6, "flex": [0.12, 0], "activation": {"gain": 0.4, "full": 0.85}}),
]


def flex_rig(mesh):
    """humanoid-flex.rig.json: the same muscles, those of the limbs on lines; the biceps is longer."""
    lines = [side for row in _LINES for side in laid.line_pair(*row, ORIGIN)]
    spanning = {line["name"] for line in lines}
    rows = [{**row, "line": row["name"]} if row["name"] in spanning else row for row in _swell_rows(mesh, _ON_LINE)]
    return laid.rig_text("humanoid.glb", SURFACE, ADAPTIVE, GROUPS, LINKS, rows, lines)


def swell_rig(mesh):
    """humanoid.rig.json: muscles under the skin."""
    return laid.rig_text("humanoid.glb", SURFACE, ADAPTIVE, GROUPS, LINKS, _swell_rows(mesh, {}))


def _swell_rows(mesh, instead):
    skin = laid.Skin(mesh)
    rows = []
    for name, bone, group, a, b, longer, width, thick, sink in (instead.get(row[0], row) for row in _PAIRS):
        rows += laid.pair(name, bone, group, *laid.ellipsoid(skin, a, b, longer, width, thick, sink), ORIGIN,
                          _SOFT.get(name, REACH), _OWN_SKIN.get(name))
    for name, bone, group, a, b, longer, width, thick, sink in _MIDDLE:
        centre, rotation, radii = laid.ellipsoid(skin, a, b, longer, width, thick, sink)
        rows.append(laid.primitive(name, bone, group, centre, rotation, radii, ORIGIN[bone], "", REACH))
    return rows


# What wraps the body: fitted to the muscled skin by maker/fit.py, then rounded. Name, bone, group, centre and rotation
# in the bind pose, radii (metres).
WRAP = [
    ("ribs, upper", "chest", "torso", (0.065, 1.386, -0.006), (0.0000, 0.0000, 0.0000, 1.0000), (0.119, 0.121, 0.087)),
    ("ribs, lower", "chest", "torso", (0.067, 1.274, 0.004), (0.0000, 0.0000, 0.0000, 1.0000), (0.088, 0.131, 0.124)),
    ("pectoralis", "chest", "torso", (0.085, 1.350, 0.076), (0.0000, 0.0000, 0.1305, 0.9914), (0.107, 0.074, 0.051)),
    ("latissimus", "chest", "torso", (0.097, 1.263, -0.039), (0.0000, 0.0000, -0.1045, 0.9945), (0.045, 0.084, 0.060)),
    ("trapezius", "clavicle.L", "torso", (0.085, 1.445, -0.045), (0.0000, 0.0000, -0.1305, 0.9914), (0.080, 0.035, 0.050)),
    ("scapula", "chest", "torso", (0.099, 1.390, -0.087), (0.0000, 0.0000, -0.0872, 0.9962), (0.101, 0.094, 0.049)),
    ("abdomen, upper", "spine", "torso", (0.037, 1.170, 0.048), (0.0000, 0.0000, 0.0000, 1.0000), (0.064, 0.083, 0.059)),
    ("abdomen, lower", "spine", "torso", (0.036, 1.069, 0.051), (0.0000, 0.0000, 0.0000, 1.0000), (0.056, 0.084, 0.056)),
    ("flank", "spine", "torso", (0.071, 1.087, 0.000), (0.0000, 0.0000, 0.0000, 1.0000), (0.071, 0.120, 0.079)),
    ("loin", "spine", "torso", (0.040, 1.116, -0.029), (0.0000, 0.0000, 0.0000, 1.0000), (0.043, 0.113, 0.047)),
    ("pelvis", "hips", "torso", (0.057, 0.976, 0.004), (0.0000, 0.0000, 0.0000, 1.0000), (0.094, 0.122, 0.104)),
    ("gluteus", "hips", "torso", (0.067, 0.931, -0.041), (0.0000, 0.0000, 0.0000, 1.0000), (0.071, 0.080, 0.097)),
    ("axilla", "clavicle.L", "torso", (0.137, 1.388, -0.013), (0.0000, 0.0000, 0.0000, 1.0000), (0.043, 0.054, 0.063)),
    ("deltoideus", "upper_arm.L", "shoulders", (0.235, 1.416, -0.024), (0.0000, 0.0152, -0.3826, 0.9238), (0.096, 0.065, 0.071)),
    ("biceps", "upper_arm.L", "arms", (0.279, 1.330, 0.004), (0.0000, 0.0152, -0.3826, 0.9238), (0.057, 0.038, 0.046)),
    ("triceps", "upper_arm.L", "arms", (0.306, 1.320, -0.032), (0.0000, 0.0152, -0.3826, 0.9238), (0.101, 0.047, 0.064)),
    ("forearm", "forearm.L", "arms", (0.413, 1.213, -0.018), (0.0000, -0.0466, -0.3816, 0.9232), (0.165, 0.047, 0.053)),
    ("thigh, front", "thigh.L", "legs", (0.098, 0.684, 0.012), (-0.0094, 0.0000, 0.0094, 0.9999), (0.068, 0.220, 0.089)),
    ("thigh, back", "thigh.L", "legs", (0.099, 0.820, -0.012), (-0.0094, 0.0000, 0.0094, 0.9999), (0.080, 0.183, 0.111)),
    ("calf", "shin.L", "legs", (0.105, 0.368, -0.022), (0.0432, 0.0000, 0.0060, 0.9990), (0.059, 0.138, 0.074)),
    ("nape", "neck", "torso", (0.000, 1.508, -0.054), (0.1736, 0.0000, 0.0000, 0.9848), (0.070, 0.074, 0.050)),
]
WRAP_GROUPS = ["neck", "torso", "shoulders", "arms", "legs"]
WRAP_LINKS = [("neck", "torso"), ("torso", "shoulders"), ("shoulders", "arms"), ("torso", "legs")]


_NO_ARM = ("ribs, lower", "latissimus", "flank")


def wrap_territory(row):
    """Limbs hang beside the trunk and bend until their halves touch: each part moves its own skin alone."""
    if row[2] in ("arms", "legs"):
        return [row[1]]
    return ["chest", "spine"] if row[0] in _NO_ARM else None


def wrapped_rig():
    """humanoid-wrapped.rig.json: the paper's way, a body that its primitives hold whole."""
    rows = []
    for row in WRAP:
        name, bone, group, centre, rotation, radii = row
        if centre[0] == 0.0:
            rows.append(laid.primitive(name, bone, group, centre, rotation, radii, ORIGIN[bone]))
        else:
            rows += laid.pair(name, bone, group, centre, rotation, radii, ORIGIN, territory=wrap_territory(row))
    return laid.rig_text("humanoid.glb", {"mode": "replace", "iso": 0.25, "skin_blend": 0.04},
                         {**SMOOTHING, "projection": "analytic"}, WRAP_GROUPS, WRAP_LINKS, rows)
