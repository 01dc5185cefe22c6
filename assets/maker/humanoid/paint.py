# assets/maker/humanoid/paint.py: the humanoid's colours as a function of space: skin, and who paints what lies over it.
import math

from . import paint_clothes, paint_head
from . import paint_marks as marks
from .paint_marks import DEEP, LIGHT, RED, SHADE, arm_place
from .paint_tools import mix, noise, smoothstep

SIZE = 1024  # texels
SKIN, COOL, NAIL = (214, 160, 128), (186, 146, 128), (236, 196, 178)


def colour(part, p, normal):
    """RGB at a point of the left half in the bind pose."""
    tone = _skin(part, p, normal)
    if part in ("head", "neck"):
        tone = paint_head.over(tone, part, p, normal)
    else:
        tone = paint_clothes.over(tone, part, p, normal)
    return tuple([int(c / 3.0 + 0.5) * 3 for c in tone])


def _skin(part, p, n):
    x, y, z = p
    tone = mix(SKIN, RED, 0.22 * smoothstep(0.35, 0.85, noise(x, y, z, 0.10)))
    tone = mix(tone, COOL, 0.35 * smoothstep(0.45, 0.9, noise(z, x, y, 0.07)))
    tone = mix(tone, LIGHT, 0.42 * max(0.0, 0.75 * n[1] + 0.45 * n[2]))  # a soft light from above and in front
    tone = mix(tone, SHADE, 0.40 * max(0.0, -n[1]) + 0.16 * max(0.0, -n[2]))
    if part in ("trunk", "neck", "arm"):
        tone = marks.FRONT.over(tone, x, y, smoothstep(0.0, 0.4, n[2]))
        tone = marks.BACK.over(tone, x, y, smoothstep(0.0, 0.4, -n[2]))
        tone = mix(tone, SHADE, 0.6 * smoothstep(0.055, 0.0, math.dist(p, (0.182, 1.352, -0.012))))
    if part == "leg":
        tone = marks.LEG_FRONT.over(tone, x, y, smoothstep(0.1, 0.5, n[2]))
        tone = marks.LEG_BACK.over(tone, x, y, smoothstep(0.1, 0.5, -n[2]))
        tone = marks.LEG_OUTSIDE.over(tone, z, y, smoothstep(0.3, 0.7, n[0]))
        tone = marks.LEG_INSIDE.over(tone, z, y, smoothstep(0.3, 0.7, -n[0]))
    if part in ("arm", "hand") or (part == "trunk" and x > 0.10 and y > 1.28):
        tone = _arm(tone, part, p, n)
    return tone


def _arm(tone, part, p, n):
    t, up, forward = arm_place(p)
    lift = 0.7071 * (n[0] + n[1])
    if part != "hand":
        tone = marks.ARM_FRONT.over(tone, t, up, smoothstep(0.2, 0.6, n[2]))
        tone = marks.ARM_BACK.over(tone, t, up, smoothstep(0.2, 0.6, -n[2]))
        return marks.ARM_TOP.over(tone, t, forward, smoothstep(0.3, 0.7, lift))
    tone = mix(tone, RED, 0.30 * smoothstep(0.58, 0.70, t))
    return _fingers(tone, t, forward, lift)


def _fingers(tone, t, forward, lift):
    """Lines between the fingers, knuckles, nails; `forward` runs from the little finger to the index."""
    for gap, start in ((0.0005, 0.636), (-0.0155, 0.630)):
        d = abs(forward - gap) / 0.0036
        if d < 1.0 and t > start - 0.02:
            tone = mix(tone, DEEP, 0.75 * (1.0 - d * d) * smoothstep(start - 0.02, start + 0.02, t))
    for middle in (0.028, 0.0085, -0.0075, -0.0235):
        knuckle = math.hypot(t - 0.632, forward - middle) / 0.009
        bend = math.hypot(0.8 * (t - 0.676), forward - middle) / 0.007
        if lift > 0.2 and min(knuckle, bend) < 1.0:
            tone = mix(tone, LIGHT if knuckle < 1.0 else SHADE, 0.35 * (1.0 - min(knuckle, bend)))
        nail = max(abs(forward - middle) / 0.0058, abs(t - 0.712 + 0.008 * (middle < -0.01)) / 0.0075)
        if lift > 0.1:
            tone = mix(tone, NAIL, 0.8 * smoothstep(1.0, 0.8, nail))
    thumb = math.hypot((t - 0.652) / 0.009, (forward - 0.076) / 0.0065)
    return mix(tone, NAIL, 0.7 * smoothstep(1.0, 0.8, thumb)) if lift > 0.1 else tone
