# tests/python/clips_test.py: clips of other files, on characters and rigs.
import json

from tools import ASSETS, Case, main, needs_program, numpy, run, sinew
from clip_gltf import write_clips, write_still  # noqa: E402: tools says where it is

MAN = ASSETS / "humanoid.glb"


class Clips(Case):
    def setUp(self):
        super().setUp()
        self.still = write_still(MAN, self.folder / "still.glb")
        self.walk = write_clips(MAN, self.folder / "walk.glb", {"Walk": "Stroll"})
        self.dance = write_clips(MAN, self.folder / "dance.glb", {"Dance": "Dance", "Flex": "Stroll"})

    def test_added_clips_play_as_in_their_own_file(self):
        still = sinew.load(self.still)
        self.assertEqual(still.clips, {})
        self.assertEqual(still.add_clips(self.walk), [])
        self.assertEqual(list(still.clips), ["Stroll"])
        self.assertEqual(still.duration("Stroll"), self.character.duration("Walk"))
        for time in (0.0, 0.31, 0.9):
            self.same_bits(still.sample("Stroll", time), self.character.sample("Walk", time))
        told = still.add_clips(str(self.dance))
        self.assertEqual(list(still.clips), ["Stroll", "Dance", "Stroll 2"])
        self.assertEqual(len(told), 1, told)
        self.assertIn('is called "Stroll 2"', told[0])
        still.add_clips(self.walk)  # Read again, not added twice.
        self.assertEqual(list(still.clips), ["Stroll", "Dance", "Stroll 2"])
        self.assertGreater(still.duration("Range of motion"), 0)

    def test_rig_stores_clip_files(self):
        rig = sinew.Rig(sinew.load(self.still))
        rig.add_muscle("a", bone="chest", radii=(0.1, 0.1, 0.1))
        rig.add_clips(self.walk)
        rig.add_clips(self.walk)
        self.assertEqual(rig.clip_files, ("walk.glb",))
        surface = sinew.Smoother(rig.character, rig)(clip="Stroll", time=0.4)
        (self.folder / "rigs").mkdir()
        rig.save(self.folder / "rigs" / "a.rig.json")
        self.assertEqual(json.loads((self.folder / "rigs" / "a.rig.json").read_text())["clips"], ["../walk.glb"])
        self.assertEqual(rig.clip_files, ("../walk.glb",))
        rig.add_clips(self.dance)
        self.assertEqual(rig.clip_files, ("../walk.glb", "../dance.glb"))
        again = sinew.load_rig(self.folder / "rigs" / "a.rig.json")
        self.assertEqual((list(again.character.clips), again.missing_clips), (["Stroll"], []))
        self.same_bits(sinew.Smoother(again.character, again)(clip="Stroll", time=0.4).positions, surface.positions)
        self.assertEqual(again.copy().clip_files, again.clip_files)

    def test_missing_clip_file_is_reported(self):
        rig = sinew.Rig(sinew.load(self.still))
        rig.add_clips(self.walk)
        rig.add_clips(self.dance)
        rig.save(self.folder / "a.rig.json")
        self.walk.unlink()
        again = sinew.load_rig(self.folder / "a.rig.json")
        self.assertEqual(list(again.character.clips), ["Dance", "Stroll"])
        missing, = again.missing_clips
        self.assertIn("walk.glb", missing)
        self.assertEqual(again.clip_files, ("walk.glb", "dance.glb"))
        again.save(self.folder / "a.rig.json")
        self.assertEqual(json.loads((self.folder / "a.rig.json").read_text())["clips"], ["walk.glb", "dance.glb"])

    def test_invalid_clip_files_are_refused(self):
        still = sinew.load(self.still)
        rig = sinew.Rig(still)
        before = rig.copy()
        (self.folder / "bad.glb").write_bytes(b"nothing of this kind")
        for add in (still.add_clips, rig.add_clips):
            for path in (self.folder / "none.glb", self.folder / "bad.glb", self.still):
                self.assertEqual(self.refusal(add, path).file, str(path))
            for wrong in (None, 3, []):
                self.assertIn("expected a path", self.refusal(add, wrong).reason)
        self.assertEqual((still.clips, rig), ({}, before))

    def test_unmatched_bones_are_reported(self):
        lizard = write_clips(ASSETS / "demo.glb", self.folder / "lizard.glb", {"Walk": "Crawl"})
        still = sinew.load(self.still)
        told = still.add_clips(lizard)
        self.assertEqual(list(still.clips), ["Crawl"])
        self.assertIn("tail.1", " ".join(told))

    @needs_program
    def test_surfaces_and_exports_match_the_command_line(self):
        rig = sinew.Rig(sinew.load(self.still))
        rig.detail, rig.depth = "uniform", 1
        rig.add_muscle("a", bone="thigh.L", center=(0, 0.15, 0.03), radii=(0.06, 0.12, 0.06))
        rig.add_clips(self.walk)
        rig.save(self.folder / "a.rig.json")
        run("smooth", self.folder / "a.rig.json", "--clip", "Stroll", "--time", 0.3, "-o", self.folder / "theirs.ply")
        opened = sinew.load_rig(self.folder / "a.rig.json")
        sinew.Smoother(opened.character, opened)(clip="Stroll", time=0.3).save(self.folder / "ours.ply")
        self.assertEqual((self.folder / "ours.ply").read_bytes(), (self.folder / "theirs.ply").read_bytes())
        sinew.export(opened, self.folder / "out.glb", weights="transferred")
        self.assertEqual(list(sinew.load(self.folder / "out.glb").clips), ["Stroll"])
        told, = json.loads(run("inspect", self.folder / "a.rig.json", "--json"))["clip_files"]
        self.assertEqual(told, {"file": "walk.glb", "missing": None, "clips": ["Stroll"], "unmatched_bones": [],
                                "unmoved_bones": []})


if __name__ == "__main__":
    main()
