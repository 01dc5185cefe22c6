# tests/blender/window_test.py: the real window: a rig opened and posed there, undo, the tab, a picture.
"""SINEW_KEEP_PICTURES names a folder for the picture."""
import json
import os
import shutil

from tools import ASSETS, blender, check, main


def test(folder):
    for tool in ("xvfb-run", "xdotool"):
        if not shutil.which(tool):
            print("left out: %s is not installed" % tool)
            raise SystemExit(77)
    picture = folder / "window.png"
    printed = blender(folder, "window_in_blender.py", ASSETS / "humanoid-flex.rig.json", picture, window=True,
                      LIBGL_ALWAYS_SOFTWARE="1")
    if "left out: " in printed:
        print(next(line for line in printed.splitlines() if line.startswith("left out: ")))
        raise SystemExit(77)
    if kept := os.environ.get("SINEW_KEEP_PICTURES"):
        shutil.copy(picture, kept)
    found = [json.loads(line[6:]) for line in printed.splitlines() if line.startswith("seen: ")]
    for each in found:
        check(each["what"], each["holds"], each["seen"])
    check("all was tried", len(found) == 7, printed[-3000:])


main(test)
