# tests/gui/files.py: what comes in and goes out: refused, dropped, exported while one works on, asked about when the window closes.
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import driver
from clip_gltf import write_clips

BONE = "thigh.L"
DEPTH = 2  # Of an export that gives time for an edit meanwhile.


def refused_without_a_window(t):
    """A bad file is one line, and no screen is looked for; where a rig's character is missing, the window would ask."""
    (t.folder / "text.glb").write_bytes(b"this is no character\n")
    rig = {"format": "sinew-rig", "version": 1, "primitives": []}
    (t.folder / "orphan.rig.json").write_text(json.dumps(dict(rig, character="text.glb")))
    (t.folder / "lost.rig.json").write_text(json.dumps(dict(rig, character="gone.glb")))
    display = t.environment.pop("DISPLAY")
    for name, word in (("absent.glb", "absent.glb"), ("text.glb", "text.glb"), ("orphan.rig.json", "text.glb"),
                       ("lost.rig.json", "gone.glb")):
        done = t.run_program("edit", t.folder / name)
        t.check_equal("%s is refused without a word to the output" % name, (done.returncode, done.stdout), (1, ""))
        t.check("in one line that names %s" % word, done.stderr.count("\n") == 1 and word in done.stderr, done.stderr)
    t.environment["DISPLAY"] = display


def asks_for_the_character(t):
    editor = t.edit(t.folder / "lost.rig.json")
    editor.click("locate/locate")
    editor.wait_until("the file dialog", lambda s: s["dialog"] == "locate-file" and "dialog/path" in s["widgets"])
    editor.fill("dialog/path", str(t.copy(t.assets / "demo.glb")))
    state = editor.wait_until("the rig", lambda s: s["dialog"] == "" and BONE in s["bones"])
    t.check("it counts as changed", state["document"]["modified"])
    t.check_equal("the new path is written, relative", editor.saved_rig()["character"], "demo.glb")
    return editor


def dropped(t, editor):
    """Another program's file over the window: a rig opens, clips play, a character asks about muscles, nonsense is said."""
    rig = t.copy(t.assets / "demo.rig.json", "work.rig.json")
    editor.drop(rig)
    editor.wait_until("the rig", lambda s: s["document"]["primitives"] > 0)
    t.check("it is the open one", editor.title().startswith("work.rig.json"), editor.title())
    editor.drop(write_clips(t.assets / "demo.glb", t.folder / "more.glb", {"Walk": "Crawl"}))
    state = editor.wait_until("its clip", lambda s: s["clip"] == "Crawl" and s["playing"])
    t.check_equal("as one step", (state["dialog"], state["document"]["undo"]), ("", 1))
    editor.tap("ctrl+z", "it to go", lambda s: s["document"]["undo"] == 0 and "Crawl" not in s["clips"])
    editor.drop(t.folder / "demo.glb")
    editor.wait_until("the question", lambda s: s["dialog"] == "keep-muscles" and "keep-muscles/keep" in s["widgets"])
    editor.tap("Escape", "the question to go", lambda s: s["dialog"] == "")
    editor.drop(t.folder / "orphan.rig.json")
    editor.wait_until("a message", lambda s: any("text.glb" in message for message in s["messages"]))
    t.check("the open one stays", editor.title().startswith("work.rig.json"), editor.title())
    editor.click("messages/dismiss-all")
    return rig


def start_export(editor, name):
    editor.tap("ctrl+shift+e", "the export dialog", lambda s: s["dialog"] == "export" and "export/ok" in s["widgets"])
    if "export/depth" not in editor.state()["widgets"]:
        editor.click("export/detail/uniform")
    editor.type_number("export/depth", str(DEPTH))
    editor.click("export/place")
    editor.key("ctrl+a")
    editor.type(name)
    editor.click("export/ok")
    return editor.wait_until("it to run", lambda s: s["dialog"] == "" and any(e["running"] for e in s["exports"]))


def exported_meanwhile(t, editor, rig):
    state = start_export(editor, "meanwhile.glb")
    undo, count = state["document"]["undo"], state["document"]["primitives"]
    editor.key("ctrl+a")
    editor.tap("Delete", "the muscles to go", lambda s: s["document"]["primitives"] == 0)
    t.check("edited while it runs", editor.state()["exports"] != [])
    editor.tap("ctrl+z", "them to be back", lambda s: (s["document"]["undo"], s["document"]["primitives"]) == (undo, count))
    editor.wait_until("the export to end", lambda s: not s["exports"])
    done = t.run_program("export", rig, "--as", "helpers", "--depth", DEPTH, "-o", "cli.glb")
    t.check_equal("the command line exports: " + done.stderr, done.returncode, 0)
    t.check("the same bytes", (t.folder / "meanwhile.glb").read_bytes() == (t.folder / "cli.glb").read_bytes())


def closed(t, editor, rig):
    """By the window's own button: unsaved work is asked about, an export too; nothing is half written."""
    before = rig.read_bytes()
    editor.key("ctrl+a")
    editor.tap("Delete", "a change", lambda s: s["document"]["modified"])
    editor.close()
    editor.click("unsaved/cancel")
    state = editor.wait_until("the question to go", lambda s: s["dialog"] == "" and "unsaved/save" not in s["widgets"])
    t.check("cancel keeps the window and the change", state["document"]["modified"] and rig.read_bytes() == before)
    editor.tap("ctrl+z", "the muscles again", lambda s: not s["document"]["modified"])
    start_export(editor, "last.glb")
    editor.close()
    editor.click("export-question/later")
    t.check_equal("it quits when the export is done", editor.wait_for_end(), 0)
    t.check("the file is whole", (t.folder / "last.glb").read_bytes() == (t.folder / "cli.glb").read_bytes())
    t.check("the rig is as it was", rig.read_bytes() == before)


def story(t):
    refused_without_a_window(t)
    editor = asks_for_the_character(t)
    rig = dropped(t, editor)
    exported_meanwhile(t, editor, rig)
    closed(t, editor, rig)


if __name__ == "__main__":
    sys.exit(driver.run("files", story))
