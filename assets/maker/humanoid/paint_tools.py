# assets/maker/humanoid/paint_tools.py: mixing, noise and strokes, for a million texels.
import functools
import math


def mix(a, b, t):
    return (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t)


def smoothstep(low, high, x):
    """From 0 at low to 1 at high, which may be the smaller."""
    t = (x - low) / (high - low)
    return 0.0 if t <= 0.0 else 1.0 if t >= 1.0 else t * t * (3.0 - 2.0 * t)


@functools.lru_cache(maxsize=None)
def _lattice(i, j, k):
    n = (i * 374761393 + j * 668265263 + k * 1274126177) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1103515245 + 12345) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65535.0


def noise(x, y, z, cell):
    """Smooth value noise in 0..1."""
    x, y, z = x / cell, y / cell, z / cell
    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - i, y - j, z - k
    u, v, w = u * u * (3.0 - 2.0 * u), v * v * (3.0 - 2.0 * v), w * w * (3.0 - 2.0 * w)

    def row(b, c):
        low = _lattice(i, b, c)
        return low + (_lattice(i + 1, b, c) - low) * u

    def layer(c):
        low = row(j, c)
        return low + (row(j + 1, c) - low) * v

    low = layer(k)
    return low + (layer(k + 1) - low) * w


def spot(x, y, cx, cy, rx, ry):
    """1 in the middle of an ellipse, softly 0 at its rim."""
    a, b = (x - cx) / rx, (y - cy) / ry
    d = a * a + b * b
    return (1.0 - d) * (1.0 - d) if d < 1.0 else 0.0


class Stroke:
    """A soft line through points in the plane, that fades towards both ends."""

    def __init__(self, tone, strength, radius, points):
        self.tone, self.strength, self.radius = tone, strength, radius
        xs, ys = [q[0] for q in points], [q[1] for q in points]
        self.box = (min(xs) - radius, max(xs) + radius, min(ys) - radius, max(ys) + radius)
        self.pieces, total = [], 0.0
        for (ax, ay), (bx, by) in zip(points, points[1:]):
            self.pieces.append((ax, ay, bx - ax, by - ay, total, math.hypot(bx - ax, by - ay)))
            total += self.pieces[-1][-1]
        self.length = total

    def share(self, x, y):
        """How much of the tone there is at a place."""
        x0, x1, y0, y1 = self.box
        if not (x0 < x < x1 and y0 < y < y1):
            return 0.0
        best, at = 1e9, 0.0
        for ax, ay, dx, dy, before, size in self.pieces:
            t = ((x - ax) * dx + (y - ay) * dy) / (size * size)
            t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
            ex, ey = ax + t * dx - x, ay + t * dy - y
            d = ex * ex + ey * ey
            if d < best:
                best, at = d, before + t * size
        d = best / (self.radius * self.radius)
        if d >= 1.0:
            return 0.0
        ends = min(at, self.length - at) / self.length
        return self.strength * (1.0 - d) * (1.0 - d) * (0.35 + 0.65 * min(1.0, 3.0 * ends))


class Strokes:
    """Many strokes, found by height."""

    _ROW = 0.016

    def __init__(self, strokes):
        self.rows = {}
        for stroke in strokes:
            for row in range(math.floor(stroke.box[2] / self._ROW), math.floor(stroke.box[3] / self._ROW) + 1):
                self.rows.setdefault(row, []).append(stroke)

    def over(self, tone, x, y, share):
        """The tone after all strokes, as far as `share` lets them."""
        if share <= 0.0:
            return tone
        for stroke in self.rows.get(math.floor(y / self._ROW), ()):
            k = stroke.share(x, y)
            if k > 0.0:
                tone = mix(tone, stroke.tone, share * k)
        return tone
