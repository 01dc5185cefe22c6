# tests/limits/memcheck.py: verbs and tests under Valgrind. Usage: memcheck.py PROGRAM [TESTS...]
"""Not a test of ctest: it says nothing new beside AddressSanitizer but for reads of memory that was never written. Each file
written must also have the bytes of a run without Valgrind, on a small character. Of test programs those tests are run that need
no real characters. Exit status 1 for an error, a leak, other bytes or a test that fails."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from hostile_post import Post, rig

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())  # Runs have other working directories.
VALGRIND = ["valgrind", "-q", "--error-exitcode=9", "--leak-check=full", "--show-leak-kinds=definite",
            "--errors-for-leak-kinds=definite", "--num-callers=30"]
# Valgrind stops at RDTSCP where the processor does not list it; Highway asks for the time with it as the program begins.
TIMER = "namespace hwy::platform { unsigned long TimerResolution() { return 1; } }\n"
JOBS = (
    ["inspect", "a.rig.json", "--json"],
    ["smooth", "a.rig.json", "--clip", "bend", "--time", "0.5", "--depth", "2", "-o", "one.obj"],
    ["smooth", "a.rig.json", "--depth", "2", "-o", "one.ply"],
    ["export", "a.rig.json", "--as", "skinned", "--depth", "1", "-o", "skinned.glb"],
    ["export", "a.rig.json", "--as", "baked", "--clip", "bend", "--fps", "4", "--depth", "1", "-o", "baked.glb"],
    ["retarget", "a.rig.json", "post.glb", "-o", "again.rig.json"],
    ["pack", "a.rig.json", "-o", "a.sinew"],
    ["check", "a.rig.json"],
)


def preload(folder):
    if re.search(r"\brdtscp\b", pathlib.Path("/proc/cpuinfo").read_text()):
        return {}
    (folder / "timer.cpp").write_text(TIMER)
    library = folder / "timer.so"
    subprocess.run(["c++", "-std=c++20", "-shared", "-fPIC", "-o", str(library), str(folder / "timer.cpp")], check=True)
    return {"LD_PRELOAD": str(library)}


def written(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def run(place, name, command, words, extra):
    """In a folder of its own: what was run, and the files that lie there after it."""
    folder = place / name
    folder.mkdir()
    (folder / "post.glb").write_bytes(Post().glb())
    (folder / "a.rig.json").write_text(rig("post.glb"))
    ended = subprocess.run(command + [PROGRAM] + words, cwd=folder, env=dict(os.environ, **extra), capture_output=True, text=True)
    return ended, written(folder)


def tests_under_valgrind(program, extra):
    """Whether all is well. The filter leaves out what is big: real characters and what counts allocations or seconds."""
    began = time.monotonic()
    command = VALGRIND + [program, "--gtest_brief=1", "--gtest_filter=-Real*:*Allocat*"]
    ended = subprocess.run(command, env=dict(os.environ, **extra), capture_output=True, text=True)
    said = ended.stdout + ended.stderr
    passed = re.search(r"PASSED  \] (\d+)", said)
    sound = ended.returncode == 0 and "==" not in ended.stderr
    print("%-18s exit %d, %s tests passed, %s, %.0f s" % (pathlib.Path(program).name, ended.returncode, passed.group(1) if passed else "no",
                                                        "0 errors" if sound else "ERRORS", time.monotonic() - began), flush=True)
    if not sound:
        print(said)
    return sound


def main():
    if not shutil.which("valgrind"):
        print("left out: valgrind is not installed")
        return 77
    bad = 0
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        extra = preload(place)
        for number, words in enumerate(JOBS):
            plain, expected = run(place, "plain%d" % number, [], words, {})
            checked, found = run(place, "checked%d" % number, VALGRIND, words, extra)
            sound = checked.returncode == plain.returncode and "==" not in checked.stderr
            same = found == expected and checked.stdout == plain.stdout
            bad += not (sound and same)
            print("%-9s exit %d, %s, %s" % (words[0], checked.returncode, "0 errors" if sound else "ERRORS",
                                            "same bytes" if same else "OTHER BYTES"), flush=True)
            if not sound:
                print(plain.stderr + checked.stderr)
        for program in sys.argv[2:]:
            bad += not tests_under_valgrind(program, extra)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
