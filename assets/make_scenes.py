#!/usr/bin/env python3
# assets/make_scenes.py: makes the trial scenes, wrapped and tangle (.glb and .rig.json), from nothing but this code.
"""Usage: make_scenes.py [FOLDER]     (default: the folder of this script)

Standard library only. The same code writes the same bytes, so the files in the project can be checked against it.
"""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from maker import plain_glb, tangle, wrapped  # noqa: E402


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    for name, maker in (("wrapped", wrapped), ("tangle", tangle)):
        (folder / (name + ".glb")).write_bytes(plain_glb.pack(maker.scene()))
        (folder / (name + ".rig.json")).write_text(maker.rig(), encoding="utf-8")


if __name__ == "__main__":
    main()
