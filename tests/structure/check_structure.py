# tests/structure/check_structure.py: the rules of the house that no compiler knows. Usage: check_structure.py ROOT
"""Prints one line per broken rule and exits 1 if there is any."""
import pathlib
import re
import sys

FLOORS = {
    "core": {"base": 1, "mesh": 2, "skeleton": 2, "primitives": 2, "character": 3, "blending": 3, "rig": 4,
             "smoothing": 5, "io": 6},
    "app": {"document": 1, "platform": 1, "render": 2, "tools": 3, "cli": 3, "playback": 3, "panels": 4,
            "editor": 5, "main": 6},
}
SOURCES = {".h", ".cpp", ".vert", ".frag", ".geom", ".comp", ".glsl", ".py", ".sh", ".cmake"}
SCRIPTS_WITHOUT_ENDING = {".ci/run"}
LEFT_OUT = {".git", "build", "out", ".cache"}
MAX_LINES = 400
MAX_COLUMNS = 120
LONGER = {}  # path: why it is one idea and longer all the same
WINDOW_AND_GPU = re.compile(r"^(epoxy/|GLFW/|GL/|EGL/|GLES|KHR/|imgui|backends/imgui|misc/)")
FILE_LIBRARIES = re.compile(r"^(tiny_gltf|tinygltf|nlohmann/|stb)")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def files(root):
    """Paths relative to root, sorted, without what builds leave."""
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        if path.is_file() and relative.parts[0] not in LEFT_OUT and "__pycache__" not in relative.parts:
            yield relative


def is_source(path):
    return path.suffix in SOURCES or path.as_posix() in SCRIPTS_WITHOUT_ENDING


def room(path):
    """("core", "mesh") of core/mesh/weld.h; ("app", "editor") of app/editor.cpp; None elsewhere."""
    parts = pathlib.PurePosixPath(path).parts
    if len(parts) < 2 or parts[0] not in FLOORS:
        return None
    return parts[0], parts[1] if len(parts) > 2 else re.split(r"[._]", parts[1])[0]


def check_include(path, target):
    """Why `path` may not include `target`, or None."""
    own, other = room(path.as_posix()), room(target)
    if own is None:
        return None
    house, name = own
    if house == "core" and (other is not None and other[0] == "app"):
        return "core never includes app"
    if house == "core" and WINDOW_AND_GPU.match(target):
        return "core knows no window, no OpenGL and no ImGui"
    if FILE_LIBRARIES.match(target) and own != ("core", "io") and not (house == "app" and target.startswith("stb")):
        return "only core/io knows tinygltf, nlohmann-json and stb"
    if other is None or other[0] != house or other[1] == name:
        return None
    for who in (name, other[1]):
        if who not in FLOORS[house]:
            return "%s/%s stands on no floor; give it one in tests/structure/check_structure.py" % (house, who)
    if FLOORS[house][other[1]] >= FLOORS[house][name]:
        return "%s (floor %d) may include only rooms below it, %s is on floor %d" % (
            name, FLOORS[house][name], other[1], FLOORS[house][other[1]])
    return None


def check_source(path, lines):
    head = lines[:2] if lines and lines[0].startswith(("#!", "#version")) else lines[:1]
    name = re.compile(r"(?:#|//|/\*)\s*" + re.escape(path.as_posix()) + r": \S")
    if path.name not in ("CMakeLists.txt",) and not any(name.search(line) for line in head):
        yield 1, "the first line does not name the file: '// %s: what it is'" % path.as_posix()
    if len(lines) > MAX_LINES and path.as_posix() not in LONGER:
        yield len(lines), "more than %d lines" % MAX_LINES
    if path.suffix in (".h", ".cpp"):
        for number, line in enumerate(lines, 1):
            found = INCLUDE.match(line)
            reason = check_include(path, found.group(1)) if found else None
            if reason:
                yield number, "includes %s: %s" % (found.group(1), reason)
            if len(line) > MAX_COLUMNS:
                yield number, "more than %d columns" % MAX_COLUMNS


def check_tests(root, paths):
    """Every folder of tests, and every test script, is named by some CMakeLists.txt under tests."""
    tests = [p for p in paths if p.parts[0] == "tests" and len(p.parts) > 2]
    known = "\n".join((root / p).read_text() for p in paths if p.parts[0] == "tests" and p.name == "CMakeLists.txt")
    words = {p.parts[1]: p.parent for p in tests if is_source(p)}
    words.update({p.name: p for p in tests if re.search(r"_test\.(py|sh|cmake)$", p.name)})
    for word, path in sorted(words.items()):
        if not re.search(r"(?<![\w.])" + re.escape(word) + r"(?![\w])", known):
            yield "%s: no CMakeLists.txt under tests names '%s'" % (path.as_posix(), word)


def problems(root):
    paths = list(files(root))
    for path in paths:
        if is_source(path):
            lines = (root / path).read_text(encoding="utf-8", errors="replace").splitlines()
            for number, reason in check_source(path, lines):
                yield "%s:%d: %s" % (path.as_posix(), number, reason)
    yield from check_tests(root, paths)
    for path in LONGER:
        if not (root / path).is_file() or len((root / path).read_text().splitlines()) <= MAX_LINES:
            yield "%s: needs its place in LONGER no more" % path


def main():
    found = list(problems(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) if found else "the house is in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
