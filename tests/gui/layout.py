# tests/gui/layout.py: a window made small and large again, large interfaces in small windows, numbers dragged and typed.
import json
import struct
import sys

import driver

SCREEN = (2560, 1600)
BARS = ("layout/left", "layout/right", "layout/bottom", "layout/history")
BONE = "Armature_Character_thigh.L_Twist_01"


def with_long_names(source, target):
    """A copy of a .glb whose nodes have names as exporters make them."""
    data = source.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    gltf = json.loads(data[20:20 + length])
    for node in gltf["nodes"]:
        node["name"] = "Armature_Character_%s_Twist_01" % node.get("name", "node")
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    head = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A)
    target.write_bytes(head + text + rest)
    return target


def resize(editor, width, height):
    window = editor.xdotool("search", "--onlyvisible", "--name", ".").split()[0]
    editor.xdotool("windowsize", window, width, height)

    def resized(state):
        bar = state["widgets"].get("layout/bottom", (0, 0, 0, 0))
        end = state["viewport"][1] + state["viewport"][3]
        return abs(bar[2] - width) < 2 and abs(end - bar[1]) < 2 and height - 400 < end < height - 60

    return editor.wait_until("a window of %d x %d" % (width, height), resized)


def bars(state):
    return {name: state["widgets"][name] for name in BARS}


def small_and_large_again(t, file):
    editor = t.edit(file)
    resize(editor, 1600, 1000)
    x, y = editor.widget("layout/left")
    editor.drag((x, y), (x + 130, y))
    x, y = editor.widget("layout/bottom")
    editor.drag((x, y), (x, y - 70))
    editor.settle()
    before = bars(editor.state())
    for width, height in ((820, 560), (700, 900)):
        small = resize(editor, width, height)
        t.check("a small window shows smaller panels", small["widgets"]["layout/left"][0] < before["layout/left"][0])
        outside = [name for name, box in small["widgets"].items() if box[0] + box[2] > width + 1 or box[1] + box[3] > height + 1]
        t.check("all of it lies in the window", not outside, outside)
    resize(editor, 1600, 1000)
    after = bars(editor.wait_until("the panels", lambda s: s["widgets"]["layout/right"] == before["layout/right"]))
    t.check_equal("as large as it was, it looks as it did", after, before)
    return editor


def behind_more(t, file, scale):
    editor = t.edit(file, "--scale", scale)
    resize(editor, 1280, 800)
    state = editor.settle()
    t.check("what fits is shown at scale %s" % scale, "display/textured" in state["widgets"] or scale == 2)
    more = state["widgets"]["display/more"]
    x, _, width, _ = state["viewport"]
    t.check("the rest is behind a button in the picture", more[0] >= x and more[0] + more[2] <= x + width, more)
    editor.click("display/more")
    editor.wait_until("the rest", lambda s: "display/wire" in s["widgets"])
    wire = editor.state()["display"]["wire"]
    editor.click("display/wire")
    editor.wait_until("edges to be switched", lambda s: s["display"]["wire"] != wire)
    editor.wait_until("the menu to close", lambda s: "display/wire" not in s["widgets"])
    editor.screenshot(t.out / ("layout_scale_%s.png" % scale))
    t.check_equal("quits", editor.quit(), 0)


def double_click(editor, field):
    editor.point_at(lambda: editor.widget(field))
    editor.xdotool("click", "--repeat", 2, "--delay", 60, driver.LEFT)


def numbers(t, editor):
    undo = editor.state()["document"]["undo"]
    double_click(editor, "smoothing/tolerance")
    editor.key("ctrl+a")
    editor.type("0.5")
    editor.tap("Return", "the typed tolerance to be one step",
               lambda s: abs(s["tolerance"] - 0.005) < 1e-6 and s["document"]["undo"] == undo + 1)
    editor.save_as(t.folder / "numbers.rig.json")
    tightness = lambda: editor.saved_rig().get("surface", {}).get("iso", 0.5)

    def dragged(pixels, along, held=None):
        """From its own place in the field: two presses on one place within a moment are a double click."""
        before = tightness()
        at = editor.widget("surface/iso", along)
        editor.move(at)
        editor.press()
        if held:
            editor.hold(held)
        for part in (0.5, 1.0):
            editor.move((at[0] + part * pixels, at[1]))
        editor.release()
        if held:
            editor.let_go(held)
        editor.settle()
        return tightness() - before

    plain = dragged(60, 0.4)
    t.check("a drag changes it", plain > 0.1, plain)
    precise = dragged(-60, 0.6, "shift")
    t.check("with Shift a tenth as far", 0.0 < -precise < 0.2 * plain, (plain, precise))
    dragged(-20, 0.5, "ctrl")
    value = tightness()
    t.check("with Ctrl in steps", abs(value / 0.05 - round(value / 0.05)) < 1e-3, value)


def story(t):
    file = with_long_names(t.assets / "humanoid.glb", t.folder / "long.glb")
    editor = small_and_large_again(t, file)
    editor.choose_clip(-1, "")
    editor.wait_until("long names", lambda s: BONE in s["bones"])
    numbers(t, editor)
    editor.screenshot(t.out / "layout.png")
    t.check_equal("quits", editor.quit(), 0)
    for scale in (1.5, 2):
        behind_more(t, file, scale)


if __name__ == "__main__":
    sys.exit(driver.run("layout", story, SCREEN))
