# tests/blender/bake_test.py: rendered frames, bakes, shapes, colors; how fast it is.
import json
import pathlib

from tools import ASSETS, blender, check, main  # First: it finds the others.
from colored_glb import write_colored
from face_gltf import face_rig, write_face


def test(folder):
    face = folder / "face.rig.json"
    face.write_text(face_rig(pathlib.Path(write_face(folder / "face.glb")).name))
    write_colored(ASSETS / "humanoid.glb", folder / "humanoid.glb")
    rig = folder / "colored.rig.json"
    rig.write_text((ASSETS / "humanoid.rig.json").read_text())
    printed = blender(folder, "bake_in_blender.py", ASSETS / "humanoid.rig.json", face, rig, folder)
    found = [json.loads(line[6:]) for line in printed.splitlines() if line.startswith("seen: ")]
    for each in found:
        check(each["what"], each["holds"], each["seen"])
    left_out = [line for line in printed.splitlines() if line.startswith("left out: ")]
    print("\n".join(left_out))
    check("all was tried", len(found) + len(left_out) == 16, len(found))


main(test)
