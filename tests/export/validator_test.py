# tests/export/validator_test.py: Khronos's validator on what `sinew export` writes. Usage: validator_test.py PROGRAM ROOT CHARACTERS
"""No errors, and no warnings of kinds that the source file does not have. The validator is npm's gltf-validator: found by
node (NODE_PATH), else fetched into a folder for this run. Left out (77) where neither works."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from face_gltf import face_rig, write_face
from simple_rig import simple_rig

# Of every source with its shortest clip; with all clips the first kind, of ALL_CLIPS or where MORE is in the environment.
# Weights are fitted vertex by vertex, and no count of vertices makes a file more or less valid: most are made with few. Fox and
# face have the detail of their rig.
MORE = "MORE" in os.environ
DEPTHS = {} if MORE else {"humanoid-flex": "2", "horse": "2", "cesium_man": "1", "robot": "1"}
BUNDLED = ("humanoid", "horse", "humanoid-flex", "horse-flex") if MORE else ("humanoid-flex", "horse")  # With lines, and without.
KINDS = {"refined": ["skinned"], "original": ["skinned", "--mesh", "original"], "helpers": ["helpers"],
         "helpers-original": ["helpers", "--mesh", "original", "--joint-scale", "none"], "baked": ["baked", "--bound", "0.05"]}
ALL_CLIPS = ("humanoid-flex.rig.json", "Fox.rig.json")
ENDINGS = (".glb", ".gltf")  # By turns: each kind is seen in both.

CHECK = r"""
const fs = require('fs'), path = require('path'), validator = require('gltf-validator');
(async () => {
  const codes = {};
  for (const file of process.argv.slice(1)) {
    const beside = uri => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri)));
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)),
      {uri: path.basename(file), maxIssues: 0, externalResourceFunction: async uri => new Uint8Array(await beside(uri))});
    codes[file] = report.issues.messages.filter(m => m.severity < 2).map(m => [m.severity, m.code, m.pointer]);
  }
  console.log(JSON.stringify(codes));
})();
"""


def node_path(folder):
    """NODE_PATH under which the validator is found, or None."""
    places = [os.environ.get("NODE_PATH", ""), "/usr/share/nodejs"]
    find = ["node", "-e", "require('gltf-validator')"]
    for path in places:
        if subprocess.run(find, env={**os.environ, "NODE_PATH": path}, capture_output=True).returncode == 0:
            return path
    if not shutil.which("npm"):
        return None
    try:
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, "gltf-validator@2.0.0-dev.3.10"],
                       check=True, capture_output=True, timeout=60)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    return str(pathlib.Path(folder) / "node_modules")


def issues(files, modules):
    run = subprocess.run(["node", "-e", CHECK, *map(str, files)], env={**os.environ, "NODE_PATH": modules}, check=True,
                         capture_output=True, text=True)
    return json.loads(run.stdout)


def main():
    program, root, characters = map(pathlib.Path, sys.argv[1:4])
    if not shutil.which("node"):
        print("left out: node is not installed")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        modules = node_path(folder / "npm")
        if modules is None:
            print("left out: npm's gltf-validator is not at hand")
            return 77
        sources = [root / "assets" / (each + ".rig.json") for each in BUNDLED]
        sources += [characters / each for each in ("Fox.glb", "greenman.glb", "cesium_man.gltf", "robot.glb")]
        write_face(folder / "face.glb")
        (folder / "face.rig.json").write_text(face_rig("face.glb"))
        sources.append(folder / "face.rig.json")
        bad = 0
        for number, source in enumerate(each for each in sources if each.exists()):
            if source.suffix == ".json":
                character = source.parent / json.loads(source.read_text())["character"]
            else:
                character, source = source, simple_rig(program, source, folder)
            clips = json.loads(subprocess.run([program, "inspect", source, "--json"], check=True, capture_output=True).stdout)
            clip = min(clips["clips"], key=lambda each: each["duration"])["name"]
            every = MORE or source.name in ALL_CLIPS
            depth = DEPTHS.get(source.name.split(".")[0])
            out = []
            for kind, (name, words) in enumerate(KINDS.items()):
                out.append(folder / (name + ENDINGS[(number + kind) % 2]))
                more = ["--clip", clip] if kind > 0 or not every else []
                if depth:
                    more += ["--depth", depth]
                subprocess.run([program, "export", source, "--as", *words, *more, "-o", out[-1]], check=True, capture_output=True)
            found = issues([character, *out], modules)
            had = {code for _, code, _ in found[str(character)]}
            for file in out:
                new = [issue for issue in found[str(file)] if issue[0] == 0 or issue[1] not in had]
                print("%s as %s: %d new issues" % (source.name, file.name, len(new)))
                for issue in new[:5]:
                    print("   ", *issue)
                bad += len(new)
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
