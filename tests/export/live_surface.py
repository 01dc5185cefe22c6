# tests/export/live_surface.py: what other programs show of an export, held against `sinew smooth`.
import json
import math
import subprocess

MOMENTS = 5


def output(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def longest_times(glb, animation, nodes):
    """Key times of the clip's busiest sampler. Of the first `nodes` nodes alone: those that the export added have keys
    enough."""
    used = {channel["sampler"] for channel in animation["channels"] if channel["target"]["node"] < nodes}
    inputs = {animation["samplers"][sampler]["input"] for sampler in used}
    return max(([t for (t,) in glb.rows(index)] for index in inputs), key=len)


def spread(times):
    """Some of them; between keys other programs turn by other formulas."""
    return [times[i * (len(times) - 1) // (MOMENTS - 1)] for i in range(MOMENTS)]


def corners_of(glb):
    """{object name: [(triangle, corner) of the whole file for each of its vertices]}"""
    result, triangle = {}, 0
    for node in glb.json["nodes"]:
        if "mesh" not in node:
            continue
        mesh = glb.json["meshes"][node["mesh"]]
        corners = []
        for primitive in mesh["primitives"]:
            count = glb.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
            own = [None] * count
            indices = [i for (i,) in glb.rows(primitive["indices"])]
            for place, index in enumerate(indices):
                own[index] = own[index] or (triangle + place // 3, place % 3)
            triangle += len(indices) // 3
            corners += own
        result[node.get("name") or mesh.get("name")] = corners
    return result


def surface(program, source, clip, seconds, folder, *detail):
    """Corners of all triangles of the live surface."""
    output(program, "smooth", source, "--clip", clip, "--time", repr(seconds), *detail, "-o", folder / "live.obj")
    points, triangles = [], []
    for line in (folder / "live.obj").read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            triangles.append([points[int(word.split("/")[0]) - 1] for word in words[1:]])
    return triangles


def compare(triangles, corners, objects, height):
    """Largest distance of a vertex that the program shows from where the live surface has it, percent of the height."""
    worst = 0.0
    for name, own in corners.items():
        shown = objects[name] if name in objects else objects[name + ".001"]  # Blender names shape keys, too.
        assert len(shown) == len(own), "%s: %d vertices shown, %d in the file" % (name, len(shown), len(own))
        for place, (triangle, corner) in zip(shown, own):
            worst = max(worst, math.dist(place, triangles[triangle][corner]))
    return 100.0 * worst / height


def height_of(program, source):
    return json.loads(output(program, "inspect", source, "--json"))["height"]
