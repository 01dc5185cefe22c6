# tests/gui/letters.py: names in many scripts, one of them without a font, are drawn, typed and written.
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import driver
from clip_gltf import write_glb
from glb_reader import Glb

NOTO = pathlib.Path("/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc")
NAMES = {
    "hips": "センター", "spine": "上半身", "chest": "胸", "neck": "首", "head": "頭", "clavicle.L": "左肩", "upper_arm.L": "左腕",
    "forearm.L": "左ひじ", "hand.L": "左手首", "thigh.L": "大腿.L", "shin.L": "小腿.L", "foot.L": "脚踝.L", "toe.L": "발가락.L",
    "clavicle.R": "어깨.R", "upper_arm.R": "ذراع علوي", "forearm.R": "ساعد.R", "hand.R": "כף יד", "thigh.R": "Μηρός",
    "shin.R": "Голень", "foot.R": "እግር.R", "toe.R": "bras é ø",
}
UNKNOWN = "እግር.R"  # Ethiopic: neither Inter nor DejaVu nor Noto CJK has it.


def character(t):
    glb = Glb(t.assets / "humanoid.glb")
    for index in glb.json["skins"][0]["joints"]:
        node = glb.json["nodes"][index]
        node["name"] = NAMES[node["name"]]
    folder = t.folder / "モデル"
    folder.mkdir()
    write_glb(glb.json, glb.data, folder / "人体.glb")
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


def drawn_in_the_tree(t, editor):
    """As wide and high as the letters are: a question mark or a square is 8 wide, Chinese letters are 13."""
    state = editor.settle()
    for bone, letters in (("左手首", 3), ("上半身", 3), ("左ひじ", 3)):
        box = state["widgets"]["outliner/bone/" + bone]
        pixels, wide = editor.pixels(box, "gray"), round(box[2])
        rows = [pixels[i:i + wide] for i in range(0, len(pixels), wide)]
        left, right, top, bottom = max(words(rows), key=lambda word: word[1] - word[0])  # Beside it there are marks.
        size = right - left + 1, bottom - top + 1
        t.check("%s is drawn by its letters" % bone, 13 * letters - 5 <= size[0] <= 13 * letters + 3 and 11 <= size[1] <= 15, size)


def typed(editor):
    editor.palette("頭", "bone/頭")
    editor.wait_until("the bone", lambda s: s["document"]["bone"] == "頭")
    editor.click("outliner/muscle/上腕二頭筋")
    editor.wait_until("a muscle", lambda s: s["document"]["selection"] == ["上腕二頭筋"])
    editor.fill("inspector/name", "三角")
    editor.wait_until("another name", lambda s: s["document"]["selection"] == ["三角"])


def letters(t):
    rig = character(t)
    before = json.loads(rig.read_text())
    editor = t.edit(rig)
    editor.wait_until("its bones", lambda s: "センター" in s["bones"] and "outliner/bone/センター" in s["widgets"])
    if NOTO.exists():
        drawn_in_the_tree(t, editor)
    else:
        print("left out: Chinese, Japanese and Korean letters, as fonts-noto-cjk is not installed")
    typed(editor)
    rig = editor.saved_rig()
    before["primitives"][0]["name"] = "三角"
    for what in ("name", "bone", "group"):
        t.check_equal("every %s is written as it is" % what, [p[what] for p in rig["primitives"]],
                      [p[what] for p in before["primitives"]])
    t.check_equal("and so are the groups", rig["groups"], before["groups"])
    t.check_equal("quits", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("letters", letters))
