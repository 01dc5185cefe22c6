# tests/gui/on_card.py: the surface by the graphics card shows what the processor's shows; and what happens where it cannot.
import shutil
import sys

import driver

SAMPLES = 16
MOST = 2  # Of 255, in all but a two hundredth of the pixels.


def shown(editor):
    """The picture at rest, without what lies over it."""
    editor.move((640, 12))
    state = editor.wait_until("all samples", lambda s: s["samples"] == SAMPLES and not s["camera_moving"])
    x, y, width, height = state["viewport"]
    return editor.pixels((x + 0.25 * width, y + 0.2 * height, 0.5 * width, 0.6 * height))


def differing(a, b):
    """Fraction of the pixels that differ by more than MOST."""
    assert len(a) == len(b) > 30000
    far = sum(any(abs(a[i + c] - b[i + c]) > MOST for c in range(3)) for i in range(0, len(a), 3))
    return 3.0 * far / len(a)


def fifth_frame(editor):
    if editor.state()["playing"]:
        editor.tap("space", "a pause", lambda s: not s["playing"])
    editor.tap("ctrl+Left", "the start", lambda s: s["clip_time"] == 0)
    editor.taps(*["period"] * 4)
    editor.wait_until("frame 5", lambda s: abs(s["clip_time"] - 4 / 30.0) < 1e-4)


def acts(t, editor, by):
    """The same, whoever computes. @return pictures on the way"""
    computes = lambda s: s["surface_on"] == by
    editor.wait_until("the surface by the " + by, computes)
    fifth_frame(editor)
    pictures = {"paused": shown(editor)}
    editor.select_muscle("chest L")  # Brings it into the picture.
    editor.tap("r", "its handles", lambda s: s["gizmo"]["mode"] == "scale")
    pictures["near"] = shown(editor)
    editor.type_number("inspector/radius.x", "0.25")
    editor.wait_until("a larger muscle", lambda s: s["document"]["undo"] == 1)
    pictures["edited"] = shown(editor)
    t.check("the edit shows", differing(pictures["edited"], pictures["near"]) > 0.05)
    editor.tap("space", "the clip to play", lambda s: s["playing"])
    x, y = editor.widget("inspector/radius.x")
    editor.drag((x, y), (x + 40, y))
    editor.wait_until("a pull to be a step", lambda s: s["document"]["undo"] == 2)
    moving = editor.next_frames(4)
    t.check("drawn by the %s while it plays and is pulled" % by, all(computes(s) for s in moving))
    t.check("the body moves", moving[0]["bones"] != moving[-1]["bones"])
    editor.taps("ctrl+z", "ctrl+z")
    editor.wait_until("all undone", lambda s: s["document"]["undo"] == 0)
    fifth_frame(editor)
    pictures["undone"] = shown(editor)
    t.check("all undone, the picture is that of before", differing(pictures["undone"], pictures["near"]) < 0.001)
    picks(editor)
    t.check_equal("nothing was said", editor.state()["messages"], [])
    return pictures


def picks(editor):
    """With the muscle tool the pointer finds the skin: the processor's surface is asked for."""
    x, y, width, height = editor.state()["viewport"]
    editor.tap("m", "the muscle tool", lambda s: "muscle" in s["tool"])
    editor.move((x + 0.5 * width, y + 0.5 * height))
    editor.wait_until("the chest under the pointer", lambda s: "adds a muscle on chest" in s["status"])


def same_pictures(t, rig):
    pictures = {}
    for by in ("processor", "card"):
        shutil.rmtree(t.folder / "state", ignore_errors=True)  # Where the eye was.
        t.prefer(picture={"surface": by, "moving": "full"})
        editor = t.edit(rig)
        pictures[by] = acts(t, editor, by)
        t.check_equal("quits", editor.quit(), 0)
    for name, picture in pictures["processor"].items():
        fraction = differing(picture, pictures["card"][name])
        t.check("%s: the same picture" % name, fraction < 0.005, fraction)


def broken_shader(t, rig):
    """The processor takes over, with one message."""
    folder = t.folder / "data" / "shaders" / "compute"
    folder.mkdir(parents=True)
    (folder / "skin.comp").write_text("#version 450\nno shader\n")
    t.environment["SINEW_DATA_DIR"] = str(t.folder / "data")
    editor = t.edit(rig)
    editor.wait_until("a message", lambda s: s["messages"])
    editor.next_frames(3)
    state = editor.state()
    t.check("one message says so", len(state["messages"]) == 1 and "computed by the processor" in state["messages"][0],
            state["messages"])
    t.check("the processor draws", state["surface_on"] == "processor" and state["triangles"] > 0)
    t.check_equal("quits", editor.quit(), 0)


def story(t):
    t.environment.pop("SINEW_DATA_DIR", None)
    t.copy(t.assets / "demo.glb")
    rig = t.copy(t.assets / "demo.rig.json")
    same_pictures(t, rig)
    broken_shader(t, rig)


if __name__ == "__main__":
    sys.exit(driver.run("on_card", story))
