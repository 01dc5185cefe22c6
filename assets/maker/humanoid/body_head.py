# assets/maker/humanoid/body_head.py: neck and head of the left half.
from . import weights

THROAT = [(0.0, 1.555, 0.044), (0.036, 1.558, 0.030), (0.056, 1.588, -0.022), (0.042, 1.600, -0.072),
          (0.0, 1.600, -0.086)]

HEAD = {
    # The middle line, from the chin over the crown to the back.
    "chin": (0.0, 1.57, 0.086), "lip": (0.0, 1.612, 0.095), "nose": (0.0, 1.651, 0.1085), "bridge": (0.0, 1.694, 0.0915),
    "forehead": (0.0, 1.738, 0.0945), "hairline": (0.0, 1.783, 0.056), "crown": (0.0, 1.800, -0.020),
    "back": (0.0, 1.752, -0.106), "occiput": (0.0, 1.670, -0.108),
    # The face.
    "jaw": (0.029, 1.571, 0.071), "angle": (0.063, 1.606, 0.002), "mouth": (0.030, 1.613, 0.079),
    "nostril": (0.0168, 1.645, 0.0935), "eye in": (0.017, 1.684, 0.078), "eye out": (0.057, 1.667, 0.063),
    "brow": (0.034, 1.706, 0.088), "temple": (0.067, 1.708, 0.040), "hair": (0.050, 1.752, 0.064),
    # The skull.
    "ear": (0.0735, 1.650, -0.006), "side": (0.077, 1.713, -0.012), "top": (0.056, 1.777, -0.016),
    "behind ear": (0.0745, 1.692, -0.032), "helix": (0.0885, 1.7035, -0.0355),
    "back low": (0.060, 1.660, -0.078), "back high": (0.063, 1.735, -0.076),
}

FACES = [  # corners, texels
    ("chin jaw mouth lip", 75), ("lip mouth nostril nose", 75), ("nose nostril eye_in bridge", 75),
    ("bridge eye_in brow forehead", 75), ("forehead brow hair hairline", 75),
    ("jaw angle eye_out mouth", 75), ("angle ear eye_out", 59), ("mouth eye_out eye_in nostril", 75),
    ("eye_in eye_out temple brow", 97), ("brow temple hair", 59), ("eye_out ear side temple", 75),
    ("temple side top hair", 59), ("hairline hair top crown", 54), ("crown top back_high back", 54),
    ("side back_high top", 48), ("ear back_low back_high behind_ear", 59),
    ("behind_ear back_high side", 48), ("ear helix side", 59), ("side helix behind_ear", 37), ("behind_ear helix ear", 37), ("back_low occiput back back_high", 54),
    ("under under_side jaw chin", 37), ("under_side under_angle angle jaw", 48),
    ("under_angle nape_side back_low ear", 54), ("angle under_angle ear", 48), ("nape_side nape occiput back_low", 48),
]


def head(cage, neck):
    throat = [cage.vertex(p, w) for p, w in zip(THROAT, weights.THROAT)]
    cage.tube([neck, throat], "neck", closed=False, pixels=36)
    v = {name.replace(" ", "_"): cage.vertex(p, {"head": 1.0}) for name, p in HEAD.items()}
    v.update(zip(("under", "under_side", "under_angle", "nape_side", "nape"), throat))
    for corners, pixels in FACES:
        cage.single([v[name] for name in corners.split()], "head", pixels)
