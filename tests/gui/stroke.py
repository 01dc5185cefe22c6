# tests/gui/stroke.py: a muscle drawn along a walking thigh; the pose is held while the button is down.
import math
import sys
import time

import bind_pose
import driver
import rigs

BONE, NEXT = "thigh.L", "shin.L"
WALK = 1.1        # Seconds of the clip.
SPEED = 0.1       # On a slow machine the thigh would be elsewhere before the press arrives.
SECONDS = 1.0     # What the stroke takes at least,
MOVES = 8         # in so many moves.
FROM = 0.3        # Of the way from the hip to the knee.
LENGTH = 0.45     # Of the thigh.
MOST_DEGREES = 15.0


def thigh(state):
    """(hip, hip to knee) on the screen."""
    hip, knee = state["bones"][BONE], state["bones"][NEXT]
    return hip, [b - a for a, b in zip(hip, knee)]


def press_on_thigh(editor):
    def start(state):
        hip, way = thigh(state)
        return [a + FROM * b for a, b in zip(hip, way)]

    return editor.press_on_skin(BONE, start)


def draw(editor, held):
    """Moves along the thigh for a second, as a hand does. The states seen on the way."""
    _, way = thigh(held)
    start = editor.mouse
    begun = time.monotonic()
    states = []
    for step in range(1, MOVES + 1):
        share = step / MOVES
        editor.move([a + share * LENGTH * b for a, b in zip(start, way)])
        states.append(editor.state())
        driver.wait_for("the time of a move", lambda: time.monotonic() >= begun + share * SECONDS)
    return states


def check_held(t, held, states):
    t.check_equal("the clip time stands while the button is down", {s["clip_time"] for s in states}, {held["clip_time"]})
    t.check_equal("the bones stand as well", [s for s in states if s["bones"] != held["bones"]], [])
    t.check("it still counts as playing", all(s["playing"] for s in states))
    t.check("the status line says so", "the pose is held" in states[-1]["status"], states[-1]["status"])


def check_goes_on(t, editor, ended, since):
    """Playing goes on from where it was held, by no more than the time since then: the frame that ends a stroke may be slow."""
    state = editor.wait_until("the clip to go on", lambda s: s["clip_time"] != ended["clip_time"])
    t.check("it still plays", state["playing"])
    passed = (state["clip_time"] - ended["clip_time"]) % WALK
    t.check("from the time at which it was held", passed < 1.5 * SPEED * (state["seconds"] - since) + 0.01, passed)


def stroke_while_walking(t, editor):
    undo = editor.state()["document"]["undo"]
    held = press_on_thigh(editor)
    states = draw(editor, held)
    check_held(t, held, states)
    editor.release()
    ended = editor.wait_until("the stroke to be a step", lambda s: s["document"]["undo"] == undo + 1)
    t.check_equal("released, the clip has not moved yet", ended["clip_time"], held["clip_time"])
    check_goes_on(t, editor, ended, states[-1]["seconds"])


def check_muscle(t, file, muscle):
    t.check_equal("it is on the thigh", muscle["bone"], BONE)
    bones = bind_pose.bones_in_bind(file)
    knee = [row[3] for row in bind_pose.matrix_product(bind_pose.affine_inverse(bones[BONE]), bones[NEXT])[:3]]
    length = math.hypot(*knee)
    axis = rigs.turned(muscle["rotation"], [1.0, 0.0, 0.0])
    cosine = abs(sum(a * b for a, b in zip(axis, knee))) / length
    degrees = math.degrees(math.acos(min(cosine, 1.0)))
    t.check("it lies along the thigh, as it was drawn", degrees < MOST_DEGREES, degrees)
    share = 2.0 * muscle["radii"][0] / length
    t.check("it is as long as it was drawn", abs(share - LENGTH) < 0.12, share)


def cancels(t, editor):
    """Esc and the right button, in the middle of a stroke."""
    for name, cancel in (("Esc", lambda: editor.key("Escape")),
                         ("the right button", lambda: editor.xdotool("click", driver.RIGHT))):
        before = editor.state()["document"]
        held = press_on_thigh(editor)
        _, way = thigh(held)
        editor.move([a + 0.2 * b for a, b in zip(editor.mouse, way)])
        before_end = editor.state()
        t.check_equal(name + ": held until then", before_end["clip_time"], held["clip_time"])
        cancel()
        state = editor.wait_until(name + " to take it back", lambda s: s["document"]["primitives"] == before["primitives"])
        t.check_equal(name + " leaves no trace", state["document"], before)
        check_goes_on(t, editor, {**state, "clip_time": held["clip_time"]}, before_end["seconds"])
        editor.release()


def story(t):
    file = t.copy(t.assets / "humanoid.glb")
    editor = t.edit(file)
    state = editor.wait_until("a character", lambda s: s["triangles"] > 0 and BONE in s["bones"])
    editor.choose_clip(state["clips"].index("Walk"), "Walk")
    if not editor.state()["playing"]:
        editor.tap("space", "the clip to play", lambda s: s["playing"])
    editor.type_number("timeline/speed", str(SPEED))
    editor.one_sided()
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")
    cancels(t, editor)
    stroke_while_walking(t, editor)
    editor.save_as(t.folder / "stroke.rig.json")
    editor.screenshot(t.out / "stroke.png")
    check_muscle(t, file, rigs.only_primitive(editor.saved_rig()))
    t.check_equal("quits without a question", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("stroke", story))
