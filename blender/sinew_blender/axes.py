# blender/sinew_blender/axes.py: from glTF's axes (y up) to Blender's (z up) and back.
import numpy
from mathutils import Matrix

TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
TO_GLTF = TO_BLENDER.inverted()


def points_in_blender(points, unit):
    """[N, 3] float32 in a row, as Blender's foreach_set takes it. unit: Blender's units in one of the file's."""
    turned = numpy.empty(points.shape, numpy.float32)
    turned[:, 0] = points[:, 0]
    numpy.negative(points[:, 2], out=turned[:, 1])
    turned[:, 2] = points[:, 1]
    if unit != 1.0:
        turned *= unit
    return turned


def matrices_in_gltf(matrices, unit):
    """[N, 4, 4] maps between spaces with Blender's axes, as maps between the same with glTF's."""
    turned = numpy.array(TO_GLTF) @ matrices @ numpy.array(TO_BLENDER)
    turned[:, :3, 3] /= unit
    return turned


def matrices_in_blender(matrices, unit):
    """The way back."""
    turned = numpy.array(TO_BLENDER) @ matrices.astype(float) @ numpy.array(TO_GLTF)
    turned[:, :3, 3] *= unit
    return turned
