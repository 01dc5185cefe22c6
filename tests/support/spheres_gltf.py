# tests/support/spheres_gltf.py: a sphere of one material, for tests of materials.
"""write_sphere(path, material, images, columns): a sphere about (0, 1, 0) of radius 1 on one joint-less node. Texture
coordinates go around it once and from pole to pole."""
import json
import math
import struct
import zlib


def png(width, height, pixel):
    """A PNG of pixel(x, y) -> (r, g, b, a), 0..255."""
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def write_sphere(path, material, images=(), columns=96):
    rings = columns // 2
    positions, normals, uvs, indices = [], [], [], []
    for ring in range(rings + 1):
        for column in range(columns + 1):
            polar, turn = math.pi * ring / rings, 2 * math.pi * (column % columns) / columns
            flat = 0.0 if ring in (0, rings) else math.sin(polar)
            normal = (flat * math.sin(turn), math.cos(polar), flat * math.cos(turn))
            normals.append(normal)
            positions.append((normal[0], 1 + normal[1], normal[2]))
            uvs.append((column / columns, ring / rings))
    for ring in range(rings):
        for column in range(columns):
            a = ring * (columns + 1) + column
            b = a + columns + 1
            indices += ([a, b, b + 1] if ring < rings - 1 else []) + ([a, b + 1, a + 1] if ring else [])
            if ring == rings - 1:
                indices[-3:] = [a, b, a + 1]
    data, views = b"", []
    for piece in (struct.pack("<%df" % (3 * len(positions)), *(v for p in positions for v in p)),
                  struct.pack("<%df" % (3 * len(normals)), *(v for n in normals for v in n)),
                  struct.pack("<%df" % (2 * len(uvs)), *(v for t in uvs for v in t)),
                  struct.pack("<%dI" % len(indices), *indices), *images):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(piece)})
        data += piece + bytes(-len(piece) % 4)
    low, high = [list(map(pick, zip(*(struct.unpack("<3f", struct.pack("<3f", *p)) for p in positions))))
                 for pick in (min, max)]
    gltf = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "sphere"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3,
                                    "material": 0}]}],
        "materials": [material],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3", "min": low, "max": high},
            {"bufferView": 1, "componentType": 5126, "count": len(normals), "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": len(uvs), "type": "VEC2"},
            {"bufferView": 3, "componentType": 5125, "count": len(indices), "type": "SCALAR"}],
        "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    if images:
        gltf["images"] = [{"bufferView": 4 + i, "mimeType": "image/png"} for i in range(len(images))]
        gltf["textures"] = [{"source": i} for i in range(len(images))]
    if used := sorted(material.get("extensions", {})):
        gltf["extensionsUsed"] = used
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) +
                     struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)
    return path
