# tests/gui/view_state.py: what the picture asks of the surface, depth and hidden sides, never touches the document.
import sys

import driver

WHEEL_UP, WHEEL_DOWN = 4, 5


def zoom(editor, button, what, predicate):
    """Wheel steps in the picture's middle until it holds."""
    for _ in range(40):
        x, y, width, height = editor.state()["viewport"]
        editor.xdotool("mousemove", round(x + 0.5 * width), round(y + 0.5 * height), "click", button)
        try:
            return editor.wait_until(what, predicate, 0.5)
        except driver.Failure:
            continue
    raise driver.Failure("zoomed in vain: " + what)


def turn_until(editor, place, what, predicate):
    """Orbits by unequal steps until it holds: as many triangles may be hidden from one side as from another."""
    for way in (150, 97, -61, 43):
        editor.drag(place, (place[0] + way, place[1]))
        try:
            return editor.wait_until(what, predicate, 3)
        except driver.Failure:
            continue
    raise driver.Failure("turned in vain: " + what)


def depth_follows(t, editor):
    own = editor.state()["tolerance"]
    editor.click("smoothing/auto")
    editor.wait_until("auto detail to be a step", lambda s: s["document"]["undo"] == 1)
    far = zoom(editor, WHEEL_DOWN, "a larger tolerance from afar", lambda s: s["tolerance"] > 2 * own)
    near = zoom(editor, WHEEL_UP, "a smaller one from near", lambda s: s["tolerance"] < own)
    t.check("the mesh follows", near["triangles"] > 1.5 * far["triangles"], (far["triangles"], near["triangles"]))
    t.check_equal("zooming is no step", (far["document"]["undo"], near["document"]["undo"]), (1, 1))
    state = editor.tap("ctrl+z", "undo", lambda s: s["document"]["undo"] == 0)
    state = editor.wait_until("the rig's own tolerance", lambda s: s["tolerance"] == own)
    t.check("undone, nothing is modified", not state["document"]["modified"])


def hidden_sides(t, editor):
    editor.click("menu/view")
    editor.click("view/cull")
    state = editor.wait_until("triangles to be culled", lambda s: s["display"]["cull"] and s["culled"] > 0)
    x, y, width, height = state["viewport"]
    low = (x + 0.5 * width, y + height - 30)
    turned = turn_until(editor, low, "other triangles from elsewhere", lambda s: s["culled"] not in (0, state["culled"]))
    t.check("looking is no step", turned["document"]["undo"] == 0 and not turned["document"]["modified"])
    editor.click("menu/view")
    editor.click("view/cull")
    editor.wait_until("all triangles again", lambda s: not s["display"]["cull"] and s["culled"] == 0)


def anatomy(t, editor):
    """Muscles under glass: a key, a slider, and no step of the history."""
    state = editor.tap("v", "muscles as flesh", lambda s: s["display"]["anatomy"] and "legend/glass" in s["widgets"])
    t.check_equal("the skin is mostly clear", round(state["display"]["glass"], 3), 0.8)
    x, y, width, height = state["widgets"]["legend/glass"]
    middle = y + 0.5 * height
    editor.drag((x + 0.8 * width, middle), (x + 0.3 * width, middle))
    editor.wait_until("less clear skin", lambda s: s["display"]["glass"] < 0.6)
    editor.wait_until("all samples", lambda s: s["samples"] == 16)
    state = editor.tap("v", "the skin again", lambda s: not s["display"]["anatomy"])
    t.check("looking is no step", state["document"]["undo"] == 0 and not state["document"]["modified"])


def story(t):
    t.copy(t.assets / "demo.glb")
    editor = t.edit(t.copy(t.assets / "demo.rig.json"))
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0)
    if state["playing"]:
        editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    depth_follows(t, editor)
    hidden_sides(t, editor)
    anatomy(t, editor)
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("view_state", story))
