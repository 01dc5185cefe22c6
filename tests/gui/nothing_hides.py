# tests/gui/nothing_hides.py: what the editor says while nothing moves: tooltips, reasons, messages, toasts.
import json
import subprocess
import sys

import driver


def pixels(t, editor, box):
    """The screen's pixels in x, y, width, height."""
    x, y, width, height = map(round, box)
    return subprocess.run(["import", "-window", "root", "-crop", "%dx%d+%d+%d" % (width, height, x, y), "-depth", "8",
                           "rgb:-"], env=t.environment, check=True, capture_output=True, timeout=driver.PATIENCE).stdout


def tooltip_comes(t, editor, control, picture=None):
    """Hovered, the picture beside the pointer changes by itself: no event comes, no clip plays."""
    editor.point_at(lambda: editor.widget(control))
    x, y = editor.mouse
    beside = (x + 14, y + 20, 60, 24)
    before = pixels(t, editor, beside)
    driver.wait_for("a tooltip of " + control, lambda: pixels(t, editor, beside) != before)
    if picture:
        editor.screenshot(t.out / picture)
    t.check("a tooltip of %s comes while nothing moves" % control, True)


def tooltips(t, editor):
    editor.tap("space", "the clip to stand still", lambda s: not s["playing"])
    tooltip_comes(t, editor, "toolstrip/axes")
    tooltip_comes(t, editor, "toolstrip/territory")
    editor.click("menu/edit")
    tooltip_comes(t, editor, "edit/delete", "nothing_hides_menu.png")
    editor.tap("Escape", "the menu to close", lambda s: "edit/delete" not in s["widgets"])


def toasts(t, editor):
    editor.click("outliner/bone/thigh.L")
    editor.wait_until("the bone to be selected", lambda s: s["document"]["bone"] == "thigh.L")
    editor.tap("ctrl+m", "a muscle", lambda s: s["document"]["undo"] == 1)
    status = editor.settle()["status"]
    said = editor.tap("ctrl+z", "undo to be said", lambda s: s.get("toast"))
    t.check("undo says what it undid", said["toast"].startswith("Undone: "), said["toast"])
    box = editor.wait_until("the toast", lambda s: "toast" in s["widgets"])["widgets"]["toast"]
    x, y = editor.mouse
    t.check("it is not under the pointer", not (box[0] <= x <= box[0] + box[2] and box[1] <= y <= box[1] + box[3]), box)
    editor.screenshot(t.out / "nothing_hides_toast.png")
    editor.wait_until("the toast to go by itself", lambda s: s["toast"] == "" and "toast" not in s["widgets"])
    said = editor.tap("ctrl+d", "a reason why nothing is copied", lambda s: s.get("toast"))
    t.check("a key that can do nothing says why", "Select a muscle first" in said["toast"], said["toast"])
    editor.tap("ctrl+shift+z", "redo", lambda s: s["document"]["undo"] == 1 and s["toast"].startswith("Redone: "))
    editor.save_as(t.folder / "mine.rig.json")
    t.check_equal("saving is said", editor.state()["toast"], "Saved mine.rig.json")
    editor.wait_until("the toast to go", lambda s: s["toast"] == "")
    t.check("the status line says what the tool does, as before", editor.state()["status"] != "" and status != "")


def with_unknown_bones(t):
    """A rig of another skeleton."""
    rig = json.loads((t.assets / "demo.rig.json").read_text())
    rig["character"] = "lizard.glb"
    for muscle in rig["primitives"][:2]:
        muscle["bone"] = "upper_arm.X"
    path = t.folder / "foreign.rig.json"
    path.write_text(json.dumps(rig))
    return path, rig["primitives"][0]["name"]


def messages(t, editor):
    path, name = with_unknown_bones(t)
    editor.key("ctrl+o")
    editor.wait_until("the dialog", lambda s: s["dialog"] == "open")
    editor.fill("dialog/path", str(path))
    state = editor.wait_until("the rig", lambda s: s["document"]["path"] == str(path) and s["messages"])
    wanted = 'Muscle "%s": this character has no bone "upper_arm.X"; it is kept, but has no effect' % name
    t.check("what is missing is said in plain words", wanted in state["messages"], state["messages"])
    t.check("without a path into the file", not any("primitives[" in line for line in state["messages"]))
    broken = t.folder / "broken.rig.json"
    text = path.read_text().replace('"radii": [', '"radii": [-', 1)
    broken.write_text(text)
    editor.key("ctrl+o")
    editor.wait_until("the dialog", lambda s: s["dialog"] == "open")
    editor.fill("dialog/path", str(broken))
    state = editor.wait_until("an error", lambda s: any("broken.rig.json" in line for line in s["messages"]))
    t.check('a wrong number is named by its muscle', '"%s", radius X: expected' % name in state["messages"][-1],
            state["messages"][-1])
    newest = len(state["messages"]) - 1
    box = editor.wait_until("the newest message in sight",
                            lambda s: "messages/dismiss/%d" % newest in s["widgets"])["widgets"]
    t.check("it is on top", all(box["messages/dismiss/%d" % newest][1] <= place[1] for control, place in box.items()
                                if control.startswith("messages/dismiss/")))
    editor.screenshot(t.out / "nothing_hides_messages.png")
    refused = t.run_program("smooth", broken, "-o", t.folder / "x.obj")
    t.check("the command line has the path into the file", "primitives[0].radii[0]" in refused.stderr, refused.stderr)
    if editor.state()["dialog"] == "open":
        editor.tap("Escape", "the dialog to go", lambda s: s["dialog"] == "")
    editor.key("ctrl+o")
    editor.wait_until("the dialog", lambda s: s["dialog"] == "open")
    editor.fill("dialog/path", str(t.folder / "mine.rig.json"))
    editor.wait_until("messages of the file before to go", lambda s: not any("upper_arm.X" in m for m in s["messages"]))
    t.check("messages of another document are gone", True)


def row_is_lit(t, editor, row):
    """The row's left edge differs from the palette's own ground."""
    box = editor.state()["widgets"][row]
    return pixels(t, editor, (box[0] + 2, box[1] + box[3] / 2, 1, 1)) != pixels(
        t, editor, (box[0] - 4, box[1] + box[3] / 2, 1, 1))


def palette(t, editor):
    editor.move((640, 700))
    editor.tap("Escape", "nothing to be selected", lambda s: not s["document"]["selection"])
    editor.tap("ctrl+p", "the palette", lambda s: "palette/query" in s["widgets"])
    editor.type("save")
    editor.wait_until("rows", lambda s: "palette/file/save" in s["widgets"])
    editor.settle()
    t.check("what can be done is preselected", row_is_lit(t, editor, "palette/file/save"))
    editor.key("ctrl+a")
    editor.type("duplicate")
    editor.wait_until("rows", lambda s: "palette/edit/duplicate" in s["widgets"] and
                      "palette/file/save" not in s["widgets"])
    editor.settle()
    t.check("what cannot is not", not row_is_lit(t, editor, "palette/edit/duplicate"))
    editor.screenshot(t.out / "nothing_hides_palette.png")
    editor.tap("Escape", "the palette to go", lambda s: s["dialog"] == "")


def story(t):
    t.copy(t.assets / "demo.glb", "lizard.glb")
    editor = t.edit(t.folder / "lizard.glb")
    editor.wait_until("the character", lambda s: "thigh.L" in s["bones"])
    tooltips(t, editor)
    toasts(t, editor)
    palette(t, editor)
    messages(t, editor)
    t.check_equal("quits", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("nothing_hides", story))
