# assets/maker/horse/solve.py: legs bent so that hoofs stand where they are told to.
from .. import vec
from .skeleton import ORIGIN

UPRIGHT = (1, 0, 0)  # legs bend about this axis; a positive turn takes the lower end back


def flip(q):
    """A rotation of the left side, seen in the mirror x -> -x."""
    return (q[0], -q[1], -q[2], q[3])


def pitch(degrees):
    return vec.turn(UPRIGHT, degrees)


def bone(upper, lower):
    """From one joint to the next in the bind pose, left side."""
    return vec.sub(ORIGIN[lower + ".L"], ORIGIN[upper + ".L"])


def place(above, where, origin, joint):
    """World place of a left joint carried by a bone that stands at `where`, turned by `above`."""
    return vec.add(where, vec.rotate(above, vec.sub(ORIGIN[joint + ".L"], origin)))


class Chain:
    """Three bones in a row. bends(angle) -> degrees of the second and third; their straightness grows with the angle."""

    def __init__(self, names, low, high):
        self.names, self.low, self.high = names, low, high
        self.first, self.second, self.third = (bone(a, b) for a, b in zip(names, names[1:]))

    def tip(self, bends):
        """Where the chain ends, from its first joint, when only the lower two bones turn."""
        second, third = bends
        lower = vec.add(self.second, vec.rotate(pitch(third), self.third))
        return vec.add(self.first, vec.rotate(pitch(second), lower))

    def solve(self, above, where, target, bends):
        """([local rotation x 3], metres that the target is out of reach)."""
        wanted = vec.rotate(vec.inverse(above), vec.sub(target, where))
        reach = vec.length(wanted)
        low, high = self.low, self.high
        for _ in range(50):
            angle = (low + high) / 2.0
            if vec.length(self.tip(bends(angle))) > reach:
                high = angle
            else:
                low = angle
        tip = self.tip(bends(low))
        first = vec.shortest_arc(tip, wanted)
        second, third = bends(low)
        return [first, pitch(second), pitch(third)], abs(vec.length(tip) - reach)


# Stretching opens the elbow; the knee bends as it is told.
FORELEG = Chain(("upper_arm", "forearm", "cannon_front", "pastern_front"), -100.0, 36.0)
# Stifle and hock open and close together, as a horse's must.
HIND_LEG = Chain(("thigh", "shin", "cannon_hind", "pastern_hind"), -95.0, 33.0)


def hock_with_stifle(angle):
    return (-angle, angle)


def knee(flexed):
    return lambda angle: (angle, flexed)


def hoof(kind, dz, dy, turned, sole):
    """World place of the hoof's joint. dz, dy: the sole's place against the bind pose; turned > 0: heel up, about the
    toe; < 0: toe up, about the heel. sole: (toe z, heel z)."""
    joint = ORIGIN[kind + ".L"]
    pivot = (joint[0], 0.0, sole[0] if turned > 0.0 else sole[1])
    arm = vec.sub(joint, pivot)
    return vec.add(vec.add(pivot, (0.0, dy, dz)), vec.rotate(pitch(turned), arm))
