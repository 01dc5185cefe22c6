# tests/blender/poses_test.py: random poses made in Blender: the surface is where `sinew smooth` has it.
import json
import os
import pathlib
import subprocess
import sys

import numpy
from tools import ASSETS, CHARACTERS, ROOT, TOLERANCE, blender, check, height_of, main  # First: it finds the others.
from face_gltf import face_rig, write_face
from pose_clip import farthest, surfaces, write_at_rest

MORE = "MORE" in os.environ
BUNDLED = ("humanoid-flex", "horse", "demo", "tangle", "wrapped") if MORE else ("demo",)
REAL = ("Fox.glb", "greenman.glb", "robot.glb", "cesium_man.gltf", "RobotExpressive.glb", "Trex.glb") if MORE else ()
POSES = 20 if MORE else 3


def rigs(folder):
    face = folder / "face.rig.json"
    face.write_text(face_rig(pathlib.Path(write_face(folder / "face.glb")).name))
    made = [face] + [ASSETS / (name + ".rig.json") for name in BUNDLED]
    for name in REAL:
        if (CHARACTERS / name).exists():
            made.append(folder / (name + ".rig.json"))
            rule = ROOT / "examples" / "python" / "muscles_by_rule.py"
            subprocess.run([sys.executable, "-B", rule, CHARACTERS / name, made[-1]], check=True, capture_output=True)
        else:
            print("left out: no " + name)
    return made


def test(folder):
    asked, characters = [], []
    for number, rig in enumerate(rigs(folder)):
        character = (rig.parent / json.loads(rig.read_text())["character"]).resolve()
        rest = folder / ("rest%d%s" % (number, character.suffix))
        write_at_rest(character, rest)
        asked.append([str(rig), str(rest), str(folder / ("told%d.npz" % number))])
        characters.append((rig, character))
    (folder / "asked.json").write_text(json.dumps(asked))
    blender(folder, "poses_in_blender.py", folder / "asked.json", POSES)
    for (rig, character), (_, _, out) in zip(characters, asked):
        told = numpy.load(out)
        made = surfaces(rig, character, told, folder, "--detail", "uniform", "--depth", 2)
        off = farthest(told["shown"], made) / height_of(rig)
        moved = numpy.linalg.norm(told["shown"] - told["shown"][0], axis=2).max() / height_of(rig)
        check("%s: %d poses, %d vertices within %.1e H, moved by %.2f H" % (
            rig.name, len(told["shown"]), told["shown"].shape[1], off, moved),
              off <= TOLERANCE and moved > 0.05 and len(told["shown"]) == POSES, off)


main(test)
