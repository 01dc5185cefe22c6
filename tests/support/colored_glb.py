# tests/support/colored_glb.py: a character with vertex colors that say where on its texture they are.
import json
import struct

from glb_reader import Glb


def write_colored(source, out):
    """COLOR_0 is (u, v, 0.25, 1): whoever refines both refines them alike."""
    glb = Glb(source)
    root, data = glb.json, glb.data
    for mesh in root["meshes"]:
        for primitive in mesh["primitives"]:
            rows = glb.rows(primitive["attributes"]["TEXCOORD_0"])
            colors = b"".join(struct.pack("<4f", u, v, 0.25, 1.0) for u, v in rows)
            data += bytes(-len(data) % 4)
            root["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(colors)})
            view = len(root["bufferViews"]) - 1
            root["accessors"].append({"bufferView": view, "componentType": 5126, "count": len(rows), "type": "VEC4"})
            primitive["attributes"]["COLOR_0"] = len(root["accessors"]) - 1
            data += colors
    root["buffers"][0]["byteLength"] = len(data)
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A)
    out.write_bytes(head + text + struct.pack("<II", len(data), 0x004E4942) + data)
    return out
