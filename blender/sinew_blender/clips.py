# blender/sinew_blender/clips.py: which clip of its file an armature plays, and where in it: the rig's keys go by that.
import math

NAME, RATE = "sinew_clip", "sinew_frames_a_second"  # Of an action: the clip it was made from. Copies have them too.


def mark(action, name, rate):
    """rate: frames of the action in a second of the clip."""
    action[NAME], action[RATE] = name, float(rate)


def moment(armature, frame, known):
    """(clip, seconds) of the topmost action that was made from one of the clips `known`; (None, 0) where none plays."""
    data = armature.animation_data
    for action, at in _playing(data, frame) if data else ():
        name, rate = action.get(NAME), action.get(RATE)
        if name in known and rate:
            return name, max(0.0, at / rate)
    return None, 0.0


def _playing(data, frame):
    """(action, frame in it), from the top down."""
    if data.action is not None:
        yield data.action, frame
    if not data.use_nla:
        return
    alone = [track for track in data.nla_tracks if track.is_solo]
    for track in reversed(alone or [track for track in data.nla_tracks if not track.mute]):
        strip = _strip_at(track, frame)
        if strip is not None and strip.action is not None and not strip.mute:
            yield strip.action, _frame_in(strip, min(max(frame, strip.frame_start), strip.frame_end))


def _strip_at(track, frame):
    """The strip that a frame is in, or the one before it that holds its end, or the first that holds its begin."""
    before = None
    for strip in track.strips:
        if frame < strip.frame_start:
            break
        before = strip
        if frame <= strip.frame_end:
            return strip
    if before is not None:
        return before if before.extrapolation != "NOTHING" else None
    first = next(iter(track.strips), None)
    return first if first is not None and first.extrapolation == "HOLD" else None


def _frame_in(strip, frame):
    """As Blender has it: a whole number of repeats ends at the action's last frame, not at its first again."""
    if strip.use_animated_time:
        return strip.strip_time
    first, last = strip.action_frame_start, strip.action_frame_end
    length = last - first
    passed = (frame - strip.frame_start) / strip.scale
    if length > 0:
        ends = frame == strip.frame_end and abs(strip.repeat - round(strip.repeat)) < 1e-4
        passed = length if ends else math.fmod(passed, length)
    return last - passed if strip.use_reverse else first + passed
