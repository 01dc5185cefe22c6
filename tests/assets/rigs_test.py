# tests/assets/rigs_test.py: the rigs of the humanoid and the horse: as many muscles as the paper counts, exact twins, a
# whole surface at every depth of its table and at several times of every clip.
# Usage: rigs_test.py ROOT [SINEW]. Without the program only the files are looked at.
import functools
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import glb_reader  # noqa: E402

ROOT = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = sys.argv[2] if len(sys.argv) > 2 else None
ASSETS = ROOT / "assets"
MUSCLES = {"humanoid": 41, "horse": 24}
TRIANGLES = {"humanoid": 592, "horse": 412}
REFINED = {"humanoid": {2: 2368, 3: 5328, 4: 9472, 5: 14800}, "horse": {2: 1648, 3: 3708, 4: 6592, 5: 10300}}
CLIPS = {"humanoid": ("Walk", "Dance", "Flex"), "horse": ("Walk", "Gallop")}
KINDS = {"": "swell", "-flex": "swell", "-wrapped": "replace"}
TIMES = {"": 6, "-flex": 4, "-wrapped": 6}
OUTSIDE = 0.04  # of the height: how far muscles may widen the body
FAR = {"swell": 0.035, "replace": 0.06}  # of the height: what is a large step from the skin
UNRESOLVED = {"swell": 0.0, "replace": 0.03}  # of the refined vertices


def each_rig():
    for body in MUSCLES:
        for suffix in KINDS:
            yield body, body + suffix + ".rig.json", json.loads((ASSETS / (body + suffix + ".rig.json")).read_text())


def kind_of(body, name):
    return name[len(body):-len(".rig.json")]


def mirrored(bone):
    return bone[:-2] + {".L": ".R", ".R": ".L"}.get(bone[-2:], bone[-2:])


class Files(unittest.TestCase):
    def test_muscle_counts_match_the_paper(self):
        for body, name, rig in each_rig():
            with self.subTest(name):
                muscles = [p["name"] for p in rig["primitives"]]
                self.assertEqual(MUSCLES[body], len(muscles))
                self.assertEqual(len(muscles), len(set(muscles)), "names are unique")
                self.assertEqual({"ellipsoid"}, {p["kind"] for p in rig["primitives"]})
                self.assertEqual(KINDS[kind_of(body, name)], rig["surface"]["mode"])

    def test_bones_groups_and_links_exist(self):
        for body, name, rig in each_rig():
            file = glb_reader.Glb(ASSETS / rig["character"]).json
            bones = {file["nodes"][j]["name"] for j in file["skins"][0]["joints"]}
            groups = [g["name"] for g in rig["groups"]]
            with self.subTest(name):
                named = {b for p in rig["primitives"] for b in [p["bone"], *p.get("territory", [])]}
                self.assertLessEqual(named, bones)
                self.assertLessEqual({p["group"] for p in rig["primitives"]}, set(groups))
                self.assertLessEqual({g for link in rig["links"] for g in link}, set(groups))

    def test_twins_are_exact_mirror_images(self):
        for _, name, rig in each_rig():
            muscles = {p["name"]: p for p in rig["primitives"]}
            for p in muscles.values():
                with self.subTest(name, muscle=p["name"]):
                    if "mirror" not in p:
                        self.assertEqual(p["bone"], mirrored(p["bone"]), "on the middle")
                        continue
                    twin, (x, y, z, w) = muscles[p["mirror"]], p["rotation"]
                    self.assertEqual(p["name"], twin["mirror"])
                    self.assertEqual(mirrored(p["bone"]), twin["bone"])
                    self.assertEqual([-p["center"][0], *p["center"][1:]], twin["center"])
                    self.assertEqual([x, -y, -z, w], twin["rotation"])
                    for same in ("radii", "reach", "sign", "group"):
                        self.assertEqual(p[same], twin[same])
                    self.assertEqual([mirrored(b) for b in p.get("territory", [])], twin.get("territory", []))

    def test_most_humanoid_muscles_are_on_the_torso(self):
        """And what would melt into it is in no group that is linked to the torso's."""
        for name in ("humanoid.rig.json", "humanoid-wrapped.rig.json"):
            rig = json.loads((ASSETS / name).read_text())
            bones = ("hips", "spine", "chest", "neck", "clavicle.L", "clavicle.R")
            trunk = [p for p in rig["primitives"] if p["bone"] in bones]
            self.assertGreater(2 * len(trunk), len(rig["primitives"]), name)
            of_torso = {p["group"] for p in trunk}
            arms = {p["group"] for p in rig["primitives"] if p["name"].startswith(("biceps", "triceps", "forearm"))}
            self.assertEqual([], [link for link in rig["links"] if set(link) & of_torso and set(link) & arms], name)
            self.assertEqual(set(), of_torso & arms, name)


@unittest.skipUnless(PROGRAM, "left out: the program is not built")
class Surfaces(unittest.TestCase):
    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout

    def smooth(self, rig, *options):
        """Places, faces as corners of places, and the report."""
        with tempfile.TemporaryDirectory() as folder:
            out, report = pathlib.Path(folder) / "surface.obj", pathlib.Path(folder) / "report.json"
            self.run_program("smooth", ASSETS / rig, *options, "-o", out, "--report", report)
            lines = [line.split() for line in out.read_text().splitlines()]
            told = json.loads(report.read_text())
        places = [tuple(float(c) for c in line[1:4]) for line in lines if line and line[0] == "v"]
        faces = [tuple(int(c.split("/")[0]) - 1 for c in line[1:]) for line in lines if line and line[0] == "f"]
        return places, faces, told

    def test_inspect_reports_the_papers_counts_and_a_closed_surface(self):
        for body, name, _ in each_rig():
            told = json.loads(self.run_program("inspect", ASSETS / name, "--json"))
            with self.subTest(name):
                self.check_inspected(body, told)

    def check_inspected(self, body, told):
        self.assertEqual(TRIANGLES[body], told["triangles"])
        self.assertTrue(told["closed"])
        self.assertEqual(MUSCLES[body], told["primitives"])
        self.assertEqual([], told["unattached"])

    def test_refined_triangle_counts_match_the_papers_table(self):
        for body, name, _ in each_rig():
            for depth, count in REFINED[body].items():
                with self.subTest(name, depth=depth):
                    _, faces, told = self.smooth(name, "--depth", str(depth))
                    self.assertEqual(count, len(faces))
                    self.assertEqual(count, told["refined_triangles"])
                    self.assertEqual(TRIANGLES[body], told["control_triangles"])
                    self.assertEqual(MUSCLES[body], told["primitives"], "all attached")

    def test_surface_is_valid_at_several_times_of_every_clip(self):
        for body, name, rig in each_rig():
            file = glb_reader.Glb(ASSETS / rig["character"]).json
            for clip in CLIPS[body]:
                animation = next(a for a in file["animations"] if a["name"] == clip)
                end = max(file["accessors"][s["input"]]["max"][0] for s in animation["samplers"])
                times = TIMES[kind_of(body, name)]
                for i in range(times):
                    pose = ("--clip", clip, "--time", "%.4f" % (end * i / times), "--depth", "2")
                    with self.subTest(name, pose=pose):
                        self.check_whole(rig, self.plain(rig["character"], *pose), *self.smooth(name, *pose))

    @functools.lru_cache(maxsize=None)
    def plain(self, character, *pose):
        """Places of the refined skin before any muscle."""
        return self.smooth(character, *pose)[0]

    def check_whole(self, rig, skin, places, faces, told):
        self.assertTrue(all(math.isfinite(c) for p in places for c in p))
        edges = {(f[k], f[(k + 1) % 3]) for f in faces for k in range(3)}
        self.assertEqual(3 * len(faces), len(edges), "no directed edge twice")
        self.assertTrue(all((b, a) in edges for a, b in edges), "closed")
        tall = max(p[1] for p in skin) - min(p[1] for p in skin)
        for k in range(3):
            self.assertLess(max(p[k] for p in places), max(p[k] for p in skin) + OUTSIDE * tall, "no spike")
            self.assertGreater(min(p[k] for p in places), min(p[k] for p in skin) - OUTSIDE * tall, "no spike")
        mode = rig["surface"]["mode"]
        far = sum(math.dist(p, q) > FAR[mode] * tall for p, q in zip(places, skin, strict=True))
        self.assertLess(far, 0.02 * len(places), "few vertices lie in a fold where a muscle is far along their normal")
        self.assertLessEqual(told["unresolved"], UNRESOLVED[mode] * told["refined_vertices"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
