# tests/gui/keep_muscles.py: a character is dropped on one with muscles: they go on it, or not; taken back and saved.
# Usage: keep_muscles.py PROGRAM ROOT OUT CHARACTERS
import json
import sys

import driver


def keep_muscles(t):
    rig = t.copy(t.assets / "humanoid-flex.rig.json", "hero.rig.json")
    character = t.copy(t.assets / "humanoid.glb")
    other = t.copy(t.assets / "horse.glb")
    if (t.characters / "man.glb").exists():
        other = t.copy(t.characters / "man.glb")
    editor = t.edit(rig)
    count = editor.wait_until("muscles", lambda s: s["document"]["primitives"] > 0)["document"]["primitives"]

    editor.drop(other)
    editor.wait_until("the question", lambda s: s["dialog"] == "keep-muscles")
    editor.settle()
    editor.screenshot(t.out / "keep_muscles_question.png")
    editor.tap("Escape", "the question to go", lambda s: s["dialog"] == "")
    t.check_equal("nothing is lost", editor.state()["document"]["primitives"], count)

    editor.drop(other)
    editor.click("keep-muscles/keep")
    kept = editor.wait_until("the other body with muscles",
                             lambda s: s["dialog"] == "" and s["document"]["primitives"] > 0 and s["document"]["undo"] == 1)
    editor.settle()
    editor.screenshot(t.out / "keep_muscles_kept.png")
    t.check("it is not saved yet", editor.title().startswith(other.name + "*"), editor.title())
    path = t.folder / "other.rig.json"
    editor.save_as(path)
    written = json.loads(path.read_text())
    t.check_equal("of that character", written["character"], other.name)
    t.check_equal("all are written", len(written["primitives"]), kept["document"]["primitives"])
    editor.tap("ctrl+z", "one step back", lambda s: s["document"]["undo"] == 0)
    t.check_equal("a body without muscles", editor.state()["document"]["primitives"], 0)

    editor.drop(rig)
    editor.click("unsaved/discard")
    editor.wait_until("the first one again", lambda s: s["document"]["primitives"] == count)
    t.check_equal("as it was on disk", json.loads(rig.read_text())["character"], character.name)
    editor.drop(other)
    editor.click("keep-muscles/without")
    editor.wait_until("bare", lambda s: s["document"]["primitives"] == 0)
    editor.quit()


if __name__ == "__main__":
    sys.exit(driver.run("keep_muscles", keep_muscles))
