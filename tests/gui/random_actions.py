# tests/gui/random_actions.py: actions by keys, mouse and palette; then all is undone, and redone. Byte for byte.
"""The same seed makes the same choices as long as the editor answers the same. Two more arguments: seed and count."""
import collections
import random
import sys

import driver

MOST_MUSCLES = 12
BONES = ("thigh.L", "shin.R", "upper_arm.L", "forearm.R", "chest", "hips", "head", "tail.2")


class Hands:
    """What can be done at the moment, and the doing. Every action leaves no dialog, list or drag open."""

    def __init__(self, t, editor, source):
        self.t, self.editor, self.random = t, editor, source

    def document(self):
        return self.editor.state()["document"]

    def muscles(self):
        return [w.split("/", 2)[2] for w in self.editor.state()["widgets"] if w.startswith("outliner/muscle/")]

    # Picking -------------------------------------------------------------------------------------------------------

    def one_muscle(self):
        """From the list; if none is in sight there, from the palette by the name of its bone."""
        shown = self.muscles()
        if not shown:
            return self.editor.taps("ctrl+a")
        return self.editor.click("outliner/muscle/" + self.random.choice(shown))

    def one_more(self):
        shown = self.muscles()
        if shown:
            self.editor.click("outliner/muscle/" + self.random.choice(shown), held="ctrl")

    def with_selection(self, act):
        if not self.document()["selection"]:
            self.one_muscle()
            self.editor.settle()
        return act()

    # Doing ---------------------------------------------------------------------------------------------------------

    def add(self):
        if self.document()["primitives"] < MOST_MUSCLES:
            self.editor.select_bone(self.random.choice(BONES))
            self.editor.taps("ctrl+m")

    def handles_inside(self, state):
        """Clear of tool strip, numbers and the little axes."""
        x, y, width, height = state["viewport"]
        return [name for name, at in sorted(state["gizmo"]["handles"].items())
                if x + 90 < at[0] < x + width - 230 and y + 90 < at[1] < y + height - 130]

    def handle(self):
        """A handle pulled somewhere: freely, along an axis, snapped, precisely, or canceled."""
        editor = self.editor
        key, mode = self.random.choice([("w", "move"), ("e", "rotate"), ("r", "scale"), ("q", "poles")])
        editor.tap(key, mode, lambda s: s["gizmo"]["mode"] == mode)
        if not self.document()["selection"]:
            return
        inside = self.handles_inside(editor.settle())
        if not inside:
            editor.select_muscle(self.document()["selection"][-1])  # Brings it into the picture.
            inside = self.handles_inside(editor.settle())
        if not inside:
            return
        name = self.random.choice(inside)
        if not self.try_grab(name):
            return
        way = self.random.choice(["free", "axis", "ctrl", "shift", "Escape", "number"])
        start = editor.mouse
        if way in ("ctrl", "shift"):
            editor.hold(way)
        for step in range(1, 4):
            editor.move((start[0] + step * self.random.randint(-9, 9), start[1] + step * self.random.randint(-9, 9)))
        if way == "axis":
            editor.key(self.random.choice("xyz"))
        if way == "number":
            editor.type("0.04")
        if way == "Escape":
            editor.key("Escape")
        editor.release()
        if way in ("ctrl", "shift"):
            editor.let_go(way)
        editor.wait_until("the end of a drag of " + name, lambda s: not s["gizmo"]["dragging"])

    def try_grab(self, name):
        """Handles lie one behind another: whichever is hovered there is taken."""
        editor = self.editor
        editor.move(editor.state()["gizmo"]["handles"][name])
        editor.settle()
        if editor.state()["gizmo"]["hovered"] == "":
            return False
        editor.press()
        editor.wait_until("a drag", lambda s: s["gizmo"]["dragging"])
        return True

    def number(self):
        field, low, high = self.random.choice([("center.x", -0.1, 0.1), ("center.z", -0.1, 0.1), ("rotation.y", -80, 80),
                                               ("radius.x", 0.03, 0.2), ("radius.y", 0.03, 0.2), ("reach", 1.1, 2.0)])
        if "inspector/" + field in self.editor.state()["widgets"]:
            self.editor.type_number("inspector/" + field, "%.3f" % self.random.uniform(low, high))

    def scrub_number(self):
        """A number field dragged with the mouse."""
        name = "inspector/" + self.random.choice(["center.y", "radius.z", "reach"])
        if name in self.editor.state()["widgets"]:
            x, y = self.editor.widget(name)
            self.editor.drag((x, y), (x + self.random.choice([-20, 12, 25]), y), steps=2)

    def scroll_to(self, name):
        """The right column is longer than the window when a muscle's territory has names."""
        x, y, width, height = self.editor.state()["viewport"]
        self.editor.move((x + width + 30, y + 0.5 * height))
        for _ in range(20):
            if name in self.editor.settle()["widgets"]:
                return
            self.editor.xdotool("click", 5)
        raise driver.Failure("%s is not to be reached by scrolling" % name)

    def to_top(self):
        """All that was done has been seen, and the muscle's own fields are in sight again."""
        if "inspector/header" not in self.editor.settle()["widgets"]:
            x, y, width, height = self.editor.state()["viewport"]
            self.editor.move((x + width + 30, y + 0.5 * height))
            self.editor.xdotool("click", "--repeat", 20, "--delay", 1, 4)
            self.editor.wait_until("the top of the right column", lambda s: "inspector/header" in s["widgets"])

    def effect(self):
        name = "inspector/" + self.random.choice(["adds", "carves"])
        if name in self.editor.state()["widgets"]:
            self.editor.click(name)

    def rename(self):
        if len(self.document()["selection"]) == 1:
            self.editor.fill("inspector/name", "muscle %d" % self.random.randint(1, 40))

    def group(self):
        """A new group, which asks for its name; what it has already is kept."""
        if not self.document()["selection"]:
            return
        self.editor.key("ctrl+g")
        self.editor.wait_until("the group's name", lambda s: "blending/rename" in s["widgets"])
        self.editor.tap("Return", "the name to be kept", lambda s: "blending/rename" not in s["widgets"])
        self.editor.click("outliner/tab")

    def move_to_group(self):
        groups = sorted(self.editor.state()["groups"])
        if groups and "inspector/group" in self.editor.state()["widgets"]:
            self.editor.pick("inspector/group", self.random.choice(groups))

    def link(self):
        """A cell of the matrix."""
        self.editor.click("blending/tab")
        state = self.editor.wait_until("the groups", lambda s: "blending/add" in s["widgets"])
        cells = [w for w in sorted(state["widgets"]) if w.startswith("blending/cell/") and len(set(w.split("/")[2:])) == 2]
        if cells:
            self.editor.click(self.random.choice(cells))
        self.editor.click("outliner/tab")
        self.editor.wait_until("the list", lambda s: "outliner/search" in s["widgets"])

    def surface(self):
        name, low, high = self.random.choice([("iso", 0.1, 0.5), ("grooves", 0.0, 4.0), ("skin-blend", 1.0, 8.0)])
        self.scroll_to("surface/" + name)
        self.editor.type_number("surface/" + name, "%.3f" % self.random.uniform(low, high))

    def mode(self):
        self.scroll_to("surface/mode")
        self.editor.pick("surface/mode", self.random.choice(["swell", "replace"]))

    def depth(self):
        self.scroll_to("smoothing/detail")
        self.editor.pick("smoothing/detail", "uniform")
        self.scroll_to("smoothing/depth")
        self.editor.type_number("smoothing/depth", str(self.random.choice([1, 2, 3])))

    def patch(self):
        self.scroll_to("smoothing/patch")
        self.editor.pick("smoothing/patch", self.random.choice(["pn", "phong", "spherigon", "flat"]))

    def territory(self):
        """Bones clicked in the list while the mode is on."""
        self.editor.taps("b")
        state = self.editor.settle()
        bones = [w for w in sorted(state["widgets"]) if w.startswith("outliner/bone/")]
        if state["territory"] and bones:
            self.editor.click(self.random.choice(bones))
            self.editor.settle()
        if state["territory"]:
            self.editor.tap("b", "the territory mode to end", lambda s: s["territory"] == "")

    def from_palette(self):
        words, entry = self.random.choice([("auto depth", "view/auto-depth"), ("duplicate", "edit/duplicate"),
                                           ("mirror to other side", "edit/mirror"), ("invert selection", "edit/select-invert"),
                                           ("unlink twin", "edit/unlink-twin")])
        self.editor.tap("ctrl+p", "the palette", lambda s: "palette/query" in s["widgets"])
        self.editor.type(words)
        self.editor.wait_until("the palette to find " + entry, lambda s: "palette/" + entry in s["widgets"])
        self.editor.key("Return")
        state = self.editor.settle()
        if entry == "view/auto-depth":  # As fine as the picture is dear: for a moment only.
            self.editor.taps("ctrl+p")
            self.editor.wait_until("the palette", lambda s: "palette/query" in s["widgets"])
            self.editor.type(words)
            self.editor.key("Return")
            state = self.editor.settle()
        if state["dialog"] == "palette":  # Cannot be done now: the palette says so by staying.
            self.editor.tap("Escape", "the palette to go", lambda s: s["dialog"] == "")

    def look(self):
        self.editor.taps(self.random.choice(["1", "2", "4", "5", "7", "8", "9", "f", "a", "KP_1", "KP_3", "x", "shift+x"]))

    def orbit(self):
        x, y, width, height = self.editor.state()["viewport"]
        corner = (x + 0.5 * width, y + height - 12)
        self.editor.drag(corner, (corner[0] + self.random.randint(-80, 80), corner[1] - self.random.randint(0, 20)), steps=2,
                         button=driver.RIGHT)

    def keys(self, *names):
        return lambda: self.editor.taps(*names)

    def fewer(self, *names):
        """Copies, as long as there are not too many."""
        def act():
            document = self.document()
            if document["primitives"] + 2 * len(document["selection"]) <= MOST_MUSCLES + 4:
                self.editor.taps(*names)
        return act

    def travel(self):
        """Some steps back, and all of them or some forth again; or to a step in the list."""
        state = self.editor.state()
        steps = [w for w in sorted(state["widgets"]) if w.startswith("history/step/")]
        if self.random.random() < 0.3 and steps:
            return self.editor.click(self.random.choice(steps))
        back = self.random.randint(1, 5)
        forth = self.random.choice([back, back, back, self.random.randint(0, back)])
        return self.editor.taps(*["ctrl+z"] * back, *["ctrl+shift+z"] * forth)

    def table(self):
        """(weight, name, act, whether it is an edit: then redo is forgotten)"""
        chosen = self.with_selection
        return [
            (9, "add", self.add), (14, "handle", lambda: chosen(self.handle)), (10, "number", lambda: chosen(self.number)),
            (5, "scrub", lambda: chosen(self.scrub_number)), (4, "effect", lambda: chosen(self.effect)),
            (4, "rename", lambda: chosen(self.rename)), (4, "group", lambda: chosen(self.group)),
            (4, "to group", lambda: chosen(self.move_to_group)), (4, "link", self.link), (3, "surface", self.surface),
            (2, "mode", self.mode), (3, "depth", self.depth), (2, "patch", self.patch),
            (3, "territory", lambda: chosen(self.territory)), (5, "palette", self.from_palette),
            (7, "select", self.one_muscle), (5, "select more", self.one_more), (2, "all", self.keys("ctrl+a")),
            (3, "delete", lambda: chosen(self.keys("Delete"))), (3, "duplicate", lambda: chosen(self.fewer("ctrl+d"))),
            (3, "copy and paste", lambda: chosen(self.fewer("ctrl+c", "ctrl+v"))),
            (2, "paste mirrored", lambda: chosen(self.fewer("ctrl+c", "ctrl+shift+v"))),
            (2, "cut", lambda: chosen(self.keys("ctrl+x"))), (3, "mirror", lambda: chosen(self.keys("ctrl+shift+m"))),
            (3, "flip", lambda: chosen(self.keys("ctrl+shift+f"))), (2, "unlink", lambda: chosen(self.keys("ctrl+shift+u"))),
            (3, "link twins", lambda: chosen(self.keys("ctrl+shift+l"))), (2, "symmetry", self.keys("shift+s")),
            (2, "hide", lambda: chosen(self.keys("h"))), (1, "show all", self.keys("alt+h")),
            (4, "look", self.look), (3, "orbit", self.orbit), (7, "travel", self.travel)]


class Checkpoints:
    """What was saved at which step, for as long as that step is still in the history."""

    def __init__(self):
        self.saved = {}

    def after(self, name, before, now):
        """An edit forgets what came after the step it was made at."""
        if now["undo"] == before["undo"] and now["redo"] == before["redo"]:
            return
        base = before["undo"] if name != "travel" else now["undo"]
        if name == "travel" and now["undo"] + now["redo"] == before["undo"] + before["redo"]:
            return
        self.saved = {step: data for step, data in self.saved.items() if step <= base}


def bytes_now(t, editor):
    editor.saved_rig()
    return (t.folder / "random.rig.json").read_bytes()


def act_at_random(t, editor, hands, seed, count):
    checkpoints, done = Checkpoints(), collections.Counter()
    weights, names, acts = zip(*hands.table())
    for number in range(1, count + 1):
        name, act = hands.random.choices(list(zip(names, acts)), weights)[0]
        before = editor.state()["document"]
        act()
        hands.to_top()
        now = editor.state()["document"]
        state = editor.state()
        if state["dialog"] or state["gizmo"]["dragging"]:
            raise driver.Failure("seed %d, action %d, %s: left %r open" % (seed, number, name, state["dialog"]))
        checkpoints.after(name, before, now)
        done[name] += 1
        if number % 10 == 0:
            checkpoints.saved[now["undo"]] = bytes_now(t, editor)
            print("%d: step %d of %d, %d muscles" % (number, now["undo"], now["undo"] + now["redo"], now["primitives"]), flush=True)
    print("done: " + ", ".join("%s %d" % pair for pair in sorted(done.items())))
    return checkpoints


def travel_to(editor, key, wanted):
    """With a few keys in one breath each time, as one would hold the key down."""
    while editor.state()["document"]["undo"] != wanted:
        left = abs(wanted - editor.state()["document"]["undo"])
        editor.taps(*[key] * min(left, 25))
        here = wanted + (left - min(left, 25)) * (1 if key == "ctrl+z" else -1)
        editor.wait_until("step %d" % here, lambda s: s["document"]["undo"] == here)


def story(t):
    seed, count = int(sys.argv[5]), int(sys.argv[6])
    print("seed %d, %d actions" % (seed, count))
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: s["triangles"] > 0)
    editor.choose_clip(-1, "")
    editor.save_as(t.folder / "random.rig.json")
    start = bytes_now(t, editor)
    checkpoints = act_at_random(t, editor, Hands(t, editor, random.Random(seed)), seed, count)
    end = bytes_now(t, editor)
    step = editor.state()["document"]["undo"]
    t.check("most of it were edits", step > count // 4, step)
    t.check("the end differs from the start", end != start)
    for kept in sorted(checkpoints.saved, reverse=True):
        if kept < step:
            travel_to(editor, "ctrl+z", kept)
            t.check("undone to step %d, the file is what it was then" % kept, bytes_now(t, editor) == checkpoints.saved[kept])
    travel_to(editor, "ctrl+z", 0)
    t.check("all undone, the file is what it was at the start, byte for byte", bytes_now(t, editor) == start)
    travel_to(editor, "ctrl+shift+z", step)
    t.check("all redone, the file is what it was at the end, byte for byte", bytes_now(t, editor) == end)
    t.check("nothing went wrong on the way that nobody was told of", editor.process.poll() is None)
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("random_actions", story))
