# tests/gui/two_windows.py: two windows on one rig: muscles pass by the clipboard, and each is asked before it writes over the other.
import json
import pathlib
import sys

import driver

SCREEN = (2600, 820)
SECOND_AT = (1300, 0)


def opened(t, file):
    editor = t.edit(file)
    editor.wait_until("the character", lambda s: "thigh.L" in s["bones"])
    return editor


def second_window(t, first, file):
    all_windows = lambda: set(first.xdotool("search", "--onlyvisible", "--name", ".").split())
    before = all_windows()
    second = opened(t, file)
    (one,), (two,) = before, all_windows() - before
    first.window, second.window = lambda: one, lambda: two
    second.xdotool("windowmove", two, *SECOND_AT)
    second.origin = SECOND_AT
    second.move((640, 400))
    return second


def enter(editor):
    """Pointer and keys are this window's from here on."""
    editor.move((640, 12))
    editor.xdotool("windowfocus", "--sync", editor.window())


def add_muscle(editor):
    enter(editor)
    count = editor.state()["document"]["primitives"]
    if editor.state()["document"]["bone"] != "thigh.L":
        editor.click("outliner/bone/thigh.L")
        editor.wait_until("the bone to be selected", lambda s: s["document"]["bone"] == "thigh.L")
    editor.key("ctrl+m")
    return editor.wait_until("a muscle", lambda s: s["document"]["primitives"] > count)["document"]["primitives"]


def copied(t, one, two):
    """From one window into the other."""
    add_muscle(one)
    one.key("ctrl+c")
    one.settle()
    enter(two)
    two.tap("ctrl+v", "the muscle here as well", lambda s: s["document"]["primitives"] > 0)
    t.check_equal("in both windows the same", two.state()["document"]["primitives"], one.state()["document"]["primitives"])


def ask(editor):
    enter(editor)
    return editor.tap("ctrl+s", "the question about the changed file", lambda s: s["dialog"] == "conflict")


def answer(editor, which):
    editor.click("conflict/" + which)
    return editor.wait_until("the question to go", lambda s: s["dialog"] == "" and "conflict/cancel" not in s["widgets"])


def conflicts(t, one, two, rig):
    mine = add_muscle(two)
    enter(one)
    one.tap("ctrl+s", "the first one's work to be saved", lambda s: not s["document"]["modified"])
    theirs = rig.read_bytes()
    two.wait_until("the second one to be told", lambda s: any("changed on disk" in line for line in s["messages"]))
    ask(two)
    t.check("nothing is written before the answer", rig.read_bytes() == theirs)
    t.check("cancel leaves it unsaved", answer(two, "cancel")["document"]["modified"])
    ask(two)
    beside = t.folder / "arm 2.rig.json"
    t.check_equal("kept under a name beside it", answer(two, "both")["document"]["path"], str(beside))
    t.check("the other one is as it was", rig.read_bytes() == theirs)
    t.check_equal("and this one is whole", len(json.loads(beside.read_text())["primitives"]), mine)


def settings(t, one):
    """What one window writes keeps what the other has written."""
    stored = lambda: json.loads(t.preferences.read_text())
    recent = lambda: [pathlib.Path(path).name for path in stored()["recent_files"]]
    driver.wait_for("the new name among the recent files", lambda: "arm 2.rig.json" in recent())
    enter(one)
    wide = one.state()["viewport"][2]
    one.tap("t", "a panel to go", lambda s: s["viewport"][2] > wide)
    driver.wait_for("the layout to be written", lambda: not stored()["layout"]["left_shown"])
    t.check("one window's settings keep the other's recent files", "arm 2.rig.json" in recent(), recent())
    one.tap("t", "the panel to come", lambda s: s["viewport"][2] == wide)


def killed(t, one, two):
    """Both have unsaved work; both are killed; both works are there."""
    muscles = sorted([add_muscle(one), add_muscle(two)])
    recovery = pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "recovery"
    kept = lambda: sorted(len(json.loads(file.read_text())["rig"]["primitives"]) for file in recovery.glob("*.json"))
    driver.wait_for("two autosaves with all of the work", lambda: kept() == muscles)
    one.kill()
    two.kill()
    t.check_equal("the work of both is left", kept(), muscles)


def story(t):
    t.prefer(autosave_seconds=1)
    maker = opened(t, t.copy(t.assets / "demo.glb"))
    rig = t.folder / "arm.rig.json"
    maker.save_as(rig)
    t.check_equal("a rig is made", maker.quit(), 0)
    one = opened(t, rig)
    two = second_window(t, one, rig)
    copied(t, one, two)
    conflicts(t, one, two, rig)
    settings(t, one)
    killed(t, one, two)


if __name__ == "__main__":
    sys.exit(driver.run("two_windows", story, SCREEN))
