#!/usr/bin/env python3
# docs/screenshots.py: makes docs/images/*, the pictures of the README and of docs/tutorial.md, in a real window.
# Usage: docs/screenshots.py [--tutorial | --head] [SINEW]   SINEW: the program; without it, the newest one under build/.
# --tutorial: only the tutorial's; --head: only the README's first two. Needs Xvfb, xdotool and imagemagick, as the GUI
# tests do.
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


def gallop(t):
    """The README's loop, at half speed: the mesh of the file, the skin over the muscles, the muscles."""
    columns = (("horse.glb", "--depth", "1", "--detail", "uniform", "--patch", "flat", "--crease", "1", "--shading", "clay",
                "--show", "control"),
               ("horse-flex.rig.json", "--light", "outdoor", "--ao"),
               ("horse-flex.rig.json", "--show", "muscles", "--samples", "16"))
    frames = 32  # The clip takes 0.54 s; the last of its 60 a second is the first again.
    for number, (file, *look) in enumerate(columns):
        subprocess.run([newest_program(), "render", ROOT / "assets" / file, *look, "--clip", "Gallop", "--fps", "60",
                        "--frames", "0:%d" % (frames - 1), "--view", "right", "--size", "480x350",
                        "-o", t.folder / ("%d_%%04d.png" % number)], check=True, stdout=subprocess.DEVNULL)
    for frame in range(frames):
        row = [t.folder / ("%d_%04d.png" % (column, frame)) for column in range(len(columns))]
        subprocess.run(["convert", *row, "+append", "+repage", t.folder / ("row_%04d.png" % frame)], check=True)
    loop = ROOT / "docs" / "images" / "gallop.webp"
    subprocess.run(["convert", "-delay", "3", "-loop", "0", *sorted(t.folder.glob("row_*.png")), "-quality", "90",
                    loop], check=True)
    print(loop)


def one_drag(t):
    """A muscle drawn along the thigh of the bare horse: before, half way, released; without panels."""
    editor = t.edit(t.copy(t.assets / "horse.glb", "bare.glb"))
    editor.wait_until("the walk", lambda s: s["playing"])
    editor.tap("space", "the pause", lambda s: not s["playing"])
    editor.taps("ctrl+Left", "2", "m", "KP_3")
    editor.settle()
    for _ in range(6):
        editor.move(editor.state()["bones"]["thigh.L"][:2])
        editor.xdotool("click", "4")
    stills = []

    def still():
        editor.settle()
        stills.append(t.folder / ("still_%d.png" % len(stills)))
        editor.screenshot(stills[-1])

    bones = editor.state()["bones"]
    hip, knee = bones["thigh.L"], bones["shin.L"]
    on_thigh = lambda share: [a + share * (b - a) for a, b in zip(hip, knee)][:2]  # noqa: E731
    editor.point_at(lambda: on_thigh(-0.35))
    still()
    editor.press()
    for share in (-0.2, 0.0, 0.2):
        editor.move(on_thigh(share))
    still()
    for share in (0.35, 0.5, 0.6):
        editor.move(on_thigh(share))
    editor.release()
    editor.move(on_thigh(2.5))
    editor.wait_until("all samples", lambda s: s["samples"] == 16)
    still()
    x, y = (round(c) for c in on_thigh(0.5))
    picture = ROOT / "docs" / "images" / "one-drag.jpg"
    subprocess.run(["convert", *stills, "-crop", "480x350%+d%+d" % (x - 240, y - 175), "+repage", "+append", "-strip",
                    "-quality", "88", picture], check=True)
    print(picture)
    editor.kill()


def head(t):
    one_drag(t)
    gallop(t)


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


def save_step(editor, name, height=800):
    """For the tutorial: many pictures, each small; of the upper part, where the lower one shows a folder's name."""
    editor.settle()
    editor.wait_until("all samples", lambda s: s["samples"] == 16)
    picture = ROOT / "docs" / "images" / name
    with tempfile.NamedTemporaryFile(suffix=".png") as whole:
        editor.screenshot(pathlib.Path(whole.name))
        subprocess.run(["convert", whole.name, "-crop", "1280x%d+0+0" % height, "-strip", "-quality", "82",
                        str(picture)], check=True)
    print(picture)


def tutorial(t):
    """docs/tutorial.md: the horse without a rig becomes one that flexes."""
    editor = t.edit(t.copy(t.assets / "horse.glb", "downloaded.glb"))
    editor.wait_until("the walk", lambda s: s["playing"])
    editor.tap("space", "the pause", lambda s: not s["playing"])
    editor.move((650, 640))
    save_step(editor, "tutorial-1-opened.jpg")

    editor.palette("add muscle set", "muscles/add-set")
    editor.wait_until("a step", lambda s: s["document"]["undo"] == 1)
    left, right = editor.widget("muscle-set/mass", 0.5), editor.widget("muscle-set/mass", 0.68)
    editor.drag(left, right)
    editor.move((760, 560))
    editor.key("2")
    save_step(editor, "tutorial-2-set.jpg")
    editor.click("muscle-set/done")

    editor.click("library/tab")
    editor.fill("library/search", "triceps")
    ends = (editor.state()["bones"][bone] for bone in ("upper_arm.L", "forearm.L"))
    arm = [0.4 * a + 0.6 * b for a, b in zip(*ends)][:2]
    editor.point_at(lambda: editor.widget("library/animal/triceps"))
    editor.press()
    start = editor.widget("library/animal/triceps")
    for share in (0.3, 0.6, 0.9, 1.0):
        editor.move([a + share * (b - a) for a, b in zip(start, arm)])
    save_step(editor, "tutorial-3-library.jpg")
    editor.key("Escape")
    editor.release()

    editor.click("outliner/tab")
    editor.select_muscle("gluteal L")
    editor.tap("r", "the scaling handles", lambda s: s["gizmo"]["visible"] and s["gizmo"]["mode"] == "scale")
    editor.move((760, 640))
    save_step(editor, "tutorial-4-gluteal.jpg")

    editor.tap("v", "the anatomy", lambda s: s["display"]["anatomy"])
    editor.palette("check muscles", "play/check")
    editor.move((760, 640))
    save_step(editor, "tutorial-5-check.jpg")
    editor.click("check/close")

    editor.tap("v", "the skin", lambda s: not s["display"]["anatomy"])
    editor.tap("ctrl+shift+e", "the dialog", lambda s: s["dialog"] == "export")
    save_step(editor, "tutorial-6-export.jpg", 585)
    editor.kill()


def story(t):
    def copy_of(name):
        t.copy(t.assets / (name + ".glb"))
        return t.copy(t.assets / (name + ".rig.json"))

    t.copy_of = copy_of
    head(t)
    walking(t)
    shoulder(t)
    flexing(t)
    tutorial(t)


if __name__ == "__main__":
    parts = {"--tutorial": tutorial, "--head": head}
    part = next((parts[a] for a in sys.argv[1:] if a in parts), story)
    arguments = [a for a in sys.argv[1:] if a not in parts]
    program = arguments[0] if arguments else newest_program()
    with tempfile.TemporaryDirectory() as out:
        sys.argv[1:] = [str(program), str(ROOT), out, str(ROOT / "assets")]
        sys.exit(driver.run("screenshots", part))
