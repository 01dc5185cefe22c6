# tests/assets/scenes_test.py: the trial scenes are what their script makes, closed, small, and as their names say.
# Usage: scenes_test.py ROOT
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from glb_reader import Glb, open_edges  # noqa: E402

ROOT = pathlib.Path(sys.argv[1]).resolve()
ASSETS = ROOT / "assets"
SCENES = ("wrapped", "tangle")


class Scenes(unittest.TestCase):
    def setUp(self):
        self.glb = {name: Glb(ASSETS / (name + ".glb")) for name in SCENES}
        self.rig = {name: json.loads((ASSETS / (name + ".rig.json")).read_text()) for name in SCENES}

    def test_script_reproduces_the_files(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ASSETS / "make_scenes.py", folder], check=True)
            for name in [scene + ending for scene in SCENES for ending in (".glb", ".rig.json")]:
                self.assertEqual((ASSETS / name).read_bytes(), (pathlib.Path(folder) / name).read_bytes(), name)

    def test_meshes_are_small_and_one_closed_piece(self):
        for name, glb in self.glb.items():
            primitive = glb.json["meshes"][0]["primitives"][0]
            index = [i for (i,) in glb.rows(primitive["indices"])]
            triangles = [tuple(index[k:k + 3]) for k in range(0, len(index), 3)]
            self.assertEqual([], open_edges(triangles), name)
            vertices = {v for t in triangles for v in t}
            self.assertEqual(2, len(vertices) - len(triangles) // 2, name + ": one piece without handles")
            self.assertTrue(200 <= len(triangles) <= 600, name)
            self.assertLess((ASSETS / (name + ".glb")).stat().st_size, 100_000)

    def test_weights_sum_to_one_and_clips_loop(self):
        for name, glb in self.glb.items():
            attributes = glb.json["meshes"][0]["primitives"][0]["attributes"]
            for weights in glb.rows(attributes["WEIGHTS_0"]):
                self.assertAlmostEqual(1.0, sum(weights), places=5)
            for sampler in glb.json["animations"][0]["samplers"]:
                values = glb.rows(sampler["output"])
                self.assertEqual(values[0], values[-1], name)

    def test_muscles_have_bone_and_group(self):
        for name, rig in self.rig.items():
            bones = {node["name"] for node in self.glb[name].json["nodes"]}
            groups = {group["name"] for group in rig["groups"]}
            for p in rig["primitives"]:
                self.assertIn(p["bone"], bones)
                self.assertIn(p["group"], groups)

    def test_wrapped_body_has_muscles_on_all_bones_but_head_hands_and_feet(self):
        rig = self.rig["wrapped"]
        self.assertEqual("replace", rig["surface"]["mode"])
        self.assertEqual("Walk", self.glb["wrapped"].json["animations"][0]["name"])
        bare = {"head", "hand.L", "hand.R", "foot.L", "foot.R"}
        bones = {node["name"] for node in self.glb["wrapped"].json["nodes"]} - {"wrapped"}
        self.assertEqual(bones - bare, {p["bone"] for p in rig["primitives"]})

    def test_tangle_has_carves_and_a_linked_clique(self):
        rig = self.rig["tangle"]
        self.assertEqual("swell", rig["surface"]["mode"])
        self.assertEqual(40, len(rig["primitives"]))
        self.assertTrue(3 <= sum(p["sign"] < 0 for p in rig["primitives"]) <= 8)
        links = {frozenset(link) for link in rig["links"]}
        linked = lambda *pairs: all(frozenset(pair) in links for pair in pairs)  # noqa: E731
        self.assertEqual(8, len(rig["groups"]))
        self.assertTrue(linked("ab", "ac", "ad", "bc", "bd", "cd"), "a clique of four")
        self.assertTrue(linked("de", "ef", "fg", "gd"), "a ring")
        self.assertFalse(linked("df") or linked("eg"), "with nothing across")
        self.assertEqual(5, sum("d" in link for link in links), "a star")
        self.assertFalse(any("alone" in link for link in links))
        self.assertTrue(all(any(p["group"] == g["name"] for p in rig["primitives"]) for g in rig["groups"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
