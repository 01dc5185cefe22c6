# tests/export/simple_rig.py: a rig with a muscle on every other joint of a character that has none.
import json
import subprocess

EVERY = 2
MOST = 12
RADIUS = 0.06  # Of the height, where a joint does not scale.


def simple_rig(program, character, folder):
    """Writes it and returns its path."""
    told = subprocess.run([program, "inspect", character, "--json"], check=True, capture_output=True, text=True).stdout
    about = json.loads(told)
    radius = RADIUS * about["height"]
    joints = [name for name in about["joint_names"][1::EVERY] if name not in about["helper_joints"]][:MOST]
    muscles = [{"name": "muscle %d" % number, "bone": joint, "group": "body", "center": [0, 0, 0],
                "radii": [radius, 1.5 * radius, radius]} for number, joint in enumerate(joints)]
    rig = {"format": "sinew-rig", "version": 1, "character": str(character.resolve()), "groups": [{"name": "body"}],
           "primitives": muscles}
    path = folder / (character.stem + ".rig.json")
    path.write_text(json.dumps(rig))
    return path
