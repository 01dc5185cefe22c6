# assets/maker/horse/flex.py: the horse's third rig: the muscles of muscles.py, those that span a joint on lines.
from .. import laid
from ..names import mirror_name
from .muscles import GROUPS, LINKS, under_the_skin
from .skeleton import ORIGIN

# Name; origin, insertion, via point: bone and place in the bind pose; settings of docs/muscles.md. Where the bone of the
# origin is far, girth grows from nearer by (pivot), or the belly would be pushed out of the body.
# On their bones stay: the quadriceps and the gaskin, which no line keeps under the skin of the stifle and hock in the
# gallop (`sinew check`); the masseter, whose jaw has no bone; serratus, which lies on ribs that keep their length; the
# pectorals, one muscle of the middle that would have to end on both arms.
_LINES = [
    ("brachiocephalicus", ("neck.3", (0.050, 1.830, 0.930)), ("upper_arm.L", (0.165, 1.050, 0.610)), None,
     {"rest": 0.95, "tendons": [0.1, 0.1], "volume": 0.8, "pivot": 0.3, "flex": [0.1, 0], "activation": {"full": 0.8}}),
    ("deltoid", ("scapula.L", (0.105, 1.420, 0.370)), ("upper_arm.L", (0.180, 1.030, 0.540)),
     ("chest", (0.139, 1.244, 0.446)),  # Under skin that the chest carries.
     {"tendons": [0.05, 0.15], "twist": 1, "flex": [0.2, 0], "activation": {"full": 0.8}}),
    ("trapezius", ("neck.2", (0.020, 1.800, 0.800)), ("chest", (0.020, 1.560, 0.420)), None,
     {"rest": 1.16, "tendons": [0.1, 0.1], "pivot": 0.3, "flex": [0.08, 0], "activation": {"full": 0.9}}),
    ("triceps", ("scapula.L", (0.140, 1.330, 0.380)), ("forearm.L", (0.155, 0.930, 0.360)),
     ("upper_arm.L", (0.165, 1.000, 0.400)),
     {"rest": 1.05, "tendons": [0.05, 0.15], "volume": 0.7, "pivot": 0, "flex": [0.1, 0], "activation": {"full": 0.7}}),
    ("forearm extensor", ("upper_arm.L", (0.165, 0.960, 0.470)), ("cannon_front.L", (0.140, 0.440, 0.475)),
     ("forearm.L", (0.155, 0.740, 0.480)),
     {"tendons": [0.14, 0.3], "pivot": 0.3, "flex": [0.1, 0], "activation": {"full": 0.87}}),
    ("gluteus", ("hips", (0.070, 1.470, -0.400)), ("thigh.L", (0.150, 1.300, -0.700)), None,
     {"rest": 1.1, "tendons": [0.05, 0.15], "pivot": 0.5, "flex": [0.25, 0], "activation": {"full": 0.88}}),
    ("biceps femoris", ("hips", (0.110, 1.350, -0.810)), ("shin.L", (0.168, 0.885, -0.535)), None,
     {"tendons": [0.1, 0.2], "pivot": 0.5, "flex": [0.2, 0], "activation": {"full": 0.86}}),
]
# Anchors in the mirror plane: its own twin.
_MIDDLE = [
    ("longissimus", ("hips", (0.0, 1.470, -0.560)), ("chest", (0.0, 1.450, 0.250)), None,
     {"tendons": [0.15, 0.15], "pivot": 0.3, "flex": [0.12, 0], "activation": {"full": 0.96}}),
]
# Those that move the skin around their own bone, as in horse.rig.json; by default it would be that of the whole line.
_OWN_SKIN = {"brachiocephalicus": ["neck.1", "neck.2", "neck.3"], "deltoid": ["chest", "scapula.L", "upper_arm.L"],
             "triceps": ["scapula.L", "upper_arm.L", "forearm.L"], "trapezius": ["chest", "neck.1", "neck.2"],
             "gluteus": ["hips", "spine.1", "thigh.L"], "longissimus": ["hips", "spine.1", "spine.2"]}


def _on_line(row):
    name, side = (row["name"][:-2], row["name"][-2:]) if "mirror" in row else (row["name"], "")
    territory = row.get("territory") or _OWN_SKIN[name]
    if side == " R" and name in _OWN_SKIN:
        territory = [mirror_name(bone) for bone in territory]
    return {**row, "line": row["name"], "territory": territory}


def rig():
    lines = [side for row in _LINES for side in laid.line_pair(*row, ORIGIN)]
    lines += [laid.line(*row, ORIGIN) for row in _MIDDLE]
    spanning = {line["name"] for line in lines}
    rows = [_on_line(row) if row["name"] in spanning else row for row in under_the_skin()]
    return laid.rig_text("horse.glb", {"mode": "swell", "iso": 0.25, "skin_blend": 0.04},
                         {"depth": 3, "patch": "pn", "detail": "adaptive"}, GROUPS, LINKS, rows, lines)
