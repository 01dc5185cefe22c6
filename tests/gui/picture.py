# tests/gui/picture.py: the picture at rest: smooth, asleep, as chosen; and saved to files.
import subprocess
import sys
import time

import driver

SAMPLES = 16


def gray(path, crop=None):
    """Rows of gray values of a picture, or of a part of it (x, y, width, height)."""
    part = ["-crop", "%dx%d+%d+%d" % (crop[2], crop[3], crop[0], crop[1]), "+repage"] if crop else []
    done = subprocess.run(["convert", str(path), *part, "-colorspace", "Gray", "-depth", "8", "pgm:-"],
                          capture_output=True, check=True)
    head, size, _, pixels = done.stdout.split(b"\n", 3)
    assert head == b"P5"
    width, height = map(int, size.split())
    return [pixels[y * width:(y + 1) * width] for y in range(height)]


def softness(rows):
    """Of all strong steps from one pixel to the next but one, the part that has a value between them."""
    steps = soft = 0
    for row in rows:
        for a, b, c in zip(row, row[1:], row[2:]):
            if abs(a - c) < 60:
                continue
            steps += 1
            soft += min(a, c) + 10 < b < max(a, c) - 10
    return soft / max(steps, 1), steps


def middle(state):
    """The part of the picture over which nothing lies, for a screenshot."""
    x, y, width, height = state["viewport"]
    return round(x + 0.25 * width), round(y + 0.15 * height), round(0.5 * width), round(0.7 * height)


def choose(editor, submenu, item, holds):
    editor.click("menu/view")
    editor.click(submenu)
    editor.click(item)
    return editor.wait_until(item, lambda s: holds(s["display"]))


def at_rest(editor):
    return editor.wait_until("all samples", lambda s: s["samples"] == SAMPLES)


def smooth_at_rest(t, editor):
    choose(editor, "view/background", "view/background-dark", lambda d: d["background"] == "dark")
    editor.tap("0", "no ground", lambda s: not s["display"]["ground"])
    editor.tap("2", "clay", lambda s: s["display"]["shading"] == "clay")
    state = editor.state()
    if not state["playing"]:
        state = editor.tap("space", "the clip to play", lambda s: s["playing"])
    moving = editor.next_frames(5)
    t.check_equal("one sample while it plays", {s["samples"] for s in moving}, {1})
    t.check_equal("at full resolution, as the preferences say", {s["picture_scale"] for s in moving}, {1})
    editor.screenshot(t.out / "picture_moving.png")
    moving, steps = softness(gray(t.out / "picture_moving.png", middle(state)))
    editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    state = at_rest(editor)
    editor.screenshot(t.out / "picture_resting.png")
    resting, steps_at_rest = softness(gray(t.out / "picture_resting.png", middle(state)))
    t.check("there are edges to look at", min(steps, steps_at_rest) > 100, (steps, steps_at_rest))
    t.check("edges at rest are smooth", resting > 0.35 and resting > 2.0 * moving, (moving, resting))


def asleep_at_rest(t, editor):
    editor.settle()
    before = at_rest(editor)
    time.sleep(2.5)  # Awake, it would draw dozens of frames.
    editor.settle()
    t.check("it slept", editor.state()["frame"] - before["frame"] < 12, (before["frame"], editor.state()["frame"]))


def moves_at_once(t, editor):
    state = at_rest(editor)
    x, y, width, height = state["viewport"]
    low = (x + 0.5 * width, y + height - 40)
    editor.move(low)
    editor.read_new()
    editor.press()
    for step in range(1, 6):
        editor.move((low[0] + 14 * step, low[1]))
    turning = [s for s in editor.read_new() if s["status"].startswith("Orbit")] or [editor.state()]
    t.check("a turn shows with single samples", turning[-1]["samples"] == 1, turning[-1]["samples"])
    editor.release()
    at_rest(editor)


def saved_pictures(t, editor):
    pictures = t.folder / "Pictures"
    pictures.mkdir(exist_ok=True)
    state = at_rest(editor)
    said = editor.tap("F12", "a note about the picture", lambda s: s["toast"].startswith("Picture saved as"))["toast"]
    saved = sorted(pictures.glob("*.png"))
    t.check_equal("one picture", len(saved), 1)
    t.check("the note says where", str(saved[0]) in said, said)
    editor.wait_until("the note to go by itself", lambda s: s["toast"] == "")
    whole = gray(saved[0])
    t.check_equal("as large as the view", (len(whole[0]), len(whole)), (round(state["viewport"][2]), round(state["viewport"][3])))
    resting, steps = softness(whole)
    t.check("with samples", steps > 100 and resting > 0.35, (steps, resting))
    # What is shown and what is saved are the same where nothing lies over the picture.
    state = at_rest(editor)
    editor.screenshot(t.out / "picture_shown.png")
    x, y, width, height = middle(state)
    shown = gray(t.out / "picture_shown.png", (x, y, width, height))
    left, top = round(x - state["viewport"][0]), round(y - state["viewport"][1])
    differences = [abs(a - b) for row, line in zip(shown, whole[top:top + height]) for a, b in zip(row, line[left:left + width])]
    t.check("as it is shown", sum(differences) / len(differences) < 0.5, sum(differences) / len(differences))
    editor.click("menu/file")
    editor.click("file/save-picture")
    editor.wait_until("the dialog", lambda s: s["dialog"] == "picture")
    editor.fill("dialog/path", str(t.folder / "named"))
    editor.wait_until("the dialog to close", lambda s: s["dialog"] == "")
    driver.wait_for("the named picture", lambda: (t.folder / "named.png").exists())
    t.check_equal("the same picture", gray(t.folder / "named.png"), whole)


def choices_last(t, editor, file):
    choose(editor, "view/light", "view/light-rim", lambda d: d["light"] == "rim")
    editor.click("menu/view")
    editor.click("view/occlusion")
    editor.wait_until("occlusion", lambda s: s["display"]["ao"])
    at_rest(editor)
    t.check_equal("quits without a question", editor.quit(), 0)
    again = t.edit(file)
    seen = again.wait_until("a character", lambda s: s["triangles"] > 0)["display"]
    t.check_equal("light, background and occlusion are remembered", (seen["light"], seen["background"], seen["ao"]),
                  ("rim", "dark", True))
    kept = list((t.folder / "cache" / "sinew" / "thumbnails").glob("*.png"))
    t.check_equal("one thumbnail is kept", len(kept), 1)
    kept[0].write_bytes(b"garbage")
    again.tap("ctrl+o", "the dialog", lambda s: "dialog/entry/" + file.name in s["widgets"])
    again.settle()
    again.tap("Escape", "the dialog to close", lambda s: s["dialog"] == "")
    t.check_equal("a damaged thumbnail does no harm", again.quit(), 0)


def story(t):
    if driver.shutil.which("convert") is None:
        raise driver.Skip("pictures cannot be compared here without convert")
    t.copy(t.assets / "demo.glb")
    file = t.copy(t.assets / "demo.rig.json")
    # A moving picture of few pixels is soft by itself: here the samples alone are to make it so.
    preferences = t.folder / "config" / "sinew" / "preferences.json"
    preferences.parent.mkdir(parents=True)
    preferences.write_text('{ "format": "sinew-preferences", "picture": { "moving": "full" } }')
    editor = t.edit(file)
    editor.wait_until("a character", lambda s: s["triangles"] > 0)
    smooth_at_rest(t, editor)
    asleep_at_rest(t, editor)
    moves_at_once(t, editor)
    saved_pictures(t, editor)
    choices_last(t, editor, file)


if __name__ == "__main__":
    sys.exit(driver.run("picture", story))
