#!/usr/bin/env python3
# docs/screenshots.py: makes docs/images/*.png, the README's pictures of the editor, in a real window.
# Usage: docs/screenshots.py [SINEW]     SINEW: the program; without it, the newest one under build/. Needs Xvfb, xdotool
# and imagemagick, as the GUI tests do.
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "gui"))
import driver  # noqa: E402


def newest_program():
    built = sorted(ROOT.glob("build/*/app/sinew"), key=lambda path: path.stat().st_mtime)
    if not built:
        sys.exit("screenshots.py: no program: build it, or name it")
    return built[-1]


def save(editor, name):
    picture = ROOT / "docs" / "images" / name
    editor.screenshot(picture)
    subprocess.run(["convert", str(picture), "-strip", "-define", "png:compression-level=9", str(picture)], check=True)
    print(picture)


def walking(t):
    """The humanoid in its walk, a muscle of its chest selected."""
    editor = t.edit(t.copy_of("humanoid"))
    editor.wait_until("the walk", lambda s: s["playing"] and "chest" in s["bones"])
    editor.click("outliner/muscle/pectoralis L")
    editor.wait_until("the muscle", lambda s: s["document"]["selection"] == ["pectoralis L"])
    editor.tap("r", "the scaling handles", lambda s: s["gizmo"]["visible"] and s["gizmo"]["mode"] == "scale")
    editor.move((650, 650))
    editor.next_frames(60)
    editor.tap("space", "the pause", lambda s: not s["playing"])
    editor.wait_until("all samples", lambda s: s["samples"] == 16)
    save(editor, "editor.png")
    editor.quit()


def shoulder(t):
    """A shoulder muscle from close by, bones in x-ray, the groups as a matrix."""
    editor = t.edit(t.copy_of("humanoid"))
    editor.wait_until("the walk, paused as it was left", lambda s: not s["playing"] and "chest" in s["bones"])
    editor.select_muscle("deltoideus L")
    editor.tap("r", "the scaling handles", lambda s: s["gizmo"]["visible"] and s["gizmo"]["mode"] == "scale")
    editor.click("display/skeleton")
    editor.click("blending/tab")
    editor.wait_until("the matrix", lambda s: sum(w.startswith("blending/") for w in s["widgets"]) > 3)
    editor.move((650, 650))
    editor.wait_until("all samples", lambda s: s["samples"] == 16)
    save(editor, "groups.png")
    editor.quit()


def flexing(t):
    """The flexing humanoid as an anatomy plate: his muscles under skin of glass, an arm bent."""
    t.copy(t.assets / "humanoid.glb")
    editor = t.edit(t.copy(t.assets / "humanoid-flex.rig.json"))
    state = editor.wait_until("the character", lambda s: "chest" in s["bones"])
    editor.choose_clip(state["clips"].index("Flex"), "Flex")
    if editor.state()["playing"]:
        editor.tap("space", "the pause", lambda s: not s["playing"])
    editor.taps("ctrl+Left", *["period"] * 21)
    editor.select_muscle("biceps L")
    editor.tap("w", "the moving handles", lambda s: s["gizmo"]["visible"] and s["gizmo"]["mode"] == "move")
    editor.tap("v", "the anatomy", lambda s: s["display"]["anatomy"])
    editor.click("display/skeleton")
    editor.click("display/numbers")
    editor.move((650, 650))
    editor.wait_until("all samples", lambda s: s["samples"] == 16)
    save(editor, "anatomy.png")
    editor.quit()


def story(t):
    def copy_of(name):
        t.copy(t.assets / (name + ".glb"))
        return t.copy(t.assets / (name + ".rig.json"))

    t.copy_of = copy_of
    walking(t)
    shoulder(t)
    flexing(t)


if __name__ == "__main__":
    program = sys.argv[1] if len(sys.argv) > 1 else newest_program()
    with tempfile.TemporaryDirectory() as out:
        sys.argv[1:] = [str(program), str(ROOT), out, str(ROOT / "assets")]
        sys.exit(driver.run("screenshots", story))
