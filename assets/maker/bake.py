# assets/maker/bake.py: a colour that is a function of space, baked into a cage's charts, written as a PNG.
import math
import struct
import zlib

from . import vec

PADDING = 3  # texels around each chart that repeat its border, so that filtering finds no seam


def pack(cage, size):
    """Lays the charts on shelves, tallest first."""
    order = sorted(range(len(cage.charts)), key=lambda c: (-cage.charts[c].top(cage.charts[c].rows), c))
    x = y = shelf = 0
    for index in order:
        chart = cage.charts[index]
        width = chart.columns * chart.pixels + 2 * PADDING
        height = chart.top(chart.rows) + 2 * PADDING
        if x + width > size:
            x, y, shelf = 0, y + shelf, 0
        chart.origin = (x + PADDING, y + PADDING)
        x, shelf = x + width, max(shelf, height)
    if y + shelf > size:
        raise SystemExit("the charts do not fit the texture")


def bake(cage, colour, ground, size, normals=None, every=1):
    """PNG bytes. colour(part, point) -> RGB 0..255, at points of the flat left half; ground: RGB where no face lies. With
    normals, one for each vertex, colour(part, point, normal). Rows whose number is no multiple of every stay ground."""
    pack(cage, size)
    pixels = [ground] * (size * size)
    for vertices, keys in cage.faces:
        chart = cage.charts[keys[0][0]]
        corners = [cage.positions[v] for v in vertices]
        facing = [normals[v] for v in vertices] if normals else None
        cut = cage.cut(vertices)
        i, j = keys[0][1], keys[0][2]
        margin = [PADDING if at else 0 for at in (i == 0, i == chart.columns - 1, j == 0, j == chart.rows - 1)]
        x0, y0 = chart.origin[0] + i * chart.pixels, chart.origin[1] + chart.top(j)
        high = chart.heights[j]
        for y in range(y0 - margin[2], y0 + high + margin[3]):
            if y % every:
                continue
            for x in range(x0 - margin[0], x0 + chart.pixels + margin[1]):
                place = _place(cut, (x + 0.5 - x0) / chart.pixels, (y + 0.5 - y0) / high)
                seen = (_at(corners, place),) + ((vec.unit(_at(facing, place)),) if facing else ())
                pixels[y * size + x] = colour(chart.part, *seen)
    return png(pixels, size, size)


_CORNERS = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


def _place(cut, u, v):
    """(triangle, b, c): which triangle of the cell shows this place, and how far along its two sides."""
    best = None
    for triangle in cut:
        (ax, ay), (bx, by), (cx, cy) = (_CORNERS[k] for k in triangle)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        b = ((u - ax) * (cy - ay) - (v - ay) * (cx - ax)) / area
        c = ((bx - ax) * (v - ay) - (by - ay) * (u - ax)) / area
        inside = min(1.0 - b - c, b, c)
        if best is None or inside > best[0]:
            best = (inside, triangle, b, c)
    return best[1:]


def _at(corners, place):
    """The point of the flat triangle at the place; beyond the cell, of that triangle's plane."""
    triangle, b, c = place
    (px, py, pz), (qx, qy, qz), (rx, ry, rz) = (corners[k] for k in triangle)
    return (px + ((qx - px) * b + (rx - px) * c), py + ((qy - py) * b + (ry - py) * c),
            pz + ((qz - pz) * b + (rz - pz) * c))


def noise(p, cell):
    """Smooth value noise in 0..1."""
    q = [c / cell for c in p]
    base = [math.floor(c) for c in q]
    f = [c - b for c, b in zip(q, base)]
    f = [t * t * (3.0 - 2.0 * t) for t in f]
    total = 0.0
    for corner in range(8):
        bits = [(corner >> k) & 1 for k in range(3)]
        n = (base[0] + bits[0]) * 374761393 + (base[1] + bits[1]) * 668265263 + (base[2] + bits[2]) * 2147483647
        n = ((n & 0xFFFFFFFF) ^ ((n & 0xFFFFFFFF) >> 13)) * 1274126177 & 0xFFFFFFFF
        weight = 1.0
        for bit, t in zip(bits, f):
            weight *= t if bit else 1.0 - t
        total += weight * ((n ^ (n >> 16)) & 0xFFFF) / 65535.0
    return total


def png(pixels, width, height):
    rows = bytearray()
    for y in range(height):
        row = [channel for pixel in pixels[y * width:(y + 1) * width] for channel in pixel]
        rows += b"\x01" + bytes((c - (row[i - 3] if i >= 3 else 0)) & 255 for i, c in enumerate(row))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))
