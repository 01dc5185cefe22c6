# tests/export/compression_test.py: characters as npm's gltf-transform compresses them. Usage: compression_test.py PROGRAM ROOT CHARACTERS
"""They open as their originals do, move within the quantisation, and are exported plain; damaged ones are refused in one
line. gltf-transform is fetched by npm into a folder for this run, or found in the one that GLTF_TRANSFORM names. Left out
(77) where neither works."""
import collections
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
sys.path.insert(0, str(HERE))
from glb_reader import Glb
from live_surface import output
from validator_test import issues

TOOL = "@gltf-transform/cli@4.5.1"
WAYS = {"draco": (["draco"], "KHR_draco_mesh_compression"),
        "sequential": (["draco", "--method", "sequential"], "KHR_draco_mesh_compression"),
        "meshopt": (["meshopt"], "EXT_meshopt_compression"),
        "medium": (["meshopt", "--level", "medium"], "EXT_meshopt_compression"),
        "quantized": (["quantize"], "KHR_mesh_quantization"),
        "webp": (["webp"], "EXT_texture_webp")}
MOST_PERCENT = 0.5  # Of the height: weights of eight bits, turned joints.
MORE = "MORE" in os.environ  # More characters, and more damage.
DAMAGED = 100 if MORE else 40
# Ways that say nothing new of a large character.
ONLY_SMALL = ("sequential", "medium")
# In parts that meet, each of which is rounded on its own.
IN_PARTS = "man.glb"


def modules(folder):
    """A node_modules with gltf-transform, or None."""
    if not shutil.which("node") or not shutil.which("npm"):
        return None
    if os.environ.get("GLTF_TRANSFORM"):
        return pathlib.Path(os.environ["GLTF_TRANSFORM"]) / "node_modules"
    try:
        subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, TOOL], check=True,
                       capture_output=True, timeout=180)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        return None
    return folder / "node_modules"


def points_of(program, file, clip, folder):
    """Vertices of the surface in the middle of a clip."""
    moment = ["--clip", clip["name"], "--time", repr(clip["duration"] / 2)] if clip else []
    output(program, "smooth", file, *moment, "--depth", "1", "-o", folder / "surface.obj")
    lines = (folder / "surface.obj").read_text().splitlines()
    return [tuple(map(float, line.split()[1:4])) for line in lines if line.startswith("v ")]


def farthest(points, others, most):
    """Largest distance from a point to the nearest of the others; infinite where none is within `most`."""
    cells = collections.defaultdict(list)
    for point in others:
        cells[tuple(math.floor(c / most) for c in point)].append(point)
    worst = 0.0
    for point in points:
        x, y, z = (math.floor(c / most) for c in point)
        near = (other for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)
                for other in cells.get((x + i, y + j, z + k), ()))
        worst = max(worst, min((math.dist(point, other) for other in near), default=math.inf))
    return worst


def opens_alike(program, plain, packed, folder):
    before, after = (json.loads(output(program, "inspect", each, "--json")) for each in (plain, packed))
    assert [c["name"] for c in after["clips"]] == [c["name"] for c in before["clips"]], "other clips"
    assert after["joints"] == before["joints"], "%s joints, not %s" % (after["joints"], before["joints"])
    assert not [line for line in after["ignored"] if line not in before["ignored"]], after["ignored"]
    assert after["border_edges"] == before["border_edges"], "%d border edges, not %d" % (
        after["border_edges"], before["border_edges"])
    height, most = before["height"], MOST_PERCENT / 100.0 * before["height"]
    worst = 0.0
    for clip in [None, *before["clips"][:1]]:
        a, b = (points_of(program, each, clip, folder) for each in (plain, packed))
        worst = max(worst, farthest(a, b, most), farthest(b, a, most))
    print("    %6d triangles, %.4f %% of the height off" % (after["triangles"], 100.0 * worst / height))
    assert worst <= most


def exports_plain(program, packed, extension, tool, folder):
    """Valid, of the two codecs nothing left, WebP kept."""
    made = [folder / "refined.glb", folder / "original.glb"]
    for file in made:
        kind = ["--mesh", "original"] if file.stem == "original" else ["--depth", "1"]
        output(program, "export", packed, *kind, "-o", file)
        glb = Glb(file)
        named = set(glb.json.get("extensionsUsed", [])) | set(glb.json.get("extensionsRequired", []))
        assert not named & {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}, named
        assert (extension in named) == (extension == "EXT_texture_webp") or extension == "KHR_mesh_quantization", named
        assert b"DRACO" not in file.read_bytes()
        output(program, "inspect", file)
    for file, found in issues(made, str(tool)).items():
        errors = [issue for issue in found if issue[0] == 0]
        assert not errors, "%s: %s" % (file, errors[:3])


def damage(whole, seed):
    """A few other bytes: anywhere, or where the compressed ones are."""
    number = random.Random(seed)
    data = bytearray(whole)
    binary = 20 + int.from_bytes(whole[12:16], "little")
    for _ in range(number.randint(1, 6)):
        data[number.randrange(binary if seed % 2 else 12, len(data))] = number.randrange(256)
    return bytes(data[:number.randrange(len(data))] if seed % 16 == 0 else data)


def survives_damage(program, files, count, folder):
    ends = collections.Counter()
    for seed in range(count):
        (folder / "damaged.glb").write_bytes(damage(files[seed % len(files)].read_bytes(), seed))
        run = subprocess.run([program, "smooth", folder / "damaged.glb", "--depth", "1", "-o", folder / "damaged.obj"],
                             capture_output=True, text=True, timeout=60)
        ends[run.returncode] += 1
        if run.returncode == 0:
            text = (folder / "damaged.obj").read_text()
            assert not re.search(r"\b(nan|inf)", text), "seed %d: not finite" % seed
        else:
            assert run.returncode == 1, "seed %d: exit status %d" % (seed, run.returncode)
            assert len(run.stderr.splitlines()) == 1 and "damaged.glb" in run.stderr, "seed %d: %s" % (seed, run.stderr)
    print("%d damaged files: %d opened, %d refused" % (count, ends[0], ends[1]))


def main():
    program, root, characters = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        tool = modules(folder / "npm")
        if tool is None:
            print("left out: npm's gltf-transform is not at hand")
            return 77
        sources = [root / "assets" / "demo.glb"]
        sources += [characters / each for each in ("Fox.glb", "greenman.glb", IN_PARTS)]
        sources += [characters / each for each in ("cesium_man.gltf", "RobotExpressive.glb")] if MORE else []
        small = []
        for source in [each for each in sources if each.exists()]:
            for way, (command, extension) in WAYS.items():
                if way in ONLY_SMALL and source.stem != "demo":
                    continue
                packed = folder / ("%s-%s.glb" % (source.stem, way))
                output(tool / ".bin" / "gltf-transform", command[0], source, packed, *command[1:])
                if extension not in Glb(packed).json.get("extensionsUsed", []):
                    continue  # It has no textures.
                print("%s, %s" % (source.name, way), flush=True)
                opens_alike(program, source, packed, folder)
                if source.stem == "demo" or (source.stem == "greenman" and way in ("draco", "meshopt", "webp")):
                    exports_plain(program, packed, extension, tool, folder)
                if source.stem in ("demo", "greenman", "Fox") and way != "quantized":
                    small.append(packed)
        survives_damage(program, small, DAMAGED, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
