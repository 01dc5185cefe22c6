# tests/gui/layers.py: the parts of a dressed body in the window: lit up, set, guessed again, saved; in windows of any size.
# Usage: layers.py PROGRAM ROOT OUT CHARACTERS
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import driver
from dressed_gltf import write_dressed
from layout import resize

SCREEN = (2560, 1440)
NAMES = {"shirt": "シャツ", "trousers": "سروال", "hair": "Hero_Character_LOD0_Hair_Cards_Front_And_Back", "eyes": "Eyes"}


def colors(t, picture, box):
    """Mean red, green and blue of a rectangle of a screenshot."""
    x, y, width, height = map(round, box)
    done = subprocess.run(["convert", str(picture), "-crop", "%dx%d+%d+%d" % (width, height, x, y), "-resize", "1x1!",
                           "-depth", "8", "rgb:-"], capture_output=True, check=True, timeout=driver.PATIENCE)
    return list(done.stdout[:3])


def around(editor, bone):
    """A few pixels about a bone's place in the picture."""
    box = editor.state()["bones"][bone]
    return box[0] - 4, box[1] - 4, 8, 8


def seen(t, editor, name):
    editor.wait_until("the picture at rest", lambda s: s["samples"] == 16)
    editor.screenshot(t.out / name)
    return t.out / name


def make_rig(t, name, names=None):
    write_dressed(t.assets / "humanoid.glb", t.folder / (name + ".glb"), *([names] if names else []))
    muscle = {"kind": "ellipsoid", "group": "all", "rotation": [0, 0, 0, 1], "reach": 1.5}
    rig = t.folder / (name + ".rig.json")
    rig.write_text(json.dumps({
        "format": "sinew-rig", "version": 2, "character": name + ".glb", "groups": [{"name": "all"}], "links": [],
        "primitives": [{"name": "chest", "bone": "chest", "center": [0, 0.08, 0.06], "radii": [0.16, 0.12, 0.12], **muscle}]}))
    return rig


def stand_still(editor):
    """It opens as it was left."""
    if editor.wait_until("a character", lambda s: "chest" in s["bones"])["playing"]:
        editor.tap("space", "it to stand still", lambda s: not s["playing"])


def only_layers(editor):
    """The other panels at the right are folded, as they stay for the next window."""
    for panel, control in (("surface", "surface/mode"), ("smoothing", "smoothing/detail")):
        if control in editor.settle()["widgets"]:
            editor.click(panel + "/header")
    return editor.wait_until("the list of parts", lambda s: any(id.startswith("layers/part/") for id in s["widgets"]))


def set_and_guessed(t):
    editor = t.edit(make_rig(t, "dressed"))
    resize(editor, 1280, 800)
    stand_still(editor)
    state = only_layers(editor)
    t.check_equal("all parts are listed", sorted(id[12:] for id in state["widgets"] if id.startswith("layers/part/")),
                  ["Eyes", "Hair", "Shirt", "Trousers", "humanoid"])
    t.check("all of them are guessed", not [id for id in state["widgets"] if id.startswith("layers/guess/")])
    editor.move((640, 12))
    plain = colors(t, seen(t, editor, "layers_1280.png"), around(editor, "chest"))

    editor.point_at(lambda: editor.widget("layers/part/Shirt", 0.3))
    lit = colors(t, seen(t, editor, "layers_hovered.png"), around(editor, "chest"))
    t.check("the hovered shirt is tinted", sum(abs(a - b) for a, b in zip(lit, plain)) > 40, (plain, lit))
    editor.point_at(lambda: editor.widget("layers/part/Trousers", 0.3))
    other = colors(t, seen(t, editor, "layers_trousers.png"), around(editor, "chest"))
    t.check("the shirt is plain while the trousers are hovered", max(abs(a - b) for a, b in zip(other, plain)) < 6, other)
    editor.point_at(lambda: editor.widget("layers/part/Eyes", 0.3))
    seen(t, editor, "layers_eyes.png")

    editor.click("layers/part/Shirt", 0.3)
    editor.move((640, 12))
    marked = colors(t, seen(t, editor, "layers_marked.png"), around(editor, "chest"))
    t.check("a click marks it", sum(abs(a - b) for a, b in zip(marked, plain)) > 30, (plain, marked))
    editor.key("Escape")
    editor.settle()
    again = colors(t, seen(t, editor, "layers_plain.png"), around(editor, "chest"))
    t.check("Esc takes the mark away", max(abs(a - b) for a, b in zip(again, plain)) < 6, again)

    editor.click("layers/set/Shirt/rigid")
    editor.wait_until("one step", lambda s: s["document"]["undo"] == 1 and "layers/guess/Shirt" in s["widgets"])
    editor.click("layers/set/Eyes/skin")
    editor.wait_until("two steps", lambda s: s["document"]["undo"] == 2)
    t.check_equal("what is written", editor.saved_rig()["layers"], {"Shirt": "rigid", "Eyes": "skin"})
    editor.tap("ctrl+z", "one step back", lambda s: s["document"]["undo"] == 1 and "layers/guess/Eyes" not in s["widgets"])
    editor.tap("ctrl+shift+z", "and again", lambda s: s["document"]["undo"] == 2 and "layers/guess/Eyes" in s["widgets"])
    editor.move((640, 12))
    seen(t, editor, "layers_set.png")
    editor.click("layers/guess/Shirt")
    editor.wait_until("three steps", lambda s: s["document"]["undo"] == 3 and "layers/guess/Shirt" not in s["widgets"])
    editor.tap("space", "the clip to play", lambda s: s["playing"])
    editor.click("layers/set/Trousers/skin")
    playing = editor.wait_until("a step while it plays", lambda s: s["document"]["undo"] == 4)
    t.check("it plays on", playing["playing"])
    editor.key("space")
    editor.palette("hair", "part/Hair")
    editor.key("3")
    editor.move((640, 12))
    editor.wait_until("the zones", lambda s: s["display"]["shading"] == "classes" and "legend/classes" in s["widgets"])
    seen(t, editor, "layers_zones.png")
    t.check_equal("what is written at last", editor.saved_rig()["layers"], {"Eyes": "skin", "Trousers": "skin"})
    editor.kill()


def any_window(t):
    for width, height, scale in ((900, 600, 1), (2560, 1440, 1), (1280, 800, 1.5)):
        editor = t.edit(make_rig(t, "letters", NAMES), "--scale", scale)
        resize(editor, width, height)
        stand_still(editor)
        state = only_layers(editor)
        editor.click("layers/set/%s/skin" % NAMES["shirt"])
        state = editor.wait_until("a step", lambda s: s["document"]["undo"] == 1)
        editor.point_at(lambda: editor.widget("layers/part/" + NAMES["hair"], 0.3))
        state = editor.settle()
        editor.screenshot(t.out / ("layers_%dx%d_%g.png" % (width, height, scale)))
        outside = [id for id, box in state["widgets"].items() if id.startswith("layers/") and box[0] + box[2] > width + 1]
        t.check("nothing is cut off at %d x %d, scale %g" % (width, height, scale), not outside, outside)
        editor.kill()


def layers(t):
    set_and_guessed(t)
    any_window(t)


if __name__ == "__main__":
    sys.exit(driver.run("layers", layers, SCREEN))
