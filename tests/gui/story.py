# tests/gui/story.py: eight mirrored muscles while it walks, names, groups, arms kept off the torso; reopened.
import json
import sys

import driver

# What is laid on: a name without its side, the bone it grows on, and the stroke from one bone's place towards another's.
CAST = {
    "humanoid": {
        "file": "humanoid.glb", "real": False, "clip": "Walk", "bare": "thigh.L",
        "strokes": [
            ("arm biceps", "upper_arm.L", "upper_arm.L", "forearm.L", (0.30, 0.5, 0.65, 0.8)),
            ("arm forearm", "forearm.L", "forearm.L", "hand.L", (0.2, 0.4, 0.55, 0.7)),
            ("leg quads", "thigh.L", "thigh.L", "shin.L", (0.3, 0.45, 0.6, 0.75)),
            ("leg calf", "shin.L", "shin.L", "foot.L", (0.2, 0.35, 0.5, 0.6)),
            ("leg foot", "foot.L", "foot.L", "toe.L", (0.2, 0.4, 0.6)),
            ("pec", "chest", "chest", "upper_arm.L", (0.45, 0.55, 0.65, 0.75)),
            ("trapezius", "clavicle.L", "neck", "upper_arm.L", (0.5, 0.6, 0.75)),
            ("oblique", "spine", "spine", "upper_arm.L", (0.2, 0.15, 0.1)),
        ]},
    "greenman": {
        "file": "greenman.glb", "real": True, "clip": "2_move", "bare": "hip_L",
        "strokes": [
            ("arm upper", "hand_L", "body_up", "hand_L", (1.05, 1.2, 1.35)),
            ("arm fist", "hand_L", "body_up", "hand_L", (1.35, 1.5, 1.65)),
            ("leg shank", "leg_L", "leg_L", "hand_L", (0.0, -0.2, -0.4)),
            ("leg outer", "leg_L", "body_low", "leg_L", (1.3, 1.5, 1.7)),
            ("cheek", "body_up", "body_up", "hand_L", (0.35, 0.5, 0.65)),
            ("temple", "body_up", "socket_hat", "hand_L", (0.45, 0.55, 0.65)),
            ("brow", "body_up", "socket_hat", "hand_L", (0.15, 0.25, 0.32)),
            ("belly", "body_low", "body_low", "leg_L", (0.05, 0.25, 0.45)),
        ]},
}


def between(state, stroke, part):
    _, _, start, end, _ = stroke
    a, b = state["bones"][start], state["bones"][end]
    return [p + part * (q - p) for p, q in zip(a, b)]


def open_and_walk(t, editor, role):
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0 and role["bare"] in s["bones"])
    t.check("bones pair up, so symmetry is on", state["symmetry"]["on"] and state["symmetry"]["pairs"] > 0)
    # The numbers would lie over an arm.
    editor.click("display/numbers")
    editor.wait_until("the numbers to go", lambda s: "overlay/numbers" not in s["widgets"])
    editor.choose_clip(state["clips"].index(role["clip"]), role["clip"])
    editor.type_number("timeline/speed", "0.1")
    if not editor.state()["playing"]:
        editor.tap("space", "the clip to play", lambda s: s["playing"])
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")


def add_pair(t, editor, stroke):
    before = editor.state()
    editor.press_on_skin(stroke[1], lambda state: between(state, stroke, stroke[4][0]))
    for part in stroke[4][1:]:
        editor.move(between(editor.state(), stroke, part))
    editor.release()
    undo = before["document"]["undo"]
    state = editor.wait_until("the stroke to be a step", lambda s: s["document"]["undo"] == undo + 1)
    t.check_equal("%s: one stroke, two muscles" % stroke[0], state["document"]["primitives"],
                  before["document"]["primitives"] + 2)
    t.check("%s: the walk went on" % stroke[0], state["playing"] and state["clip_time"] != before["clip_time"])
    return state


def name_pair(t, editor, name):
    """The left one gets a name with its side; the right one gets the same with its own."""
    editor.fill("inspector/name", name + " L")
    state = editor.wait_until("the name %s L" % name, lambda s: s["document"]["selection"] == [name + " L"])
    t.check_equal("%s: the twin is named along" % name, state["symmetry"]["twin"], name + " R")


def named(role, word):
    return {"%s %s" % (stroke[0], side) for stroke in role["strokes"] for side in "LR" if stroke[0].startswith(word)}


def select_in_list(t, editor, role, word):
    """Searches the list and takes all from the first muscle found to the last."""
    editor.click("outliner/tab")
    editor.wait_until("the list", lambda s: "outliner/search" in s["widgets"])
    editor.fill("outliner/search", word)
    row = "outliner/muscle/"
    wanted = named(role, word)
    state = editor.wait_until("the muscles found by '%s'" % word, lambda s: {
        name[len(row):] for name in s["widgets"] if name.startswith(row)} == wanted)
    found = [name for name in state["widgets"] if name.startswith(row)]
    rows = sorted(found, key=lambda name: state["widgets"][name][1])
    editor.click(rows[0])
    editor.wait_until("the first of them", lambda s: s["document"]["selection"] == [rows[0][len(row):]])
    editor.click(rows[-1], held="shift")
    state = editor.wait_until("all of them", lambda s: len(s["document"]["selection"]) == len(wanted))
    t.check_equal("Shift takes what lies between", set(state["document"]["selection"]), wanted)
    # Gone again, or it would hide what comes next.
    editor.click("outliner/search")
    editor.key("ctrl+a", "BackSpace", "Return")


def type_group_name(editor, name):
    editor.wait_until("a name to be typed", lambda s: "blending/rename" in s["widgets"])
    editor.key("ctrl+a")
    editor.type(name)
    editor.key("Return")
    return editor.wait_until("the group " + name,
                             lambda s: name in s["groups"] and "blending/rename" not in s["widgets"])


def group_all(t, editor, role):
    first = list(editor.state()["groups"])
    t.check_equal("all muscles began in one group", len(first), 1)
    for word, name in (("arm ", "arms"), ("leg ", "legs")):
        select_in_list(t, editor, role, word)
        editor.click("blending/tab")
        editor.wait_until("the groups", lambda s: "blending/add" in s["widgets"])
        editor.key("ctrl+g")
        state = type_group_name(editor, name)
        t.check_equal("%s hold what was selected" % name, state["groups"][name], len(named(role, word)))
    editor.point_at(lambda: editor.widget("blending/group/" + first[0]))
    editor.xdotool("click", "--repeat", 2, "--delay", 60, driver.LEFT)
    state = type_group_name(editor, "torso")
    t.check_equal("what is left is the torso", state["groups"], group_sizes(role))


def toggle_cell(editor, a, b, links):
    editor.click("blending/cell/%s/%s" % (a, b))
    return editor.wait_until("links %s" % links,
                             lambda s: sorted(map(sorted, s["links"])) == sorted(map(sorted, links)))


def surface(t, rig, name):
    out = t.folder / name
    done = t.run_program("smooth", rig, "--depth", 2, "-o", out)
    t.check_equal("the rig makes a surface: " + done.stderr.strip(), done.returncode, 0)
    return out.read_bytes()


def keep_arms_off(t, editor, rig):
    """Linked, arms melt into the torso; linked in part less; unlinked they do not. Each is another surface."""
    toggle_cell(editor, "legs", "torso", [["legs", "torso"]])
    toggle_cell(editor, "arms", "torso", [["arms", "torso"], ["legs", "torso"]])
    editor.saved_rig()
    surfaces = [surface(t, rig, "melted.obj")]
    cell = editor.widget("blending/cell/arms/torso")
    editor.drag(cell, (cell[0] - 50, cell[1]))
    state = editor.wait_until("a link in part", lambda s: any(len(link) == 3 for link in s["links"]))
    editor.saved_rig()
    t.check_equal("the file has the amount", json.loads(rig.read_text())["links"], state["links"])
    surfaces.append(surface(t, rig, "part.obj"))
    toggle_cell(editor, "arms", "torso", [["legs", "torso"]])
    editor.saved_rig()
    surfaces.append(surface(t, rig, "apart.obj"))
    t.check_equal("three different surfaces", len(set(surfaces)), 3)


def check_file(t, role, path):
    rig = json.loads(path.read_text())
    muscles = {muscle["name"]: muscle for muscle in rig["primitives"]}
    t.check_equal("sixteen muscles, all with their names", set(muscles), named(role, ""))
    t.check_equal("the links", [sorted(link) for link in rig["links"]], [["legs", "torso"]])
    for name, bone, *_ in role["strokes"]:
        left, right = muscles[name + " L"], muscles[name + " R"]
        group = {"arm": "arms", "leg": "legs"}.get(name.split(" ")[0], "torso")
        t.check_equal(name + ": bone, twins and group",
                      (left["bone"], left["mirror"], right["mirror"], left["group"], right["group"]),
                      (bone, name + " R", name + " L", group, group))


def reopen(t, role, path):
    before = path.read_bytes()
    editor = t.edit(path)
    state = editor.wait_until("the saved rig",
                              lambda s: s["document"]["primitives"] == 16 and role["bare"] in s["bones"])
    t.check_equal("groups are there", state["groups"], group_sizes(role))
    t.check_equal("links are there", [sorted(link) for link in state["links"]], [["legs", "torso"]])
    t.check("it counts as unchanged", not state["document"]["modified"])
    editor.click("blending/tab")
    editor.click("blending/group/arms")
    editor.click("blending/select-members")
    editor.wait_until("the arms", lambda s: set(s["document"]["selection"]) == named(role, "arm "))
    editor.save_as(t.folder / "again.rig.json")
    t.check("saved again it is the same, byte for byte", (t.folder / "again.rig.json").read_bytes() == before)
    t.check_equal("quits without a question", editor.quit(), 0)


def group_sizes(role):
    sizes = {"arms": len(named(role, "arm ")), "legs": len(named(role, "leg "))}
    return {"torso": len(named(role, "")) - sum(sizes.values()), **sizes}


def story(t):
    role = CAST[sys.argv[5]]
    source = (t.characters if role["real"] else t.assets) / role["file"]
    if role["real"] and not source.is_file():
        raise driver.Skip("real characters are not at hand")
    editor = t.edit(t.copy(source))
    open_and_walk(t, editor, role)
    for stroke in role["strokes"]:
        add_pair(t, editor, stroke)
        name_pair(t, editor, stroke[0])
    path = t.folder / "story.rig.json"
    editor.save_as(path)
    group_all(t, editor, role)
    keep_arms_off(t, editor, path)
    t.check_equal("quits without a question", editor.quit(), 0)
    check_file(t, role, path)
    reopen(t, role, path)


if __name__ == "__main__":
    sys.exit(driver.run("story_" + sys.argv[5], story))
