# assets/maker/horse/gait.py: what a leg does in one cycle, counted from the moment its hoof strikes.
import bisect


class Curve:
    """A smooth closed curve through (phase, value), phases in 0..1; it never overshoots its points."""

    def __init__(self, *points):
        self.points = points
        count = len(points)
        slopes = []
        for k in range(count):
            (p0, v0), (p1, v1) = points[k], points[(k + 1) % count]
            slopes.append((v1 - v0) / (p1 - p0 + (1.0 if k + 1 == count else 0.0)))
        self.tangents = [2.0 * a * b / (a + b) if a * b > 0.0 else 0.0 for a, b in zip([slopes[-1]] + slopes, slopes)]

    def __call__(self, phase):
        phase %= 1.0
        k = bisect.bisect_right([p for p, _ in self.points], phase) - 1
        following = (k + 1) % len(self.points)
        (p0, v0), (p1, v1) = self.points[k], self.points[following]
        start = p0 - (1.0 if k < 0 else 0.0)
        width = (p1 - start) % 1.0 or 1.0
        t = ((phase - start) % 1.0) / width
        return _hermite(t, v0, self.tangents[k] * width, v1, self.tangents[following] * width)


def _hermite(t, v0, m0, v1, m1):
    a, b = t * t, t * t * t
    return (2 * b - 3 * a + 1) * v0 + (b - 2 * a + t) * m0 + (3 * a - 2 * b) * v1 + (b - a) * m1


class Step:
    """One kind of leg in one gait. duty: part of the cycle on the ground; ahead: where the hoof strikes, metres before its
    place in the bind pose; travel: metres the ground carries it back; carry: how much of the ground's speed it keeps when it
    leaves and has when it strikes. Curves: lift of the toe (metres), roll of the hoof (degrees, heel up > 0), pastern
    (degrees, sunk < 0), knee (degrees), blade (the scapula's, or nothing for a hind leg)."""

    def __init__(self, duty, ahead, travel, carry, **curves):
        self.duty, self.ahead, self.travel, self.carry = duty, ahead, travel, carry
        self.curves = {name: Curve(*points) for name, points in curves.items()}

    def forward(self, phase):
        """Metres before the bind pose's place. Steady on the ground."""
        behind = self.ahead - self.travel
        if phase < self.duty:
            return self.ahead - self.travel * phase / self.duty
        t = (phase - self.duty) / (1.0 - self.duty)
        ground = -self.travel * (1.0 - self.duty) / self.duty
        return _hermite(t, behind, ground * self.carry[0], self.ahead, ground * self.carry[1])

    def value(self, name, phase):
        return self.curves[name](phase) if name in self.curves else 0.0


WALK_DUTY, GALLOP_DUTY = 0.625, 0.25  # a whole number of keys, so that no key mixes standing and swinging

WALK_FORE = Step(
    WALK_DUTY, 0.43, 0.88, (0.45, 0.70),
    lift=((0.0, 0.0), (WALK_DUTY, 0.0), (0.70, 0.060), (0.79, 0.115), (0.91, 0.055), (0.979, 0.026)),
    roll=((0.0, 0.0), (0.46, 0.0), (0.56, 14.0), (WALK_DUTY, 38.0), (0.71, 76.0), (0.80, 52.0), (0.93, -8.0)),
    pastern=((0.0, 2.0), (0.15, -9.0), (0.36, -14.0), (0.50, 2.0), (WALK_DUTY, 42.0), (0.71, 76.0), (0.82, 48.0),
             (0.93, 0.0)),
    knee=((0.0, 0.0), (0.54, 0.0), (WALK_DUTY, 14.0), (0.77, 62.0), (0.92, 6.0)),
    blade=((0.0, -8.0), (0.30, 0.0), (0.58, 9.0), (0.80, -2.0)))
WALK_HIND = Step(
    WALK_DUTY, 0.44, 0.88, (0.45, 0.70),
    lift=((0.0, 0.0), (WALK_DUTY, 0.0), (0.70, 0.045), (0.80, 0.085), (0.92, 0.040), (0.979, 0.026)),
    roll=((0.0, 0.0), (0.46, 0.0), (0.56, 14.0), (WALK_DUTY, 36.0), (0.71, 60.0), (0.82, 32.0), (0.94, -8.0)),
    pastern=((0.0, 2.0), (0.15, -8.0), (0.36, -12.0), (0.50, 4.0), (WALK_DUTY, 38.0), (0.71, 56.0), (0.83, 28.0),
             (0.94, 0.0)))

GALLOP_FORE = Step(
    GALLOP_DUTY, 0.52, 1.02, (0.10, 0.45),
    lift=((0.0, 0.0), (GALLOP_DUTY, 0.0), (0.31, 0.12), (0.42, 0.36), (0.56, 0.48), (0.72, 0.40), (0.86, 0.21),
          (0.95, 0.075), (0.969, 0.045)),
    roll=((0.0, 0.0), (0.15, 0.0), (0.20, 15.0), (GALLOP_DUTY, 42.0), (0.37, 108.0), (0.52, 138.0), (0.68, 104.0),
          (0.83, 30.0), (0.94, -8.0)),
    pastern=((0.0, 4.0), (0.05, -10.0), (0.12, -25.0), (0.19, 4.0), (GALLOP_DUTY, 44.0), (0.37, 100.0), (0.52, 128.0),
             (0.68, 96.0), (0.83, 28.0), (0.94, 0.0)),
    knee=((0.0, 0.0), (0.20, 0.0), (GALLOP_DUTY, 14.0), (0.39, 78.0), (0.54, 104.0), (0.70, 68.0), (0.86, 10.0),
          (0.94, 0.0)),
    blade=((0.0, -12.0), (0.12, 0.0), (0.25, 14.0), (0.50, 2.0), (0.80, -16.0)))
GALLOP_HIND = Step(
    GALLOP_DUTY, 0.54, 1.02, (0.10, 0.45),
    lift=((0.0, 0.0), (GALLOP_DUTY, 0.0), (0.31, 0.07), (0.42, 0.18), (0.58, 0.23), (0.74, 0.18), (0.88, 0.09),
          (0.95, 0.055), (0.969, 0.040)),
    roll=((0.0, 0.0), (0.15, 0.0), (0.20, 15.0), (GALLOP_DUTY, 42.0), (0.37, 82.0), (0.54, 60.0), (0.72, 28.0),
          (0.87, 4.0), (0.94, -8.0)),
    pastern=((0.0, 4.0), (0.05, -10.0), (0.12, -23.0), (0.19, 4.0), (GALLOP_DUTY, 44.0), (0.37, 76.0), (0.54, 54.0),
             (0.72, 24.0), (0.87, 6.0), (0.94, 2.0)))
