#!/usr/bin/env python3
# assets/make_humanoid.py: makes the bundled humanoid, humanoid.glb and its three rigs, from nothing but this code.
"""Usage: make_humanoid.py [FOLDER] [--texture-rows N]     (default: the folder of this script)

Standard library only. The same code writes the same bytes, so the files in the project can be checked against it.
"""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from maker import arguments, bake, glb  # noqa: E402
from maker.humanoid import body, motion, muscles, paint, skeleton  # noqa: E402


def main():
    told = arguments.parse(HERE)
    folder = told.folder
    cage = body.build()
    mesh = cage.mirrored()
    image = bake.bake(cage, paint.colour, paint.SKIN, paint.SIZE, mesh.normals(), every=told.texture_rows)
    packed = glb.pack("humanoid", "Sinew assets/make_humanoid.py", mesh, skeleton, image, paint.SIZE, motion.clips())
    (folder / "humanoid.glb").write_bytes(packed)
    (folder / "humanoid.rig.json").write_text(muscles.swell_rig(mesh), encoding="utf-8")
    (folder / "humanoid-flex.rig.json").write_text(muscles.flex_rig(mesh), encoding="utf-8")
    (folder / "humanoid-wrapped.rig.json").write_text(muscles.wrapped_rig(), encoding="utf-8")


if __name__ == "__main__":
    main()
