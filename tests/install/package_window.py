# tests/install/package_window.py: the editor from the package, in a real window, with the source tree hidden.
"""Arguments: PROGRAM ROOT OUT CHARACTERS BUILD, the first four as every script of tests/gui."""
import pathlib
import shlex
import shutil
import sys

sys.dont_write_bytecode = True
sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(pathlib.Path(__file__).resolve().parents[1] / "gui")]
import driver
import package_root


def story(t):
    build, source = pathlib.Path(sys.argv[5]).resolve(), t.assets.parent
    if shutil.which("cpack") is None or shutil.which("dpkg-deb") is None:
        raise driver.Skip("no package can be made here without cpack and dpkg-deb")
    _, root = package_root.make(build, t.folder)
    hidden = package_root.without(source)
    if hidden is None:
        print("left out: the source tree hidden from the installed editor, unshare cannot mount here")
        hidden = []
    program = t.folder / "sinew"
    words = " ".join(shlex.quote(str(word)) for word in [*hidden, root / "usr/bin/sinew"])
    program.write_text('#!/bin/sh\nexec %s "$@"\n' % words)
    program.chmod(0o755)
    t.program = str(program)
    sample = root / "usr/share/sinew/assets/humanoid.rig.json"
    editor = t.edit(sample)
    state = editor.wait_until("the sample's muscles", lambda s: s["document"]["primitives"] > 10 and s["triangles"] > 0)
    found = editor.xdotool("search", "--class", "^sinew$")
    t.check("its window has the class that the desktop entry names", found != "")
    t.check("no message", not state["messages"], state["messages"])
    pixels = editor.pixels(state["viewport"])
    colors = len({pixels[i:i + 3] for i in range(0, len(pixels), 3)})
    t.check("the picture is drawn", colors > 2000, colors)
    t.check_equal("quits", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("package_window", story))
