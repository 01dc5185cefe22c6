# tests/assets/horse_test.py: the bundled horse is what its script makes, is the paper's size, closed, loops; its rigs fit.
# Usage: horse_test.py ROOT [SINEW]. The program, if named, must smooth them into closed surfaces too.
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
RIGS = {"horse.rig.json": "swell", "horse-flex.rig.json": "swell", "horse-wrapped.rig.json": "replace"}  # and modes
REFINED = {2: 1648, 3: 3708, 4: 6592, 5: 10300}  # depth: triangles, the paper's Table 2


def euler(triangles):
    return len({v for t in triangles for v in t}) - len(triangles) * 3 // 2 + len(triangles)


def area(triangle):
    p, q, r = triangle
    a, b = [y - x for x, y in zip(p, q)], [y - x for x, y in zip(p, r)]
    c = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    return sum(k * k for k in c) ** 0.5 / 2.0


class Horse(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.glb = Glb(ASSETS / "horse.glb")
        cls.rigs = {name: json.loads((ASSETS / name).read_text()) for name in RIGS}

    def test_script_reproduces_the_files(self):
        made_again.check(self, ASSETS / "make_horse.py", "horse.glb", tuple(RIGS))

    def test_mesh_is_one_closed_piece_of_412_triangles_none_flat(self):
        triangles = self.glb.triangles()
        self.assertEqual(412, len(triangles))
        self.assertEqual([], open_edges(triangles))
        self.assertEqual(2, euler(triangles), "one closed piece without handles")
        self.assertGreater(min(area(t) for t in triangles), 1e-5)

    def test_body_is_symmetric_stands_on_the_ground_and_has_the_height_of_a_horse(self):
        corners = {p for t in self.glb.triangles() for p in t}
        self.assertEqual(0.0, min(y for _, y, _ in corners))
        withers = max(y for x, y, z in corners if x == 0.0 and abs(z - 0.27) < 0.1)
        self.assertAlmostEqual(1.6, withers, delta=0.03)
        self.assertEqual(corners, {(-x + 0.0, y, z) for x, y, z in corners})

    def test_vertices_have_at_most_four_weights_that_sum_to_one(self):
        attributes = self.glb.json["meshes"][0]["primitives"][0]["attributes"]
        self.assertNotIn("WEIGHTS_1", attributes)
        for weights in self.glb.rows(attributes["WEIGHTS_0"]):
            self.assertAlmostEqual(1.0, sum(weights), places=6)

    def test_clips_loop_without_jumps(self):
        self.assertEqual(["Walk", "Gallop"], [a["name"] for a in self.glb.json["animations"]])
        for animation in self.glb.json["animations"]:
            kinds = {s["sampler"]: animation["channels"][k]["target"] for k, s in enumerate(animation["channels"])}
            for number, sampler in enumerate(animation["samplers"]):
                values = self.glb.rows(sampler["output"])
                self.assertEqual(values[0], values[-1])
                self.assertGreater(len(set(values)), 1, "a constant track says nothing")
                self.assertGreater(len(values), 24)
                if kinds[number]["path"] == "rotation":
                    nearest = min(sum(a * b for a, b in zip(p, q)) for p, q in zip(values, values[1:]))
                    self.assertGreater(nearest, 0.97, "half a turn's sine: no key is far from the next")

    def test_24_muscles_have_bone_group_and_twin(self):
        bones = {self.glb.json["nodes"][j]["name"] for j in self.glb.json["skins"][0]["joints"]}
        for name, mode in RIGS.items():
            rig = self.rigs[name]
            self.assertEqual(("horse.glb", mode), (rig["character"], rig["surface"]["mode"]))
            muscles = {p["name"]: p for p in rig["primitives"]}
            groups = {g["name"] for g in rig["groups"]}
            self.assertEqual(24, len(muscles))
            self.assertEqual(24, len(rig["primitives"]))
            for p in muscles.values():
                self.assertLessEqual({p["bone"], *p.get("territory", [])}, bones)
                self.assertIn(p["group"], groups)
                self.assertEqual(p["name"][-2:] in (" L", " R"), "mirror" in p)
                self.check_twin(p, muscles)

    def check_twin(self, p, muscles):
        if "mirror" not in p:
            self.assertEqual(0.0, p["center"][0])
            return
        twin = muscles[p["mirror"]]
        self.assertEqual(p["name"], twin["mirror"])
        self.assertEqual(p["radii"], twin["radii"])
        self.assertEqual([-p["center"][0]] + p["center"][1:], twin["center"])
        x, y, z, w = p["rotation"]
        self.assertEqual([x, -y, -z, w], twin["rotation"])
        swapped = {".L": ".R", ".R": ".L"}
        self.assertEqual(p["bone"][:-2] + swapped.get(p["bone"][-2:], p["bone"][-2:]), twin["bone"])

    def test_flexing_rig_differs_only_by_lines_across_joints(self):
        rigid, flexing = (self.rigs[name]["primitives"] for name in ("horse.rig.json", "horse-flex.rig.json"))
        rest = {"line", "territory"}
        self.assertEqual([{k: v for k, v in p.items() if k not in rest} for p in rigid],
                         [{k: v for k, v in p.items() if k not in rest} for p in flexing])
        lines = {line["name"]: line for line in self.rigs["horse-flex.rig.json"]["lines"]}
        self.assertEqual(set(lines), {p["line"] for p in flexing if "line" in p}, "one muscle a line, of its name")
        self.assertEqual({"masseter L", "masseter R", "serratus L", "serratus R", "pectorals", "quadriceps L", "quadriceps R", "gaskin L",
                          "gaskin R"},
                         {p["name"] for p in flexing if "line" not in p})
        for p in flexing:
            self.assertEqual(p.get("line", p["name"]), p["name"])
        for line in lines.values():
            self.assertNotEqual(line["origin"]["bone"], line["insertion"]["bone"])
            self.check_line_twin(line, lines)

    def check_line_twin(self, line, lines):
        if "mirror" not in line:
            self.assertEqual(0.0, line["origin"]["point"][0])
            return
        twin = lines[line["mirror"]]
        self.assertEqual(line["name"], twin["mirror"])
        for end in {"origin", "insertion", "via"} & set(line):
            (x, y, z), bone = line[end]["point"], line[end]["bone"]
            self.assertEqual([-x, y, z], twin[end]["point"])
            self.assertEqual(bone[:-2] + {".L": ".R", ".R": ".L"}.get(bone[-2:], bone[-2:]), twin[end]["bone"])
        for settings in set(line) - {"name", "origin", "insertion", "via", "mirror"}:
            self.assertEqual(line[settings], twin[settings])

    def smooth(self, folder, rig, *options):
        out, report = pathlib.Path(folder) / "horse.obj", pathlib.Path(folder) / "report.json"
        subprocess.run([PROGRAM, "smooth", ASSETS / rig, *options, "-o", out, "--report", report], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        lines = [line.split() for line in out.read_text().splitlines()]
        triangles = [tuple(int(c.split("/")[0]) for c in line[1:]) for line in lines if line and line[0] == "f"]
        return triangles, json.loads(report.read_text())

    def test_smoothed_surfaces_are_closed(self):
        if not PROGRAM:
            self.skipTest("left out: the program is not built")
        poses = {2: ("--clip", "Walk", "--time", "0.3"), 3: (), 4: ("--clip", "Gallop", "--time", "0.1"),
                 5: ("--clip", "Gallop", "--time", "0.45")}
        with tempfile.TemporaryDirectory() as folder:
            for rig in RIGS:
                for depth, count in REFINED.items():
                    triangles, told = self.smooth(folder, rig, "--depth", str(depth), *poses[depth])
                    self.assertEqual(count, len(triangles))
                    self.assertEqual([], open_edges(triangles))
                    self.assertEqual(2, euler(triangles))
                    self.assertEqual(24, told["primitives"], "all attached")
                    allowed = 0.03 * told["refined_vertices"] if RIGS[rig] == "replace" else 0
                    self.assertLessEqual(told["unresolved"], allowed, rig)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
