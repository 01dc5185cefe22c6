# tests/gui/blending.py: matrix and graph are two views of one thing; groups made, named, removed; muscles moved.
"""The lizard's rig: 15 muscles in legs, torso and arms, the torso linked to both."""
import subprocess
import sys

import driver

LEGS, TORSO, ARMS, FEET = "legs", "torso", "arms", "feet and toes"
MUSCLE = "glute L"


def pairs(links):
    return {frozenset(link) for link in links}


def cell(editor, a, b):
    """The matrix has one cell for a pair, in the row of the group that comes later."""
    names = list(editor.state()["groups"])
    first, last = sorted((a, b), key=names.index)
    return "blending/cell/%s/%s" % (last, first)


def edges(state):
    """Pairs of groups that the graph shows as linked."""
    return {frozenset(name.split("/")[2:4]) for name in state["widgets"] if name.startswith("blending/edge/")}


def show(editor, view):
    other = "blending/canvas" if view == "graph" else "blending/cell/%s/%s" % (LEGS, LEGS)
    editor.click("blending/view/" + view)
    return editor.wait_until("the " + view, lambda s: other in s["widgets"])


class Picture:
    """Colors on the screen."""

    def __init__(self, t, editor):
        self.file = t.folder / "picture.png"
        editor.settle()
        editor.screenshot(self.file)

    def color(self, point):
        text = subprocess.run(["convert", str(self.file), "-format", "%%[pixel:p{%d,%d}]" % (point[0], point[1]), "info:"],
                              capture_output=True, text=True, check=True, timeout=driver.PATIENCE).stdout
        return text.strip()


def matrix_shows(t, editor):
    """Which pairs the matrix marks: a dot of color in the middle of the cell, none in the others."""
    editor.move((640, 786))  # Nothing is hovered.
    names = list(editor.state()["groups"])
    picture = Picture(t, editor)
    colors = {}
    for i, last in enumerate(names):
        for first in names[:i]:
            colors[frozenset((last, first))] = picture.color(editor.widget(cell(editor, last, first)))
    background = picture.color((editor.widget("outliner/tab")[0] + 70, 120))
    dark = {pair for pair, color in colors.items() if sum(channels(color)) < sum(channels(background)) + 12}
    return set(colors) - dark


def channels(color):
    return [float(v.rstrip("%")) for v in color[color.index("(") + 1:color.index(")")].split(",")[:3]]


def agree(t, editor, what, wanted):
    """State, saved file, matrix as it is drawn, and graph tell the same links."""
    t.check_equal(what + ": the state", pairs(editor.state()["links"]), wanted)
    t.check_equal(what + ": the file", pairs(editor.saved_rig()["links"]), wanted)
    show(editor, "matrix")
    t.check_equal(what + ": the matrix", matrix_shows(t, editor), wanted)
    state = show(editor, "graph")
    t.check_equal(what + ": the graph", edges(state), wanted)


def opened(t):
    for name in ("demo.glb", "demo.rig.json"):
        t.copy(t.assets / name)
    editor = t.edit(t.folder / "demo.rig.json")
    state = editor.wait_until("the rig", lambda s: s["document"]["primitives"] == 15)
    t.check_equal("its groups", state["groups"], {LEGS: 4, TORSO: 5, ARMS: 6})
    if state["playing"]:
        editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    editor.click("blending/tab")
    editor.wait_until("the groups", lambda s: "blending/view/graph" in s["widgets"])
    return editor


def links_in_both_views(t, editor):
    both = {frozenset((LEGS, TORSO)), frozenset((TORSO, ARMS))}
    agree(t, editor, "opened", both)
    show(editor, "matrix")
    editor.act("a cell to unlink", lambda: editor.click(cell(editor, TORSO, ARMS)), lambda s: len(s["links"]) == 1)
    agree(t, editor, "unlinked in the matrix", {frozenset((LEGS, TORSO))})
    start = editor.widget("blending/rim/" + LEGS)
    editor.drag(start, editor.widget("blending/node/" + ARMS))
    editor.wait_until("a drag from rim to node to link", lambda s: len(s["links"]) == 2)
    agree(t, editor, "linked in the graph", {frozenset((LEGS, TORSO)), frozenset((LEGS, ARMS))})
    # The torso stands between the two others: their edge has to go around it to be seen, and to be clicked by itself.
    editor.screenshot(t.out / "blending_bent_edge.png")
    editor.click("blending/edge/%s/%s" % (LEGS, TORSO))
    editor.wait_until("a click on an edge to unlink", lambda s: len(s["links"]) == 1)
    agree(t, editor, "unlinked in the graph", {frozenset((LEGS, ARMS))})
    undo = editor.state()["document"]["undo"]
    t.check_equal("three steps", undo, 3)
    for left in (2, 1, 0):
        editor.tap("ctrl+z", "undo", lambda s: s["document"]["undo"] == left)
    agree(t, editor, "undone", both)
    editor.taps(*["ctrl+shift+z"] * 3)
    editor.wait_until("redone", lambda s: s["document"]["undo"] == 3)
    agree(t, editor, "redone", {frozenset((LEGS, ARMS))})


def node_moves(t, editor):
    """Dragging a node places it; the document is not touched."""
    before = editor.state()
    start = editor.widget("blending/node/" + TORSO)
    editor.drag(start, (start[0] + 30, start[1] + 24))
    state = editor.wait_until("the node to move", lambda s: abs(s["widgets"]["blending/node/" + TORSO][1] -
                                                              before["widgets"]["blending/node/" + TORSO][1]) > 10)
    t.check_equal("moving a node is no change", state["document"]["undo"], before["document"]["undo"])


def adds_and_names(t, editor):
    show(editor, "matrix")
    undo = editor.state()["document"]["undo"]
    editor.click("blending/add")
    editor.wait_until("a new group, its name to be typed", lambda s: len(s["groups"]) == 4 and "blending/rename" in s["widgets"])
    editor.settle()
    editor.key("ctrl+a")
    editor.type(FEET)
    state = editor.tap("Return", "the name", lambda s: FEET in s["groups"] and "blending/rename" not in s["widgets"])
    t.check_equal("added and named", (list(state["groups"]), state["document"]["undo"]), ([LEGS, TORSO, ARMS, FEET], undo + 2))
    # A name that is taken is refused, with a word.
    rename_by_menu(editor, FEET)
    editor.key("ctrl+a")
    editor.type(ARMS)
    state = editor.tap("Return", "the field to close", lambda s: "blending/rename" not in s["widgets"])
    t.check_equal("two groups of one name there are not", list(editor.settle()["groups"]), [LEGS, TORSO, ARMS, FEET])
    rename_by_menu(editor, LEGS)
    editor.key("ctrl+a")
    editor.type("hind legs")
    state = editor.tap("Return", "another name for a linked group", lambda s: "hind legs" in s["groups"])
    t.check_equal("links go along with the name", pairs(state["links"]), {frozenset(("hind legs", ARMS))})
    rig = editor.saved_rig()
    t.check_equal("and so do the muscles", sum(m["group"] == "hind legs" for m in rig["primitives"]), 4)
    editor.tap("ctrl+z", "undo of the name", lambda s: LEGS in s["groups"])


def context(editor, name, entry):
    editor.point_at(lambda: editor.widget(name))
    editor.xdotool("click", driver.RIGHT)
    editor.click("context/" + entry)


def rename_by_menu(editor, group):
    context(editor, "blending/group/" + group, "group-rename")
    editor.wait_until("the name to be typed", lambda s: "blending/rename" in s["widgets"])
    editor.settle()


def moves_muscles(t, editor):
    """By the button, by drag and drop onto the name, by the inspector: the file says so."""
    def group_of(name):
        return next(m["group"] for m in editor.saved_rig()["primitives"] if m["name"] == name)

    editor.click("outliner/tab")
    editor.click("outliner/muscle/" + MUSCLE)
    editor.wait_until("a muscle to be selected", lambda s: s["document"]["selection"] == [MUSCLE])
    editor.click("blending/tab")
    editor.click("blending/group/" + FEET)
    editor.act("the muscle to move", lambda: editor.click("blending/move-here"), lambda s: s["groups"][FEET] > 0)
    t.check_equal("the selected muscle is in the group, in the file", group_of(MUSCLE), FEET)
    t.check_equal("its linked twin went along", group_of("glute R"), FEET)
    editor.tap("ctrl+z", "undo", lambda s: s["groups"][FEET] == 0)

    editor.click("outliner/tab")
    start = editor.widget("outliner/muscle/" + MUSCLE)
    editor.move(start)
    editor.press()
    editor.move((start[0] + 12, start[1] + 6))
    editor.move(editor.widget("blending/tab"))
    editor.wait_until("the tab to open under a dragged muscle", lambda s: "blending/group/" + FEET in s["widgets"])
    target = editor.widget("blending/group/" + FEET)
    editor.move((target[0] - 3, target[1]))
    editor.move(target)
    editor.screenshot(t.out / "blending_drop.png")
    editor.release()
    editor.wait_until("the muscle to be dropped", lambda s: s["groups"][FEET] > 0)
    t.check_equal("dropped, it is in the group, in the file", group_of(MUSCLE), FEET)
    editor.tap("ctrl+z", "undo", lambda s: s["groups"][FEET] == 0)

    editor.pick("inspector/group", FEET)
    editor.wait_until("the inspector to move it", lambda s: s["groups"][FEET] > 0)
    t.check_equal("chosen in the inspector, it is in the group, in the file", group_of(MUSCLE), FEET)


def removes(t, editor):
    """A group with muscles asks where they go; an empty one goes at once; links to them go with them."""
    before = editor.state()
    editor.point_at(lambda: editor.widget("blending/group/" + FEET))
    editor.xdotool("click", driver.RIGHT)
    editor.move(editor.widget("context/group-delete"))  # Opens the list of the other groups.
    editor.click("context/group-delete/" + TORSO)
    state = editor.wait_until("the group to go", lambda s: FEET not in s["groups"])
    t.check_equal("its muscles went where they were told", state["groups"][TORSO],
                  before["groups"][TORSO] + before["groups"][FEET])
    t.check_equal("one step", state["document"]["undo"], before["document"]["undo"] + 1)
    editor.click("blending/add")
    editor.wait_until("an empty group", lambda s: len(s["groups"]) == 4 and "blending/rename" in s["widgets"])
    editor.settle()
    editor.tap("Return", "its name", lambda s: "blending/rename" not in s["widgets"])
    empty = list(editor.state()["groups"])[-1]
    editor.click(cell(editor, empty, TORSO))
    editor.wait_until("a link of the empty group", lambda s: frozenset((empty, TORSO)) in pairs(s["links"]))
    context(editor, "blending/group/" + empty, "group-delete")
    state = editor.wait_until("the empty group to go", lambda s: empty not in s["groups"])
    t.check("its link went with it", all(empty not in link for link in state["links"]), state["links"])


def story(t):
    editor = opened(t)
    file = t.folder / "demo.rig.json"
    editor.saved_rig()
    start = file.read_bytes()
    links_in_both_views(t, editor)
    node_moves(t, editor)
    editor.screenshot(t.out / "blending_graph.png")
    adds_and_names(t, editor)
    editor.screenshot(t.out / "blending_matrix.png")
    moves_muscles(t, editor)
    removes(t, editor)
    agree(t, editor, "at the end", pairs(editor.state()["links"]))
    steps = editor.state()["document"]["undo"]
    editor.taps(*["ctrl+z"] * steps)
    editor.wait_until("all undone", lambda s: s["document"]["undo"] == 0)
    editor.saved_rig()
    t.check("all undone and saved, the file is as it was, byte for byte", file.read_bytes() == start)
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("blending", story))
