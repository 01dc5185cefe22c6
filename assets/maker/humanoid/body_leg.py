# assets/maker/humanoid/body_leg.py: crotch, leg and shoe of the left half.
from . import weights

CROTCH = {"front": (0.024, 0.866, 0.056), "back": (0.024, 0.846, -0.066), "inner": (0.018, 0.842, -0.006),
          "middle": (0.0, 0.858, -0.012)}

# Rings of six points: inner front, outer front, outer, outer back, inner back, inner.
LEG = [
    ("thigh", [(0.056, 0.785, 0.090), (0.128, 0.792, 0.090), (0.180, 0.795, -0.002), (0.142, 0.790, -0.102),
               (0.060, 0.782, -0.098), (0.017, 0.780, -0.004)]),
    ("above knee", [(0.074, 0.570, 0.073), (0.130, 0.580, 0.070), (0.165, 0.578, 0.006), (0.131, 0.568, -0.054),
                    (0.077, 0.562, -0.056), (0.040, 0.560, 0.002)]),
    ("knee", [(0.082, 0.497, 0.066), (0.126, 0.497, 0.064), (0.153, 0.497, 0.004), (0.127, 0.490, -0.044),
              (0.081, 0.488, -0.046), (0.051, 0.493, 0.004)]),
    ("calf", [(0.084, 0.430, 0.052), (0.120, 0.430, 0.052), (0.163, 0.402, -0.014), (0.133, 0.368, -0.082),
              (0.079, 0.360, -0.084), (0.046, 0.380, -0.018)]),
    ("ankle", [(0.092, 0.150, 0.002), (0.124, 0.148, 0.000), (0.143, 0.108, -0.027), (0.119, 0.118, -0.066),
               (0.097, 0.120, -0.066), (0.075, 0.118, -0.025)]),
]

SHOE = {
    "heel in": (0.089, 0.000, -0.084), "heel out": (0.132, 0.000, -0.082), "ball out": (0.166, 0.000, 0.092),
    "toe out": (0.144, 0.010, 0.154), "toe in": (0.094, 0.010, 0.172), "toe top": (0.117, 0.047, 0.146),
    "ball in": (0.074, 0.000, 0.108), "arch": (0.087, 0.008, 0.015), "top in": (0.094, 0.066, 0.084),
    "top out": (0.138, 0.054, 0.078),
}
ROWS = [80, 180, 52, 70, 160]  # texels


def leg(cage, hip):
    """Grows from the front, side and back of the ring at the hip."""
    v = {name: cage.vertex(p, weights.CROTCH[name]) for name, p in CROTCH.items()}
    cage.single([hip[0], v["middle"], v["inner"], v["front"]], "trunk", 20)
    cage.single([v["middle"], hip[4], v["back"], v["inner"]], "trunk", 20)
    cage.single([hip[0], v["front"], hip[1]], "trunk", 20)
    cage.single([hip[3], v["back"], hip[4]], "trunk", 20)
    rings = [[v["front"], hip[1], hip[2], hip[3], v["back"], v["inner"]]]
    for name, points in LEG:
        rings.append([cage.vertex(p, w) for p, w in zip(points, weights.LEG[name])])
    cage.tube([ring[::-1] for ring in rings], "leg", closed=True, pixels=52, heights=ROWS)
    _shoe(cage, rings[-1])


def _shoe(cage, ankle):
    v = {name: cage.vertex(p, weights.SHOE[name]) for name, p in SHOE.items()}
    for number, name in enumerate(("front in", "front out", "out", "back out", "back in", "in")):
        v["ankle " + name] = ankle[number]
    for corners, pixels in (
            ("ankle back in, ankle back out, heel out, heel in", 40),
            ("ankle back out, ankle out, heel out", 40),
            ("ankle in, ankle back in, heel in, arch", 40),
            ("ankle front out, top out, ball out, ankle out", 44),
            ("ankle out, ball out, heel out", 44),
            ("top in, ankle front in, ankle in, arch", 44),
            ("top in, arch, ball in", 36),
            ("ankle front in, top in, top out, ankle front out", 72),
            ("top in, toe in, toe top", 44),
            ("top in, toe top, top out", 44),
            ("top out, toe top, toe out", 44),
            ("toe top, toe in, toe out", 44),
            ("top out, toe out, ball out", 36),
            ("top in, ball in, toe in", 36),
            ("heel in, heel out, arch", 36),
            ("arch, heel out, ball out, ball in", 36),
            ("ball in, ball out, toe out, toe in", 36)):
        cage.single([v[name] for name in corners.split(", ")], "shoe", pixels)
