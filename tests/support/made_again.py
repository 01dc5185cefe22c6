# tests/support/made_again.py: whether a bundled character is what its script makes now, the texture by some of its rows.
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

from glb_reader import Glb

EVERY = 16  # A whole texture takes the scripts half a minute.


def _image(glb):
    """(view, PNG bytes) of the only image."""
    view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"]]
    start = view.get("byteOffset", 0)
    return view, glb.data[start:start + view["byteLength"]]


def _rows(png):
    """Rows of bytes of an RGB image of which every row is stored as differences to the pixel on the left."""
    at, packed, width = 8, b"", 0
    while at < len(png):
        size, kind = struct.unpack_from(">I4s", png, at)
        data = png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width = struct.unpack_from(">I", data)[0]
        if kind == b"IDAT":
            packed += data
        at += 12 + size
    raw, stride = zlib.decompress(packed), 1 + 3 * width
    for start in range(0, len(raw), stride):
        assert raw[start] == 1
        row = bytearray(raw[start + 1:start + stride])
        for i in range(3, len(row)):
            row[i] = (row[i] + row[i - 3]) & 255
        yield bytes(row)


def _all_but_image(glb):
    """What it says and holds beside the image, which lies at the end."""
    view, png = _image(glb)
    start = view.get("byteOffset", 0)
    assert start + len(png) + 3 >= len(glb.data), "the image lies at the end"
    said = json.loads(json.dumps(glb.json))
    said["bufferViews"][glb.json["images"][0]["bufferView"]]["byteLength"] = 0
    said["buffers"][0]["byteLength"] = 0
    return said, glb.data[:start]


def check(case, script, character, rigs):
    """For a unittest.TestCase: runs the script and compares with the files beside it."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, script, folder, "--texture-rows", str(EVERY)], check=True)
        for name in rigs:
            case.assertEqual((script.parent / name).read_bytes(), (pathlib.Path(folder) / name).read_bytes(), name)
        bundled, made = Glb(script.parent / character), Glb(pathlib.Path(folder) / character)
        case.assertEqual(_all_but_image(bundled), _all_but_image(made), character)
        seen = [list(_rows(_image(glb)[1])) for glb in (bundled, made)]
        case.assertEqual(len(seen[0]), len(seen[1]))
        for y in range(0, len(seen[0]), EVERY):
            case.assertEqual(seen[0][y], seen[1][y], "%s, row %d of the texture" % (character, y))
