# tests/blender/joints_test.py: muscle joints with drivers are where the core's own keys put them.
import json

import numpy
from tools import ASSETS, blender, check, height_of, main, run  # First: it finds the others.
from pose_clip import CLIP, root_of, write_at_rest, write_clip

RIGS = (("humanoid-flex", "full"), ("humanoid-flex", "none"), ("horse-flex", "uniform"))
POSES = 20
NEAR = 1e-4  # Of the height.


def test(folder):
    asked, heights = [], {}
    for name, scale in RIGS:
        rig, character = ASSETS / (name + ".rig.json"), ASSETS / (name.split("-")[0] + ".glb")
        own = folder / (name + scale)
        own.mkdir()
        write_at_rest(character, own / "rest.glb")
        heights[str(own)] = height_of(rig)
        asked.append(str(own))
    (folder / "asked.json").write_text(json.dumps(asked))
    blender(folder, "joints_in_blender.py", "poses", folder / "asked.json", POSES)
    for (name, scale), own in zip(RIGS, map(folder.__class__, asked)):
        told = numpy.load(own / "told.npz")
        write_clip(ASSETS / (name.split("-")[0] + ".glb"), told, own / "poses.gltf")
        run("export", ASSETS / (name + ".rig.json"), "--clips", own / "poses.gltf", "--clip", CLIP,
            "--joint-scale", scale, "--joints", 48, "--depth", 1, "-o", own / "hero.glb")
    printed = blender(folder, "joints_in_blender.py", "joints", folder / "asked.json", POSES)
    for line in printed.splitlines():
        if not line.startswith("seen: "):
            continue
        found = json.loads(line[6:])
        height = heights[found["folder"]]
        skin, = [skin for skin in root_of(found["folder"] + "/hero.glb")[0]["skins"] if "extras" in skin]
        joints = sum(len(each["joints"]) for each in skin["extras"]["sinew"]["lines"])
        name, how = found["folder"].rsplit("/", 1)[1], found["how"]
        check("%s: %d joints in %d poses within %.1e H of their keys, moved by %.2f H; %s" % (
            name, found["joints"], found["poses"], found["off"] / height, found["moved"] / height, how),
              found["joints"] == joints > 1 and found["off"] < NEAR * height < 0.01 * height < found["moved"], found)
    check("all was tried", printed.count("seen: ") == 2 * len(RIGS), printed[-3000:])


main(test)
