# tests/gui/arrival.py: a character whose alpha would hide all of it is shown, with a message; vertex colors are drawn.
import base64
import json
import struct
import subprocess
import sys

import driver

# A post, 1 x 2 x 1: its corners, and its sides as pairs of triangles.
CORNERS = [(x, y, z) for y in (0.0, 2.0) for x, z in ((-0.5, 0.5), (0.5, 0.5), (0.5, -0.5), (-0.5, -0.5))]
SIDES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (3, 2, 1, 0), (4, 5, 6, 7)]
TOLD = "would hide the whole character; shown opaque"


def post(folder, name, material, colors=None):
    """The post as a .gltf of one file; colors: bytes, RGBA for each corner."""
    indices = [i for a, b, c, d in SIDES for i in (a, b, c, a, c, d)]
    parts = [struct.pack("<24f", *(c for corner in CORNERS for c in corner)), struct.pack("<36H", *indices)]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [-0.5, 0, -0.5],
                  "max": [0.5, 2, 0.5]},
                 {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}]
    attributes = {"POSITION": 0}
    if colors is not None:
        parts.append(bytes(colors))
        accessors.append({"bufferView": 2, "componentType": 5121, "normalized": True, "count": 8, "type": "VEC4"})
        attributes["COLOR_0"] = 2
    data = b"".join(parts)
    views, begin = [], 0
    for part in parts:
        views.append({"buffer": 0, "byteOffset": begin, "byteLength": len(part)})
        begin += len(part)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    path = folder / name
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "post", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": attributes, "indices": 1, "material": 0}]}],
        "materials": [dict(material, name="skin")], "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": uri}]}))
    return path


class Picture:
    """Part of the viewport on the screen: most of the post and the floor left of it and before it, no panel. Places and sizes are
    fractions of the viewport."""
    AREA = (0.12, 0.15, 0.56, 0.77)  # Left, top, width, height.

    def __init__(self, editor):
        self.file = editor.scenario.folder / "screen.png"
        editor.screenshot(self.file)
        x, y, width, height = editor.state()["viewport"]
        left, top, wide, high = self.AREA
        self.size = (int(wide * width), int(high * height))
        crop = "%dx%d+%d+%d" % (*self.size, x + left * width, y + top * height)
        self.bytes = subprocess.run(["convert", str(self.file), "-crop", crop, "-depth", "8", "rgb:-"], check=True,
                                    capture_output=True).stdout

    def pixel(self, across, down):
        left, top, wide, high = self.AREA
        x, y = int((across - left) / wide * self.size[0]), int((down - top) / high * self.size[1])
        return tuple(self.bytes[3 * (y * self.size[0] + x):][:3])


def opened(t, file):
    """An editor that has drawn the file, and what it says of it."""
    editor = t.edit(file)
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0)
    return editor, state["messages"]


SAMPLES = 16  # Of a picture at rest.


def still(editor):
    """The picture at rest, without the messages over it."""
    if "messages/hide" in editor.state()["widgets"]:
        editor.click("messages/hide")
        editor.wait_until("no messages", lambda s: "messages/hide" not in s["widgets"])
    editor.taps("Home")  # Framed beside the message, it stood elsewhere.
    editor.settle()
    editor.wait_until("all samples", lambda s: s["samples"] == SAMPLES)
    return Picture(editor)


def closed(t, editor):
    t.check_equal("quits without a question", editor.quit(), 0)


def hidden(t, plain):
    for mode in ("MASK", "BLEND"):
        file = post(t.folder, "hidden.gltf", {"alphaMode": mode, "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0]}})
        editor, messages = opened(t, file)
        t.check("%s: the message names the material" % mode,
                any(TOLD in message and '"skin"' in message for message in messages), messages)
        picture = still(editor)
        t.check("%s: body and shadow are drawn as of an opaque one" % mode, picture.bytes == plain.bytes,
                "%d bytes differ, the middle is %r, expected %r" % (
                    sum(a != b for a, b in zip(picture.bytes, plain.bytes)), picture.pixel(0.5, 0.5), plain.pixel(0.5, 0.5)))
        closed(t, editor)
        told = t.run_program("inspect", file)
        t.check("%s: the command line says it too" % mode, told.returncode == 0 and TOLD in told.stdout, told.stdout)


def painted(t, plain):
    """Red below, blue above, alpha 0 in a material that blends: both faults at once."""
    colors = [channel for corner in CORNERS for channel in ((255, 0, 0, 0) if corner[1] == 0.0 else (0, 0, 255, 0))]
    file = post(t.folder, "painted.gltf", {"alphaMode": "BLEND"}, colors)
    editor, messages = opened(t, file)
    t.check("vertex colors: their alpha is told", any(TOLD in message for message in messages), messages)
    t.check("vertex colours are not among what is ignored", not any("vertex colour" in m for m in messages), messages)
    told = t.run_program("inspect", file).stdout
    t.check("the command line counts them", "colours     at 8 of the wedges" in told, told)
    picture = still(editor)
    low, high = picture.pixel(0.5, 0.8), picture.pixel(0.5, 0.25)
    t.check("red below", low[0] > 1.4 * max(low[1], low[2]) and low[0] > low[2] + 40, (low, plain.pixel(0.5, 0.8)))
    t.check("blue above", high[2] > 1.4 * max(high[0], high[1]) and high[2] > high[0] + 40, (high, plain.pixel(0.5, 0.25)))
    closed(t, editor)


def story(t):
    editor, messages = opened(t, post(t.folder, "plain.gltf", {}))
    t.check("an opaque post has nothing told about its alpha", not any(TOLD in message for message in messages), messages)
    plain = still(editor)
    t.check("the post is in the picture", max(plain.pixel(0.5, 0.5)) > max(plain.pixel(0.15, 0.2)) + 30,
            (plain.pixel(0.5, 0.5), plain.pixel(0.15, 0.2)))
    closed(t, editor)
    hidden(t, plain)
    painted(t, plain)


if __name__ == "__main__":
    sys.exit(driver.run("arrival", story))
