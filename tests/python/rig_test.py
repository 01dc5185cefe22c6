# tests/python/rig_test.py: edits of a rig: muscles, twins, groups, lines, shapes, files.
import json
import os
import pathlib
import shutil

from tools import ASSETS, Case, bits, main, needs_program, numpy, run, sinew


class Rigs(Case):
    def setUp(self):
        super().setUp()
        self.new = sinew.Rig(self.character)

    def test_new_rig_has_the_editors_defaults(self):
        """Empty, with adaptive detail; its surface is that of the bare character."""
        self.assertEqual((len(self.new), self.new.groups, self.new.detail), (0, (), "adaptive"))
        self.assertEqual(json.loads(self.new.to_json())["character"], "humanoid.glb")
        self.assertEqual(self.new.grooves, float(numpy.float32(0.015)))

    def test_grooves_match_the_file(self):
        for value in (0.25, 1, 0):
            self.new.grooves = value
            self.assertEqual(self.new.grooves, value)
            self.assertEqual(json.loads(self.new.to_json())["surface"].get("grooves", 0), value)
        self.assertNotIn("grooves", self.new.to_json())
        self.assertEqual(sinew.load_rig(ASSETS / "humanoid.rig.json", self.character).grooves, 0)

    def test_muscle_fields_match_the_file(self):
        muscle = self.new.add_muscle("a", bone="chest", center=(0.1, 0.2, 0.3), radii=numpy.array([0.1, 0.2, 0.3]),
                                     rotation=[0, 0, 0, 1], group="torso", reach=1.5, amount=0.5, sign=-1, core=0.5,
                                     belly=0.1, bend=(0.2, -0.1), territory=["chest", "spine"])
        told = json.loads(self.new.to_json())["primitives"][0]
        for name, value in told.items():
            if name not in ("kind",):
                ours = getattr(muscle, name)
                ours = list(ours) if isinstance(ours, tuple) else ours
                numpy.testing.assert_equal(numpy.float32(ours) if isinstance(value, (float, list)) and name != "territory"
                                           else ours, numpy.float32(value) if isinstance(value, (float, list)) and
                                           name != "territory" else value, name)
        self.assertEqual(self.new["a"], muscle)
        self.assertIn("a", self.new)
        self.assertNotIn("b", self.new)
        self.assertNotIn(3, self.new)

    def test_twins(self):
        muscle = self.new.add_muscle("thigh L", bone="thigh.L", center=(0.01, -0.1, 0.02), radii=(0.1, 0.2, 0.1))
        twin = self.new.mirror("thigh L")
        self.assertEqual((twin.name, twin.bone, twin.mirror, muscle.mirror), ("thigh R", "thigh.R", "thigh L", "thigh R"))
        muscle.radii = (0.12, 0.2, 0.1)
        self.assertEqual(twin.radii, muscle.radii)
        twin.reach = 1.7
        self.assertEqual(muscle.reach, twin.reach)
        muscle.group = "legs"
        self.assertEqual(twin.group, "legs")
        muscle.name = "upper leg L"
        self.assertEqual(twin.name, "upper leg R")
        smoother = sinew.Smoother(self.character, self.new)
        self.assertTrue(numpy.isfinite(smoother().positions).all())
        self.new.remove(muscle)
        self.assertIsNone(twin.mirror)
        self.refusal(getattr, muscle, "radii")
        self.assertEqual(repr(muscle), "<sinew.Muscle, removed>")

    def test_leaders_contain_one_muscle_of_each_pair(self):
        rig = sinew.load_rig(ASSETS / "humanoid.rig.json", self.character)
        before = {muscle.name: muscle.radii for muscle in rig}
        for muscle in rig.leaders:
            muscle.radii = [2 * radius for radius in muscle.radii]
        self.assertLess(len(rig.leaders), len(rig))
        for muscle in rig:
            self.assertEqual(muscle.radii, tuple(2 * radius for radius in before[muscle.name]), muscle.name)

    def test_groups(self):
        self.new.add_muscle("a", bone="chest")
        self.assertEqual(self.new.groups, ("muscles",))
        self.new.link("muscles", "legs")
        self.assertEqual((self.new.groups, self.new.links), (("muscles", "legs"), (("muscles", "legs"),)))
        self.new.rename_group("legs", "limbs")
        self.assertEqual(self.new.links, (("muscles", "limbs"),))
        self.assertEqual(self.new.link_amount("limbs", "muscles"), 1)
        self.new.link("limbs", "muscles", 0.25)
        self.assertEqual(self.new.links, (("muscles", "limbs"),))
        self.assertEqual(self.new.link_amount("limbs", "muscles"), 0.25)
        self.assertIn('["muscles", "limbs", 0.25]', self.new._json())
        for amount in (-0.5, 1.5, "half", float("nan")):
            self.refusal(self.new.link, "limbs", "muscles", amount)
        self.refusal(self.new.link_amount, "limbs", "tail")
        self.refusal(self.new.link, "limbs", "limbs")
        self.refusal(self.new.remove_group, "muscles")
        self.new.unlink("muscles", "limbs")
        self.new.remove_group("limbs")
        self.assertEqual((self.new.groups, self.new.links), (("muscles",), ()))

    def test_keys_of_links_stay_until_the_groups_are_unlinked(self):
        told = json.loads((ASSETS / "humanoid.rig.json").read_text())
        a, b = told["links"][0]
        animated = [{"parameter": "link_amount", "keys": [{"times": [0], "values": [0.25]}]}]
        told["links"][0] = {"groups": [a, b], "amount": 0.5, "animated": animated}
        told["version"] = 3
        file = self.folder / "keyed.rig.json"
        file.write_text(json.dumps(told))
        rig = sinew.load_rig(file, self.character)
        self.assertEqual((rig.links[0], rig.link_amount(a, b)), ((a, b), 0.5))
        rig.link(b, a, 0.75)
        self.assertEqual(json.loads(rig.to_json())["links"][0],
                         {"groups": [a, b], "amount": 0.75, "animated": animated})
        rig.detail, rig.depth = "uniform", 2
        clip = next(iter(self.character.clips))
        keyed = next(iter(sinew.Smoother(self.character, rig).frames(clip, fps=10))).positions.copy()
        rig.unlink(a, b)
        rig.link(a, b, 0.25)
        constant = next(iter(sinew.Smoother(self.character, rig).frames(clip, fps=10))).positions
        self.assertEqual(bits(keyed), bits(constant))
        self.assertNotIn("animated", rig.to_json())

    def test_invalid_and_duplicate_names_are_refused(self):
        self.new.add_muscle("a", bone="chest")
        for name in ("a", "", None, 3):
            before = self.new.copy()
            self.refusal(self.new.add_muscle, name, bone="chest")
            self.assertEqual(self.new, before)

    def test_lines(self):
        line = self.new.add_line("biceps L", origin=("upper_arm.L", (0, 0.02, 0)), insertion=("forearm.L", (0, 0.1, 0)),
                                 rest=0.9, flex=(0.4, 0.1))
        muscle = self.new.add_muscle("biceps L", bone="upper_arm.L", center=(0, 0.1, 0.03), radii=(0.04, 0.09, 0.04),
                                     line="biceps L")
        self.assertEqual((muscle.line, line.origin[0], line.rest), ("biceps L", "upper_arm.L", numpy.float32(0.9)))
        self.new.mirror(muscle)
        self.assertEqual([each.name for each in self.new.lines], ["biceps L", "biceps R"])
        smoother = sinew.Smoother(self.character, self.new)
        self.assertFalse(numpy.array_equal(smoother().positions, smoother(flex=1).positions))
        self.same_bits(smoother(flex=1).positions, smoother(flex=1, flexed=["biceps R", "biceps L"]).positions)
        self.same_bits(smoother().positions, smoother(flex=1, flexed=[]).positions)
        line.via = ("upper_arm.L", (0, 0.1, 0.05))
        line.via = None
        self.assertIsNone(line.via)
        for wrong in ("upper_arm.L", ("upper_arm.L",), ("arm", (0, 0, 0)), (3, (0, 0, 0)), ("upper_arm.L", (0, 0)), 3):
            before = self.new.copy()
            self.refusal(setattr, line, "origin", wrong)
            self.assertEqual(self.new, before)
        muscle.line = None
        self.assertIsNone(muscle.line)

    def test_shapes(self):
        from face_gltf import write_face
        write_face(self.folder / "face.gltf")
        character = sinew.load(self.folder / "face.gltf")
        self.assertTrue(character.shapes)
        name = character.shapes[0]
        rig = sinew.Rig(character)
        plain = sinew.Smoother(character, rig)
        rig.shapes[name] = 0.5
        self.assertEqual(rig.shapes[name], 0.5)
        self.assertEqual(dict(rig.shapes)[name], 0.5)
        self.assertEqual(set(rig.shapes), set(character.shapes))
        with_shape = sinew.Smoother(character, rig)()
        self.assertFalse(numpy.array_equal(plain().positions, with_shape.positions))
        self.assertIn("did you mean", self.refusal(rig.shapes.__setitem__, name + "s", 1).reason)
        self.refusal(rig.shapes.__setitem__, name, 11)
        self.refusal(plain, shapes={name: "much"})
        by_call = plain(shapes={name: 0.5})
        self.assertFalse(numpy.array_equal(plain().positions, by_call.positions))

    def test_expressions_add_to_their_targets_in_any_order(self):
        from face_gltf import write_face
        write_face(self.folder / "face.glb", {"joy": {"smile": 0.5, "brow_up": 1}, "grin": {"smile": 0.25}})
        character = sinew.load(self.folder / "face.glb")
        smoother = sinew.Smoother(character, sinew.Rig(character))
        together = smoother(shapes={"joy": 1, "grin": 1}).positions
        self.same_bits(together, smoother(shapes={"smile": 0.75, "brow_up": 1}).positions)
        self.assertFalse(numpy.array_equal(together, smoother(shapes={"joy": 1}).positions))
        for shapes in ({"joy": 1, "smile": 0.25}, {"smile": 0.25, "joy": 1}):
            self.same_bits(together, smoother(shapes=shapes).positions)

    @needs_program
    def test_saved_rig_opens_in_the_program(self):
        self.new.add_muscle("a", bone="chest", center=(0.1, 0, 0), radii=(0.1, 0.1, 0.1))
        self.new.mirror("a")
        path = self.folder / "new.rig.json"
        self.new.save(path)
        told = json.loads(run("inspect", path, "--json"))
        self.assertEqual((told["primitives"], told["missing"]), (2, []))
        self.assertEqual(sinew.load_rig(path), self.new)
        self.assertEqual(self.new.path, str(path))
        text = path.read_text()
        again = sinew.Rig(self.character, text=text)
        self.assertEqual(again.to_json(), text)

    def test_bundled_rigs_round_trip(self):
        def values(text):
            return json.loads(text, parse_float=lambda number: float(numpy.float32(number)), parse_int=float)
        for path in sorted(ASSETS.glob("*.rig.json")):
            with self.subTest(path=path.name):
                rig = sinew.load_rig(path)
                self.assertEqual(values(rig.to_json()), values(path.read_text()))
                self.assertEqual(sinew.Rig(rig.character, text=rig.to_json()).to_json(), rig.to_json())

    def test_copy_is_independent(self):
        rig = self.rig.copy()
        self.assertEqual(rig, self.rig)
        rig.muscles[0].amount = 0.1
        self.assertNotEqual(rig, self.rig)
        self.assertNotEqual(self.rig.muscles[0].amount, rig.muscles[0].amount)

    def test_paths_of_any_type_are_accepted(self):
        path = self.folder / "Füchse ‹1›"
        path.mkdir()
        self.new.save(str(path / "a.rig.json").encode())
        self.assertEqual(sinew.load_rig(pathlib.Path(path / "a.rig.json")).muscles, ())
        self.assertEqual(sinew.load_rig(str(path / "a.rig.json"), self.character).character, self.character)
        odd = bytes(self.folder) + b"/\xff.glb"  # No UTF-8.
        shutil.copy(ASSETS / "demo.glb", odd)
        character = sinew.load(odd)
        self.assertEqual(os.fsencode(character.path), odd)
        self.assertIn("expected one of", self.refusal(character.duration, "x").reason)

    def test_rig_saved_for_another_character_refers_to_it(self):
        """Saved elsewhere, too, it opens with the character that it was opened for."""
        moved = self.folder / "moved" / "man.glb"
        moved.parent.mkdir()
        shutil.copy(ASSETS / "humanoid.glb", moved)
        rig = sinew.load_rig(ASSETS / "humanoid.rig.json", sinew.load(moved))
        rig.save(self.folder / "b.rig.json")
        self.assertEqual(json.loads((self.folder / "b.rig.json").read_text())["character"], "moved/man.glb")
        self.assertEqual(len(sinew.load_rig(self.folder / "b.rig.json")), len(rig))


if __name__ == "__main__":
    main()
