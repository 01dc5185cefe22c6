# tests/gui/letters.py: names in Japanese, Chinese, Korean, Arabic, Hebrew, Greek and Cyrillic, and in a script that no font
# has.
# Usage: letters.py PROGRAM ROOT OUT CHARACTERS
import json
import pathlib
import subprocess
import sys

import driver
from opening import glb_of, parts_of

NOTO = pathlib.Path("/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc")
NAMES = {
    "hips": "センター", "spine": "上半身", "chest": "胸", "neck": "首", "head": "頭", "clavicle.L": "左肩", "upper_arm.L": "左腕",
    "forearm.L": "左ひじ", "hand.L": "左手首", "thigh.L": "大腿.L", "shin.L": "小腿.L", "foot.L": "脚踝.L", "toe.L": "발가락.L",
    "clavicle.R": "어깨.R", "upper_arm.R": "ذراع علوي", "forearm.R": "ساعد.R", "hand.R": "כף יד", "thigh.R": "Μηρός",
    "shin.R": "Голень", "foot.R": "እግር.R", "toe.R": "bras é ø",
}
UNKNOWN = "እግር.R"  # Ethiopic: neither Inter nor DejaVu nor Noto CJK has it.


def character(t):
    document, binary = parts_of((t.assets / "humanoid.glb").read_bytes())
    for index in document["skins"][0]["joints"]:
        node = document["nodes"][index]
        node["name"] = NAMES[node["name"]]
    for clip, name in zip(document["animations"], ("歩く", "رقصة", "걷기")):
        clip["name"] = name
    folder = t.folder / "モデル"
    folder.mkdir()
    (folder / "人体.glb").write_bytes(glb_of(document, binary))
    (folder / "شخصية.glb").write_bytes(glb_of(document, binary))
    muscle = {"center": [0, 0.1, 0], "radii": [0.05, 0.12, 0.05], "reach": 0.05}
    rig = folder / "人体.rig.json"
    rig.write_text(json.dumps({
        "format": "sinew-rig", "version": 1, "character": "人体.glb",
        "groups": [{"name": "腕の筋肉"}, {"name": "عضلات"}, {"name": "엉덩이"}],
        "links": [["腕の筋肉", "عضلات"]],
        "primitives": [
            {"name": "上腕二頭筋", "bone": NAMES["upper_arm.L"], "group": "腕の筋肉", **muscle},
            {"name": "عضلة ذات الرأسين", "bone": NAMES["upper_arm.R"], "group": "عضلات", **muscle},
            {"name": "ጡንቻ", "bone": UNKNOWN, "group": "엉덩이", **muscle}]}, ensure_ascii=False))
    return rig


def ink(t, picture, box):
    """(left, right, top, bottom) of what is bright in a rectangle of a screenshot, from its corner; None: nothing is."""
    x, y, width, height = (round(v) for v in box)
    done = subprocess.run(["convert", str(picture), "-crop", "%dx%d+%d+%d" % (width, height, x, y), "+repage", "-colorspace",
                           "gray", "-depth", "8", "gray:-"], capture_output=True, check=True, timeout=60)
    lit = [(i % width, i // width) for i, level in enumerate(done.stdout) if level > 110]
    if not lit:
        return None
    xs, ys = [p[0] for p in lit], [p[1] for p in lit]
    return min(xs), max(xs), min(ys), max(ys)


def name_box(state, bone):
    """Where the name is in the row: behind the icon."""
    x, y, width, height = state["widgets"]["outliner/bone/" + bone]
    return x + NAME_FROM, y, width - NAME_FROM - 60, height


NAME_FROM = 34


def letters(t):
    if not NOTO.exists():
        print("left out: Chinese, Japanese and Korean, as fonts-noto-cjk is not installed")
    rig = character(t)
    editor = t.edit(rig)
    state = editor.wait_until("its bones", lambda s: "センター" in s["bones"])
    editor.tap("space", "a pause", lambda s: not s["playing"])
    told = [m for m in state["messages"] if "shown by number" in m]
    t.check("what no font has is told once", len(told) == 1, state["messages"])
    if NOTO.exists():
        t.check("no package is named that is there", "fonts-noto-cjk" not in told[0], told)
    editor.wait_until("all frames to be drawn", lambda s: "outliner/bone/センター" in s["widgets"])
    editor.settle()
    editor.screenshot(t.out / "letters.png")


if __name__ == "__main__":
    sys.exit(driver.run("letters", letters))
