# assets/maker/paint.py: the demo's texture, painted in space and baked into the charts, written as a PNG.
import math
import struct
import zlib

from . import vec
from .body import HEAD_SCALE, TAIL, TAIL_ROOT, TAIL_TIP, enlarged

SIZE = 512
PADDING = 3  # texels around each chart that repeat its border, so that filtering finds no seam

TEAL, DEEP, CREAM = (74, 158, 138), (32, 92, 96), (238, 222, 178)
CORAL, CLAW, WHITE, INK, AMBER = (226, 120, 92), (70, 58, 56), (250, 248, 240), (24, 22, 30), (240, 176, 60)


def pack(cage):
    """Lays the charts on shelves, tallest first."""
    order = sorted(range(len(cage.charts)), key=lambda c: (-cage.charts[c].rows * cage.charts[c].pixels, c))
    x = y = shelf = 0
    for index in order:
        chart = cage.charts[index]
        width = chart.columns * chart.pixels + 2 * PADDING
        height = chart.rows * chart.pixels + 2 * PADDING
        if x + width > SIZE:
            x, y, shelf = 0, y + shelf, 0
        chart.origin = (x + PADDING, y + PADDING)
        x, shelf = x + width, max(shelf, height)
    if y + shelf > SIZE:
        raise SystemExit("the charts do not fit the texture")


def bake(cage):
    """PNG bytes."""
    pack(cage)
    pixels = [TEAL] * (SIZE * SIZE)
    for vertices, keys in cage.faces:
        chart = cage.charts[keys[0][0]]
        corners = [cage.positions[v] for v in vertices]
        cut = cage.cut(vertices)
        i, j = keys[0][1], keys[0][2]
        margin = [PADDING if at else 0 for at in (i == 0, i == chart.columns - 1, j == 0, j == chart.rows - 1)]
        x0, y0 = chart.origin[0] + i * chart.pixels, chart.origin[1] + j * chart.pixels
        for y in range(y0 - margin[2], y0 + chart.pixels + margin[3]):
            for x in range(x0 - margin[0], x0 + chart.pixels + margin[1]):
                point = _at(corners, cut, (x + 0.5 - x0) / chart.pixels, (y + 0.5 - y0) / chart.pixels)
                pixels[y * SIZE + x] = colour(chart.part, point)
    return png(pixels, SIZE, SIZE)


_CORNERS = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


def _at(corners, cut, u, v):
    """The point of the flat triangle that shows this place of the cell; beyond the cell, of that triangle's plane."""
    best = None
    for triangle in cut:
        (ax, ay), (bx, by), (cx, cy) = (_CORNERS[k] for k in triangle)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        b = ((u - ax) * (cy - ay) - (v - ay) * (cx - ax)) / area
        c = ((bx - ax) * (v - ay) - (by - ay) * (u - ax)) / area
        inside = min(1.0 - b - c, b, c)
        if best is None or inside > best[0]:
            best = (inside, triangle, b, c)
    _, triangle, b, c = best
    p, q, r = (corners[k] for k in triangle)
    return vec.add(p, vec.add(vec.scale(vec.sub(q, p), b), vec.scale(vec.sub(r, p), c)))


def _noise(p, cell):
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


def colour(part, p):
    """RGB at a point of the left half in the bind pose."""
    if part in ("head", "snout", "eye"):
        p = enlarged(p, 1.0 / HEAD_SCALE)  # painted at the size it was modelled
    tone = _eye(p) if part == "eye" else _skin(part, p)
    shade = 0.97 + 0.06 * _noise(p, 0.02) if part != "eye" else 1.0
    return tuple(min(255, max(0, int(c * shade / 2.0 + 0.5) * 2)) for c in tone)


def _skin(part, p):
    x, y, z = p
    tone = vec.mix(TEAL, DEEP, vec.smoothstep(0.42, 0.8, _noise(p, 0.09)) * 0.4)
    tone = vec.mix(tone, DEEP, 0.55 * _back(part, p))
    tone = vec.mix(tone, DEEP, 0.8 * _bands(part, p))
    tone = vec.mix(tone, CREAM, _belly(part, p))
    if part == "head":
        cheek = vec.length(vec.sub(p, (0.135, 1.405, 0.085)))
        tone = vec.mix(tone, CORAL, 0.75 * (1.0 - vec.smoothstep(0.018, 0.050, cheek)))
    if part == "snout":
        nostril = vec.length(vec.sub(p, (0.030, 1.406, 0.302)))
        tone = vec.mix(tone, INK, 1.0 - vec.smoothstep(0.006, 0.011, nostril))
    if part in ("head", "snout"):
        tone = vec.mix(tone, INK, 0.85 * _mouth(p))
    if part == "foot":
        tone = vec.mix(tone, CLAW, _claws(p))
    if part == "arm":
        fingers = vec.smoothstep(0.43, 0.50, x)
        tone = vec.mix(tone, DEEP, 0.45 * fingers)
    return tone


def _back(part, p):
    """Dark along the spine."""
    x, y, z = p
    if part in ("body", "crotch"):
        return (1.0 - vec.smoothstep(0.03, 0.10, x)) * vec.smoothstep(0.02, 0.08, -z)
    if part == "head":
        return (1.0 - vec.smoothstep(0.03, 0.09, x)) * vec.smoothstep(1.55, 1.60, y - 0.6 * min(0.0, z + 0.02))
    return 0.0


def _bands(part, p):
    """Stripes across tail, back, thighs and upper arms; ragged edges."""
    x, y, z = p
    ragged = 0.9 * (_noise(p, 0.035) - 0.5)
    if part == "tail":
        wave = math.sin(2.0 * math.pi * (-z) / 0.115 + ragged)
        return vec.smoothstep(0.15, 0.5, wave) * vec.smoothstep(0.15, 0.25, -z)
    if part == "body":
        wave = math.sin(2.0 * math.pi * (y + 0.35 * x) / 0.105 + ragged)
        on_back = vec.smoothstep(0.035, 0.07, -z) * (1.0 - vec.smoothstep(0.10, 0.135, x))
        return vec.smoothstep(0.25, 0.6, wave) * on_back
    if part == "leg":
        wave = math.sin(2.0 * math.pi * (y + 0.25 * z) / 0.098 + ragged)
        on_thigh = vec.smoothstep(0.10, 0.135, x - 0.25 * z) * vec.smoothstep(0.36, 0.42, y)
        on_thigh *= 1.0 - vec.smoothstep(0.61, 0.65, y)
        return vec.smoothstep(0.3, 0.65, wave) * on_thigh
    if part == "arm":
        wave = math.sin(2.0 * math.pi * (0.77 * x - 0.64 * y) / 0.085 + ragged)
        outside = vec.smoothstep(-0.02, 0.02, 0.64 * (x - 0.158) + 0.77 * (y - 1.125))
        outside *= vec.smoothstep(0.0, 0.04, 0.77 * (x - 0.158) - 0.64 * (y - 1.125))
        return vec.smoothstep(0.3, 0.65, wave) * outside * (1.0 - vec.smoothstep(0.36, 0.42, x))
    return 0.0


def _belly(part, p):
    x, y, z = p
    wobble = 0.02 * (_noise(p, 0.05) - 0.5)
    if part == "body":
        wide = 0.095 - 0.030 * vec.smoothstep(1.08, 1.22, y)
        rounded = vec.smoothstep(0.700, 0.725, y - 0.9 * x * x / wide)
        in_front = vec.smoothstep(-0.01, 0.03, z + wobble)
        return (1.0 - vec.smoothstep(wide - 0.008, wide + 0.008, x + wobble)) * in_front * rounded
    if part == "tail":
        centre, half = _tail_at(z)
        return (1.0 - vec.smoothstep(-0.55, -0.35, (y - centre) / half + 8.0 * wobble)) * vec.smoothstep(0.26, 0.36, -z)
    if part in ("head", "snout"):
        edge = 1.384 - 0.9 * max(0.0, 0.13 - z)
        wide = 0.060 + 2.0 * max(0.0, y - 1.315)  # on the neck as wide as on the body
        on_throat = 1.0 - vec.smoothstep(wide - 0.008, wide + 0.008, x + wobble)
        return (1.0 - vec.smoothstep(edge - 0.005, edge + 0.005, y + 0.4 * wobble)) * on_throat
    return 0.0


def _tail_at(z):
    """Height of the tail's middle and its half height, from the root to the tip."""
    rows = [(TAIL_ROOT[1], TAIL_ROOT[0], 0.07)]
    rows += [(r[1], r[0], r[3]) for r in TAIL] + [(TAIL_TIP[1], TAIL_TIP[0], 0.01)]
    for (z0, y0, h0), (z1, y1, h1) in zip(rows, rows[1:]):
        if z >= z1 or z1 == TAIL_TIP[1]:
            t = min(1.0, max(0.0, (z - z0) / (z1 - z0)))
            return y0 + (y1 - y0) * t, h0 + (h1 - h0) * t
    return rows[-1][1:]


def _mouth(p):
    """A smile: a line around the snout that rises towards the cheek."""
    x, y, z = p
    if z < 0.085:
        return 0.0
    line = 1.384 + 0.028 * (1.0 - vec.smoothstep(0.085, 0.19, z))
    return 1.0 - vec.smoothstep(0.0020, 0.0042, abs(y - line))


def _claws(p):
    """Three dark nails at the front of the foot."""
    x, y, z = p
    nail = min(math.hypot((x - centre) / 0.011, (z - 0.170) / 0.020) for centre in (0.100, 0.136, 0.172))
    return 1.0 - vec.smoothstep(0.85, 1.1, nail)


def _eye(p):
    """White, amber iris, round pupil and a glint; p lies on the dome."""
    away = vec.length(vec.sub(p, (0.087, 1.503, 0.152)))
    glint = vec.length(vec.sub(p, (0.079, 1.517, 0.156)))
    tone = vec.mix(AMBER, WHITE, vec.smoothstep(0.0255, 0.0275, away))
    tone = vec.mix(INK, tone, vec.smoothstep(0.0175, 0.0195, away))
    tone = vec.mix(tone, INK, vec.smoothstep(0.0345, 0.0365, away))
    tone = vec.mix(tone, _skin("head", p), vec.smoothstep(0.0385, 0.0415, away))
    return vec.mix(WHITE, tone, vec.smoothstep(0.0055, 0.0072, glint))


def png(pixels, width, height):
    rows = bytearray()
    for y in range(height):
        row = [channel for pixel in pixels[y * width:(y + 1) * width] for channel in pixel]
        rows += b"\x01" + bytes((c - (row[i - 3] if i >= 3 else 0)) & 255 for i, c in enumerate(row))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))
