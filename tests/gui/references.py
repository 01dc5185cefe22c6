# tests/gui/references.py: a character that opens beside the tools, pictures to work after behind it, a turntable from the menu.
import json
import subprocess
import sys

import driver


def covers(state):
    """Rectangles of what lies over the picture."""
    begins = ("toolstrip/", "display/", "overlay/", "messages/", "legend/", "view/flex")
    return [box for name, box in state["widgets"].items() if name.startswith(begins)]


def opens_beside_the_tools(t, editor):
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0 and "foot.L" in s["bones"])
    over = [(name, box) for name, place in state["bones"].items() for box in covers(state)
            if box[0] <= place[0] <= box[0] + box[2] and box[1] <= place[1] <= box[1] + box[3]]
    t.check("no joint lies under a tool or a bar", not over, over)


def color_at(t, editor, place):
    """Of the screen, mean of a few pixels: red, green, blue."""
    editor.screenshot(t.out / "references.png")
    done = subprocess.run(["convert", str(t.out / "references.png"), "-crop", "9x9+%d+%d" % (round(place[0]) - 4, round(place[1]) - 4),
                           "+repage", "-resize", "1x1!", "-depth", "8", "rgb:-"], capture_output=True, check=True)
    return tuple(done.stdout[:3])


def is_red(color):
    return color[0] > 150 and color[1] < 90 and color[2] < 90


def beside_the_head(state):
    """A place in the picture where nothing of the body is: left of the head by its distance from the chest."""
    head, chest = state["bones"]["head"], state["bones"]["chest"]
    return head[0] - 2.5 * abs(head[1] - chest[1]), head[1]


def a_picture_behind(t, editor):
    subprocess.run(["convert", "-size", "60x60", "xc:#ff0000", str(t.folder / "front.png")], check=True)
    editor.click("menu/view")
    editor.click("view/reference")
    editor.click("reference/side/front")
    editor.wait_until("the view from the front", lambda s: not s["camera_moving"] and abs(s["camera"]["yaw"]) < 0.01)
    editor.click("reference/file")
    editor.wait_until("the dialog", lambda s: s["dialog"] == "open" and "dialog/path" in s["widgets"])
    editor.fill("dialog/path", str(t.folder / "front.png"))
    editor.wait_until("the rows of the picture", lambda s: s["dialog"] == "" and "reference/opacity" in s["widgets"])
    editor.type_number("reference/opacity", "100")
    editor.type_number("reference/scale", "120")
    state = editor.wait_until("all samples", lambda s: s["samples"] == 16)
    place = beside_the_head(state)
    t.check("it is seen beside the body", is_red(color_at(t, editor, place)), color_at(t, editor, place))
    chest = state["bones"]["chest"]
    t.check("the body stands before it", not is_red(color_at(t, editor, chest)))
    t.check_equal("no step of the history", state["document"]["undo"], 0)
    editor.tap("F12", "a picture to be saved", lambda s: s["toast"].startswith("Picture saved as"))
    saved = sorted((t.folder / "Pictures").glob("*.png"))[-1]
    corner = (round(place[0] - state["viewport"][0]), round(place[1] - state["viewport"][1]))
    done = subprocess.run(["convert", str(saved), "-crop", "1x1+%d+%d" % corner, "-depth", "8", "rgb:-"], capture_output=True, check=True)
    t.check("it is not in what is saved", not is_red(tuple(done.stdout[:3])), tuple(done.stdout[:3]))


def comes_back(t, file):
    editor = t.edit(file)
    state = editor.wait_until("the character again", lambda s: s["triangles"] > 0 and s["samples"] == 16)
    place = beside_the_head(state)
    t.check("the picture comes back with the view", is_red(color_at(t, editor, place)), color_at(t, editor, place))
    return editor


def a_turntable(t, editor, file):
    editor.click("menu/file")
    editor.point_at(lambda: editor.widget("file/export"))
    editor.click("file/export-pictures")
    editor.wait_until("its dialog", lambda s: s["dialog"] == "pictures" and "pictures/ok" in s["widgets"])
    for field, number in (("turns", 4), ("width", 80), ("height", 64)):
        editor.type_number("pictures/" + field, str(number))
    editor.click("pictures/ok")
    editor.wait_until("the file to be said", lambda s: not s["exports"] and s["toast"].startswith("Saved"))
    made = (file.parent / "demo_turntable.webp").read_bytes()
    t.check("it is a moving WebP", made[:4] == b"RIFF" and made[8:12] == b"WEBP" and made.count(b"ANMF") == 4)


def cancels(t, editor, file):
    editor.palette("turntable", "file/export-pictures")
    editor.wait_until("its dialog", lambda s: s["dialog"] == "pictures" and "pictures/turns" in s["widgets"])
    editor.type_number("pictures/turns", "700")
    editor.fill("pictures/place", "long.webp")  # Enter is the button.
    editor.wait_until("it to be under way", lambda s: s["exports"] and s["exports"][0]["running"])
    editor.click("status/export-cancel")
    editor.wait_until("it to end", lambda s: not s["exports"] and "long.webp was not written" in s["toast"])
    t.check("no file is left", not (file.parent / "long.webp").exists())


def story(t):
    if driver.shutil.which("convert") is None:
        raise driver.Skip("pictures cannot be compared here without convert")
    (t.folder / "Pictures").mkdir()
    t.copy(t.assets / "demo.glb")
    file = t.copy(t.assets / "demo.rig.json")
    editor = t.edit(file)
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0)
    if state["playing"]:
        editor.tap("space", "the clip to stop", lambda s: not s["playing"])
    editor.choose_clip(-1, "")
    opens_beside_the_tools(t, editor)
    a_picture_behind(t, editor)
    t.check_equal("quits without a question", editor.quit(), 0)
    views = list((t.folder / "state" / "sinew" / "views").glob("*.json"))
    kept = json.loads(views[0].read_text())["view"]["references"]
    t.check_equal("it is remembered beside the views", [(k["side"], k["file"]) for k in kept], [("front", str(t.folder / "front.png"))])
    editor = comes_back(t, file)
    a_turntable(t, editor, file)
    cancels(t, editor, file)
    t.check_equal("quits", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("references", story))
