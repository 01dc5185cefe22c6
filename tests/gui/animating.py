# tests/gui/animating.py: driven keys set by posing and scrubbing, a radius keyed at two moments; undone, the file is as it was.
# Usage: animating.py PROGRAM ROOT OUT CHARACTERS
import sys

import driver

MUSCLE, LOWER = "biceps L", "forearm.L"
RADIUS, FIELD = "radii.x", "inspector/radius.x"


def value(state):
    return state["animation"]["now"].get(RADIUS)


def scrub(editor, share):
    before = editor.state()["clip_time"]
    editor.click("timeline/scrub", along=share)
    return editor.wait_until("another moment", lambda s: abs(s["clip_time"] - before) > 0.01)


def poses(t, editor):
    """The forearm, by a ring of the pose tool."""
    straight = editor.state()["animation"]["input"]
    editor.click("toolstrip/pose")
    editor.wait_until("the pose tool", lambda s: s["tool"] == "pose")
    editor.select_bone(LOWER)
    editor.wait_until("its rings", lambda s: s["gizmo"]["visible"])
    editor.grab("rotate.screen")
    start = editor.mouse
    for step in range(15, 200, 15):  # Which way the joint bends depends on the view.
        editor.move((start[0] + step, start[1] + step))
        if abs(editor.state()["animation"]["input"] - straight) > 20.0:
            break
    editor.wait_until("the joint to turn", lambda s: s["pose"]["overrides"] == 1)
    editor.release()
    state = editor.wait_until("the end of the drag", lambda s: not s["gizmo"]["dragging"])
    t.check("the input is read off the pose", abs(state["animation"]["input"] - straight) > 5.0, state["animation"])


def drives(t, editor, drawn):
    """Two driven keys: as the clip has the arm, and bent by hand."""
    editor.choose(FIELD, "set-driven", "set-driven/bend", "set-driven/bend/near/" + LOWER)
    state = editor.wait_until("the mode", lambda s: s["animation"].get("setting") == "bend of " + LOWER)
    t.check_equal("nothing is driven yet", (state["animation"]["drivers"], state["document"]["undo"]), (0, 0))
    state = editor.tap("k", "a point as the arm is", lambda s: s["animation"]["drivers"] == 1)
    first = value(state)
    poses(t, editor)
    editor.select_muscle(MUSCLE)
    editor.type_number(FIELD, "0.12")
    editor.wait_until("the number", lambda s: value(s) and abs(value(s) - 0.12) < 1e-5)
    editor.screenshot(t.out / "animating_driven_key.png")
    editor.tap("Escape", "Esc to end it", lambda s: "setting" not in s["animation"])
    rig = editor.saved_rig()
    primitive = next(p for p in rig["primitives"] if p["name"] == MUSCLE)
    t.check_equal("the number itself stays", primitive["radii"][0], drawn)
    t.check_equal("two points", len(primitive["animated"][0]["drivers"][0]["curve"]), 2)
    editor.tap("shift+p", "the pose reset", lambda s: s["pose"]["overrides"] == 0)
    state = editor.wait_until("the number to follow", lambda s: abs(value(s) - first) < 0.3 * abs(0.12 - first))
    before = value(state)
    state = scrub(editor, 0.55)
    t.check("and with the clip", value(state) != before, (value(state), before))


def keys(t, editor):
    """The number is keyed at two moments; between them surface and state change."""
    editor.choose(FIELD, "animation-remove")
    editor.wait_until("nothing drives", lambda s: s["animation"]["drivers"] == 0)
    for share, number in ((0.2, "0.05"), (0.8, "0.1")):
        scrub(editor, share)
        editor.type_number(FIELD, number)
        count = editor.state()["animation"]["keys"]
        editor.settle()
        editor.tap("k", "a key", lambda s: s["animation"]["keys"] == count + 1)
    seen = [value(scrub(editor, share)) for share in (0.3, 0.5, 0.7)]
    t.check("the number rises from key to key", 0.05 < seen[0] < seen[1] < seen[2] < 0.1, seen)
    editor.wait_until("rows of keys", lambda s: any(w.startswith("timeline/row/") for w in s["widgets"]))
    editor.screenshot(t.out / "animating_keys.png")


def story(t):
    t.copy(t.assets / "humanoid.glb")
    path = t.copy(t.assets / "humanoid-flex.rig.json")
    editor = t.edit(path)
    state = editor.wait_until("a character", lambda s: s["bones"])
    if state["playing"]:
        editor.tap("space", "it stands", lambda s: not s["playing"])
    editor.one_sided()
    editor.select_muscle(MUSCLE)
    scrub(editor, 0.4)
    editor.saved_rig()
    before = path.read_bytes()
    drives(t, editor, next(p for p in editor.saved_rig()["primitives"] if p["name"] == MUSCLE)["radii"][0])
    keys(t, editor)
    for undo in range(editor.state()["document"]["undo"] - 1, -1, -1):
        editor.tap("ctrl+z", "undo to %d" % undo, lambda s: s["document"]["undo"] == undo)
    editor.saved_rig()
    t.check("all undone, the file is what it was", path.read_bytes() == before)


if __name__ == "__main__":
    sys.exit(driver.run("animating", story))
