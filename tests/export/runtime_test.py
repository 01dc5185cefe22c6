# tests/export/runtime_test.py: runtimes of examples/ against the core. Usage: runtime_test.py PROGRAM ORACLE ROOT HOW
"""Random poses of three rigs and all joint scales: world matrices of muscle joints agree to 1e-4 of the height. HOW
`node` checks the formulas with node alone, and three's graph where npm gives three; `browser` loads an export in
Chromium, checks there and looks at a picture; `mono` compiles and runs the C# with stubs of Unity's types; `godot` runs
the GDScript as Python. Left out (77) where the tools are missing."""
import functools
import http.server
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

import godot_in_python

THREE = "0.170.0"
POSES = 100
NEAR = 1e-4  # Of the height.
WIDE = 560
CLIPS = {"humanoid-flex": "Flex", "horse-flex": "Gallop", "post": "bend"}

CHECK_PAGE = """<!doctype html><title>checking</title>
<script type="importmap">{"imports": {"three": "./node_modules/three/build/three.module.js",
 "three/addons/": "./node_modules/three/examples/jsm/"}}</script><pre id="result"></pre>
<script type="module">
const show = text => document.getElementById('result').textContent = text;
try {
  const three = await import('three');
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const { clone } = await import('three/addons/utils/SkeletonUtils.js');
  const { SinewMuscles } = await import('./sinew_muscles.js');
  const { checkGraph } = await import('./runtime_check.js');
  const oracle = await (await fetch('oracle.json')).json();
  const gltf = await new GLTFLoader().loadAsync('hero.glb');
  show(JSON.stringify(checkGraph(gltf, oracle, three, clone, SinewMuscles)));
} catch (error) { show(JSON.stringify({ error: String(error.stack) })); }
</script>"""


class Bench:
    def __init__(self, program, oracle, root, folder):
        self.program, self.oracle, self.root, self.folder = program, oracle, root, folder
        subprocess.run([oracle, "post", folder], check=True)
        for file in ("examples/three.js/sinew_muscles.js", "examples/three.js/index.html", "tests/export/runtime_check.js",
                     "tests/export/runtime_in_node.js"):
            shutil.copy(root / file, folder)
        (folder / "package.json").write_text('{"type": "module"}')

    def rig(self, name):
        return (self.folder if name == "post" else self.root / "assets") / (name + ".rig.json")

    def export(self, name, scale, file="hero.glb"):
        """The exported file, and the core's poses."""
        out, poses = self.folder / file, self.folder / "oracle.json"
        subprocess.run([self.program, "export", self.rig(name), "--as", "helpers", "--joint-scale", scale, "--joints", "48",
                        "--clip", CLIPS[name], "-o", out], check=True, capture_output=True)
        printed = subprocess.run([self.oracle, "poses", self.rig(name), scale, str(POSES)], check=True, capture_output=True)
        poses.write_bytes(printed.stdout)
        return out, poses

    def three(self):
        """Whether npm's three is in the folder now."""
        if not shutil.which("npm"):
            return False
        try:
            subprocess.run(["npm", "install", "--no-audit", "--no-fund", "three@" + THREE], cwd=self.folder, check=True,
                           capture_output=True, timeout=60)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            return False
        return True


def judged(what, checks):
    """Prints what was found; whether all of it holds."""
    bad = [text for text, holds in checks if not holds]
    print("%s: %s%s" % (what, ", ".join(text for text, _ in checks), " FAILED: " + ", ".join(bad) if bad else ""))
    return not bad


def graph_checks(found):
    return [("%d joints in three's graph within %.1e H" % (found["joints"], found["worst"]), found["worst"] < NEAR),
            ("%d keys within %.1e H" % (found["keys"], found["keyed"]), found["keys"] > 100 and found["keyed"] < NEAR)]


def joint_check(found):
    holds = found["joints"] >= 6 * POSES and found["worst"] < NEAR
    return "%d joints within %.1e H" % (found["joints"], found["worst"]), holds


def scenes():
    return [(name, scale) for name in CLIPS for scale in ("full", "uniform", "none")]


def in_node(bench):
    if not shutil.which("node"):
        print("left out: node is not installed")
        return 77
    with_three = bench.three()
    if not with_three:
        print("three's graph is left out: npm's three is not at hand")
    good = True
    for name, scale in scenes():
        file, poses = bench.export(name, scale)
        run = subprocess.run(["node", "runtime_in_node.js", file, poses] + (["three"] if with_three else []), cwd=bench.folder,
                             capture_output=True, text=True)
        if run.returncode:
            print(run.stderr)
            return 1
        found = json.loads(run.stdout)
        formulas = found["formulas"]
        checks = [("%d joints by formulas within %.1e H" % (formulas["joints"], formulas["worst"]), formulas["worst"] < NEAR),
                  ("%.2f H from where they rest" % formulas["moved"], formulas["moved"] > 0.1),
                  ("%d on via points" % formulas["vias"], formulas["joints"] >= 6 * POSES and formulas["vias"] >= POSES)]
        good &= judged("%s, %s" % (name, scale), checks + (graph_checks(found["graph"]) if with_three else []))
    return 0 if good else 1


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class Browser:
    """Chromium without a window, drawing in software, on pages of a folder."""

    def __init__(self, folder):
        self.folder = folder
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(folder)))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def open(self, page, *options):
        command = ["chromium", "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
                   "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars", "--window-size=800,800",
                   "--user-data-dir=%s" % (self.folder / "profile"), "--virtual-time-budget=20000", *options,
                   "http://127.0.0.1:%d/%s" % (self.server.server_address[1], page)]
        return subprocess.run(command, capture_output=True, text=True, timeout=240, cwd=self.folder,
                              env={**os.environ, "HOME": str(self.folder)})


def pixels(file):
    """Bytes r g b of the part right of the page's form, WIDE pixels in a row."""
    run = subprocess.run(["convert", file, "-crop", "%dx800+%d+0" % (WIDE, 800 - WIDE), "+repage", "-depth", "8", "rgb:-"], check=True,
                         capture_output=True)
    return run.stdout


def in_browser(bench):
    for tool in ("chromium", "npm", "convert"):
        if not shutil.which(tool):
            print("left out: %s is not installed" % tool)
            return 77
    if not bench.three():
        print("left out: npm's three is not at hand")
        return 77
    browser = Browser(bench.folder)
    (bench.folder / "check.html").write_text(CHECK_PAGE)
    bench.export("humanoid-flex", "full")
    page = browser.open("check.html", "--dump-dom").stdout
    found = json.loads(page.split('id="result">')[1].split("</pre>")[0])
    if "error" in found:
        print(found["error"])
        return 1
    good = judged("humanoid-flex in Chromium", graph_checks(found))
    pictures = {}
    for muscles in "01":
        shot = bench.folder / ("shot%s.png" % muscles)
        query = "index.html?file=hero.glb&clip=&joint=forearm.L&angle=-110&axis=z&time=0&flex=0&muscles=" + muscles
        run = browser.open(query, "--screenshot=%s" % shot)
        if not shot.exists():
            print(run.stderr)
            return 1
        pictures[muscles] = pixels(shot)
        if os.environ.get("SINEW_KEEP_PICTURES"):
            shutil.copy(shot, os.environ["SINEW_KEEP_PICTURES"])
    background = pictures["1"][:3]
    without, shown = [[p[i:i + 3] for i in range(0, len(p), 3)] for p in pictures.values()]
    covered = sum(pixel != background for pixel in shown) / len(shown)
    changed = [i for i, pair in enumerate(zip(without, shown)) if max(abs(a - b) for a, b in zip(*pair)) > 8]
    near = sum(i % WIDE > WIDE / 3 for i in changed)  # On the side of the arm.
    good &= judged("index.html", [
        ("%.1f %% of the picture is the character" % (100 * covered), 0.05 < covered < 0.6),
        ("%.2f %% of it change with the muscles" % (100 * len(changed) / len(shown)), 0.001 < len(changed) / len(shown) < 0.05),
        ("%d of %d where the arm bends" % (near, len(changed)), near > 0.95 * len(changed))])
    return 0 if good else 1


def by_mono(bench):
    """The compiler finds what a wrong type or name is; Unity itself is not here."""
    for tool in ("mcs", "mono"):
        if not shutil.which(tool):
            print("left out: %s is not installed" % tool)
            return 77
    exe = bench.folder / "check.exe"
    sources = ["examples/unity/SinewMuscles.cs", "tests/export/unity_stubs.cs"]
    subprocess.run(["mcs", "-warnaserror", "-out:%s" % exe, *(bench.root / source for source in sources)], check=True)
    good = True
    for name, scale in scenes():
        file, poses = bench.export(name, scale, "hero.gltf")
        found = json.loads(subprocess.run(["mono", exe, file, poses], check=True, capture_output=True, text=True).stdout)
        good &= judged("%s, %s" % (name, scale), [joint_check(found)])
    return 0 if good else 1


def as_python(bench):
    """Godot is not here: the GDScript is run as Python."""
    text = (bench.root / "examples/godot/sinew_muscles.gd").read_text()
    good = True
    for name, scale in scenes():
        file, poses = bench.export(name, scale, "hero.gltf")
        found = godot_in_python.check(text, json.loads(file.read_text()), json.loads(poses.read_text()))
        good &= judged("%s, %s" % (name, scale), [joint_check(found)])
    return 0 if good else 1


def main():
    program, oracle, root = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        bench = Bench(program, oracle, root, pathlib.Path(name))
        return {"node": in_node, "browser": in_browser, "mono": by_mono, "godot": as_python}[sys.argv[4]](bench)


if __name__ == "__main__":
    sys.exit(main())
