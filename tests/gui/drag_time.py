# tests/gui/drag_time.py: what a frame of a drag costs beside drawing, with little and much history, few and many muscles.
"""Prints; judges no time. Last argument: man or humanoid."""
import json
import shutil
import statistics
import sys

import driver

CAST = {
    "man": {"files": ["cesium_man.gltf"], "real": True, "bone": "joint 5"},
    "humanoid": {"files": ["humanoid.glb"], "real": False, "bone": "upper_arm.L"},
}
DEPTH = 5
FRAMES = 60
STAGES = ("skin", "patch", "project", "prepare", "ui")  # All but drawing and what goes to the graphics card.
DRAGGED = "dragged"


def muscle(name, bone, offset, radius, sign=1):
    return {"name": name, "bone": bone, "group": "muscles", "kind": "ellipsoid", "center": offset,
            "rotation": [0.0, 0.0, 0.0, 1.0], "radii": [radius, 0.7 * radius, 0.7 * radius], "reach": 1.4142135, "sign": sign}


def rig_with(told, role, character, untouched):
    """The one that is dragged, and others on the other bones, none in the same place."""
    height = told["height"]
    others = [bone for bone in told["joint_names"] if bone != role["bone"]]
    primitives = [muscle(DRAGGED, role["bone"], [0.0, 0.0, 0.0], 0.05 * height)]
    for i in range(untouched):
        spread = [0.06 * height * (((i * step) % 1.0) - 0.5) for step in (0.618034, 0.414214, 0.732051)]
        primitives.append(muscle("other %d" % i, others[i % len(others)], spread, 0.03 * height))
    return {"format": "sinew-rig", "version": 1, "character": character,
            "surface": {"mode": "swell", "iso": 0.25, "skin_blend": 0.04},
            "smoothing": {"depth": 1, "patch": "pn", "projection": "newton"},
            "groups": [{"name": "muscles"}], "links": [], "primitives": primitives}


def opened(t, role, told, character, untouched):
    file = t.folder / ("drag-%d-%d.rig.json" % (untouched, len(t.editors)))
    file.write_text(json.dumps(rig_with(told, role, character, untouched)))
    editor = t.edit(file)
    state = editor.wait_until("the rig", lambda s: s["document"]["primitives"] == untouched + 1)
    if state["playing"]:
        editor.choose_clip(-1, "")
    editor.tap("shift+s", "no symmetry", lambda s: not s["symmetry"]["on"])
    editor.select_muscle(DRAGGED)
    return editor


def with_history(t, editor, steps):
    """Many small steps, at depth 1, where they cost little; the last is the depth."""
    fields = [editor.widget("inspector/carves"), editor.widget("inspector/adds")]
    for done in range(0, steps - 1, 24):
        words = []
        for i in range(done, min(done + 24, steps - 1)):
            words += ["mousemove", round(fields[i % 2][0]), round(fields[i % 2][1]), "click", driver.LEFT]
        editor.xdotool(*words)
        editor.wait_until("some steps", lambda s: s["document"]["undo"] == min(done + 24, steps - 1))
    editor.mouse = tuple(round(v) for v in fields[(steps - 2) % 2])
    editor.click("smoothing/depth", along=(DEPTH - 0.5) / 8.0)
    state = editor.wait_until("the depth", lambda s: s["depth"] == DEPTH and s["document"]["undo"] == steps)
    t.check_equal("steps in the history", state["document"]["undo"], steps)


def frames_of_a_drag(t, editor):
    """Times of the frames in which the muscle moved, milliseconds by stage."""
    editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    editor.grab("move.center")
    start = editor.mouse
    editor.read_new()
    frames = []

    def moved():
        step = len(frames) + 1
        editor.xdotool("mousemove", start[0] + step % 40 + 1, start[1] + (step * 7) % 30)
        driver.wait_for("a frame", lambda: frames.extend(
            s["ms"] for s in editor.read_new() if s["gizmo"]["dragging"] and s["ms"]["prepare"] > 0) or True)
        return len(frames) >= FRAMES

    driver.wait_for("%d frames of a drag" % FRAMES, moved, timeout=2 * driver.PATIENCE)
    editor.key("Escape")
    editor.release()
    editor.wait_until("the end of the drag", lambda s: not s["gizmo"]["dragging"])
    return frames


def measured(t, role, told, character, steps, untouched):
    editor = opened(t, role, told, character, untouched)
    with_history(t, editor, steps)
    frames = frames_of_a_drag(t, editor)
    editor.screenshot(t.out / ("drag_time_%s_%d_%d.png" % (sys.argv[5], steps, untouched)))
    editor.tap("ctrl+q", "the question about changes", lambda s: s["dialog"] == "unsaved")
    editor.click("unsaved/discard")
    editor.wait_for_end()
    median = statistics.median(sum(ms[stage] for stage in STAGES) for ms in frames)
    parts = ", ".join("%s %.2f" % (stage, statistics.median(ms[stage] for ms in frames)) for stage in STAGES)
    print("%3d steps, %2d untouched muscles: %6.2f ms beside drawing (%s; %d frames)" % (steps, untouched, median, parts, len(frames)),
          flush=True)
    return median


def story(t):
    role = CAST[sys.argv[5]]
    folder = t.characters if role["real"] else t.assets
    if role["real"] and not (folder / role["files"][0]).is_file():
        raise driver.Skip("real characters are not at hand")
    for name in role["files"]:
        shutil.copyfile(folder / name, t.folder / name)
    character = role["files"][0]
    told = json.loads(t.run_program("inspect", "--json", t.folder / character).stdout)
    usual = measured(t, role, told, character, 5, 10)
    long = measured(t, role, told, character, 200, 10)
    many = measured(t, role, told, character, 5, 60)
    print("a drag with 200 steps of history costs %.2f times one with 5" % (long / usual))
    print("a drag with 60 untouched muscles costs %.2f times one with 10" % (many / usual))


if __name__ == "__main__":
    sys.exit(driver.run("drag_time_" + sys.argv[5], story))
