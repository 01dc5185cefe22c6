# assets/maker/lizard/motion.py: the lizard's two clips. Legs are solved from where the feet stand, so planted feet stay planted.
import math

from .. import vec
from ..clip import Clip
from .skeleton import ANKLE, ARM, HIP, KNEE, ORIGIN

THIGH = vec.sub(KNEE, HIP)
SHIN = vec.sub(ANKLE, KNEE)
TOE = (0.0, -ANKLE[1], 0.13)    # pivots of the sole, from the ankle
HEEL = (0.0, -ANKLE[1], -0.04)
STRIDE = 0.36   # metres between foot strike and toe-off
STANCE = 0.60   # part of the cycle a foot stands
UP_OUT = (-ARM[1], ARM[0], 0.0)


def _wave(phase, offset=0.0):
    return math.sin(2.0 * math.pi * (phase + offset))


def _flip(q):
    """A rotation of the left side, seen in the mirror x -> -x."""
    return (q[0], -q[1], -q[2], q[3])


def _solve_leg(hips, hip_place, ankle, foot, mirrored):
    """Local rotations of thigh, shin and foot that bring the ankle there. For the right side, all comes mirrored."""
    hip = vec.add(hip_place, vec.rotate(hips, vec.sub(HIP, ORIGIN["hips"])))
    target = vec.rotate(vec.inverse(hips), vec.sub(ankle, hip))
    reach = vec.length(target)
    low, high = 0.0, 140.0  # degrees of knee bend
    for _ in range(60):
        bend = (low + high) / 2.0
        if vec.length(vec.add(THIGH, vec.rotate(vec.turn((1, 0, 0), bend), SHIN))) > reach:
            low = bend
        else:
            high = bend
    shin = vec.turn((1, 0, 0), low)
    thigh = vec.shortest_arc(vec.add(THIGH, vec.rotate(shin, SHIN)), target)
    above = vec.times(hips, vec.times(thigh, shin))
    result = (thigh, shin, vec.times(vec.inverse(above), foot))
    return tuple(_flip(q) for q in result) if mirrored else result


def _foot(phase):
    """Ankle from the bind pose (z, y) and the foot's pitch in degrees (heel up > 0), one cycle from foot strike."""
    if phase < STANCE:
        s = phase / STANCE
        z, lift = STRIDE * (0.5 - s), 0.0
        pitch = -16.0 * (1.0 - vec.smoothstep(0.0, 0.22, s)) + 30.0 * vec.smoothstep(0.62, 1.0, s) ** 1.3
    else:
        s = (phase - STANCE) / (1.0 - STANCE)
        ease = s - math.sin(2.0 * math.pi * s) / (2.0 * math.pi) * 0.35
        z, lift = STRIDE * (ease - 0.5), 0.060 * math.sin(math.pi * s) ** 1.2
        pitch = 30.0 * (1.0 - vec.smoothstep(0.0, 0.65, s)) - 16.0 * vec.smoothstep(0.45, 1.0, s)
    return z, lift, pitch


def _leg(clip, side, hips, place, z, lift, pitch, out=0.0):
    mirrored = side == ".R"
    if mirrored:
        hips, place = _flip(hips), (-place[0], place[1], place[2])
    foot = vec.turn((1, 0, 0), pitch)
    pivot = TOE if pitch > 0.0 else HEEL
    rolled = vec.sub(pivot, vec.rotate(foot, pivot))
    ankle = vec.add(vec.add(ANKLE, (out, lift, z)), rolled)
    for bone, q in zip(("thigh", "shin", "foot"), _solve_leg(hips, place, ankle, foot, mirrored)):
        clip.key(bone + side, "rotation", q)


def _arm(clip, side, swing, bend, lowered):
    """Swing forward > 0, elbow bend and lowering from the bind pose, degrees."""
    upper = vec.times(vec.turn((1, 0, 0), -swing), vec.turn((0, 0, 1), -lowered))
    fore = vec.turn(vec.scale(UP_OUT, -1.0), bend)
    hand = vec.turn(vec.scale(UP_OUT, -1.0), 0.35 * bend)
    for bone, q in (("upper_arm", upper), ("forearm", fore), ("hand", hand)):
        clip.key(bone + side, "rotation", _flip(q) if side == ".R" else q)


def _tail(clip, phase, swing, lift):
    for k in range(1, 5):
        sideways = swing * (0.6 + 0.2 * k) * _wave(phase, 0.30 - 0.11 * k)
        clip.key("tail.%d" % k, "rotation", vec.euler(x=lift * _wave(2.0 * phase, -0.10 * k), y=sideways))


def walk():
    keys = 24
    clip = Clip("Walk", 1.2, keys)
    for k in range(keys):
        phase = k / keys  # the left foot strikes at 0
        hips = vec.euler(x=4.0, y=-7.0 * _wave(phase, 0.25), z=3.5 * _wave(phase, 0.02))
        place = (0.020 * _wave(phase, -0.05), ORIGIN["hips"][1] - 0.020 - 0.012 * _wave(2.0 * phase, 0.15), 0.0)
        clip.key("hips", "translation", place)
        clip.key("hips", "rotation", hips)
        clip.key("spine", "rotation", vec.euler(x=2.0, y=5.0 * _wave(phase, 0.25), z=-3.0 * _wave(phase, 0.02)))
        clip.key("chest", "rotation", vec.euler(x=-1.5, y=8.0 * _wave(phase, 0.25), z=-2.0 * _wave(phase, 0.02)))
        clip.key("neck", "rotation", vec.euler(x=-2.0 + 1.5 * _wave(2.0 * phase, 0.1), y=-3.0 * _wave(phase, 0.25)))
        nod = -2.5 + 2.5 * _wave(2.0 * phase)
        clip.key("head", "rotation", vec.euler(x=nod, y=-3.0 * _wave(phase, 0.25), z=1.5 * _wave(phase)))
        for side, offset in ((".L", 0.0), (".R", 0.5)):
            own = (phase + offset) % 1.0
            clip.key("shoulder" + side, "rotation", vec.euler(y=(3.0 if side == ".L" else -3.0) * _wave(own, -0.25)))
            _leg(clip, side, hips, place, *_foot(own))
            swing = -_wave(own, 0.22)
            _arm(clip, side, 28.0 * swing, 24.0 + 14.0 * swing, 29.0)
        _tail(clip, phase, 9.0, 3.0)
    return clip.close()


def idle():
    keys = 32
    clip = Clip("Idle", 3.2, keys)
    for k in range(keys):
        phase = k / keys
        breath = _wave(phase, -0.25)
        hips = vec.euler(x=1.5, y=2.0 * _wave(phase), z=1.5 * _wave(phase))
        place = (0.012 * _wave(phase, 0.05), ORIGIN["hips"][1] - 0.018 + 0.004 * breath, 0.0)
        clip.key("hips", "translation", place)
        clip.key("hips", "rotation", hips)
        clip.key("spine", "rotation", vec.euler(x=1.0 - 1.0 * breath, z=-1.0 * _wave(phase)))
        clip.key("chest", "rotation", vec.euler(x=-0.5 - 1.8 * breath, y=-1.5 * _wave(phase)))
        clip.key("neck", "rotation", vec.euler(x=1.0 * breath, y=6.0 * _wave(phase, -0.1)))
        clip.key("head", "rotation", vec.euler(x=1.2 * breath, y=10.0 * _wave(phase, -0.1), z=5.0 * _wave(phase, 0.1)))
        for side in (".L", ".R"):
            clip.key("shoulder" + side, "rotation", vec.euler(z=(1.0 if side == ".L" else -1.0) * 2.0 * breath))
            _leg(clip, side, hips, place, 0.0, 0.0, 0.0)
            _arm(clip, side, 2.0 + 3.0 * _wave(phase, 0.1), 16.0 + 3.0 * breath, 23.0)
        _tail(clip, phase, 8.0, 1.0)
    return clip.close()
