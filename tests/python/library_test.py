# tests/python/library_test.py: what docs/python.md begins with runs, line by line.
import contextlib
import io
import re
import shutil
import unittest

from tools import ASSETS, CHARACTERS, ROOT, Case, main, numpy, sinew

FOX = CHARACTERS / "Fox.glb"
HORSE = {"b_LeftLeg01_015": "thigh.L"}  # Where there is no fox: bones of the bundled horse.


def first_code(page):
    """The lines of the page's first block of code."""
    block = re.search(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)[1]
    return block.splitlines()


class Library(Case):
    def the_lines(self, character, words):
        shutil.copy(character, self.folder / "fox.glb")
        lines = first_code(ROOT / "docs" / "python.md")
        self.assertGreaterEqual(len(lines), 10)
        names = {"sinew": sinew}
        for line in lines:
            if "matrices" in line and "matrices" not in names:
                names["matrices"] = names["character"].sample("Walk", 0.2)
            for word, other in words.items():
                line = line.replace(word, other)
            line = re.sub(r'"(fox[\w.]*)"', lambda found: repr(str(self.folder / found[1])), line)
            exec(compile(line, line, "exec"), names)
        return names

    def check(self, names):
        surface, rig = names["surface"], names["rig"]
        vertices, triangles = surface.positions.shape[0], surface.triangles.shape[0]
        self.assertEqual(surface.positions.shape, (vertices, 3))
        self.assertEqual(surface.normals.shape, (vertices, 3))
        self.assertEqual(surface.triangles.shape, (triangles, 3))
        self.assertEqual(surface.uv.shape, (len(surface.uv_vertices), 2))
        self.assertEqual(int(surface.triangles.max()), vertices - 1)
        self.assertEqual(len(rig.muscles), 2)  # And its twin.
        self.assertEqual(rig.links, (("hind legs", "torso"),))
        self.assertGreater((self.folder / "fox_muscled.glb").stat().st_size, 1000)
        again = sinew.load_rig(self.folder / "fox.rig.json")
        self.assertEqual(again, rig)
        self.assertEqual(again.character.names, names["character"].names)

    @unittest.skipUnless(FOX.is_file(), "left out: the lines on the fox itself, shared/characters is not here")
    def test_page_examples_work_on_the_fox(self):
        self.check(self.the_lines(FOX, {}))

    @unittest.skipIf(FOX.is_file(), "")
    def test_page_examples_work_on_the_bundled_horse(self):
        self.check(self.the_lines(ASSETS / "horse.glb", HORSE))

    def test_readme_example_runs(self):
        text = "\n".join(first_code(ROOT / "README.md")).replace("assets/", str(ASSETS) + "/")
        told = io.StringIO()
        with contextlib.redirect_stdout(told), contextlib.chdir(self.folder):
            # The horse, and helpers, would take seconds.
            exec(text.replace("horse.rig.json", "demo.rig.json").replace("helpers=24", 'weights="transferred"'), {})
        self.assertGreater(len(told.getvalue().splitlines()), 10)
        self.assertTrue((self.folder / "horse.obj").is_file() and (self.folder / "horse_muscled.glb").is_file())

    @unittest.skipUnless(FOX.is_file(), "left out: the refusals of docs/python.md, shared/characters is not here")
    def test_errors_match_the_page(self):
        shutil.copy(FOX, self.folder / "fox.glb")
        with contextlib.chdir(self.folder):
            character = sinew.load("fox.glb")
        smoother, bones = sinew.Smoother(character), character.sample()
        muscle = sinew.Rig(character).add_muscle("thigh L", bone="b_LeftLeg01_015")
        bones[2] = bones[2].T
        told = [str(self.refusal(smoother, clip="Wlak")), str(self.refusal(smoother, bones=bones[:-1])),
                str(self.refusal(smoother, bones=bones)), str(self.refusal(setattr, muscle, "radii", (1, -3, 1)))]
        page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
        shown = [line.strip() for line in page.split("## Errors")[1].split("\n\n")[2].splitlines()]
        self.assertEqual(told, shown)

    def test_facts_match_the_mesh_and_skeleton(self):
        facts = self.character.facts()
        self.assertEqual(facts["triangles"], len(self.character.mesh.triangles))
        self.assertEqual(facts["vertices"], len(self.character.mesh.positions))
        self.assertEqual(facts["joints"], len(self.character.bones))
        self.assertEqual([bone.parent for bone in self.character.bones][0], -1)
        self.assertTrue(all(bone.parent < bone.number for bone in self.character.bones))
        self.assertEqual(self.character.clips["Walk"], self.character.duration("Walk"))
        self.assertGreater(self.character.duration("Range of motion"), 1.0)

    def test_vertex_weights_sum_to_one(self):
        mesh = self.character.mesh
        sums = numpy.add.reduceat(mesh.influence_weights, mesh.influence_begin[:-1])
        self.assertEqual(len(sums), len(mesh.positions))
        numpy.testing.assert_allclose(sums, 1.0, atol=1e-5)
        self.assertLess(int(mesh.influence_bones.max()), len(self.character.bones))


if __name__ == "__main__":
    main()
