# tests/install/package_test.py: the Debian package: what is in it, what the checkers say, and the program from it.
"""Usage: package_test.py BUILD SOURCE. Nothing is installed on this system: dpkg gets a root folder of its own."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import package_python
import package_root
from checks import check, run

EXPECTED = """usr/bin/sinew usr/share/applications/sinew.desktop usr/share/mime/packages/sinew.xml
    usr/share/metainfo/org.example.Sinew.metainfo.xml usr/share/icons/hicolor/scalable/apps/sinew.svg
    usr/share/icons/hicolor/16x16/apps/sinew.png usr/share/icons/hicolor/48x48/apps/sinew.png
    usr/share/icons/hicolor/256x256/apps/sinew.png usr/share/man/man1/sinew.1.gz
    usr/share/bash-completion/completions/sinew usr/share/zsh/vendor-completions/_sinew
    usr/share/fish/vendor_completions.d/sinew.fish usr/share/doc/sinew/copyright usr/share/doc/sinew/changelog.gz
    usr/share/doc/sinew/changelog.Debian.gz usr/share/doc/sinew/examples/three.js/sinew_muscles.js usr/share/doc/sinew/docs/editor.md usr/share/sinew/shaders/surface.frag
    usr/share/sinew/core/geometry/formulas/potential.h
    usr/share/sinew/assets/humanoid.rig.json usr/share/sinew/assets/presets/athlete.json""".split()


def has(tool):
    if shutil.which(tool) is None:
        print("left out: what %s says of the package, it is not installed" % tool)
        return False
    return True


def names_its_dependencies(deb, root):
    field = run("dpkg-deb", "--field", deb, "Depends")
    named = set(re.findall(r"[\w.+-]+", re.sub(r"\([^)]*\)", "", field)))
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", root / "usr/bin/sinew"))
    check("the program needs libraries", len(needed) > 5, needed)
    for library in needed:
        owners = set(re.findall(r"^([\w.+-]+)(?::\w+)?: ", run("dpkg-query", "--search", "*/" + library), re.MULTILINE))
        check("the package of %s is named" % library, owners & named, "%s, not in: %s" % (owners, field))
    check("the letters' packages are named", {"fonts-inter", "fonts-dejavu-core"} <= named, field)
    wished = run("dpkg-deb", "--field", deb, "Recommends")
    check("that of Chinese, Japanese and Korean is recommended", "fonts-noto-cjk" in wished, wished)
    check("what opens the pages is recommended", "xdg-utils" in wished, wished)


def holds_what_it_should(root):
    files = {path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()}
    check("all parts are there", not set(EXPECTED) - files, set(EXPECTED) - files)
    with_shaders = "usr/share/sinew/core/geometry/formulas/"  # What they include.
    strange = [f for f in files if re.search(r"(\.py|\.h|\.cpp|\.a|\.cmake|CMakeLists\.txt)$|/maker/", f)
               and not f.startswith(with_shaders)]
    check("no part of the library or of the build", not strange, strange)
    pages = root / "usr/share/doc/sinew/docs"
    for page in pages.glob("*.md"):
        for picture in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text()):
            check("%s has its picture %s" % (page.name, picture), (pages / picture).is_file())
    for size in (16, 24, 32, 48, 64, 128, 256):
        head = (root / ("usr/share/icons/hicolor/%dx%d/apps/sinew.png" % (size, size))).read_bytes()[16:24]
        check("the icon of %d pixels" % size, head == size.to_bytes(4, "big") * 2)


def pleases_the_checkers(deb, root):
    share = root / "usr/share"
    if has("desktop-file-validate"):
        check("desktop-file-validate", run("desktop-file-validate", share / "applications/sinew.desktop") == "")
    if has("appstreamcli"):
        run("appstreamcli", "validate", "--no-net", share / "metainfo/org.example.Sinew.metainfo.xml")
        check("appstreamcli validate", True)
    if has("man"):
        page = subprocess.run(["man", "--warnings", "-l", share / "man/man1/sinew.1.gz"], capture_output=True,
                              text=True, env=dict(os.environ, MANWIDTH="80", LC_ALL="C.UTF-8"))
        check("the manual is set without a warning", page.returncode == 0 and page.stderr == "", page.stderr)
        check("it has its sections", all(s in page.stdout for s in ("EXIT STATUS", "FILES", "sinew render")))
    if has("lintian"):
        # --allow-root: in a container tests run as root.
        done = subprocess.run(["lintian", "--allow-root", "--no-cfg", "--fail-on", "error", deb], capture_output=True,
                              text=True)
        print(done.stdout.rstrip())
        check("lintian finds no error", done.returncode == 0, done.stdout + done.stderr)


def rigs_have_their_type(root, work):
    if not has("update-mime-database"):
        return
    data = work / "share"
    (data / "mime/packages").mkdir(parents=True)
    shutil.copy(root / "usr/share/mime/packages/sinew.xml", data / "mime/packages")
    done = run("update-mime-database", data / "mime")
    globs = (data / "mime/globs2").read_text()
    check("*.rig.json is a rig", "application/x-sinew-rig+json:*.rig.json" in globs, done + globs)
    entry = (root / "usr/share/applications/sinew.desktop").read_text()
    check("which the program opens", "application/x-sinew-rig+json;" in entry)


def runs_without_its_source(deb, root, source, work):
    hidden = package_root.without(source)
    if hidden is None:
        print("left out: the source tree hidden from the installed program, unshare cannot mount here")
        hidden = []
    program, data = root / "usr/bin/sinew", root / "usr/share/sinew"
    if hidden:
        seen = subprocess.run([*hidden, "ls", source], capture_output=True, text=True)
        check("the source tree is hidden", seen.returncode == 0 and seen.stdout == "", seen.stdout + seen.stderr)
    described = re.search(r"command line \(([^)]*)\)", run("dpkg-deb", "--field", deb, "Description"))[1]
    verbs = re.findall(r"^  (\w+) {2,}", run(*hidden, program, "--help").split("Subcommands:")[1], re.MULTILINE)
    check("the description names the verbs", re.findall(r"\w+", described) == [v for v in verbs if v != "edit"], described)
    version = run(*hidden, program, "--version")
    check("--version: version and commit", re.fullmatch(r"sinew \d+\.\d+\.\d+ \(\S+\)\n", version), version)
    told = run(*hidden, program, "inspect", data / "assets/humanoid.rig.json")
    check("inspect describes a sample", "primitives" in told or "muscles" in told, told)
    picture = work / "picture.png"
    render = [program, "render", data / "assets/humanoid.rig.json", "--size", "160x160", "-o", picture]
    done = subprocess.run([*hidden, *render], capture_output=True, text=True, cwd=work)
    if "OpenGL" in done.stderr or "EGL" in done.stderr:
        print("left out: a picture by the installed program: " + done.stderr.strip())
    else:
        drawn = done.returncode == 0 and picture.stat().st_size > 4000
        check("render draws a sample with the installed shaders", drawn, done.stderr)
        # With the source tree in sight, its shaders are not taken in place of the program's own.
        (data / "shaders/surface.frag").write_text("no shader")
        done = subprocess.run(render, capture_output=True, text=True, cwd=work)
        check("its own shaders come first", done.returncode == 1 and str(data) in done.stderr, done.stderr)
    told = run(*hidden, program, "bench", data / "assets/demo.rig.json", "--rounds", 1)
    check("bench measures a sample", "Table 1" in told, told)
    check("no package ships the measurements for those who change the code", not list(root.rglob("*sinew_bench*")))


def installs_and_goes_again(deb, work):
    """dpkg's own steps on an empty root; dependencies are those of this system."""
    root = work / "system"
    for folder in ("var/lib/dpkg/info", "var/lib/dpkg/updates", "var/lib/dpkg/triggers", "var/log"):
        (root / folder).mkdir(parents=True)
    for file in ("status", "available"):
        (root / "var/lib/dpkg" / file).touch()
    dpkg = ["dpkg", "--root=%s" % root, "--force-not-root", "--force-script-chrootless", "--force-depends",
            "--force-bad-path", "--log=/dev/null"]
    as_root = [] if os.geteuid() == 0 else (["unshare", "-r"] if package_root.can(["unshare", "-r", "true"]) else None)
    if as_root is None:
        print("left out: dpkg --install and --purge in a root of their own, files cannot be given to root here")
        return
    # dpkg wants the tools of an administrator, though no script of the package uses them.
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    run(*as_root, *dpkg, "--install", deb)
    check("dpkg has installed it", "install ok" in run(*dpkg, "--status", "sinew"))
    check("the program runs from there", run(root / "usr/bin/sinew", "--version").startswith("sinew "))
    run(*as_root, *dpkg, "--purge", "sinew")
    left = [p for p in root.rglob("*") if "sinew" in p.name]
    check("nothing is left of it", not left, left)


def main():
    build, source = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    missing = [tool for tool in ("cpack", "dpkg-deb", "dpkg-shlibdeps", "readelf") if shutil.which(tool) is None]
    if missing:
        print("left out: no package can be made here without " + ", ".join(missing))
        return 77
    # Outside the source tree, which is hidden later.
    work = pathlib.Path(tempfile.mkdtemp(prefix="sinew-package-"))
    try:
        deb, root = package_root.make(build, work)
        print("made %s, %d bytes" % (deb.name, deb.stat().st_size))
        names_its_dependencies(deb, root)
        holds_what_it_should(root)
        pleases_the_checkers(deb, root)
        rigs_have_their_type(root, work)
        runs_without_its_source(deb, root, source, work)
        installs_and_goes_again(deb, work)
        for module in deb.parent.glob("python3-sinew_*.deb"):
            package_python.check_package(module, work, source)
    finally:
        shutil.rmtree(work, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
