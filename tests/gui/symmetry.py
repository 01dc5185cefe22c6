# tests/gui/symmetry.py: what is done to a muscle is done to its twin, mirrored in the bind pose. Last argument: a role.
"""The mirror image is judged by the bind matrices in the character's file, not by anything the editor says of it."""
import json
import sys

import bind_pose
import driver
import rigs

CAST = {
    "demo": {"file": "demo.glb", "real": False, "left": "thigh.L", "right": "thigh.R", "clip": "Walk"},
    # Bones that are turned against each other and against the world.
    "greenman": {"file": "greenman.glb", "real": True, "left": "leg_L", "right": "leg_R", "clip": "2_move"},
}
EXACT = 1e-5  # Of the character's height.
WAY = [(8, 5), (17, 9), (34, 21)]


class Pair:
    """The two muscles as they are saved."""

    def __init__(self, t, editor, bones, height):
        self.t, self.editor, self.bones, self.height = t, editor, bones, height
        self.left_name = self.right_name = ""

    def read(self):
        """(left, right, whole rig)"""
        rig = self.editor.saved_rig()
        by_name = {muscle["name"]: muscle for muscle in rig["primitives"]}
        return by_name[self.left_name], by_name[self.right_name], rig

    def check_mirrored(self, what):
        left, right, rig = self.read()
        error = bind_pose.mirror_error(self.bones, left, right) / self.height
        self.t.check("%s: the other side is its mirror image in the bind pose" % what, error < EXACT, error)
        shared = ("reach", "sign", "group")
        self.t.check_equal("%s: what has no side is the same" % what, [left[k] for k in shared], [right[k] for k in shared])
        return left, right, rig


def paused_in_a_clip(editor, role):
    """Away from the bind pose: what is mirrored there is so however the character stands."""
    index = editor.state()["clips"].index(role["clip"])
    editor.choose_clip(index, role["clip"])
    if editor.state()["playing"]:
        editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    editor.click("timeline/scrub", along=0.37)
    editor.wait_until("a moment of the clip", lambda s: s["clip_time"] > 0)


def add_on_both_sides(t, editor, role):
    state = editor.state()
    t.check("symmetry is on from the start, and the sides are known", state["symmetry"]["on"] and state["symmetry"]["pairs"] > 0)
    editor.select_bone(role["left"])
    state = editor.tap("ctrl+m", "a muscle on the left", lambda s: s["document"]["undo"] == 1)
    t.check_equal("one step, two muscles", state["document"]["primitives"], 2)
    t.check_equal("the left one alone is selected", len(state["document"]["selection"]), 1)
    t.check("its twin is known", state["symmetry"]["twin"] != "", state["symmetry"])
    editor.save_as(t.folder / "symmetry.rig.json")
    return state["document"]["selection"][0], state["symmetry"]["twin"]


def changed(t, what, before, after, parts):
    for side, name in ((0, "the left one"), (1, "the right one")):
        seen = rigs.changed_parts(before[side], after[side])
        t.check("%s changes %s" % (what, name), seen and seen <= parts, seen)


def dragged(t, editor, pair):
    """Every kind of handle; with each the twin's image is exact, while the character stands in the middle of a step."""
    before = pair.check_mirrored("new")
    for key, mode, handle, parts in (("w", "move", "move.center", {"center"}), ("e", "rotate", "rotate.screen", {"rotation"}),
                                     ("r", "scale", "scale.uniform", {"radii"}), ("q", "poles", None, {"radii", "center"})):
        state = editor.tap(key, mode, lambda s: s["gizmo"]["mode"] == mode)
        handle = handle or sorted(h for h in state["gizmo"]["handles"] if h.startswith("pole."))[0]
        editor.drag_handle(handle, WAY)
        after = pair.check_mirrored("a drag of " + handle)
        changed(t, "a drag of " + handle, before, after, parts)
        before = after
    return before


def typed(t, editor, pair, before):
    for field, text, parts in (("inspector/center.x", "0.11", {"center"}), ("inspector/rotation.y", "20", {"rotation"}),
                               ("inspector/radius.z", "0.13", {"radii"}), ("inspector/reach", "1.7", {"reach"})):
        undo = editor.state()["document"]["undo"]
        editor.type_number(field, text)
        editor.wait_until("%s to be a step" % field, lambda s: s["document"]["undo"] == undo + 1)
        after = pair.check_mirrored("a number in " + field)
        changed(t, "a number in " + field, before, after, parts)
        before = after
    editor.act("carving", lambda: editor.click("inspector/carves"), lambda s: s["document"]["undo"] == undo + 2)
    after = pair.check_mirrored("carving")
    changed(t, "carving", before, after, {"sign"})
    editor.act("a new group", lambda: editor.key("ctrl+g"), lambda s: len(s["groups"]) == 2 and "blending/rename" in s["widgets"])
    editor.tap("Return", "its name to be kept", lambda s: "blending/rename" not in s["widgets"])
    editor.click("outliner/tab")
    before, after = after, pair.check_mirrored("a new group")
    changed(t, "a new group", before, after, {"group"})
    return after


def shaped(t, editor, pair, before):
    """A shape has its image on the other side; undone, the file is as it was."""
    first = editor.state()["document"]["undo"]
    editor.act("the shape's rows", lambda: editor.click("inspector/shape"), lambda s: "inspector/core" in s["widgets"])
    for done, (key, field, text) in enumerate((("core", "core", "0.5"), ("belly", "belly", "0.1"), ("bend", "bend.x", "0.4"))):
        editor.type_number("inspector/" + field, text)
        editor.wait_until("%s to be a step" % field, lambda s: s["document"]["undo"] == first + done + 1)
        left, right, rig = pair.check_mirrored("a number in " + field)
        sizes = [[abs(x) for x in (muscle[key] if key == "bend" else [muscle[key]])] for muscle in (left, right)]
        t.check_equal("%s is as much on both sides" % key, sizes[0], sizes[1])
        t.check_equal("and as typed", sizes[0][0], float(text))
    t.check_equal("a rig with shapes is of version 2", rig["version"], 2)
    editor.taps("ctrl+z", "ctrl+z", "ctrl+z")
    editor.wait_until("the shape undone", lambda s: s["document"]["undo"] == first)
    editor.act("no rows", lambda: editor.click("inspector/shape"), lambda s: "inspector/core" not in s["widgets"])
    t.check_equal("undone, the rig is as it was", pair.read()[2], before[2])
    return before


def right_leads_too(t, editor, pair, before):
    editor.select_muscle(pair.right_name)
    editor.tap("w", "move", lambda s: s["gizmo"]["mode"] == "move")
    editor.drag_handle("move.center", WAY)
    after = pair.check_mirrored("a drag on the right")
    changed(t, "a drag on the right", before, after, {"center"})
    editor.select_muscle(pair.left_name)
    return after


def unlinked(t, editor, pair, linked):
    """Returns the rigs (as saved) linked, unlinked, edited."""
    editor.act("the twins to part", lambda: editor.click("inspector/unlink"), lambda s: s["symmetry"]["twin"] == "")
    apart = pair.read()
    t.check_equal("unlinking changes the links and nothing else",
                  [rigs.changed_parts(linked[i], apart[i]) for i in (0, 1)], [{"mirror"}, {"mirror"}])
    editor.tap("w", "move", lambda s: s["gizmo"]["mode"] == "move")
    editor.drag_handle("move.center", [(-x, -y) for x, y in WAY])
    edited = pair.read()
    t.check_equal("unlinked, the left one moves", rigs.changed_parts(apart[0], edited[0]), {"center"})
    t.check_equal("unlinked, the right one stays to the bit", edited[1], apart[1])
    error = bind_pose.mirror_error(pair.bones, edited[0], edited[1]) / pair.height
    t.check("and is its image no more", error > 100 * EXACT, error)
    return linked[2], apart[2], edited[2]


def back_and_forth(t, editor, pair, states):
    """Undo over the unlinking: linked again, and following again; redo leads to where it was."""
    linked, apart, edited = states
    undo = editor.state()["document"]["undo"]
    editor.tap("ctrl+z", "undo of the move", lambda s: s["document"]["undo"] == undo - 1)
    t.check_equal("undone, the unlinked pair is as it was", editor.saved_rig(), apart)
    state = editor.tap("ctrl+z", "undo of the unlinking", lambda s: s["document"]["undo"] == undo - 2)
    t.check_equal("undone, they are twins", state["symmetry"]["twin"], pair.right_name)
    t.check_equal("undone, the linked pair is as it was", editor.saved_rig(), linked)
    editor.tap("ctrl+shift+z", "redo of the unlinking", lambda s: s["document"]["undo"] == undo - 1)
    editor.tap("ctrl+shift+z", "redo of the move", lambda s: s["document"]["undo"] == undo)
    t.check_equal("redone, the right one is where it was left", editor.saved_rig(), edited)
    editor.taps("ctrl+z", "ctrl+z")
    editor.wait_until("both undone", lambda s: s["document"]["undo"] == undo - 2)
    before = pair.read()
    editor.drag_handle("move.center", WAY)
    after = pair.check_mirrored("linked again by undo, a drag")
    changed(t, "linked again by undo, a drag", before, after, {"center"})


def mirrored_anew(t, editor, pair):
    """Parted, moved, and brought back by the command: no third muscle, the left one leads."""
    editor.act("the twins to part", lambda: editor.key("ctrl+shift+u"), lambda s: s["symmetry"]["twin"] == "")
    editor.drag_handle("move.center", [(-x, y) for x, y in WAY])
    left = pair.read()[0]
    undo = editor.state()["document"]["undo"]
    editor.palette("mirror to other side", "edit/mirror")
    state = editor.wait_until("a twin", lambda s: s["document"]["undo"] == undo + 1)
    t.check_equal("without a twin, mirroring makes one", state["document"]["primitives"], 3)
    rig = editor.saved_rig()
    by_name = {muscle["name"]: muscle for muscle in rig["primitives"]}
    error = bind_pose.mirror_error(pair.bones, by_name[pair.left_name], by_name[state["symmetry"]["twin"]]) / pair.height
    t.check("it is the mirror image", error < EXACT, error)
    t.check_equal("and who led stays", rigs.changed_parts(left, by_name[pair.left_name]), {"mirror"})


def one_side_alone(t, editor, role):
    editor.tap("shift+s", "symmetry off", lambda s: not s["symmetry"]["on"])
    count = editor.state()["document"]["primitives"]
    editor.select_bone(role["left"])
    state = editor.tap("ctrl+m", "a muscle", lambda s: s["document"]["primitives"] > count)
    t.check_equal("without symmetry, one muscle", (state["document"]["primitives"], state["symmetry"]["twin"]), (count + 1, ""))
    editor.tap("shift+s", "symmetry on", lambda s: s["symmetry"]["on"])


def undone_to_the_start(t, editor):
    steps = editor.state()["document"]["undo"]
    editor.taps(*["ctrl+z"] * steps)
    state = editor.wait_until("all undone", lambda s: s["document"]["undo"] == 0)
    t.check_equal("all undone, no muscle is left", state["document"]["primitives"], 0)
    editor.taps(*["ctrl+shift+z"] * steps)
    editor.wait_until("all redone", lambda s: s["document"]["undo"] == steps)


def story(t):
    role = CAST[sys.argv[5]]
    source = (t.characters if role["real"] else t.assets) / role["file"]
    if role["real"] and not source.is_file():
        raise driver.Skip("real characters are not at hand")
    file = t.copy(source)
    height = json.loads(t.run_program("inspect", "--json", file).stdout)["height"]
    editor = t.edit(file)
    editor.wait_until("a character", lambda s: s["triangles"] > 0)
    paused_in_a_clip(editor, role)
    pair = Pair(t, editor, bind_pose.bones_in_bind(file), height)
    pair.left_name, pair.right_name = add_on_both_sides(t, editor, role)
    left, right, _ = pair.read()
    t.check_equal("one on each side", (left["bone"], right["bone"]), (role["left"], role["right"]))
    now = typed(t, editor, pair, dragged(t, editor, pair))
    now = shaped(t, editor, pair, now)
    now = right_leads_too(t, editor, pair, now)
    editor.screenshot(t.out / ("symmetry_%s.png" % sys.argv[5]))
    back_and_forth(t, editor, pair, unlinked(t, editor, pair, now))
    mirrored_anew(t, editor, pair)
    one_side_alone(t, editor, role)
    end = editor.saved_rig()
    undone_to_the_start(t, editor)
    t.check_equal("undone and redone, the rig is the same", editor.saved_rig(), end)
    editor.screenshot(t.out / ("symmetry_%s_unlinked.png" % sys.argv[5]))
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("symmetry_" + sys.argv[5], story))
