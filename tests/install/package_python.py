# tests/install/package_python.py: the Debian package of the Python module: what is in it, and the module from it.
import os
import re
import shutil
import subprocess

import package_root
from checks import check, run

PACKAGES = "usr/lib/python3/dist-packages"
USE = """
import sinew
rig = sinew.load_rig(%r)
surface = sinew.Smoother(rig.character, rig)(clip="Walk", time=0.2)
print(sinew.__file__, len(surface.positions))
"""


def check_package(deb, work, source):
    root = work / "python"
    run("dpkg-deb", "--extract", deb, root)
    print("made %s, %d bytes" % (deb.name, deb.stat().st_size))
    files = {path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()}
    wanted = {PACKAGES + "/sinew/" + path.name for path in (source / "python/sinew").iterdir() if path.is_file()}
    wanted |= {"usr/share/doc/python3-sinew/examples/" + path.name for path in (source / "examples/python").glob("*.py")}
    wanted.add("usr/share/python3-sinew/sinew-blender.zip")
    wanted |= {"usr/share/doc/python3-sinew/" + name for name in ("copyright", "changelog.gz", "changelog.Debian.gz")}
    check("python3-sinew: all parts are there", not wanted - files, wanted - files)
    more = [name for name in files - wanted if not re.fullmatch(PACKAGES + r"/sinew/_sinew\.cpython-\S+\.so", name)]
    check("and nothing else", not more and len(files) == len(wanted) + 1, more)
    depends = run("dpkg-deb", "--field", deb, "Depends")
    module, = (root / PACKAGES / "sinew").glob("_sinew*.so")
    named = set(re.findall(r"[\w.+-]+", re.sub(r"\([^)]*\)", "", depends)))
    for library in re.findall(r"\(NEEDED\).*\[(.*)\]", run("readelf", "-d", module)):
        owners = set(re.findall(r"^([\w.+-]+)(?::\w+)?: ", run("dpkg-query", "--search", "*/" + library), re.MULTILINE))
        check("the package of %s is named" % library, owners & named, "%s, not in: %s" % (owners, depends))
    check("Python's own version, and NumPy", "python3 (<< 3." in depends and "python3-numpy" in named, depends)
    check("neither the editor's letters nor OpenGL", not named & {"libgl1", "fonts-inter"}, depends)
    pleases_lintian(deb)
    works(root, work, source)
    scripts_are_sound(deb, work)


def pleases_lintian(deb):
    if shutil.which("lintian") is None:
        return
    done = subprocess.run(["lintian", "--allow-root", "--no-cfg", "--fail-on", "error", deb], capture_output=True, text=True)
    print(done.stdout.rstrip())
    check("lintian finds no error", done.returncode == 0, done.stdout + done.stderr)


def works(root, work, source):
    """With the source tree out of sight."""
    samples = work / "root/usr/share/sinew/assets/humanoid.rig.json"
    hidden = package_root.without(source) or []
    environment = dict(os.environ, PYTHONPATH=str(root / PACKAGES), PYTHONDONTWRITEBYTECODE="1")
    if subprocess.run(["/usr/bin/python3", "-c", "import numpy"], capture_output=True).returncode != 0:
        print("left out: surfaces by the module from its package, NumPy is not installed")
        return
    told = run(*hidden, "/usr/bin/python3", "-c", USE % str(samples), env=environment, cwd=work)
    place, vertices = told.split()
    check("the module from the package makes surfaces", place.startswith(str(root)) and int(vertices) > 1000, told)


def scripts_are_sound(deb, work):
    control = work / "control"
    run("dpkg-deb", "--control", deb, control)
    for name in ("postinst", "prerm"):
        check("%s can be run" % name, os.access(control / name, os.X_OK))
        run(control / name, "configure" if name == "postinst" else "remove", env=dict(os.environ, DPKG_ROOT="/nowhere"))
