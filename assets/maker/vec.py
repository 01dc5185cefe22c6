# assets/maker/vec.py: vectors as 3-tuples and quaternions as (x, y, z, w).
import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    n = length(a)
    return scale(a, 1.0 / n) if n > 0.0 else a


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smoothstep(low, high, x):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3.0 - 2.0 * t)


IDENTITY = (0.0, 0.0, 0.0, 1.0)


def turn(axis, degrees):
    """Quaternion of a rotation about an axis."""
    half = math.radians(degrees) / 2.0
    x, y, z = scale(unit(axis), math.sin(half))
    return (x, y, z, math.cos(half))


def euler(x=0.0, y=0.0, z=0.0):
    """Degrees about the fixed axes: first z, then x, then y."""
    return times(turn((0, 1, 0), y), times(turn((1, 0, 0), x), turn((0, 0, 1), z)))


def times(a, b):
    """b first, then a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
            aw * bw - ax * bx - ay * by - az * bz)


def inverse(q):
    return (-q[0], -q[1], -q[2], q[3])


def rotate(q, v):
    u = q[:3]
    t = scale(cross(u, v), 2.0)
    return add(add(v, scale(t, q[3])), cross(u, t))


def shortest_arc(a, b):
    """The smallest rotation that takes direction a to direction b (not opposite)."""
    a, b = unit(a), unit(b)
    c = cross(a, b)
    q = (c[0], c[1], c[2], 1.0 + dot(a, b))
    n = math.sqrt(sum(k * k for k in q))
    return tuple(k / n for k in q)
