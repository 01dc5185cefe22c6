# examples/python/turntable.py: all clips of a character, seen while going around it: one row of pictures each.
"""turntable.py RIG OUT.png [COLUMNS]: needs NumPy alone."""
import struct
import sys
import zlib

import numpy
import sinew

SIZE = 180  # Pixels of one picture.
LIGHT = numpy.array([0.4, 0.7, 0.6])


def samples(surface, across):
    """Points inside the triangles with their normals, so close that they cover the picture."""
    corners, normals = surface.positions[surface.triangles], surface.normals[surface.triangles]
    longest = numpy.linalg.norm(corners - numpy.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = numpy.clip(numpy.ceil(longest * SIZE / across * 1.5), 1, 24).astype(int)
    points, shades = [], []
    for n in numpy.unique(parts):
        chosen = parts == n
        for a in range(n):
            for b in range(n - a):
                share = (numpy.array([a, b, n - 1 - a - b]) + 1 / 3) / n
                points.append(numpy.einsum("tcx,c->tx", corners[chosen], share))
                shades.append(numpy.einsum("tcx,c->tx", normals[chosen], share))
    return numpy.concatenate(points), numpy.concatenate(shades)


def picture(surface, angle, across):
    """Shaded clay, seen from the side at that angle. across: the width of the picture in the world."""
    points, normals = samples(surface, across)
    c, s = numpy.cos(angle), numpy.sin(angle)
    turn = numpy.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    middle = (surface.positions.min(axis=0) + surface.positions.max(axis=0)) / 2
    points, normals = (points - middle) @ turn, normals @ turn
    x = (SIZE * (0.5 + points[:, 0] / across)).astype(int)
    y = (SIZE * (0.5 - points[:, 1] / across)).astype(int)
    inside = (x >= 0) & (x < SIZE) & (y >= 0) & (y < SIZE)
    order = numpy.flatnonzero(inside)[numpy.argsort(points[inside, 2], kind="stable")]  # The nearest is painted last.
    shade = 60 + 180 * numpy.clip(normals @ (LIGHT / numpy.linalg.norm(LIGHT)), 0, 1)
    pixels = numpy.full((SIZE, SIZE), 28, numpy.uint8)
    pixels[y[order], x[order]] = shade[order].astype(numpy.uint8)
    return pixels


def png(pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def main(rig_file, out, columns=8):
    rig = sinew.load_rig(rig_file)
    smoother = sinew.Smoother(rig.character, rig)
    if not rig.character.clips:
        raise sinew.Error("the character has no clips", file=rig.character.path)
    width, height, depth = numpy.ptp(smoother().positions, axis=0)
    across = 1.3 * max(height, numpy.hypot(width, depth))
    rows = []
    for clip, seconds in rig.character.clips.items():
        shares = [column / columns for column in range(columns)]
        surfaces = (smoother(clip=clip, time=share * seconds) for share in shares)
        rows.append(numpy.hstack([picture(surface, 2 * numpy.pi * share, across)
                                  for share, surface in zip(shares, surfaces)]))
        print("%s: %d pictures" % (clip, columns))
    with open(out, "wb") as file:
        file.write(png(numpy.vstack(rows)))


if __name__ == "__main__":
    try:
        main(sys.argv[1], sys.argv[2], *map(int, sys.argv[3:4]))
    except sinew.Error as error:
        sys.exit("turntable: %s" % error)
