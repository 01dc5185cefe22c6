# assets/maker/limb.py: what moves a body by code: curves that loop, limbs of two bones, soles that do not slip.
import bisect
import math

from . import vec


class Loop:
    """A curve through keys (time, number or tuple) that repeats every `period`. Cubic, and between two keys never
    beyond them: equal neighbours hold still, extremes are eased into."""

    def __init__(self, period, keys):
        self.period = period
        self.times = [t for t, _ in keys]
        self.plain = not isinstance(keys[0][1], tuple)
        self.values = [(v,) if self.plain else v for _, v in keys]
        assert self.times == sorted(set(self.times)) and self.times[-1] - self.times[0] < period
        self.slopes = [self._slope(k) for k in range(len(keys))]

    def _step(self, k):
        """Time and values from key k to the next, round the end."""
        n = len(self.times)
        i, j = k % n, (k + 1) % n
        span = self.times[j] - self.times[i] if j > i else self.times[j] + self.period - self.times[i]
        return span, [b - a for a, b in zip(self.values[i], self.values[j])]

    def _slope(self, k):
        if len(self.times) == 1:
            return [0.0] * len(self.values[0])
        (h0, d0), (h1, d1) = self._step(k - 1), self._step(k)
        result = []
        for a, b in zip(d0, d1):
            before, after = a / h0, b / h1
            slope = (before * h1 + after * h0) / (h0 + h1)
            limit = 3.0 * min(abs(before), abs(after)) if before * after > 0.0 else 0.0
            result.append(max(-limit, min(limit, slope)))
        return result

    def __call__(self, time):
        t = (time - self.times[0]) % self.period + self.times[0]
        k = bisect.bisect_right(self.times, t) - 1
        j = (k + 1) % len(self.times)
        span, _ = self._step(k)
        if len(self.times) == 1:
            span = self.period
        found = hermite(self.values[k], self.slopes[k], self.values[j], self.slopes[j], span, t - self.times[k])
        return found[0] if self.plain else found


def hermite(p, p_slope, q, q_slope, span, t):
    """The cubic that leaves p with p_slope at 0 and reaches q with q_slope at `span`."""
    s = t / span
    a, b = s * s * (3.0 - 2.0 * s), s * (1.0 - s) * (1.0 - s)
    c = s * s * (s - 1.0)
    return tuple(x + (y - x) * a + span * (u * b + v * c) for x, u, y, v in zip(p, p_slope, q, q_slope))


def ease(t):
    """0 to 1 with neither speed nor acceleration at the ends."""
    t = min(1.0, max(0.0, t))
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0)


def bump(t):
    """0 at 0 and 1, 1 at the middle, gentle at all three."""
    return ease(2.0 * t) if t < 0.5 else ease(2.0 - 2.0 * t)


def mirror(q):
    """A rotation of the left side, seen in the mirror x -> -x."""
    return (q[0], -q[1], -q[2], q[3])


def between(a, b, t):
    """Rotation from a (t = 0) to b (t = 1), the short way round."""
    if sum(x * y for x, y in zip(a, b)) < 0.0:
        b = tuple(-c for c in b)
    q = vec.mix(a, b, t)
    n = math.sqrt(sum(c * c for c in q))
    return tuple(c / n for c in q)


def bend(upper, lower, axis, distance):
    """Degrees > 0 about the axis by which the second bone must turn for that reach; as near as it comes if it is out of
    reach."""
    axis = vec.unit(axis)
    along = vec.dot(upper, axis) * vec.dot(lower, axis)
    cosine = vec.dot(upper, lower) - along
    sine = vec.dot(upper, vec.cross(axis, lower))
    wanted = (distance * distance - vec.dot(upper, upper) - vec.dot(lower, lower)) / 2.0 - along
    ratio = max(-1.0, min(1.0, wanted / math.hypot(cosine, sine)))
    return math.degrees(math.atan2(sine, cosine) + math.acos(ratio))


def two_bones(upper, lower, axis, target, forward, rest_forward=(0.0, 0.0, 1.0)):
    """Rotations of both bones, the second relative to the first, that bring their end to `target` (from their root).
    The hinge turns only to the positive side about the axis; `rest_forward` of the bind pose comes to look towards
    `forward`."""
    hinge = vec.turn(axis, bend(upper, lower, axis, vec.length(target)))
    first = vec.shortest_arc(vec.add(upper, vec.rotate(hinge, lower)), target)
    pole = vec.unit(target)

    def across(v):
        return vec.unit(vec.sub(v, vec.scale(pole, vec.dot(v, pole))))

    is_at, should = across(vec.rotate(first, rest_forward)), across(forward)
    angle = math.atan2(vec.dot(vec.cross(is_at, should), pole), vec.dot(is_at, should))
    return vec.times(vec.turn(pole, math.degrees(angle)), first), hinge


class Sole:
    """What may touch the ground: points as skinning moves them, relative to the ankle, the toes hinged at `joint`."""

    def __init__(self, joint, points):
        """joint: from the ankle. points: [(from the ankle, share of the toes 0..1)], all in the bind pose."""
        self.joint, self.points = joint, points

    def touching(self, foot, toes):
        """The points under these rotations of foot and toes in the world, from the ankle."""
        joint = vec.rotate(foot, self.joint)
        result = []
        for p, share in self.points:
            as_toe = vec.add(joint, vec.rotate(toes, vec.sub(p, self.joint)))
            result.append(vec.mix(vec.rotate(foot, p), as_toe, share))
        return result

    def ankle_height(self, foot, toes):
        """Of the ankle while the lowest point is on the ground."""
        return -min(p[1] for p in self.touching(foot, toes))

    def roll(self, states, flat):
        """Ankles of a foot that rolls on the ground without slipping through these (foot, toes). At state `flat` the
        ankle is above the origin."""
        points = [self.touching(*state) for state in states]
        low = [min(range(len(p)), key=lambda k: p[k][1]) for p in points]
        result = [None] * len(states)
        x, z = 0.0, 0.0
        for order in (range(flat, len(states)), range(flat, -1, -1)):
            for k in order:
                if k == flat:
                    x, z = 0.0, 0.0
                else:
                    last = k - order.step
                    on = low[min(k, last)]
                    x += points[last][on][0] - points[k][on][0]
                    z += points[last][on][2] - points[k][on][2]
                result[k] = (x, -points[k][low[k]][1], z)
        return result
