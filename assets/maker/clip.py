# assets/maker/clip.py: one animation as keys at even times.


class Clip:
    """Keys at even times; the last equals the first, so that the clip loops."""

    def __init__(self, name, duration, keys):
        self.name = name
        self.times = [duration * k / keys for k in range(keys + 1)]
        self.tracks = {}  # (bone, path) -> [value per key]

    def key(self, bone, path, value):
        values = self.tracks.setdefault((bone, path), [])
        if path == "rotation" and values and sum(a * b for a, b in zip(values[-1], value)) < 0.0:
            value = tuple(-c for c in value)
        values.append(value)

    def close(self):
        for values in self.tracks.values():
            values.append(values[0])
        return self
