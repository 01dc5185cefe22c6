# assets/maker/humanoid/motion_walk.py: the walk: heel strike, foot flat, heel off on bent toes, swing; 1.25 m/s.
import math

from .. import limb, vec
from ..clip import Clip
from . import motion_figure as figure

CYCLE = 1.1      # seconds
KEYS = 66
SPEED = 1.25     # metres a second; a planted foot goes back by so much
STANCE = 0.62    # part of the cycle a foot stands
FINE = 1240      # steps of the roll's table in one stance
AHEAD = 0.315    # of the hips: where a foot would stand flat when it strikes
OUT, YAW = 0.072, 7.0   # metres from the middle, degrees outwards

# Degrees against the foot's own cycle, which starts with its heel strike. Heel up > 0.
PITCH = limb.Loop(1.0, [(0.0, -20.0), (0.085, 0.0), (0.30, 0.0), (0.42, 14.0), (0.52, 33.0), (STANCE, 60.0),
                        (0.67, 66.0), (0.76, 44.0), (0.86, 4.0), (0.93, -17.0), (0.97, -21.0)])
TOES = limb.Loop(1.0, [(0.0, -22.0), (0.085, 0.0), (0.50, 0.0), (STANCE, 28.0), (0.68, 46.0), (0.78, 30.0),
                       (0.88, -4.0), (0.95, -24.0)])


def _turned(phase):
    yaw = vec.turn((0, 1, 0), YAW)
    return tuple(vec.times(yaw, vec.turn((1, 0, 0), curve(phase))) for curve in (PITCH, TOES))


_STATES = [_turned(STANCE * k / FINE) for k in range(FINE + 1)]
_ROLLED = figure.SOLE.roll(_STATES, int(0.2 / STANCE * FINE))


def _stance(phase):
    """Ankle in the stance, hips at x = z = 0."""
    at = min(max(phase / STANCE, 0.0), 1.0) * FINE
    k = min(int(at), FINE - 1)
    x, y, z = vec.mix(_ROLLED[k], _ROLLED[k + 1], at - k)
    return (OUT + x, y, z + AHEAD - SPEED * CYCLE * phase)


def _swing():
    """The ankle's way through the air, from the stance's end to the next one's start: in step with the ground
    at both, but up and down faster than the sole rolls."""
    def speed(phase, step):
        return vec.scale(vec.sub(_stance(phase + step), _stance(phase)), 1.0 / step)

    leave, strike = _stance(STANCE), _stance(0.0)
    keys = [(STANCE, leave), (0.70, (OUT + 0.006, 0.263, -0.325)), (0.80, (OUT + 0.004, 0.190, 0.055)),
            (0.89, (OUT, 0.124, 0.262)), (0.952, (OUT - 0.002, 0.108, 0.304)), (1.0, strike)]
    slopes = [vec.add(speed(STANCE, -0.004), (0.0, 0.20, 0.0))]
    for (t0, p0), (t1, p1), (t2, p2) in zip(keys, keys[1:], keys[2:]):
        slopes.append(tuple(((b - a) / (t1 - t0) * (t2 - t1) + (c - b) / (t2 - t1) * (t1 - t0)) / (t2 - t0)
                            for a, b, c in zip(p0, p1, p2)))
    slopes.append(vec.sub(speed(0.0, 0.004), (0.0, 0.24, 0.0)))
    return keys, slopes


_AIR = _swing()


def ankle(phase):
    if phase < STANCE:
        return _stance(phase)
    keys, slopes = _AIR
    k = max(i for i, (t, _) in enumerate(keys[:-1]) if t <= phase)
    (t0, p), (t1, q) = keys[k], keys[k + 1]
    return limb.hermite(p, slopes[k], q, slopes[k + 1], t1 - t0, phase - t0)


def _wave(phase, offset=0.0):
    return math.sin(2.0 * math.pi * (phase + offset))


# Lowest soon after a strike, highest over the standing leg.
HEIGHT = limb.Loop(0.5, [(0.035, -0.049), (0.15, -0.030), (0.285, -0.015), (0.40, -0.031)])
FOREARM = limb.Loop(1.0, [(0.02, 12.0), (0.30, 19.0), (0.54, 32.0), (0.80, 19.0)])


def posture(phase):
    """The left foot strikes at 0, the right at 0.5."""
    p = figure.Posture()
    sway, turn, list_ = _wave(phase, -0.05), _wave(phase, 0.25), _wave(phase, 0.02)
    p.at = (0.021 * sway, HEIGHT(phase), 0.008 * _wave(2.0 * phase, 0.30))
    p.hips = vec.euler(x=3.5 + 0.8 * _wave(2.0 * phase, 0.1), y=-5.5 * turn, z=3.6 * list_)
    p.chest = vec.euler(x=3.0 + 1.2 * _wave(2.0 * phase, 0.02), y=7.0 * _wave(phase, 0.235), z=-1.6 * list_)
    p.look = vec.euler(x=1.0 + 0.8 * _wave(2.0 * phase, -0.05), y=0.8 * turn, z=-0.6 * list_)
    for side, offset in ((".L", 0.0), (".R", 0.5)):
        own = (phase + offset) % 1.0
        p.feet[side] = figure.Foot(ankle(own), *_turned(own))
        forward = -21.5 * _wave(own, 0.235)
        along = vec.rotate(vec.turn((1, 0, 0), -forward), vec.rotate(vec.turn((0, 0, 1), 11.0), (0.0, -1.0, 0.0)))
        out = math.degrees(math.acos(-along[1]))
        ahead = math.degrees(math.atan2(along[2], along[0]))
        p.arms[side] = figure.Arm(out, ahead, roll=16.0, elbow=FOREARM((own - 0.03) % 1.0), twist=8.0,
                                  fist=10.0 + 4.0 * _wave(own, 0.13), shrug=1.0 * _wave(own, -0.2))
    return p


def walk():
    clip = Clip("Walk", CYCLE, KEYS)
    for k in range(KEYS):
        figure.key(clip, posture(k / KEYS))
    return figure.finish(clip)
