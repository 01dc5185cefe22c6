# tests/python/same_bits_test.py: surfaces are those of the command line and of the pose, bit for bit.
import sys
import threading
import time

from tools import ASSETS, Case, main, needs_program, numpy, run, sinew
from glb_reader import Glb  # noqa: E402: tools says where it is

RIGS = ("humanoid", "horse", "demo", "humanoid-flex", "wrapped")


def obj(path):
    """Positions and triangles; nine digits are enough for every float."""
    rows = [line.split() for line in path.read_text().splitlines()]
    positions = numpy.array([row[1:4] for row in rows if row and row[0] == "v"], numpy.float64).astype(numpy.float32)
    corners = [[int(corner.split("/")[0]) - 1 for corner in row[1:]] for row in rows if row and row[0] == "f"]
    return positions, numpy.array(corners, numpy.int32)


def ply(path):
    """Vertices by name, and the triangles."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    count, names, faces, formats = 0, [], 0, {"float": "<f4", "uchar": "u1", "float32": "<f4", "uint8": "u1"}
    for words in (line.split() for line in head.decode().splitlines()):
        if words[:2] == ["element", "vertex"]:
            count = int(words[2])
        elif words[:2] == ["element", "face"]:
            faces = int(words[2])
        elif words[0] == "property" and words[1] != "list":
            names.append((words[2], formats[words[1]]))
    vertices = numpy.frombuffer(body, numpy.dtype(names), count)
    lists = numpy.frombuffer(body[vertices.nbytes:], numpy.dtype([("n", "u1"), ("v", "<i4", 3)]), faces)
    return vertices, lists["v"]


class SameBits(Case):
    @needs_program
    def test_surfaces_match_the_command_line(self):
        for name in RIGS:
            with self.subTest(rig=name):
                rig = sinew.load_rig(ASSETS / (name + ".rig.json"))
                clip = next(iter(rig.character.clips))
                surface = sinew.Smoother(rig.character, rig)(clip=clip, time=0.3)
                for ending in (".obj", ".ply", ".glb"):
                    theirs, ours = self.folder / ("theirs" + ending), self.folder / ("ours" + ending)
                    run("smooth", ASSETS / (name + ".rig.json"), "--clip", clip, "--time", 0.3, "-o", theirs)
                    surface.save(ours)
                    self.assertEqual(ours.read_bytes().replace(b"ours", b"theirs"), theirs.read_bytes())
                self.holds_what_the_files_say(surface)

    def holds_what_the_files_say(self, surface):
        """Readers that share no code with what wrote the files find what the arrays hold."""
        positions, triangles = obj(self.folder / "theirs.obj")
        self.same_bits(positions, surface.positions)
        self.same_bits(triangles, surface.triangles)
        vertices, split = ply(self.folder / "theirs.ply")
        for axis, name in enumerate("xyz"):
            self.same_bits(vertices[name], numpy.ascontiguousarray(surface.split_positions[:, axis]))
            self.same_bits(vertices["n" + name], numpy.ascontiguousarray(surface.split_normals[:, axis]))
        self.assertEqual(split.tolist(), surface.uv_triangles.tolist())
        u, v = (n for n in vertices.dtype.names if n in ("s", "t", "u", "v", "texture_u", "texture_v"))
        self.same_bits(vertices[u], numpy.ascontiguousarray(surface.uv[:, 0]))
        self.same_bits(vertices[v], 1 - surface.uv[:, 1])
        glb = Glb(self.folder / "theirs.glb")
        parts = glb.json["meshes"][0]["primitives"]
        self.assertEqual(sum(len(glb.rows(part["indices"])) for part in parts), 3 * len(surface.triangles))

    def test_clip_matches_its_sampled_pose(self):
        for seconds in (0.0, 0.37, 1.0):
            clip = self.smoother(clip="Walk", time=seconds)
            bones = self.smoother(bones=self.character.sample("Walk", seconds))
            self.same_bits(clip.positions, bones.positions)
            self.same_bits(clip.normals, bones.normals)
        self.same_bits(self.smoother().positions, self.smoother(bones=self.character.sample()).positions)

    def test_frames_match_single_surfaces(self):
        for threads in (1, 3):
            frames = list(self.smoother.frames("Walk", fps=10, threads=threads))
            self.assertEqual([round(frame.time * 10) for frame in frames], list(range(12)))
            for number, frame in enumerate(frames):
                self.same_bits(frame.positions, self.smoother(clip="Walk", time=number / 10).positions)

    def test_concurrent_surfaces_match_sequential_ones(self):
        """Four threads on one character: each with a smoother of its own, then all with one."""
        times = [0.05 * number for number in range(12)]
        expected = [self.smoother(clip="Dance", time=each).positions for each in times]
        for own in (True, False):
            made, failed = {}, []

            def work(first):
                try:
                    smoother = sinew.Smoother(self.character, self.rig) if own else self.smoother
                    for number in range(first, len(times), 4):
                        made[number] = smoother(clip="Dance", time=times[number], threads=1).positions
                except Exception as error:
                    failed.append(error)
            threads = [threading.Thread(target=work, args=(first,)) for first in range(4)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertFalse(failed, failed)
            for number, positions in enumerate(expected):
                self.same_bits(made[number], positions)

    def test_smoothing_releases_the_interpreter_lock(self):
        """Another thread runs while a large surface is made, though the interpreter makes no thread wait for another."""
        rig = self.rig.copy()
        rig.depth = 12
        smoother = sinew.Smoother(self.character, rig)
        counted, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0)  # Lets go of the lock; nobody takes it away.
        thread = threading.Thread(target=count)
        interval = sys.getswitchinterval()
        try:
            sys.setswitchinterval(1000)
            thread.start()
            before = counted[0]
            smoother(clip="Walk", time=0.1, threads=1)
            during = counted[0] - before
            before = counted[0]
            sum(range(200000))  # This one keeps the lock.
            self.assertEqual(counted[0], before)
        finally:
            stop.set()
            sys.setswitchinterval(interval)
            thread.join()
        self.assertGreater(during, 0)

    def test_edited_rig_matches_a_fresh_smoother(self):
        """What is prepared again is what is prepared anew, and undoing an edit gives the bits back."""
        smoother, rig = sinew.Smoother(self.character, self.rig), self.rig.copy()
        before = smoother(clip="Walk", time=0.2).positions.copy()
        muscle = rig.muscles[0]
        radii = muscle.radii
        muscle.radii = tuple(1.3 * radius for radius in radii)
        smoother.prepare(rig)
        edited = smoother(clip="Walk", time=0.2).positions
        self.assertFalse(numpy.array_equal(edited, before))
        self.same_bits(edited, sinew.Smoother(self.character, rig)(clip="Walk", time=0.2).positions)
        muscle.radii = radii
        smoother.prepare(rig)
        self.same_bits(smoother(clip="Walk", time=0.2).positions, before)

    def test_local_transforms_of_the_file_give_the_rest_pose(self):
        """Nothing set is rest and clip, bit for bit; a joint's own transform, read from the file apart, changes nothing."""
        self.same_bits(self.character.from_locals(), self.character.rest())
        self.same_bits(self.character.from_locals(clip="Walk", time=0.3), self.character.sample("Walk", 0.3))
        nodes = {node["name"]: node for node in Glb(ASSETS / "humanoid.glb").json["nodes"] if "name" in node}
        locals_ = [{}, {}, {}]
        for bone in self.character.bones:
            for kind, key, usual in ((0, "rotation", (0, 0, 0, 1)), (1, "translation", (0, 0, 0)), (2, "scale", (1, 1, 1))):
                locals_[kind][bone.name] = nodes[bone.name].get(key, usual)
        self.same_bits(self.character.from_locals(*locals_), self.character.rest())
        raised = self.character.from_locals(translations={"head": (0, 5, 0)})
        moved = [bone.name for bone in self.character.bones if bits_differ(raised, self.character.rest(), bone.number)]
        self.assertEqual(moved, ["head"])

    def test_rotated_joints_move_their_descendants(self):
        elbow = next(bone for bone in self.character.bones if bone.name == "forearm.L")
        half = numpy.sqrt(0.5)
        turned, still = self.character.turned({elbow.name: (half, 0, 0, half)}), self.character.sample()
        moved = {bone.name for bone in self.character.bones if bits_differ(turned, still, bone.number)}
        below = {elbow.name}
        for bone in self.character.bones:
            if bone.parent >= 0 and self.character.bones[bone.parent].name in below:
                below.add(bone.name)
        self.assertEqual(moved, below)
        quarter = numpy.linalg.inv(still[elbow.number].astype(float)) @ turned[elbow.number]
        numpy.testing.assert_allclose(quarter[:3, :3], [[1, 0, 0], [0, 0, -1], [0, 1, 0]], atol=1e-5)


def bits_differ(one, other, number):
    return not numpy.array_equal(one[number], other[number])


if __name__ == "__main__":
    main()
