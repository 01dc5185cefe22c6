# assets/maker/lizard/paint.py: the lizard's colours as a function of space.
import math

from .. import vec
from ..bake import noise
from .body import HEAD_SCALE, TAIL, TAIL_ROOT, TAIL_TIP, enlarged

SIZE = 512  # texels

TEAL, DEEP, CREAM = (74, 158, 138), (32, 92, 96), (238, 222, 178)
CORAL, CLAW, WHITE, INK, AMBER = (226, 120, 92), (70, 58, 56), (250, 248, 240), (24, 22, 30), (240, 176, 60)


def colour(part, p):
    """RGB at a point of the left half in the bind pose."""
    if part in ("head", "snout", "eye"):
        p = enlarged(p, 1.0 / HEAD_SCALE)  # painted at the size it was modelled
    tone = _eye(p) if part == "eye" else _skin(part, p)
    shade = 0.97 + 0.06 * noise(p, 0.02) if part != "eye" else 1.0
    return tuple(min(255, max(0, int(c * shade / 2.0 + 0.5) * 2)) for c in tone)


def _skin(part, p):
    x, y, z = p
    tone = vec.mix(TEAL, DEEP, vec.smoothstep(0.42, 0.8, noise(p, 0.09)) * 0.4)
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
    ragged = 0.9 * (noise(p, 0.035) - 0.5)
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
    wobble = 0.02 * (noise(p, 0.05) - 0.5)
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
