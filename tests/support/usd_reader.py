# tests/support/usd_reader.py: reads a .usda apart from the program, and skins what it holds, for the tests in Python.
"""One statement a line, as Sinew writes them; lists, tuples and strings of USD are those of Python."""
import ast
import re

PRIM = re.compile(r'def (\w+) "([A-Za-z_]\w*)"( \()?$', re.ASCII)
ATTRIBUTE = re.compile(r"((?:uniform )?[\w\[\]]+) ([\w:.]+)(?: = (.*?))?( \()?$", re.ASCII)


class Prim:
    def __init__(self, kind, name, path):
        self.kind, self.name, self.path = kind, name, path
        self.values, self.types, self.metadata, self.children = {}, {}, {}, []

    def all(self, kind=None):
        below = [each for child in self.children for each in child.all(kind)]
        return ([self] if kind in (None, self.kind) else []) + below

    def codes(self):
        """Where anything is sampled."""
        return sorted({code for name, samples in self.values.items() if name.endswith(".timeSamples") for code in samples})

    def codes_below(self):
        return sorted({code for prim in self.all() for code in prim.codes()})

    def at(self, name, code):
        samples = self.values.get(name + ".timeSamples")
        return self.values[name] if samples is None else samples[code]


def value_of(text):
    if text[0] in "<@":
        return text[1:-1]
    if text.startswith("[<"):
        return [each[1:-1] for each in text[1:-1].split(", ")]
    return ast.literal_eval(text.replace("( (", "((").replace(") )", "))"))


def metadata_of(lines):
    """The lines up to the closing parenthesis."""
    found = {}
    for line in lines:
        if line == ")":
            return found
        name, text = line.split(" = ", 1)
        found[name] = value_of(text)
    raise AssertionError("parentheses are not closed")


def read(path):
    """(metadata of the layer, its one root prim)"""
    lines = map(str.strip, path.read_text(encoding="utf-8").split("\n"))
    assert next(lines) == "#usda 1.0" and next(lines) == "("
    layer, root, open_prims = metadata_of(lines), None, []
    for line in lines:
        prim, attribute = PRIM.match(line), ATTRIBUTE.match(line)
        if prim:
            above = open_prims[-1] if open_prims else None
            made = Prim(prim[1], prim[2], (above.path if above else "") + "/" + prim[2])
            assert above or root is None
            if above:
                assert made.name not in [child.name for child in above.children], made.path
                above.children.append(made)
            root = root or made
            made.metadata = metadata_of(lines) if prim[3] else {}
            assert next(lines) == "{"
            open_prims.append(made)
        elif line == "}":
            open_prims.pop()
        elif line:
            assert attribute, line[:90]
            own, name = open_prims[-1], attribute[2]
            assert name not in own.values, name
            own.types[name] = attribute[1]
            if attribute[3] == "{":
                own.values[name] = samples = {}
                for sample in iter(lambda: next(lines), "}"):
                    code, text = sample.rstrip(",").split(": ", 1)
                    samples[float(code)] = value_of(text)
                assert list(samples) == sorted(samples)
            elif attribute[3]:
                own.values[name] = value_of(attribute[3])
            if attribute[4]:
                own.metadata[name] = metadata_of(lines)
    assert not open_prims
    return layer, root


def times(a, b):
    """Matrices of rows: what a does first."""
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def inverse(m):
    """Of a matrix whose last column is (0, 0, 0, 1)."""
    a, b, c = m[0][:3], m[1][:3], m[2][:3]

    def cross(u, v):
        return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    columns = [cross(b, c), cross(c, a), cross(a, b)]
    volume = sum(x * y for x, y in zip(a, columns[0]))
    rows = [[columns[j][i] / volume for j in range(3)] for i in range(3)]
    shift = [-sum(m[3][k] * rows[k][j] for k in range(3)) for j in range(3)]
    return [rows[0] + [0.0], rows[1] + [0.0], rows[2] + [0.0], shift + [1.0]]


def local(translation, rotation, scale):
    w, x, y, z = rotation
    size = (w * w + x * x + y * y + z * z) ** 0.5
    w, x, y, z = w / size, x / size, y / size, z / size
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
            [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
            [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]]
    return [[s * e for e in row] + [0.0] for s, row in zip(scale, rows)] + [list(translation) + [1.0]]


def pointed(root, code):
    """Corners of all triangles of meshes whose points are sampled, mesh by mesh."""
    corners = []
    for mesh in root.all("Mesh"):
        points, index = mesh.at("points", code), mesh.values["faceVertexIndices"]
        assert mesh.values["faceVertexCounts"] == [3] * (len(index) // 3)
        assert len(mesh.at("normals", code)) == len(points)
        low, high = mesh.at("extent", code)
        assert low == tuple(map(min, zip(*points))) and high == tuple(map(max, zip(*points)))
        corners += [points[i] for i in index]
    return corners


def blended(mesh, animation, code):
    """Points of a mesh with its blend shapes, before joints move them."""
    names, paths = mesh.values.get("skel:blendShapes", []), mesh.values.get("skel:blendShapeTargets", [])
    prims = {child.path: child for child in mesh.children}
    assert len(names) == len(paths) and all(prims[path].kind == "BlendShape" for path in paths)
    points = [list(point) for point in mesh.values["points"]]
    if not names or animation is None:
        return points
    weights = dict(zip(animation.values["blendShapes"], animation.at("blendShapeWeights", code)))
    for name, path in zip(names, paths):
        shape = prims[path].values
        assert len(shape["pointIndices"]) == len(shape["offsets"]) == len(shape.get("normalOffsets", shape["offsets"]))
        for index, offset in zip(shape["pointIndices"], shape["offsets"]):
            points[index] = [a + weights[name] * b for a, b in zip(points[index], offset)]
    return points


def skinned(root, animation=None, code=0.0):
    """Corners of all triangles, mesh by mesh, in the world; at rest without an animation."""
    (skeleton,) = root.all("Skeleton")
    joints = skeleton.values["joints"]
    if animation:
        assert animation.values["joints"] == joints
        locals_ = [local(*each) for each in zip(*(animation.at(name, code) for name in
                                                  ("translations", "rotations", "scales")))]
    else:
        locals_ = skeleton.values["restTransforms"]
    assert len(locals_) == len(joints) == len(set(joints))
    world = {}
    for path, matrix in zip(joints, locals_):
        above = path.rpartition("/")[0]
        world[path] = times(matrix, world[above]) if above else matrix
    to_world = [times(inverse(bind), world[path]) for path, bind in zip(joints, skeleton.values["bindTransforms"])]
    corners = []
    for mesh in root.all("Mesh"):
        assert mesh.values["skel:skeleton"] == skeleton.path
        bind = mesh.values["primvars:skel:geomBindTransform"]
        matrices = [times(bind, matrix) for matrix in to_world]
        numbers, weights = (mesh.values["primvars:skel:joint" + name] for name in ("Indices", "Weights"))
        wide = mesh.metadata["primvars:skel:jointIndices"]["elementSize"]
        assert len(numbers) == len(weights) == wide * len(mesh.values["points"])
        points = []
        for v, (x, y, z) in enumerate(blended(mesh, animation, code)):
            place = [0.0, 0.0, 0.0]
            for i in range(wide * v, wide * v + wide):
                if weights[i]:
                    m, w = matrices[numbers[i]], weights[i]
                    for k in range(3):
                        place[k] += w * (x * m[0][k] + y * m[1][k] + z * m[2][k] + m[3][k])
            assert abs(sum(weights[wide * v:wide * v + wide]) - 1.0) < 1e-5
            points.append(tuple(place))
        index = mesh.values["faceVertexIndices"]
        assert mesh.values["faceVertexCounts"] == [3] * (len(index) // 3)
        corners += [points[i] for i in index]
    return corners


