#!/usr/bin/env python3
# assets/make_demo.py: makes the demo character, demo.glb and demo.rig.json, from nothing but this code.
"""Usage: make_demo.py [FOLDER] [--texture-rows N]     (default: the folder of this script)

Standard library only. The same code writes the same bytes, so the files in the project can be checked against it.
"""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from maker import arguments, bake, glb  # noqa: E402
from maker.lizard import body, motion, muscles, paint, skeleton  # noqa: E402


def main():
    told = arguments.parse(HERE)
    folder = told.folder
    cage = body.build()
    image = bake.bake(cage, paint.colour, paint.TEAL, paint.SIZE, every=told.texture_rows)
    clips = [motion.walk(), motion.idle()]
    packed = glb.pack("demo", "Sinew assets/make_demo.py", cage.mirrored(), skeleton, image, paint.SIZE, clips)
    (folder / "demo.glb").write_bytes(packed)
    (folder / "demo.rig.json").write_text(muscles.rig_text(), encoding="utf-8")


if __name__ == "__main__":
    main()
