# assets/maker/humanoid/motion_dance.py: sixteen beats: steps to the side, arms overhead, two steps forward with a
# twist, a wave from arm to arm, a circle of the hips.
from .. import limb, vec
from ..clip import Clip
from . import motion_figure as figure

BEAT = 0.55      # seconds
BEATS = 16
KEYS = 264

# Where a foot stands: from beat, to beat, metres outwards, ahead, degrees outwards, heel up. Else it is in the air.
LEFT = [(0.90, 3.10, 0.400, 0.00, 10.0, 0.0), (3.85, 10.10, 0.200, 0.00, 12.0, 0.0),
        (10.80, 11.12, 0.110, 0.24, 8.0, 0.0), (11.85, 14.10, 0.190, 0.00, 12.0, 0.0),
        (14.80, 16.10, 0.130, 0.00, 10.0, 0.0)]
RIGHT = [(-0.20, 1.15, 0.130, 0.00, 10.0, 0.0), (1.88, 2.12, -0.150, 0.03, 6.0, 40.0),
         (2.85, 8.10, 0.180, 0.00, 12.0, 0.0), (8.80, 9.12, 0.110, 0.24, 8.0, 0.0),
         (9.85, 15.10, 0.190, 0.00, 12.0, 0.0)]
LIFT = 0.085


def _loop(*keys):
    return limb.Loop(float(BEATS), list(keys))


# Heels that come up while the weight is on the other foot.
HEELS = {
    ".L": _loop((1.4, 0.0), (2.90, 0.0), (3.08, 14.0), (3.85, 24.0), (4.4, 0.0), (5.5, 0.0), (6.0, 30.0), (6.5, 0.0),
                (12.5, 0.0), (13.55, 0.0), (14.05, 26.0), (14.80, 12.0), (15.2, 0.0)),
    ".R": _loop((0.55, 0.0), (1.12, 26.0), (1.9, 8.0), (3.0, 4.0), (3.5, 0.0), (4.5, 0.0), (5.0, 30.0), (5.5, 0.0),
                (6.5, 0.0), (7.0, 32.0), (7.5, 0.0), (12.2, 0.0), (12.75, 26.0), (13.3, 0.0), (14.6, 0.0),
                (15.08, 22.0), (15.8, 10.0)),
}

# The hips' place: to the left, ahead; and how they are turned to the left, degrees.
ASIDE = _loop((0.0, -0.092), (0.9, 0.215), (1.5, 0.330), (2.0, 0.325), (2.95, 0.040), (3.45, -0.132), (4.1, -0.105),
              (5.0, 0.115), (6.0, -0.112), (7.0, 0.118), (8.1, 0.150), (8.9, 0.055), (9.5, 0.030), (10.1, -0.145),
              (10.9, -0.055), (11.5, -0.030), (12.1, 0.000), (12.75, 0.095), (13.4, 0.010), (14.1, -0.138),
              (14.6, -0.100), (15.1, 0.070), (15.6, 0.030))
AHEAD = _loop((0.0, -0.01), (1.0, 0.0), (4.0, -0.01), (5.5, 0.02), (8.0, -0.01), (8.9, 0.115), (9.9, -0.02),
              (10.1, -0.02), (10.9, 0.115), (11.9, -0.02), (12.4, -0.025), (13.1, 0.055), (13.8, -0.01), (14.3, -0.04),
              (15.0, 0.0))
TURN = _loop((0.0, 0.0), (1.0, 12.0), (2.0, 22.0), (3.0, -10.0), (4.0, -16.0), (5.0, 8.0), (6.0, -8.0), (7.0, 10.0),
             (8.0, 0.0), (8.9, 24.0), (9.8, -8.0), (10.9, -24.0), (11.8, 8.0), (12.7, -10.0), (13.3, 4.0), (14.0, 14.0),
             (15.1, -12.0))
DOWN = _loop((0.0, -0.030), (1.0, -0.045), (2.0, -0.025), (3.0, -0.055), (4.0, -0.045), (5.2, -0.030), (7.4, -0.030),
             (8.0, -0.050), (9.0, -0.070), (10.0, -0.045), (11.0, -0.070), (12.2, -0.040), (13.3, -0.075),
             (14.2, -0.045), (15.0, -0.035))
BOUNCE = limb.Loop(1.0, [(0.0, -0.020), (0.28, -0.004), (0.55, 0.012), (0.80, 0.000)])

# The chest in the world: lean ahead, turned left, tilted to the right; the look likewise.
CHEST = _loop((0.0, (4.0, 0.0, 3.0)), (1.0, (5.0, 20.0, -5.0)), (2.0, (8.0, 4.0, 6.0)), (3.0, (5.0, -20.0, 5.0)),
              (4.0, (9.0, 0.0, -2.0)), (5.0, (-3.0, -3.0, -8.0)), (6.0, (-4.0, 3.0, 8.0)), (7.0, (-3.0, -3.0, -8.0)),
              (8.0, (4.0, 0.0, -2.0)), (8.95, (9.0, -24.0, 3.0)), (9.8, (3.0, 10.0, 0.0)), (10.95, (9.0, 24.0, -3.0)),
              (11.85, (3.0, -8.0, 0.0)), (12.6, (2.0, 14.0, -8.0)), (13.3, (3.0, 0.0, 0.0)), (14.0, (0.0, -14.0, 8.0)),
              (14.7, (-3.0, -8.0, 3.0)), (15.4, (5.0, 8.0, -3.0)))
LOOK = _loop((0.0, (4.0, 0.0, 0.0)), (0.9, (2.0, 36.0, -4.0)), (1.9, (8.0, 14.0, 5.0)), (2.9, (2.0, -36.0, 4.0)),
             (3.9, (9.0, -4.0, 0.0)), (5.0, (-8.0, 8.0, 7.0)), (6.0, (-9.0, -8.0, -7.0)), (7.0, (-7.0, 8.0, 7.0)),
             (8.0, (3.0, 0.0, 0.0)), (8.9, (4.0, -8.0, 3.0)), (9.8, (2.0, 0.0, 0.0)), (10.9, (4.0, 8.0, -3.0)),
             (11.8, (1.0, 6.0, 0.0)), (12.5, (0.0, 46.0, -6.0)), (13.2, (5.0, 8.0, 0.0)), (13.9, (0.0, -46.0, 6.0)),
             (14.7, (-6.0, -24.0, -4.0)), (15.4, (6.0, 4.0, 2.0)))

# out, ahead, roll, elbow, twist, fist, side, shrug: see motion_figure.Arm.
READY = (32.0, 6.0, -8.0, 86.0, 12.0, 16.0, 0.0, 0.0)
WIDE = (74.0, 6.0, 24.0, 22.0, 0.0, -14.0, 0.0, 2.0)
ACROSS = (44.0, 66.0, 14.0, 74.0, -6.0, 6.0, 0.0, 0.0)
CLOSE = (34.0, 46.0, 34.0, 112.0, 24.0, 20.0, 0.0, 2.0)
SWEEP = (96.0, 22.0, 40.0, 44.0, 4.0, -6.0, 0.0, 0.0)
HIGH = (166.0, 16.0, 58.0, 16.0, 0.0, -8.0, 0.0, 0.0)
HIGH_BENT = (138.0, 10.0, 62.0, 58.0, 10.0, -18.0, 0.0, 0.0)
CROWN = (128.0, 14.0, 62.0, 96.0, 10.0, 0.0, 0.0, 0.0)
PUNCH = (62.0, 62.0, 34.0, 62.0, -10.0, 4.0, 0.0, 0.0)
DRAWN = (36.0, -38.0, 6.0, 104.0, 10.0, 10.0, 0.0, 0.0)
HIP = (40.0, -14.0, -22.0, 76.0, -8.0, 18.0, 0.0, 0.0)
WAVE_UP = (98.0, 6.0, 18.0, 34.0, -4.0, -26.0, 0.0, 5.0)
WAVE_MID = (80.0, 6.0, -6.0, 58.0, 0.0, 26.0, 0.0, 1.0)
WAVE_OUT = (88.0, 6.0, 12.0, 8.0, 0.0, -30.0, 0.0, 0.0)
LOW = (28.0, 6.0, -4.0, 44.0, 4.0, 8.0, 0.0, 0.0)

ARMS = {
    ".L": _loop((0.0, READY), (1.0, WIDE), (2.0, CLOSE), (3.0, ACROSS), (4.0, CLOSE), (4.5, SWEEP), (5.0, HIGH_BENT),
                (6.0, HIGH), (7.0, HIGH_BENT), (7.5, CROWN), (8.1, READY), (8.95, PUNCH), (9.8, READY), (10.95, DRAWN),
                (11.8, LOW), (12.25, WAVE_MID), (12.6, WAVE_UP), (13.0, WAVE_OUT), (13.7, HIP), (14.8, HIP),
                (15.4, LOW)),
    ".R": _loop((0.0, READY), (1.0, ACROSS), (2.0, CLOSE), (3.0, WIDE), (4.0, CLOSE), (4.5, SWEEP), (5.0, HIGH),
                (6.0, HIGH_BENT), (7.0, HIGH), (7.5, CROWN), (8.1, READY), (8.95, DRAWN), (9.8, READY), (10.95, PUNCH),
                (11.8, HIP), (12.9, HIP), (13.3, LOW), (13.6, WAVE_MID), (13.95, WAVE_UP), (14.35, SWEEP),
                (14.85, HIGH), (15.5, CLOSE)),
}
LATE = (0.0, 0.02, 0.06, 0.11, 0.14, 0.22, 0.2, -0.04)  # beats: what is farther out on the arm follows


def _foot(plants, heel, beat):
    for plant in plants:
        for turn in (0, BEATS):
            if plant[0] <= beat + turn <= plant[1] or plant[0] <= beat - turn <= plant[1]:
                _, _, x, z, yaw, pitch = plant
                return figure.standing(x, z + figure.ANKLE[2], yaw, max(pitch, heel))
    after = [(p[0] if p[0] > beat else p[0] + BEATS, p) for p in plants]
    land, target = min(after, key=lambda item: item[0])
    start = plants[plants.index(target) - 1]
    s = 1.0 - (land - beat) / (land - start[1] if land > start[1] else land + BEATS - start[1])
    x, z, yaw = vec.mix(start[2:5], target[2:5], limb.ease((s - 0.10) / 0.80))
    pitch = start[5] + (target[5] - start[5]) * limb.ease(s) + 26.0 * limb.bump(s ** 0.8)
    return figure.standing(x, z + figure.ANKLE[2], yaw, max(pitch, heel), LIFT * 16.0 * (s * (1.0 - s)) ** 2)


def posture(beat):
    p = figure.Posture()
    aside, x, y, z = ASIDE(beat), *CHEST(beat - 0.08)
    p.at = (aside, DOWN(beat) + BOUNCE(beat % 1.0), AHEAD(beat))
    feet = {".L": _foot(LEFT, HEELS[".L"](beat), beat), ".R": _foot(RIGHT, HEELS[".R"](beat), beat)}
    middle = (feet[".L"].ankle[0] - feet[".R"].ankle[0]) / 2.0
    sway = aside - middle
    p.hips = vec.euler(x=5.0, y=TURN(beat), z=78.0 * sway)
    p.chest = vec.euler(x=x, y=y, z=z - 12.0 * sway)
    x, y, z = LOOK(beat)
    p.look = vec.euler(x=x, y=y, z=z)
    for side in figure.SIDES:
        numbers = [ARMS[side](beat - late)[k] for k, late in enumerate(LATE)]
        p.arms[side] = figure.Arm(*numbers)
    p.feet = feet
    return p


def dance():
    clip = Clip("Dance", BEAT * BEATS, KEYS)
    for p in figure.settle([posture(BEATS * k / KEYS) for k in range(KEYS)]):
        figure.key(clip, p)
    return figure.finish(clip)
