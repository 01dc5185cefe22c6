# tests/gui/sheets.py: a sheet is drawn with two strokes, its edge is dragged, and it is broken into strips.
import sys

import driver

BONE = "thigh.L"


def stroke(editor, start, end):
    """Slowly, so that a slow frame sees the way."""
    editor.move(start)
    editor.settle()
    editor.press()
    for i in range(1, 5):
        editor.move([round(a + (b - a) * i / 4) for a, b in zip(start, end)])
        editor.settle()
    editor.release()


def drawn(t, editor):
    editor.one_sided()
    editor.tap("d", "the tool", lambda s: s["tool"] == "add sheet")
    state = editor.state()
    (x, y), (_, below) = state["bones"][BONE], state["bones"]["shin.L"]
    low, high = round(y + 0.7 * (below - y)), round(y + 0.3 * (below - y))
    x = round(x)
    stroke(editor, (x - 9, high), (x + 9, high))
    editor.wait_until("the second stroke to be next", lambda s: s["status"].startswith("Sheet, second stroke"))
    t.check_equal("the origin alone is no step", editor.state()["document"]["undo"], 0)
    stroke(editor, (x - 9, low), (x + 9, low))
    state = editor.wait_until("the sheet", lambda s: s["document"]["sheets"] == 1 and s["document"]["undo"] == 1)
    t.check_equal("one muscle is selected", len(state["document"]["selection"]), 1)
    rows = [row for row in state["widgets"] if row.startswith("outliner/muscle/")]
    t.check_equal("one row in the list", rows, ["outliner/muscle/" + state["document"]["selection"][0]])


def edited(t, editor):
    editor.tap("w", "the move tool", lambda s: s["tool"] == "move" and "edges" in s["sheet"])
    point = editor.state()["sheet"]["edges"][0][0]
    editor.move(point)
    editor.wait_until("the handle", lambda s: s["sheet"]["hovered"] == "origin")
    stroke(editor, point, [point[0] + 4, point[1] + 12])
    state = editor.wait_until("the edge to move", lambda s: s["document"]["undo"] == 2 and not s["sheet"]["dragging"])
    t.check("the point lies elsewhere", state["sheet"]["edges"][0][0][1] > point[1] + 4, state["sheet"]["edges"][0][0])
    editor.type_number("inspector/sheet/strips", "4")
    editor.wait_until("four strips", lambda s: s["sheet"]["strips"] == 4)
    bellies = editor.state()["document"]["primitives"]
    editor.palette("break into strips", "edit/break-sheet")
    state = editor.wait_until("single muscles", lambda s: s["document"]["sheets"] == 0)
    t.check_equal("all bellies stay", state["document"]["primitives"], bellies)
    editor.taps(*["ctrl+z"] * 4)
    editor.wait_until("all undone", lambda s: s["document"]["undo"] == 0 and s["document"]["primitives"] == 0)


def sheets(t):
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("the character", lambda s: BONE in s["bones"])
    editor.tap("space", "the pause", lambda s: not s["playing"])
    editor.tap("KP_1", "the front", lambda s: not s["camera_moving"])
    editor.select_bone(BONE)
    editor.tap("f", "the frame", lambda s: not s["camera_moving"])
    drawn(t, editor)
    edited(t, editor)
    editor.quit()


sys.exit(driver.run("sheets", sheets))
