# tests/gui/files.py: bad files, unsaved changes and places that cannot be written. Nothing is lost, everything is said.
import pathlib
import sys

import driver

BONE = "thigh.L"


def with_a_muscle(t, editor):
    """One muscle more, from the outliner."""
    count = editor.state()["document"]["primitives"]
    editor.click("outliner/bone/" + BONE)
    editor.wait_until("the bone to be selected", lambda s: s["document"]["bone"] == BONE)
    editor.click("outliner/add")
    return editor.wait_until("a muscle", lambda s: s["document"]["primitives"] > count)


def bad_files(t):
    """name: a file that cannot be opened, and a word that the complaint must have."""
    whole = (t.assets / "demo.glb").read_bytes()
    files = {"absent.glb": None, "cut.glb": whole[:len(whole) // 2], "text.glb": b"this is no character\n",
             "broken.rig.json": b'{ "format": "sinew-rig", "version": 1, ',
             "orphan.rig.json": b'{ "format": "sinew-rig", "version": 1, "character": "cut.glb", "primitives": [] }'}
    for name, data in files.items():
        if data is not None:
            (t.folder / name).write_bytes(data)
    return list(files)


def refused_on_the_command_line(t, names):
    for name in names:
        done = t.run_program("edit", t.folder / name)
        t.check_equal("the editor does not open %s" % name, done.returncode, 1)
        lines = done.stderr.splitlines()
        t.check("it says why in one line that names the file", len(lines) == 1 and name in lines[0], done.stderr)
        t.check_equal("and nothing else", done.stdout, "")


def open_from_dialog(editor, path):
    editor.tap("ctrl+o", "the open dialog", lambda s: s["dialog"] == "open")
    editor.fill("dialog/path", str(path))


def refused_in_the_window(t, editor, names):
    before = editor.state()["document"]
    for count, name in enumerate(n for n in names if n != "absent.glb"):
        open_from_dialog(editor, t.folder / name)
        state = editor.wait_until("a message about " + name, lambda s: len(s["messages"]) > count)
        t.check("the message names %s" % name, name in state["messages"][-1], state["messages"])
        t.check("the message is on the screen", editor.widget("messages/dismiss/%d" % count))
        t.check_equal("the open document is untouched by %s" % name, state["document"], before)
    open_from_dialog(editor, t.folder / "absent.glb")
    # The dialog stays for another try: its buttons are there after the answer, and Cancel closes it.
    editor.click("dialog/cancel")
    state = editor.wait_until("the dialog to close", lambda s: s["dialog"] == "")
    t.check_equal("a file that is not there changes nothing", state["document"], before)
    editor.click("messages/dismiss-all")
    editor.wait_until("the messages to go", lambda s: not s["messages"] and "messages/dismiss-all" not in s["widgets"])


def unwritable_place(t, editor):
    before = editor.state()["document"]
    t.check("there is something to save", before["modified"])
    # Nobody, not even root, makes files there.
    place = pathlib.Path("/proc/sinew-gui-test.rig.json")
    editor.tap("ctrl+shift+s", "the save dialog", lambda s: s["dialog"] == "save")
    editor.fill("dialog/path", str(place))
    state = editor.wait_until("a message that it was not saved", lambda s: s["messages"])
    t.check("the message names the file", place.name in state["messages"][-1], state["messages"])
    t.check_equal("the document is as it was, still modified", state["document"], before)
    t.check_equal("the dialog stays for another try", state["dialog"], "save")
    good = t.folder / "good.rig.json"
    editor.fill("dialog/path", str(good))
    state = editor.wait_until("the second try", lambda s: s["dialog"] == "" and s["document"]["path"] == str(good))
    t.check("the second try saves", good.is_file() and not state["document"]["modified"])
    editor.click("messages/dismiss-all")
    editor.wait_until("the messages to go", lambda s: not s["messages"])


def lost_folder(t, editor):
    """Ctrl+S where the file's folder has become something else."""
    folder = t.folder / "place"
    folder.mkdir()
    editor.save_as(folder / "kept.rig.json")
    text = (folder / "kept.rig.json").read_bytes()
    folder.rename(t.folder / "elsewhere")
    folder.write_bytes(b"a file where the folder was")
    with_a_muscle(t, editor)
    editor.tap("ctrl+s", "the question about a file that is gone", lambda s: s["dialog"] == "conflict")
    editor.click("conflict/overwrite")
    state = editor.wait_until("a message that it was not saved", lambda s: any("Not saved" in m for m in s["messages"]) and
                              any("no longer on disk" in m for m in s["messages"]))
    t.check("it stays modified", state["document"]["modified"])
    t.check("what was saved before is whole", (t.folder / "elsewhere" / "kept.rig.json").read_bytes() == text)
    editor.click("messages/dismiss-all")
    editor.wait_until("the messages to go", lambda s: not s["messages"])


def question(t, editor):
    t.check("the title marks changes", "*" in editor.title(), editor.title())
    before = editor.state()["document"]
    for answer in ("unsaved/cancel", "Escape"):
        editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
        t.check("with changes, quitting asks", editor.process.poll() is None)
        if answer == "Escape":
            editor.key(answer)
        else:
            editor.click(answer)
        state = editor.wait_until("the question to go", lambda s: s["dialog"] == "" and "unsaved/save" not in s["widgets"])
        t.check_equal("%s keeps everything" % answer.split("/")[-1], state["document"], before)
        # Alive, and listening: it does as it is told.
        wire = state["display"]["wire"]
        editor.tap("5", "the wire to switch", lambda s: s["display"]["wire"] != wire)
    # Opening another file asks as well.
    open_from_dialog(editor, t.folder / "good.rig.json")
    editor.wait_until("the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/discard")
    state = editor.wait_until("the other file", lambda s: s["document"]["path"] == str(t.folder / "good.rig.json"))
    t.check_equal("discarded, the other file is open", state["document"]["modified"], False)


def save_on_quit(t, editor):
    with_a_muscle(t, editor)
    file = t.folder / "good.rig.json"
    before = file.read_bytes()
    editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/save")
    t.check_equal("saved, it quits", editor.wait_for_end(), 0)
    t.check("the file has the change", file.read_bytes() != before)


def discard_on_quit(t, file):
    editor = t.edit(file)
    editor.wait_until("the rig", lambda s: s["document"]["primitives"] > 0)
    before = file.read_bytes()
    with_a_muscle(t, editor)
    editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/discard")
    t.check_equal("discarded, it quits", editor.wait_for_end(), 0)
    t.check("the file is as it was", file.read_bytes() == before)


def dropped(t):
    """Another program's file over the window: a rig opens at once, what cannot be read is said."""
    editor = t.edit(t.copy(t.assets / "demo.glb", "bare.glb"))
    editor.wait_until("a character", lambda s: s["document"]["primitives"] == 0 and BONE in s["bones"])
    rig = t.copy(t.assets / "demo.rig.json", "dropped.rig.json")
    editor.drop(rig)
    editor.wait_until("the rig", lambda s: s["document"]["primitives"] > 0)
    t.check("it is the open one", editor.title().startswith("dropped.rig.json"), editor.title())
    bad = t.folder / "dropped.glb"
    bad.write_bytes(b"no character")
    # It has muscles now: whether they stay is asked before the file is read.
    editor.drop(bad)
    editor.click("keep-muscles/without")
    editor.wait_until("a message", lambda s: any("dropped.glb" in message for message in s["messages"]))
    t.check("the open one stays", editor.title().startswith("dropped.rig.json"), editor.title())
    editor.quit()


def story(t):
    names = bad_files(t)
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: BONE in s["bones"])
    editor.choose_clip(-1, "")
    refused_in_the_window(t, editor, names)
    with_a_muscle(t, editor)
    unwritable_place(t, editor)
    lost_folder(t, editor)
    question(t, editor)
    save_on_quit(t, editor)
    discard_on_quit(t, t.folder / "good.rig.json")
    refused_on_the_command_line(t, names)
    dropped(t)


if __name__ == "__main__":
    sys.exit(driver.run("files", story))
