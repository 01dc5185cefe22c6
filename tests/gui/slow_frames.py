# tests/gui/slow_frames.py: what hands do during one long frame is all done after it: clicks, taps, text, a whole drag.
import pathlib
import signal
import sys

import driver

BONE = "thigh.L"


class Stopped:
    """The editor stands still for the time of a with: the longest frame there can be."""

    def __init__(self, editor):
        self.editor = editor

    def __enter__(self):
        self.editor.process.send_signal(signal.SIGSTOP)
        status = pathlib.Path("/proc/%d/stat" % self.editor.process.pid)
        driver.wait_for("the editor to stand still", lambda: status.read_text().rsplit(")", 1)[1].split()[0] == "T")
        self.editor.read_new()

    def __exit__(self, *_):
        self.editor.process.send_signal(signal.SIGCONT)


def heavy(t):
    """A document whose frames are long: one muscle, the least tolerance, wire, playing."""
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: BONE in s["bones"])
    editor.one_sided()
    editor.choose_clip(-1, "")
    editor.type_number("smoothing/tolerance", "0.01")
    editor.wait_until("the tolerance to be a step", lambda s: s["tolerance"] < 0.00011 and s["document"]["undo"] == 1)
    editor.select_bone(BONE)
    editor.tap("ctrl+m", "a muscle", lambda s: s["document"]["primitives"] == 1 and s["document"]["undo"] == 2)
    editor.wait_until("much to draw", lambda s: s["triangles"] > 50000)
    return editor


def click_and_tap(t, editor):
    button = editor.widget("toolstrip/rotate")
    pill = editor.widget("display/skeleton")
    before = editor.state()
    t.check("the tool and the display will change", before["tool"] != "rotate" and not before["display"]["skeleton"])
    with Stopped(editor):
        editor.xdotool("mousemove", *map(round, button), "click", driver.LEFT)
        editor.xdotool("mousemove", *map(round, pill), "click", driver.LEFT)
        editor.xdotool("key", "5")
    state = editor.wait_until("both clicks and the key", lambda s: s["tool"] == "rotate" and s["display"]["skeleton"] and
                              s["display"]["wire"])
    t.check_equal("two clicks and a tap during one frame all arrive", state["document"], before["document"])
    shown = state["display"]["influence"]
    with Stopped(editor):
        editor.key("9", "9", "9", "0")
    state = editor.wait_until("the last tap", lambda s: not s["display"]["ground"])
    t.check("three taps of one key are three", state["display"]["influence"] != shown)


def whole_drag(t, editor):
    before = editor.tap("w", "move handles", lambda s: s["gizmo"]["mode"] == "move" and "move.center" in s["gizmo"]["handles"])
    start = [round(v) for v in before["gizmo"]["handles"]["move.center"]]
    with Stopped(editor):
        editor.xdotool("mousemove", *start, "mousedown", driver.LEFT)
        editor.xdotool("mousemove", start[0] + 20, start[1] + 12)
        editor.xdotool("mousemove", start[0] + 40, start[1] + 24, "mouseup", driver.LEFT)
        # On: the release belongs to where it happened, not to where the pointer is when the frame ends.
        editor.xdotool("mousemove", start[0] + 150, start[1] - 90)
    state = editor.wait_until("the drag to be a step",
                              lambda s: s["document"]["undo"] == before["document"]["undo"] + 1 and not s["gizmo"]["dragging"])
    state = editor.wait_until("the pointer to come to rest", lambda s: abs(s["mouse"][0] - start[0] - 150) < 0.1)
    seen = state["gizmo"]["handles"]["move.center"]
    # A muscle that is dragged in the picture's plane stays under the pointer.
    t.check("a drag during one frame ends where the button was released",
            abs(seen[0] - start[0] - 40) <= 2 and abs(seen[1] - start[1] - 24) <= 2, (seen, start))
    t.check_equal("the muscle stays selected", state["document"]["selection"], before["document"]["selection"])


def text(t, editor):
    search = editor.widget("outliner/search")
    with Stopped(editor):
        editor.xdotool("mousemove", *map(round, search), "click", driver.LEFT)
        editor.type("forearm.r")
    state = editor.wait_until("the outliner to show what was typed",
                              lambda s: "outliner/bone/forearm.R" in s["widgets"] and "outliner/bone/forearm.L" not in s["widgets"])
    t.check("a click and nine letters during one frame are all there", "outliner/bone/tail.1" not in state["widgets"])
    editor.fill("outliner/search", "forearm")
    editor.wait_until("a wider search", lambda s: "outliner/bone/forearm.L" in s["widgets"])


def short_click_on_slow_frames(t, editor):
    """No standstill now: real frames, as long as they come while it plays."""
    editor.choose_clip(0, "Walk")
    editor.tap("space", "playing", lambda s: s["playing"])
    for name in ("toolstrip/scale", "toolstrip/select", "toolstrip/move"):
        tool = name.split("/")[1]
        editor.click(name)
        editor.wait_until("a short click on " + name, lambda s: s["tool"] == tool)
    t.check("short clicks on slow frames arrive", editor.state()["playing"])
    for expected in (False, True, False):
        editor.tap("space", "a tap of space", lambda s: s["playing"] == expected)
    t.check("short taps on slow frames arrive, each once", not editor.state()["playing"])


def coarse_while_moving(t, editor):
    """Where the processor draws, frames of this size are slow: they become smaller while it plays, and whole at rest."""
    if not editor.state()["playing"]:
        editor.tap("space", "playing", lambda s: s["playing"])
    editor.wait_until("fewer pixels while it plays", lambda s: s["picture_scale"] < 1)
    editor.tap("space", "a stop", lambda s: not s["playing"])
    state = editor.wait_until("all pixels and samples at rest", lambda s: s["samples"] == 16)
    t.check_equal("at rest the picture is whole", state["picture_scale"], 1)


def story(t):
    editor = heavy(t)
    click_and_tap(t, editor)
    whole_drag(t, editor)
    text(t, editor)
    short_click_on_slow_frames(t, editor)
    coarse_while_moving(t, editor)
    editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/discard")
    t.check_equal("quits", editor.wait_for_end(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("slow_frames", story))
