# tests/blender/clips_in_blender.py: run by Blender: clips of the file as actions and as strips.
import os
import sys

sys.path.insert(0, os.path.dirname(__file__))
import bpy  # noqa: E402
import inside  # noqa: E402
import numpy  # noqa: E402

rig, rest, folder = inside.ARGUMENTS
scene = bpy.context.scene


def show(label, frame):
    scene.frame_set(int(frame), subframe=frame % 1)
    moments.add(body, label)


def strip(extrapolation="HOLD", **settings):
    """One alone, from frame 41."""
    for track in list(data.nla_tracks):
        data.nla_tracks.remove(track)
    made = data.nla_tracks.new().strips.new("strip", 41, walk)
    made.extrapolation = extrapolation
    for name, value in settings.items():
        setattr(made, name, value)
    return made


inside.install()
moments = inside.Moments(rest)
inside.clear()
body = inside.open_rig(rig, detail="UNIFORM", depth=2)
data = body.sinew.armature.animation_data
walk, dance = (next(each for each in bpy.data.actions if each.name.startswith(name)) for name in ("Walk", "Dance"))
first, last = walk.frame_range
data.action = walk
show("action", 7)
show("between frames", 8.25)
data.action = dance
show("other clip", 7)
data.action = bpy.data.actions.new("own")
show("own action", 7)
data.action = walk.copy()
show("copied action", 11)

data.action = None
strip(scale=2.0)
show("strip twice as long", 51)
strip(use_reverse=True)
show("backwards", 55)
strip(repeat=2.0)
show("second round", 41 + (last - first) + 4)
strip()
show("held after its end", 200)
strip()
data.action = bpy.data.actions.new("over it")
show("own action over a strip", 47)
data.action = None
data.nla_tracks[0].mute = True
show("muted", 47)
data.action = walk
scene.render.fps = 30
show("later rate of frames", 7)
numpy.savez(folder + "/told.npz", numbers=moments.numbers, rest=moments.rest, poses=moments.poses, shown=moments.shown,
            labels=moments.labels, length=(last - first) / 24)
