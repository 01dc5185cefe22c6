# tests/gui/acts.py: what a designer does in one go: dialogs, fields, handles, the palette. The hands are the driver's.
import json
import pathlib

from waiting import wait_for


def changed_keys(before, after):
    """In what two muscles differ, as they are saved."""
    return {key for key in before.keys() | after.keys() if before.get(key) != after.get(key)}


class Acts:
    """For an Editor, which has keys, a mouse and the states that the editor writes."""

    def act(self, what, do, predicate):
        """Does it and waits for a state in which predicate holds."""
        do()
        return self.wait_until(what, predicate)

    def tap(self, key, what, predicate):
        return self.act(what, lambda: self.key(key), predicate)

    def fill(self, field, text):
        """Replaces what a text field holds and confirms."""
        self.click(field)
        self.key("ctrl+a")
        self.type(text)
        self.key("Return")

    def type_number(self, field, text):
        """A number into a drag or slider field: Ctrl and a click open it for typing."""
        self.click(field, held="ctrl")
        self.key("ctrl+a")
        self.type(text)
        self.key("Return")

    def one_sided(self):
        """Symmetry off: what is added stays alone."""
        if self.state()["symmetry"]["on"]:
            self.tap("shift+s", "symmetry off", lambda s: not s["symmetry"]["on"])

    def press_on_skin(self, bone, where):
        """Presses with the muscle tool where a muscle grows on that bone: where(state) is a place on the screen. On a slow
        machine a body that moves has moved on by then: what was hit in its place is taken back, and it is tried again."""
        count = self.state()["document"]["primitives"]

        def pressed():
            self.move(where(self.state()))
            if "adds a muscle on " + bone not in self.state()["status"]:
                return None
            self.press()
            state = self.settle()
            document = state["document"]
            if document["primitives"] > count and document["selection"][0].startswith(bone + " muscle"):
                return state
            if document["primitives"] > count:
                self.tap("Escape", "the wrong one to go", lambda s: s["document"]["primitives"] == count)
            self.release()
            self.settle()
            return None

        return wait_for("%s under the pointer" % bone, pressed)

    def taps(self, *names):
        """Taps one after the other without waiting for anything, in one breath."""
        self.xdotool("key", "--delay", 1, *names)

    def settle(self):
        """What was done so far has been seen: events come in order, and a pixel's way of the pointer is the last."""
        x, y = self.mouse if self.mouse else (640, 12)
        self.move((x + (1 if x % 2 == 0 else -1), y))
        return self.state()

    def palette(self, words, entry):
        """Finds and does something by name; entry is the id of the row that has to be the first one found."""
        self.tap("ctrl+p", "the palette", lambda s: s["dialog"] == "palette" and "palette/query" in s["widgets"])
        self.type(words)
        self.wait_until("the palette to find " + entry, lambda s: "palette/" + entry in s["widgets"])
        return self.tap("Return", "the palette to close",
                        lambda s: s["dialog"] != "palette" and "palette/query" not in s["widgets"])

    def select_bone(self, bone):
        """From the palette, which brings it into the picture as well."""
        self.palette(bone, "bone/" + bone)
        return self.wait_until("the bone %s in the picture" % bone,
                               lambda s: s["document"]["bone"] == bone and not s["camera_moving"])

    def select_muscle(self, muscle):
        self.palette(muscle, "muscle/" + muscle)
        return self.wait_until("the muscle %s in the picture" % muscle,
                               lambda s: s["document"]["selection"] == [muscle] and not s["camera_moving"])

    def pick(self, choice, entry):
        """An entry of a drop-down list."""
        self.click(choice)
        self.click(choice + "/" + entry)
        return self.wait_until("the list of %s to close" % choice, lambda s: choice + "/" + entry not in s["widgets"])

    def choose_clip(self, index, name):
        self.click("timeline/clip")
        self.click("timeline/clip/%d" % index)
        return self.wait_until("the clip '%s'" % name, lambda s: s["clip"] == name and "timeline/clip/0" not in s["widgets"])

    def grab(self, handle):
        """Hovers a gizmo handle and presses on it."""
        self.wait_until("the handle " + handle, lambda s: handle in s["gizmo"]["handles"])

        def aim():
            state = self.state()
            at = state["gizmo"]["handles"].get(handle)
            if at is None or state["camera_moving"]:  # A handle that moves on is not under the press that follows.
                return False
            self.move(at)
            return self.state()["gizmo"]["hovered"] == handle

        wait_for("the handle %s under the pointer" % handle, aim)
        self.press()
        self.wait_until("a drag of " + handle, lambda s: s["gizmo"]["dragging"])

    def drag_handle(self, handle, way, during=None):
        """Pulls a gizmo handle along offsets in pixels from where it was grabbed; during() happens before the release."""
        undo = self.state()["document"]["undo"]
        self.grab(handle)
        start = self.mouse
        for offset in way:
            self.move((start[0] + offset[0], start[1] + offset[1]))
        if during:
            during()
        self.release()
        return self.wait_until("the drag of %s to be a step" % handle,
                               lambda s: not s["gizmo"]["dragging"] and s["document"]["undo"] == undo + 1)

    def save_as(self, path):
        """Through the dialog, the path typed."""
        self.tap("ctrl+shift+s", "the save dialog", lambda s: s["dialog"] == "save")
        self.fill("dialog/path", str(path))
        return self.wait_until("%s to be saved" % path,
                               lambda s: s["dialog"] == "" and "dialog/path" not in s["widgets"] and
                               s["document"]["path"] == str(path) and not s["document"]["modified"])

    def saved_rig(self):
        """Saves to the document's own file and reads it. Written atomically: a new file is a finished file."""
        path = pathlib.Path(self.state()["document"]["path"])
        before = path.stat()
        self.key("ctrl+s")
        wait_for("%s to be written anew" % path,
                 lambda: (path.stat().st_ino, path.stat().st_mtime_ns) != (before.st_ino, before.st_mtime_ns))
        self.wait_until("the document to count as saved", lambda s: not s["document"]["modified"])
        return json.loads(path.read_text())
