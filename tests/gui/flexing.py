# tests/gui/flexing.py: a muscle drawn across a joint stretches and flexes; its ends are pulled while a clip plays.
# Usage: flexing.py PROGRAM ROOT OUT CHARACTERS humanoid|fox
import sys

import driver

# Upper bone, lower bone, its end, where on the upper one the press is, a clip.
CHARACTERS = {"humanoid": ("upper_arm.L", "forearm.L", "hand.L", 0.2, "Flex"),
              "fox": ("b_LeftLeg01_015", "b_LeftLeg02_016", "b_LeftFoot01_017", 0.6, "Run")}


def between(state, a, b, share):
    return [x + share * (y - x) for x, y in zip(state["bones"][a], state["bones"][b])]


def draw_line(t, editor, upper, lower, tip, at):
    """From the upper bone's skin to the lower one's."""
    editor.palette("add flexing", "tool/muscle-line")
    state = editor.state()
    start, end = between(state, upper, lower, at), between(state, lower, tip, 0.3)
    editor.move(start)
    editor.press()
    for share in (0.3, 0.6, 1.0):
        editor.move([a + share * (b - a) for a, b in zip(start, end)])
    editor.wait_until("both ends named", lambda s: s["status"].startswith("From ") and " to " in s["status"])
    editor.release()
    state = editor.wait_until("a muscle", lambda s: s["document"]["undo"] == 1 and s["line"].get("stretch"))
    t.check("it is at rest in the bind pose", abs(state["line"]["stretch"] - 1.0) < 1e-4, state["line"])
    t.check("and loose", state["line"]["activation"] == 0, state["line"])
    line = editor.saved_rig()["lines"][0]
    t.check_equal("it ends on the lower bone", line["insertion"]["bone"], lower)
    # Skin over a short bone may follow the one above.
    t.check("and begins on another", line["origin"]["bone"] != lower, line["origin"])


def flex(t, editor):
    """By the slider's key, held."""
    editor.hold("shift")
    editor.xdotool("keydown", "f")
    state = editor.wait_until("a flexed muscle", lambda s: s["flex"] == 1)
    t.check_equal("fully active", state["line"]["activation"], 1)
    editor.xdotool("keyup", "f")
    editor.let_go("shift")
    editor.wait_until("a loose one again", lambda s: s["flex"] == 0)


def learn(t, editor):
    editor.click("inspector/line/learn")
    editor.wait_until("a step", lambda s: s["document"]["undo"] == 2)
    full = editor.saved_rig()["lines"][0].get("activation", {}).get("full", 0.75)
    t.check("full contraction is where the clips take it", 0.3 < full < 0.99 and full != 0.75, full)


def play(t, editor, clip):
    """At a tenth of the speed, so that what is aimed at is still there."""
    editor.type_number("timeline/speed", "0.1")
    names = editor.state()["clips"]
    editor.choose_clip(names.index(clip), clip)
    if not editor.state()["playing"]:
        editor.tap("space", "it plays", lambda s: s["playing"])
    before = editor.state()["line"]["stretch"]
    editor.wait_until("the line to change its length", lambda s: abs(s["line"]["stretch"] - before) > 0.002)


def pull_end(t, editor, end):
    undo = editor.state()["document"]["undo"]
    muscle = editor.saved_rig()["primitives"][0]["name"]
    point = editor.saved_rig()["lines"][0][end]["point"]

    def aimed():
        place = editor.state()["line"]["ends"].get(end)
        if place is None:
            return False
        editor.move(place)
        return editor.state()["line"]["hovered"] == end

    def pulled():
        driver.wait_for("the %s under the pointer" % end, aimed)
        editor.press()
        if editor.settle()["line"]["dragging"]:
            return True
        editor.release()  # It had moved on: the press picked or turned something else.
        editor.settle()
        editor.click("outliner/muscle/" + muscle)
        editor.wait_until("the muscle again", lambda s: s["document"]["selection"] == [muscle])
        return False

    driver.wait_for("a pull of the " + end, pulled)
    start = editor.mouse
    editor.move((start[0] + 4, start[1] + 9))
    editor.release()
    editor.wait_until("a step", lambda s: s["document"]["undo"] == undo + 1 and not s["line"]["dragging"])
    moved = editor.saved_rig()["lines"][0][end]["point"]
    t.check("the %s has moved, in bone space" % end, moved != point, moved)


def flexing(t):
    which = sys.argv[5]
    upper, lower, tip, at, clip = CHARACTERS[which]
    source = t.assets / "humanoid.glb" if which == "humanoid" else t.characters / "Fox.glb"
    if not source.exists():
        raise driver.Skip("real characters are not at hand")
    editor = t.edit(t.copy(source))
    editor.wait_until("a character", lambda s: upper in s["bones"])
    editor.choose_clip(-1, "")
    path = t.folder / "flex.rig.json"
    editor.save_as(path)
    before = path.read_bytes()
    draw_line(t, editor, upper, lower, tip, at)
    editor.screenshot(t.out / ("flexing_%s.png" % which))
    flex(t, editor)
    learn(t, editor)
    editor.tap("w", "the move tool", lambda s: s["gizmo"]["mode"] == "move")
    editor.click("inspector/line/via")
    editor.wait_until("a via point", lambda s: "via point" in s["line"]["ends"])
    play(t, editor, clip)
    pull_end(t, editor, "origin")
    pull_end(t, editor, "insertion")
    editor.tap("space", "it stands", lambda s: not s["playing"])
    for undo in range(editor.state()["document"]["undo"] - 1, -1, -1):
        editor.tap("ctrl+z", "undo to %d" % undo, lambda s: s["document"]["undo"] == undo)
    editor.saved_rig()
    t.check("all undone, the file is what it was", path.read_bytes() == before)


if __name__ == "__main__":
    sys.exit(driver.run("flexing_" + sys.argv[5], flexing))
