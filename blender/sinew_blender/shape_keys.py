# blender/sinew_blender/shape_keys.py: the character's shapes as shape keys whose sliders Sinew reads.
"""The surface has the shapes in it already. So a key has no places of its own, it is relative to itself: its slider,
drivers and animation count, and Blender adds nothing."""
from typing import NamedTuple


class Slider(NamedTuple):
    name: str
    value: float
    low: float
    high: float


def sliders_of(names, imported):
    """As Blender's importer made them, where it did; expressions of .vrm files it knows nothing of."""
    found = {key.name: key for keys in imported for key in keys.key_blocks}
    plain = {name: Slider(name, 0.0, 0.0, 1.0) for name in names}
    return [_slider(found[name]) if name in found else plain[name] for name in plain]


def _slider(key):
    return Slider(key.name, key.value, key.slider_min, key.slider_max)


def animation_of(keys):
    """(action, NLA tracks) of shape keys as plain values, or None."""
    data = keys.animation_data
    if data is None:
        return None
    tracks = [(track.name, track.mute, [(strip.name, int(strip.frame_start), strip.action) for strip in track.strips])
              for track in data.nla_tracks]
    return data.action, tracks


def put_on(item, kept):
    """kept: (sliders, animation)."""
    sliders, animation = kept
    if not sliders:
        return
    item.shape_key_add(name="Basis", from_mix=False)
    for slider in sliders:
        key = item.shape_key_add(name=slider.name, from_mix=False)
        key.relative_key = key
        key.slider_min, key.slider_max, key.value = slider.low, slider.high, slider.value
    if animation is None:
        return
    data = item.data.shape_keys.animation_data_create()
    action, tracks = animation
    for name, mute, strips in tracks:
        track = data.nla_tracks.new()
        track.name, track.mute = name, mute
        for strip in strips:
            track.strips.new(*strip)
    data.action = action


def take_off(item):
    """What put_on puts on again."""
    keys = item.data.shape_keys
    if keys is None:
        return [], None
    kept = [_slider(key) for key in keys.key_blocks[1:]], animation_of(keys)
    item.shape_key_clear()
    return kept
