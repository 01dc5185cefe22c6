# tests/assets/motion_test.py: the humanoid's clips loop, turn no joint the wrong way and do what their names say.
# Usage: motion_test.py ROOT. Whether planted feet stay planted is measured on the skin, by tests/character.
import math
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import glb_reader  # noqa: E402

ASSETS = pathlib.Path(sys.argv[1]).resolve() / "assets"


def times(a, b):
    """Quaternions x, y, z, w: b first, then a."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


def rotated(q, v):
    x, y, z, _ = times(times(q, (*v, 0.0)), (-q[0], -q[1], -q[2], q[3]))
    return (x, y, z)


def angle(q):
    """Degrees, 0..180."""
    return 2.0 * math.degrees(math.atan2(math.hypot(*q[:3]), abs(q[3])))


class Clip:
    def __init__(self, name):
        glb = glb_reader.Glb(ASSETS / "humanoid.glb")
        self.json, self.nodes = glb.json, glb.json["nodes"]
        self.parent = {c: i for i, n in enumerate(self.nodes) for c in n.get("children", [])}
        animation = next(a for a in self.json["animations"] if a["name"] == name)
        self.tracks = {}
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            self.times = [t for (t,) in glb.rows(sampler["input"])]
            bone = self.nodes[channel["target"]["node"]]["name"]
            self.tracks[(bone, channel["target"]["path"])] = glb.rows(sampler["output"])
        self.keys = range(len(self.times))

    def turned(self, bone):
        return self.tracks.get((bone, "rotation"), [(0.0, 0.0, 0.0, 1.0)] * len(self.times))

    def place(self, bone, key):
        """World."""
        index, point = next(i for i, n in enumerate(self.nodes) if n["name"] == bone), (0.0, 0.0, 0.0)
        while index is not None:
            node = self.nodes[index]
            moved = self.tracks.get((node["name"], "translation"), [node["translation"]] * len(self.times))[key]
            point = tuple(a + b for a, b in zip(rotated(self.turned(node["name"])[key], point), moved))
            index = self.parent.get(index)
        return point

    def range_of(self, bone, axis):
        places = [self.place(bone, key)[axis] for key in self.keys]
        return max(places) - min(places)


class Motion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clips = {name: Clip(name) for name in ("Walk", "Dance", "Flex")}

    def test_file_has_three_clips_of_the_expected_length(self):
        self.assertEqual(["Walk", "Dance", "Flex"], [a["name"] for a in self.clips["Walk"].json["animations"]])
        for name, low, high in (("Walk", 1.0, 1.2), ("Dance", 8.0, 10.0), ("Flex", 3.0, 5.0)):
            self.assertTrue(low <= self.clips[name].times[-1] <= high, name)

    def test_clips_loop_without_jumps(self):
        """The last key is the first; and the step over it is no larger than the steps beside it allow."""
        for name, clip in self.clips.items():
            for track, values in clip.tracks.items():
                self.assertEqual(values[0], values[-1], (name, track))
                steps = [[b - a for a, b in zip(p, q)] for p, q in zip(values, values[1:])]
                jolts = [math.dist(a, b) for a, b in zip(steps, steps[1:])]
                self.assertLessEqual(math.dist(steps[-1], steps[0]), max(jolts) + 1e-6, (name, track))

    def test_no_joint_flips(self):
        """Unit rotations that never leap: 600 degrees a second is fast for a limb, 150 for the trunk."""
        for name, clip in self.clips.items():
            for (bone, path), values in clip.tracks.items():
                if path != "rotation":
                    continue
                fastest = (150.0 if bone in ("hips", "spine", "chest", "neck", "head") else 600.0) * clip.times[1]
                for p, q in zip(values, values[1:]):
                    self.assertAlmostEqual(1.0, math.hypot(*q), places=5)
                    self.assertGreater(sum(a * b for a, b in zip(p, q)), 0.0, (name, bone, "the long way round"))
                    step = times(q, (-p[0], -p[1], -p[2], p[3]))
                    self.assertLess(angle(step), fastest, (name, bone))

    def test_knees_bend_one_way_and_never_lock(self):
        for name, clip in self.clips.items():
            for side in (".L", ".R"):
                for x, y, z, w in clip.turned("shin" + side):
                    self.assertLess(math.hypot(y, z), 1e-5, (name, "a hinge"))
                    self.assertTrue(5.0 < 2.0 * math.degrees(math.atan2(x, w)) < 120.0, (name, side))

    def test_walk_lifts_feet_bends_toes_and_swings_arms_against_legs(self):
        clip = self.clips["Walk"]
        for side in (".L", ".R"):
            self.assertTrue(max(angle(q) for q in clip.turned("shin" + side)) > 55.0)
            self.assertTrue(max(angle(q) for q in clip.turned("toe" + side)) > 20.0)
        hands = [clip.place("hand.L", k)[2] - clip.place("hand.R", k)[2] for k in clip.keys]
        feet = [clip.place("foot.L", k)[2] - clip.place("foot.R", k)[2] for k in clip.keys]
        self.assertLess(sum(a * b for a, b in zip(hands, feet)), 0.0)
        self.assertTrue(0.02 < clip.range_of("hips", 1) < 0.06)
        self.assertLess(clip.range_of("head", 0), 0.06, "a steady head")

    def test_dance_moves_everything(self):
        clip = self.clips["Dance"]
        above = [min(clip.place("hand" + s, k)[1] for s in (".L", ".R")) - clip.place("head", k)[1] for k in clip.keys]
        self.assertGreater(max(above), 0.30, "both hands over the head")
        for side in (".L", ".R"):
            self.assertGreater(max(angle(q) for q in clip.turned("forearm" + side)), 90.0)
            self.assertGreater(clip.range_of("foot" + side, 0), 0.15, "steps")
        self.assertGreater(clip.range_of("hips", 0), 0.30)
        self.assertGreater(max(angle(q) for q in clip.turned("hips")), 15.0)
        self.assertGreater(max(angle(q) for q in clip.turned("chest")), 10.0)

    def test_flex_curls_both_arms_at_shoulder_height(self):
        clip = self.clips["Flex"]
        for side in (".L", ".R"):
            bends = [angle(q) for q in clip.turned("forearm" + side)]
            self.assertTrue(118.0 <= max(bends) <= 135.0, max(bends))
            self.assertLess(min(bends), 30.0, "and lets go")
            key = bends.index(max(bends))
            elbow, shoulder = clip.place("forearm" + side, key), clip.place("upper_arm" + side, key)
            self.assertLess(abs(elbow[1] - shoulder[1]), 0.08)
            self.assertGreater(clip.place("hand" + side, key)[1], elbow[1] + 0.12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
