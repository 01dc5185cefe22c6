# tests/gui/export.py: File > Export in the real window: the command line's bytes, edits and cancelling meanwhile, the end.
import subprocess
import sys

import driver

# Depths of exports that take so long.
SHORT = 1
MEDIUM = 2  # Time enough for an edit meanwhile.
LONG = 12  # Many seconds: to be canceled.


def open_dialog(editor):
    return editor.tap("ctrl+shift+e", "the export dialog", lambda s: s["dialog"] == "export" and "export/ok" in s["widgets"])


def choose_depth(editor, depth):
    if "export/depth" not in editor.state()["widgets"]:
        editor.click("export/detail/uniform")
    editor.type_number("export/depth", str(depth))


def start(editor, name, depth):
    open_dialog(editor)
    choose_depth(editor, depth)
    editor.click("export/place")
    editor.key("ctrl+a")
    editor.type(name)
    editor.wait_until("the name to be there", lambda s: s["dialog"] == "export")
    editor.click("export/ok")
    return editor.wait_until("the dialog to close", lambda s: s["dialog"] == "")


def running(state):
    return any(export["running"] for export in state["exports"])


def beside(t):
    return sorted(path.name for path in t.folder.iterdir() if path.suffix in (".glb", ".gltf", ".bin"))


def exports_from_the_menu(t, editor, rig):
    editor.click("menu/file")
    editor.point_at(lambda: editor.widget("file/export"))
    editor.click("file/export-character")
    editor.wait_until("the export dialog", lambda s: s["dialog"] == "export" and "export/ok" in s["widgets"])
    choose_depth(editor, SHORT)
    editor.click("export/ok")
    state = editor.wait_until("the figures", lambda s: not s["exports"] and any("RMS" in m for m in s["messages"]))
    t.check("the message names file and figures",
            "demo_muscled.glb: RMS " in state["messages"][-1] and " joints; " in state["messages"][-1], state["messages"])
    file = t.folder / "demo_muscled.glb"
    t.check_equal("the command line exports", t.run_program("export", rig, "--as", "helpers", "--depth", SHORT, "-o", "cli.glb").returncode, 0)
    t.check("the editor's file has the command line's bytes", file.read_bytes() == (t.folder / "cli.glb").read_bytes())
    t.check_equal("it opens", t.run_program("inspect", file).returncode, 0)


def skin_columns(t, editor, name):
    """How many columns of the picture, between the tools above and the plate below, show skin, which is brighter than all behind it."""
    state = editor.wait_until("all samples", lambda s: not s["camera_moving"] and s["samples"] == 16)
    boxes = state["widgets"].items()
    left = max(box[0] + box[2] for key, box in boxes if key.startswith("toolstrip/"))
    top = max(box[1] + box[3] for key, box in boxes if key.startswith("display/"))
    x, _, width, _ = state["viewport"]
    size = round(x + width - left - 8), round(state["widgets"]["legend/export-error"][1] - top - 80)
    shot = t.out / ("export-%s.png" % name)
    editor.screenshot(shot)
    crop = "%dx%d+%d+%d" % (*size, round(left + 8), round(top + 8))
    # The median takes letters and lines away.
    gray = subprocess.run(["convert", str(shot), "-crop", crop, "+repage", "-colorspace", "Gray", "-statistic", "median", "7x7", "-depth",
                           "8", "gray:-"], capture_output=True, check=True).stdout
    return sum(max(gray[column::size[0]]) > 140 for column in range(size[0]))


def error_side_by_side(t, editor):
    """The figure in the status line leads to the moment, a switch puts the exported mesh beside the live one."""
    editor.click("status/export-error")
    editor.wait_until("the plate", lambda s: "export-error/largest" in s["widgets"] and not s["playing"])
    editor.palette("frame all", "view/frame-all")
    alone = skin_columns(t, editor, "alone")
    t.check("the live one alone is seen", alone > 30, alone)
    editor.click("export-error/mesh/side by side")
    both = skin_columns(t, editor, "beside")
    t.check("both are seen, side by side", both > 1.3 * alone, (alone, both))
    editor.palette("frame all", "view/frame-all")
    framed = skin_columns(t, editor, "framed")
    editor.palette("export beside", "view/export-beside")
    again = skin_columns(t, editor, "again")
    t.check("from the palette: the live one alone again", again < 0.7 * framed, (framed, again))
    editor.click("export-error/close")
    editor.wait_until("the plate to go", lambda s: "export-error/close" not in s["widgets"])


def edits_meanwhile(t, editor):
    state = start(editor, "meanwhile.glb", MEDIUM)
    t.check("it runs in the background", running(state), state["exports"])
    undo = state["document"]["undo"]
    editor.select_muscle("glute L")
    editor.key("Delete")
    state = editor.wait_until("the muscle to go", lambda s: s["document"]["undo"] > undo)
    t.check("edited while it runs", running(state), state["exports"])
    editor.tap("ctrl+z", "the muscle to be back", lambda s: s["document"]["undo"] == undo)
    if not state["playing"]:
        editor.tap("space", "the clip to play", lambda s: s["playing"])
    editor.next_frames(10)
    editor.wait_until("the export to end", lambda s: not s["exports"])
    done = t.run_program("export", t.folder / "demo.rig.json", "--as", "helpers", "--depth", MEDIUM, "-o", "cli2.glb")
    t.check_equal("the command line exports at this depth", done.returncode, 0)
    t.check("what was edited meanwhile is not in it",
            (t.folder / "meanwhile.glb").read_bytes() == (t.folder / "cli2.glb").read_bytes())


def canceled(t, editor):
    before = beside(t)
    start(editor, "cancelled.glb", LONG)
    editor.wait_until("it to be under way", lambda s: s["exports"] and s["exports"][0]["share"] > 0.02)
    editor.click("status/export-cancel")
    editor.wait_until("the toast that says so", lambda s: not s["exports"] and "Cancelled: cancelled.glb" in s["toast"])
    t.check_equal("no file is left", beside(t), before)


def quits_meanwhile(t, editor):
    before = beside(t)
    start(editor, "unfinished.glb", LONG)
    editor.wait_until("it to be under way", lambda s: s["exports"] and s["exports"][0]["share"] > 0.02)
    editor.tap("ctrl+q", "the question", lambda s: s["dialog"] == "export-question" and "export-question/cancel" in s["widgets"])
    editor.click("export-question/cancel")
    state = editor.wait_until("the question to go", lambda s: s["dialog"] == "")
    t.check("it goes on", running(state), state["exports"])
    editor.tap("ctrl+q", "the question", lambda s: s["dialog"] == "export-question" and "export-question/now" in s["widgets"])
    editor.click("export-question/now")
    t.check_equal("it quits", editor.wait_for_end(), 0)
    t.check_equal("no half file is left", beside(t), before)


def quits_when_done(t, rig):
    editor = t.edit(rig)
    editor.wait_until("the rig", lambda s: s["document"]["primitives"] > 0)
    start(editor, "last.glb", MEDIUM)
    editor.tap("ctrl+q", "the question", lambda s: s["dialog"] == "export-question" and "export-question/later" in s["widgets"])
    editor.click("export-question/later")
    t.check_equal("it quits when it is done", editor.wait_for_end(), 0)
    t.check("the file is whole", (t.folder / "last.glb").read_bytes() == (t.folder / "cli2.glb").read_bytes())


def story(t):
    t.copy(t.assets / "demo.glb")
    rig = t.copy(t.assets / "demo.rig.json")
    editor = t.edit(rig)
    editor.wait_until("the rig", lambda s: s["document"]["primitives"] > 0)
    exports_from_the_menu(t, editor, rig)
    error_side_by_side(t, editor)
    edits_meanwhile(t, editor)
    canceled(t, editor)
    quits_meanwhile(t, editor)
    quits_when_done(t, rig)


if __name__ == "__main__":
    sys.exit(driver.run("export", story))
