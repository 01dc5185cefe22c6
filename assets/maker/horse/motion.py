# assets/maker/horse/motion.py: the horse's two clips, in place: the ground runs back under it at a steady speed.
import math

from .. import vec
from ..clip import Clip
from . import gait, solve
from .body import FORELEG, HIND_LEG
from .gait import Curve
from .skeleton import ORIGIN

SOLES = {"hoof_front": (FORELEG[-1][0][1], FORELEG[-1][2][1]), "hoof_hind": (HIND_LEG[-1][0][1], HIND_LEG[-1][2][1])}
SPINE = ("hips", "spine.1", "spine.2", "chest")


def _wave(phase, offset=0.0):
    return math.sin(2.0 * math.pi * (phase + offset))


class Trunk:
    """Where hips and chest stand and how they are turned."""

    def __init__(self, clip, place, turns):
        """turns: degrees (x, y, z) of hips, spine.1, spine.2, chest."""
        clip.key("hips", "translation", place)
        self.frames = {}
        above, where, origin = vec.IDENTITY, place, ORIGIN["hips"]
        for bone, (x, y, z) in zip(SPINE, turns):
            own = vec.euler(x=x, y=y, z=z)
            where = vec.add(where, vec.rotate(above, vec.sub(ORIGIN[bone], origin)))
            above, origin = vec.times(above, own), ORIGIN[bone]
            self.frames[bone] = (above, where)
            clip.key(bone, "rotation", own)

    def frame(self, bone, side):
        """Rotation and place; for the right side, all comes mirrored."""
        above, where = self.frames[bone]
        return (above, where) if side == ".L" else (solve.flip(above), (-where[0], where[1], where[2]))


def _leg(clip, trunk, side, step, kind, phase):
    """kind: "front" or "hind"; phase: 0 when this hoof strikes."""
    hoof, pastern = "hoof_" + kind, "pastern_" + kind
    roll, sunk = step.value("roll", phase), solve.pitch(step.value("pastern", phase))
    coffin = solve.hoof(hoof, step.forward(phase), step.value("lift", phase), roll, SOLES[hoof])
    fetlock = vec.sub(coffin, vec.rotate(sunk, solve.bone(pastern, hoof)))
    turns = []
    if kind == "front":
        above, where = trunk.frame("chest", side)
        blade = solve.pitch(step.value("blade", phase))
        scapula = solve.place(above, where, ORIGIN["chest"], "scapula")
        above = vec.times(above, blade)
        where = solve.place(above, scapula, ORIGIN["scapula.L"], "upper_arm")
        turns.append(("scapula", blade))
        chain, bends = solve.FORELEG, solve.knee(step.value("knee", phase))
    else:
        above, where = trunk.frame("hips", side)
        where = solve.place(above, where, ORIGIN["hips"], "thigh")
        chain, bends = solve.HIND_LEG, solve.hock_with_stifle
    solved, missed = chain.solve(above, where, fetlock, bends)
    if missed > 1e-4:
        raise SystemExit("%s%s is %.3f m out of reach at phase %.3f of %s" % (kind, side, missed, phase, clip.name))
    turns += zip(chain.names, solved)
    for q in solved:
        above = vec.times(above, q)
    turns.append((pastern, vec.times(vec.inverse(above), sunk)))
    turns.append((hoof, vec.times(vec.inverse(sunk), solve.pitch(roll))))
    for bone, q in turns:
        clip.key(bone + side, "rotation", q if side == ".L" else solve.flip(q))


def _tail(clip, phase, swing, carried, beat):
    """swing: degrees to the sides; carried: degrees up at the dock; beat: degrees up and down, twice a cycle."""
    for k in range(1, 5):
        up = (carried if k == 1 else -0.25 * carried) + beat * _wave(2.0 * phase, 0.2 - 0.10 * k)
        clip.key("tail.%d" % k, "rotation", vec.euler(x=up, y=0.0, z=swing * (0.5 + 0.2 * k) * _wave(phase, 0.3 - 0.1 * k)))


def _ears(clip, back, phase, beat):
    for side, sign in ((".L", 1.0), (".R", -1.0)):
        clip.key("ear" + side, "rotation", vec.euler(x=-back + beat * _wave(phase, 0.1), y=6.0 * sign))


def _feet(clip, trunk, phase, strikes, fore, hind):
    for (side, kind), strike in strikes.items():
        _leg(clip, trunk, side, fore if kind == "front" else hind, kind, (phase - strike) % 1.0)


WALK_STRIKES = {(".L", "hind"): 0.0, (".L", "front"): 0.25, (".R", "hind"): 0.5, (".R", "front"): 0.75}


def walk():
    """Four beats: left hind, left fore, right hind, right fore."""
    keys = 48
    clip = Clip("Walk", 1.1, keys)
    for k in range(keys):
        phase = k / keys
        sway = _wave(phase, 0.20)     # towards the hind leg that stands
        place = (0.012 * sway, ORIGIN["hips"][1] - 0.022 + 0.012 * _wave(2.0 * phase, -0.25),
                 ORIGIN["hips"][2] + 0.006 * _wave(2.0 * phase))
        rise = 0.7 * _wave(2.0 * phase, 0.35)
        trunk = Trunk(clip, place, [(0.3 + rise, -3.0 * _wave(phase, 0.25), 2.2 * sway),
                                    (0.2 - 0.6 * rise, 1.8 * _wave(phase, 0.20), -1.0 * sway),
                                    (-0.3 * rise, 1.8 * _wave(phase, 0.12), -1.0 * sway),
                                    (0.2 - 0.5 * rise, 1.2 * _wave(phase, 0.05), -0.6 * _wave(phase, -0.05))])
        nod = _wave(2.0 * phase, 0.10)
        clip.key("neck.1", "rotation", vec.euler(x=5.0 + 3.2 * nod, y=-1.2 * _wave(phase, 0.05)))
        clip.key("neck.2", "rotation", vec.euler(x=2.0 + 1.4 * _wave(2.0 * phase, 0.05), y=-0.8 * _wave(phase)))
        clip.key("neck.3", "rotation", vec.euler(x=0.5 * _wave(2.0 * phase)))
        clip.key("head", "rotation", vec.euler(x=-2.0 - 2.4 * _wave(2.0 * phase, 0.03)))
        _ears(clip, 2.0, 2.0 * phase, 3.0)
        _feet(clip, trunk, phase, WALK_STRIKES, gait.WALK_FORE, gait.WALK_HIND)
        _tail(clip, phase, 6.0, 3.0, 1.5)
    return clip.close()


GALLOP_STRIKES = {(".L", "hind"): 0.0, (".R", "hind"): 0.125, (".L", "front"): 0.375, (".R", "front"): 0.5}

_ROUNDED = Curve((0.0, 0.7), (0.12, 0.0), (0.34, -1.0), (0.60, -0.3), (0.88, 1.0))  # the back: 1 gathered, -1 stretched
_TILT = Curve((0.0, -1.5), (0.14, -4.5), (0.36, -1.5), (0.60, 4.5), (0.80, 3.0))    # degrees, nose down > 0
_RISE = Curve((0.0, 0.2), (0.20, -0.6), (0.45, -1.0), (0.62, -0.5), (0.86, 1.0))    # highest while all hoofs hang
_NECK = Curve((0.0, 2.0), (0.14, -3.5), (0.34, -1.0), (0.58, 8.0), (0.80, 7.0))     # the head goes down over the forelegs


def gallop():
    """Four beats and a suspension: left hind, right hind, left fore, right fore leading."""
    keys = 32
    clip = Clip("Gallop", 0.54, keys)
    for k in range(keys):
        phase = k / keys
        rounded = _ROUNDED(phase)
        place = (0.006 * _wave(phase), ORIGIN["hips"][1] - 0.062 + 0.050 * _RISE(phase),
                 ORIGIN["hips"][2] + 0.030 * rounded)
        trunk = Trunk(clip, place, [(_TILT(phase) - 7.0 * rounded, 1.5 * _wave(phase, 0.1), 1.0 * _wave(phase, 0.1)),
                                    (5.0 * rounded, -0.8 * _wave(phase, 0.1), -0.5 * _wave(phase, 0.1)),
                                    (4.5 * rounded, -0.8 * _wave(phase, 0.1), -0.5 * _wave(phase, 0.1)),
                                    (2.5 * rounded, 0.0, 0.0)])
        neck = _NECK(phase)
        clip.key("neck.1", "rotation", vec.euler(x=11.0 + neck))
        clip.key("neck.2", "rotation", vec.euler(x=6.0 + 0.4 * neck))
        clip.key("neck.3", "rotation", vec.euler(x=2.0 + 0.2 * neck))
        clip.key("head", "rotation", vec.euler(x=-14.0 - 0.9 * neck))
        _ears(clip, 18.0, phase, 3.0)
        _feet(clip, trunk, phase, GALLOP_STRIKES, gait.GALLOP_FORE, gait.GALLOP_HIND)
        _tail(clip, phase, 3.0, 34.0, 4.0)
    return clip.close()
