# examples/python/muscles_by_rule.py: a muscle along every long bone, as thick as the limb around it.
"""muscles_by_rule.py CHARACTER OUT.rig.json [SHARE]: SHARE of the limb's thickness, 0.9 if left out."""
import sys

import numpy
import sinew

LEAST_LENGTH = 0.06  # Of the height: shorter bones get none.


def skin_of(character, bone):
    """Vertices that follow the bone more than all others together."""
    mesh = character.mesh
    follows = (mesh.influence_bones == bone.number) & (mesh.influence_weights > 0.5)
    vertex = numpy.repeat(numpy.arange(len(mesh.positions)), numpy.diff(mesh.influence_begin))
    return mesh.positions[numpy.unique(vertex[follows])]


def towards(direction):
    """The rotation x, y, z, w that turns the y axis into a direction."""
    x, y, z = direction / numpy.linalg.norm(direction)
    turn = numpy.array([z, 0.0, -x, 1.0 + y])
    length = numpy.linalg.norm(turn)
    return turn / length if length > 1e-6 else numpy.array([1.0, 0.0, 0.0, 0.0])


def add_muscles(rig, share):
    character = rig.character
    bind = character.sample()
    for bone in character.bones:
        children = [other for other in character.bones if other.parent == bone.number]
        if len(children) != 1:
            continue
        to_bone = numpy.linalg.inv(bind[bone.number].astype(float))
        end = (to_bone @ bind[children[0].number][:, 3])[:3]
        scale = numpy.linalg.norm(bind[bone.number][:3, 0])  # Bone space may have other units.
        length = numpy.linalg.norm(end)
        skin = skin_of(character, bone)
        if length * scale < LEAST_LENGTH * character.height or len(skin) < 8:
            continue
        inside = numpy.hstack([skin, numpy.ones((len(skin), 1))]) @ to_bone.T
        aside = inside[:, :3] - numpy.outer(inside[:, :3] @ (end / length), end / length)
        middle = (aside.min(axis=0) + aside.max(axis=0)) / 2  # Few bones lie in the middle of their limb.
        thickness = numpy.quantile(numpy.linalg.norm(aside - middle, axis=1), 0.3)
        rig.add_muscle(bone.name, bone=bone.name, center=end / 2 + middle, rotation=towards(end),
                       radii=(share * thickness, 0.5 * length, share * thickness), group="muscles")


def main(character_file, out, share=0.9):
    rig = sinew.Rig(sinew.load(character_file))
    add_muscles(rig, share)
    if len(rig) == 0:
        raise sinew.Error("no bone is long enough for a muscle", file=character_file)
    rig.save(out)
    print("%s: %d muscles" % (out, len(rig)))


if __name__ == "__main__":
    try:
        main(sys.argv[1], sys.argv[2], *map(float, sys.argv[3:4]))
    except sinew.Error as error:
        sys.exit("muscles_by_rule: %s" % error)
