# tests/python/refusals_test.py: whatever is passed wrong is refused with a sentence, and nothing is changed by it.
import json
import math
import struct
import weakref

from tools import ASSETS, Case, main, numpy, sinew
from glb_reader import Glb  # noqa: E402: tools says where it is

WRONG = (None, True, "word", b"bytes", 1j, [], {}, (1, 2), object(), math.nan, math.inf, 1e300, [[1, 2, 3]],
         numpy.array(["a", "b", "c"]), numpy.array([1, 2, numpy.nan]), lambda: 0)


class Refusals(Case):
    def says(self, words, what, *arguments, place=None, **named):
        error = self.refusal(what, *arguments, **named)
        self.assertIn(words, error.reason)
        if place is not None:
            self.assertEqual(error.place, place)
        return error

    def test_files(self):
        error = self.says("No such file", sinew.load, "nowhere.glb")
        self.assertEqual(error.file, "nowhere.glb")
        (self.folder / "bad.glb").write_bytes(b"not a glb at all")
        self.assertEqual(self.refusal(sinew.load, self.folder / "bad.glb").file, str(self.folder / "bad.glb"))
        (self.folder / "bad.rig.json").write_text((ASSETS / "demo.rig.json").read_text().replace("swell", "swollen"))
        error = self.refusal(sinew.load_rig, self.folder / "bad.rig.json")
        self.assertEqual((error.file, error.place), (str(self.folder / "bad.rig.json"), "surface.mode"))
        for wrong in (None, 3, [], object()):
            self.says("expected a path", sinew.load, wrong, place="path")
        self.says("ends in", self.smoother().save, self.folder / "a.xyz")
        self.says("no such folder", self.smoother().save, self.folder / "none" / "a.obj")

    def test_poses(self):
        count = len(self.character.bones)
        good = self.character.sample("Walk", 0.2)
        for wrong, words in ((good[:-1], "expected the shape (%d, 4, 4)" % count), (good[0], "got (4, 4)"),
                             (good[:, :3], "got (%d, 3, 4)" % count), (good.astype(str), "expected numbers"),
                             (good.astype(complex), "dtype complex"), (good.astype(object), "dtype object"),
                             (good.astype(bool), "dtype bool"), ("word", "dtype"), (3, "got ()"),
                             (good.transpose(0, 2, 1), "is it transposed?"), ([[1], [1, 2]], "expected")):
            self.says(words, self.smoother, bones=wrong)
        for number in (numpy.nan, numpy.inf, 1e39):
            broken = good.astype(float)
            broken[2, 1, 3] = number
            error = self.says("got %r in row 1, column 3" % float(number), self.smoother, bones=broken)
            self.assertEqual(error.place, "bones[2] (%s)" % self.character.names[2])

    def test_unknown_attributes(self):
        """A setting that is misspelled must not seem to be set."""
        rig = self.rig.copy()
        for each in (rig, rig.muscles[0], self.character, self.smoother, self.smoother()):
            with self.assertRaisesRegex(AttributeError, "toleranc"):
                each.toleranc = 0.001
        copy = weakref.ref(rig)
        del rig, each
        self.assertIsNone(copy())

    def test_equivalent_arrays_are_accepted(self):
        good = self.character.sample("Walk", 0.2)
        expected = self.smoother(bones=good).positions
        strided = numpy.zeros((2 * len(good), 4, 8), numpy.float32)
        strided[::2, :, ::2] = good
        for same in (good.astype(float), good.tolist(), numpy.asfortranarray(good), strided[::2, :, ::2],
                     list(good), good.astype(">f4")):
            self.same_bits(self.smoother(bones=same).positions, expected)

    def test_times_and_threads(self):
        for wrong in ("word", None, math.nan, -1, True):
            self.refusal(self.smoother, clip="Walk", time=wrong)
        for wrong in (-1, 1.5, "2", None, True, 10**30):
            self.refusal(self.smoother, threads=wrong)
            self.refusal(self.smoother.frames, "Walk", threads=wrong)
        for wrong in (0, -30, math.nan, "30", 1e300):
            self.refusal(self.smoother.frames, "Walk", fps=wrong)
        for wrong in (-0.1, 1.1, "all"):
            self.refusal(self.smoother, flex=wrong)

    def test_names(self):
        self.says('did you mean "Walk"?', self.smoother, clip="Wlak", place='clip "Wlak"')
        self.says('did you mean "Walk"?', self.smoother.frames, "walkk")
        self.says('did you mean "Dance"?', self.character.sample, "Danse")
        self.says('did you mean "forearm.L"?', self.character.turned, {"foream.L": (0, 0, 0, 1)})
        self.says('did you mean "%s"?' % self.rig.muscles[0].name, self.rig.muscle, self.rig.muscles[0].name[:-1] + "l")
        self.says('did you mean "hips"?', self.rig.add_muscle, "new", bone="hps")
        self.says("no group of this name", self.rig.unlink, "nothing", "at all")
        self.says("expected a str", self.smoother, clip=3, place="clip")
        self.says("no shapes", self.smoother, shapes={"smile": 1})
        self.says("no line", self.smoother, flex=1, flexed=["biceps"])

    def test_local_transforms(self):
        self.says('did you mean "head"?', self.character.from_locals, {"haed": (0, 0, 0, 1)}, place='rotations["haed"]')
        self.says("expected a dict", self.character.from_locals, translations=[1])
        self.says("expected 3 numbers", self.character.from_locals, scales={"head": 2})
        self.says("expected a clip of the file", self.character.from_locals, clip="Range of motion")

    def test_node_with_a_matrix_is_not_decomposed(self):
        glb = Glb(ASSETS / "humanoid.glb")
        head = next(node for node in glb.json["nodes"] if node.get("name") == "head")
        x, y, z = head.pop("translation", (0, 0, 0))
        head.pop("rotation", None), head.pop("scale", None)
        head["matrix"] = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]
        del glb.json["animations"]
        text = json.dumps(glb.json).encode()
        text += b" " * (-len(text) % 4)
        whole = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(glb.data))
        whole += struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(glb.data), b"BIN\0") + glb.data
        (self.folder / "matrix.glb").write_bytes(whole)
        character = sinew.load(self.folder / "matrix.glb")
        self.same_bits(character.from_locals(), character.rest())
        turn, place, scale = {"head": (0, 0, 1, 0)}, {"head": (x, y, z)}, {"head": (1, 1, 1)}
        self.says("not taken apart", character.from_locals, turn, place='"head"')
        self.says("not taken apart", character.from_locals, turn, place)
        whole = character.from_locals(turn, place, scale)
        numpy.testing.assert_allclose(whole[:, :3, 3], character.rest()[:, :3, 3], atol=1e-5)

    def test_rotations(self):
        for wrong in ((0, 0, 0, 0), (1, 1, 1, 1), (0, 0, 1), "xyzw", (0, 0, 0, math.nan)):
            self.refusal(self.character.turned, {"spine": wrong})
            self.refusal(setattr, self.rig.muscles[0], "rotation", wrong)

    def test_fields_of_muscles(self):
        """Every field refuses every wrong value, or takes it and gives it back; the rig is a valid one all the time."""
        rig = sinew.load_rig(ASSETS / "humanoid.rig.json", self.character)
        muscle, before = rig.muscles[0], rig.copy()
        for name in (key for key, value in vars(sinew.Muscle).items() if isinstance(value, property)):
            for wrong in (*WRONG, -1, 0, 1e9, (0, 0, 0), (-1, -1, -1), (1e9, 1, 1)):
                try:
                    setattr(muscle, name, wrong)
                except sinew.Error as error:
                    self.assertNotIn("\n", str(error))
                    self.assertTrue(error.place, str(error))
                    self.assertEqual(rig, before, (name, wrong))
                else:
                    sinew.Rig(self.character, text=rig.to_json())
                    rig = before.copy()
                    muscle = rig.muscles[0]

    def test_settings(self):
        rig = self.rig.copy()
        for name, wrong in (("mode", "swollen"), ("mode", 3), ("iso", 0), ("iso", 1), ("iso", "a"), ("depth", 0),
                            ("depth", 17), ("depth", 2.0), ("detail", "fine"), ("tolerance", 1), ("patch", ""),
                            ("projection", None), ("crease_angle", 181), ("skin_blend", 0), ("skin_blend", math.inf),
                            ("grooves", -0.01), ("grooves", 1.5), ("grooves", "soft")):
            with self.subTest(name=name, wrong=wrong):
                error = self.refusal(setattr, rig, name, wrong)
                self.assertEqual(error.place, name)
                self.assertEqual(rig, self.rig)

    def test_wrong_object_types(self):
        for wrong in (None, 3, "humanoid", self.rig):
            self.says("expected a sinew.Character", sinew.Rig, wrong)
            self.says("expected a sinew.Character", sinew.Smoother, wrong)
        self.says("expected a sinew.Rig", sinew.Smoother, self.character, self.character)
        self.says("expected a sinew.Rig", sinew.export, self.character, "a.glb")
        self.says("expected a dict", self.smoother, shapes=[1])
        self.says("expected a dict", self.character.turned, [1])

    def test_wrong_call_arguments_raise_type_errors(self):
        for call in (lambda: self.smoother(clp="Walk"), lambda: self.rig.add_muscle("a"), lambda: sinew.load()):
            with self.assertRaises(TypeError) as caught:
                call()
            self.assertNotIn("\n", str(caught.exception))

    def test_missing_bones(self):
        text = self.rig.to_json().replace('"chest"', '"chestt"')
        rig = sinew.Rig(self.character, text=text)
        self.assertTrue(rig.unattached)
        self.says('did you mean "chest"?', sinew.Smoother, self.character, rig)
        without = sinew.Smoother(self.character, rig, leave_out_missing=True)(clip="Walk", time=0.1)
        fewer = sinew.Rig(self.character, text=text)
        for name in rig.unattached:
            fewer.remove(name)
        self.same_bits(without.positions, sinew.Smoother(self.character, fewer)(clip="Walk", time=0.1).positions)
        rig.muscles[-1].amount = 0.5  # Other edits go on.

    def test_exports(self):
        for named in (dict(helpers=-1), dict(helpers=257), dict(helpers=2.5), dict(mesh="fine"), dict(weights="new"),
                      dict(joint_scale="some"), dict(clips="Walk"), dict(clips=["Swim"]), dict(progress=3),
                      dict(shapes=1), dict(threads=-1), dict(helpers=4, weights="transferred")):
            self.refusal(sinew.export, self.rig, self.folder / "a.glb", **named)
        self.says("ends in", sinew.export, self.rig, self.folder / "a.obj")
        for named in (dict(fps=0), dict(substeps=17), dict(bound=0), dict(clip="Swim"), dict(weights="")):
            named = dict(dict(clip="Walk"), **named)
            self.refusal(sinew.export_baked, self.rig, self.folder / "a.glb", **named)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()
