# assets/maker/humanoid/paint_head.py: face and hair.
import math

from .paint_marks import DEEP, LIGHT, RED, SHADE
from .paint_tools import Stroke, mix, noise, smoothstep, spot

HAIR, HAIR_LIGHT, HAIR_DARK = (70, 48, 35), (104, 74, 52), (50, 35, 27)
WHITE, IRIS, IRIS_LIGHT, INK = (236, 230, 222), (52, 92, 120), (112, 158, 178), (26, 20, 22)
LIP, LIP_DARK, BEARD = (190, 120, 104), (100, 52, 46), (146, 116, 106)

EYE, EYE_HALF = (0.0325, 1.6865), 0.0152
_EAR_FRONT = Stroke(DEEP, 1.0, 0.0045, [(-0.005, 1.655), (-0.007, 1.675), (-0.011, 1.704)])
_EAR_RIM = Stroke(DEEP, 1.0, 0.0040, [(-0.013, 1.702), (-0.026, 1.700), (-0.030, 1.690), (-0.022, 1.674)])
_FOLD = Stroke(SHADE, 0.22, 0.0060, [(0.021, 1.640), (0.030, 1.628), (0.035, 1.612)])


def over(tone, part, p, n):
    x, y, z = p
    if part == "neck":
        under = smoothstep(1.52, 1.555, y) * smoothstep(-0.03, 0.03, z)
        tone = mix(tone, BEARD, 0.20 * _beard(x, y, z) * smoothstep(1.525, 1.56, y))
        return _hair(mix(tone, SHADE, 0.40 * under), p, n)
    below = smoothstep(0.35, 0.80, -n[1])  # the underside of the chin
    tone = mix(tone, BEARD, (0.42 - 0.22 * below) * _beard(x, y, z))
    front = smoothstep(0.10, 0.40, n[2]) * smoothstep(0.02, 0.04, z)
    if front > 0.0:
        tone = mix(tone, _face(tone, x, y), front)
    tone = _ear(tone, p)
    return _hair(tone, p, n)


def _face(tone, x, y):
    tone = mix(tone, RED, 0.16 * spot(x, y, 0.042, 1.650, 0.024, 0.018))       # cheek
    tone = mix(tone, LIGHT, 0.40 * spot(x, y, 0.044, 1.664, 0.018, 0.009))
    tone = mix(tone, SHADE, 0.26 * spot(x, y, 0.050, 1.630, 0.018, 0.028))     # below the cheekbone
    tone = mix(tone, SHADE, 0.62 * spot(x, y, 0.024, 1.6945, 0.020, 0.010))    # socket
    tone = mix(tone, SHADE, 0.40 * spot(x, y, 0.014, 1.690, 0.009, 0.018))
    tone = mix(tone, SHADE, 0.30 * spot(x, y, 0.031, 1.6755, 0.020, 0.007))
    tone = mix(tone, LIGHT, 0.45 * spot(x, y, 0.0, 1.672, 0.0055, 0.030))      # bridge of the nose
    tone = mix(tone, SHADE, 0.42 * spot(x, y, 0.0135, 1.662, 0.007, 0.022))
    tone = mix(tone, RED, 0.38 * spot(x, y, 0.0, 1.650, 0.017, 0.010))
    tone = mix(tone, LIGHT, 0.40 * spot(x, y, 0.0, 1.6535, 0.006, 0.005))
    tone = mix(tone, SHADE, 0.42 * spot(x, y, 0.0190, 1.6450, 0.0055, 0.010))   # beside the nostril
    tone = mix(tone, SHADE, 0.55 * spot(x, y, 0.0, 1.6385, 0.020, 0.009))      # below the nose
    tone = mix(tone, INK, 0.80 * spot(x, y, 0.0078, 1.6432, 0.0052, 0.0030))
    tone = mix(tone, SHADE, _FOLD.share(x, y))
    tone = mix(tone, LIGHT, 0.32 * spot(x, y, 0.016, 1.724, 0.030, 0.016))     # forehead
    tone = mix(tone, LIGHT, 0.36 * spot(x, y, 0.0, 1.581, 0.016, 0.012))       # chin
    tone = _mouth(tone, x, y)
    tone = _eye(tone, x, y)
    return _brow(tone, x, y)


def _mouth(tone, x, y):
    half = 0.0265
    if x > half + 0.006 or not 1.590 < y < 1.630:
        return tone
    s = min(1.0, abs(x) / half)
    line = 1.6118 + 0.0012 * s * s + 0.0004 * spot(x, y, 0.009, 1.612, 0.007, 0.01)
    upper = line + 0.0068 * (1.0 - s ** 1.6) - 0.0016 * max(0.0, 1.0 - x / 0.006)
    lower = line - 0.0100 * (1.0 - s * s) ** 0.8
    tone = mix(tone, SHADE, 0.60 * spot(x, y, 0.0, 1.5995, 0.018, 0.0048))     # below the lower lip
    soft = 0.0009
    inside = smoothstep(lower - soft, lower + soft, y) * (1.0 - smoothstep(upper - soft, upper + soft, y))
    inside *= 1.0 - smoothstep(0.94, 1.02, x / half)
    lip = LIP if y < line else mix(LIP, LIP_DARK, 0.24)
    lip = mix(lip, LIGHT, 0.40 * spot(x, y, 0.004, line - 0.0048, 0.012, 0.0026))
    tone = mix(tone, lip, 0.70 * inside)
    parting = (1.0 - smoothstep(0.0006, 0.0019, abs(y - line))) * (1.0 - smoothstep(0.96, 1.06, x / half))
    tone = mix(tone, LIP_DARK, 0.88 * parting)
    return mix(tone, SHADE, 0.5 * spot(x, y, half + 0.0008, line, 0.0042, 0.0042))


def _eye(tone, x, y):
    cx, cy = EYE
    s = (x - cx) / EYE_HALF
    if abs(s) > 1.35 or abs(y - cy) > 0.020:
        return tone
    r = max(0.0, 1.0 - s * s)
    tilt = 0.0012 * s
    upper = cy + tilt + 0.0061 * r ** 0.72
    lower = cy + tilt - 0.0046 * r ** 0.85
    crease = cy + tilt + 0.0028 + 0.0082 * max(0.0, 1.0 - (s / 1.2) ** 2) ** 0.7
    tone = mix(tone, DEEP, 0.55 * (1.0 - smoothstep(0.0004, 0.0016, abs(y - crease))) * smoothstep(1.2, 0.9, abs(s)))
    if abs(s) < 1.0 and lower < y < upper:
        tone = _ball(x - cx - 0.0004, y - cy - 0.0009, upper - y)
    if abs(s) < 1.06:
        fade = 1.0 - smoothstep(0.98, 1.06, abs(s))
        thick = 0.0012 + 0.0007 * max(0.0, s)
        tone = mix(tone, INK, 0.92 * fade * (1.0 - smoothstep(0.5 * thick, 1.3 * thick, abs(y - upper))))
        tone = mix(tone, DEEP, 0.60 * fade * (1.0 - smoothstep(0.0003, 0.0012, abs(y - lower))))
    return mix(tone, RED, 0.5 * spot(x, y, cx - EYE_HALF, cy - 0.0008, 0.0026, 0.0022))


def _ball(dx, dy, below_lid):
    d = math.hypot(dx, dy)
    tone = mix((204, 186, 178), WHITE, smoothstep(0.013, 0.007, abs(dx)))
    if d < 0.0066:
        iris = mix(IRIS, IRIS_LIGHT, smoothstep(0.001, -0.005, dy) * 0.8)
        iris = mix(iris, INK, 0.75 * smoothstep(0.0047, 0.0061, d))
        iris = mix(INK, iris, smoothstep(0.0024, 0.0031, d))
        tone = mix(iris, tone, smoothstep(0.0060, 0.0066, d))
    tone = mix(tone, (70, 52, 50), 0.60 * (1.0 - smoothstep(0.0, 0.0036, below_lid)))
    glint = math.hypot(dx + 0.0018, dy - 0.0022)
    return mix((255, 255, 255), tone, smoothstep(0.0009, 0.0017, glint))


def _brow(tone, x, y):
    if not 0.008 < x < 0.060 or not 1.692 < y < 1.722:
        return tone
    s = (x - 0.0115) / 0.044  # 0 inside, 1 outside
    if not 0.0 < s < 1.0:
        return tone
    middle = 1.7008 + 0.0068 * math.sin(math.pi * min(1.0, 0.78 * s + 0.06)) - 0.0035 * s
    thick = 0.0045 * (1.0 - 0.70 * s) * smoothstep(0.0, 0.10, s) + 0.0005
    hairs = 0.75 + 0.5 * noise(x * 3.0 + 1.3 * y, y * 1.1, 0.0, 0.0028)
    away = abs(y - middle) / (thick * hairs)
    return mix(tone, HAIR_DARK, 0.86 * (1.0 - smoothstep(0.55, 1.15, away)) * (1.0 - smoothstep(0.85, 1.0, s)))


def _beard(x, y, z):
    """A shaved beard's shade: jaw, chin and round the mouth."""
    top = 1.622 + 0.5 * max(0.0, 0.060 - z) - 0.010 * smoothstep(0.020, 0.006, x)
    low = smoothstep(0.006, -0.010, y - min(top, 1.664))
    return low * smoothstep(-0.010, 0.010, z)


def _ear(tone, p):
    x, y, z = p
    if x < 0.066 or not 1.645 < y < 1.722 or not -0.048 < z < 0.004:
        return tone
    tone = mix(tone, RED, 0.30 * smoothstep(0.0735, 0.080, x))
    tone = mix(tone, SHADE, 0.60 * spot(z, y, -0.017, 1.681, 0.011, 0.020))          # the shell
    tone = mix(tone, DEEP, 0.55 * spot(z, y, -0.011, 1.676, 0.006, 0.008))           # the hole
    tone = mix(tone, DEEP, 0.45 * _EAR_FRONT.share(z, y) + 0.35 * _EAR_RIM.share(z, y))
    return mix(tone, LIGHT, 0.35 * spot(z, y, -0.034, 1.696, 0.006, 0.012))


# The hair's lower edge: forward -> height; temples, burns before the ear, round the ear, nape.
_EDGE = [(-0.110, 1.606), (-0.080, 1.610), (-0.064, 1.628), (-0.050, 1.664), (-0.042, 1.704), (-0.008, 1.704), (-0.001, 1.668),
         (0.018, 1.672), (0.026, 1.704), (0.034, 1.716), (0.044, 1.738), (0.054, 1.752), (0.064, 1.755), (0.100, 1.748)]


def _edge(z):
    for (z0, y0), (z1, y1) in zip(_EDGE, _EDGE[1:]):
        if z < z1:
            return y0 + (y1 - y0) * max(0.0, (z - z0) / (z1 - z0))
    return _EDGE[-1][1]


def _hair(tone, p, n):
    x, y, z = p
    ragged = 0.006 * (noise(x * 1.5, y * 0.8, z * 1.5, 0.004) - 0.5)
    height = y - _edge(z) + ragged
    if height < -0.004 or x > 0.0800:
        return tone
    on_top = smoothstep(0.35, 0.75, n[1])
    strands = noise(x * 1.4, y * 0.30, z * 1.4, 0.0030) * (1.0 - on_top) + noise(x * 1.4, y * 0.5, z * 0.35, 0.0030) * on_top
    strands = 0.55 * strands + 0.45 * noise(x, y, z, 0.012)
    hair = mix(HAIR_DARK, HAIR, smoothstep(0.25, 0.65, strands))
    hair = mix(hair, HAIR_LIGHT, 0.55 * smoothstep(0.5, 0.85, strands) * smoothstep(0.2, 0.9, n[1]))
    hair = mix(hair, HAIR_DARK, 0.45 * max(0.0, -n[1]) + 0.25 * smoothstep(0.030, 0.0, height))
    short = 0.70 + 0.30 * smoothstep(0.0, 0.030, height)  # cropped at the sides
    return mix(tone, hair, short * smoothstep(-0.003, 0.004, height))
