# tests/python/export_test.py: exports are those of the command line, tell how far they are, and can be stopped.
import _thread
import threading

from tools import ASSETS, Case, main, needs_program, run, sinew


class Exports(Case):
    @classmethod
    def setUpClass(cls):
        cls.rig = sinew.load_rig(ASSETS / "tangle.rig.json")
        cls.clip = next(iter(cls.rig.character.clips))

    @needs_program
    def test_files_match_the_command_line(self):
        theirs, ours, rig = self.folder / "theirs.glb", self.folder / "ours.glb", ASSETS / "tangle.rig.json"
        report = sinew.export(self.rig, ours, helpers=3)
        run("export", rig, "--joints", 3, "-o", theirs)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())
        self.assertEqual(report["bytes"], len(ours.read_bytes()))
        self.assertIn(self.clip, report["clips"])
        sinew.export(self.rig, ours, weights="transferred", mesh="original", clips=[self.clip])
        run("export", rig, "--as", "skinned", "--weights", "transferred", "--mesh", "original", "--clip", self.clip, "-o", theirs)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())
        theirs, ours = theirs.with_suffix(".pc2"), ours.with_suffix(".pc2")
        report = sinew.export_baked(self.rig, ours, self.clip, fps=5)
        run("export", rig, "--as", "baked", "--clip", self.clip, "--fps", 5, "-o", theirs)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())
        self.assertGreater(report["frames"], 1)

    def test_progress_increases_and_can_cancel(self):
        shares = []
        sinew.export(self.rig, self.folder / "a.glb", weights="transferred", progress=shares.append)
        self.assertEqual(shares, sorted(shares))
        self.assertTrue(shares and 0 <= shares[0] and shares[-1] <= 1)
        error = self.refusal_of_cancel(progress=lambda share: False)
        self.assertEqual(error.reason, "cancelled")

    def refusal_of_cancel(self, **named):
        with self.assertRaises(sinew.Error) as caught:
            sinew.export(self.rig, self.folder / "b.glb", weights="transferred", **named)
        self.assertFalse((self.folder / "b.glb").exists())
        return caught.exception

    def test_exception_from_progress_propagates(self):
        class Own(Exception):
            pass

        def fail(share):
            raise Own("enough")
        with self.assertRaises(Own):
            sinew.export(self.rig, self.folder / "b.glb", weights="transferred", progress=fail)
        self.assertFalse((self.folder / "b.glb").exists())

    def test_ctrl_c_stops_an_export(self):
        timer = threading.Timer(0.05, _thread.interrupt_main)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            for number in range(1000):
                sinew.export(self.rig, self.folder / "c.glb", helpers=24)
        timer.join()

    def test_changed_character_file_is_refused(self):
        copy = self.folder / "copy.glb"
        copy.write_bytes((ASSETS / "tangle.glb").read_bytes())
        rig = sinew.load_rig(ASSETS / "tangle.rig.json", sinew.load(copy))
        copy.write_bytes((ASSETS / "demo.glb").read_bytes())
        self.refusal(sinew.export, rig, self.folder / "d.glb", weights="transferred")


if __name__ == "__main__":
    main()
