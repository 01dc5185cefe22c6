# tests/gui/failed_save.py: a full disk and a read-only one: it is reported, nothing is lost, and the next try saves.
import ctypes
import json
import os
import pathlib
import subprocess
import sys

import driver

SIZE = 256 * 1024
INTERVAL = 300  # Seconds between autosaves: what is kept before is kept because a save failed.
NEW_MOUNTS, NEW_USERS = 0x00020000, 0x10000000


def mounts_of_our_own():
    """From here on what this process and its children mount is seen by them alone, and gone with them."""
    user, group = os.getuid(), os.getgid()
    if ctypes.CDLL(None).unshare(NEW_MOUNTS | (NEW_USERS if user else 0)) != 0:
        raise driver.Skip("no file system can be mounted here")
    if user:
        for name, text in (("setgroups", "deny"), ("uid_map", "0 %d 1" % user), ("gid_map", "0 %d 1" % group)):
            pathlib.Path("/proc/self", name).write_text(text)
    subprocess.run(["mount", "--make-rprivate", "/"], check=True)


class Disk:
    """A very small file system of its own, on a folder."""

    def __init__(self, t):
        self.place = t.folder / "disk"
        self.place.mkdir()
        self.ballast = self.place / "ballast.bin"
        mounts_of_our_own()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=%d" % SIZE, "none", str(self.place)],
                                 capture_output=True, text=True)
        if mounted.returncode != 0:
            raise driver.Skip("no file system can be mounted here: " + mounted.stderr.strip())

    def fill(self):
        """To the last block."""
        with open(self.ballast, "wb", buffering=0) as file:
            try:
                while True:
                    file.write(b"x" * 512)
            except OSError:
                pass

    def make_room(self):
        self.ballast.unlink()

    def writable(self, yes):
        subprocess.run(["mount", "-o", "remount," + ("rw" if yes else "ro"), str(self.place)], check=True)

    def names(self):
        return sorted(path.name for path in self.place.iterdir() if path != self.ballast)

    def stop(self):
        subprocess.run(["umount", "-l", str(self.place)], check=False)


def add_pair(editor):
    count = editor.state()["document"]["primitives"]
    editor.key("ctrl+m")
    return editor.wait_until("a muscle and its twin", lambda s: s["document"]["primitives"] == count + 2)


def dismiss(editor):
    editor.click("messages/dismiss-all")
    editor.wait_until("the messages to go", lambda s: not s["messages"] and "messages/dismiss-all" not in s["widgets"])


def kept_muscles(t):
    """How many muscles the recovery file has; None where there is none."""
    files = list((pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "recovery").glob("*.json"))
    return len(json.loads(files[0].read_text())["rig"]["primitives"]) if files else None


def refused(t, editor, path, reason):
    """Ctrl+S where it cannot be: a message with name and reason; document, undo steps and file are as they were."""
    before, written, names = editor.state()["document"], path.read_bytes(), sorted(path.parent.iterdir())
    t.check("there is something to save", before["modified"])
    t.check("and the recovery file has not all of it yet", kept_muscles(t) != before["primitives"], kept_muscles(t))
    editor.key("ctrl+s")
    state = editor.wait_until("a message that it was not saved", lambda s: s["messages"])
    text = state["messages"][-1]
    t.check("it names the file and says why", path.name in text and reason in text and "Not saved" in text, text)
    t.check_equal("the document is as it was, still modified", state["document"], before)
    t.check("the title still marks changes", "*" in editor.title(), editor.title())
    t.check("what was saved before is whole", path.read_bytes() == written)
    t.check_equal("nothing half written lies beside it", sorted(path.parent.iterdir()), names)
    driver.wait_for("the recovery file to have all of the work", lambda: kept_muscles(t) == before["primitives"])
    dismiss(editor)


def quitting_keeps_it(t, editor, path):
    """Save, asked for by the question on quitting, fails: the window must not close over it."""
    before, written = editor.state()["document"], path.read_bytes()
    editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/save")
    state = editor.wait_until("a message that it was not saved", lambda s: s["messages"] and s["dialog"] == "")
    t.check("the editor stays", editor.process.poll() is None)
    t.check_equal("with everything in it", state["document"], before)
    t.check("and the file as it was", path.read_bytes() == written)
    dismiss(editor)


def save_as_refused(t, editor, path):
    before = editor.state()["document"]
    editor.tap("ctrl+shift+s", "the save dialog", lambda s: s["dialog"] == "save")
    editor.fill("dialog/path", str(path))
    state = editor.wait_until("a message that it was not saved", lambda s: s["messages"])
    t.check("it names the file", path.name in state["messages"][-1], state["messages"])
    t.check_equal("the dialog stays for another try", state["dialog"], "save")
    t.check_equal("the document keeps its own file", state["document"], before)
    t.check("no file was left there", not path.exists())
    editor.click("dialog/cancel")
    editor.wait_until("the dialog to close", lambda s: s["dialog"] == "" and "dialog/cancel" not in s["widgets"])
    dismiss(editor)


def on_disk(t, disk):
    t.prefer(autosave_seconds=INTERVAL)
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: "thigh.L" in s["bones"])
    editor.select_bone("thigh.L")
    path = disk.place / "work.rig.json"
    add_pair(editor)
    editor.save_as(path)
    t.check_equal("the disk holds the rig alone", disk.names(), [path.name])
    add_pair(editor)

    disk.fill()
    refused(t, editor, path, "No space left")
    quitting_keeps_it(t, editor, path)
    save_as_refused(t, editor, disk.place / "other.rig.json")
    disk.make_room()
    t.check_equal("with room again Ctrl+S saves it all", len(editor.saved_rig()["primitives"]), 4)

    add_pair(editor)
    disk.writable(False)
    refused(t, editor, path, "Read-only")
    disk.writable(True)
    t.check_equal("writable again Ctrl+S saves it all", len(editor.saved_rig()["primitives"]), 6)
    t.check_equal("and leaves nothing else", disk.names(), [path.name])
    add_pair(editor)
    editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/save")
    t.check_equal("saved, it quits", editor.wait_for_end(), 0)
    t.check_equal("the file has all of it", len(json.loads(path.read_text())["primitives"]), 8)


def story(t):
    disk = Disk(t)
    try:
        on_disk(t, disk)
    finally:
        disk.stop()


if __name__ == "__main__":
    sys.exit(driver.run("failed_save", story))
