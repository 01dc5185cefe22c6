# assets/maker/humanoid/weights.py: how much each ring of vertices follows which bones, left half.


def _row(**shares):
    return {name.replace("_L", ".L"): share for name, share in shares.items()}


def _same(count, **shares):
    return [_row(**shares)] * count


TRUNK = {  # front middle, front, side, back, back middle
    "hip": [_row(hips=1.0), _row(hips=0.62, thigh_L=0.38), _row(hips=0.55, thigh_L=0.45), _row(hips=0.62, thigh_L=0.38),
            _row(hips=1.0)],
    "belt": [_row(hips=0.75, spine=0.25), _row(hips=0.70, spine=0.24, thigh_L=0.06), _row(hips=0.78, spine=0.22),
             _row(hips=0.74, spine=0.22, thigh_L=0.04), _row(hips=0.78, spine=0.22)],
    "waist": _same(5, hips=0.22, spine=0.72, chest=0.06),
    "ribs": _same(5, spine=0.48, chest=0.52),
    "chest": [_row(chest=0.94, spine=0.06), _row(chest=0.80, clavicle_L=0.08, upper_arm_L=0.12),
              _row(chest=0.62, clavicle_L=0.16, upper_arm_L=0.22), _row(chest=0.78, clavicle_L=0.12, upper_arm_L=0.10),
              _row(chest=0.96, spine=0.04)],
    "collar": [_row(chest=0.95, neck=0.05), _row(chest=0.42, clavicle_L=0.40, upper_arm_L=0.18),
               _row(chest=0.12, clavicle_L=0.62, upper_arm_L=0.26), _row(chest=0.44, clavicle_L=0.40, upper_arm_L=0.16),
               _row(chest=0.95, neck=0.05)],
    "neck": [_row(chest=0.75, neck=0.25), _row(chest=0.60, clavicle_L=0.15, neck=0.25),
             _row(chest=0.38, clavicle_L=0.17, neck=0.45), _row(chest=0.45, clavicle_L=0.05, neck=0.50),
             _row(chest=0.50, neck=0.50)],
}
THROAT = [_row(neck=0.55, head=0.45), _row(neck=0.50, head=0.50), _row(neck=0.45, head=0.55), _row(neck=0.50, head=0.50),
          _row(neck=0.50, head=0.50)]

CROTCH = {"front": _row(hips=0.72, thigh_L=0.28), "back": _row(hips=0.66, thigh_L=0.34),
          "inner": _row(hips=0.62, thigh_L=0.38), "middle": _row(hips=1.0)}
LEG = {  # inner front, outer front, outer, outer back, inner back, inner
    "thigh": [_row(hips=0.10, thigh_L=0.90), _row(hips=0.08, thigh_L=0.92), _row(hips=0.12, thigh_L=0.88),
              _row(hips=0.16, thigh_L=0.84), _row(hips=0.16, thigh_L=0.84), _row(hips=0.12, thigh_L=0.88)],
    "above knee": _same(6, thigh_L=0.90, shin_L=0.10),
    "knee": [_row(thigh_L=0.50, shin_L=0.50)] * 6,
    "calf": _same(6, thigh_L=0.04, shin_L=0.96),
    "ankle": _same(6, shin_L=0.68, foot_L=0.32),
}
SHOE = {name: _row(foot_L=1.0) for name in ("heel in", "heel out", "arch")}
SHOE.update({name: _row(foot_L=0.55, toe_L=0.45) for name in ("ball out", "ball in", "top in", "top out")})
SHOE.update({name: _row(toe_L=1.0) for name in ("toe in", "toe out", "toe top")})

ARM = {  # top, top back, low back, low, low front, top front
    "deltoid": [_row(clavicle_L=0.18, upper_arm_L=0.82), _row(clavicle_L=0.14, upper_arm_L=0.86),
                _row(chest=0.06, clavicle_L=0.06, upper_arm_L=0.88), _row(chest=0.10, clavicle_L=0.06, upper_arm_L=0.84),
                _row(chest=0.06, clavicle_L=0.06, upper_arm_L=0.88), _row(clavicle_L=0.14, upper_arm_L=0.86)],
    "biceps": _same(6, upper_arm_L=1.0),
    "above elbow": _same(6, upper_arm_L=0.90, forearm_L=0.10),
    "elbow": _same(4, upper_arm_L=0.50, forearm_L=0.50),
    "forearm": _same(6, upper_arm_L=0.06, forearm_L=0.94),
    "wrist": _same(6, forearm_L=0.58, hand_L=0.42),
    "knuckles": _same(6, hand_L=1.0),
}
