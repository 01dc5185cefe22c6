# tests/assets/humanoid_test.py: the bundled humanoid is what its script makes: 592 triangles of one closed body, evenly bound.
# Usage: humanoid_test.py ROOT [SINEW]. The program, if named, must smooth it into a closed surface too.
import json
import math
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
FILES = ("humanoid.glb", "humanoid.rig.json", "humanoid-flex.rig.json", "humanoid-wrapped.rig.json")


def area(a, b, c):
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return 0.5 * math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def mirrored(name):
    return name[:-2] + {".L": ".R", ".R": ".L"}.get(name[-2:], name[-2:])


class Humanoid(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.glb = Glb(ASSETS / FILES[0])
        primitive = cls.glb.json["meshes"][0]["primitives"][0]
        cls.attributes = {name: cls.glb.rows(index) for name, index in primitive["attributes"].items()}
        index = [i for (i,) in cls.glb.rows(primitive["indices"])]
        points = cls.attributes["POSITION"]
        cls.triangles = [tuple(points[i] for i in index[k:k + 3]) for k in range(0, len(index), 3)]
        cls.vertices = {p for t in cls.triangles for p in t}

    def bound(self):
        """position -> {bone: weight}"""
        nodes, joints = self.glb.json["nodes"], self.glb.json["skins"][0]["joints"]
        result = {}
        for p, js, ws in zip(self.attributes["POSITION"], self.attributes["JOINTS_0"], self.attributes["WEIGHTS_0"]):
            result[p] = {nodes[joints[j]]["name"]: w for j, w in zip(js, ws) if w > 0.0}
        return result

    def place(self, bone):
        nodes = self.glb.json["nodes"]
        index = next(i for i, n in enumerate(nodes) if n["name"] == bone)
        point = (0.0, 0.0, 0.0)
        while index is not None:
            point = tuple(a + b for a, b in zip(point, nodes[index]["translation"]))
            index = next((i for i, n in enumerate(nodes) if index in n.get("children", [])), None)
        return point

    def girth(self, height, low, high):
        """Extent in x and z of the flat body's section at a height, among low <= x <= high."""
        cut = []
        for t in self.triangles:
            for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
                if (a[1] - height) * (b[1] - height) < 0.0:
                    s = (height - a[1]) / (b[1] - a[1])
                    p = tuple(u + (v - u) * s for u, v in zip(a, b))
                    if low <= p[0] <= high:
                        cut.append(p)
        return tuple(max(p[k] for p in cut) - min(p[k] for p in cut) for k in (0, 2))

    def test_script_reproduces_the_files(self):
        made_again.check(self, ASSETS / "make_humanoid.py", "humanoid.glb", FILES[1:])

    def test_mesh_has_592_triangles_none_flat(self):
        self.assertEqual(592, len(self.triangles))
        for t in self.triangles:
            longest = max(math.dist(t[k], t[k - 1]) for k in range(3))
            self.assertGreater(2.0 * area(*t) / longest, 0.003, "a triangle 3 mm high at least: %s" % (t,))

    def test_mesh_is_one_closed_piece(self):
        self.assertEqual([], open_edges(self.triangles))
        self.assertEqual(2, len(self.vertices) - len(self.triangles) * 3 // 2 + len(self.triangles))
        volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in self.triangles) / 6.0
        self.assertTrue(0.055 < volume < 0.085, "cubic metres, faces outwards: %g" % volume)

    def test_mesh_and_weights_are_symmetric(self):
        bound = self.bound()
        for (x, y, z), weights in bound.items():
            twin = bound[(-x if x else x, y, z)]
            self.assertEqual(weights, {mirrored(bone): w for bone, w in twin.items()})

    def test_vertices_have_at_most_four_weights_that_sum_to_one(self):
        self.assertNotIn("WEIGHTS_1", self.attributes)
        for weights in self.attributes["WEIGHTS_0"]:
            self.assertAlmostEqual(1.0, sum(weights), places=6)
            self.assertGreaterEqual(min(weights), 0.0)
        moved = {bone for weights in self.bound().values() for bone in weights}
        self.assertEqual({self.glb.json["nodes"][j]["name"] for j in self.glb.json["skins"][0]["joints"]}, moved)

    def test_neighboring_vertices_share_weights(self):
        """Along every edge at least a fifth of the weight is shared, or the bones are parent and child."""
        nodes, bound = self.glb.json["nodes"], self.bound()
        parent = {nodes[c]["name"]: n["name"] for n in nodes for c in n.get("children", [])}
        for t in self.triangles:
            for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
                shared = sum(min(w, bound[b].get(bone, 0.0)) for bone, w in bound[a].items())
                kin = any(parent.get(p) == q or parent.get(q) == p for p in bound[a] for q in bound[b])
                self.assertTrue(shared > 0.2 or kin, (a, b))

    def test_proportions_are_those_of_an_athlete(self):
        height = max(p[1] for p in self.vertices)
        self.assertAlmostEqual(1.80, height, places=2)
        self.assertAlmostEqual(0.0, min(p[1] for p in self.vertices), places=3)
        head = {p for p, weights in self.bound().items() if weights.get("head", 0.0) > 0.99}
        chin = min(p[1] for p in head if p[2] > 0.05)
        self.assertTrue(7.5 <= height / (height - chin) <= 8.0, "heads: %.2f" % (height / (height - chin)))
        arm = self.place("upper_arm.L"), self.place("hand.L")
        self.assertAlmostEqual(45.0, math.degrees(math.atan2(arm[0][1] - arm[1][1], arm[1][0] - arm[0][0])), delta=2.0)
        chest, waist, hips = (self.girth(y, -0.2, 0.2)[0] for y in (1.33, 1.12, 0.90))
        self.assertGreater(chest, 1.2 * waist)
        self.assertGreater(hips, 1.2 * waist)
        thigh, knee, calf, ankle = (self.girth(y, 0.0, 0.3)[1] for y in (0.75, 0.495, 0.39, 0.13))
        self.assertTrue(thigh > knee > ankle and calf > 1.15 * ankle, (thigh, knee, calf, ankle))

    def test_texture_coordinates_lie_in_the_texture(self):
        for u, v in self.attributes["TEXCOORD_0"]:
            self.assertTrue(0.0 < u < 1.0 and 0.0 < v < 1.0)

    def test_file_is_small_enough_to_bundle(self):
        self.assertLess((ASSETS / FILES[0]).stat().st_size, 700_000)

    def test_smoothed_surface_is_closed(self):
        if not PROGRAM:
            self.skipTest("left out: the program is not built")
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "humanoid.obj"
            subprocess.run([PROGRAM, "smooth", ASSETS / FILES[0], "--depth", "3", "-o", out], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            lines = [line.split() for line in out.read_text().splitlines()]
            triangles = [tuple(int(c.split("/")[0]) for c in line[1:]) for line in lines if line and line[0] == "f"]
            self.assertEqual(592 * 9, len(triangles))
            self.assertEqual([], open_edges(triangles))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
