# python/sinew/__init__.py: muscles for animated characters, from Python. docs/python.md.
"""Muscles for animated characters.

    import sinew
    character = sinew.load("fox.glb")
    rig = sinew.Rig(character)
    rig.add_muscle("thigh L", bone="b_LeftLeg01_015", center=(0, 4.5, -1), radii=(6, 12, 7))
    surface = sinew.Smoother(character, rig)(clip="Walk", time=0.3)
    surface.positions, surface.normals, surface.triangles      # NumPy arrays, without a copy

Whatever cannot be is refused with sinew.Error, which has .file, .place and .reason.
"""
from ._character import Bone, Character, load
from ._error import Error
from ._export import export, export_baked
from ._muscle import Line, Muscle
from ._rig import Rig, load_rig
from ._sinew import Mesh
from ._sinew import version as __version__
from ._smoother import Smoother, Surface

__all__ = ["Bone", "Character", "Error", "Line", "Mesh", "Muscle", "Rig", "Smoother", "Surface", "export", "export_baked",
           "load", "load_rig"]
for _public in (Bone, Character, Error, Line, Mesh, Muscle, Rig, Smoother, Surface, export, export_baked, load, load_rig):
    _public.__module__ = "sinew"
del _public
