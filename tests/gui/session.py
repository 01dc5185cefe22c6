# tests/gui/session.py: from one start to the next: layout, keymap, palette, and unsaved work after a kill.
import json
import pathlib
import sys

import driver

BONE = "thigh.L"


def preferences(t):
    return pathlib.Path(t.environment["XDG_CONFIG_HOME"]) / "sinew" / "preferences.json"


def recovery_files(t):
    return sorted((pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "recovery").glob("*.json"))


def set_preferences(t, **changes):
    """Before a start: the format's name and what is to differ from the defaults."""
    preferences(t).parent.mkdir(parents=True, exist_ok=True)
    preferences(t).write_text(json.dumps({"format": "sinew-preferences", "version": 1, **changes}))


def layout_is_remembered(t, file):
    editor = t.edit(file)
    before = editor.state()["viewport"]
    x, y = editor.widget("layout/left")
    editor.drag([x, y], [x + 60, y])
    wide = editor.wait_until("a wider panel", lambda s: s["viewport"][0] > before[0] + 50)["viewport"]
    editor.tap("n", "the right panels to go", lambda s: "layout/right" not in s["widgets"])
    t.check_equal("quits", editor.quit(), 0)
    again = t.edit(file)
    state = again.wait_until("the character", lambda s: BONE in s["bones"])
    t.check("the panel is as wide as it was", abs(state["viewport"][0] - wide[0]) < 2, state["viewport"])
    t.check("what was hidden stays hidden", "layout/right" not in state["widgets"])
    return again


def palette_finds(t, editor):
    wire = editor.state()["display"]["wire"]
    editor.tap("ctrl+p", "the palette", lambda s: s["dialog"] == "palette")
    editor.type("wire")
    editor.wait_until("the wire to be found", lambda s: "palette/view/wire" in s["widgets"])
    editor.tap("Return", "the wire to switch", lambda s: s["display"]["wire"] != wire)
    editor.tap("ctrl+p", "the palette", lambda s: s["dialog"] == "palette")
    editor.type("reset layout")
    editor.tap("Return", "the layout to be reset", lambda s: "layout/right" in s["widgets"])
    editor.wait_until("the palette to be gone", lambda s: s["dialog"] == "")


def keymap_changes(t, editor):
    editor.tap("F1", "the key sheet", lambda s: "keys/blender" in s["widgets"])
    editor.click("keys/blender")
    editor.wait_until("the other keymap", lambda s: s["keymap"] == "blender")
    editor.tap("Escape", "the sheet to go", lambda s: s["dialog"] == "" and "keys/close" not in s["widgets"])


def with_a_muscle(editor):
    count = editor.state()["document"]["primitives"]
    editor.click("outliner/bone/" + BONE)
    editor.wait_until("the bone to be selected", lambda s: s["document"]["bone"] == BONE)
    editor.key("ctrl+m")
    # Its twin on the other side comes with it.
    return editor.wait_until("a muscle", lambda s: s["document"]["primitives"] > count)["document"]["primitives"]


def killed(t, file):
    """Work that was never saved: a copy of it is on the disk within the interval; then the editor is killed."""
    editor = t.edit(file)
    editor.wait_until("the character", lambda s: BONE in s["bones"])
    muscles = with_a_muscle(editor)
    driver.wait_for("an autosave", lambda: recovery_files(t))
    before = file.read_bytes()
    editor.process.kill()
    editor.process.wait()
    t.check_equal("the work is left", len(recovery_files(t)), 1)
    return before, muscles


def recovered(t, file, before, muscles):
    editor = t.edit(file)
    editor.wait_until("the question", lambda s: "recovery/recover/0" in s["widgets"])
    editor.screenshot(t.out / "recovery.png")
    editor.click("recovery/later")
    editor.wait_until("the question to go", lambda s: s["dialog"] == "" and "recovery/later" not in s["widgets"])
    t.check_equal("quits without changes", editor.quit(), 0)
    t.check_equal("later means kept", len(recovery_files(t)), 1)
    editor = t.edit(file)
    editor.wait_until("the question again", lambda s: "recovery/recover/0" in s["widgets"])
    editor.click("recovery/recover/0")
    state = editor.wait_until("the work", lambda s: s["document"]["primitives"] == muscles)
    t.check("it counts as modified", state["document"]["modified"])
    t.check("the title says so", "*" in editor.title(), editor.title())
    t.check("the file was never touched", file.read_bytes() == before)
    editor.save_as(t.folder / "saved.rig.json")
    driver.wait_for("the recovery file to go", lambda: not recovery_files(t))
    t.check_equal("quits", editor.quit(), 0)
    last = t.edit(file)
    state = last.wait_until("the character", lambda s: BONE in s["bones"])
    t.check_equal("after a clean end nothing is asked", state["dialog"], "")
    t.check_equal("quits", last.quit(), 0)


def damaged_preferences(t, file):
    preferences(t).write_text("{ this is no")
    editor = t.edit(file)
    state = editor.wait_until("a message", lambda s: s["messages"])
    t.check("it names the file", "preferences.json" in state["messages"][0], state["messages"])
    t.check("the damaged one is kept", preferences(t).with_name("preferences.json.bad").is_file())
    t.check_equal("quits", editor.quit(), 0)


def story(t):
    file = t.copy(t.assets / "demo.glb")
    set_preferences(t, autosave_seconds=1)
    editor = layout_is_remembered(t, file)
    palette_finds(t, editor)
    keymap_changes(t, editor)
    t.check_equal("quits", editor.quit(), 0)
    t.check_equal("the keymap is remembered", json.loads(preferences(t).read_text())["keymap"], "blender")
    recovered(t, file, *killed(t, file))
    damaged_preferences(t, file)


if __name__ == "__main__":
    sys.exit(driver.run("session", story))
