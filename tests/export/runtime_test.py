# tests/export/runtime_test.py: runtimes of examples/ against the core. Usage: runtime_test.py PROGRAM ORACLE ROOT HOW
"""In the bind pose and in random poses of three rigs with all joint scales, and of other people's characters, the world
matrices of muscle joints agree to 1e-4 of the height. HOW: `node` checks the formulas with node alone, and three's graph
where npm gives three; `browser` loads an export in Chromium, checks there and looks at pictures; `mono` compiles and runs
the C# with stubs of Unity's types; `godot` runs the GDScript as Python. Left out (77) where tools are missing."""
import functools
import http.server
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

import godot_in_python

THREE = "0.187.0"
POSES = 100
NEAR = 1e-4  # Of the height.
CLIPS = {"humanoid-flex": "Flex", "horse-flex": "Gallop", "post.glb": "bend"}
DEPTHS = {"post.glb": 3, "Fox.glb": 2}  # Else 1.
OTHERS = {"Fox.glb": "Walk", "cesium_man.gltf": "clip 0"}  # Where they are at hand.

# Numbers first, then pictures of index.html; all of it sent to the server that the page came from.
QUERIES = {"stiff": "clip=&joint=forearm.L&angle=-110&axis=z&time=0&muscles=0",
           "bent": "clip=&joint=forearm.L&angle=-110&axis=z&time=0&muscles=1",
           "keyed": "clip=Flex&time=2&muscles=0", "played": "clip=Flex&time=2&muscles=1"}
CHECK_PAGE = """<!doctype html><title>checking</title>
<script type="importmap">{"imports": {"three": "./node_modules/three/build/three.module.js",
 "three/addons/": "./node_modules/three/examples/jsm/"}}</script>
<iframe id="page" width="800" height="800"></iframe>
<script type="module">
const send = (name, body) => fetch(name, { method: 'POST', body });
const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));
try {
  const three = await import('three');
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const { clone } = await import('three/addons/utils/SkeletonUtils.js');
  const { SinewMuscles } = await import('./sinew_muscles.js');
  const { checkGraph } = await import('./runtime_check.js');
  const oracle = await (await fetch('oracle.json')).json();
  const gltf = await new GLTFLoader().loadAsync('hero.glb');
  await send('numbers', JSON.stringify(checkGraph(gltf, oracle, three, clone, SinewMuscles)));
  const page = document.getElementById('page');
  for (const [name, query] of Object.entries(QUERIES)) {
    const loaded = new Promise(done => page.addEventListener('load', done, { once: true }));
    page.src = 'index.html?file=hero.glb&' + query;
    await loaded;
    while (page.contentDocument.title !== 'drawn') await wait(50);
    const canvas = page.contentDocument.querySelector('canvas');
    await send(name, await new Promise(done => canvas.toBlob(done)));
  }
} catch (error) { await send('error', String(error.stack)); }
await send('end', '');
</script>""".replace("QUERIES", json.dumps(QUERIES))


class Bench:
    def __init__(self, program, oracle, root, folder):
        self.program, self.oracle, self.root, self.folder = program, oracle, root, folder
        self.characters = root / "../shared/characters"
        subprocess.run([oracle, "post", folder / "post.glb"], check=True)
        for file in ("examples/three.js/sinew_muscles.js", "examples/three.js/index.html", "tests/export/runtime_check.js",
                     "tests/export/runtime_in_node.js", "tests/export/without_images.mjs"):
            shutil.copy(root / file, folder)
        (folder / "package.json").write_text('{"type": "module"}')

    def rig(self, name):
        if "." not in name:
            return self.root / "assets" / (name + ".rig.json")
        rig, character = self.folder / (name + ".rig.json"), self.folder / name
        if not character.exists():
            character = self.characters / name
        subprocess.run([self.oracle, "lines", character, rig], check=True)
        return rig

    def export(self, name, scale, file="hero.glb", depth=None):
        """The exported file, as coarse as will do, and the core's poses."""
        out, poses, rig = self.folder / file, self.folder / "oracle.json", self.rig(name)
        subprocess.run([self.program, "export", rig, "--as", "helpers", "--joint-scale", scale, "--joints", "48",
                        "--depth", str(depth or DEPTHS.get(name, 1)), "--clip", {**CLIPS, **OTHERS}[name], "-o", out], check=True,
                       capture_output=True)
        printed = subprocess.run([self.oracle, "poses", rig, scale, str(POSES)], check=True, capture_output=True)
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
            ("%d keys within %.1e H" % (found["keys"], found["keyed"]), found["keys"] > 50 and found["keyed"] < NEAR)]


def joint_check(found):
    holds = found["joints"] >= 6 * POSES and found["worst"] < NEAR
    return "%d joints within %.1e H" % (found["joints"], found["worst"]), holds


def scenes():
    return [(name, scale) for name in CLIPS for scale in ("full", "uniform", "none")]


def fewer_scenes():
    """Where the formulas are those that node checks in all scenes."""
    return [("humanoid-flex", "full"), ("horse-flex", "none")] + [("post.glb", scale) for scale in ("full", "uniform", "none")]


def in_node(bench):
    if not shutil.which("node"):
        print("left out: node is not installed")
        return 77
    with_three = bench.three()
    if not with_three:
        print("three's graph is left out: npm's three is not at hand")
    good = True
    others = [(name, "full") for name in OTHERS if (bench.characters / name).exists()]
    for name, scale in scenes() + others:
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
                  ("in the bind pose %.1e H" % formulas["bind"], formulas["bind"] < NEAR),
                  ("%d on via points" % formulas["vias"],
                   formulas["joints"] > POSES / 2 and (formulas["vias"] > POSES / 2 or name in OTHERS))]
        good &= judged("%s, %s" % (name, scale), checks + (graph_checks(found["graph"]) if with_three else []))
    return 0 if good else 1


class Listener(http.server.SimpleHTTPRequestHandler):
    """Gives files, and takes what the page sends."""

    def do_POST(self):
        self.server.sent[self.path[1:]] = self.rfile.read(int(self.headers["Content-Length"]))
        self.send_response(204)
        self.end_headers()
        if self.path == "/end":
            self.server.ended.set()

    def log_message(self, *_):
        pass


def opened(folder, page):
    """What a page sends until it says that it is at its end. Chromium without a window, drawing in software."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Listener, directory=str(folder)))
    server.sent, server.ended = {}, threading.Event()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    command = ["chromium", "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
               "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--window-size=900,900",
               "--user-data-dir=%s" % (folder / "profile"), "http://127.0.0.1:%d/%s" % (server.server_address[1], page)]
    with open(folder / "chromium.log", "w") as log:
        browser = subprocess.Popen(command, stdout=log, stderr=log, env={**os.environ, "HOME": str(folder)},
                                   start_new_session=True)
        ended = server.ended.wait(300)
        os.killpg(browser.pid, signal.SIGTERM)
        browser.wait()
    server.shutdown()
    if not ended:
        print((folder / "chromium.log").read_text())
    return server.sent


def pixels(png):
    rgb = subprocess.run(["convert", "png:-", "-alpha", "off", "-depth", "8", "rgb:-"], input=png, check=True,
                         capture_output=True).stdout
    return [rgb[i:i + 3] for i in range(0, len(rgb), 3)]


def different(a, b):
    return [i for i, pair in enumerate(zip(a, b)) if max(abs(x - y) for x, y in zip(*pair)) > 8]


def in_browser(bench):
    for tool in ("chromium", "npm", "convert"):
        if not shutil.which(tool):
            print("left out: %s is not installed" % tool)
            return 77
    if not bench.three():
        print("left out: npm's three is not at hand")
        return 77
    (bench.folder / "check.html").write_text(CHECK_PAGE)
    bench.export("humanoid-flex", "full", depth=2)
    sent = opened(bench.folder, "check.html")
    if "end" not in sent or "error" in sent:
        print(sent.get("error", b"the page did not come to its end").decode())
        return 1
    if kept := os.environ.get("SINEW_KEEP_PICTURES"):
        for name in QUERIES:
            (pathlib.Path(kept) / (name + ".png")).write_bytes(sent[name])
    good = judged("humanoid-flex in Chromium", graph_checks(json.loads(sent["numbers"])))
    stiff, bent, keyed, played = (pixels(sent[name]) for name in QUERIES)
    covered = sum(pixel != bent[0] for pixel in bent) / len(bent)
    changed = different(stiff, bent)
    near = sum(i % 800 > 400 for i in changed)  # On the side of the arm.
    good &= judged("index.html", [
        ("%.1f %% of the picture is the character" % (100 * covered), len(bent) == 640000 and 0.05 < covered < 0.6),
        ("%d pixels change with the muscles" % len(changed), 500 < len(changed) < 20000),
        ("%d of them where the arm bends" % near, near > 0.95 * len(changed)),
        ("in a clip with keys %d" % len(different(keyed, played)), len(different(keyed, played)) < 20),
        ("which shows another pose, %d" % len(different(bent, played)), len(different(bent, played)) > 20000)])
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
    for name, scale in fewer_scenes():
        file, poses = bench.export(name, scale, "hero.gltf")
        found = json.loads(subprocess.run(["mono", exe, file, poses], check=True, capture_output=True, text=True).stdout)
        good &= judged("%s, %s" % (name, scale), [joint_check(found)])
    return 0 if good else 1


def as_python(bench):
    """Godot is not here: the GDScript is run as Python."""
    text = (bench.root / "examples/godot/sinew_muscles.gd").read_text()
    good = True
    for name, scale in fewer_scenes():
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
