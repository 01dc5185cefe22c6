# tests/gui/first_steps.py: Help > First steps, done by hand from the first to the last.
# Usage: first_steps.py PROGRAM ROOT OUT CHARACTERS
import sys

import driver


def first_steps(t):
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.palette("first steps", "help/first-steps")
    state = editor.wait_until("the walking man",
                              lambda s: "first-steps/turn" in s["widgets"] and "upper_arm.L" in s["bones"])
    if state["playing"]:
        editor.tap("space", "the pause", lambda s: not s["playing"])
    left, top, width, height = state["viewport"]
    empty = (left + 0.2 * width, top + 0.25 * height)
    editor.drag(empty, (empty[0] + 60, empty[1] + 20))
    editor.settle()
    editor.screenshot(t.out / "first_steps.png")
    editor.select_muscle("biceps L")
    editor.type_number("inspector/radius.x", "0.09")
    editor.wait_until("a thicker muscle", lambda s: s["document"]["undo"] == 1)
    editor.tap("Escape", "nothing selected", lambda s: not s["document"]["selection"])
    editor.tap("f", "all of him", lambda s: "foot.R" in s["bones"] and not s["camera_moving"])
    editor.key("m")
    editor.press_on_skin("thigh.R", lambda s: [0.5 * a + 0.5 * b for a, b in zip(s["bones"]["thigh.R"],
                                                                               s["bones"]["shin.R"])][:2])
    editor.release()
    editor.wait_until("one more", lambda s: s["document"]["undo"] == 2)
    editor.hold("grave")
    editor.wait_until("the last one done", lambda s: "first-steps/turn" not in s["widgets"])
    editor.let_go("grave")
    editor.settle()
    editor.screenshot(t.out / "first_steps_done.png")
    editor.click("first-steps/leave")
    editor.wait_until("no list", lambda s: "first-steps/leave" not in s["widgets"])
    editor.kill()


if __name__ == "__main__":
    sys.exit(driver.run("first_steps", first_steps))
