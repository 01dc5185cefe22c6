# tests/blender/clips_test.py: numbers that a rig keys over a clip go by what the armature plays.
import json

import numpy
from tools import ASSETS, TOLERANCE, blender, check, height_of, main  # First: it finds the others.
from pose_clip import farthest, surfaces, write_at_rest

RIG = json.loads((ASSETS / "humanoid.rig.json").read_text())
END, LOW, HIGH = 0.8, 0.3, 1.9  # Keys from LOW at 0 s to HIGH at END.
RATE = 24
# Seconds into the clip at each label; None: the numbers as drawn.
EXPECTED = {
    "action": 7 / RATE, "between frames": 8.25 / RATE, "other clip": None, "own action": None, "copied action": 11 / RATE,
    "strip twice as long": 5 / RATE, "backwards": -14 / RATE, "second round": 4 / RATE, "held after its end": 0.99,
    "own action over a strip": 6 / RATE, "muted": None, "later rate of frames": 7 / RATE}


def with_amounts(path, amount, keys=None):
    rig = json.loads(json.dumps(RIG))
    rig["version"], rig["character"] = 2, str(ASSETS / "humanoid.glb")
    for muscle in rig["primitives"]:
        if keys is not None:
            muscle["animated"] = [{"parameter": "amount", "keys": [keys]}]
        elif amount != 1.0:
            muscle["amount"] = amount
    path.write_text(json.dumps(rig))
    return path


def test(folder):
    keys = {"clip": "Walk", "times": [0, END], "values": [LOW, HIGH], "interpolation": "linear"}
    rig = with_amounts(folder / "keyed.rig.json", 1.0, keys)
    write_at_rest(ASSETS / "humanoid.glb", folder / "rest.glb")
    blender(folder, "clips_in_blender.py", rig, folder / "rest.glb", folder)
    told = dict(numpy.load(folder / "told.npz"))
    length = float(told.pop("length"))
    labels = [str(label) for label in told["labels"]]
    check("all was tried", set(labels) == set(EXPECTED), labels)
    height = height_of(rig)
    for row, label in enumerate(labels):
        seconds = EXPECTED[label]
        if seconds is not None and seconds < 0:
            seconds += length
        amount = 1.0 if seconds is None else LOW + (HIGH - LOW) * min(seconds / END, 1.0)
        alone = {**told, "poses": told["poses"][[row, row]]}
        off = []
        for typed in (amount, amount - 0.1):
            typed_in = with_amounts(folder / "typed.rig.json", typed)
            made = surfaces(typed_in, ASSETS / "humanoid.glb", alone, folder, "--detail", "uniform", "--depth", 2)
            off.append(farthest(told["shown"][row:row + 1], made[:1]) / height)
        check("%s: amount %.3f, within %.1e H; with another one %.1e H" % (label, amount, *off),
              off[0] <= 1e-5 < TOLERANCE < off[1], off)


main(test)
