#!/usr/bin/env python3
# assets/make_horse.py: makes the bundled horse, horse.glb and its three rigs, from nothing but this code.
"""Usage: make_horse.py [FOLDER] [--texture-rows N]     (default: the folder of this script)

Standard library only. The same code writes the same bytes, so the files in the project can be checked against it.
"""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from maker import arguments, bake, glb  # noqa: E402
from maker.horse import body, flex, motion, muscles, paint, skeleton, volumes  # noqa: E402


def main():
    told = arguments.parse(HERE)
    folder = told.folder
    cage = body.build()
    image = bake.bake(cage, paint.colour, paint.GROUND, paint.SIZE, every=told.texture_rows)
    clips = [motion.walk(), motion.gallop()]
    packed = glb.pack("horse", "Sinew assets/make_horse.py", cage.mirrored(), skeleton, image, paint.SIZE, clips)
    (folder / "horse.glb").write_bytes(packed)
    (folder / "horse.rig.json").write_text(muscles.rig(), encoding="utf-8")
    (folder / "horse-flex.rig.json").write_text(flex.rig(), encoding="utf-8")
    (folder / "horse-wrapped.rig.json").write_text(volumes.rig(), encoding="utf-8")


if __name__ == "__main__":
    main()
