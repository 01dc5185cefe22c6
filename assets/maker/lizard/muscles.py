# assets/maker/lizard/muscles.py: the lizard's rig: ellipsoids on its bones; the right ones mirror the left.
import json
import math

from .. import vec
from ..names import mirror_name
from .skeleton import ARM, ORIGIN, along_arm

_TO_ARM = vec.turn((0, 0, 1), math.degrees(math.atan2(ARM[1], ARM[0])))  # primitive x along the left arm

# name, bone, group, centre in the bind pose, rotation, radii (metres)
_LEFT = [
    ("thigh", "thigh", "legs", (0.116, 0.585, 0.026), vec.euler(z=2.0), (0.078, 0.125, 0.088)),
    ("calf", "shin", "legs", (0.117, 0.270, -0.030), vec.euler(x=4.0), (0.052, 0.090, 0.050)),
    ("glute", "hips", "torso", (0.086, 0.735, -0.074), vec.euler(), (0.074, 0.076, 0.068)),
    ("chest", "chest", "torso", (0.060, 1.124, 0.056), vec.euler(z=-10.0), (0.084, 0.050, 0.056)),
    ("shoulder", "upper_arm", "arms", vec.add(along_arm(0.045), (0.010, 0.020, 0.0)), _TO_ARM, (0.076, 0.058, 0.068)),
    ("biceps", "upper_arm", "arms", vec.add(along_arm(0.155), (0.006, 0.006, 0.014)), _TO_ARM, (0.064, 0.044, 0.048)),
    ("forearm", "forearm", "arms", along_arm(0.310), _TO_ARM, (0.072, 0.045, 0.047)),
]
_MIDDLE = [
    ("tail root", "tail.1", "torso", (0.0, 0.715, -0.200), vec.euler(x=-24.0), (0.076, 0.068, 0.115)),
]


def _primitive(name, bone, group, centre, rotation, radii, twin):
    entry = {"name": name, "bone": bone, "group": group, "kind": "ellipsoid",
             "center": [_short(c) for c in vec.sub(centre, ORIGIN[bone])],
             "rotation": [_short(c) for c in _unit(rotation)],
             "radii": list(radii), "reach": 1.4142135, "sign": 1}
    if twin:
        entry["mirror"] = twin
    return entry


def _short(value):
    return round(value, 7) + 0.0  # + 0.0: no minus zero


def _unit(q):
    n = math.sqrt(sum(c * c for c in q))
    return tuple(c / n for c in q)


def rig_text():
    primitives = []
    for name, bone, group, centre, rotation, radii in _LEFT:
        left = bone + ".L" if bone + ".L" in ORIGIN else bone
        primitives.append(_primitive(name + " L", left, group, centre, rotation, radii, name + " R"))
        flipped = (rotation[0], -rotation[1], -rotation[2], rotation[3])
        across = (-centre[0], centre[1], centre[2])
        primitives.append(_primitive(name + " R", mirror_name(left), group, across, flipped, radii, name + " L"))
    primitives += [_primitive(*row, "") for row in _MIDDLE]
    head = {"format": "sinew-rig", "version": 1, "character": "demo.glb",
            "surface": {"mode": "swell", "iso": 0.25, "skin_blend": 0.04},
            "smoothing": {"depth": 3, "patch": "pn"},
            "groups": [{"name": "legs"}, {"name": "torso"}, {"name": "arms"}],
            "links": [["legs", "torso"], ["torso", "arms"]]}
    lines = ["  %s: %s" % (json.dumps(key), json.dumps(value)) for key, value in head.items()]
    rows = ",\n".join("    " + json.dumps(p) for p in primitives)
    return "{\n" + ",\n".join(lines) + ',\n  "primitives": [\n' + rows + "\n  ]\n}\n"
