# assets/maker/horse/volumes.py: the horse's second rig: 24 ellipsoids wrap the body, as in the paper's Fig. 7.
from ..plain_glb import rig_text
from .head import at
from .muscles import GROUPS, LINKS, primitives

# Rows as in muscles.py.
_LEFT = [
    ("cheek", "head", "head and neck", at(0.034, 0.180, -0.100), (48.0, 0.0), (0.058, 0.116, 0.110)),
    ("shoulder", "scapula", "shoulders", (0.112, 1.245, 0.505), (54.0, 8.0), (0.098, 0.140, 0.260)),
    ("upper arm", "upper_arm", "shoulders", (0.146, 1.030, 0.405), (60.0, 0.0), (0.082, 0.135, 0.165)),
    ("forearm", "forearm", "forelegs", (0.152, 0.755, 0.455), (88.0, 0.0), (0.060, 0.088, 0.205)),
    ("quarter", "hips", "quarters", (0.110, 1.380, -0.590), (14.0, 0.0), (0.140, 0.155, 0.240)),
    ("ham", "thigh", "quarters", (0.130, 1.165, -0.740), (76.0, 0.0), (0.106, 0.140, 0.270)),
    ("thigh", "thigh", "quarters", (0.145, 1.110, -0.520), (72.0, 0.0), (0.110, 0.130, 0.230)),
    ("gaskin", "shin", "hind legs", (0.152, 0.815, -0.610), (-47.0, 0.0), (0.058, 0.085, 0.215)),
]
_MIDDLE = [
    ("face", "head", "head and neck", at(0.0, 0.270, -0.055), (47.0, 0.0), (0.067, 0.086, 0.250)),
    ("upper neck", "neck.3", "head and neck", (0.0, 1.810, 0.890), (-52.0, 0.0), (0.084, 0.155, 0.230)),
    ("lower neck", "neck.1", "head and neck", (0.0, 1.500, 0.675), (-54.0, 0.0), (0.122, 0.215, 0.310)),
    ("breast", "chest", "shoulders", (0.0, 1.140, 0.480), (70.0, 0.0), (0.190, 0.240, 0.225)),
    ("withers", "chest", "shoulders", (0.0, 1.420, 0.350), (-14.0, 0.0), (0.130, 0.200, 0.300)),
    ("barrel", "spine.2", "barrel", (0.0, 1.185, 0.100), (0.0, 0.0), (0.270, 0.325, 0.400)),
    ("belly", "spine.1", "barrel", (0.0, 1.235, -0.250), (-6.0, 0.0), (0.265, 0.285, 0.380)),
    ("croup", "hips", "quarters", (0.0, 1.330, -0.620), (10.0, 0.0), (0.165, 0.230, 0.250)),
]

_REACH = 1.6  # a little farther than muscles: the volumes melt into each other
_HEAD, _SIDES = ["head", "neck.3"], ["scapula.L", "scapula.R", "upper_arm.L", "upper_arm.R"]
_THIGHS = ["thigh.L", "thigh.R"]
# Ears and tail stay as they are in the mesh; the trunk lies under the shoulders' and thighs' skin too, and
# a thigh that swings forward lifts the flank.
_TERRITORIES = {"cheek L": _HEAD, "cheek R": _HEAD, "face": _HEAD, "upper neck": ["neck.2"] + _HEAD,
                "barrel": ["spine.1", "spine.2", "chest"] + _SIDES, "belly": ["hips", "spine.1", "spine.2"] + _THIGHS,
                "quarter L": ["hips", "spine.1", "thigh.L"], "quarter R": ["hips", "spine.1", "thigh.R"],
                "ham L": ["hips", "seat.L", "thigh.L"], "ham R": ["hips", "seat.R", "thigh.R"],
                "thigh L": ["hips", "spine.1", "spine.2", "thigh.L", "shin.L"],
                "thigh R": ["hips", "spine.1", "spine.2", "thigh.R", "shin.R"],
                "croup": ["hips", "spine.1"] + _THIGHS}



def rig():
    return rig_text("horse.glb", "replace", 3, GROUPS, LINKS, primitives(_LEFT, _MIDDLE, _TERRITORIES, _REACH), along_normals=True)
