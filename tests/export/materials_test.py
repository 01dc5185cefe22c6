# tests/export/materials_test.py: materials beside three.js. Usage: materials_test.py PROGRAM ROOT CHARACTERS
"""Spheres of one material each, and six of other people's characters, under the light `white` and from the same eye:
`sinew render` and three.js in Chromium, which draws the surface that `sinew smooth` wrote with the materials of the source
file. The mean difference over the pixels that both have covered is small. three.js also lights metals with what goes from
facet to facet, which the specification's model leaves out: it is compared without that, and as it is where that counts
for little. Left out (77) where Chromium, node, npm's three
or ImageMagick is not at hand."""
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
sys.path.insert(0, str(HERE))
from glb_reader import Glb
from runtime_test import opened
from spheres_gltf import png, write_sphere
from three_test import modules

MOST = 3.0  # Of 255, mean over the pixels of the object and the channels.
SIZE = (480, 480)
FIELD, MARGIN = 0.55, 0.08  # As app/viewport/render/view.h has them.
ROUGH_METALS = ("iron", "striped")
CHARACTERS = {"Fox.glb": 2, "greenman.glb": 2, "cesium_man.gltf": 1, "robot.glb": 1, "fighter.glb": 1, "woman.glb": 1}


def bump(x, y):
    """Round studs, as a normal map of 256 x 256."""
    u, v = (x % 32 - 15.5) / 12, (y % 32 - 15.5) / 12
    slope = math.hypot(u, v)
    if slope >= 1:
        return (128, 128, 255, 255)
    n = (0.6 * u, -0.6 * v, math.sqrt(1 - 0.36 * slope * slope))
    return tuple(round(127.5 * (c + 1)) for c in n) + (255,)


def metal(**values):
    return {"pbrMetallicRoughness": values}


def spheres():
    checker = png(64, 64, lambda x, y: (255, 255, 255, 255 if (x // 8 + y // 8) % 2 else 0))
    stripes = png(64, 64, lambda x, y: (0, 60 + 3 * x, 255 if y // 8 % 2 else 0, 255))
    lava = png(64, 64, lambda x, y: (4 * x, 2 * y, 20, 255))
    paint = png(64, 64, lambda x, y: (40 + 3 * x, 220 - 3 * y, 90, 255))
    texture = {"index": 0}
    return {
        "dull": (metal(baseColorFactor=[0.6, 0.1, 0.08, 1], metallicFactor=0, roughnessFactor=0.9), ()),
        "polished": (metal(baseColorFactor=[0.05, 0.2, 0.6, 1], metallicFactor=0, roughnessFactor=0.2), ()),
        "gold": (metal(baseColorFactor=[1, 0.71, 0.29, 1], metallicFactor=1, roughnessFactor=0.3), ()),
        "iron": (metal(baseColorFactor=[0.56, 0.57, 0.58, 1], metallicFactor=1, roughnessFactor=0.7), ()),
        "painted": (metal(baseColorTexture=texture, metallicFactor=0, roughnessFactor=0.5), (paint,)),
        "striped": (metal(baseColorFactor=[0.8, 0.5, 0.3, 1], metallicRoughnessTexture=texture), (stripes,)),
        "studded": (metal(baseColorFactor=[0.5, 0.5, 0.5, 1], metallicFactor=0, roughnessFactor=0.4) |
                    {"normalTexture": {"index": 0}}, (png(256, 256, bump),)),
        "half-studded": (metal(baseColorFactor=[0.5, 0.5, 0.5, 1], metallicFactor=0, roughnessFactor=0.4) |
                         {"normalTexture": {"index": 0, "scale": 0.5}}, (png(256, 256, bump),)),
        "glowing": (metal(baseColorFactor=[0.1, 0.1, 0.1, 1], metallicFactor=0) |
                    {"emissiveFactor": [0.4, 0.2, 0.1], "emissiveTexture": texture,
                     "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2}}}, (lava,)),
        "cut": (metal(baseColorTexture=texture, metallicFactor=0) | {"alphaMode": "MASK", "doubleSided": True}, (checker,)),
        "unlit": (metal(baseColorTexture=texture) | {"extensions": {"KHR_materials_unlit": {}}}, (paint,)),
    }


PAGE = """<!doctype html><title>materials</title>
<script type="importmap">{"imports": {"three": "./node_modules/three/build/three.module.js",
 "three/addons/": "./node_modules/three/examples/jsm/"}}</script>
<script type="module">
const send = (name, body) => fetch(name, { method: 'POST', body });
try {
  const THREE = await import('three');
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
  const asked = await (await fetch('asked.json')).json();
  const { ShaderChunk } = THREE;
  const draw = async as => {
    if (as === 'single') {
      const factor = ' * material.multiScatteringCompensation';
      if (!ShaderChunk.lights_physical_pars_fragment.includes(factor)) throw new Error('three.js is another one');
      ShaderChunk.lights_physical_pars_fragment = ShaderChunk.lights_physical_pars_fragment.replace(factor, '');
    }
    const renderer = new THREE.WebGLRenderer({ alpha: true, antialias: false, preserveDrawingBuffer: true });
    renderer.setPixelRatio(1);
    renderer.setClearColor(0x000000, 0);
    for (const { name, source, size, eye, axes, middle, near, far, field } of asked) {
      renderer.setSize(size[0], size[1]);
      const shown = await new GLTFLoader().loadAsync(name + '.surface.glb');
      const from = await new GLTFLoader().loadAsync(source);
      const materials = await Promise.all((from.parser.json.materials || []).map((_, i) =>
        from.parser.getDependency('material', i)));
      const named = new Map(materials.map((m, i) => [m.name || 'material ' + i, m]));
      shown.scene.traverse(mesh => {
        if (!mesh.isMesh) return;
        const material = named.get(mesh.material.name).clone();
        material.vertexColors = mesh.geometry.attributes.color !== undefined;
        if (material.normalMap) {  // Against v, as glTF has it; three's own tangents are along it.
          mesh.geometry.computeTangents();
          material.normalScale.y *= -1;
        }
        mesh.material = material;
      });
      const scene = new THREE.Scene();
      scene.add(shown.scene);
      const light = new THREE.DirectionalLight(0xffffff, Math.PI);
      light.position.set(-0.5, 0.6, 0.8);
      scene.add(light);
      const camera = new THREE.PerspectiveCamera(field * 180 / Math.PI, size[0] / size[1], near, far);
      const basis = new THREE.Matrix4().makeBasis(...axes.map(a => new THREE.Vector3(...a)));
      camera.quaternion.setFromRotationMatrix(basis);
      camera.position.set(...eye);
      renderer.render(scene, camera);
      await send(name + '.' + as, await new Promise(done => renderer.domElement.toBlob(done)));
    }
  };
  await draw('whole');
  await draw('single');
} catch (error) { await send('error', String(error.stack)); }
await send('end', '');
</script>"""


def output(program, *words):
    run = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return run.stdout


def extremes(points):
    """As extremePoints in app/viewport/render/view.cpp."""
    for i in range(96):
        y = 1 - (2 * i + 1) / 96
        ring, angle = math.sqrt(1 - y * y), 2.3999632 * i
        d = (ring * math.cos(angle), y, ring * math.sin(angle))
        yield max(points, key=lambda p: p[0] * d[0] + p[1] * d[1] + p[2] * d[2])


def eye_for(points, yaw, pitch):
    """As framedView there, in perspective."""
    back = (math.sin(yaw) * math.cos(pitch), math.sin(pitch), math.cos(yaw) * math.cos(pitch))
    right = (math.cos(yaw), 0.0, -math.sin(yaw))
    up = tuple(back[(i + 1) % 3] * right[(i + 2) % 3] - back[(i + 2) % 3] * right[(i + 1) % 3] for i in range(3))
    axes = (right, up, back)
    seen = [[sum(a * b for a, b in zip(p, axis)) for axis in axes] for p in extremes(points)]
    tangent = math.tan(FIELD / 2) * (1 - 2 * MARGIN)
    tangents = (tangent * SIZE[0] / SIZE[1], tangent)
    cone = [max(p[i] + tangents[i] * p[2] for p in seen) for i in (0, 1)]
    low = [max(-p[i] + tangents[i] * p[2] for p in seen) for i in (0, 1)]
    local = [(cone[i] - low[i]) / 2 for i in (0, 1)] + [max((cone[i] + low[i]) / (2 * tangents[i]) for i in (0, 1))]
    eye = [sum(axes[k][i] * local[k] for k in range(3)) for i in range(3)]
    nearest, furthest = max(p[2] for p in seen), min(p[2] for p in seen)
    span = nearest - furthest
    return {"eye": eye, "axes": axes, "near": (local[2] - nearest) / 2, "far": local[2] - furthest + 60 * span,
            "field": FIELD, "size": SIZE}


def rgba(picture):
    run = subprocess.run(["convert", "png:-", "-depth", "8", "rgba:-"], input=picture, check=True, capture_output=True)
    return run.stdout


def compare(ours, theirs):
    """Mean difference where both are solid, of 255; the share of that in all that either covers."""
    a, b = rgba(ours), rgba(theirs)
    both = [i for i in range(0, len(a), 4) if a[i + 3] == 255 and b[i + 3] == 255]
    either = sum(1 for i in range(0, len(a), 4) if a[i + 3] or b[i + 3])
    off = sum(abs(a[i + c] - b[i + c]) for i in both for c in range(3)) / (3 * max(len(both), 1))
    return off, len(both) / max(either, 1)


def ask(program, name, source, depth, folder):
    """Our picture, the surface for three, and the eye."""
    shutil.copy(source, folder / source.name) if source.parent != folder else None
    view = ("--view", "30,12") if name not in spheres() else ("--view", "front")
    yaw, pitch = (math.radians(30), math.radians(12)) if name not in spheres() else (0.0, 0.0)
    output(program, "render", source, "--light", "white", "--transparent", "--no-ground", "--samples", 1, *view,
           "--depth", depth, "--size", "%dx%d" % SIZE, "-o", folder / (name + ".png"))
    output(program, "smooth", source, "--depth", depth, "-o", folder / (name + ".surface.glb"))
    output(program, "smooth", source, "--depth", 1, "--patch", "flat", "-o", folder / "flat.glb")
    flat = Glb(folder / "flat.glb")
    points = flat.rows(flat.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"])
    return {"name": name, "source": source.name, **eye_for(points, yaw, pitch)}


def main():
    program, _, characters = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    for tool in ("chromium", "node", "npm", "convert"):
        if not shutil.which(tool):
            print("left out: %s is not installed" % tool)
            return 77
    with tempfile.TemporaryDirectory() as folder_name:
        folder = pathlib.Path(folder_name)
        if modules(folder) is None:
            print("left out: npm's three is not at hand")
            return 77
        asked = []
        for name, (material, images) in spheres().items():
            sphere = write_sphere(folder / (name + ".glb"), {"name": name, **material}, images)
            asked.append(ask(program, name, sphere, 1, folder))
        for file, depth in CHARACTERS.items():
            if (characters / file).exists():
                asked.append(ask(program, pathlib.Path(file).stem, characters / file, depth, folder))
            else:
                print("left out: no " + file)
        (folder / "asked.json").write_text(json.dumps(asked))
        (folder / "materials.html").write_text(PAGE)
        sent = opened(folder, "materials.html")
        if "error" in sent or "end" not in sent:
            print(sent.get("error", b"the page did not come to its end").decode())
            return 1
        good = True
        for each in asked:
            ours = (folder / (each["name"] + ".png")).read_bytes()
            single, shared = compare(ours, sent[each["name"] + ".single"])
            whole, _ = compare(ours, sent[each["name"] + ".whole"])
            good &= single < MOST and shared > 0.97 and (whole < MOST or each["name"] in ROUGH_METALS)
            print("  %-14s %.2f of 255 off, %.2f of three.js as it is; %.1f %% of the pixels in both" %
                  (each["name"], single, whole, 100 * shared))
            if kept := os.environ.get("SINEW_KEEP_PICTURES"):
                for kind, picture in (("sinew", ours), ("three", sent[each["name"] + ".whole"])):
                    (pathlib.Path(kept) / ("%s.%s.png" % (each["name"], kind))).write_bytes(picture)
        return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
