# assets/maker/humanoid/motion.py: the humanoid's clips.
from .motion_dance import dance
from .motion_flex import flex
from .motion_walk import walk


def clips():
    return [walk(), dance(), flex()]
