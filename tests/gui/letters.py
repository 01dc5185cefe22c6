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
    muscle = {"center": [0, 0.1, 0], "radii": [0.05, 0.12, 0.05], "reach": 1.5}
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


def brightness(picture, box):
    """Rows of grey levels of a rectangle of a screenshot."""
    x, y, width, height = (round(v) for v in box)
    done = subprocess.run(["convert", str(picture), "-crop", "%dx%d+%d+%d" % (width, height, x, y), "+repage", "-colorspace",
                           "gray", "-depth", "8", "gray:-"], capture_output=True, check=True, timeout=60)
    return [done.stdout[i:i + width] for i in range(0, width * height, width)]


def words(rows, apart=5):
    """(left, right, top, bottom) of what is bright, parted where so many columns are dark."""
    found = []
    for x in range(len(rows[0])):
        lit = [y for y, row in enumerate(rows) if row[x] > 100]
        if not lit:
            continue
        if not found or x - found[-1][1] > apart:
            found.append([x, x, lit[0], lit[-1]])
        left, _, top, bottom = found[-1]
        found[-1] = [left, x, min(top, lit[0]), max(bottom, lit[-1])]
    return found


def name_on_screen(state, picture, bone):
    """Width and height of the name in the row of a bone that has no fold mark open: the widest of what is bright there."""
    rows = brightness(picture, state["widgets"]["outliner/bone/" + bone])
    left, right, top, bottom = max(words(rows), key=lambda word: word[1] - word[0])
    return right - left + 1, bottom - top + 1


def in_the_tree(t, editor):
    state = editor.settle()
    picture = t.out / "letters.png"
    editor.screenshot(picture)
    if not NOTO.exists():
        return
    for bone, letters in (("左手首", 3), ("上半身", 3), ("左ひじ", 3)):
        width, height = name_on_screen(state, picture, bone)
        # A question mark or a square is 8 wide; Chinese letters are 13 and nothing of them is cut off.
        t.check("%s is as wide as its letters" % bone, 13 * letters - 5 <= width <= 13 * letters + 3, (width, height))
        t.check("... and as high", 11 <= height <= 15, (width, height))


def typed(t, editor):
    """Found by letters that are typed, shown by letters that nobody has seen before."""
    editor.palette("頭", "bone/頭")
    editor.wait_until("the bone", lambda s: s["document"]["bone"] == "頭" and not s["camera_moving"])
    editor.palette("bone 20", "bone/" + UNKNOWN)
    editor.wait_until("the bone by its number", lambda s: s["document"]["bone"] == UNKNOWN and not s["camera_moving"])
    editor.palette("muscle 3", "muscle/ጡንቻ")
    editor.wait_until("the muscle by its number", lambda s: s["document"]["selection"] == ["ጡንቻ"] and not s["camera_moving"])
    editor.click("outliner/muscle/上腕二頭筋")
    editor.wait_until("a muscle", lambda s: s["document"]["selection"] == ["上腕二頭筋"])
    editor.fill("inspector/name", "三角筋")
    editor.wait_until("another name", lambda s: s["document"]["selection"] == ["三角筋"])
    editor.settle()
    editor.screenshot(t.out / "letters_typed.png")


def in_lists(t, editor):
    editor.click("timeline/clip")
    editor.wait_until("the clips", lambda s: "timeline/clip/2" in s["widgets"])
    editor.settle()
    editor.screenshot(t.out / "letters_clips.png")
    editor.key("Escape")
    editor.wait_until("no list", lambda s: "timeline/clip/2" not in s["widgets"])
    editor.tap("ctrl+o", "the open dialog", lambda s: s["dialog"] == "open" and "dialog/entry/شخصية.glb" in s["widgets"])
    editor.settle()
    editor.screenshot(t.out / "letters_files.png")
    editor.tap("Escape", "no dialog", lambda s: s["dialog"] == "")


def letters(t):
    if not NOTO.exists():
        print("left out: Chinese, Japanese and Korean, as fonts-noto-cjk is not installed")
    rig = character(t)
    before = json.loads(rig.read_text())
    editor = t.edit(rig)
    state = editor.wait_until("its bones", lambda s: "センター" in s["bones"] and "outliner/bone/センター" in s["widgets"])
    editor.tap("space", "a pause", lambda s: not s["playing"])
    told = [m for m in state["messages"] if "shown by number" in m]
    t.check("what no font has is told once", len(told) == 1, state["messages"])
    if NOTO.exists():
        t.check("no package is named that is there", "fonts-noto-cjk" not in told[0], told)
    if "messages/hide" in state["widgets"]:
        editor.click("messages/hide")
    in_the_tree(t, editor)
    typed(t, editor)
    in_lists(t, editor)
    rig = editor.saved_rig()
    before["primitives"][0]["name"] = "三角筋"
    for what in ("name", "bone", "group"):
        t.check_equal("every %s is written as it is" % what, [p[what] for p in rig["primitives"]],
                      [p[what] for p in before["primitives"]])
    t.check_equal("and so are the groups", rig["groups"], before["groups"])
    t.check_equal("quits", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("letters", letters))
