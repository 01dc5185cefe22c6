# assets/maker/cage.py: the left half of a character as rings of vertices joined by quads, with charts for its texture.
import math

from . import vec
from .names import mirror_name


class Chart:
    """A grid of cells in the texture, `pixels` wide and, unless `heights` says so row by row, as high. Cell (i, j) belongs to
    at most one face."""

    def __init__(self, part, columns, rows, pixels, heights=None):
        self.part, self.columns, self.rows, self.pixels = part, columns, rows, pixels
        self.heights = list(heights) if heights else [pixels] * rows
        self.origin = (0, 0)  # of cell (0, 0), in texels; set by the packing

    def top(self, j):
        """Texels from the chart's origin to row j; j = rows: the chart's height."""
        return sum(self.heights[:j])


class Cage:
    """Vertices with x >= 0; those with x == 0 are shared with the mirrored half."""

    def __init__(self):
        self.positions = []
        self.weights = []   # [{bone: weight}], sum 1
        self.charts = []
        self.faces = []     # [(vertices, [(chart, i, j)])], 3 or 4 corners, counter-clockwise from outside

    def vertex(self, position, weights):
        total = sum(weights.values())
        self.positions.append(tuple(position))
        self.weights.append({bone: w / total for bone, w in weights.items() if w > 0.0})
        return len(self.positions) - 1

    def ring(self, points, weights):
        return [self.vertex(p, weights) for p in points]

    def chart(self, part, columns, rows, pixels, heights=None):
        self.charts.append(Chart(part, columns, rows, pixels, heights))
        return len(self.charts) - 1

    def face(self, vertices, chart, i=0, j=0):
        corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        self.faces.append((list(vertices), [(chart, a, b) for a, b in corners[:len(vertices)]]))

    def tube(self, rings, part, closed, holes=(), pixels=20, heights=None):
        """Quads between consecutive rings, but not at the (column, row) of `holes`."""
        count = len(rings[0])
        columns = count if closed else count - 1
        chart = self.chart(part, columns, len(rings) - 1, pixels, heights)
        for j in range(len(rings) - 1):
            for i in range(columns):
                if (i, j) not in holes:
                    k = (i + 1) % count
                    self.face([rings[j][i], rings[j][k], rings[j + 1][k], rings[j + 1][i]], chart, i, j)

    def cap(self, ring, part, pixels=20):
        """Closes a ring of 4 (one quad) or 6 (two quads)."""
        chart = self.chart(part, len(ring) // 2 - 1, 1, pixels)
        self.face([ring[0], ring[1], ring[2], ring[-1]], chart, 0, 0)
        if len(ring) == 6:
            self.face([ring[2], ring[3], ring[4], ring[5]], chart, 1, 0)

    def single(self, vertices, part, pixels=20):
        self.face(vertices, self.chart(part, 1, 1, pixels))

    def cut(self, vertices):
        """Corners of the triangles of a face: a quad is cut along its shorter diagonal."""
        if len(vertices) == 3:
            return ((0, 1, 2),)
        p = [self.positions[v] for v in vertices]
        first = vec.length(vec.sub(p[0], p[2])) <= vec.length(vec.sub(p[1], p[3])) + 1e-9
        return ((0, 1, 2), (0, 2, 3)) if first else ((1, 2, 3), (1, 3, 0))

    def triangles(self):
        """[((vertex, corner key) x 3)]"""
        return [tuple((vertices[k], keys[k]) for k in t) for vertices, keys in self.faces for t in self.cut(vertices)]

    def uv(self, key, size):
        chart, i, j = key
        c = self.charts[chart]
        return ((c.origin[0] + i * c.pixels) / size, (c.origin[1] + c.top(j)) / size)

    def mirrored(self):
        """The whole character: a Mesh with both halves, texture shared."""
        mesh = Mesh(self)
        twin = {}
        for v, (x, y, z) in enumerate(self.positions):
            mesh.add(self.positions[v], self.weights[v])
        for v, (x, y, z) in enumerate(self.positions):
            flipped = {mirror_name(bone): w for bone, w in self.weights[v].items()}
            twin[v] = v if x == 0.0 else mesh.add((-x, y, z), flipped)
        half = self.triangles()
        mesh.triangles = half + [tuple((twin[v], key) for v, key in (t[0], t[2], t[1])) for t in half]
        return mesh


class Mesh:
    """A closed triangle mesh with shared vertices."""

    def __init__(self, cage):
        self.cage, self.positions, self.weights, self.triangles = cage, [], [], []

    def add(self, position, weights):
        self.positions.append(position)
        self.weights.append(weights)
        return len(self.positions) - 1

    def normals(self):
        """Unit, weighted by the faces' angles."""
        sums = [(0.0, 0.0, 0.0)] * len(self.positions)
        for t in self.triangles:
            p = [self.positions[v] for v, _ in t]
            face = vec.unit(vec.cross(vec.sub(p[1], p[0]), vec.sub(p[2], p[0])))
            for k in range(3):
                a, b = vec.unit(vec.sub(p[(k + 1) % 3], p[k])), vec.unit(vec.sub(p[(k + 2) % 3], p[k]))
                angle = math.acos(min(1.0, max(-1.0, vec.dot(a, b))))
                sums[t[k][0]] = vec.add(sums[t[k][0]], vec.scale(face, angle))
        return [vec.unit(s) for s in sums]
