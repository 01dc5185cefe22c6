# tests/blender/motion_test.py: keys, IK, another action, undo, two characters, a hidden armature, a saved file.
import json

import numpy
from tools import ASSETS, TOLERANCE, blender, check, height_of, main  # First: it finds the others.
from pose_clip import farthest, surfaces, write_at_rest

RIG = ASSETS / "humanoid.rig.json"
EXPECTED = {"keyed", "IK target", "second action", "undo", "redo", "two characters: the first",
            "two characters: the second", "hidden armature", "object moved", "another scene", "saved and opened",
            "linked", "override", "local, the armature an override",
            "uniform detail again", "renamed", "its file is back"}


def test(folder):
    write_at_rest(ASSETS / "humanoid.glb", folder / "rest.glb")
    printed = blender(folder, "motion_in_blender.py", RIG, folder / "rest.glb", folder)
    told = numpy.load(folder / "told.npz")
    labels = [str(label) for label in told["labels"]]
    made = surfaces(RIG, ASSETS / "humanoid.glb", told, folder, "--detail", "uniform", "--depth", 2)
    for label in dict.fromkeys(labels):
        rows = [row for row, each in enumerate(labels) if each == label]
        off = max(farthest(told["shown"][row:row + 1], made[row:row + 1]) for row in rows) / height_of(RIG)
        moved = numpy.linalg.norm(told["shown"][rows[0]] - told["shown"][labels.index("keyed")], axis=1).max()
        check("%s: %d poses within %.1e H" % (label, len(rows), off),
              off <= TOLERANCE and (moved > 0 or label == "keyed"), off)
    check("all was tried", set(labels) == EXPECTED, set(labels) ^ EXPECTED)
    for line in printed.splitlines():
        if line.startswith("seen: "):
            found = json.loads(line[6:])
            check(found["what"], found["holds"], found["seen"])


main(test)
