# tests/gui/posing.py: joints turned by hand, undone, mirrored; the range of motion from the list of clips.
import math
import sys

import driver

ARM, HAND, OTHER_ARM, OTHER_HAND = "upper_arm.L", "hand.L", "upper_arm.R", "hand.R"


def moved(before, after, bone):
    return math.dist(before["bones"][bone], after["bones"][bone])


def selects_a_joint(t, editor):
    editor.choose_clip(-1, "")
    editor.click("toolstrip/pose")
    state = editor.wait_until("the pose tool", lambda s: s["tool"] == "pose")
    editor.move(state["bones"][ARM])
    editor.press()
    editor.release()
    state = editor.wait_until("a click on a joint", lambda s: s["document"]["bone"] == ARM and s["gizmo"]["visible"])
    t.check("only rings stand around it", all(name.startswith("rotate") for name in state["gizmo"]["handles"]))
    return state


def turns(t, editor, before):
    editor.grab("rotate.screen")
    start = editor.mouse
    for step in (15, 30, 45, 60):
        editor.move((start[0] + step, start[1] + step))
    editor.wait_until("the joint to turn", lambda s: s["pose"]["overrides"] == 1)
    editor.release()
    state = editor.wait_until("the end of the drag", lambda s: not s["gizmo"]["dragging"])
    t.check("the hand goes along", moved(before, state, HAND) > 10.0, moved(before, state, HAND))
    t.check("the joint itself stays", moved(before, state, ARM) < 1.0, moved(before, state, ARM))
    t.check("the other hand stays", moved(before, state, OTHER_HAND) < 0.01)
    t.check_equal("one step of the history, the rig as it was", (state["document"]["undo"], state["document"]["modified"]),
                  (1, False))
    t.check("the timeline says so", "timeline/posed" in state["widgets"])
    return state


def cancels(t, editor, posed):
    editor.grab("rotate.screen")
    start = editor.mouse
    editor.move((start[0] - 50, start[1] + 40))
    editor.wait_until("another turn", lambda s: s["pose"]["turns"] != posed["pose"]["turns"])
    editor.tap("Escape", "Esc", lambda s: not s["gizmo"]["dragging"])
    editor.release()
    t.check_equal("Esc goes back to the turn before", editor.state()["pose"], posed["pose"])


def mirrors_and_resets(t, editor, before):
    state = editor.tap("ctrl+shift+p", "the other side", lambda s: set(s["pose"]["turns"]) == {ARM, OTHER_ARM})
    t.check("the other hand follows", moved(before, state, OTHER_HAND) > 10.0)
    editor.click("timeline/pose-reset")
    state = editor.wait_until("the reset, and nothing said of poses any more",
                              lambda s: s["pose"]["overrides"] == 0 and "timeline/posed" not in s["widgets"])
    t.check("the hand is where it was", moved(before, state, HAND) < 0.01)


def range_of_motion(t, editor):
    count = len(editor.state()["clips"])
    editor.click("timeline/clip")
    editor.click("timeline/clip/range-of-motion")
    state = editor.wait_until("the range of motion", lambda s: s["clip"] == "Range of motion" and s["playing"])
    t.check_equal("one clip more", len(state["clips"]), count + 1)
    later = editor.wait_until("a second of it", lambda s: s["clip_time"] > state["clip_time"] + 0.8)
    t.check("joints move", any(moved(state, later, bone) > 1.0 for bone in later["bones"] if bone in state["bones"]))
    t.check("the document is as it was", not later["document"]["modified"])


def story(t):
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: ARM in s["bones"])
    before = selects_a_joint(t, editor)
    posed = turns(t, editor, before)
    cancels(t, editor, posed)
    mirrors_and_resets(t, editor, before)
    range_of_motion(t, editor)
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("posing", story))
