# examples/python/batch.py: every rig and character of a folder: a surface each, and a table.
"""batch.py FOLDER OUT: OUT/NAME.ply is the middle of the first clip; OUT/table.csv has a line for each. What cannot be read
has a line too, and the exit status is 3."""
import csv
import pathlib
import sys
import time

import sinew

ENDINGS = (".rig.json", ".glb", ".gltf", ".vrm")
COLUMNS = ("file", "muscles", "clip", "vertices", "triangles", "milliseconds", "refused")


def rig_of(path):
    return sinew.load_rig(path) if path.name.endswith(".json") else sinew.Rig(sinew.load(path))


def surface_of(path, out):
    """The row of the table."""
    rig = rig_of(path)
    smoother = sinew.Smoother(rig.character, rig)
    clip = next(iter(rig.character.clips), None)
    moment = rig.character.clips[clip] / 2 if clip else 0.0
    smoother(clip=clip, time=moment)  # The first one takes memory.
    began = time.perf_counter()
    surface = smoother(clip=clip, time=moment)
    took = time.perf_counter() - began
    surface.save(out / (path.name + ".ply"))
    return {"file": path.name, "muscles": len(rig), "clip": clip or "", "vertices": len(surface.positions),
            "triangles": len(surface.triangles), "milliseconds": "%.1f" % (1000 * took)}


def main(folder, out):
    out = pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    paths = sorted(path for path in pathlib.Path(folder).iterdir() if path.name.lower().endswith(ENDINGS))
    refused = 0
    with open(out / "table.csv", "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, restval="")
        table.writeheader()
        for path in paths:
            try:
                row = surface_of(path, out)
            except sinew.Error as error:
                refused += 1
                row = {"file": path.name, "refused": str(error)}
                print(error, file=sys.stderr)
            table.writerow(row)
    print("%s: %d files, %d refused" % (out / "table.csv", len(paths), refused))
    return 3 if refused else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
