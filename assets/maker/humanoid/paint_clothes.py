# assets/maker/humanoid/paint_clothes.py: shorts, shoes, socks and wrist bands.
import math

from .paint_marks import DEEP, SHADE, arm_place
from .paint_tools import Stroke, Strokes, mix, noise, smoothstep

BLUE, NAVY, SKY = (38, 62, 112), (20, 32, 64), (74, 106, 164)
ORANGE, CREAM, SOLE, SHOE, SHOE_DARK = (222, 112, 46), (236, 228, 214), (222, 218, 208), (58, 62, 72), (32, 34, 42)

WAIST, HEM = 1.003, 0.668

# Folds, as the skin's strokes: tone, strength, radius, points in (x, y).
_FOLDS_FRONT = Strokes(Stroke(*row) for row in (
    (NAVY, 0.75, 0.016, [(0.016, 0.890), (0.060, 0.905), (0.120, 0.950), (0.150, 0.965)]),
    (NAVY, 0.65, 0.013, [(0.020, 0.866), (0.070, 0.866), (0.120, 0.885)]),
    (NAVY, 0.55, 0.012, [(0.030, 0.838), (0.070, 0.826), (0.105, 0.830)]),
    (SKY, 0.55, 0.014, [(0.040, 0.882), (0.085, 0.892), (0.125, 0.920)]),
    (SKY, 0.50, 0.013, [(0.045, 0.850), (0.085, 0.846), (0.115, 0.856)]),
    (SKY, 0.50, 0.034, [(0.095, 0.800), (0.100, 0.710)]),
    (SKY, 0.40, 0.020, [(0.020, 0.935), (0.080, 0.958)]),
    (NAVY, 0.40, 0.012, [(0.052, 0.745), (0.085, 0.722), (0.130, 0.726)]),
    (NAVY, 0.35, 0.010, [(0.062, 0.705), (0.090, 0.694), (0.120, 0.700)])))
_FOLDS_BACK = Strokes(Stroke(*row) for row in (
    (NAVY, 0.80, 0.018, [(0.030, 0.820), (0.080, 0.808), (0.140, 0.826)]),
    (NAVY, 0.45, 0.012, [(0.040, 0.792), (0.090, 0.778), (0.130, 0.790)]),
    (SKY, 0.60, 0.045, [(0.075, 0.915), (0.085, 0.880)]),
    (SKY, 0.35, 0.026, [(0.095, 0.765), (0.100, 0.710)]),
    (NAVY, 0.40, 0.012, [(0.030, 0.955), (0.070, 0.968), (0.110, 0.960)]),
    (NAVY, 0.40, 0.011, [(0.060, 0.720), (0.095, 0.702), (0.135, 0.712)])))


def over(tone, part, p, n):
    if part == "shoe":
        return _shoe(p, n)
    if part in ("trunk", "leg"):
        return _sock(_shorts(tone, p, n), part, p)
    return _band(tone, part, p)


def _lit(tone, light, dark, n):
    tone = mix(tone, light, 0.35 * max(0.0, 0.7 * n[1] + 0.5 * n[2]))
    return mix(tone, dark, 0.45 * max(0.0, -n[1]) + 0.25 * max(0.0, -n[2]))


def _shorts(tone, p, n):
    x, y, z = p
    hem = HEM + 0.10 * (x - 0.10) - 0.012 * (z > 0.0) * n[2]
    if y > WAIST + 0.004 or y < hem - 0.016:
        return tone
    if y < hem:  # the hem's shadow on the thigh
        return mix(tone, DEEP, 0.65 * smoothstep(hem - 0.016, hem, y))
    cloth = _lit(BLUE, SKY, NAVY, n)
    worn = noise(x * 2.0, y * 0.7, z * 2.0, 0.035)
    cloth = mix(cloth, NAVY, 0.16 * smoothstep(0.4, 0.9, worn))
    cloth = _FOLDS_FRONT.over(cloth, x, y, smoothstep(0.1, 0.5, n[2]))
    cloth = _FOLDS_BACK.over(cloth, x, y, smoothstep(0.1, 0.5, -n[2]))
    inner = smoothstep(0.045, 0.0, x) * smoothstep(0.93, 0.84, y)
    cloth = mix(cloth, NAVY, 0.7 * inner + 0.25 * max(0.0, -n[0]))
    if z < 0.0:  # between the buttocks
        cloth = mix(cloth, NAVY, 0.75 * smoothstep(0.022, 0.0, x) * smoothstep(0.985, 0.93, y))
    side = abs(z + 0.004) if n[0] > 0.35 else 1.0
    cloth = mix(ORANGE, cloth, smoothstep(0.0120, 0.0142, side))
    cloth = mix(CREAM, cloth, smoothstep(0.0018, 0.0038, abs(side - 0.0165)))
    for seam in (abs(x - 0.001) if y > 0.86 and n[0] < 0.5 else 1.0, abs(y - hem - 0.020), abs(y - WAIST + 0.036)):
        cloth = mix(NAVY, cloth, smoothstep(0.0006, 0.0020, seam))
    if y > WAIST - 0.034:  # waistband
        rib = 0.5 + 0.5 * math.sin(2.0 * math.pi * (math.atan2(z, x) / 0.045))
        cloth = mix(mix(CREAM, (176, 170, 164), 0.30 * rib), NAVY, 0.35 * max(0.0, -n[2]))
        cloth = mix(ORANGE, cloth, smoothstep(0.0040, 0.0052, abs(y - WAIST + 0.017)))
        cloth = mix(cloth, NAVY, 0.8 * smoothstep(0.0, 0.003, y - WAIST))
    return mix(NAVY, cloth, smoothstep(0.0, 0.0028, y - hem))


def _sock(tone, part, p):
    y, top = p[1], 0.180
    if part != "leg" or y > 0.194:
        return tone
    if y > top:
        return mix(tone, DEEP, 0.5 * smoothstep(0.194, top, y))
    return mix(_knit(p), SHADE, 0.4 * smoothstep(top - 0.003, top, y))


def _knit(p):
    x, y, z = p
    rib = 0.5 + 0.5 * math.sin(2.0 * math.pi * math.atan2(z + 0.027, x - 0.109) / 0.20)
    sock = mix(CREAM, (180, 176, 172), 0.45 * rib + 0.35 * smoothstep(0.14, 0.115, y))
    return mix(ORANGE, sock, smoothstep(0.0045, 0.0060, abs(y - 0.163)))


def _shoe(p, n):
    x, y, z = p
    tone = _lit(SHOE, (112, 118, 130), SHOE_DARK, n)
    tone = mix(tone, SHOE_DARK, 0.30 * smoothstep(0.5, 0.8, noise(x, y, z, 0.02)))
    toe = smoothstep(0.112, 0.118, z + 0.4 * (y - 0.03))
    tone = mix(tone, mix(SHOE_DARK, (86, 90, 100), max(0.0, n[1])), 0.85 * toe)
    tongue = abs(x - 0.112 - 0.05 * (z - 0.04))
    if 0.012 < z < 0.098 and n[1] > 0.25 and y > 0.040:
        tone = mix(SHOE_DARK, tone, smoothstep(0.010, 0.013, tongue))
        lace = abs((z - 0.02) / 0.0165 - round((z - 0.02) / 0.0165)) * 0.0165
        if tongue < 0.022:
            tone = mix(CREAM, tone, smoothstep(0.0028, 0.0042, lace))
    flash = abs(z + 0.9 * y - 0.058) if abs(n[0]) > 0.35 and 0.018 < y < 0.085 else 1.0
    tone = mix(ORANGE, tone, smoothstep(0.008, 0.0095, flash))
    tone = mix(ORANGE, tone, smoothstep(0.006, 0.008, abs(y - 0.088) + (0.0 if z < -0.045 else 1.0)))
    sole = 0.016 + 0.05 * max(0.0, -z - 0.03)
    tone = mix(SOLE, tone, smoothstep(sole, sole + 0.002, y))
    tone = mix(tone, SHOE_DARK, 0.6 * (1.0 - smoothstep(0.0008, 0.002, abs(y - sole - 0.0015))))
    tone = mix(tone, (70, 64, 62), smoothstep(-0.60, -0.85, n[1]))
    collar = 0.114 + 0.10 * max(0.0, z + 0.012)
    tone = mix(tone, SHOE_DARK, 0.8 * smoothstep(0.005, 0.001, abs(y - collar + 0.003)))
    return mix(tone, _knit(p), smoothstep(collar - 0.001, collar + 0.001, y))


def _band(tone, part, p):
    """A wrist band."""
    x, y, z = p
    t = arm_place(p)[0]
    if part != "arm" or not 0.452 < t < 0.536:
        return tone
    if t > 0.531:
        return mix(tone, DEEP, 0.45)
    tone = mix(tone, DEEP, 0.55 * smoothstep(0.452, 0.462, t))
    band = mix(BLUE, NAVY, 0.5 * noise(x, y, z, 0.004) + 0.3 * smoothstep(0.476, 0.464, t) + 0.3 * smoothstep(0.516, 0.530, t))
    band = mix(ORANGE, band, smoothstep(0.0046, 0.0066, abs(t - 0.496)))
    return mix(tone, band, smoothstep(0.4605, 0.4635, t))
