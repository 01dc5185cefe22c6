# tests/gui/main_story.py: a muscle drawn on a walking thigh, shaped, undone, saved and opened again. Last argument: demo or fox.
import math
import sys

import driver
from acts import changed_keys

CAST = {
    # The thigh's bone and the one after it, the stroke along it (parts of its length), and how far to drag the view (pixels)
    # so that the thigh is in sight.
    "demo": {"file": "demo.glb", "real": False, "bone": "thigh.L", "next": "shin.L", "stroke": (0.25, 0.4, 0.55, 0.7),
             "orbit": 60},
    "fox": {"file": "Fox.glb", "real": True, "bone": "b_LeftLeg01_015", "next": "b_LeftLeg02_016",
            "stroke": (0.7, 0.5, 0.3, 0.1), "orbit": -200},
}


def muscle(editor):
    """The one muscle, as it is saved."""
    (only,) = editor.saved_rig()["primitives"]
    return only


def between(state, role, part):
    a, b = state["bones"][role["bone"]], state["bones"][role["next"]]
    return [p + part * (q - p) for p, q in zip(a, b)]


def open_and_look(t, editor, role):
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0 and role["bone"] in s["bones"])
    t.check_equal("opens walking", (state["clip"], state["playing"]), ("Walk", True))
    t.check_equal("the rig is empty", (state["document"]["primitives"], state["document"]["modified"]), (0, False))
    editor.one_sided()
    editor.type_number("timeline/speed", "0.1")  # On a slow machine the thigh would be elsewhere before the press arrives.
    before = editor.state()["camera"]["yaw"]
    x, y, width, height = editor.state()["viewport"]
    corner = [x + 0.6 * width, y + 0.95 * height]
    editor.drag(corner, [corner[0] + role["orbit"], corner[1]])
    editor.wait_until("a drag beside the character to turn the view",
                      lambda s: abs(s["camera"]["yaw"] - before) > 0.1 and not s["status"].startswith("Orbit"))


def stroke(t, editor, role):
    """Press and moves, the button still down."""
    held = editor.press_on_skin(role["bone"], lambda state: between(state, role, role["stroke"][0]))
    for part in role["stroke"][1:]:
        editor.move(between(held, role, part))
        t.check_equal("the pose is held while the button is down",
                      (editor.state()["clip_time"], editor.state()["playing"]), (held["clip_time"], True))
    return held


def draw_muscle(t, editor, role):
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")
    before = editor.state()["document"]
    stroke(t, editor, role)
    state = editor.tap("Escape", "Esc to take it back", lambda s: s["document"]["primitives"] == 0)
    t.check_equal("without a trace", state["document"], before)
    editor.release()
    held = stroke(t, editor, role)
    editor.release()
    state = editor.wait_until("the muscle to be a step", lambda s: s["document"]["undo"] == 1)
    editor.wait_until("the clip to go on", lambda s: s["playing"] and s["clip_time"] != held["clip_time"])
    state = editor.save_as(t.folder / "first.rig.json")
    drawn = muscle(editor)
    t.check_equal("it is on the bone under the pointer", drawn["bone"], role["bone"])
    t.check_equal("it is what is selected", state["document"]["selection"], [drawn["name"]])
    t.check("its long axis lies along the drag", drawn["radii"][0] > max(drawn["radii"][1:]), drawn["radii"])


def change_with_handles(t, editor):
    editor.choose_clip(-1, "")
    before = muscle(editor)
    editor.tap("e", "the rotate tool", lambda s: s["gizmo"]["mode"] == "rotate")
    editor.drag_handle("rotate.screen", [(15, 0), (30, 20), (30, 40)])
    turned = muscle(editor)
    t.check_equal("the ring turns the muscle and does nothing else", changed_keys(before, turned), {"rotation"})
    editor.tap("r", "the scale tool", lambda s: s["gizmo"]["mode"] == "scale")
    handles = editor.state()["gizmo"]["handles"]
    # The arm with the most room on the screen.
    center = handles["scale.uniform"]
    arm = max((h for h in handles if h in ("scale.x", "scale.y", "scale.z")), key=lambda h: math.dist(handles[h], center))
    out = [a - b for a, b in zip(handles[arm], center)]
    editor.drag_handle(arm, [[part * v for v in out] for part in (0.3, 0.7, 1.0)])
    stretched = muscle(editor)
    axis = "xyz".index(arm[-1])
    t.check_equal("the arm changes its own radius and nothing else",
                  (changed_keys(turned, stretched), [i for i in range(3) if turned["radii"][i] != stretched["radii"][i]]),
                  ({"radii"}, [axis]))
    t.check("pulled outwards it grows", stretched["radii"][axis] > 1.2 * turned["radii"][axis])
    editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    editor.drag_handle("move.center", [(9, 4)], lambda: (editor.key("y"), editor.type("0.25")))
    moved = muscle(editor)
    way = [b - a for a, b in zip(stretched["center"], moved["center"])]
    t.check("an axis and a number typed during the drag say how far", math.dist(way, [0.0, 0.25, 0.0]) < 1e-5, way)
    held = editor.state()["document"]
    editor.grab("move.center")
    editor.move((editor.mouse[0] + 30, editor.mouse[1] + 18))
    editor.wait_until("the muscle to move", lambda s: s["document"]["modified"])
    editor.xdotool("click", driver.RIGHT)
    editor.wait_until("the right button to end the drag", lambda s: not s["gizmo"]["dragging"])
    editor.release()
    t.check_equal("without a trace", editor.settle()["document"], held)


def play_and_edit(t, editor):
    editor.choose_clip(editor.state()["clips"].index("Walk"), "Walk")
    if not editor.state()["playing"]:
        editor.tap("space", "the clip to play", lambda s: s["playing"])
    before = editor.state()
    after = editor.drag_handle("move.center", [(6, 0), (12, 3), (14, 6)])
    t.check("the clip went on playing during the drag", after["playing"] and after["clip_time"] != before["clip_time"])
    editor.tap("space", "the clip to stop", lambda s: not s["playing"])


def undo_and_redo(t, editor):
    saved = editor.saved_rig()
    steps = editor.state()["document"]["undo"]
    t.check_equal("steps: muscle, turn, stretch, number, move", steps, 5)
    editor.taps(*["ctrl+z"] * steps)
    state = editor.wait_until("all undone", lambda s: s["document"]["undo"] == 0)
    t.check_equal("no muscle, and not what the file holds",
                  (state["document"]["primitives"], state["document"]["modified"]), (0, True))
    editor.taps(*["ctrl+shift+z"] * steps)
    state = editor.wait_until("all redone", lambda s: s["document"]["undo"] == steps)
    t.check("redone, it is what the file holds", not state["document"]["modified"])
    t.check_equal("redone, the rig is the same", editor.saved_rig(), saved)


def save_and_reopen(t, editor):
    second, third = t.folder / "second.rig.json", t.folder / "third.rig.json"
    editor.save_as(second)
    t.check_equal("quits without a question", editor.quit(), 0)
    again = t.edit(second)
    state = again.wait_until("the saved rig", lambda s: s["document"]["primitives"] == 1 and s["triangles"] > 0)
    t.check("freshly opened it has no changes", not state["document"]["modified"])
    again.save_as(third)
    t.check("saved, opened, saved again: byte for byte the same", second.read_bytes() == third.read_bytes())
    t.check_equal("the second window quits too", again.quit(), 0)


def story(t):
    role = CAST[sys.argv[5]]
    source = (t.characters if role["real"] else t.assets) / role["file"]
    if not source.is_file():
        raise driver.Skip("real characters are not at hand")
    editor = t.edit(t.copy(source))
    open_and_look(t, editor, role)
    draw_muscle(t, editor, role)
    change_with_handles(t, editor)
    play_and_edit(t, editor)
    undo_and_redo(t, editor)
    save_and_reopen(t, editor)


if __name__ == "__main__":
    sys.exit(driver.run("main_story_" + sys.argv[5], story))
