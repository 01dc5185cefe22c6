# assets/maker/humanoid/motion_flex.py: both arms come up, curl hard, pulse twice and come down again.
from .. import limb, vec
from ..clip import Clip
from . import motion_figure as figure

SECONDS = 4.0
KEYS = 120


def _loop(*keys):
    return limb.Loop(SECONDS, list(keys))


# out, ahead, roll, elbow, twist, fist, side, shrug: see motion_figure.Arm
REST = (13.0, 14.0, -6.0, 20.0, 6.0, 10.0, 0.0, 0.0)
GATHER = (20.0, 48.0, 4.0, 62.0, 10.0, 18.0, 0.0, -1.5)
OPEN = (70.0, 14.0, 46.0, 62.0, 34.0, 8.0, 0.0, 0.0)
CURL = (83.0, 12.0, 78.0, 110.0, 62.0, 12.0, 0.0, 2.0)
SQUEEZE = (86.0, 15.0, 77.0, 125.0, 68.0, 14.0, 0.0, 4.0)
EASED = (80.0, 11.0, 75.0, 103.0, 58.0, 8.0, 0.0, 1.0)
DOWN = (48.0, 14.0, 34.0, 62.0, 30.0, 14.0, 0.0, 0.0)
ARM = _loop((0.10, REST), (0.45, GATHER), (0.85, OPEN), (1.22, CURL), (1.50, SQUEEZE), (1.84, EASED), (2.16, SQUEEZE),
            (2.62, CURL), (3.05, DOWN), (3.55, REST))

CHEST = _loop((0.10, 2.0), (0.45, 7.0), (0.95, -6.0), (1.50, -12.0), (1.84, -9.0), (2.16, -12.5), (2.62, -8.0),
              (3.15, 1.0), (3.60, 3.0))
HIPS = _loop((0.10, 2.0), (0.45, 5.0), (1.10, 3.0), (1.55, 6.0), (2.62, 4.0), (3.30, 2.5))
SINK = _loop((0.10, 0.000), (0.48, -0.040), (1.10, 0.002), (1.50, -0.014), (1.84, -0.003), (2.16, -0.016),
             (2.62, -0.001), (3.20, -0.012), (3.60, 0.000))
BACK = _loop((0.10, 0.0), (0.48, -0.030), (1.30, 0.012), (2.40, 0.012), (3.20, -0.010))
# Weight on the right foot while the arms are up.
ASIDE = _loop((0.10, 0.016), (1.30, -0.020), (2.50, -0.026), (3.40, 0.010))
LOOK = _loop((0.20, (1.0, 0.0, 0.0)), (0.50, (9.0, 0.0, 0.0)), (1.00, (-4.0, 6.0, 0.0)), (1.45, (-1.0, 26.0, -3.0)),
             (1.95, (0.0, 28.0, -4.0)), (2.25, (-2.0, -4.0, 0.0)), (2.60, (-4.0, -9.0, 2.0)), (3.20, (2.0, 0.0, 0.0)))


def posture(time):
    p = figure.Posture()
    aside = ASIDE(time)
    p.at = (aside, SINK(time), BACK(time))
    p.hips = vec.euler(x=HIPS(time), z=90.0 * aside)
    p.chest = vec.euler(x=CHEST(time - 0.04), y=0.12 * LOOK(time)[1], z=-60.0 * aside)
    x, y, z = LOOK(time)
    p.look = vec.euler(x=x, y=y, z=z)
    for side, late, ahead in ((".L", 0.0, 0.050), (".R", 0.035, -0.030)):
        numbers = list(ARM(time - late))
        wrist = ARM(time - late - 0.07)
        numbers[5] = wrist[5]
        p.arms[side] = figure.Arm(*numbers)
        p.feet[side] = figure.standing(0.150, ahead - 0.028, 12.0)
    return p


def flex():
    clip = Clip("Flex", SECONDS, KEYS)
    for p in figure.settle([posture(SECONDS * k / KEYS) for k in range(KEYS)]):
        figure.key(clip, p)
    return figure.finish(clip)
