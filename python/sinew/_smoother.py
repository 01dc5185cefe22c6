# python/sinew/_smoother.py: from character, rig and pose to surfaces.
from . import _sinew
from ._character import Character
from ._checks import expect
from ._rig import Rig


class Surface(_sinew.Surface):
    """The smoothed mesh of one moment, as NumPy arrays over the memory it was made in; they keep it.

    positions, normals: [V, 3] of the vertices, world; yours to write into. triangles: [T, 3] of them, counter-clockwise.
    uv: [D, 2], which has several rows for a vertex on a seam; uv_triangles: [T, 3] of uv rows, corner by corner as
    triangles; uv_vertices: [D] the vertex of each. v counts downwards, as in glTF. colors: [D, 4] linear
    RGBA, without rows where the mesh has none. split_positions, split_normals: one row
    for each row of uv, for vertex buffers. All but positions and normals are read only, and shared between frames.
    """

    __slots__ = ("_clip", "_time")

    def __init__(self, memory, clip, time):
        super().__init__(memory)
        self._clip = clip
        self._time = time

    @property
    def clip(self):
        """Name of the clip it was posed by, or None."""
        return self._clip

    @property
    def time(self):
        """Seconds into that clip."""
        return self._time

    def save(self, path):
        """Writes it as .obj, .ply or .glb, by the name's ending, with what its arrays hold now."""
        self._save(path)

    def __repr__(self):
        return "<sinew.Surface: %d vertices, %d triangles>" % (len(self.positions), len(self.triangles))


class Smoother(_sinew.Smoother):
    """Makes surfaces of one character with one rig. Any thread may call it, several at once.

    The rig is taken as it is now; prepare() takes it again after edits. leave_out_missing: muscles whose bone the
    character lacks are left out; otherwise such a rig is refused.
    """

    __slots__ = ("_character",)

    def __init__(self, character, rig=None, *, leave_out_missing=False):
        super().__init__(expect(character, Character, "character"))
        self._character = character
        self.prepare(Rig(character) if rig is None else rig, leave_out_missing=leave_out_missing)

    @property
    def character(self):
        """The character it poses."""
        return self._character

    def prepare(self, rig, *, leave_out_missing=False):
        """Takes a rig. Keeps what did not change since the last one; refused, the last one stays in force."""
        self._prepare(expect(rig, Rig, "rig"), bool(leave_out_missing))

    def __call__(self, clip=None, time=0.0, *, bones=None, shapes=None, flex=0.0, flexed=None, threads=0):
        """The surface of one moment.

        clip, time: the pose of a clip at a time in seconds; without a clip the bind pose.
        bones: any pose in its place, [bones, 4, 4]; with a clip too, keys and shapes go by that.
        shapes: weights of shapes by name in place of those of the file or clip.
        flex, flexed: activation that is added to muscle lines, 0 to 1; to those named, else to all.
        threads: at most so many; 0: all cores. The surface is the same, bit for bit.
        """
        return Surface(self._smooth(clip, time, bones, shapes, flex, flexed, threads), clip, float(time))

    def frames(self, clip, fps=30.0, threads=0):
        """The surfaces of a clip, one after the other: frame i is at i / fps seconds, the clip's end is the last.

        Some are made ahead, on so many threads (0: all cores), while the loop waits. Each stays valid for as long as it
        is held.
        """
        count = self._count_frames(clip, fps)
        ahead = _sinew.threads_meant(threads)
        return self._each(clip, float(fps), count, ahead, threads)

    def _each(self, clip, fps, count, ahead, threads):
        for first in range(0, count, ahead):
            made = self._frames(clip, fps, first, min(ahead, count - first), threads)
            made.reverse()
            for frame in range(first, first + len(made)):
                yield Surface(made.pop(), clip, frame / fps)

    def __repr__(self):
        return "<sinew.Smoother of %r>" % self._character.name
