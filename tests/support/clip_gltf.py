# tests/support/clip_gltf.py: a character's file taken apart: without its clips, or clips without its mesh.
import json
import struct

from glb_reader import Glb


def write_glb(document, data, path):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
    path.write_bytes(head + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)
    return path


def write_still(source, path):
    """The character without a clip."""
    glb = Glb(source)
    del glb.json["animations"]
    return write_glb(glb.json, glb.data, path)


def write_clips(source, path, clips):
    """Some of its clips, without the mesh: `clips` says by its own names what they are called. The skin stays: it says how
    the bones are bound."""
    glb = Glb(source)
    document = glb.json
    document["animations"] = [dict(clip, name=clips[clip["name"]]) for clip in document["animations"] if clip["name"] in clips]
    for node in document["nodes"]:
        node.pop("mesh", None), node.pop("skin", None)
    for key in ("meshes", "materials", "images", "samplers", "textures"):
        document.pop(key, None)
    return write_glb(document, glb.data, path)
