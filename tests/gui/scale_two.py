# tests/gui/scale_two.py: --scale 2 on a large screen: all is twice as large, and the same hands do the same.
import json
import math
import sys

import driver
import rigs

SCREEN = (2560, 1600)
BONE, NEXT = "thigh.L", "shin.L"
# Controls whose size the scale alone decides, width or height; others share what room there is.
FIXED = {"toolstrip/select": 2, "toolstrip/symmetry": 2, "timeline/play": 2, "display/wire": 2, "menu/file": 2,
         "outliner/bone/" + BONE: 3, "smoothing/tolerance": 3, "timeline/clip": 2}


def inside(box, place):
    x, y, width, height = place
    return box[0] >= x - 1 and box[1] >= y - 1 and box[0] + box[2] <= x + width + 1 and box[1] + box[3] <= y + height + 1


def everything_is_twice_as_large(t, file):
    plain = t.edit(file, "--scale", 1)
    one = plain.wait_until("a character", lambda s: BONE in s["bones"] and "smoothing/tolerance" in s["widgets"])
    t.check_equal("scale 1", one["scale"], 1)
    plain.choose_clip(-1, "")
    t.check_equal("it quits", plain.quit(), 0)
    editor = t.edit(file, "--scale", 2)
    two = editor.wait_until("a character", lambda s: BONE in s["bones"] and "smoothing/tolerance" in s["widgets"])
    t.check_equal("scale 2", two["scale"], 2)
    for name, side in FIXED.items():
        small, large = one["widgets"][name][side], two["widgets"][name][side]
        t.check("%s is twice as large" % name, abs(large - 2.0 * small) <= 3.0, (small, large))
    whole = (0, 0, *window(editor))
    t.check("no control lies outside the window", all(inside(box, whole) for box in two["widgets"].values()),
            [name for name, box in two["widgets"].items() if not inside(box, whole)])
    t.check("the window is twice as large", window(editor) == tuple(2 * side for side in driver.SCREEN), window(editor))
    return editor


def window(editor):
    number = editor.xdotool("search", "--onlyvisible", "--name", ".").split()[0]
    told = editor.xdotool("getwindowgeometry", "--shell", number).split()
    lines = dict(line.split("=") for line in told if "=" in line)
    return int(lines["WIDTH"]), int(lines["HEIGHT"])


def between(state, part):
    a, b = state["bones"][BONE], state["bones"][NEXT]
    return [p + part * (q - p) for p, q in zip(a, b)]


def add_and_name(t, editor):
    editor.choose_clip(-1, "")
    editor.type_number("smoothing/tolerance", "0.2")
    editor.wait_until("the tolerance", lambda s: abs(s["tolerance"] - 0.002) < 1e-6)
    undo = editor.state()["document"]["undo"]
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")
    editor.move(between(editor.state(), 0.25))
    editor.wait_until("the bone under the pointer", lambda s: "grows on " + BONE in s["status"])
    editor.press()
    for part in (0.4, 0.55, 0.7):
        editor.move(between(editor.state(), part))
    editor.release()
    state = editor.wait_until("the stroke to be a step", lambda s: s["document"]["undo"] == undo + 1)
    t.check_equal("a muscle and its twin", state["document"]["primitives"], 2)
    editor.fill("inspector/name", "quads L")
    state = editor.wait_until("its name", lambda s: s["document"]["selection"] == ["quads L"])
    t.check_equal("the twin's name", state["symmetry"]["twin"], "quads R")
    editor.save_as(t.folder / "scale.rig.json")


def muscle(editor):
    return next(p for p in editor.saved_rig()["primitives"] if p["name"] == "quads L")


def handles_follow(t, editor):
    state = editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    arms = [math.dist(state["gizmo"]["handles"]["move.center"], at) for name, at in state["gizmo"]["handles"].items()
            if name in ("move.x", "move.y", "move.z")]
    # 95 design pixels and a head, less where an arm points to or from the eye.
    t.check("the longest arm is as long as at scale 1, twice", 130.0 < max(arms) < 260.0, arms)
    before = muscle(editor)
    editor.drag_handle("move.center", [(20, 10), (40, 20)])
    t.check_equal("the muscle moves", rigs.changed_parts(before, muscle(editor)), {"center"})
    editor.tap("r", "the scale tool", lambda s: s["gizmo"]["mode"] == "scale")
    before = muscle(editor)
    editor.drag_handle("scale.uniform", [(95, 0), (190, 0)])
    after = muscle(editor)
    ratios = [b / a for a, b in zip(before["radii"], after["radii"])]
    # 95 design pixels double it.
    t.check("190 pixels here are what 95 are at scale 1", all(abs(r - 2.0) < 0.05 for r in ratios), ratios)
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["redo"] == 1)
    editor.saved_rig()
    return editor.state()["gizmo"]["handles"]["scale.uniform"]


def click_in_picture(editor, place):
    """What is under the pointer is what is meant: a click beside clears the selection, a click on the muscle selects it again."""
    editor.tap("q", "the select tool", lambda s: s["tool"] == "select")
    editor.tap("8", "all muscles to be seen", lambda s: s["display"]["primitives"])
    x, y, width, height = editor.state()["viewport"]
    editor.move((x + 0.55 * width, y + 0.92 * height))
    editor.xdotool("click", driver.LEFT)
    editor.wait_until("nothing to be selected", lambda s: not s["document"]["selection"])
    editor.move(place)
    editor.xdotool("click", driver.LEFT)
    editor.wait_until("the muscle to be taken", lambda s: s["document"]["selection"] == ["quads L"])


def group_and_unlink(t, editor):
    editor.click("blending/tab")
    editor.wait_until("the groups", lambda s: "blending/add" in s["widgets"])
    first = next(iter(editor.state()["groups"]))
    editor.key("ctrl+g")
    editor.wait_until("a name to be typed", lambda s: "blending/rename" in s["widgets"])
    editor.key("ctrl+a")
    editor.type("leg")
    editor.tap("Return", "the group", lambda s: "leg" in s["groups"] and "blending/rename" not in s["widgets"])
    for links in ([[first, "leg"]], []):
        editor.click("blending/cell/leg/" + first)
        editor.wait_until("links %s" % links, lambda s: sorted(map(sorted, s["links"])) == sorted(map(sorted, links)))
    editor.click("blending/cell/leg/" + first)
    editor.wait_until("the link", lambda s: len(s["links"]) == 1)


def story(t):
    file = t.copy(t.assets / "humanoid.glb")
    editor = everything_is_twice_as_large(t, file)
    add_and_name(t, editor)
    click_in_picture(editor, handles_follow(t, editor))
    group_and_unlink(t, editor)
    editor.settle()
    editor.screenshot(t.out / "scale_two.png")
    saved = editor.saved_rig()
    names = {p["name"]: p["group"] for p in saved["primitives"]}
    t.check_equal("quits without a question", editor.quit(), 0)
    again = t.edit(t.folder / "scale.rig.json", "--scale", 2)
    state = again.wait_until("the saved rig", lambda s: s["document"]["primitives"] == 2 and BONE in s["bones"])
    t.check_equal("both are there, in their group", names, {"quads L": "leg", "quads R": "leg"})
    t.check_equal("and the link", len(state["links"]), 1)
    again.save_as(t.folder / "again.rig.json")
    t.check("byte for byte", json.loads((t.folder / "again.rig.json").read_text()) == saved and
            (t.folder / "again.rig.json").read_bytes() == (t.folder / "scale.rig.json").read_bytes())
    t.check_equal("quits", again.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("scale_two", story, SCREEN))
