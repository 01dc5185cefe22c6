# assets/maker/blocks.py: closed coarse meshes: the faces of a heap of boxes, drawn onto a body made of capsules.
import math

from . import vec

_SIDES = [  # step to the neighbour, corners of the face counter-clockwise from outside
    ((1, 0, 0), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))),
    ((-1, 0, 0), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))),
    ((0, 1, 0), ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0))),
    ((0, -1, 0), ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1))),
    ((0, 0, 1), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))),
    ((0, 0, -1), ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0))),
]


class Capsule:
    """A segment with a radius; part of a smooth union."""

    def __init__(self, a, b, radius):
        self.a, self.b, self.radius = a, b, radius

    def closest(self, p):
        along = vec.sub(self.b, self.a)
        span = vec.dot(along, along)
        t = min(1.0, max(0.0, vec.dot(vec.sub(p, self.a), along) / span)) if span > 0.0 else 0.0
        return vec.add(self.a, vec.scale(along, t))

    def distance(self, p):
        return vec.length(vec.sub(p, self.closest(p))) - self.radius


def blended_distance(capsules, p, softness):
    """Signed distance to the union, rounded where capsules meet: -s log sum exp(-d/s)."""
    distances = [c.distance(p) for c in capsules]
    low = min(distances)
    return low - softness * math.log(sum(math.exp((low - d) / softness) for d in distances))


def drawn_onto(p, distance, step=1e-4):
    """The point moved along the distance's gradient until the distance is 0."""
    for _ in range(40):
        d = distance(p)
        if abs(d) < 1e-7:
            break
        gradient = tuple((distance(tuple(c + step * (i == k) for i, c in enumerate(p))) -
                          distance(tuple(c - step * (i == k) for i, c in enumerate(p)))) / (2.0 * step)
                         for k in range(3))
        slope = max(vec.dot(gradient, gradient), 0.05)
        p = vec.sub(p, vec.scale(gradient, 0.8 * d / slope))
    return p


class Blocks:
    """Cells of an uneven grid. cells: {(i, j, k)}; corner (i, j, k) lies at place((i, j, k))."""

    def __init__(self, cells, place):
        self.cells, self.place = set(cells), place

    def mesh(self):
        """([positions], [triangles]): every face between a cell and none, cut in two."""
        numbers, positions, triangles = {}, [], []

        def number(corner):
            if corner not in numbers:
                numbers[corner] = len(positions)
                positions.append(self.place(corner))
            return numbers[corner]

        for cell in sorted(self.cells):
            for step, corners in _SIDES:
                if tuple(a + b for a, b in zip(cell, step)) in self.cells:
                    continue
                quad = [number(tuple(a + b for a, b in zip(cell, corner))) for corner in corners]
                # The cut alternates from cell to cell, so that no direction is preferred.
                if sum(cell) % 2:
                    quad = quad[1:] + quad[:1]
                triangles += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
        return positions, triangles


def relaxed(positions, triangles, distance, rounds):
    """Vertices moved half way to their neighbours' mean, then back onto the surface: evens the faces out."""
    around = [set() for _ in positions]
    for t in triangles:
        for k in range(3):
            around[t[k]] |= {t[(k + 1) % 3], t[(k + 2) % 3]}
    for _ in range(rounds):
        moved = []
        for p, near in zip(positions, around):
            mean = vec.scale(tuple(sum(positions[n][c] for n in sorted(near)) for c in range(3)), 1.0 / len(near))
            moved.append(drawn_onto(vec.mix(p, mean, 0.5), distance))
        positions = moved
    return positions


def normals(positions, triangles):
    """Unit, weighted by the faces' areas."""
    sums = [(0.0, 0.0, 0.0)] * len(positions)
    for t in triangles:
        p = [positions[v] for v in t]
        face = vec.cross(vec.sub(p[1], p[0]), vec.sub(p[2], p[0]))
        for v in t:
            sums[v] = vec.add(sums[v], face)
    return [vec.unit(s) for s in sums]


def weights(p, segments, softness):
    """{bone: share}: bones whose segment is nearly as close as the closest. segments: {bone: Capsule}"""
    distances = {bone: segment.distance(p) for bone, segment in segments.items()}
    low = min(distances.values())
    shares = {bone: math.exp((low - d) / softness) for bone, d in distances.items()}
    kept = sorted(shares.items(), key=lambda item: (-item[1], item[0]))[:4]
    kept = [(bone, share) for bone, share in kept if share > 0.02]
    total = sum(share for _, share in kept)
    return {bone: share / total for bone, share in kept}
