# tests/blender/tools.py: what the tests of the Blender add-on share, outside Blender.
"""The environment names the module's build (PYTHONPATH), the add-on (SINEW_ADDON), the command line (SINEW_PROGRAM)."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ASSETS = ROOT / "assets"
CHARACTERS = ROOT.parent / "shared" / "characters"
ADDON = os.environ.get("SINEW_ADDON", "")
PROGRAM = os.environ.get("SINEW_PROGRAM", "")
sys.path += [str(ROOT / "tests" / "support"), str(ROOT / "tests" / "export")]
TOLERANCE = 1e-4  # Of the height.


def environment(home, **more):
    """Preferences of its own. Debian's Blender takes the first Python on PATH for its own, which may be another one."""
    return {**os.environ, "HOME": str(home), "XDG_CONFIG_HOME": str(home / "config"), "PYTHONDONTWRITEBYTECODE": "1",
            "PATH": "/usr/bin:" + os.environ.get("PATH", ""), **more}


def blender(home, script, *arguments, window=False, **more):
    """What a script prints that Blender runs; arguments are what it finds behind --. If it fails, the test does."""
    command = ["blender", *([] if window else ["-b"]), "--factory-startup", "--python-exit-code", "3", "--python",
               str(HERE / script), "--", *map(str, arguments)]
    if window:
        command = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", *command]
    done = subprocess.run(command, env=environment(home, **more), capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit("FAILED: %s exits %d\n%s" % (script, done.returncode, (done.stdout + done.stderr)[-9000:]))
    return done.stdout


def run(*words):
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit("FAILED: %s\n%s" % (" ".join(map(str, words)), done.stderr))
    return done.stdout


def missing():
    """Why nothing can be tried here, or None."""
    if not shutil.which("blender"):
        return "Blender is not installed"
    with tempfile.TemporaryDirectory() as home:
        probe = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "3", "--python-expr",
                                "import numpy; numpy.bool = bool; import io_scene_gltf2, sinew"],
                               env=environment(pathlib.Path(home)), capture_output=True)
    if probe.returncode:
        return "Blender has no numpy, no glTF importer, or another Python than the module is for"
    return None


def check(what, holds, seen=""):
    if not holds:
        raise SystemExit("FAILED: %s; seen: %s" % (what, seen))
    print("ok: " + what, flush=True)


def main(test):
    """Calls it with a folder of its own; 77 where nothing can be tried."""
    reason = missing()
    if reason:
        print("left out: " + reason)
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        test(pathlib.Path(folder))


def height_of(rig):
    return json.loads(run("inspect", rig, "--json"))["height"]
