# tests/export/three_test.py: three.js plays what `sinew export` writes. Usage: three_test.py PROGRAM ROOT CHARACTERS
"""At five moments of up to three clips every vertex that three shows lies where `sinew smooth` has it, within the error
that the export printed. With Blender at hand, also a corrective shape that Blender has made and an elbow drives. Left out
(77) where node or npm's three is not at hand."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
sys.path.insert(0, str(HERE))
import blender_test
from face_gltf import face_rig, write_face
from glb_reader import Glb
from live_surface import compare, corners_of, height_of, longest_times, output, spread, surface
from simple_rig import simple_rig

THREE = "0.187.0"
MOST_CLIPS = 3
# Weights are fitted vertex by vertex in every clip, and three.js plays few vertices as it plays many. The skinned humanoid and the face
# have the detail of their rigs.
DEPTHS = {("humanoid-flex", "helpers"): 2, ("RobotExpressive", "skinned"): 1, ("RobotExpressive", "helpers"): 1}
SLACK = 1e-3  # % of the height: floats.


def modules(folder):
    """A folder with in_three.mjs, what it needs, and npm's three; or None."""
    if not shutil.which("node") or not shutil.which("npm"):
        return None
    try:
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, "three@" + THREE], check=True,
                       capture_output=True, timeout=60)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    for file in ("in_three.mjs", "without_images.mjs"):
        shutil.copy(HERE / file, folder)
    return folder


def check(program, source, kind, folder, three):
    file = folder / "out.glb"
    depth = None if "MORE" in os.environ else DEPTHS.get((source.name.split(".")[0], kind))
    detail = ["--depth", depth] if depth else []
    report = json.loads(output(program, "export", source, "--as", kind, *detail, "--json", "-o", file))
    printed = {clip["name"]: clip["max"] for clip in report["error_percent_of_height"]["clips"]}
    height, glb = height_of(program, source), Glb(file)
    corners = corners_of(glb)
    clips = [a for a in glb.json["animations"] if a.get("name") in printed][:MOST_CLIPS]
    own = len(glb.json["nodes"]) - report["line_joints"] - report["rigid_helpers"]
    (folder / "asked.json").write_text(json.dumps([[a["name"], spread(longest_times(glb, a, own))] for a in clips]))
    subprocess.run(["node", three / "in_three.mjs", file, folder / "asked.json", folder / "seen.json"], check=True)
    for clip, seconds, objects in json.loads((folder / "seen.json").read_text()):
        percent = compare(surface(program, source, clip, seconds, folder, *detail), corners, objects, height)
        print("  %-16s %7.3f s: %.3f %% of the height off, %.3f printed" % (clip, seconds, percent, printed[clip]))
        assert percent <= 1.05 * printed[clip] + SLACK, "%s at %g s" % (clip, seconds)
    assert clips, "nothing was compared"


def corrective(program, root, folder):
    """The bundled humanoid with a shape that Blender has made, driven by its elbow."""
    made = folder / "corrected.glb"
    run = blender_test.blender("--python", HERE / "corrective_in_blender.py", "--", root / "assets" / "humanoid.glb", made)
    assert run.returncode == 0, run.stdout + run.stderr
    assert json.loads(output(program, "inspect", made, "--json"))["morph_targets"] == ["elbow.L"]
    rig = json.loads((root / "assets" / "humanoid-flex.rig.json").read_text())
    driver = {"input": {"kind": "bend", "bone": "forearm.L"}, "curve": [[0, 0], [100, 1]]}
    rig.update(character="corrected.glb", version=2,
               shapes=[{"name": "elbow.L", "weight": 0, "animated": [{"parameter": "weight", "drivers": [driver]}]}])
    rig["smoothing"].update(detail="uniform", depth=1)
    (folder / "corrected.rig.json").write_text(json.dumps(rig))
    return folder / "corrected.rig.json"


def main():
    program, root, characters = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        three = modules(folder / "npm")
        if three is None:
            print("left out: npm's three is not at hand")
            return 77
        face = folder / "face.rig.json"
        face.write_text(face_rig(pathlib.Path(write_face(folder / "face.glb")).name))
        sources = [face, root / "assets" / "humanoid-flex.rig.json"]
        robot = characters / "RobotExpressive.glb"
        if robot.exists():
            sources.append(simple_rig(program, robot, folder))
        else:
            print("left out: no " + robot.name)
        missing = blender_test.missing()
        if missing:
            print("left out, the corrective shape: " + missing)
        else:
            sources.append(corrective(program, root, folder))
        for source in sources:
            for kind in ("skinned", "helpers"):
                print(source.name, "as", kind)
                check(program, source, kind, folder, three)
    return 0


if __name__ == "__main__":
    sys.exit(main())
