# tests/gui/session.py: from one start to the next: as it was left; killed in a drag, the work comes back; killed while it saves.
import json
import pathlib
import sys

import driver
from acts import changed_keys

BONE = "thigh.L"


def recovery_files(t):
    return list((pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "recovery").glob("*.json"))


def kept_rig(t):
    """The rig in the recovery file, if there is one. Written atomically: a file that is there is whole."""
    files = recovery_files(t)
    return json.loads(files[0].read_text())["rig"] if files else None


def opened(t, file):
    editor = t.edit(file)
    editor.wait_until("the character", lambda s: BONE in s["bones"])
    return editor


def another_key(editor):
    editor.key("ctrl+comma")
    editor.click("preferences/page/keys")
    editor.click("preferences/keys/search")
    editor.type("Ground")
    editor.click("preferences/keys/view/ground/1")
    editor.key("ctrl+k")
    editor.wait_until("the row to be changed", lambda s: "preferences/keys/view/ground/reset" in s["widgets"])
    editor.click("preferences/close")
    editor.wait_until("the dialog to close", lambda s: "preferences/close" not in s["widgets"])


def works(editor):
    shown = editor.state()["display"]["ground"]
    editor.tap("ctrl+k", "the ground by its new key", lambda s: s["display"]["ground"] != shown)


def arranged(t, editor):
    """Panels, a key, the picture, the moment: what comes back is this state."""
    before = editor.state()
    x, y = editor.widget("layout/left")
    editor.drag([x, y], [x + 60, y])
    editor.wait_until("a wider panel", lambda s: s["viewport"][0] > before["viewport"][0] + 50)
    editor.tap("n", "the right panels to go", lambda s: "layout/right" not in s["widgets"])
    another_key(editor)
    works(editor)
    editor.palette("clay", "view/clay")
    editor.tap("space", "a pause", lambda s: not s["playing"])
    editor.tap("ctrl+Left", "the start", lambda s: s["clip_time"] == 0)
    editor.tap("period", "the next frame", lambda s: s["clip_time"] > 0)
    x, y, width, height = editor.state()["viewport"]
    low = (x + 0.5 * width, y + height - 30)
    editor.drag(low, (low[0] + 140, low[1] - 20))
    return editor.wait_until("another view", lambda s: abs(s["camera"]["yaw"] - before["camera"]["yaw"]) > 0.2 and
                             not s["camera_moving"] and s["display"]["shading"] == "clay")


def as_it_was_left(t, before, state):
    for what in ("clip", "playing", "display", "viewport"):
        t.check_equal("as it was left: " + what, state[what], before[what])
    numbers = lambda s: [s["clip_time"], *(s["camera"][k] for k in ("yaw", "pitch", "distance"))]
    t.check("as it was left: moment and view", max(abs(a - b) for a, b in zip(numbers(state), numbers(before))) < 1e-4)
    t.check("what was hidden stays hidden", "layout/right" not in state["widgets"])


def dragged_and_killed(t, editor, file):
    """A drag that lasts over two autosaves. Returns what the last of them holds."""
    editor.select_bone(BONE)
    editor.tap("ctrl+m", "a muscle and its twin", lambda s: s["document"]["primitives"] == 2)
    editor.save_as(file)
    before = file.read_bytes()
    editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    editor.grab("move.center")
    start, step, seen = editor.mouse, [0], [json.loads(before)["primitives"]]

    def kept_twice():
        step[0] += 1
        # Never back to the start: there nothing is unsaved.
        editor.move((start[0] + 1 + step[0] % 60, start[1] + (step[0] // 2) % 30))
        kept = kept_rig(t)
        if kept and kept["primitives"] not in seen:
            seen.append(kept["primitives"])
        return len(seen) > 2

    driver.wait_for("two autosaves in the middle of the drag", kept_twice)
    state = editor.state()
    t.check("all this in one drag", state["gizmo"]["dragging"] and state["document"]["undo"] == 1)
    editor.kill()
    editor.release()  # The button goes up, though nobody listens.
    t.check_equal("one copy is left", len(recovery_files(t)), 1)
    t.check_equal("it holds the drag", changed_keys(seen[0][0], seen[-1][0]), {"center"})
    t.check("the rig's own file is untouched, byte for byte", file.read_bytes() == before)
    return before


def recovered(t, file, before):
    kept = kept_rig(t)
    editor = t.edit(file)
    editor.click("recovery/recover/0")
    state = editor.wait_until("the work", lambda s: s["document"]["modified"] and s["dialog"] == "")
    t.check_equal("it is the same document", state["document"]["path"], str(file))
    t.check("the title says that it is not saved", "*" in editor.title(), editor.title())
    t.check("and the file on the disk still is what it was", file.read_bytes() == before)
    other = t.folder / "recovered.rig.json"
    editor.save_as(other)
    t.check_equal("what was copied in the drag is recovered", json.loads(other.read_text())["primitives"], kept["primitives"])
    driver.wait_for("the copy to go once it is saved", lambda: not recovery_files(t))
    t.check_equal("quits", editor.quit(), 0)


def killed_while_saving(t, file):
    """The file is the old one or the new one, nothing between."""
    editor = opened(t, file)
    t.check_equal("after a clean end nothing is asked", editor.state()["dialog"], "")
    editor.key("ctrl+a")
    editor.tap("Delete", "a change", lambda s: s["document"]["primitives"] == 0)
    old = file.read_bytes()
    editor.key("ctrl+s")
    editor.kill()
    now = file.read_bytes()
    t.check("killed after Ctrl+S, the file is whole", now == old or json.loads(now)["primitives"] == [])


def story(t):
    character, rig = t.copy(t.assets / "demo.glb"), t.folder / "work.rig.json"
    t.prefer(autosave_seconds=1)
    editor = opened(t, character)
    before = arranged(t, editor)
    t.check_equal("quits", editor.quit(), 0)
    editor = opened(t, character)
    as_it_was_left(t, before, editor.state())
    works(editor)
    recovered(t, rig, dragged_and_killed(t, editor, rig))
    killed_while_saving(t, rig)


if __name__ == "__main__":
    sys.exit(driver.run("session", story))
