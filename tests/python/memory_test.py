# tests/python/memory_test.py: arrays look into the surface's own memory, and never dangle.
import gc
import pickle
import weakref

from tools import Case, main, numpy, sinew


class Memory(Case):
    def test_arrays_are_views_of_the_same_memory(self):
        surface = self.smoother(clip="Walk", time=0.1)
        for name in ("positions", "normals", "triangles", "uv", "uv_triangles", "uv_vertices", "displacement"):
            with self.subTest(name=name):
                array = getattr(surface, name)
                self.assertTrue(numpy.shares_memory(array, getattr(surface, name)))
                self.assertFalse(array.flags.owndata)
                self.assertTrue(array.flags.c_contiguous)
        mesh = self.character.mesh
        for name in ("positions", "normals", "triangles", "uv", "uv_triangles", "materials", "influence_weights"):
            with self.subTest(name=name):
                self.assertTrue(numpy.shares_memory(getattr(mesh, name), getattr(self.character.mesh, name)))
                self.assertFalse(getattr(mesh, name).flags.writeable)
                with self.assertRaises(ValueError):
                    getattr(mesh, name)[0] = 0

    def test_frames_share_constant_arrays(self):
        one, other = self.smoother(clip="Walk", time=0.1), self.smoother(clip="Walk", time=0.2)
        for name in ("triangles", "uv", "uv_triangles", "uv_vertices"):
            self.assertTrue(numpy.shares_memory(getattr(one, name), getattr(other, name)), name)
            self.assertFalse(getattr(one, name).flags.writeable)
        self.assertFalse(numpy.shares_memory(one.positions, other.positions))

    def test_arrays_outlive_surface_and_smoother(self):
        smoother = sinew.Smoother(self.character, self.rig)
        surface = smoother(clip="Walk", time=0.1)
        positions, triangles, expected = surface.positions, surface.triangles, surface.positions.copy()
        gone = weakref.ref(smoother)
        del surface, smoother
        gc.collect()
        self.assertIsNone(gone())
        self.same_bits(positions, expected)
        self.assertLess(int(triangles.max()), len(positions))

    def test_referenced_arrays_are_not_overwritten(self):
        """All frames stay as they were, however many are made; memory that nobody holds is used again."""
        smoother = sinew.Smoother(self.character, self.rig)
        held = [frame.positions for frame in smoother.frames("Walk", fps=20)]
        copies = [positions.copy() for positions in held]
        for _ in range(3):
            for frame in smoother.frames("Dance", fps=5):
                frame.positions[:] = -1
        smoother.prepare(sinew.Rig(self.character))
        smoother(clip="Dance", time=1.0)
        for positions, copy in zip(held, copies):
            self.same_bits(positions, copy)

    def test_memory_is_reused(self):
        smoother = sinew.Smoother(self.character, self.rig)
        places = set()
        for number in range(20):
            surface = smoother(clip="Walk", time=0.05 * number)
            places.add(surface.positions.__array_interface__["data"][0])
            del surface
        self.assertEqual(len(places), 1)

    def test_surface_in_reused_memory_matches_a_new_one(self):
        """Nothing of what was written into the memory before is left."""
        smoother = sinew.Smoother(self.character, self.rig)
        surface = smoother(clip="Walk", time=0.4)
        surface.positions[:] = numpy.nan
        surface.normals[:] = 7
        del surface
        again = smoother(clip="Walk", time=0.4)
        new = sinew.Smoother(self.character, self.rig)(clip="Walk", time=0.4)
        self.same_bits(again.positions, new.positions)
        self.same_bits(again.normals, new.normals)
        self.same_bits(again.split_normals, new.split_normals)

    def test_abandoned_loop_keeps_its_first_frame_valid(self):
        for _ in range(3):
            frames = self.smoother.frames("Walk", fps=30, threads=2)
            first = next(frames)
            del frames
            gc.collect()
            self.assertTrue(numpy.isfinite(first.positions).all())

    def test_modified_positions_are_saved(self):
        surface = self.smoother()
        surface.positions[:, 1] += 5
        surface.save(self.folder / "up.obj")
        heights = [float(line.split()[2]) for line in (self.folder / "up.obj").read_text().splitlines()
                   if line.startswith("v ")]
        self.assertGreater(min(heights), 4)
        surface.positions[3, 1] = numpy.nan
        error = self.refusal(surface.save, self.folder / "nan.obj")
        self.assertEqual(error.place, "positions[3]")
        self.assertFalse((self.folder / "nan.obj").exists())

    def test_matrices_are_copies(self):
        bones = self.character.sample("Walk", 0.1)
        bones[:] = 0
        self.assertTrue(self.character.sample("Walk", 0.1).any())

    def test_errors_can_be_pickled(self):
        error = self.refusal(sinew.load, "nowhere.glb")
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.file, again.place, again.reason),
                         (str(error), error.file, error.place, error.reason))


if __name__ == "__main__":
    main()
