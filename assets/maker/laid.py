# assets/maker/laid.py: ellipsoids laid on a character's skin: each between two places that rays from inside find.
import json
import math

from . import vec
from .names import mirror_name


class Skin:
    """The control mesh in the bind pose, asked for the outermost place along a ray."""

    def __init__(self, mesh):
        self.positions = mesh.positions
        self.triangles = [tuple(corner[0] for corner in t) for t in mesh.triangles]

    def hit(self, origin, direction):
        """First place where a ray from inside leaves the body, and the face's normal there."""
        direction = vec.unit(direction)
        best = None
        for t in self.triangles:
            a, b, c = (self.positions[v] for v in t)
            ab, ac = vec.sub(b, a), vec.sub(c, a)
            p = vec.cross(direction, ac)
            det = vec.dot(ab, p)
            if abs(det) < 1e-12:
                continue
            s = vec.sub(origin, a)
            u = vec.dot(s, p) / det
            q = vec.cross(s, ab)
            v = vec.dot(direction, q) / det
            if u < -1e-9 or v < -1e-9 or u + v > 1.0 + 1e-9:
                continue
            along = vec.dot(ac, q) / det
            normal = vec.unit(vec.cross(ab, ac))
            if along > 1e-6 and vec.dot(normal, direction) > 0.0 and (best is None or along < best[0]):
                best = (along, normal)
        if best is None:
            raise SystemExit("no skin along %s from %s" % (direction, origin))
        return vec.add(origin, vec.scale(direction, best[0])), best[1]


def _quaternion(x, y, z):
    """Of the rotation whose columns these are."""
    m = (x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2])
    trace = m[0] + m[4] + m[8]
    if trace > 0.0:
        s = math.sqrt(trace + 1.0) * 2.0
        q = ((m[7] - m[5]) / s, (m[2] - m[6]) / s, (m[3] - m[1]) / s, 0.25 * s)
    elif m[0] >= m[4] and m[0] >= m[8]:
        s = math.sqrt(1.0 + m[0] - m[4] - m[8]) * 2.0
        q = (0.25 * s, (m[1] + m[3]) / s, (m[2] + m[6]) / s, (m[7] - m[5]) / s)
    elif m[4] >= m[8]:
        s = math.sqrt(1.0 + m[4] - m[0] - m[8]) * 2.0
        q = ((m[1] + m[3]) / s, 0.25 * s, (m[5] + m[7]) / s, (m[2] - m[6]) / s)
    else:
        s = math.sqrt(1.0 + m[8] - m[0] - m[4]) * 2.0
        q = ((m[2] + m[6]) / s, (m[5] + m[7]) / s, 0.25 * s, (m[3] - m[1]) / s)
    n = math.sqrt(sum(c * c for c in q))
    q = tuple(c / n for c in q)
    return q if q[3] >= 0.0 else tuple(-c for c in q)


def ellipsoid(skin, ray_a, ray_b, longer, width, thick, sink):
    """Centre, rotation, radii in the bind pose's world: x along the muscle, y out of the skin. Each ray: (origin, towards);
    half length = half the way between the places found x longer; the middle lies `sink` x thick under the skin."""
    (a, normal_a), (b, normal_b) = (skin.hit(*ray) for ray in (ray_a, ray_b))
    x = vec.unit(vec.sub(b, a))
    out = vec.add(normal_a, normal_b)
    y = vec.unit(vec.sub(out, vec.scale(x, vec.dot(out, x))))
    middle = vec.scale(vec.add(a, b), 0.5)
    # The skin bulges between the two places: measure under the middle's own.
    surface, _ = skin.hit(vec.sub(middle, vec.scale(y, thick + 0.02)), y)
    centre = vec.sub(surface, vec.scale(y, sink * thick))
    return centre, _quaternion(x, y, vec.cross(x, y)), (0.5 * vec.length(vec.sub(b, a)) * longer, thick, width)


def _short(value, digits=6):
    return round(value, digits) + 0.0  # + 0.0: no minus zero


def primitive(name, bone, group, centre, rotation, radii, origin_of_bone, twin="", reach=1.4142135, territory=None):
    entry = {"name": name, "bone": bone, "group": group, "kind": "ellipsoid",
             "center": [_short(c) for c in vec.sub(centre, origin_of_bone)], "rotation": [_short(c, 7) for c in rotation],
             "radii": [_short(r) for r in radii], "reach": reach, "sign": 1}
    if twin:
        entry["mirror"] = twin
    if territory is not None:
        entry["territory"] = territory
    return entry


def pair(name, bone, group, centre, rotation, radii, origins, reach=1.4142135, territory=None):
    """The left muscle and its twin across x = 0."""
    left = primitive(name + " L", bone, group, centre, rotation, radii, origins[bone], name + " R", reach, territory)
    across = (-centre[0], centre[1], centre[2])
    turned = (rotation[0], -rotation[1], -rotation[2], rotation[3])
    others = [mirror_name(b) for b in territory] if territory is not None else None
    right = mirror_name(bone)
    return [left, primitive(name + " R", right, group, across, turned, radii, origins[right], name + " L", reach, others)]


def line(name, origin, insertion, via, settings, origins):
    """A muscle line. Each end: (bone, place in the bind pose's world)."""
    def end(bone, place):
        return {"bone": bone, "point": [_short(c) for c in vec.sub(place, origins[bone])]}

    entry = {"name": name, "origin": end(*origin), "insertion": end(*insertion)}
    if via:
        entry["via"] = end(*via)
    return {**entry, **settings}


def line_pair(name, origin, insertion, via, settings, origins):
    """The left muscle line and its twin across x = 0."""
    def across(end):
        return end and (mirror_name(end[0]), (-end[1][0], end[1][1], end[1][2]))

    left = line(name + " L", origin, insertion, via, settings, origins)
    right = line(name + " R", across(origin), across(insertion), across(via), settings, origins)
    return [{**left, "mirror": name + " R"}, {**right, "mirror": name + " L"}]


def rig_text(character, surface, smoothing, groups, links, primitives, muscle_lines=()):
    head = {"format": "sinew-rig", "version": 2 if muscle_lines else 1, "character": character, "surface": surface, "smoothing": smoothing,
            "groups": [{"name": g} for g in groups], "links": [list(link) for link in links]}
    lines = ["  %s: %s" % (json.dumps(key), json.dumps(value)) for key, value in head.items()]
    lists = ([("lines", muscle_lines)] if muscle_lines else []) + [("primitives", primitives)]
    for key, items in lists:
        lines.append('  "%s": [\n' % key + ",\n".join("    " + json.dumps(item) for item in items) + "\n  ]")
    return "{\n" + ",\n".join(lines) + "\n}\n"
