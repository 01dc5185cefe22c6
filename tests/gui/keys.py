# tests/gui/keys.py: a key is changed in the preferences, does its work, and is still there after a restart.
import json
import sys

import driver


def preferences(t):
    return t.folder / "config" / "sinew" / "preferences.json"


def stored(t):
    """The changes that are on the disk now."""
    file = preferences(t)
    return json.loads(file.read_text())["keys"]["maya"] if file.is_file() else {}


def open_page(editor):
    editor.key("ctrl+comma")
    editor.click("preferences/page/keys")
    editor.widget("preferences/keys/search")


def search(editor, text):
    """Only the actions with this label."""
    editor.click("preferences/keys/search")
    editor.key("ctrl+a")
    editor.type(text)


def ground(state):
    return state["display"]["ground"]


def another_key(t, editor):
    open_page(editor)
    search(editor, "Ground")
    editor.click("preferences/keys/view/ground/1")
    editor.key("ctrl+k")
    editor.wait_until("the row to be changed", lambda s: "preferences/keys/view/ground/reset" in s["widgets"])
    # A taken key: a question, and Esc is no answer.
    editor.click("preferences/keys/view/ground/2")
    editor.key("w")
    editor.widget("preferences/keys/replace")
    editor.screenshot(t.out / "keys-question.png")
    editor.key("Escape")
    editor.wait_until("the question to go", lambda s: "preferences/keys/replace" not in s["widgets"])
    t.check("the dialog stays", "preferences/close" in editor.state()["widgets"])
    # Taken from the tool.
    editor.click("preferences/keys/view/ground/2")
    editor.key("w")
    editor.click("preferences/keys/replace")
    editor.wait_until("an answer", lambda s: "preferences/keys/replace" not in s["widgets"])
    editor.click("preferences/close")
    editor.wait_until("the dialog to close", lambda s: "preferences/close" not in s["widgets"])


def works(t, editor):
    shown, tool = ground(editor.state()), editor.state()["tool"]
    editor.key("ctrl+k")
    editor.wait_until("the ground to change", lambda s: ground(s) != shown)
    editor.key("w")
    state = editor.wait_until("the ground to change back", lambda s: ground(s) == shown)
    t.check_equal("the tool has lost its key", state["tool"], tool)
    # The old key is nobody's: what comes after it is seen, it is not.
    editor.key("0")
    editor.key("ctrl+k")
    editor.wait_until("one change", lambda s: ground(s) != shown)
    editor.key("ctrl+k")
    editor.wait_until("the ground as it was", lambda s: ground(s) == shown)


def story(t):
    file = t.copy(t.assets / "demo.glb")
    editor = t.edit(file)
    editor.wait_until("the character", lambda s: s["bones"])
    another_key(t, editor)
    works(t, editor)
    wanted = {"tool/move": [], "view/ground": ["Ctrl+K", "W"]}
    driver.wait_for("the keys on the disk", lambda: stored(t) == wanted)
    t.check_equal("quits", editor.quit(), 0)
    editor = t.edit(file)
    editor.wait_until("the character", lambda s: s["bones"])
    works(t, editor)
    editor.key("F1")
    editor.wait_until("the key sheet", lambda s: "keys/close" in s["widgets"])
    editor.screenshot(t.out / "keys-sheet.png")
    editor.key("Escape")
    editor.wait_until("the sheet to close", lambda s: "keys/close" not in s["widgets"])
    open_page(editor)
    editor.screenshot(t.out / "keys-page.png")
    editor.click("preferences/keys/reset-all")
    driver.wait_for("no changes on the disk", lambda: stored(t) == {})
    editor.click("preferences/close")
    editor.wait_until("the dialog to close", lambda s: "preferences/close" not in s["widgets"])
    editor.key("w")
    editor.wait_until("the tool on its key", lambda s: s["tool"].lower() == "move")
    t.check_equal("quits", editor.quit(), 0)
    damaged(t, file)


def damaged(t, file):
    """What nobody can use is told, and costs nothing else."""
    saved = json.loads(preferences(t).read_text())
    saved["keys"]["maya"] = {"edit/gone": ["K"], "view/ground": ["Ctrl+K"]}
    preferences(t).write_text(json.dumps(saved))
    editor = t.edit(file)
    state = editor.wait_until("a message", lambda s: s["messages"])
    t.check("it names the action", "edit/gone" in str(state["messages"]), state["messages"])
    shown = ground(state)
    editor.key("ctrl+k")
    editor.wait_until("the other key works", lambda s: ground(s) != shown)
    t.check_equal("quits", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("keys", story))
