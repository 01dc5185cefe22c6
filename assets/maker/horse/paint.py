# assets/maker/horse/paint.py: the horse's colours, a bay with a star, as a function of space.
import math

from .. import vec
from ..bake import noise
from .head import DOWN_FACE, NECK, OFF_FACE, POLL
from .muscles import shapes

SIZE = 512  # texels

BAY, DARK_BAY, SAND, BLACK = (128, 70, 40), (80, 41, 25), (172, 114, 72), (30, 24, 23)
SOOT, WHITE, PINK, HORN, EYE = (52, 38, 33), (236, 228, 216), (176, 130, 118), (92, 78, 66), (22, 14, 12)
GROUND = BAY

CREST = [(1.605, 0.270), (1.655, 0.480)] + [row[0][0][1:] for row in NECK]  # y, z
SHAPES = shapes()


def colour(part, p):
    """RGB at a point of the left half in the bind pose."""
    if part in ("front hoof", "hind hoof"):
        tone = _hoof(p)
    elif part == "tail":
        tone = _covered(p, 1.0 - vec.smoothstep(1.385, 1.47, p[1]), p[1])
    elif part in ("foreleg", "hind leg"):
        tone = _covered(p, _points(part, p), p[1])
    else:
        tone = _covered(p, 0.0 if part in ("ear", "muzzle") else _mane(p), p[1] * 0.6 - p[2])
        if part in ("head", "muzzle", "ear"):
            tone = _face(part, p, tone)
    return tuple(min(255, max(0, int(c / 2.0 + 0.5) * 2)) for c in tone)


def _covered(p, share, along):
    """The coat under as much of the long hair."""
    if share == 0.0:
        return _coat(p)
    return _hair(p, along) if share == 1.0 else vec.mix(_coat(p), _hair(p, along), share)


def _coat(p):
    """Bay: darker along the back, sandy under the belly, lit on muscles, dark in the furrows between them."""
    x, y, z = p
    tone = vec.mix(BAY, DARK_BAY, 0.55 * vec.smoothstep(0.45, 0.75, noise(p, 0.16)))
    back = vec.smoothstep(1.36, 1.56, y) * (1.0 - vec.smoothstep(0.45, 0.60, z))
    tone = vec.mix(tone, DARK_BAY, 0.60 * back)
    tone = vec.mix(tone, DARK_BAY, 0.55 * (1.0 - vec.smoothstep(0.006, 0.056, x)) * back)
    below = (1.0 - vec.smoothstep(0.90, 1.12, y)) * vec.smoothstep(-0.56, -0.40, z) * (1.0 - vec.smoothstep(0.1, 0.3, z))
    tone = vec.mix(tone, SAND, 0.55 * below)
    lit, furrow = _relief(p)
    tone = vec.mix(tone, SAND, 0.24 * lit)
    tone = vec.mix(tone, DARK_BAY, 0.34 * furrow)
    fine = noise((x / 0.7, y / 0.7, z / 2.0), 0.008)
    return vec.scale(tone, 0.94 + 0.11 * fine)


def _relief(p):
    """How much p lies on the crown of a muscle, and how much in the furrow around one; both 0..1."""
    lit = furrow = 0.0
    for centre, turned_back, radii in SHAPES:
        d = vec.sub(p, centre)
        if vec.dot(d, d) > (1.5 * max(radii)) ** 2:
            continue
        d = vec.rotate(turned_back, d)
        q = math.sqrt(sum((a / r) ** 2 for a, r in zip(d, radii)))
        lit = max(lit, 1.0 - vec.smoothstep(0.30, 1.05, q))
        furrow = max(furrow, vec.smoothstep(0.85, 1.12, q) * (1.0 - vec.smoothstep(1.12, 1.50, q)))
    return lit, furrow * (1.0 - lit)


def _hair(p, along):
    """Mane, tail and legs: black with brown strands. along: what stays the same across a strand's width."""
    strand = noise((p[0] / 0.012, p[2] / 0.012 + p[1] / 0.05, along / 0.30), 1.0)
    return vec.mix(BLACK, SOOT, vec.smoothstep(0.40, 0.85, strand))


def _points(part, p):
    """How black the leg is: from above the knee or hock down."""
    ragged = 0.05 * (noise(p, 0.03) - 0.5)
    low, high = (0.47, 0.70) if part == "foreleg" else (0.56, 0.80)
    return 1.0 - vec.smoothstep(low, high, p[1] + ragged)


def _mane(p):
    """The mane hangs from the crest in locks; between the ears it falls on the forehead."""
    x, y, z = p
    best, along, run = 9.0, 0.0, 0.0
    for (y0, z0), (y1, z1) in zip(CREST, CREST[1:]):
        dy, dz = y1 - y0, z1 - z0
        length = math.hypot(dy, dz)
        t = min(1.0, max(0.0, ((y - y0) * dy + (z - z0) * dz) / (length * length)))
        away = math.hypot(y - y0 - t * dy, z - z0 - t * dz)
        if away < best:
            best, along = away, run + t * length
        run += length
    lock = noise((along / 0.035, 0.0, 0.0), 1.0)
    strand = noise((along / 0.010, 0.5, 0.0), 1.0)
    hangs = (0.095 + 0.060 * lock + 0.020 * strand) * vec.smoothstep(0.0, 0.18, along)
    neck = 1.0 - vec.smoothstep(hangs - 0.012, hangs + 0.006, best)
    down, off = _on_face(p)
    wide = 0.034 * (1.0 - vec.smoothstep(0.04, 0.165, down)) + 0.008 * (noise((x / 0.008, down / 0.06, 0.0), 1.0) - 0.5)
    forelock = (1.0 - vec.smoothstep(wide - 0.004, wide + 0.004, x)) * vec.smoothstep(-0.08, -0.04, down)
    forelock *= vec.smoothstep(-0.02, 0.0, off) * (1.0 - vec.smoothstep(0.15, 0.17, down))
    on_neck = 1.0 - vec.smoothstep(0.02, 0.05, down) * vec.smoothstep(0.03, 0.045, x)
    return max(neck * on_neck if down < 0.05 else 0.0, forelock)


def _on_face(p):
    """(metres from the poll towards the nose, metres off the face)."""
    d = vec.sub(p, POLL)
    return vec.dot(d, DOWN_FACE), vec.dot(d, OFF_FACE)


def _spot(a, b, half_a, half_b, soft=0.15):
    """1 inside an ellipse about 0, 0 outside."""
    return 1.0 - vec.smoothstep(1.0 - soft, 1.0 + soft, math.hypot(a / half_a, b / half_b))


def _face(part, p, tone):
    x = p[0]
    down, off = _on_face(p)
    if part == "ear":
        return vec.mix(tone, BLACK, 0.85 * (1.0 - vec.smoothstep(-0.125, -0.03, down)))
    jaw = 1.0 - vec.smoothstep(-0.20, -0.13, off)
    tone = vec.mix(tone, SAND, 0.25 * jaw)
    muzzle = vec.smoothstep(0.40, 0.53, down + 0.05 * (noise(p, 0.04) - 0.5))
    tone = vec.mix(tone, SAND, 0.75 * muzzle * (1.0 - vec.smoothstep(0.53, 0.60, down)))
    tone = vec.mix(tone, SOOT, 0.75 * vec.smoothstep(0.545, 0.60, down + 0.3 * max(0.0, x - 0.03)))
    tone = vec.mix(tone, WHITE, _star(p, x, down, off))
    tone = vec.mix(tone, PINK, 0.8 * _spot(x, down - 0.605, 0.020, 0.025, 0.4) * vec.smoothstep(-0.10, -0.03, off))
    nostril = _spot(down - 0.574 + 0.35 * (off + 0.045), off + 0.045, 0.017, 0.022) * vec.smoothstep(0.028, 0.036, x)
    tone = vec.mix(tone, BLACK, 0.95 * nostril)
    mouth = 1.0 - vec.smoothstep(0.0025, 0.0055, abs(off + 0.098 + 0.10 * (0.58 - down)))
    tone = vec.mix(tone, BLACK, 0.8 * mouth * vec.smoothstep(0.485, 0.51, down))
    return _eye(x, down, off, tone)


def _star(p, x, down, off):
    """A star between the eyes and a thin strip down the nose."""
    ragged = 0.006 * (noise(p, 0.012) - 0.5)
    star = _spot(x + ragged, down - 0.205, 0.030, 0.048, 0.12)
    wide = 0.014 - 0.006 * vec.smoothstep(0.25, 0.42, down) + 0.008 * vec.smoothstep(0.46, 0.58, down)
    strip = (1.0 - vec.smoothstep(wide - 0.003, wide + 0.003, x + ragged)) * vec.smoothstep(0.21, 0.22, down)
    strip *= 1.0 - vec.smoothstep(0.585, 0.60, down)
    return max(star, strip) * vec.smoothstep(-0.06, -0.03, off) * 0.96


def _eye(x, down, off, tone):
    """Large and dark, with a lid, a corner and a glint."""
    if x < 0.05:
        return tone
    along, across = down - 0.190, off + 0.030
    a, slant = 0.82 * along + 0.57 * across, 0.82 * across - 0.57 * along  # the corners lie level
    tone = vec.mix(tone, DARK_BAY, 0.75 * _spot(a, slant, 0.046, 0.034, 0.35))
    tone = vec.mix(tone, SAND, 0.35 * _spot(a, slant - 0.030, 0.034, 0.007, 0.6))
    tone = vec.mix(tone, BLACK, _spot(a, slant, 0.032, 0.0215, 0.10))
    tone = vec.mix(tone, EYE, _spot(a, slant, 0.026, 0.017, 0.10))
    tone = vec.mix(tone, (86, 50, 30), 0.75 * _spot(a + 0.001, slant + 0.007, 0.017, 0.008, 0.5))
    return vec.mix(tone, WHITE, _spot(a + 0.006, slant - 0.007, 0.0052, 0.0045, 0.3))


def _hoof(p):
    """Horn with rings, dark at the ground, a pale band under the hair."""
    x, y, z = p
    rings = 0.5 + 0.5 * math.sin(2.0 * math.pi * (y + 0.25 * z) / 0.016)
    tone = vec.mix(HORN, SOOT, 0.25 + 0.30 * rings + 0.30 * noise((x / 0.01, z / 0.01, y / 0.2), 1.0))
    tone = vec.mix(SOOT, tone, vec.smoothstep(-0.002, 0.020, y))
    line = 0.078 + 0.30 * max(0.0, _from_heel(z))
    tone = vec.mix(tone, SAND, 0.40 * vec.smoothstep(line - 0.022, line - 0.012, y))
    return vec.mix(tone, _hair(p, y), vec.smoothstep(line - 0.008, line + 0.002, y + 0.008 * (noise(p, 0.010) - 0.5)))


def _from_heel(z):
    return z - 0.455 if z > 0.0 else z + 0.742
