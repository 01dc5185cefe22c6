# blender/sinew_blender/line_data.py: the line data of a helpers export, read from its glTF. docs/export.md, Line data.
import json
import struct

VERSION = 1
JSON_CHUNK = 0x4E4F534A


def read(path):
    """[(line data, line)] of a .glb or .gltf. Raises ValueError with a sentence."""
    root = _json_of(path)
    datas = [skin["extras"]["sinew"] for skin in root.get("skins", []) if "sinew" in (skin.get("extras") or {})]
    lines = [(data, line) for data in datas if data.get("version") == VERSION for line in data.get("lines", [])]
    if datas and not lines:
        raise ValueError("%s: its muscle joints are of another version of Sinew" % path)
    if not lines:
        raise ValueError("%s: has no joints of muscle lines; sinew export --as helpers writes them" % path)
    return lines


def _json_of(path):
    with open(path, "rb") as file:
        data = file.read()
    try:
        if data[:4] != b"glTF":
            return json.loads(data.decode("utf-8"))
        size, kind = struct.unpack_from("<II", data, 12)
        if kind != JSON_CHUNK:
            raise ValueError("no JSON")
        return json.loads(data[20:20 + size].decode("utf-8"))
    except (ValueError, struct.error) as error:
        raise ValueError("%s: is no glTF: %s" % (path, error)) from None
