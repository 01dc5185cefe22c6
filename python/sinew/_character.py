# python/sinew/_character.py: a character: what a glTF file becomes.
from typing import NamedTuple

from . import _sinew


class Bone(NamedTuple):
    """A joint of the skin."""

    number: int  # In every array of bones.
    name: str  # As rigs call it: the file's name where that is unique, else the path.
    path: str  # Names from the root joint, "/" between.
    parent: int  # Index of the nearest joint above, or -1.


class Character(_sinew.Character):
    """Control mesh, bones, clips and materials of a .glb, .gltf or .vrm file. Read only, but that clips can be added.

    Every matrix of a bone goes from its space to the world and multiplies columns: world = matrix @ [x, y, z, 1].
    """

    __slots__ = ("_made",)

    def __init__(self, path):
        super().__init__(path)
        self._made = {}

    def _once(self, key, make):
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]

    @property
    def bones(self):
        """All bones, parents before children."""
        return self._once("bones", lambda: tuple(Bone(*row) for row in self._bones()))

    @property
    def names(self):
        """Names of the bones, as rigs call them."""
        return self._once("names", lambda: tuple(bone.name for bone in self.bones))

    @property
    def clips(self):
        """Seconds that each clip lasts, by name, in the order of the file; then those that were added."""
        clips = {}
        for name, seconds in self._clips():
            clips.setdefault(name, seconds)
        return clips

    def add_clips(self, path):
        """Adds the clips of another file, .glb, .gltf or .vrm, with a mesh or without, with these bones or others.

        Returns what did not match, a line each. A rig remembers such files: Rig.add_clips.
        """
        return self._add_clips(path)

    def nodes(self):
        """Number of the file's node that each bone is, in the order of bones, for what reads the glTF itself as well."""
        return self._once("nodes", self._nodes)

    def duration(self, clip):
        """Seconds that a clip lasts, the made clip "Range of motion" too."""
        return self._duration(clip)

    def sample(self, clip=None, time=0.0):
        """Matrices of the bones [bones, 4, 4] at a time of a clip, seconds; without a clip in the bind pose.

        "Range of motion" is a clip made from the joints. Times past the end are the end.
        """
        return self._pose(clip, time)

    def rest(self):
        """Matrices of the bones [bones, 4, 4] as the file's nodes stand when nothing is animated."""
        return self._rest()

    def turned(self, turns, clip=None, time=0.0):
        """The same as sample(), with joints turned: what hangs on them follows.

        turns: a dict of rotations x, y, z, w by bone, each in the joint's own axes: its local rotation times this.
        """
        return self._turned(turns, clip, time)

    def from_locals(self, rotations=None, translations=None, scales=None, *, clip=None, time=0.0):
        """Matrices of the bones [bones, 4, 4] with joints set in their parents' space, as a motion capture gives them.

        Dicts by bone: rotations x, y, z, w, translations and scales x, y, z. What is not given is as in the clip then, or as
        the file's nodes stand at rest.
        """
        return self._from_locals(translations, rotations, scales, clip, time)

    def facts(self):
        """What `sinew inspect` counts: a dict with its words."""
        return self._facts()

    def __repr__(self):
        return "<sinew.Character %r: %d bones, %d clips, %d triangles>" % (
            self.name, len(self.bones), len(self.clips), len(self.mesh.triangles))


def load(path):
    """Opens a character: a .glb, .gltf or .vrm file."""
    return Character(path)
