# tests/gui/resizing.py: a window made small and large again; an interface twice as large, where the same hands do the same.
import sys

import driver

SCREEN = (2560, 1600)
BARS = ("layout/left", "layout/right", "layout/bottom", "layout/history")
BONE, NEXT = "thigh.L", "shin.L"
# Controls whose size the scale alone decides, width or height; others share what room there is.
FIXED = {"toolstrip/select": 2, "timeline/play": 2, "menu/file": 2, "outliner/bone/" + BONE: 3}


def resize(editor, width, height):
    editor.xdotool("windowsize", editor.window(), width, height)

    def resized(state):
        bar = state["widgets"].get("layout/bottom", (0, 0, 0, 0))
        end = state["viewport"][1] + state["viewport"][3]
        return abs(bar[2] - width) < 2 and abs(end - bar[1]) < 2 and height - 400 < end < height - 60

    return editor.wait_until("a window of %d x %d" % (width, height), resized)


def outside(state, width, height):
    return [name for name, (x, y, wide, high) in state["widgets"].items()
            if min(x, y) < -1 or x + wide > width + 1 or y + high > height + 1]


def picture_fills_it(t, editor):
    """Near every corner of the picture something of the editor is on the screen, not the black of an X server."""
    x, y, width, height = editor.state()["viewport"]
    for right in (0, 1):
        for below in (0, 1):
            place = (x + 3 + right * (width - 8), y + 3 + below * (height - 8), 2, 2)
            driver.wait_for("the picture at %g, %g" % place[:2], lambda p=place: max(editor.pixels(p)) > 0)


def small_and_large_again(t, file):
    editor = t.edit(file)
    resize(editor, 1600, 1000)
    x, y = editor.widget("layout/left")
    editor.drag((x, y), (x + 130, y))
    editor.settle()
    before = editor.state()["widgets"]
    for width, height in ((820, 560), (700, 900)):
        small = resize(editor, width, height)
        t.check("a small window shows smaller panels", small["widgets"]["layout/left"][0] < before["layout/left"][0])
        t.check_equal("all of it lies in the window", outside(small, width, height), [])
        picture_fills_it(t, editor)
    resize(editor, 1600, 1000)
    after = editor.wait_until("the panels", lambda s: s["widgets"]["layout/right"] == before["layout/right"])["widgets"]
    t.check_equal("as large as it was, it looks as it did", [after[bar] for bar in BARS], [before[bar] for bar in BARS])
    picture_fills_it(t, editor)
    t.check_equal("quits", editor.quit(), 0)
    return before


def twice_as_large(t, file, one):
    editor = t.edit(file, "--scale", 2)
    state = editor.wait_until("a character", lambda s: BONE in s["bones"] and "timeline/play" in s["widgets"])
    told = editor.xdotool("getwindowgeometry", "--shell", editor.window()).split()
    lines = dict(line.split("=") for line in told if "=" in line)
    size = int(lines["WIDTH"]), int(lines["HEIGHT"])
    t.check_equal("scale and window", (state["scale"], size), (2, (2 * driver.SCREEN[0], 2 * driver.SCREEN[1])))
    t.check_equal("no control lies outside", outside(state, *size), [])
    for name, side in FIXED.items():
        small, large = one[name][side], state["widgets"][name][side]
        t.check("%s is twice as large" % name, abs(large - 2.0 * small) <= 3.0, (small, large))
    return editor


def the_same_hands(t, editor):
    """What is under the pointer is what is meant."""
    editor.choose_clip(-1, "")
    editor.select_bone(BONE)
    state = editor.tap("ctrl+m", "a muscle and its twin", lambda s: s["document"]["primitives"] == 2)
    (muscle,) = state["document"]["selection"]
    editor.save_as(t.folder / "scale.rig.json")
    editor.tap("r", "the scale tool", lambda s: s["gizmo"]["mode"] == "scale")
    radii = lambda: next(p for p in editor.saved_rig()["primitives"] if p["name"] == muscle)["radii"]
    before = radii()
    editor.drag_handle("scale.uniform", [(95, 0), (190, 0)])
    t.check("190 pixels double it, as 95 do at scale 1", all(abs(b / a - 2.0) < 0.05 for a, b in zip(before, radii())))
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["redo"] == 1)
    place = editor.state()["gizmo"]["handles"]["scale.uniform"]
    editor.tap("q", "the select tool", lambda s: s["tool"] == "select")
    editor.tap("8", "all muscles to be seen", lambda s: s["display"]["primitives"])
    x, y, width, height = editor.state()["viewport"]
    editor.move((x + 0.55 * width, y + 0.92 * height))
    editor.xdotool("click", driver.LEFT)
    editor.wait_until("nothing to be selected", lambda s: not s["document"]["selection"])
    editor.move(place)
    editor.xdotool("click", driver.LEFT)
    editor.wait_until("the muscle to be taken", lambda s: s["document"]["selection"] == [muscle])
    t.check_equal("quits without a question", (editor.saved_rig() is not None, editor.quit()), (True, 0))


def story(t):
    file = t.copy(t.assets / "demo.glb")
    one = small_and_large_again(t, file)
    the_same_hands(t, twice_as_large(t, file, one))


if __name__ == "__main__":
    sys.exit(driver.run("resizing", story, SCREEN))
