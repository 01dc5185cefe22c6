# tests/export/usd_test.py: .usda files read and skinned by other means. Usage: usd_test.py PROGRAM ROOT CHARACTERS
"""At three moments of the first two clips (with MORE in the environment of all, of more characters) the file, skinned by
the reader of these tests, shows what the .glb of the same export shows and, within the printed error, what `sinew smooth` shows. npm's
tinyusdz reads the same points; that part says so where it is left out."""
import json
import math
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
import usd_reader
from awkward_gltf import awkward
from face_gltf import SHAPES, face_rig, write_face
from glb_reader import Glb

MOMENTS = 3
MORE = "MORE" in os.environ
CLIPS = 1000 if MORE else 2
RIGS = ("humanoid", "horse", "humanoid-flex") if MORE else ("horse", "humanoid-flex")
ADAPTIVE = "horse"  # As fine as its rig says; of the others few vertices, since weights are fitted vertex by vertex.
FEW = [] if MORE else ["--depth", "2"]
CHARACTERS = ["Fox.glb", "cesium_man.gltf", "SimpleSkin.gltf"]
CHARACTERS += ["greenman.glb", "robot.glb", "RobotExpressive.glb"] if MORE else []
EXACT = 0.0005  # % of the height: what floats in text and the weld of a second import leave.
HALVES = 0.06  # Scales that change have 11 bits.
IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*$")
READ = r"""
globalThis.window = globalThis;  // It is made for browsers alone.
process.type = 'renderer';
const fs = require('fs'), path = require('path');
(async () => {
  const folder = path.dirname(require.resolve('tinyusdz/tinyusdz.js'));
  const usd = await (await import(path.join(folder, 'tinyusdz.js'))).default(
    {wasmBinary: fs.readFileSync(path.join(folder, 'tinyusdz.wasm'))});
  const seen = {};
  for (const file of process.argv.slice(1)) {
    const stage = new usd.TinyUSDZLoaderNative();
    if (!stage.loadFromBinary(new Uint8Array(fs.readFileSync(file)), file)) { seen[file] = stage.error(); continue; }
    seen[file] = [];
    for (let m = 0; m < stage.numMeshes(); ++m) {
      const mesh = stage.getMesh(m);
      seen[file].push([mesh.primName, Array.from(mesh.points), Array.from(mesh.faceVertexIndices)]);
    }
  }
  fs.writeFileSync(process.env.SEEN, JSON.stringify(seen));
})();
"""


def output(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def surface(program, source, folder, *more):
    """Corners of all triangles of the live surface."""
    output(program, "smooth", source, "-o", folder / "live.obj", *more)
    points, corners = [], []
    for line in (folder / "live.obj").read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            corners += [points[int(word.split("/")[0]) - 1] for word in words[1:]]
    return corners


def farthest(a, b):
    assert len(a) == len(b) > 0, (len(a), len(b))
    return max(map(math.dist, a, b))


def check_paths(root, folder):
    """What relations and connections name is there, and so are the textures."""
    paths = {prim.path: prim for prim in root.all()}
    for prim in root.all():
        for name, value in prim.values.items():
            for each in value if name.startswith("skel:blendShapeTargets") else []:
                assert each in paths, each
            if isinstance(value, str) and value.startswith("/"):
                path, _, output_name = value.partition(".")
                assert path in paths, value
                assert not output_name or any(each == output_name or each.startswith(output_name + ".connect")
                                              for each in list(paths[path].types)), value
            elif prim.types[name] == "asset":
                assert (folder / value).is_file(), value


def check_joints(root):
    (skeleton,) = root.all("Skeleton")
    for path in skeleton.values["joints"]:
        assert all(map(IDENTIFIER.match, path.split("/"))), path
        assert "/" not in path or path.rpartition("/")[0] in skeleton.values["joints"]
    assert sum("/" not in path for path in skeleton.values["joints"]) == 1
    assert len(set(skeleton.values["jointNames"])) == len(skeleton.values["joints"])


def check_attributes(root, glb, file):
    """Vertices are those of the .glb, v upwards; the images its images."""
    meshes = iter(root.all("Mesh"))
    for node in [node for node in glb.json["nodes"] if "mesh" in node]:
        for primitive in glb.json["meshes"][node["mesh"]]["primitives"]:
            mesh, attributes = next(meshes), primitive["attributes"]
            assert as_floats(mesh.values["points"]) == glb.rows(attributes["POSITION"])
            assert as_floats(mesh.values["normals"]) == glb.rows(attributes["NORMAL"])
            if "TEXCOORD_0" in attributes:
                for (s, t), (u, v) in zip(mesh.values["primvars:st"], glb.rows(attributes["TEXCOORD_0"])):
                    assert abs(s - u) < 1e-6 and abs(t - (1.0 - v)) < 1e-6
            assert mesh.values["subdivisionScheme"] == "none"
    assert next(meshes, None) is None
    views = [glb.json["bufferViews"][image["bufferView"]] for image in glb.json.get("images", [])]
    images = [glb.data[view.get("byteOffset", 0):view.get("byteOffset", 0) + view["byteLength"]] for view in views]
    for texture in file.parent.glob(file.stem + "_*"):
        assert texture.read_bytes() in images, texture


def as_float(number):
    return struct.unpack("<f", struct.pack("<f", number))[0]


def as_floats(rows):
    """What a reader keeps of decimals."""
    return [tuple(map(as_float, row)) for row in rows]


def check(program, source, folder, *kind, exact=EXACT):
    file, glb = folder / (source.name.split(".")[0] + "".join(kind[1:2]) + ".usda"), folder / "out.glb"
    report = json.loads(output(program, "export", source, "--as", *kind, "--json", "-o", file))
    first = file.read_bytes()
    output(program, "export", source, "--as", *kind, "-o", glb)
    if "transferred" in kind:
        output(program, "export", source, "--as", *kind, "-o", file)
        assert file.read_bytes() == first, "the same inputs, other bytes"
    beside = list(folder.glob(file.stem + "_*"))
    assert report["bytes"] == len(first) + sum(each.stat().st_size for each in beside)
    height = json.loads(output(program, "inspect", source, "--json"))["height"]
    layer, root = usd_reader.read(file)
    assert layer["upAxis"] == "Y" and layer["metersPerUnit"] == 1 and layer["defaultPrim"] == root.name
    check_paths(root, folder)
    check_joints(root)
    check_attributes(root, Glb(glb), file)
    animations = root.all("SkelAnimation")
    printed = {clip["name"]: clip["max"] for clip in report["error_percent_of_height"]["clips"]}
    (skeleton,) = root.all("Skeleton")
    assert skeleton.values.get("skel:animationSource") == (animations[0].path if animations else None)
    assert layer["endTimeCode"] == max([each.codes()[-1] for each in animations if each.codes()], default=0)
    worst = [0.0, 0.0]
    for animation in animations[:CLIPS]:
        clip = animation.metadata.get("displayName", animation.name)
        codes = animation.codes() or [0.0]
        for i in range(MOMENTS):
            code = codes[i * (len(codes) - 1) // (MOMENTS - 1)]
            moment = ["--clip", clip, "--time", repr(code / layer["timeCodesPerSecond"])]
            shown = usd_reader.skinned(root, animation, code)
            depth = kind[kind.index("--depth"):][:2] if "--depth" in kind else []
            live = 100.0 / height * farthest(shown, surface(program, source, folder, *moment, *depth))
            same = 100.0 / height * farthest(shown, surface(program, glb, folder, *moment, "--depth", "1"))
            assert live <= 1.01 * printed[clip] + exact, "%s %s %g: %g %%, %g printed" % (source, clip, code, live,
                                                                                         printed[clip])
            assert same <= exact, "%s %s %g: %g %% from the .glb" % (source.name, clip, code, same)
            worst = [max(worst[0], live), max(worst[1], same)]
    print("%s %s: %d clips, %.3f %% of the height from the live surface, %.5f %% from the .glb" %
          (source.name, " ".join(kind), len(animations[:CLIPS]), *worst))
    return file


def check_shapes(file):
    """Every shape is there under its name, and moves something."""
    _, root = usd_reader.read(file)
    shapes = root.all("BlendShape")
    assert [each.metadata.get("displayName", each.name) for each in shapes] == list(SHAPES)
    assert all(each.values["pointIndices"] for each in shapes)
    (animation,) = root.all("SkelAnimation")
    assert len(animation.values["blendShapeWeights.timeSamples"]) == 61


def check_points(program, source, folder, clip, rate):
    """A baked clip: the points are those of the live surface, in every frame."""
    file = folder / (source.name.split(".")[0] + " points.usda")
    baked = ["export", source, "--as", "baked", "--clip", clip, "--fps", rate, "--depth", "1", "-o", file]
    report = json.loads(output(program, *baked, "--json"))
    first = file.read_bytes()
    output(program, *baked)
    assert file.read_bytes() == first, "the same inputs, other bytes"
    beside = list(folder.glob(file.stem + "_*"))
    assert report["bytes"] == len(first) + sum(each.stat().st_size for each in beside)
    layer, root = usd_reader.read(file)
    assert root.kind == "Xform" and not root.all("Skeleton") and layer["timeCodesPerSecond"] == rate
    check_paths(root, folder)
    codes = root.codes_below()
    assert codes[:-1] == list(range(len(codes) - 1)) and len(codes) == report["frames"]
    assert [layer["startTimeCode"], layer["endTimeCode"]] == [codes[0], codes[-1]]
    assert sum(len(mesh.at("points", 0.0)) for mesh in root.all("Mesh")) == report["vertices"]
    height = json.loads(output(program, "inspect", source, "--json"))["height"]
    worst = 0.0
    for i in range(MOMENTS):
        code = codes[i * (len(codes) - 1) // (MOMENTS - 1)]
        moment = ["--clip", clip, "--time", repr(code / rate), "--depth", "1"]
        live = surface(program, source, folder, *moment)
        worst = max(worst, 100.0 / height * farthest(usd_reader.pointed(root, code), live))
    assert worst <= EXACT, "%s: %g %%" % (source, worst)
    print("%s %s: %d frames of points, %.5f %% of the height from the live surface" %
          (source.name, clip, len(codes), worst))
    return file


def check_awkward(program, folder):
    files = []
    for name, options in (("plain", {}), ("scales", {"scales": True}), ("still", {"clips": False})):
        source = folder / (name + " \u00fc.gltf")
        source.write_text(json.dumps(awkward(**options)), encoding="utf-8")
        kind = ["skinned", "--weights", "transferred", "--depth", "1"]
        files.append(check(program, source, folder, *kind, exact=HALVES if "scales" in options else EXACT))
        _, root = usd_reader.read(files[-1])
        (skeleton,) = root.all("Skeleton")
        names = skeleton.values["jointNames"]
        for joint in ("h\u00fcfte 1.0", "knee", "knee 2", "9 toe", 'a/b "q"\\'):
            assert joint in names, (joint, names)
        assert 'skin "A" \u00df' in [each.metadata.get("displayName") for each in root.all("Material")]
        assert len(root.all("Material")) == 3 and len(root.all("Mesh")) == 3
        assert len([each for each in root.all("Mesh") if "primvars:displayColor" in each.values]) == 1
        assert sum("\u00fcfte" in joint for joint in names) == 2  # Two skins bind it differently.
        assert len(names) == 9, names  # 5 of skins, 1 again, a mesh, "stretch", a root
    files.append(check_points(program, folder / "plain \u00fc.gltf", folder, '1st "clip"', 12))
    # At rest: the same place as in a clip whose keys are those of the rest pose.
    resting = folder / "resting.gltf"
    resting.write_text(json.dumps(awkward(resting=True)), encoding="utf-8")
    output(program, "export", resting, "--as", *kind, "-o", folder / "resting.glb")
    shown = surface(program, folder / "resting.glb", folder, "--clip", '1st "clip"', "--depth", "1")
    assert farthest(usd_reader.skinned(root), shown) < 1e-5
    return files


def check_tinyusdz(files, folder):
    """None, or why it was left out."""
    if not shutil.which("node"):
        return "node is not installed"
    modules = os.environ.get("NODE_PATH", "")
    find = ["node", "-e", "require.resolve('tinyusdz/tinyusdz.js')"]
    if subprocess.run(find, capture_output=True).returncode != 0:
        if not shutil.which("npm"):
            return "npm is not installed"
        modules = str(folder / "npm" / "node_modules")
        try:
            subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", folder / "npm",
                            "tinyusdz@0.9.0-rc10"], check=True, capture_output=True, timeout=60)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            return "npm's tinyusdz is not at hand"
    copies = {}
    for file in files:
        copies[file] = folder / "read" / file.name
        copies[file].parent.mkdir(exist_ok=True)
        # Its scenes know no other inputs than colors of textures; it would refuse the whole file.
        text = re.sub(r"\n.*\.connect = <.*(outputs:a|VertexColor\.outputs:result)>", "", file.read_text())
        # Nor does this version read weights of blend shapes.
        text = re.sub(r"\n *uniform token\[\] blendShapes = .*", "", text)
        text = re.sub(r"\n *float\[\] blendShapeWeights(\.timeSamples = \{[^}]*\}| = .*)", "", text)
        copies[file].write_text(text)
    environment = {**os.environ, "NODE_PATH": modules, "SEEN": str(folder / "seen.json")}
    subprocess.run(["node", "-e", READ, *map(str, copies.values())], env=environment, check=True, capture_output=True)
    seen = json.loads((folder / "seen.json").read_text())
    for file in files:
        meshes = seen[str(copies[file])]
        assert isinstance(meshes, list), meshes
        own = {mesh.name: mesh for mesh in usd_reader.read(file)[1].all("Mesh")}
        assert sorted(own) == sorted(name for name, _, _ in meshes)
        for name, points, indices in meshes:
            assert indices == own[name].values["faceVertexIndices"], name
            codes = own[name].codes()
            first = own[name].at("points", codes[0] if codes else None)
            flat = [as_float(number) for point in first for number in point]
            assert points == flat, name
        print("tinyusdz reads %s: %d meshes" % (file.name, len(meshes)))
    return None


def main():
    program, root, characters = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = check_awkward(program, folder)
        for each in RIGS:
            files.append(check(program, root / "assets" / (each + ".rig.json"), folder, "skinned", *(FEW if each != ADAPTIVE else [])))
        write_face(folder / "face.glb")
        (folder / "face.rig.json").write_text(face_rig("face.glb"))
        files.append(check(program, folder / "face.rig.json", folder, "skinned"))
        check_shapes(files[-1])
        files.append(check(program, root / "assets" / "humanoid-flex.rig.json", folder, "helpers", "--joints", "8", *FEW,
                           exact=HALVES))
        files.append(check_points(program, root / "assets" / "humanoid-flex.rig.json", folder, "Flex", 5))
        files.append(check_points(program, root / "assets" / "horse.rig.json", folder, "Gallop", 30))
        for each in CHARACTERS:
            if (characters / each).exists():
                kind = ["skinned", "--weights", "transferred", "--depth", "1"]
                files.append(check(program, characters / each, folder, *kind))
            else:
                print("left out: no " + each)
        left = check_tinyusdz(files, folder)
        if left:
            print("left out: reading by tinyusdz: " + left)
    return 0


if __name__ == "__main__":
    sys.exit(main())
