# tests/gui/bind_pose.py: a character's bones as its file binds them, and what a muscle is there. Nothing of the editor's.
import math
import pathlib
import random
import sys

import rigs

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from glb_reader import Glb  # noqa: E402


def matrix_product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def affine_inverse(m):
    """Of a matrix whose last row is 0 0 0 1."""
    (a, b, c, _), (d, e, f, _), (g, h, i, _) = m[0], m[1], m[2]
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    inverse = [[(e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det],
               [(f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det],
               [(d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det]]
    shift = [-sum(row[k] * m[k][3] for k in range(3)) for row in inverse]
    return [row + [s] for row, s in zip(inverse, shift)] + [[0.0, 0.0, 0.0, 1.0]]


def bones_in_bind(path):
    """Joint name -> 4x4 rows, bone space -> the space the skin is bound in, from a .glb with one skin."""
    glb = Glb(pathlib.Path(path))
    skin = glb.json["skins"][0]
    bones = {}
    for joint, columns in zip(skin["joints"], glb.rows(skin["inverseBindMatrices"])):
        rows = [[columns[4 * j + i] for j in range(4)] for i in range(4)]
        rows[3] = [0.0, 0.0, 0.0, 1.0]
        bones[glb.json["nodes"][joint].get("name", "")] = affine_inverse(rows)
    return bones


def ellipsoid_in_bind(bones, muscle):
    """(center, three semi-axes), bind pose. The axes are the images of the ellipsoid's own; sheared bones shear them."""
    bone = bones[muscle["bone"]]
    center = [sum(row[k] * muscle["center"][k] for k in range(3)) + row[3] for row in bone[:3]]
    axes = []
    for i in range(3):
        unit = [0.0, 0.0, 0.0]
        unit[i] = muscle["radii"][i]
        arm = rigs.turned(muscle["rotation"], unit)
        axes.append([sum(row[k] * arm[k] for k in range(3)) for row in bone[:3]])
    return center, axes


def support(ellipsoid, direction):
    """How far it reaches in a direction. Two ellipsoids are the same if this is, for all directions."""
    center, axes = ellipsoid
    dot = lambda a: sum(x * y for x, y in zip(a, direction))
    return dot(center) + math.sqrt(sum(dot(axis) ** 2 for axis in axes))


def mirror_error(bones, left, right):
    """Largest distance between one muscle's tangent planes and the mirrored other's, across x = 0, bind pose."""
    a, b = ellipsoid_in_bind(bones, left), ellipsoid_in_bind(bones, right)
    source = random.Random(7)
    worst = 0.0
    for _ in range(200):
        way = [source.gauss(0.0, 1.0) for _ in range(3)]
        length = math.sqrt(sum(v * v for v in way))
        way = [v / length for v in way]
        worst = max(worst, abs(support(a, way) - support(b, [-way[0], way[1], way[2]])))
    return worst
