# tests/python/examples_test.py: the scripts of examples/python do what they say, on bundled characters.
import csv
import shutil
import subprocess
import sys

from tools import ASSETS, CHARACTERS, ROOT, Case, main, numpy, sinew

EXAMPLES = ROOT / "examples" / "python"
MOST_LINES = 80


class Examples(Case):
    @classmethod
    def setUpClass(cls):
        pass

    def run_script(self, name, *words, status=0):
        """(stdout, stderr)"""
        done = subprocess.run([sys.executable, "-B", EXAMPLES / name, *map(str, words)], capture_output=True, text=True,
                              cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stdout, done.stderr

    def test_examples_are_short(self):
        scripts = list(EXAMPLES.glob("*.py"))
        self.assertEqual(len(scripts), 5)
        for script in scripts:
            self.assertLess(len(script.read_text().splitlines()), MOST_LINES, script.name)

    def test_turntable(self):
        told, _ = self.run_script("turntable.py", ASSETS / "demo.rig.json", "out.png", 4)
        clips = len(sinew.load(ASSETS / "demo.glb").clips)
        self.assertEqual(told.count(": 4 pictures"), clips)
        data = (self.folder / "out.png").read_bytes()
        size = int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")
        self.assertEqual(size, (4 * 180, clips * 180))
        import zlib
        length = int.from_bytes(data[33:37], "big")
        rows = numpy.frombuffer(zlib.decompress(data[41:41 + length]), numpy.uint8).reshape(size[1], size[0] + 1)
        for column in range(4):
            picture = rows[:180, 1 + 180 * column:181 + 180 * column]
            self.assertGreater((picture > 60).mean(), 0.03)  # The animal.
            self.assertGreater((picture == 28).mean(), 0.5)  # What is around it.

    def test_muscles_by_rule(self):
        self.run_script("muscles_by_rule.py", ASSETS / "humanoid.glb", "made.rig.json")
        rig = sinew.load_rig(self.folder / "made.rig.json")
        self.assertGreater(len(rig), 6)
        self.assertEqual(len({muscle.bone for muscle in rig}), len(rig))
        surface = sinew.Smoother(rig.character, rig)(clip="Walk", time=0.3)
        self.assertTrue(numpy.isfinite(surface.positions).all())
        _, said = self.run_script("muscles_by_rule.py", "nowhere.glb", "b.rig.json", status=1)
        self.assertEqual(said, "muscles_by_rule: nowhere.glb: cannot be read: No such file or directory\n")

    def test_error_heat_map(self):
        told, _ = self.run_script("error_heat_map.py", ASSETS / "demo.rig.json", "Walk", "heat.ply")
        head, body = (self.folder / "heat.ply").read_bytes().split(b"end_header\n", 1)
        count = int(head.split(b"element vertex ")[1].split()[0])
        vertices = numpy.frombuffer(body, [("place", "<f4", 3), ("color", "u1", 3), ("error", "<f4")], count)
        self.assertIn("at most %.2f %%" % vertices["error"].max(), told)
        self.assertEqual(vertices["color"][vertices["error"].argmax()].tolist(), [200, 40, 30])
        if "matplotlib is not installed" in told:
            self.skipTest("left out: the picture of the error heat map, matplotlib is not installed")
        self.assertEqual((self.folder / "heat.png").read_bytes()[:4], b"\x89PNG")

    def test_batch(self):
        folder = self.folder / "in"
        folder.mkdir()
        for name in ("demo.glb", "demo.rig.json", "wrapped.rig.json"):
            shutil.copy(ASSETS / name, folder)
        told, said = self.run_script("batch.py", folder, "out", status=3)
        self.assertIn("3 files, 1 refused", told)
        self.assertIn("wrapped.glb", said)
        with open(self.folder / "out" / "table.csv", newline="") as file:
            rows = {row["file"]: row for row in csv.DictReader(file)}
        self.assertEqual(rows["demo.rig.json"]["muscles"], str(len(sinew.load_rig(ASSETS / "demo.rig.json"))))
        self.assertIn("wrapped.glb", rows["wrapped.rig.json"]["refused"])
        self.assertTrue((self.folder / "out" / "demo.glb.ply").is_file())

    def test_rig_to_csv_round_trip(self):
        source = ASSETS / "humanoid.rig.json"
        rig = sinew.load_rig(source)
        self.run_script("rig_csv.py", "out", source, "a.csv")
        self.run_script("rig_csv.py", "in", source, "a.csv", "same.rig.json")
        again = sinew.load_rig(self.folder / "same.rig.json")
        self.assertEqual([row(muscle) for muscle in again], [row(muscle) for muscle in rig])
        with open(self.folder / "a.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        gone, changed = rows.pop(), rows[0]
        changed["radii.x"] = "0.2"
        rows.append(dict(changed, name="new one"))
        with open(self.folder / "b.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
        self.run_script("rig_csv.py", "in", source, "b.csv", "edited.rig.json")
        edited = sinew.load_rig(self.folder / "edited.rig.json")
        self.assertNotIn(gone["name"], edited)
        for name in (changed["name"], "new one"):
            self.assertEqual(edited[name].radii[0], float(numpy.float32(0.2)))
        (self.folder / "b.csv").write_text("name,bone\n")
        _, said = self.run_script("rig_csv.py", "in", source, "b.csv", "no.rig.json", status=1)
        self.assertIn("b.csv: expected the columns", said)
        changed["radii.x"] = "wide"
        with open(self.folder / "c.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, changed.keys())
            writer.writeheader()
            writer.writerow(changed)
        _, said = self.run_script("rig_csv.py", "in", source, "c.csv", "no.rig.json", status=1)
        self.assertIn("expected a number, got 'wide'", said)
        self.assertFalse((self.folder / "no.rig.json").exists())

    def test_examples_run_on_other_characters(self):
        found = sorted(CHARACTERS.glob("*.gl*")) if CHARACTERS.is_dir() else []
        if not found:
            self.skipTest("left out: the examples on real characters, shared/characters is not here")
        self.run_script("batch.py", CHARACTERS, "out")
        with open(self.folder / "out" / "table.csv", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), len(found))


def row(muscle):
    return (muscle.name, muscle.bone, muscle.group, muscle.center, muscle.radii, muscle.rotation, muscle.reach,
            muscle.mirror)


if __name__ == "__main__":
    main()
