# examples/python/error_heat_map.py: how far the plain skin is from the one with muscles, over a clip.
"""error_heat_map.py RIG CLIP OUT.ply: each vertex has the largest distance, in percent of the height, as its color and as a
number of its own. With matplotlib, OUT.png beside it shows them."""
import sys

import numpy
import sinew

COLORS = numpy.array([[40, 60, 160], [60, 160, 200], [240, 220, 90], [200, 40, 30]], float)  # Near to far.


def distances(rig, clip, fps=15):
    """Percent of the height [frames, vertices], and a surface to show them on. The same triangles in both."""
    with_muscles = rig.copy()
    with_muscles.detail, with_muscles.depth = "uniform", 4
    without = sinew.Rig(rig.character)
    without.detail, without.depth = "uniform", 4
    live, plain = sinew.Smoother(rig.character, with_muscles), sinew.Smoother(rig.character, without)
    rows = [numpy.linalg.norm(a.positions - b.positions, axis=1)
            for a, b in zip(live.frames(clip, fps), plain.frames(clip, fps))]
    return 100 * numpy.array(rows) / rig.character.height, live()


def colors_of(values):
    """Linear between the four colors; the largest value is the last."""
    place = (len(COLORS) - 1) * values / max(values.max(), 1e-9)
    low = numpy.minimum(place.astype(int), len(COLORS) - 2)
    share = (place - low)[:, None]
    return ((1 - share) * COLORS[low] + share * COLORS[low + 1]).astype(numpy.uint8)


def write_ply(path, surface, values):
    vertices = numpy.zeros(len(values), [("place", "<f4", 3), ("color", "u1", 3), ("error", "<f4")])
    vertices["place"], vertices["color"], vertices["error"] = surface.positions, colors_of(values), values
    faces = numpy.zeros(len(surface.triangles), [("n", "u1"), ("corners", "<i4", 3)])
    faces["n"], faces["corners"] = 3, surface.triangles
    names = ["float x", "float y", "float z", "uchar red", "uchar green", "uchar blue", "float error"]
    head = ["ply", "format binary_little_endian 1.0", "element vertex %d" % len(vertices)]
    head += ["property " + name for name in names]
    head += ["element face %d" % len(faces), "property list uchar int vertex_indices", "end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(head).encode() + vertices.tobytes() + faces.tobytes())


def draw(path, surface, errors):
    """The character from the front and from the back, and how the largest distance goes from frame to frame."""
    try:
        import matplotlib
    except ImportError:
        print("no picture: matplotlib is not installed")
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 5), layout="constrained")
    x, y, z = surface.positions.T
    for view, side, title in ((axes[0], 1, "front"), (axes[1], -1, "back")):
        order = numpy.argsort(side * z[surface.triangles].mean(axis=1))  # The nearest is drawn last.
        shown = view.tripcolor(side * x, y, surface.triangles[order], cmap="turbo",
                               facecolors=errors.max(axis=0)[surface.triangles[order]].mean(axis=1))
        view.set(title=title, aspect="equal")
        view.set_axis_off()
    figure.colorbar(shown, ax=axes[:2], label="largest distance, percent of the height")
    axes[2].plot(errors.max(axis=1))
    axes[2].set(xlabel="frame", ylabel="percent of the height", ylim=(0, None))
    figure.savefig(path)


def main(rig_file, clip, out):
    errors, surface = distances(sinew.load_rig(rig_file), clip)
    write_ply(out, surface, errors.max(axis=0))
    print("%s: at most %.2f %% of the height, in frame %d" % (out, errors.max(), errors.max(axis=1).argmax()))
    draw(out.rsplit(".", 1)[0] + ".png", surface, errors)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:4])
    except sinew.Error as error:
        sys.exit("error_heat_map: %s" % error)
