# tests/structure/check_structure.py: the rules of the tree that no compiler knows. Usage: check_structure.py ROOT
"""Prints one line per broken rule and exits 1 if there is any."""
import pathlib
import re
import sys

# Each row may include only rows above it. "surface/patches" is a floor of the room core/surface, which is built from it.
LAYERS = {
    "core": ["geometry/formulas", "geometry", "character", "rig", "surface/patches surface/roots", "surface/projection surface/finish", "surface", "runtime",
             "bodies/sheets", "bodies", "files/disk files/json", "files/gltf", "files", "files/fit", "files/usd", "files/export", "sinew"],
    "app": ["ui", "document", "viewport/render", "viewport/gpu viewport/tools", "command", "editor", "panels", "window", "main"],
}
LAYERS = {tree: {name: number for number, row in enumerate(rows) for name in row.split()} for tree, rows in LAYERS.items()}
# Under tests, what runs without the editor: the tests of core's directories, and what they share.
CORE_TESTS = {name.split("/")[0] for name in LAYERS["core"]} | {"support"}
EDITOR_SUPPORT = ("tests", "support", "editor")
PUBLIC_ROOMS = {"c": "runtime"}  # core/include/sinew/c is the public face of core/runtime in C
PUBLIC = "core/include/"  # sinew/mesh/x.h there is the public face of core/geometry
ASKS_FOR_ITS_LIBRARY = "sinew/geometry/same_version.h"
ONLY_MACROS = "sinew/geometry/version.h"
SOURCES = {".h", ".c", ".cpp", ".vert", ".frag", ".geom", ".comp", ".glsl", ".py", ".sh", ".cmake", ".js", ".gd", ".cs", ".pyi"}
SCRIPTS_WITHOUT_ENDING = {".ci/run"}
LEFT_OUT = {".git", "build", "out", ".cache"}
MAX_COLUMNS = 120
WINDOW_AND_GPU = re.compile(r"^(epoxy/|GLFW/|GL/|EGL/|GLES|KHR/|imgui|backends/imgui|misc/)")
# Their templates must not come into the archives under their own names: one file of core includes them, and sees to that.
IN_ONE_FILE = {"Eigen/": "core/files/fit/own_eigen.h", "tbb/": "core/geometry/own_tasks.cpp", "oneapi/": "core/geometry/own_tasks.cpp"}
FILE_LIBRARIES = re.compile(r"^(tiny_gltf|tinygltf|nlohmann/|stb|draco/|meshoptimizer)")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
PAGES = {"README.md", "CONTRIBUTING.md"}  # docs/*.md and the pages of rooms: every path they name in backticks must exist
TREES = ("app", "core", "tests", "shaders", "assets", "docs", "cmake", "packaging", "examples", "python", "blender")
NAMED_PATH = re.compile(r"(?:%s)/[\w./*{},-]*" % "|".join(TREES))
# In a batch of files compiled as one, a constant of one file hides a header's of the same name from the files behind it.
HEADER_CONSTANT = re.compile(r"\binline constexpr [^=;({]*?\b(k[A-Z]\w*)\s*[={]")
OWN_CONSTANT = re.compile(r"^(?:static )?constexpr [^=;({]*?\b(k[A-Z]\w*)\s*[={]", re.MULTILINE)
SAMPLE = "tests/install/consumer/main.cpp"
PLACEHOLDER = re.compile(r"[A-Z]{3,}")  # app/command/NAME.cpp: not a path but a pattern


def files(root):
    """Paths relative to root, sorted, without what builds leave."""
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        if path.is_file() and relative.parts[0] not in LEFT_OUT and "__pycache__" not in relative.parts:
            yield relative


def is_source(path):
    return path.suffix in SOURCES or path.as_posix() in SCRIPTS_WITHOUT_ENDING


def directory(path):
    """("core", "mesh") of core/geometry/weld.h and of core/include/sinew/geometry/x.h; ("app", "main") of app/main.cpp; else None."""
    path = path.removeprefix(PUBLIC)
    parts = pathlib.PurePosixPath(path).parts
    if parts and parts[0] == "sinew":
        parts = ("core",) + parts[1:]
    if len(parts) < 2 or parts[0] not in LAYERS:
        return None
    name = "/".join(parts[1:-1]) or parts[1].split(".")[0]
    return parts[0], PUBLIC_ROOMS.get(name, name)


def layer(tree, name, public):
    """A public header of "smoothing" stands below every part of smoothing."""
    layers = LAYERS[tree]
    return min(n for d, n in layers.items() if d.split("/")[0] == name) if public else layers[name]


def needs_editor(path):
    """Whether a file is of the editor and the command line, or tests them."""
    parts = pathlib.PurePosixPath(path).parts
    of_app = parts[0] == "app" or parts[:3] == EDITOR_SUPPORT
    return of_app or (parts[0] == "tests" and len(parts) > 2 and parts[1] not in CORE_TESTS)


def check_include(path, target):
    """Why `path` may not include `target`, or None."""
    own, other = directory(path.as_posix()), directory(target)
    if path.parts[0] == "tests" and not needs_editor(path) and needs_editor(target):
        return "tests of core include nothing of app"
    if path.parts[0] == "python":
        if (other is not None and other[0] == "app") or WINDOW_AND_GPU.match(target) or FILE_LIBRARIES.match(target):
            return "the Python module includes core alone"
        return None
    if own is None:
        return None
    tree, name = own
    if tree == "core" and (other is not None and other[0] == "app"):
        return "core never includes app"
    if tree == "core" and WINDOW_AND_GPU.match(target):
        return "core knows no window, no OpenGL and no ImGui"
    for start, one in IN_ONE_FILE.items():
        if tree == "core" and target.startswith(start) and path.as_posix() != one:
            return "only %s knows it" % one
    if FILE_LIBRARIES.match(target) and not (tree == "core" and name.split("/")[0] == "files") and not (
            tree == "app" and target.startswith("stb")):
        return "only core/files knows tinygltf, nlohmann-json, stb, Draco and meshoptimizer"
    public, own_public = target.startswith("sinew/"), path.as_posix().startswith(PUBLIC)
    if own_public and other is not None and other[0] == "core" and not public:
        return "a public header includes only public headers"
    if other is None or other[0] != tree or other[1] == name:
        return None
    for who in (name, other[1]):
        if who not in LAYERS[tree]:
            return "%s/%s has no layer; give it one in tests/structure/check_structure.py" % (tree, who)
    mine, theirs = layer(tree, name, own_public), layer(tree, other[1], public)
    if theirs >= mine and not (public and other[1] == name.split("/")[0]):
        return "%s may include only what LAYERS names before it, not %s" % (name, other[1])
    return None


def check_source(path, lines):
    head = lines[:2] if lines and lines[0].startswith(("#!", "#version")) else lines[:1]
    name = re.compile(r"(?:#|//|/\*)\s*" + re.escape(path.as_posix()) + r": \S")
    if path.name not in ("CMakeLists.txt",) and not any(name.search(line) for line in head):
        yield 1, "the first line does not name the file: '// %s: what it is'" % path.as_posix()
    if path.suffix in (".h", ".cpp"):
        for number, line in enumerate(lines, 1):
            found = INCLUDE.match(line)
            reason = check_include(path, found.group(1)) if found else None
            if reason:
                yield number, "includes %s: %s" % (found.group(1), reason)
            if number > 1 and len(line) > MAX_COLUMNS:
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


def check_public(root, paths):
    """Each public header includes another one, so that all of them lead to the one that asks for the library of its version."""
    for path in paths:
        name = path.as_posix().removeprefix(PUBLIC)
        if name != path.as_posix() and name not in (ASKS_FOR_ITS_LIBRARY, ONLY_MACROS):
            found = (INCLUDE.match(line) for line in text_of(root / path).splitlines())
            if not any(f and f[1].startswith("sinew/") and f[1] != ONLY_MACROS for f in found):
                yield "%s: includes no other public header; include %s" % (path.as_posix(), ASKS_FOR_ITS_LIBRARY)


def check_constants(root, paths):
    """Within core and within app."""
    for tree in LAYERS:
        own = [path for path in paths if path.parts[0] == tree]
        header_of = {name: path for path in own if path.suffix == ".h" for name in HEADER_CONSTANT.findall(text_of(root / path))}
        for path in own:
            if path.suffix == ".cpp":
                for name in OWN_CONSTANT.findall(text_of(root / path)):
                    if name in header_of:
                        yield "%s: %s would hide that of %s from files compiled with it" % (
                            path.as_posix(), name, header_of[name].as_posix())


def named_paths(line):
    """The paths in the backticks of a line, "a.{h,cpp}" as two."""
    for quoted in re.findall(r"`([^`]+)`", line):
        for word in quoted.split():
            path = NAMED_PATH.fullmatch(word.rstrip(".,;:"))
            if not path or PLACEHOLDER.search(word):
                continue
            choice = re.fullmatch(r"(.*)\{(.*)\}(.*)", path.group())
            yield from (choice[1] + end + choice[3] for end in choice[2].split(",")) if choice else (path.group(),)


def check_pages(root, paths):
    """A page names only files and directories that are there."""
    for path in paths:
        if path.as_posix() in PAGES or (path.parts[0] in ("docs", "core", "app") and path.suffix == ".md"):
            for number, line in enumerate((root / path).read_text(encoding="utf-8").splitlines(), 1):
                for name in named_paths(line):
                    if not any(root.glob(name.rstrip("/"))):
                        yield "%s:%d: `%s` does not exist" % (path.as_posix(), number, name)


def check_rooms(root):
    """Each room has a page that begins with its name and says what comes in, goes out and may be included, and its tests."""
    for tree, layers in LAYERS.items():
        for room in sorted({name.split("/")[0] for name in layers} - {"sinew", "main"}):
            if not (root / tree / room).is_dir():
                continue
            text = text_of(root / tree / room / "README.md")
            rows = [row for row in ("comes in", "goes out", "may include", "tests") if not re.search(r"^\| %s \| .+ \|$" % row, text, re.MULTILINE)]
            if not text.startswith("# %s/%s\n" % (tree, room)) or rows:
                yield "%s/%s/README.md: expected '# %s/%s', and a table with comes in, goes out, may include, tests" % (tree, room, tree, room)


def check_sample(text, program):
    """The C++ in README.md is made of lines of a program that the tests build and run."""
    lines = {line.strip() for line in program.splitlines()}
    for block in re.findall(r"```cpp\n(.*?)```", text, re.DOTALL):
        for line in block.splitlines():
            if line.strip() and line.strip() not in lines:
                yield "README.md: '%s' is not in %s" % (line.strip(), SAMPLE)


def text_of(path):
    return path.read_text(encoding="utf-8") if path.is_file() else ""


def problems(root):
    paths = list(files(root))
    for path in paths:
        if is_source(path):
            lines = (root / path).read_text(encoding="utf-8", errors="replace").splitlines()
            for number, reason in check_source(path, lines):
                yield "%s:%d: %s" % (path.as_posix(), number, reason)
    yield from check_tests(root, paths)
    yield from check_public(root, paths)
    yield from check_constants(root, paths)
    yield from check_pages(root, paths)
    yield from check_rooms(root)
    yield from check_sample(text_of(root / "README.md"), text_of(root / SAMPLE))


def main():
    found = list(problems(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) if found else "all rules are kept")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
