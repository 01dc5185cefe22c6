# tests/farm/jobs_test.py: shares of a job together make what one run makes, however they are run and whatever ends them.
# Usage: jobs_test.py PROGRAM ROOT
import collections
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import slurm_node

PROGRAM, ROOT = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
FRAMES = 240
RIG = str(ROOT / "assets" / "demo.rig.json")
SMOOTH = ["smooth", RIG, "--clip", "Walk", "--fps", "200", "--frames", "0:%d" % (FRAMES - 1), "--depth", "2",
          "-o", "out file's/f %03d.ply"]
# Levels are found by every process anew.
ADAPTIVE = ["smooth", RIG, "--clip", "Walk", "--frames", "0:8", "--detail", "adaptive", "-o", "out file's/f %03d.ply"]
RENDER = ["render", RIG, "--frames", "0:13", "--size", "48x48", "--depth", "1", "--view", "-30,12",
          "-o", "out file's/f %03d.png"]


def sinew(folder, *words, environment=None, check=True):
    return subprocess.run([PROGRAM, *words], cwd=folder, text=True, capture_output=True, check=check,
                          env={**os.environ, **(environment or {})})


def contents(folder):
    """All of the job's files; nothing else may be among them."""
    return {path.name: path.read_bytes() for path in (folder / "out file's").iterdir()}


class Jobs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = {}
        for name, job in (("smooth", SMOOTH), ("adaptive", ADAPTIVE), ("render", RENDER)):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "out file's").mkdir()
                sinew(folder, *job)
                cls.whole[name] = contents(pathlib.Path(folder))
        assert len(cls.whole["smooth"]) == FRAMES and len(set(cls.whole["smooth"].values())) > FRAMES // 2

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="sinew's jobs ")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "out file's").mkdir()

    def expect_whole(self, job="smooth"):
        found = contents(self.folder)
        self.assertEqual(sorted(found), sorted(self.whole[job]))
        self.assertEqual([name for name in found if found[name] != self.whole[job][name]], [])

    def farm(self, to, tasks, job=SMOOTH):
        sinew(self.folder, "farm", *job, "--to", to, "--tasks", str(tasks), "--job", "job")
        return self.folder / "job"

    def test_shards_add_up_to_the_whole_job(self):
        for count in (1, 2, 7, 16):
            with self.subTest(count=count):
                for index in range(count):
                    sinew(self.folder, *SMOOTH, "--shard", "%d/%d" % (index, count))
                self.expect_whole()
                shutil.rmtree(self.folder / "out file's")
                (self.folder / "out file's").mkdir()

    def test_adaptive_meshes_do_not_depend_on_shard_or_thread_count(self):
        heads = {ply.split(b"end_header")[0] for ply in self.whole["adaptive"].values()}
        self.assertEqual(len(heads), 1, "as many vertices and faces in all frames")
        for index in range(3):
            sinew(self.folder, *ADAPTIVE, "--shard", "%d/3" % index, "--threads", str(index + 1))
        self.expect_whole("adaptive")

    def test_picture_shards_add_up_to_the_whole_job(self):
        for index in range(3):
            sinew(self.folder, *RENDER, "--shard", "%d/3" % index)
        self.expect_whole("render")

    def test_every_item_is_in_exactly_one_shard(self):
        for count in (5, 14, 20):
            times = collections.Counter()
            for index in range(count):
                times.update(sinew(self.folder, *RENDER, "--dry-run", "--shard", "%d/%d" % (index, count))
                             .stdout.splitlines())
            self.assertEqual(sorted(times), ["out file's/" + name for name in sorted(self.whole["render"])])
            self.assertEqual(set(times.values()), {1})
        self.assertEqual(contents(self.folder), {}, "a dry run makes nothing")

    def test_killed_job_can_be_resumed(self):
        with subprocess.Popen([PROGRAM, *SMOOTH], cwd=self.folder, stdout=subprocess.PIPE, text=True) as process:
            for _ in range(9):
                process.stdout.readline()
            process.send_signal(signal.SIGKILL)
        left = contents(self.folder)
        self.assertTrue(9 <= len(left) < FRAMES, len(left))
        for name, bytes_ in left.items():
            self.assertEqual(bytes_, self.whole["smooth"][name], name)
        before = {path.name: path.stat().st_mtime_ns for path in (self.folder / "out file's").iterdir()}
        made = sinew(self.folder, *SMOOTH, "--resume").stdout.splitlines()
        self.assertEqual(len(made), FRAMES - len(left))
        self.expect_whole()
        for name, when in before.items():
            self.assertEqual((self.folder / "out file's" / name).stat().st_mtime_ns, when, name)
        self.assertEqual(sinew(self.folder, *SMOOTH, "--resume").stdout, "")

    def test_two_jobs_in_one_folder_do_not_interfere(self):
        both = [subprocess.Popen([PROGRAM, *SMOOTH], cwd=self.folder, stdout=subprocess.DEVNULL) for _ in range(2)]
        self.assertEqual([process.wait() for process in both], [0, 0])
        self.expect_whole()

    def test_bad_input_in_a_list_does_not_stop_the_others(self):
        out = ["--clip", "Walk", "--frames", "0:4:2", "--depth", "1", "-o", "out file's/{name}_%d.ply"]
        (self.folder / "list.txt").write_text("# two good ones\n%s\n\nmissing.glb\n %s \n" % (
            RIG, ROOT / "assets" / "horse.rig.json"))
        done = sinew(self.folder, "smooth", "--list", "list.txt", *out, check=False)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual([line for line in done.stderr.splitlines() if "missing.glb" in line], done.stderr.splitlines())
        self.assertEqual(sorted(contents(self.folder)),
                         ["%s_%d.ply" % (name, frame) for name in ("demo", "horse") for frame in (0, 2, 4)])
        (self.folder / "list.txt").write_text("missing.glb\nabsent.glb\n")
        self.assertEqual(sinew(self.folder, "smooth", "--list", "list.txt", *out, check=False).returncode, 1)

    def test_exports_of_a_list_can_be_sharded(self):
        (self.folder / "list.txt").write_text("".join("%s\n" % (ROOT / "assets" / name) for name in (
            "demo.rig.json", "horse.rig.json", "wrapped.glb")))
        job = ["export", "--list", "list.txt", "--as", "skinned", "--depth", "1", "--weights", "transferred", "-o",
               "out file's/{name} muscled.glb"]
        names = sinew(self.folder, *job, "--dry-run").stdout.splitlines()
        for index in (2, 0, 1):
            sinew(self.folder, *job, "--shard", "%d/3" % index)
        parts = contents(self.folder)
        self.assertEqual(sorted("out file's/" + name for name in parts), sorted(names))
        sinew(self.folder, *job)
        self.assertEqual(contents(self.folder), parts)

    def test_command_lines_run_the_whole_job(self):
        lines = self.farm("commands", 5, RENDER).read_text().splitlines()
        self.assertEqual(len(lines), 5)
        for line in lines:
            subprocess.run(["sh", "-c", line], cwd="/", check=True, capture_output=True)
        self.expect_whole("render")

    def test_gnu_parallel_runs_the_whole_job(self):
        if shutil.which("parallel") is None:
            self.skipTest("left out: GNU parallel is not installed")
        job = self.farm("parallel", 7)
        subprocess.run(["sh", str(job), "--jobs", "2"], cwd="/", check=True, capture_output=True,
                       env={**os.environ, "HOME": str(self.folder)})
        self.expect_whole()

    def test_array_job_script_reads_the_schedulers_variables(self):
        job = self.farm("slurm", 3, RENDER)
        subprocess.run(["bash", "-n", str(job)], check=True)
        for index in (2, 0):
            subprocess.run(["sh", str(job)], cwd="/", check=True, capture_output=True,
                           env={**os.environ, "SLURM_ARRAY_TASK_ID": str(index)})
        last = {"SGE_TASK_ID": "5", "SGE_TASK_FIRST": "1", "SGE_TASK_LAST": "9", "SGE_TASK_STEPSIZE": "4"}
        sinew(self.folder, *RENDER, "--shard", "auto", environment=last)
        self.expect_whole("render")
        gaps = {"SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_MIN": "3", "SLURM_ARRAY_TASK_MAX": "7",
                "SLURM_ARRAY_TASK_STEP": "1", "SLURM_ARRAY_TASK_COUNT": "2"}
        for environment in ({}, gaps):
            none = sinew(self.folder, *RENDER, "--shard", "auto", environment=environment, check=False)
            self.assertEqual((none.returncode, len(none.stderr.splitlines())), (2, 1), none.stderr)

    def test_slurm_array_job_runs_the_whole_job(self):
        reason = slurm_node.why_not()
        if reason:
            self.skipTest("left out: " + reason)
        job = self.farm("slurm", 4)
        with tempfile.TemporaryDirectory(prefix="sinew-slurm-") as folder, slurm_node.Node(folder) as node:
            node.run("sbatch", "--wait", str(job), cwd=self.folder)
        self.assertEqual(len(list(self.folder.glob("sinew-smooth-*.log"))), 4)
        self.expect_whole()

    def test_openjd_template_runs_the_whole_job(self):
        template = json.loads(self.farm("openjd", 3, RENDER).read_text())
        self.assertEqual(template["specificationVersion"], "jobtemplate-2023-09")
        step, = template["steps"]
        shard, = step["parameterSpace"]["taskParameterDefinitions"]
        self.assertEqual((shard["name"], shard["type"], shard["range"]), ("Shard", "INT", "0-2"))
        run = step["script"]["actions"]["onRun"]
        for index in range(3):
            words = [word.replace("{{Task.Param.Shard}}", str(index)) for word in [run["command"], *run["args"]]]
            subprocess.run(words, cwd="/", check=True, capture_output=True)
        self.expect_whole("render")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
