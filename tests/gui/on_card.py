# tests/gui/on_card.py: the surface by the graphics card shows what the processor's shows; and what happens where it cannot.
import json
import pathlib
import shutil
import subprocess
import sys

import driver

SAMPLES = 16
MOST = 2  # Of 255, in all but a two hundredth of the pixels.


def prefer(t, by):
    place = pathlib.Path(t.environment["XDG_CONFIG_HOME"]) / "sinew" / "preferences.json"
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(json.dumps({"format": "sinew-preferences", "version": 1,
                                 "picture": {"surface": by, "moving": "full"}}))


def shown(t, editor, name):
    """Bytes of the picture at rest, without what lies over it."""
    editor.move((640, 12))
    state = editor.wait_until("all samples", lambda s: s["samples"] == SAMPLES and not s["camera_moving"])
    file = t.out / ("on_card_%s.png" % name)
    editor.screenshot(file)
    x, y, width, height = state["viewport"]
    part = "%dx%d+%d+%d" % (0.5 * width, 0.6 * height, x + 0.25 * width, y + 0.2 * height)
    done = subprocess.run(["convert", str(file), "-crop", part, "+repage", "-depth", "8", "rgb:-"], capture_output=True,
                          check=True)
    return done.stdout


def differing(a, b):
    """Share of the pixels that differ by more than MOST."""
    assert len(a) == len(b) > 30000
    far = sum(any(abs(a[i + c] - b[i + c]) > MOST for c in range(3)) for i in range(0, len(a), 3))
    return 3.0 * far / len(a)


def story(t, editor, by):
    """The same acts, whoever computes. @return pictures on the way"""
    computes = lambda s: s["surface_on"] == by  # noqa: E731
    editor.wait_until("the surface by the " + by, computes)
    editor.choose_clip(0, "Walk")
    if editor.state()["playing"]:
        editor.tap("space", "a pause", lambda s: not s["playing"])
    editor.click("timeline/start")
    for frame in range(1, 5):
        editor.tap("period", "frame %d" % frame, lambda s: abs(s["clip_time"] - frame / 30.0) < 1e-4)
    pictures = {"paused": shown(t, editor, by + "_paused")}
    editor.click("outliner/muscle/chest L")
    editor.wait_until("a muscle", lambda s: s["document"]["selection"] == ["chest L"])
    editor.tap("f", "the muscle in the picture", lambda s: not s["camera_moving"])
    editor.wait_until("a camera at rest", lambda s: not s["camera_moving"])
    before = shown(t, editor, by + "_before")
    pictures["near"] = before
    editor.tap("r", "its handles", lambda s: s["gizmo"]["mode"] == "scale")
    editor.type_number("inspector/radius.x", "0.12")
    editor.wait_until("a larger muscle", lambda s: s["document"]["undo"] == 1)
    pictures["edited"] = shown(t, editor, by + "_edited")
    editor.tap("space", "the clip to play", lambda s: s["playing"])
    x, y = editor.widget("inspector/radius.x")
    editor.drag((x, y), (x + 40, y))
    editor.wait_until("a pull to be a step", lambda s: s["document"]["undo"] == 2)
    moving = editor.next_frames(4)
    t.check("drawn by the %s while it plays and is pulled" % by, all(computes(s) for s in moving))
    t.check("the body moves", moving[0]["bones"] != moving[-1]["bones"])
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["undo"] == 1)
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["undo"] == 0)
    editor.tap("space", "a pause", lambda s: not s["playing"])
    editor.click("timeline/start")
    for frame in range(1, 5):
        editor.tap("period", "frame %d" % frame, lambda s: abs(s["clip_time"] - frame / 30.0) < 1e-4)
    editor.tap("w", "the handles of before", lambda s: s["gizmo"]["mode"] == "move")
    pictures["undone"] = shown(t, editor, by + "_undone")
    t.check("all undone, the picture is that of before", differing(pictures["undone"], before) < 0.001)
    picks(editor)
    t.check("nothing was said", not editor.state()["messages"], editor.state()["messages"])
    return pictures


def picks(editor):
    """With the muscle tool the pointer finds the skin: the processor's surface is asked for."""
    x, y, width, height = editor.state()["viewport"]
    editor.tap("m", "the muscle tool", lambda s: "muscle" in s["tool"])
    editor.move((x + 0.5 * width, y + 0.5 * height))
    editor.wait_until("the chest under the pointer", lambda s: "grows on chest" in s["status"])
    editor.tap("w", "the handles", lambda s: s["gizmo"]["mode"] == "move")


def same_pictures(t):
    pictures = {}
    for by in ("processor", "card"):
        shutil.rmtree(t.folder / "state", ignore_errors=True)  # Where the eye was.
        prefer(t, by)
        rig = t.copy(t.assets / "demo.rig.json")
        t.copy(t.assets / "demo.glb")
        editor = t.edit(rig)
        pictures[by] = story(t, editor, by)
        if by == "card":
            changes_its_mind(t, editor)
        t.check_equal("quits", editor.quit(), 0)
    for name, picture in pictures["processor"].items():
        share = differing(picture, pictures["card"][name])
        t.check("%s: the same picture" % name, share < 0.005, share)
    t.check("the edit shows", differing(pictures["card"]["edited"], pictures["card"]["undone"]) > 0.005)


def changes_its_mind(t, editor):
    editor.click("menu/view")
    editor.click("view/cull")
    state = editor.wait_until("hidden sides left out", lambda s: s["surface_on"] == "processor" and s["culled"] > 0)
    t.check("without a word", not state["messages"], state["messages"])
    editor.click("menu/view")
    editor.click("view/cull")
    editor.wait_until("the card again", lambda s: s["surface_on"] == "card")
    editor.palette("surface computed by", "control/preferences/surface/automatic")
    editor.click("preferences/surface/automatic")
    editor.wait_until("the processor, which draws here too", lambda s: s["surface_on"] == "processor")
    editor.screenshot(t.out / "on_card_preferences.png")
    editor.click("preferences/surface/graphics card")
    editor.wait_until("the card again", lambda s: s["surface_on"] == "card")
    editor.click("preferences/close")
    editor.wait_until("the dialog to close", lambda s: s["dialog"] == "")


def broken_shader(t):
    """The processor takes over, one message."""
    folder = t.folder / "data" / "shaders" / "compute"
    folder.mkdir(parents=True)
    (folder / "skin.comp").write_text("#version 450\nno shader\n")
    t.environment["SINEW_DATA_DIR"] = str(t.folder / "data")
    prefer(t, "card")
    editor = t.edit(t.folder / "demo.rig.json")
    state = editor.wait_until("a message", lambda s: s["messages"])
    editor.next_frames(3)
    state = editor.state()
    t.check_equal("one message", len(state["messages"]), 1)
    t.check("which says so", "computed by the processor" in json.dumps(state["messages"]), state["messages"])
    t.check("the processor draws", state["surface_on"] == "processor" and state["triangles"] > 0)
    t.check_equal("quits", editor.quit(), 0)


def tell(t):
    t.environment.pop("SINEW_DATA_DIR", None)
    same_pictures(t)
    broken_shader(t)


if __name__ == "__main__":
    sys.exit(driver.run("on_card", tell))
