# tests/gui/crash.py: killed in the middle of a drag, and in the middle of saving. What was saved is whole, little is lost.
import json
import pathlib
import sys

import driver
import rigs

MUSCLE = "thigh L"
INTERVAL = 3  # Seconds between autosaves here; what the editor does of itself is checked to be 30.


def recovery_files(t):
    return sorted((pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "recovery").glob("*.json"))


def preferences(t):
    return pathlib.Path(t.environment["XDG_CONFIG_HOME"]) / "sinew" / "preferences.json"


def muscle_of(rig, name=MUSCLE):
    return next(m for m in rig["primitives"] if m["name"] == name)


def kept_rig(t):
    """The rig in the recovery file, if there is one. Written atomically: a file that is there is whole."""
    files = recovery_files(t)
    return json.loads(files[0].read_text())["rig"] if files else None


def opened(t):
    editor = t.edit(t.folder / "demo.rig.json")
    state = editor.wait_until("the rig", lambda s: s["document"]["primitives"] == 15)
    if state["playing"]:
        editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    return editor


def of_itself(t):
    """What an editor without preferences does: it writes down an interval of 30 seconds."""
    editor = opened(t)
    t.check_equal("quits", editor.quit(), 0)
    written = json.loads(preferences(t).read_text())
    t.check_equal("unsaved work is written every 30 seconds", written["autosave_seconds"], 30)
    preferences(t).write_text(json.dumps(dict(written, autosave_seconds=INTERVAL)))


def dragged_and_killed(t, file, before):
    """A drag that lasts over two autosaves. Returns what the second of them, or a later one, holds."""
    editor = opened(t)
    editor.select_muscle(MUSCLE)
    editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    editor.grab("move.center")
    start, step = editor.mouse, [0]

    def pull():
        step[0] += 1
        # Never back to the start: there nothing is unsaved.
        editor.move((start[0] + 1 + step[0] % 60, start[1] + (step[0] // 2) % 30))

    def kept_after(rig):
        """Goes on pulling until another state than that is on the disk."""
        def look():
            pull()
            kept = kept_rig(t)
            return kept if kept is not None and muscle_of(kept) != muscle_of(rig) else None
        return driver.wait_for("an autosave in the middle of the drag", look)

    original = json.loads(before)
    first = kept_after(original)
    second = kept_after(first)
    state = editor.state()
    t.check("all this in one drag", state["gizmo"]["dragging"] and state["document"]["undo"] == 0)
    t.check_equal("the copy holds the drag", rigs.changed_parts(muscle_of(original), muscle_of(second)), {"center"})
    editor.screenshot(t.out / "crash_dragging.png")
    editor.kill()
    editor.release()  # The button goes up, though nobody listens.
    t.check_equal("the copy is left, and one alone", len(recovery_files(t)), 1)
    t.check("the rig's own file is untouched, byte for byte", file.read_bytes() == before)
    return kept_rig(t)


def recovered(t, file, before, kept):
    editor = t.edit(file)
    editor.wait_until("the question", lambda s: s["dialog"] == "recovery" and "recovery/recover/0" in s["widgets"])
    editor.settle()
    editor.screenshot(t.out / "crash_question.png")
    editor.click("recovery/recover/0")
    state = editor.wait_until("the work", lambda s: s["document"]["modified"] and s["dialog"] == "")
    t.check_equal("it is the same document", (state["document"]["path"], state["document"]["primitives"]), (str(file), 15))
    t.check("the title says that it is not saved", "*" in editor.title(), editor.title())
    t.check("and the file on the disk still is what it was", file.read_bytes() == before)
    other = t.folder / "recovered.rig.json"
    editor.save_as(other)
    rig = json.loads(other.read_text())
    t.check_equal("recovered is what was copied in the middle of the drag", rig["primitives"], kept["primitives"])
    driver.wait_for("the copy to go once it is saved", lambda: not recovery_files(t))
    editor.tap("ctrl+z", "a step back", lambda s: s["document"]["undo"] == 0)
    t.check_equal("one step back is what the file held", editor.saved_rig()["primitives"], json.loads(before)["primitives"])
    t.check_equal("quits", editor.quit(), 0)


def killed_while_saving(t, file):
    """Some moment after the key: the file is the old one or the new one, nothing between, and nothing else lies there."""
    outcomes = []
    for rest in (0.0, 0.02, 0.05, 0.1, 0.4):
        editor = opened(t)
        editor.select_muscle(MUSCLE)
        editor.type_number("inspector/reach", "%.4f" % (1.3 + rest))
        editor.wait_until("a change", lambda s: s["document"]["modified"])
        old = file.read_bytes()
        editor.key("ctrl+s")
        try:
            driver.wait_for("some moment", lambda: file.read_bytes() != old, timeout=rest)
        except driver.Failure:
            pass
        editor.kill()
        now = file.read_bytes()
        reach = muscle_of(json.loads(now))["reach"]
        outcomes.append("new" if now != old else "old")
        t.check("killed after Ctrl+S, the file is whole: the %s one" % outcomes[-1], now == old or abs(reach - 1.3 - rest) < 1e-6)
        told = t.run_program("inspect", file)
        t.check_equal("and can be read: " + told.stderr, told.returncode, 0)
        for left in recovery_files(t):
            left.unlink()  # Recovery is what was tested above.
    print("killed while saving: " + ", ".join(outcomes))


def story(t):
    t.copy(t.assets / "demo.glb")
    file = t.copy(t.assets / "demo.rig.json")
    of_itself(t)
    before = file.read_bytes()
    kept = dragged_and_killed(t, file, before)
    recovered(t, file, before, kept)
    killed_while_saving(t, file)


if __name__ == "__main__":
    sys.exit(driver.run("crash", story))
