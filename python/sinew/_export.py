# python/sinew/_export.py: characters for other programs.
from . import _sinew
from ._checks import expect
from ._rig import Rig


def export(rig, path, *, helpers=None, mesh="refined", weights="refitted", joint_scale="full", clips=None, shapes=True,
           progress=None, threads=0):
    """Writes the character with its muscles as .glb, .gltf or .usda, and returns what `sinew export --json` tells.

    helpers: joints are added that move as the muscles do, one a muscle line and at most so many more, 0 to 256; None:
    the character's own joints alone. mesh: refined or original. weights: refitted or transferred. joint_scale: full,
    uniform or none. clips: names of those to keep; None: all. shapes: morph targets come along.
    progress: called with the share that is done, 0 to 1; it cancels by returning False or raising. docs/export.md.
    """
    options = dict(helpers=helpers, mesh=mesh, weights=weights, joint_scale=joint_scale, clips=clips, shapes=shapes,
                   progress=progress, threads=threads)
    return _sinew.export_skinned(expect(rig, Rig, "rig"), path, options)


def export_baked(rig, path, clip, *, fps=30.0, substeps=1, bound=0.1, weights="refitted", progress=None, threads=0):
    """Writes one clip as morph targets (.glb, .gltf) or points (.usda, .pc2, .mdd), and returns what the export tells.

    bound: how far vertices may lie off, percent of the height. docs/export.md.
    """
    options = dict(fps=fps, substeps=substeps, bound=bound, weights=weights, progress=progress, threads=threads)
    return _sinew.export_baked(expect(rig, Rig, "rig"), path, clip, options)
