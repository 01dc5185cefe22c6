# tests/assets/demo_test.py: the bundled character is what its script makes, is closed, loops, and its rig fits it.
# Usage: demo_test.py ROOT [SINEW]. The program, if named, must smooth it into a closed surface too.
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import made_again  # noqa: E402
from glb_reader import Glb, open_edges  # noqa: E402

ROOT = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = sys.argv[2] if len(sys.argv) > 2 else None
ASSETS = ROOT / "assets"


class Demo(unittest.TestCase):
    def setUp(self):
        self.glb = Glb(ASSETS / "demo.glb")
        self.rig = json.loads((ASSETS / "demo.rig.json").read_text())

    def test_script_reproduces_the_files(self):
        made_again.check(self, ASSETS / "make_demo.py", "demo.glb", ("demo.rig.json",))

    def test_mesh_is_a_closed_manifold_without_flat_triangles(self):
        primitive = self.glb.json["meshes"][0]["primitives"][0]
        positions = self.glb.rows(primitive["attributes"]["POSITION"])
        index = [i for (i,) in self.glb.rows(primitive["indices"])]
        triangles = [tuple(positions[i] for i in index[k:k + 3]) for k in range(0, len(index), 3)]
        self.assertEqual([], open_edges(triangles))
        vertices = {p for t in triangles for p in t}
        euler = len(vertices) - len(triangles) * 3 // 2 + len(triangles)
        self.assertEqual(2, euler, "one closed piece without handles")

    def test_vertices_have_at_most_four_weights_that_sum_to_one(self):
        attributes = self.glb.json["meshes"][0]["primitives"][0]["attributes"]
        self.assertNotIn("WEIGHTS_1", attributes)
        for weights in self.glb.rows(attributes["WEIGHTS_0"]):
            self.assertAlmostEqual(1.0, sum(weights), places=6)

    def test_clips_loop(self):
        self.assertEqual(["Walk", "Idle"], [a["name"] for a in self.glb.json["animations"]])
        for animation in self.glb.json["animations"]:
            for sampler in animation["samplers"]:
                values = self.glb.rows(sampler["output"])
                self.assertEqual(values[0], values[-1])
                self.assertGreater(len(values), 8)

    def test_planted_feet_do_not_slide_up_or_down(self):
        """Some part of the sole touches the ground at every key of the walk."""
        joints = self.glb.json["nodes"]
        parent = {c: i for i, n in enumerate(joints) for c in n.get("children", [])}
        feet = [i for i, n in enumerate(joints) if n["name"].startswith("foot.")]
        walk = self.glb.json["animations"][0]
        local = {(c["target"]["node"], c["target"]["path"]): self.glb.rows(walk["samplers"][c["sampler"]]["output"])
                 for c in walk["channels"]}

        def to_world(joint, key, point):
            while joint is not None:
                turned, moved = local.get((joint, "rotation")), local.get((joint, "translation"))
                q = turned[key] if turned else (0, 0, 0, 1)
                t = moved[key] if moved else joints[joint]["translation"]
                point = tuple(a + b for a, b in zip(rotated(q, point), t))
                joint = parent.get(joint)
            return point

        def rotated(q, v):
            x, y, z, w = q
            t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
            return (v[0] + w * t[0] + y * t[2] - z * t[1],
                    v[1] + w * t[1] + z * t[0] - x * t[2],
                    v[2] + w * t[2] + x * t[1] - y * t[0])

        for key in range(25):
            lowest = min(to_world(f, key, (0.0, -0.075, z))[1] for f in feet for z in (-0.04, 0.13))
            self.assertLess(abs(lowest), 0.01, "key %d" % key)

    def test_muscles_have_bone_group_and_twin(self):
        bones = {self.glb.json["nodes"][j]["name"] for j in self.glb.json["skins"][0]["joints"]}
        names = {p["name"]: p for p in self.rig["primitives"]}
        groups = {g["name"] for g in self.rig["groups"]}
        self.assertGreaterEqual(len(names), 8)
        for p in names.values():
            self.assertIn(p["bone"], bones)
            self.assertIn(p["group"], groups)
            if "mirror" in p:
                twin = names[p["mirror"]]
                self.assertEqual(p["name"], twin["mirror"])
                self.assertEqual(p["radii"], twin["radii"])
                self.assertEqual([-p["center"][0]] + p["center"][1:], twin["center"])

    def test_smoothed_surface_is_closed(self):
        if not PROGRAM:
            self.skipTest("left out: the program is not built")
        with tempfile.TemporaryDirectory() as folder:
            out, report = pathlib.Path(folder) / "demo.obj", pathlib.Path(folder) / "report.json"
            subprocess.run([PROGRAM, "smooth", ASSETS / "demo.rig.json", "--clip", "Walk", "--time", "0.3", "-o", out,
                            "--report", report], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            lines = [line.split() for line in out.read_text().splitlines()]
            triangles = [tuple(int(c.split("/")[0]) for c in line[1:]) for line in lines if line and line[0] == "f"]
            self.assertEqual([], open_edges(triangles))
            told = json.loads(report.read_text())
            self.assertEqual(len(self.rig["primitives"]), told["primitives"], "all attached")
            self.assertEqual(0, told["unresolved"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
