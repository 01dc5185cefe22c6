# tests/export/blender_test.py: Blender plays what `sinew export` writes. Usage: blender_test.py PROGRAM ROOT CHARACTERS
"""At five moments of each of up to three clips every vertex that Blender shows lies where `sinew smooth` has it, within
the error that the export printed; of baked clips within the bound, and of point caches where it is. Left out (77) where Blender is not installed."""
import json
import math
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
from face_gltf import face_rig, write_face
from glb_reader import Glb
from live_surface import MOMENTS, compare, corners_of, height_of, longest_times, output, spread, surface
from simple_rig import simple_rig

MOST_CLIPS = 3
BAKED = {"demo.rig.json": "Walk", "humanoid.rig.json": "Dance", "horse.rig.json": "Gallop", "horse-flex.rig.json": "Walk"}
SLACK = 0.05  # % of the height: Blender keeps bones as head, tail and roll, in floats; joints on joints add up.


def blender(*arguments):
    """Debian's Blender takes the first Python on PATH for its own, which may be another one than Debian's."""
    environment = {**os.environ, "PATH": "/usr/bin:" + os.environ.get("PATH", "")}
    command = ["blender", "-b", "--factory-startup", "--python-exit-code", "3", *map(str, arguments)]
    return subprocess.run(command, env=environment, capture_output=True, text=True)


def missing():
    """Why nothing can be tried here, or None."""
    if not shutil.which("blender"):
        return "Blender is not installed"
    importer = "import numpy; numpy.bool = bool; import io_scene_gltf2"
    return "Blender has no numpy or no glTF importer" if blender("--python-expr", importer).returncode else None


def seen(file, asked, folder):
    """[clip, seconds, {object: places}] of the moments that are asked for."""
    (folder / "asked.json").write_text(json.dumps(asked))
    run = blender("--python", HERE / "in_blender.py", "--", file, folder / "asked.json", folder / "seen.json")
    assert run.returncode == 0, run.stdout + run.stderr
    return json.loads((folder / "seen.json").read_text())


def check_baked(program, source, clip, folder):
    """Within the bound at every baked frame looked at."""
    exported = Glb(folder / "out.glb")
    own = len(exported.json["nodes"])
    keys = longest_times(exported, next(a for a in exported.json["animations"] if a["name"] == clip), own)
    rate = (len(keys) - 1) / keys[-1]  # So that joints have a key in every baked frame.
    assert all(abs(i / rate - key) < 1e-4 for i, key in enumerate(keys)), "the keys of %s are not even" % clip
    bound = 0.1
    report = json.loads(output(program, "export", source, "--as", "baked", "--clip", clip, "--bound", bound,
                               "--fps", repr(rate), "--json", "-o", folder / "baked.glb"))
    assert report["targets"] > 2
    height, corners = height_of(program, source), corners_of(Glb(folder / "baked.glb"))
    for _, seconds, objects in seen(folder / "baked.glb", [[clip, spread(keys)]], folder):
        percent = compare(surface(program, source, clip, seconds, folder), corners, objects, height)
        print("  %-16s %7.3f s: %.3f %% of the height off, %.3f printed, baked with %d targets" %
              (clip, seconds, percent, report["error_percent_of_height"]["baked"]["max"], report["targets"]))
        assert percent <= bound + SLACK, "%s at %g s, baked" % (clip, seconds)


def check_cache(program, source, clip, ending, folder):
    """Blender's Mesh Cache modifier shows the live vertices."""
    file = folder / "cache.obj"
    report = json.loads(output(program, "export", source, "--as", "baked", "--clip", clip, "--json",
                               "-o", file.with_suffix(ending)))
    frames = [i * (report["frames"] - 2) // (MOMENTS - 1) for i in range(MOMENTS)]
    for _, seconds, objects in seen(file, [[clip, [frame / 30 for frame in frames]]], folder):
        output(program, "smooth", source, "--clip", clip, "--time", repr(seconds), "-o", folder / "live.obj")
        (shown,) = objects.values()
        live = [tuple(map(float, line.split()[1:4])) for line in (folder / "live.obj").read_text().splitlines()
                if line.startswith("v ")]
        assert len(shown) == len(live) == report["vertices"]
        percent = 100.0 / height_of(program, source) * max(map(math.dist, shown, live))
        print("  %-16s %7.3f s: %.5f %% of the height off, %s" % (clip, seconds, percent, ending))
        assert percent <= 1e-3, "%s at %g s, %s" % (clip, seconds, ending)
    file.with_suffix(ending).unlink()


def check(program, source, kind, folder):
    report = json.loads(output(program, "export", source, "--as", kind, "--json", "-o", folder / "out.glb"))
    printed = {clip["name"]: clip["max"] for clip in report["error_percent_of_height"]["clips"]}
    height, glb = height_of(program, source), Glb(folder / "out.glb")
    clips = [a for a in glb.json["animations"] if a.get("name") in printed][:MOST_CLIPS]
    corners = corners_of(glb)
    compared = 0
    own = len(glb.json["nodes"]) - report["line_joints"] - report["rigid_helpers"]
    asked = [[a["name"], spread(longest_times(glb, a, own))] for a in clips]
    for clip, seconds, objects in seen(folder / "out.glb", asked, folder):
        percent = compare(surface(program, source, clip, seconds, folder), corners, objects, height)
        print("  %-16s %7.3f s: %.3f %% of the height off, %.3f printed" % (clip, seconds, percent, printed[clip]))
        assert percent <= 1.05 * printed[clip] + SLACK, "%s at %g s" % (clip, seconds)
        compared += 1
    assert compared > 0, "nothing was compared"


def main():
    program, root, characters = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    reason = missing()
    if reason:
        print("left out: " + reason)
        return 77
    more = "MORE" in os.environ
    bundled = ("humanoid", "horse", "humanoid-flex", "horse-flex") if more else ("demo",)
    sources = [root / "assets" / (name + ".rig.json") for name in bundled]
    sources += [characters / name for name in ("Fox.glb", "greenman.glb", "robot.glb")] if more else []
    made = tempfile.TemporaryDirectory()
    face = pathlib.Path(made.name) / "face.rig.json"
    face.write_text(face_rig(pathlib.Path(write_face(face.with_name("face.glb"))).name))
    for source in [face, *sources]:
        if not source.exists():
            print("left out: no " + source.name)
            continue
        print(source.name)
        with tempfile.TemporaryDirectory() as folder:
            own = source
            if source.suffix != ".json":
                own = simple_rig(program.resolve(), source, pathlib.Path(folder))
            for kind in ("helpers", "skinned"):
                print("  as " + kind)
                check(program.resolve(), own, kind, pathlib.Path(folder))
            clip = BAKED.get(source.name)
            if clip:
                check_baked(program.resolve(), source, clip, pathlib.Path(folder))
                for ending in (".pc2", ".mdd"):
                    check_cache(program.resolve(), source, clip, ending, pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
