# tests/support/dressed_gltf.py: the bundled humanoid with clothes, hair and eyes, for tests of parts in the window.
"""The body as it is, and on it meshes of its own triangles, moved out along their normals; two balls inside of the head."""
import json
import math
import struct

from glb_reader import Glb

# What each part is called (as files do, in any script), the joints that it lies over, how far off, and its color.
GARMENTS = {
    "shirt": (("spine", "chest", "clavicle", "upper_arm"), 0.016, (0.2, 0.35, 0.6, 1.0)),
    "trousers": (("hips", "thigh", "shin"), 0.012, (0.25, 0.22, 0.2, 1.0)),
    "hair": (("head",), 0.014, (0.2, 0.1, 0.05, 1.0)),
}
NAMES = {"shirt": "Shirt", "trousers": "Trousers", "hair": "Hair", "eyes": "Eyes"}
EYES_COLOR = (0.9, 0.9, 0.95, 1.0)


def _ball(center, radius, joint, rings=8):
    """Rows of position, normal, joints and weights, and triangles."""
    columns, rows, triangles = 2 * rings, [], []
    for ring in range(rings + 1):
        for column in range(columns):
            polar, turn = math.pi * ring / rings, 2 * math.pi * column / columns
            n = (math.sin(polar) * math.sin(turn), math.cos(polar), math.sin(polar) * math.cos(turn))
            rows.append((tuple(c + radius * v for c, v in zip(center, n)), n, (joint, 0, 0, 0), (1.0, 0.0, 0.0, 0.0)))
    for ring in range(rings):
        for column in range(columns):
            a, b = ring * columns + column, ring * columns + (column + 1) % columns
            triangles += ([(a, a + columns, b)] if ring else []) + ([(b, a + columns, b + columns)] if ring < rings - 1 else [])
            if ring == 0:
                triangles[-1] = (a, a + columns, b + columns)
    return rows, triangles


def write_dressed(body, path, names=NAMES):
    """@param body  assets/humanoid.glb"""
    glb = Glb(body)
    gltf, data = glb.json, bytearray(glb.data[:glb.json["buffers"][0]["byteLength"]])
    primitive = gltf["meshes"][0]["primitives"][0]
    columns = [glb.rows(primitive["attributes"][each]) for each in ("POSITION", "NORMAL", "JOINTS_0", "WEIGHTS_0")]
    rows = list(zip(*columns))
    index = [i for (i,) in glb.rows(primitive["indices"])]
    joints = [gltf["nodes"][node]["name"].split(".")[0] for node in gltf["skins"][0]["joints"]]
    main = [joints[row[2][max(range(4), key=lambda k: row[3][k])]] for row in rows]

    def add(flat, kind, letter):
        data.extend(bytes(-len(data) % 4))
        packed = struct.pack("<%d%s" % (len(flat), letter), *flat)
        gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
        data.extend(packed)
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[kind]
        gltf["accessors"].append({"bufferView": len(gltf["bufferViews"]) - 1, "type": kind, "count": len(flat) // width,
                                  "componentType": {"f": 5126, "H": 5123, "B": 5121}[letter]})
        return len(gltf["accessors"]) - 1

    def add_mesh(name, vertices, triangles, color):
        flat = [[value for vertex in vertices for value in vertex[k]] for k in range(4)]
        position = add(flat[0], "VEC3", "f")
        kept = [struct.unpack("<3f", struct.pack("<3f", *vertex[0])) for vertex in vertices]
        gltf["accessors"][position].update(min=list(map(min, zip(*kept))), max=list(map(max, zip(*kept))))
        attributes = {"POSITION": position, "NORMAL": add(flat[1], "VEC3", "f"), "JOINTS_0": add(flat[2], "VEC4", "B"),
                      "WEIGHTS_0": add(flat[3], "VEC4", "f")}
        indices = add([i for triangle in triangles for i in triangle], "SCALAR", "H")
        gltf["materials"].append({"name": name, "pbrMetallicRoughness": {"baseColorFactor": list(color), "metallicFactor": 0.0}})
        gltf["meshes"].append({"name": name, "primitives": [
            {"attributes": attributes, "indices": indices, "material": len(gltf["materials"]) - 1}]})
        gltf["scenes"][0]["nodes"].append(len(gltf["nodes"]))
        gltf["nodes"].append({"name": name, "mesh": len(gltf["meshes"]) - 1, "skin": 0})

    head = [row[0] for row, bone in zip(rows, main) if bone == "head"]
    low, high = [list(map(pick, zip(*head))) for pick in (min, max)]
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    for garment, (bones, off, color) in GARMENTS.items():
        def covered(vertex):
            return main[vertex] in bones and (garment != "hair" or rows[vertex][0][1] > middle[1])
        triangles = [index[k:k + 3] for k in range(0, len(index), 3) if all(map(covered, index[k:k + 3]))]
        number = {old: new for new, old in enumerate(sorted({v for triangle in triangles for v in triangle}))}
        moved = [(tuple(p + off * n for p, n in zip(rows[v][0], rows[v][1])), *rows[v][1:]) for v in number]
        add_mesh(names[garment], moved, [[number[v] for v in triangle] for triangle in triangles], color)
    size, eyes, faces = [b - a for a, b in zip(low, high)], [], []
    for side in (-1, 1):
        place = (middle[0] + side * 0.22 * size[0], middle[1], middle[2] + 0.2 * size[2])
        ball, triangles = _ball(place, 0.09 * size[0], joints.index("head"))
        faces += [[len(eyes) + v for v in triangle] for triangle in triangles]
        eyes += ball
    add_mesh(names["eyes"], eyes, faces, EYES_COLOR)
    gltf["buffers"][0]["byteLength"] = len(data)
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    data.extend(bytes(-len(data) % 4))
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A) + text +
                     struct.pack("<II", len(data), 0x004E4942) + bytes(data))
    return path
