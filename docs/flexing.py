#!/usr/bin/env python3
# docs/flexing.py: makes docs/images/flexing-*.png: muscles on their bones, the same on lines, and those under glass.
# Usage: docs/flexing.py [SINEW] [--out FOLDER] [--sheet NAME ...]     SINEW: the program; without it, the newest one
# under build/. Without --sheet the docs' sheets, into docs/images. Needs imagemagick.
import argparse
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
ASSETS = ROOT / "assets"
DIAGONAL = math.sqrt(0.5)
# Across the arm, which hangs at 45 degrees in the bind pose, and across the shin: bone, axis, degrees, a frame each.
HINGES = {"arm": ("forearm.L", (-DIAGONAL, -DIAGONAL, 0.0)), "knee": ("shin.L", (1.0, 0.0, 0.0))}
MOST = 140
# Character, clip, times, view, size of the picture, part of it, width in the sheet.
SHEETS = {
    "arm": ("humanoid", "Hinge", (0, 35, 70, 105, 135), "90,45", 1000, "300x350+345+325", 200),
    "knee": ("humanoid", "Hinge", (0, 35, 70, 105, 130), "90,5", 800, "240x440+286+320", 160),
    "gallop": ("horse", "Gallop", (0.0, 0.135, 0.27, 0.405), "left", 700, "620x400+40+140", 250),
}
GREY = "#34363b"
IN_DOCS = ("arm", "gallop")
ROWS = (("", ()), ("-flex", ()), ("-flex", ("--show", "muscles", "--samples", "16")))


def hinged(source, bone, axis):
    """The .glb with one more clip, in which one bone turns about an axis of the bind pose: a degree a second."""
    size = struct.unpack_from("<I", source, 12)[0]
    document, data = json.loads(source[20:20 + size]), bytearray(source[28 + size:])
    angles = [math.radians(degrees) for degrees in range(MOST + 1)]
    turns = [[c * math.sin(a / 2.0) for c in axis] + [math.cos(a / 2.0)] for a in angles]
    for kind, rows in (("SCALAR", [[float(t)] for t in range(MOST + 1)]), ("VEC4", turns)):
        raw = b"".join(struct.pack("<%df" % len(row), *row) for row in rows)
        data += bytes(-len(data) % 4)
        accessor = {"bufferView": len(document["bufferViews"]), "componentType": 5126, "count": len(rows), "type": kind}
        if kind == "SCALAR":
            accessor.update(min=[0.0], max=[float(MOST)])
        document["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(raw)})
        document["accessors"].append(accessor)
        data += raw
    times = len(document["accessors"]) - 2
    node = next(i for i, n in enumerate(document["nodes"]) if n.get("name") == bone)
    document["animations"].append({
        "name": "Hinge", "samplers": [{"input": times, "output": times + 1}],
        "channels": [{"sampler": 0, "target": {"node": node, "path": "rotation"}}]})
    document["buffers"][0]["byteLength"] = len(data)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(data)) + struct.pack("<II", len(text), 0x4E4F534A) +
            text + struct.pack("<II", len(data), 0x004E4942) + bytes(data))


def character_of(sheet, folder):
    name = SHEETS[sheet][0]
    if sheet not in HINGES:
        return ASSETS / (name + ".glb")
    path = folder / (sheet + ".glb")
    path.write_bytes(hinged((ASSETS / (name + ".glb")).read_bytes(), *HINGES[sheet]))
    return path


def rig_of(sheet, suffix, character, folder):
    rig = json.loads((ASSETS / (SHEETS[sheet][0] + suffix + ".rig.json")).read_text())
    rig["character"] = str(character)
    path = folder / (sheet + suffix + ".rig.json")
    path.write_text(json.dumps(rig))
    return path


def convert(*arguments):
    subprocess.run(["convert", *arguments], check=True)


def make(sheet, program, folder, out):
    _, clip, times, view, size, part, width = SHEETS[sheet]
    character, pictures = character_of(sheet, folder), []
    for row, (suffix, options) in enumerate(ROWS):
        rig = rig_of(sheet, suffix, character, folder)
        for time in times:
            picture = folder / ("%s-%d-%g.png" % (sheet, row, time))
            subprocess.run([program, "render", rig, "--clip", clip, "--time", str(time), "--view", view, "--size",
                            "%dx%d" % (size, size), "--depth", "5", "--shading", "clay", "--no-ground", "--transparent",
                            *options, "-o", picture], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            convert(picture, "-background", GREY, "-flatten", "-crop", part, "+repage", picture)
            pictures.append(picture)
    finished = out / ("flexing-%s.png" % sheet)
    subprocess.run(["montage", *pictures, "-tile", "%dx" % len(times), "-geometry", "%dx+1+1" % width,
                    "-background", GREY, folder / "sheet.png"], check=True)
    convert(folder / "sheet.png", "+dither", "-colors", "256", "-strip", "-define", "png:compression-level=9",
            "-define", "png:exclude-chunks=date,time", "png8:%s" % finished)
    print(finished)


def newest_program():
    built = sorted(ROOT.glob("build/*/app/sinew"), key=lambda path: path.stat().st_mtime)
    if not built:
        sys.exit("flexing.py: no program: build it, or name it")
    return built[-1]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", metavar="SINEW", nargs="?", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs" / "images")
    parser.add_argument("--sheet", action="append", choices=SHEETS)
    told = parser.parse_args()
    program = told.program.resolve() if told.program else newest_program()
    with tempfile.TemporaryDirectory() as folder:
        for sheet in told.sheet or IN_DOCS:
            make(sheet, program, pathlib.Path(folder), told.out)


if __name__ == "__main__":
    main()
