# tests/gui/main_story.py: from opening a character to the same rig on the disk twice. Last argument: demo or fox.
import json
import math
import sys

import driver
import rigs

CAST = {
    # The thigh's bone and the one after it, the stroke along it (parts of its length), the clip to play, and how far to
    # drag the view (pixels) so that the thigh is in sight.
    "demo": {"file": "demo.glb", "real": False, "bone": "thigh.L", "next": "shin.L", "stroke": (0.25, 0.4, 0.55, 0.7),
             "clip": "Walk", "orbit": 0},
    "fox": {"file": "Fox.glb", "real": True, "bone": "b_LeftLeg01_015", "next": "b_LeftLeg02_016",
            "stroke": (0.7, 0.5, 0.3, 0.1), "clip": "Walk", "orbit": -200},
}


def between(state, role, part):
    a, b = state["bones"][role["bone"]], state["bones"][role["next"]]
    return [p + part * (q - p) for p, q in zip(a, b)]


def open_and_look(t, editor, role):
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0 and role["bone"] in s["bones"])
    t.check_equal("opens walking", state["clip"], role["clip"])
    t.check("the clip plays at once", state["playing"])
    t.check_equal("the rig is empty", (state["document"]["primitives"], state["document"]["modified"]), (0, False))
    editor.one_sided()
    editor.choose_clip(-1, "")
    if role["orbit"]:
        before = editor.state()["bones"]
        x, y, width, height = editor.state()["viewport"]
        corner = [x + 0.6 * width, y + 0.95 * height]
        editor.drag(corner, [corner[0] + role["orbit"], corner[1]])
        after = editor.wait_until("the view to rest", lambda s: not s["status"].startswith("Orbit"))["bones"]
        farthest = max(math.dist(before[bone], after[bone]) for bone in before if bone in after)
        t.check("a drag beside the character turns the view", farthest > 50, farthest)


def add_muscle(t, editor, role):
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")
    editor.move(between(editor.state(), role, role["stroke"][0]))
    editor.wait_until("the bone under the pointer to be named", lambda s: "grows on " + role["bone"] in s["status"])
    editor.press()
    editor.wait_until("a muscle where the skin is pressed", lambda s: s["document"]["primitives"] == 1)
    for part in role["stroke"][1:]:
        editor.move(between(editor.state(), role, part))
    editor.release()
    state = editor.wait_until("the muscle to be a step", lambda s: s["document"]["undo"] == 1)
    t.check_equal("exactly one muscle", state["document"]["primitives"], 1)
    t.check_equal("it is selected", len(state["document"]["selection"]), 1)
    t.check("the document has changes", state["document"]["modified"])
    state = editor.save_as(t.folder / "first.rig.json")
    muscle = rigs.only_primitive(json.loads((t.folder / "first.rig.json").read_text()))
    t.check_equal("it is on the bone under the pointer", muscle["bone"], role["bone"])
    t.check_equal("it is what is selected", state["document"]["selection"], [muscle["name"]])
    t.check("its long axis lies along the drag", muscle["radii"][0] > max(muscle["radii"][1:]), muscle["radii"])


def change_with_handles(t, editor):
    before = rigs.only_primitive(editor.saved_rig())
    editor.tap("e", "the rotate tool", lambda s: s["gizmo"]["mode"] == "rotate")
    editor.drag_handle("rotate.screen", [(15, 0), (30, 0), (30, 20), (30, 40)])
    turned = rigs.only_primitive(editor.saved_rig())
    t.check_equal("the ring turns the muscle and does nothing else", rigs.changed_parts(before, turned), {"rotation"})
    editor.tap("r", "the scale tool", lambda s: s["gizmo"]["mode"] == "scale")
    handles = editor.state()["gizmo"]["handles"]
    # The arm with the most room on the screen.
    center = handles["scale.uniform"]
    arm = max((h for h in handles if h in ("scale.x", "scale.y", "scale.z")), key=lambda h: math.dist(handles[h], center))
    out = [a - b for a, b in zip(handles[arm], center)]
    editor.drag_handle(arm, [[part * v for v in out] for part in (0.3, 0.7, 1.0)])
    stretched = rigs.only_primitive(editor.saved_rig())
    axis = "xyz".index(arm[-1])
    t.check_equal("the arm changes radii and nothing else", rigs.changed_parts(turned, stretched), {"radii"})
    t.check_equal("of the radii only its own", rigs.changed_axes(turned["radii"], stretched["radii"], 0.0), {axis})
    t.check("pulled outwards it grows", stretched["radii"][axis] > 1.2 * turned["radii"][axis])
    editor.drag_handle("scale.uniform", [(20, 0), (40, -10), (60, -20)])
    grown = rigs.only_primitive(editor.saved_rig())
    t.check("the middle handle makes it grow as a whole",
            all(b > 1.2 * a for a, b in zip(stretched["radii"], grown["radii"])), grown["radii"])


def refine(t, editor):
    before = editor.state()
    editor.type_number("smoothing/tolerance", "0.03")
    state = editor.wait_until("a small tolerance", lambda s: s["tolerance"] < 0.00031)
    t.check("it makes more triangles", state["triangles"] > 1.2 * before["triangles"], state["triangles"])
    editor.wait_until("it to be a step", lambda s: s["document"]["undo"] == before["document"]["undo"] + 1)


def play_and_edit(t, editor, role):
    index = editor.state()["clips"].index(role["clip"])
    editor.choose_clip(index, role["clip"])
    editor.type_number("timeline/speed", "0.1")
    editor.tap("space", "the clip to play", lambda s: s["playing"])
    times = [s["clip_time"] for s in editor.next_frames(3)]
    t.check("time passes", len(set(times)) == 3, times)
    editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    before = editor.state()
    after = editor.drag_handle("move.center", [(6, 0), (12, 3), (14, 6)])
    t.check("the clip went on playing during the drag", after["playing"] and after["clip_time"] != before["clip_time"])
    t.check_equal("still one muscle", after["document"]["primitives"], 1)
    editor.tap("space", "the clip to stop", lambda s: not s["playing"])


def undo_and_redo(t, editor):
    saved = editor.saved_rig()
    steps = editor.state()["document"]["undo"]
    t.check_equal("steps: muscle, turn, stretch, growth, tolerance, move", steps, 6)
    for left in reversed(range(steps)):
        editor.tap("ctrl+z", "undo to %d" % left, lambda s: s["document"]["undo"] == left)
    state = editor.state()
    t.check_equal("all undone", (state["document"]["primitives"], round(state["tolerance"], 6)), (0, 0.001))
    t.check("undone, the document differs from the file", state["document"]["modified"])
    for done in range(1, steps + 1):
        editor.tap("ctrl+shift+z", "redo to %d" % done, lambda s: s["document"]["undo"] == done)
    t.check("redone, it is what the file holds", not editor.state()["document"]["modified"])
    t.check_equal("redone, the rig is the same", editor.saved_rig(), saved)
    t.check_equal("what undo took away is selected again", editor.state()["document"]["selection"],
                  [saved["primitives"][0]["name"]])


def save_and_reopen(t, editor, picture):
    second = t.folder / "second.rig.json"
    editor.save_as(second)
    editor.screenshot(picture)
    t.check_equal("quits without a question", editor.quit(), 0)
    told = t.run_program("inspect", "--json", second)
    t.check_equal("inspect reads the saved rig: " + told.stderr, told.returncode, 0)
    t.check("inspect tells of its character", json.loads(told.stdout)["triangles"] > 0)
    again = t.edit(second)
    state = again.wait_until("the saved rig", lambda s: s["document"]["primitives"] == 1 and s["triangles"] > 0)
    t.check_equal("its tolerance came with it", round(state["tolerance"], 6), 0.0003)
    t.check("freshly opened it has no changes", not state["document"]["modified"])
    third = t.folder / "third.rig.json"
    again.save_as(third)
    t.check("saved, opened, saved again: byte for byte the same", second.read_bytes() == third.read_bytes())
    t.check_equal("the second window quits too", again.quit(), 0)


def story(t):
    name = sys.argv[5]
    role = CAST[name]
    source = (t.characters if role["real"] else t.assets) / role["file"]
    if role["real"] and not source.is_file():
        raise driver.Skip("real characters are not at hand")
    editor = t.edit(t.copy(source))
    open_and_look(t, editor, role)
    add_muscle(t, editor, role)
    change_with_handles(t, editor)
    refine(t, editor)
    play_and_edit(t, editor, role)
    undo_and_redo(t, editor)
    save_and_reopen(t, editor, t.out / ("main_story_%s.png" % name))


if __name__ == "__main__":
    sys.exit(driver.run("main_story_" + sys.argv[5], story))
