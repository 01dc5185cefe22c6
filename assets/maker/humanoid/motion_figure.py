# assets/maker/humanoid/motion_figure.py: the humanoid as an animator poses it: hips, chest and look in the world, arms
# by where they point, feet by where they stand; turned into the bones' own rotations.
import math
from dataclasses import dataclass, field

from .. import limb, vec
from . import body_leg, weights
from .skeleton import ORIGIN

SIDES = (".L", ".R")
KNEE = (1.0, 0.0, 0.0)        # bends backwards about it
SOFT, FULL = 0.986, 0.9935    # of the leg's length: from there the hips give way; beyond there nothing reaches


def _bone(a, b):
    return vec.sub(ORIGIN[b], ORIGIN[a])


THIGH, SHIN = _bone("thigh.L", "shin.L"), _bone("shin.L", "foot.L")
LEG = vec.length(THIGH) + vec.length(SHIN)
ANKLE = ORIGIN["foot.L"]
UPPER, FORE = vec.unit(_bone("upper_arm.L", "forearm.L")), vec.unit(_bone("forearm.L", "hand.L"))
ELBOW = vec.unit((UPPER[1], -UPPER[0], 0.0))  # bends forward about it
SOLE = limb.Sole(_bone("foot.L", "toe.L"),
                 [(vec.sub(p, ANKLE), weights.SHOE[name].get("toe.L", 0.0)) for name, p in body_leg.SHOE.items()
                  if p[1] < 0.03])


@dataclass
class Arm:
    """Degrees. Out: from hanging (0) over level (90) up; ahead: the plane of that, from the side (0) to the front (90).
    Roll: the elbow's pit from forward to up, at level. Twist: palm from down to up. Fist: wrist towards the palm."""
    out: float = 10.0
    ahead: float = 12.0
    roll: float = 0.0
    elbow: float = 16.0
    twist: float = 0.0
    fist: float = 8.0
    side: float = 0.0   # hand towards the thumb
    shrug: float = 0.0

    def direction(self):
        out, ahead = math.radians(self.out), math.radians(self.ahead)
        return (math.sin(out) * math.cos(ahead), -math.cos(out), math.sin(out) * math.sin(ahead))


@dataclass
class Foot:
    """In the world, as of the left foot; the right foot's are given in the mirror."""
    ankle: tuple = ANKLE
    foot: tuple = vec.IDENTITY
    toes: tuple = vec.IDENTITY


@dataclass
class Posture:
    """Rotations in the world. `at`: metres from the hips' place in the bind pose."""
    at: tuple = (0.0, 0.0, 0.0)
    hips: tuple = vec.IDENTITY
    chest: tuple = vec.IDENTITY
    look: tuple = vec.IDENTITY
    arms: dict = field(default_factory=lambda: {side: Arm() for side in SIDES})
    feet: dict = field(default_factory=lambda: {side: Foot() for side in SIDES})


def standing(x=0.0, z=0.0, yaw=0.0, pitch=0.0, lift=0.0):
    """A left foot whose ankle would be at x, z if it stood flat; pitch > 0 raises the heel, < 0 the toes."""
    turned = vec.turn((0, 1, 0), yaw)
    foot = vec.times(turned, vec.turn((1, 0, 0), pitch))
    toes = vec.times(turned, vec.turn((1, 0, 0), min(pitch, 0.0) + 0.25 * max(0.0, pitch - 30.0)))
    pivot = SOLE.joint if pitch > 0.0 else (0.0, -ANKLE[1], -0.055)
    moved = vec.sub(vec.rotate(turned, pivot), vec.rotate(foot, pivot))
    height = SOLE.ankle_height(foot, toes)
    return Foot((x + moved[0], height + lift, z + moved[2]), foot, toes)


def _seen(side, v):
    return (-v[0], v[1], v[2]) if side == ".R" else v


def _own(side, q):
    return limb.mirror(q) if side == ".R" else q


def _span(posture, side, down=0.0):
    """Hip to ankle, in the mirror for the right side."""
    hip = vec.rotate(_own(side, posture.hips), _bone("hips", "thigh.L"))
    at = vec.add(_seen(side, posture.at), (0.0, ORIGIN["hips"][1] - down, 0.0))
    return vec.sub(posture.feet[side].ankle, vec.add(at, hip))


def _give(posture):
    """Metres the hips must sink so that no leg is stretched: nothing, then gently more."""
    need = 0.0
    for side in SIDES:
        x, y, z = _span(posture, side)
        high = math.sqrt(max(1e-6, (SOFT * LEG) ** 2 - x * x - z * z))
        need = max(need, -y - high)
    return need


def settle(postures):
    """Lowers the hips where a leg would be stretched, smoothed over the neighbours so that nothing snaps."""
    count = len(postures)
    raw = [_give(p) for p in postures]
    reach = 5
    wide = [max(raw[(k + d) % count] for d in range(-reach, reach + 1)) for k in range(count)]
    bell = [0.5 + 0.5 * math.cos(math.pi * d / (reach + 1)) for d in range(-reach, reach + 1)]
    for k, posture in enumerate(postures):
        down = sum(b * wide[(k + d) % count] for b, d in zip(bell, range(-reach, reach + 1))) / sum(bell)
        posture.at = (posture.at[0], posture.at[1] - down, posture.at[2])
    return postures


def _leg(clip, posture, side):
    foot, hips, span = posture.feet[side], _own(side, posture.hips), _span(posture, side)
    if vec.length(span) > FULL * LEG:
        raise ValueError("%s: a leg of %.3f m would have to be %.3f m" % (clip.name, LEG, vec.length(span)))
    ahead = vec.unit(vec.add(vec.rotate(hips, (0.06, 0.0, 1.0)), vec.rotate(foot.foot, (0.0, 0.15, 1.0))))
    thigh, shin = limb.two_bones(THIGH, SHIN, KNEE, span, ahead)
    local = {"thigh": vec.times(vec.inverse(hips), thigh), "shin": shin,
             "foot": vec.times(vec.inverse(vec.times(thigh, shin)), foot.foot),
             "toe": vec.times(vec.inverse(foot.foot), foot.toes)}
    for bone, q in local.items():
        clip.key(bone + side, "rotation", _own(side, q))


def clavicle(arm):
    """Follows the arm: a quarter of what it is raised beyond 30 degrees, and a little forward and back with it."""
    raised = arm.out - 30.0
    lift = 0.26 * (raised + math.sqrt(raised * raised + 400.0)) / 2.0 - 1.3
    return vec.euler(y=-13.0 * arm.direction()[2], z=lift + arm.shrug)


def _arm(clip, arm, side):
    """Chest space throughout."""
    level, points = vec.shortest_arc(UPPER, (1.0, 0.0, 0.0)), arm.direction()
    upper = vec.times(vec.turn(points, -arm.roll), vec.times(vec.shortest_arc((1.0, 0.0, 0.0), points), level))
    shoulder = clavicle(arm)
    twist = vec.turn(FORE, -0.5 * arm.twist)
    wrist = vec.times(vec.turn((0, 0, 1), -arm.fist), vec.turn(ELBOW, arm.side))
    local = {"clavicle": shoulder, "upper_arm": vec.times(vec.inverse(shoulder), upper),
             "forearm": vec.times(vec.turn(ELBOW, arm.elbow), twist), "hand": vec.times(twist, wrist)}
    for bone, q in local.items():
        clip.key(bone + side, "rotation", _own(side, q))


def key(clip, posture):
    """Adds one key to every track."""
    clip.key("hips", "translation", vec.add(ORIGIN["hips"], posture.at))
    clip.key("hips", "rotation", posture.hips)
    back = vec.times(vec.inverse(posture.hips), posture.chest)
    spine = limb.between(vec.IDENTITY, back, 0.48)
    clip.key("spine", "rotation", spine)
    clip.key("chest", "rotation", vec.times(vec.inverse(spine), back))
    top = vec.times(vec.inverse(posture.chest), posture.look)
    neck = limb.between(vec.IDENTITY, top, 0.42)
    clip.key("neck", "rotation", neck)
    clip.key("head", "rotation", vec.times(vec.inverse(neck), top))
    for side in SIDES:
        _leg(clip, posture, side)
        _arm(clip, posture.arms[side], side)


def finish(clip):
    """Closes the loop; bones that never leave the bind pose need no track."""
    still = [track for track, values in clip.tracks.items() if track[1] == "rotation" and all(
        abs(c) < 1e-9 for q in values for c in q[:3])]
    for track in still:
        del clip.tracks[track]
    return clip.close()
