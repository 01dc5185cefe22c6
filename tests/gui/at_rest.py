# tests/gui/at_rest.py: nothing moves: the picture becomes smooth, the editor sleeps, hints come and go; pictures behind and saved.
import subprocess
import sys
import time

import driver

SAMPLES = 16


def gray(path):
    """Rows of gray values of a picture."""
    done = subprocess.run(["convert", str(path), "-depth", "8", "pgm:-"], capture_output=True, check=True)
    head, size, _, pixels = done.stdout.split(b"\n", 3)
    assert head == b"P5"
    width, height = map(int, size.split())
    return [pixels[y * width:(y + 1) * width] for y in range(height)]


def shown(editor, box):
    """The same of a part of the screen."""
    width = round(box[2])
    pixels = editor.pixels(box, "gray")
    return [pixels[i:i + width] for i in range(0, len(pixels), width)]


def softness(rows):
    """Of all strong steps from one pixel to the next but one, the fraction that has a value between them; and their number."""
    steps = soft = 0
    for row in rows:
        for a, b, c in zip(row, row[1:], row[2:]):
            if abs(a - c) < 60:
                continue
            steps += 1
            soft += min(a, c) + 10 < b < max(a, c) - 10
    return soft / max(steps, 1), steps


def middle(state):
    """The part of the picture over which nothing lies."""
    x, y, width, height = state["viewport"]
    return round(x + 0.25 * width), round(y + 0.15 * height), round(0.5 * width), round(0.7 * height)


def at_rest(editor):
    return editor.wait_until("all samples", lambda s: s["samples"] == SAMPLES and not s["camera_moving"])


def smooth_at_rest(t, editor):
    editor.palette("background dark", "view/background-dark")
    editor.tap("0", "no ground", lambda s: not s["display"]["ground"])
    state = editor.tap("2", "clay", lambda s: s["display"]["shading"] == "clay")
    moving = editor.next_frames(5)
    t.check_equal("one sample while it plays, at full resolution as the preferences say",
                  {(s["samples"], s["picture_scale"]) for s in moving}, {(1, 1)})
    moving, steps = softness(shown(editor, middle(state)))
    editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    resting, steps_at_rest = softness(shown(editor, middle(at_rest(editor))))
    t.check("there are edges to look at", min(steps, steps_at_rest) > 100, (steps, steps_at_rest))
    t.check("edges at rest are smooth", resting > 0.35 and resting > 2.0 * moving, (moving, resting))


def sleeps_until_the_mouse_moves(t, editor):
    editor.settle()
    before = at_rest(editor)
    time.sleep(1.5)  # Awake, it would draw dozens of frames.
    editor.settle()
    t.check("it slept", editor.state()["frame"] - before["frame"] < 12, (before["frame"], editor.state()["frame"]))
    x, y, width, height = at_rest(editor)["viewport"]
    low = (x + 0.5 * width, y + height - 40)
    editor.move(low)
    editor.read_new()
    editor.press()
    for step in range(1, 4):
        editor.move((low[0] + 14 * step, low[1]))
    turning = [s for s in editor.read_new() if s["status"].startswith("Orbit")] or [editor.state()]
    t.check_equal("a turn shows at once, with single samples", turning[-1]["samples"], 1)
    editor.release()
    at_rest(editor)


def tooltip_comes(editor, control):
    """Hovered, the picture beside the pointer changes by itself: no event comes, no clip plays."""
    editor.point_at(lambda: editor.widget(control))
    beside = (editor.mouse[0] + 14, editor.mouse[1] + 20, 60, 24)
    before = editor.pixels(beside)
    driver.wait_for("a tooltip of " + control, lambda: editor.pixels(beside) != before)


def hints(t, editor):
    tooltip_comes(editor, "toolstrip/axes")
    editor.click("menu/edit")
    tooltip_comes(editor, "edit/duplicate")
    editor.tap("Escape", "the menu to close", lambda s: "edit/duplicate" not in s["widgets"])
    said = editor.tap("ctrl+d", "a reason why nothing is copied", lambda s: s["toast"] != "")
    t.check("a key that can do nothing says why", "Select a muscle first" in said["toast"], said["toast"])
    editor.wait_until("the toast to go by itself", lambda s: s["toast"] == "" and "toast" not in s["widgets"])


def a_picture_to_work_after(t, editor):
    """Let go over the window; seen behind the body, and not in what is saved."""
    red = t.folder / "front.png"
    subprocess.run(["convert", "-size", "60x60", "xc:#ff0000", str(red)], check=True)
    editor.drop(red)
    editor.wait_until("its panel", lambda s: "reference/opacity" in s["widgets"])
    editor.click("reference/side/front")
    editor.type_number("reference/opacity", "100")
    editor.type_number("reference/scale", "120")
    editor.tap("Escape", "the panel to close", lambda s: "reference/opacity" not in s["widgets"])
    editor.settle()
    place = beside_the_head(editor)
    t.check("it is seen beside the head", is_red(editor.pixels(place)), editor.pixels(place))
    x, y = (round(a - b) for a, b in zip(place[:2], editor.state()["viewport"]))
    crop = ["convert", str(save_picture(t, editor)), "-crop", "1x1+%d+%d" % (x, y), "-depth", "8", "rgb:-"]
    saved = subprocess.run(crop, capture_output=True, check=True).stdout
    t.check("it is not in what is saved", len(saved) == 3 and not is_red(saved), saved)


def beside_the_head(editor):
    """A pixel left of the head by its distance from the chest: nothing of the body is there."""
    state = at_rest(editor)
    head, chest = state["bones"]["head"], state["bones"]["chest"]
    return round(head[0] - 2.5 * abs(head[1] - chest[1])), round(head[1]), 1, 1


def is_red(color):
    return color[0] > 150 and max(color[1:]) < 90


def save_picture(t, editor):
    pictures = t.folder / "Pictures"
    pictures.mkdir(exist_ok=True)
    before = set(pictures.iterdir())
    at_rest(editor)
    editor.key("F12")
    (saved,) = driver.wait_for("a picture", lambda: set(pictures.iterdir()) - before)
    editor.wait_until("a note that says where", lambda s: s["toast"] == "Picture saved as %s" % saved)
    return saved


def saved_picture(t, editor):
    whole = gray(save_picture(t, editor))
    state = at_rest(editor)
    t.check_equal("as large as the view", [len(whole[0]), len(whole)], [round(v) for v in state["viewport"][2:]])
    box = middle(state)
    left, top = round(box[0] - state["viewport"][0]), round(box[1] - state["viewport"][1])
    differences = [abs(a - b) for row, line in zip(shown(editor, box), whole[top:top + box[3]])
                   for a, b in zip(row, line[left:left + box[2]])]
    t.check("as it is shown", sum(differences) / len(differences) < 0.5, sum(differences) / len(differences))


def comes_back(t, editor, file):
    seen = at_rest(editor)["camera"]
    t.check_equal("quits without a question", editor.quit(), 0)
    again = t.edit(file)
    state = at_rest(again)
    t.check_equal("the background is remembered", state["display"]["background"], "dark")
    t.check("the view is as it was left", abs(state["camera"]["yaw"] - seen["yaw"]) < 1e-4, state["camera"])
    t.check("the picture behind comes back with it", is_red(again.pixels(beside_the_head(again))))
    t.check_equal("quits", again.quit(), 0)


def story(t):
    # A moving picture of few pixels is soft by itself: here the samples alone are to make it so.
    t.prefer(picture={"moving": "full"})
    t.copy(t.assets / "demo.glb")
    file = t.copy(t.assets / "demo.rig.json")
    editor = t.edit(file)
    editor.wait_until("a character that walks", lambda s: s["triangles"] > 0 and s["playing"])
    smooth_at_rest(t, editor)
    sleeps_until_the_mouse_moves(t, editor)
    hints(t, editor)
    saved_picture(t, editor)
    a_picture_to_work_after(t, editor)
    comes_back(t, editor, file)


if __name__ == "__main__":
    sys.exit(driver.run("at_rest", story))
