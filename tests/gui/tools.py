# tests/gui/tools.py: every handle moves only what it should; locks, numbers, snapping, cancelling.
import math
import sys

import driver
import rigs

BONE = "thigh.L"
TINY = 1e-6  # Character units; the demo is 1.7 tall.


def muscle_on_bone(t):
    """The demo in its bind pose with one muscle made from the outliner, saved."""
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: BONE in s["bones"])
    editor.one_sided()
    editor.choose_clip(-1, "")
    editor.click("outliner/bone/" + BONE)
    editor.wait_until("the bone to be selected", lambda s: s["document"]["bone"] == BONE)
    editor.click("outliner/add")
    state = editor.wait_until("a muscle from the outliner", lambda s: s["document"]["primitives"] == 1)
    t.check_equal("added in one step and selected", (state["document"]["undo"], len(state["document"]["selection"])), (1, 1))
    editor.save_as(t.folder / "tools.rig.json")
    return editor, rigs.only_primitive(editor.saved_rig())


def after_drag(editor, handle, way, during=None):
    """The muscle after one drag, which is then undone."""
    undo = editor.state()["document"]["undo"]
    editor.drag_handle(handle, way, during)
    muscle = rigs.only_primitive(editor.saved_rig())
    editor.tap("ctrl+z", "undo of " + handle, lambda s: s["document"]["undo"] == undo)
    return muscle


def check_move(t, handle, before, after):
    t.check_equal(handle + " moves the center alone", rigs.changed_parts(before, after), {"center"})
    if handle == "move.center":
        return
    # Axes are the bone's, and so are the coordinates of the center.
    may = {"xyz".index(axis) for axis in handle.split(".")[1]}
    moved = rigs.changed_axes(before["center"], after["center"], TINY)
    t.check(handle + " moves along its own axes", moved and moved <= may, moved)


def check_rotate(t, handle, before, after):
    t.check_equal(handle + " turns and does nothing else", rigs.changed_parts(before, after), {"rotation"})
    axis, degrees = rigs.turn_between(before["rotation"], after["rotation"])
    t.check(handle + " turns visibly", 1.0 < degrees < 180.0, degrees)
    if handle != "rotate.screen":
        own = abs(axis["xyz".index(handle[-1])])
        t.check(handle + " turns about its own axis", own > 1.0 - 1e-4, axis)


def check_scale(t, handle, before, after):
    t.check_equal(handle + " changes radii alone", rigs.changed_parts(before, after), {"radii"})
    if handle == "scale.uniform":
        ratios = [b / a for a, b in zip(before["radii"], after["radii"])]
        t.check(handle + " scales all three alike", max(ratios) - min(ratios) < 1e-4 and abs(ratios[0] - 1.0) > 0.05, ratios)
    else:
        t.check_equal(handle + " scales one radius", rigs.changed_axes(before["radii"], after["radii"], 0.0),
                      {"xyz".index(handle[-1])})


def check_pole(t, handle, before, after):
    axis, sign = "xyz".index(handle[-1]), 1 if "+" in handle else -1
    t.check_equal(handle + " changes a radius and the center", rigs.changed_parts(before, after), {"center", "radii"})
    t.check_equal(handle + " changes one radius", rigs.changed_axes(before["radii"], after["radii"], 0.0), {axis})
    stays = math.dist(rigs.pole(before, axis, -sign), rigs.pole(after, axis, -sign))
    t.check(handle + " leaves the other end where it was", stays < TINY, stays)


CHECKS = {"move": check_move, "rotate": check_rotate, "scale": check_scale, "pole": check_pole}
MODES = {"move": ("w", 6), "rotate": ("e", 3), "scale": ("r", 3), "poles": ("q", 2)}  # Key; handles to be there at least: those too near others hide.
# Not along any one line, so that no handle is pulled only across its way.
WAY = [(9, 4), (18, 8), (36, 22)]


def every_handle(t, editor, before):
    for mode, (key, least) in MODES.items():
        state = editor.tap(key, mode + " handles", lambda s: s["gizmo"]["mode"] == mode)
        kind = mode.rstrip("s") + "."
        handles = [h for h in state["gizmo"]["handles"] if h.startswith(kind)]
        t.check("%s shows its handles" % mode, len(handles) >= least, sorted(state["gizmo"]["handles"]))
        for handle in handles:
            CHECKS[handle.split(".")[0]](t, handle, before, after_drag(editor, handle, WAY))


def locks(t, editor, before):
    editor.tap("w", "move handles", lambda s: s["gizmo"]["mode"] == "move")
    for axis, key in enumerate("xyz"):
        after = after_drag(editor, "move.center", WAY, lambda: editor.key(key))
        moved = rigs.changed_axes(before["center"], after["center"], TINY)
        t.check_equal("%s locks a free move to its axis" % key.upper(), moved, {axis})
    after = after_drag(editor, "move.center", WAY, lambda: editor.key("x", "x"))
    t.check("X twice frees the move again", len(rigs.changed_axes(before["center"], after["center"], TINY)) > 1, after["center"])


def numbers_and_snaps(t, editor, before):
    editor.tap("w", "move handles", lambda s: s["gizmo"]["mode"] == "move")
    after = after_drag(editor, "move.center", WAY[:1], lambda: (editor.key("y"), editor.type("0.25")))
    moved = after["center"][1] - before["center"][1]
    t.check("a typed number is the length of a move", abs(moved - 0.25) < 1e-5, moved)
    undo = editor.state()["document"]["undo"]
    editor.grab("move.center")
    editor.key("x")
    editor.type("-0.5")
    editor.tap("Return", "Enter to end the drag", lambda s: s["document"]["undo"] == undo + 1 and not s["gizmo"]["dragging"])
    editor.release()
    moved = rigs.only_primitive(editor.saved_rig())["center"][0] - before["center"][0]
    t.check("Enter keeps a typed number", abs(moved + 0.5) < 1e-5, moved)
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["undo"] == undo)

    editor.tap("e", "rotate handles", lambda s: s["gizmo"]["mode"] == "rotate")

    def snap():
        editor.hold("ctrl")
        editor.move((editor.mouse[0] + 14, editor.mouse[1] + 30))

    after = after_drag_held(editor, "rotate.screen", WAY, snap, "ctrl")
    _, degrees = rigs.turn_between(before["rotation"], after["rotation"])
    rest = abs(degrees / 15.0 - round(degrees / 15.0))
    t.check("Ctrl snaps a turn to 15 degrees", degrees > 1.0 and rest < 1e-3, degrees)


def after_drag_held(editor, handle, way, during, held):
    """after_drag with a key that is down until the release has come."""
    undo = editor.state()["document"]["undo"]
    editor.drag_handle(handle, way, during)
    editor.let_go(held)
    muscle = rigs.only_primitive(editor.saved_rig())
    editor.tap("ctrl+z", "undo of " + handle, lambda s: s["document"]["undo"] == undo)
    return muscle


def both_ends(t, editor, before):
    state = editor.tap("q", "pole handles", lambda s: s["gizmo"]["mode"] == "poles")
    handle = sorted(h for h in state["gizmo"]["handles"] if h.startswith("pole."))[0]

    def alt():
        editor.hold("alt")
        editor.move((editor.mouse[0] + 6, editor.mouse[1] + 6))

    after = after_drag_held(editor, handle, WAY, alt, "alt")
    t.check_equal("with Alt %s leaves the center" % handle, rigs.changed_parts(before, after), {"radii"})


def cancels(t, editor, before):
    editor.saved_rig()
    file = t.folder / "tools.rig.json"
    written = file.read_bytes()
    undo = editor.state()["document"]["undo"]
    for mode, key, handle in (("move", "w", "move.center"), ("rotate", "e", "rotate.screen"), ("scale", "r", "scale.uniform")):
        editor.tap(key, mode + " handles", lambda s: s["gizmo"]["mode"] == mode)
        for cancel in ("Esc", "the right button"):
            editor.grab(handle)
            for offset in WAY:
                editor.move((editor.mouse[0] + offset[0], editor.mouse[1] + offset[1]))
            editor.wait_until("the drag to change the muscle", lambda s: s["document"]["modified"])
            if cancel == "Esc":
                editor.key("Escape")
            else:
                editor.xdotool("click", driver.RIGHT)
            state = editor.wait_until(cancel + " to end the drag", lambda s: not s["gizmo"]["dragging"])
            editor.release()
            state = editor.act("another tool", lambda: editor.key("q"), lambda s: s["tool"] == "select")
            t.check_equal("%s during %s leaves no trace" % (cancel, handle),
                          (state["document"]["modified"], state["document"]["undo"], len(state["document"]["selection"])),
                          (False, undo, 1))
            editor.tap(key, mode + " handles", lambda s: s["gizmo"]["mode"] == mode)
    t.check_equal("after all that the rig is the same", rigs.only_primitive(editor.saved_rig()), before)
    t.check("and so is its file", file.read_bytes() == written)


def canceled_muscle(t, editor):
    """Esc while a muscle grows: no muscle, the selection as it was."""
    before = editor.state()["document"]
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")
    bones = editor.state()["bones"]
    middle = [0.5 * (a + b) for a, b in zip(bones["spine"], bones["chest"])]
    editor.move(middle)
    editor.wait_until("skin under the pointer", lambda s: "grows on" in s["status"])
    editor.press()
    editor.wait_until("a second muscle", lambda s: s["document"]["primitives"] == 2)
    editor.move((middle[0] + 20, middle[1] + 10))
    state = editor.tap("Escape", "Esc to take it back", lambda s: s["document"]["primitives"] == 1)
    editor.release()
    t.check_equal("a canceled muscle leaves no trace", state["document"], before)
    editor.tap("q", "the select tool", lambda s: s["tool"] == "select")


def story(t):
    editor, before = muscle_on_bone(t)
    every_handle(t, editor, before)
    locks(t, editor, before)
    numbers_and_snaps(t, editor, before)
    both_ends(t, editor, before)
    cancels(t, editor, before)
    canceled_muscle(t, editor)
    editor.screenshot(t.out / "tools.png")
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("tools", story))
