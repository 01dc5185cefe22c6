# tests/limits/kill_test.py: `sinew` killed at any moment leaves old or new files. Usage: kill_test.py PROGRAM [KILLS]
"""Each verb writes two versions of its files in turn, over each other, and is killed by SIGKILL at random moments, late ones
more often: that is when it writes. Every file, and every NAME~ beside it, must be one of the two versions, whole."""
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from hostile_post import Post, rig

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())  # Runs have other working directories.
KILLS = int(sys.argv[2]) if len(sys.argv) > 2 else 40
VERSIONS = ("1", "3")


def jobs():
    """Name -> command for a version, and the files it writes."""
    return {
        "a skinned .gltf": (lambda v: ["export", "a.rig.json", "--as", "skinned", "--depth", v, "-o", "s.gltf"], ["s.gltf", "s.bin"]),
        "a baked .glb": (lambda v: ["export", "a.rig.json", "--as", "baked", "--clip", "bend", "--fps", "4", "--depth", v,
                                    "-o", "b.glb"], ["b.glb"]),
        "an .obj": (lambda v: ["smooth", "a.rig.json", "--depth", v, "-o", "o.obj"], ["o.obj"]),
        "a rig": (lambda v: ["retarget", "a.rig.json" if v == "1" else "b.rig.json", "post.glb", "-o", "r.rig.json"],
                  ["r.rig.json"]),
        "a farm job": (lambda v: ["farm", "smooth", "a.rig.json", "--depth", v, "-o", "f.ply", "--to", "commands",
                                  "--job", "job.txt"], ["job.txt"]),
    }


def start(folder, words):
    return subprocess.Popen([PROGRAM, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def whole(folder, words, names):
    """The files of a run that nobody kills, and its seconds."""
    began = time.monotonic()
    run = start(folder, words)
    _, said = run.communicate()
    assert run.returncode == 0, (words, said)
    return {name: (folder / name).read_bytes() for name in names}, time.monotonic() - began


def main():
    dice = random.Random(3)
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        (folder / "post.glb").write_bytes(Post().glb())
        (folder / "a.rig.json").write_text(rig("post.glb"))
        (folder / "b.rig.json").write_text(rig("post.glb", radius=0.5))
        known = {}
        for name, (command, files) in jobs().items():
            made = [whole(folder, command(version), files) for version in VERSIONS + VERSIONS]
            assert made[0][0] != made[1][0], name + ": both versions are the same"
            known[name] = ([each for each, _ in made[:2]], min(seconds for _, seconds in made))
        bad = killed = replaced = 0
        for kill in range(KILLS):
            name = list(known)[kill % len(known)]
            command, files = jobs()[name]
            versions, seconds = known[name]
            before = {file: (folder / file).read_bytes() for file in files}
            run = start(folder, command(dice.choice(VERSIONS)))
            time.sleep(seconds * dice.random() ** 0.5)
            run.send_signal(signal.SIGKILL)
            run.communicate()
            killed += run.returncode == -signal.SIGKILL
            for file in files:
                allowed = [version[file] for version in versions]
                for path in (folder / file, folder / (file + "~")):
                    if path.exists() and path.read_bytes() not in allowed:
                        print("%s: %s is no whole version after kill %d" % (name, path.name, kill))
                        bad += 1
                replaced += (folder / file).read_bytes() != before[file]
        left = [path for path in folder.iterdir() if path.name.startswith(".sinew-")]
        print("%d runs, %d of them killed, %d files replaced, %d files without a place left, %d not whole"
              % (KILLS, killed, replaced, len(left), bad))
        return 1 if bad or not killed else 0


if __name__ == "__main__":
    sys.exit(main())
