# tests/gui/library.py: muscles from the library by a click and by hand, kept as a set, and the set on another character.
# Usage: library.py PROGRAM ROOT OUT CHARACTERS
import sys

import driver


def library(t):
    other = t.copy(t.assets / "demo.glb")
    editor = t.edit(t.copy(t.assets / "humanoid.glb"))
    editor.wait_until("a character", lambda s: "upper_arm.L" in s["bones"])
    editor.save_as(t.folder / "first.rig.json")
    editor.key("space")
    editor.click("library/tab")
    editor.click("library/athlete/biceps")
    editor.wait_until("a pair", lambda s: s["document"]["primitives"] == 2 and s["document"]["undo"] == 1)
    editor.settle()
    editor.screenshot(t.out / "library.png")

    left, top, width, height = editor.state()["viewport"]
    hip, knee = (editor.state()["bones"][bone] for bone in ("thigh.R", "shin.R"))
    editor.drag(editor.widget("library/athlete/deltoid, side"), [0.4 * a + 0.6 * b for a, b in zip(hip, knee)][:2])
    editor.wait_until("a second pair", lambda s: s["document"]["primitives"] == 4)
    rig = editor.saved_rig()
    bones = sorted(each["bone"] for each in rig["primitives"])
    t.check_equal("on the arms and where it was let go", bones, ["thigh.L", "thigh.R", "upper_arm.L", "upper_arm.R"])
    editor.drag(editor.widget("library/athlete/biceps"), (left + 0.9 * width, top + 0.4 * height))
    editor.settle()
    t.check_equal("nothing beside the character", editor.state()["document"]["primitives"], 4)

    editor.click("library/save-set")
    editor.type("Mine")
    editor.key("Return")
    driver.wait_for("the file", lambda: (t.folder / "config" / "sinew" / "sets" / "Mine.json").exists())
    editor.key("ctrl+s")
    editor.wait_until("saved", lambda s: not s["document"]["modified"])
    editor.kill()

    again = t.edit(other)
    again.wait_until("a character", lambda s: s["document"]["primitives"] == 0)
    again.key("space")
    again.click("library/tab")
    again.click("library/athlete")
    again.settle()
    again.screenshot(t.out / "library_own.png")
    again.click("library/Mine/deltoid, side")
    again.wait_until("its pair", lambda s: s["document"]["primitives"] == 2)
    again.tap("ctrl+z", "one step back", lambda s: s["document"]["primitives"] == 0)


if __name__ == "__main__":
    sys.exit(driver.run("library", library))
