# tests/gui/gizmo_handles.py: every handle in every space (spaces); locks, snaps, numbers, cancels, two muscles (keys).
import itertools
import json
import math
import sys

import bind_pose
import driver
import rigs

BONE, OTHER = "upper_arm.L", "thigh.R"
SPACES = ("bone", "world", "primitive")
MODES = {"move": "w", "rotate": "e", "scale": "r", "poles": "q"}
EVERY = {"move": {"move.x", "move.y", "move.z", "move.xy", "move.yz", "move.zx", "move.center"},
         "rotate": {"rotate.x", "rotate.y", "rotate.z", "rotate.screen"},
         "scale": {"scale.x", "scale.y", "scale.z", "scale.uniform"},
         "poles": {"pole." + sign + axis for sign in "+-" for axis in "xyz"}}
WAY = [(12, 5), (36, 22)]  # Along no line, so that no handle is pulled only across its way.
UNIT = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def scaled_to_unit(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


class Bench:
    """The humanoid in its bind pose with muscles that lie askew on askew bones, so that no two spaces agree."""

    def __init__(self, t):
        self.t = t
        file = t.copy(t.assets / "humanoid.glb")
        self.bones = bind_pose.bones_in_bind(file)
        self.height = json.loads(t.run_program("inspect", file, "--json").stdout)["height"]
        self.editor = t.edit(file)
        self.editor.wait_until("a character", lambda s: BONE in s["bones"])
        self.editor.choose_clip(-1, "")
        self.editor.click("display/numbers")
        self.editor.type_number("smoothing/tolerance", "1")
        self.editor.wait_until("a coarse mesh", lambda s: s["tolerance"] > 0.0099)
        # Two sides that are no twins.
        self.editor.tap("shift+s", "symmetry to be off", lambda s: not s["symmetry"]["on"])
        self.names = [self.add(BONE, (25, -35, 15)), self.add(OTHER, (-20, 10, 40))]
        self.select(self.names[0])
        self.path = t.folder / "bench.rig.json"
        self.editor.save_as(self.path)
        self.start = self.rig()

    def add(self, bone, degrees):
        editor = self.editor
        count = editor.state()["document"]["primitives"]
        editor.select_bone(bone)
        editor.key("ctrl+m")
        state = editor.wait_until("a muscle on " + bone, lambda s: s["document"]["primitives"] == count + 1)
        for axis, angle in zip("xyz", degrees):
            undo = editor.state()["document"]["undo"]
            editor.type_number("inspector/rotation." + axis, str(angle))
            editor.wait_until("a typed rotation", lambda s: s["document"]["undo"] == undo + 1)
        return state["document"]["selection"][0]

    def select(self, *names):
        self.editor.click("outliner/muscle/" + names[0])
        for name in names[1:]:
            self.editor.click("outliner/muscle/" + name, held="ctrl")
        self.editor.wait_until("%s to be selected" % (names,), lambda s: s["document"]["selection"] == list(names))

    def rig(self):
        """What the file holds after Ctrl+S: name -> muscle."""
        return {muscle["name"]: muscle for muscle in self.editor.saved_rig()["primitives"]}

    def mode(self, mode):
        return self.editor.tap(MODES[mode], mode + " handles", lambda s: s["gizmo"]["mode"] == mode)

    def axes(self, space):
        for _ in SPACES:
            now = self.editor.state()["gizmo"]["axes"]
            if now == space:
                return
            self.editor.tap("x", "the next axes", lambda s: s["gizmo"]["axes"] != now)
        raise driver.Failure("no %s axes" % space)

    def dragged(self, handle, way=WAY, during=None, held=()):
        """The rig after one drag, which is then undone. Held keys go down once the handle is grabbed."""
        editor = self.editor
        undo = editor.state()["document"]["undo"]
        editor.grab(handle)
        for key in held:
            editor.hold(key)
        start = editor.mouse
        for offset in way:
            editor.move((start[0] + offset[0], start[1] + offset[1]))
        if during:
            during()
        editor.release()
        editor.wait_until("the drag of %s to be a step" % handle,
                          lambda s: not s["gizmo"]["dragging"] and s["document"]["undo"] == undo + 1)
        for key in held:
            editor.let_go(key)
        after = self.rig()
        editor.tap("ctrl+z", "undo of " + handle, lambda s: s["document"]["undo"] == undo)
        return after

    def one(self, handle, **how):
        """The same of the first muscle; the other must not have changed."""
        after = self.dragged(handle, **how)
        self.t.check(handle + " leaves the other muscle alone", after[self.names[1]] == self.start[self.names[1]])
        return after[self.names[0]]

    @property
    def before(self):
        return self.start[self.names[0]]

    def in_world(self, vector, bone=BONE):
        return [dot(row[:3], vector) for row in self.bones[bone][:3]]

    def center(self, muscle):
        return bind_pose.ellipsoid_in_bind(self.bones, muscle)[0]

    def axis(self, space, i):
        """A unit vector of a space, in the world."""
        if space == "world":
            return UNIT[i]
        own = space == "primitive"
        return scaled_to_unit(self.in_world(rigs.turned(self.before["rotation"], UNIT[i]) if own else UNIT[i]))

    def turn(self, before, after, bone=BONE):
        """(axis in the world, degrees). These bones do not scale, so a direction stays one."""
        axis, degrees = rigs.turn_between(before["rotation"], after["rotation"])
        return self.in_world(axis, bone), degrees


def check_moved(b, what, space, ways, after):
    """The center went along those axes of the space and no other; nothing else changed."""
    b.t.check_equal(what + " moves the center alone", rigs.changed_parts(b.before, after), {"center"})
    way = minus(b.center(after), b.center(b.before))
    length = math.sqrt(dot(way, way))
    b.t.check(what + " moves", length > 0.002 * b.height, length)
    if ways is None:
        return length
    # In an orthogonal frame what lies across is what is left of the three coordinates.
    across = max((abs(dot(way, b.axis(space, i))) for i in range(3) if i not in ways), default=0.0)
    b.t.check(what + " moves along its own axes", across < 1e-4 * b.height + 1e-3 * length, (way, across))
    if len(ways) == 2:
        b.t.check(what + " moves along both", all(abs(dot(way, b.axis(space, i))) > 1e-4 * b.height for i in ways), way)
    return length


def check_turned(b, what, space, way, after):
    b.t.check_equal(what + " turns and does nothing else", rigs.changed_parts(b.before, after), {"rotation"})
    axis, degrees = b.turn(b.before, after)
    b.t.check(what + " turns visibly", 1.0 < degrees < 180.0, degrees)
    if way is not None:
        b.t.check(what + " turns about its own axis", abs(dot(axis, b.axis(space, way))) > 1.0 - 1e-4, axis)
    return degrees


def check_scaled(b, what, axes, after):
    b.t.check_equal(what + " changes radii alone", rigs.changed_parts(b.before, after), {"radii"})
    b.t.check_equal(what + " changes its own", rigs.changed_axes(b.before["radii"], after["radii"], 0.0), set(axes))
    factors = [after["radii"][i] / b.before["radii"][i] for i in axes]
    b.t.check(what + " by one factor", max(factors) - min(factors) < 1e-4 and abs(factors[0] - 1.0) > 0.01, factors)
    return factors[0]


def check_pulled(b, what, handle, after):
    axis, sign = "xyz".index(handle[-1]), 1 if "+" in handle else -1
    b.t.check_equal(what + " changes a radius and the center", rigs.changed_parts(b.before, after), {"center", "radii"})
    b.t.check_equal(what + " changes one radius", rigs.changed_axes(b.before["radii"], after["radii"], 0.0), {axis})
    stays = math.dist(rigs.pole(b.before, axis, -sign), rigs.pole(after, axis, -sign))
    b.t.check(what + " leaves the other end where it was", stays < 1e-5 * b.height, stays)
    return after["radii"][axis]


def check_any(b, space, handle, after):
    kind, way = handle.split(".")
    what = "%s in %s axes" % (handle, space)
    if kind == "move":
        check_moved(b, what, space, None if way == "center" else {"xyz".index(c) for c in way}, after)
    elif kind == "rotate":
        check_turned(b, what, space, None if way == "screen" else "xyz".index(way), after)
    elif kind == "scale":
        check_scaled(b, what, range(3) if way == "uniform" else ["xyz".index(way)], after)
    else:
        check_pulled(b, what, handle, after)


def look_from(b, view):
    """Another side, by the menu: a handle that points at the eye or lies behind the body is there from elsewhere."""
    b.editor.click("menu/view")
    b.editor.click("view/look")
    b.editor.click("view/" + view)
    b.editor.wait_until("the view to rest", lambda s: not s["camera_moving"] and "view/front" not in s["widgets"])


def frame(b):
    b.editor.key("f")
    b.editor.settle()
    b.editor.wait_until("the view to rest", lambda s: not s["camera_moving"] and s["gizmo"]["visible"])


def spaces(t):
    b = Bench(t)
    left = {("bone" if mode in ("scale", "poles") else space, mode): set(EVERY[mode])
            for space in SPACES for mode in MODES}
    for view in (None, "left", "back", "top"):
        if not any(left.values()):
            break
        if view:
            look_from(b, view)
        frame(b)
        for (space, mode), handles in left.items():
            if not handles:
                continue
            b.axes(space)
            shown = set(b.mode(mode)["gizmo"]["handles"])
            for handle in sorted(handles & shown):
                check_any(b, space, handle, b.one(handle))
                handles.discard(handle)
            if view is None and mode == "rotate":
                b.editor.settle()
                b.editor.screenshot(t.out / ("gizmo_%s.png" % space))
    t.check("every handle was there from some side", not any(left.values()), left)
    finish(b)


def finish(b):
    b.editor.saved_rig()
    b.t.check("after all that the rig is the same", b.rig() == b.start)
    b.t.check_equal("quits without a question", b.editor.quit(), 0)


def multiple_of(step, value):
    return abs(value / step - round(value / step)) < 2e-3 and abs(value) > 0.5 * step


def locks(b):
    for space in SPACES:
        b.axes(space)
        for i, key in enumerate("xyz"):
            what = "%s in %s axes" % (key.upper(), space)
            b.mode("move")
            check_moved(b, what + ", a free move,", space, {i}, b.one("move.center", during=lambda: b.editor.key(key)))
            b.mode("rotate")
            check_turned(b, what + ", a free turn,", space, i, b.one("rotate.screen", during=lambda: b.editor.key(key)))
    b.mode("move")
    check_moved(b, "Z over the arm along X", "primitive", {2}, b.one("move.x", during=lambda: b.editor.key("z")))
    after = b.one("move.center", during=lambda: b.editor.key("x", "x"))
    way = minus(b.center(after), b.center(b.before))
    ways = [i for i in range(3) if abs(dot(way, b.axis("primitive", i))) > 1e-4 * b.height]
    b.t.check("X twice frees the move again", len(ways) > 1, way)


HANDLE = {"move": "move.y", "rotate": "rotate.y", "scale": "scale.uniform", "poles": None}


def value_of(b, mode, handle, after):
    """What a drag did, as the number that could have been typed: length, degrees, factor, radius."""
    if mode == "move":
        return dot(minus(b.center(after), b.center(b.before)), b.axis("bone", 1))
    if mode == "rotate":
        axis, degrees = b.turn(b.before, after)
        return math.copysign(degrees, dot(axis, b.axis("bone", 1)))
    if mode == "scale":
        return after["radii"][0] / b.before["radii"][0]
    return after["radii"]["xyz".index(handle[-1])]


def handle_of(b, mode):
    state = b.mode(mode)
    return HANDLE[mode] or sorted(name for name in state["gizmo"]["handles"] if name.startswith("pole."))[0]


def snapped_and_precise(b):
    b.axes("bone")
    step = {"move": 0.01 * b.height, "rotate": 15.0, "scale": 0.1, "poles": 0.01 * b.height}
    for mode in MODES:
        handle = handle_of(b, mode)
        rest = {"move": 0.0, "rotate": 0.0, "scale": 1.0}.get(mode, value_of(b, mode, handle, b.before))
        free = value_of(b, mode, handle, b.one(handle))
        snap = value_of(b, mode, handle, b.one(handle, held=["ctrl"]))
        b.t.check("Ctrl snaps %s" % handle,
                  multiple_of(step[mode], snap) and not multiple_of(step[mode], free), (free, snap))
        fine = value_of(b, mode, handle, b.one(handle, held=["shift"]))
        slowed = math.log(fine) / math.log(free) if mode == "scale" else (fine - rest) / (free - rest)
        b.t.check("Shift slows %s to a tenth" % handle, abs(slowed - 0.1) < 0.01, (free, fine, slowed))


def typed(b):
    b.axes("bone")
    for mode, keys, wanted in (("move", ["0", "period", "2", "5"], 0.25), ("rotate", ["minus", "4", "0"], -40.0),
                               ("scale", ["1", "period", "7", "BackSpace", "5"], 1.5), ("poles", ["period", "1", "5"], 0.15)):
        handle = handle_of(b, mode)
        got = value_of(b, mode, handle, b.one(handle, during=lambda: b.editor.key(*keys)))
        b.t.check("%s typed into %s" % (wanted, handle), abs(got - wanted) < 1e-4 * max(1.0, abs(wanted)), got)


def cancel_one(b, handle, cancel):
    before = b.editor.state()["document"]
    b.editor.grab(handle)
    b.editor.move((b.editor.mouse[0] + 30, b.editor.mouse[1] + 18))
    b.editor.wait_until(handle + " to change the muscle", lambda s: s["document"]["modified"])
    if cancel == "Esc":
        b.editor.key("Escape")
    else:
        b.editor.xdotool("click", driver.RIGHT)
    b.editor.wait_until(cancel + " to end the drag", lambda s: not s["gizmo"]["dragging"])
    b.editor.release()
    b.t.check_equal("%s ends %s without a trace" % (cancel, handle), b.editor.settle()["document"], before)


def canceled(b):
    """Every handle, by Esc and by the right button in turn: nothing is left of it, not even a step to redo."""
    b.axes("bone")
    b.t.check("the rig is as it began", b.rig() == b.start)
    written = b.path.read_bytes()
    for mode in MODES:
        handles = sorted(set(b.mode(mode)["gizmo"]["handles"]) & EVERY[mode])
        b.t.check("there are %s handles to cancel" % mode, len(handles) >= 3, handles)
        for handle, cancel in zip(handles, itertools.cycle(("Esc", "the right button"))):
            cancel_one(b, handle, cancel)
    b.editor.saved_rig()
    b.t.check("the file is what it was", b.path.read_bytes() == written)


def two_muscles(b):
    first, second = b.names
    b.select(second, first)  # The last is the active one.
    b.editor.key("a")
    b.editor.settle()  # The key has been seen, so a camera that stands still has arrived.
    b.editor.wait_until("the view to rest", lambda s: not s["camera_moving"])
    b.axes("world")
    b.mode("move")
    after = b.dragged("move.center")
    ways = [minus(b.center(after[name]), b.center(b.start[name])) for name in b.names]
    b.t.check("both move by the same way in the world",
              math.dist(*ways) < 1e-5 * b.height and math.hypot(*ways[0]) > 0.002 * b.height, ways)
    after = b.dragged("move.center", during=lambda: b.editor.key("y", "period", "2"))
    ways = [minus(b.center(after[name]), b.center(b.start[name])) for name in b.names]
    b.t.check("a lock and a number hold for both", all(math.dist(way, [0.0, 0.2, 0.0]) < 1e-4 for way in ways), ways)
    for pivot in ("active", "centroid"):
        if b.editor.state()["gizmo"]["pivot"] != pivot:
            b.editor.tap("shift+x", "the other pivot", lambda s: s["gizmo"]["pivot"] == pivot)
        turn_both(b, pivot)
    b.editor.settle()
    b.editor.screenshot(b.t.out / "gizmo_two.png")
    b.mode("scale")
    after = b.dragged("scale.uniform", during=lambda: b.editor.key("1", "period", "5"))
    factors = [after[n]["radii"][i] / b.start[n]["radii"][i] for n in b.names for i in range(3)]
    b.t.check("both grow by the typed factor", all(abs(f - 1.5) < 1e-4 for f in factors), factors)
    b.mode("rotate")
    b.editor.saved_rig()
    before = b.editor.state()["document"]
    b.editor.grab("rotate.screen")
    b.editor.move((b.editor.mouse[0] + 30, b.editor.mouse[1] + 18))
    b.editor.wait_until("both to turn", lambda s: s["document"]["modified"])
    b.editor.key("Escape")
    b.editor.wait_until("Esc to end it", lambda s: not s["gizmo"]["dragging"])
    b.editor.release()
    b.t.check_equal("Esc leaves both as they were", b.editor.settle()["document"], before)


def turn_both(b, pivot):
    """By 90 degrees about the world's Y: both turn so, and the pivot is where it was."""
    b.mode("rotate")
    after = b.dragged("rotate.screen", during=lambda: b.editor.key("y", "9", "0"))
    for name, bone in zip(b.names, (BONE, OTHER)):
        axis, degrees = b.turn(b.start[name], after[name], bone)
        b.t.check("%s turns by 90 degrees about Y, pivot: %s" % (name, pivot),
                  abs(degrees * axis[1] - 90.0) < 0.01 and abs(axis[1]) > 1.0 - 1e-4, (axis, degrees))
    old, new = ([b.center(rig[name]) for name in b.names] for rig in (b.start, after))
    middle = [0.5 * (x + y) for x, y in zip(*old)] if pivot == "centroid" else old[0]
    for before, now in zip(old, new):
        x, y, z = minus(before, middle)
        b.t.check("a center goes round the %s pivot" % pivot, math.dist(minus(now, middle), [z, y, -x]) < 1e-4 * b.height,
                  (middle, before, now))


def keys(t):
    b = Bench(t)
    frame(b)
    locks(b)
    snapped_and_precise(b)
    typed(b)
    canceled(b)
    two_muscles(b)
    finish(b)


if __name__ == "__main__":
    sys.exit(driver.run("gizmo_" + sys.argv[5], {"spaces": spaces, "keys": keys}[sys.argv[5]]))
