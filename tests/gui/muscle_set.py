# tests/gui/muscle_set.py: a set of muscles is added, made heavier by its slider, refined, checked, saved and taken back.
# Usage: muscle_set.py PROGRAM ROOT OUT CHARACTERS
import json
import sys

import driver


def volume(rig):
    def of(radii):
        return radii[0] * radii[1] * radii[2]
    return sum(of(each["radii"]) for each in rig["primitives"])


def muscle_set(t):
    editor = t.edit(t.copy(t.assets / "humanoid.glb"))
    editor.wait_until("a character", lambda s: "upper_arm.L" in s["bones"])
    path = t.folder / "set.rig.json"
    editor.save_as(path)
    bare = json.loads(path.read_text())

    editor.palette("add muscle set", "muscles/add-set")
    editor.wait_until("a step", lambda s: s["document"]["undo"] == 1)
    added = editor.saved_rig()
    names = [each["name"] for each in added["primitives"]]
    t.check("an athlete's muscles", len(names) > 60 and "biceps L" in names and "biceps R" in names, names)
    editor.screenshot(t.out / "muscle_set.png")

    left, right = editor.widget("muscle-set/mass", 0.5), editor.widget("muscle-set/mass", 0.75)
    editor.drag(left, right)
    editor.settle()
    editor.wait_until("the step again", lambda s: s["document"]["undo"] == 1)
    heavier = editor.saved_rig()
    t.check("it is heavier", volume(heavier) > 1.1 * volume(added), (volume(heavier), volume(added)))
    # What a heavier one cannot keep in the flesh is left out, and what it can comes back.
    others = set(names) ^ {each["name"] for each in heavier["primitives"]}
    t.check("by the same muscles, all but a few", len(others) <= 4, others)
    editor.screenshot(t.out / "muscle_set_heavier.png")

    editor.click("muscle-set/done")
    editor.select_muscle("biceps L")
    editor.type_number("inspector/radius.x", "0.05")
    editor.wait_until("a second step", lambda s: s["document"]["undo"] == 2)
    editor.palette("check muscles", "play/check")
    driver.wait_for("what was found", lambda: editor.widget("check/heading"))
    editor.click("check/close")

    for undo in (1, 0):
        editor.tap("ctrl+z", "one step back", lambda s, undo=undo: s["document"]["undo"] == undo)
    t.check_equal("the rig is what it was", editor.saved_rig(), bare)
    editor.quit()


if __name__ == "__main__":
    sys.exit(driver.run("muscle_set", muscle_set))
