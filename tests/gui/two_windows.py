# tests/gui/two_windows.py: two windows on one rig: each is asked before it writes over the other's work.
import json
import pathlib
import sys

import driver

SCREEN = (2600, 820)
SECOND_AT = (1300, 0)


def windows(editor):
    return set(editor.xdotool("search", "--onlyvisible", "--name", ".").split())


def second_window(t, first, file):
    before = windows(first)
    second = t.edit(file)
    own = (windows(second) - before).pop()
    first.window, second.window = before.pop(), own
    second.xdotool("windowmove", own, *SECOND_AT)
    second.origin = SECOND_AT
    second.move((640, 400))
    return second


def enter(editor):
    """Pointer and keys are this window's from here on."""
    editor.move((640, 12))
    editor.xdotool("windowfocus", "--sync", editor.window)


def add_muscle(editor):
    enter(editor)
    count = editor.state()["document"]["primitives"]
    if editor.state()["document"]["bone"] != "thigh.L":
        editor.click("outliner/bone/thigh.L")
        editor.wait_until("the bone to be selected", lambda s: s["document"]["bone"] == "thigh.L")
    editor.key("ctrl+m")
    return editor.wait_until("a muscle", lambda s: s["document"]["primitives"] > count)["document"]["primitives"]


def muscles_in(path):
    return len(json.loads(path.read_text())["primitives"])


def ask(editor, key="ctrl+s"):
    enter(editor)
    editor.key(key)
    return editor.wait_until("the question about the changed file", lambda s: s["dialog"] == "conflict")


def answer(editor, which):
    editor.click("conflict/" + which)
    return editor.wait_until("the question to go", lambda s: s["dialog"] == "" and "conflict/cancel" not in s["widgets"])


def save(editor):
    enter(editor)
    editor.key("ctrl+s")
    editor.wait_until("it to be saved", lambda s: not s["document"]["modified"])


def conflicts(t, one, two, rig):
    add_muscle(one)
    mine = add_muscle(two)
    mine = add_muscle(two)
    save(one)
    theirs = rig.read_bytes()
    ask(two)
    two.settle()
    two.screenshot(t.out / "two_windows_question.png")
    t.check("nothing is written before the answer", rig.read_bytes() == theirs)
    t.check("cancel leaves it unsaved", answer(two, "cancel")["document"]["modified"])
    ask(two)
    state = answer(two, "both")
    beside = t.folder / "arm 2.rig.json"
    t.check_equal("kept under a name beside it", state["document"]["path"], str(beside))
    t.check("the other one is as it was", rig.read_bytes() == theirs)
    t.check_equal("and this one is whole", muscles_in(beside), mine)


def reload(t, one, rig):
    """Another program writes the file under an unmodified document, then under a modified one."""
    changed = json.loads(rig.read_text())
    changed["primitives"] = []
    rig.write_text(json.dumps(changed))
    one.wait_until("it to be told", lambda s: any("changed on disk" in line for line in s["messages"]))
    t.check("a change on disk is told by itself", True)
    add_muscle(one)
    ask(one)
    state = answer(one, "reload")
    t.check_equal("the version on disk is loaded", state["document"]["primitives"], 0)
    t.check("and counts as saved", not state["document"]["modified"])


def deleted(t, one, rig):
    count = add_muscle(one)
    rig.unlink()
    ask(one)
    t.check("a file that is gone cannot be reloaded", "conflict/reload" not in one.state()["widgets"])
    answer(one, "overwrite")
    driver.wait_for("it to be written again", rig.exists)
    t.check_equal("all of it is in the file", muscles_in(rig), count)


def killed(t, one, two):
    """Both have unsaved work; both are killed; both works are there."""
    muscles = [add_muscle(one), add_muscle(two)]
    recovery = pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "recovery"
    driver.wait_for("two autosaves", lambda: len(list(recovery.glob("*.json"))) == 2)
    driver.wait_for("the work in them", lambda: sorted(
        len(json.loads(file.read_text())["rig"]["primitives"]) for file in recovery.glob("*.json")) == sorted(muscles))
    one.kill()
    two.kill()
    t.check_equal("the work of both is left", len(list(recovery.glob("*.json"))), 2)


def recent_files(t):
    preferences = json.loads((pathlib.Path(t.environment["XDG_CONFIG_HOME"]) / "sinew" / "preferences.json").read_text())
    return [pathlib.Path(path).name for path in preferences["recent_files"]]


def story(t):
    place = pathlib.Path(t.environment["XDG_CONFIG_HOME"]) / "sinew" / "preferences.json"
    place.parent.mkdir(parents=True)
    place.write_text(json.dumps({"format": "sinew-preferences", "version": 1, "autosave_seconds": 1}))
    maker = t.edit(t.copy(t.assets / "demo.glb"))
    maker.wait_until("the character", lambda s: "thigh.L" in s["bones"])
    rig = t.folder / "arm.rig.json"
    maker.save_as(rig)
    t.check_equal("a rig is made", maker.quit(), 0)
    one = t.edit(rig)
    one.wait_until("the character", lambda s: "thigh.L" in s["bones"])
    two = second_window(t, one, rig)
    two.wait_until("the character", lambda s: "thigh.L" in s["bones"])
    conflicts(t, one, two, rig)
    driver.wait_for("the new name among the recent files", lambda: "arm 2.rig.json" in recent_files(t))
    enter(one)
    wide = one.state()["viewport"][2]
    one.tap("t", "a panel to go", lambda s: s["viewport"][2] > wide)
    driver.wait_for("the layout to be written", lambda: not json.loads(place.read_text())["layout"]["left_shown"])
    t.check("one window's settings keep the other's recent files", "arm 2.rig.json" in recent_files(t), recent_files(t))
    one.tap("t", "the panel to come", lambda s: s["viewport"][2] == wide)
    reload(t, one, rig)
    deleted(t, one, rig)
    killed(t, one, two)


if __name__ == "__main__":
    sys.exit(driver.run("two_windows", story, SCREEN))
