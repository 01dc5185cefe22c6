# tests/gui/playback.py: play, pause, scrub, step, loop, speed, and the same picture for the same moment.
import sys

import driver

STEP = 1.0 / 30.0
NEAR = 1e-4
WALK, IDLE = 1.2, 3.2  # Seconds of the demo's clips.


def paused_at(editor, fraction):
    """Scrubs there by a click on the bar, from somewhere else."""
    state = editor.state()
    if not state["playing"] and state["clip_time"] > 0:
        editor.tap("ctrl+Left", "the start", lambda s: s["clip_time"] == 0)
    editor.click("timeline/scrub", along=fraction)
    return editor.wait_until("the scrubbed moment", lambda s: not s["playing"] and
                             abs(s["clip_time"] / (IDLE if s["clip"] == "Idle" else WALK) - fraction) < 0.01)


def plays_and_loops(t, editor):
    state = editor.state()
    t.check_equal("opens on its first clip, playing", (state["clip"], state["playing"]), ("Walk", True))
    before = editor.state()["clip_time"]
    states = []

    def wrapped():
        states.extend(editor.read_new())
        times = [before] + [s["clip_time"] for s in states]
        return any(b < a for a, b in zip(times, times[1:]))

    driver.wait_for("the clip to start over", wrapped)
    t.check("looping, it plays on past the end", all(s["playing"] for s in states))
    t.check("time stays within the clip", all(0.0 <= s["clip_time"] <= WALK for s in states))
    t.check("the bones move", states[0]["bones"] != states[-1]["bones"])


def pauses(t, editor):
    editor.click("timeline/play")
    stopped = editor.wait_until("a click on pause", lambda s: not s["playing"])
    editor.move((640, 300))
    editor.move((700, 320))
    t.check_equal("paused, time stands", editor.state()["clip_time"], stopped["clip_time"])
    t.check_equal("paused, the bones stand", editor.state()["bones"], stopped["bones"])
    editor.tap("space", "space to play", lambda s: s["playing"])
    later = editor.next_frames(3)[-1]
    t.check("space plays", later["clip_time"] != stopped["clip_time"])
    editor.tap("space", "space to pause", lambda s: not s["playing"])
    editor.click("timeline/play")
    editor.wait_until("a click on play", lambda s: s["playing"])
    editor.click("timeline/play")
    editor.wait_until("a click on pause again", lambda s: not s["playing"])


def scrubs(t, editor):
    first = paused_at(editor, 0.3)
    other = paused_at(editor, 0.8)
    t.check("another moment, another pose", first["bones"] != other["bones"])
    again = paused_at(editor, 0.3)
    t.check_equal("the same place on the bar, the same moment", again["clip_time"], first["clip_time"])
    t.check_equal("the same moment, the same pose", again["bones"], first["bones"])
    start, end = editor.widget("timeline/scrub", 0.2), editor.widget("timeline/scrub", 0.6)
    editor.drag(start, end)
    state = editor.wait_until("the end of the scrub", lambda s: abs(s["clip_time"] / WALK - 0.6) < 0.01)
    t.check("scrubbing pauses", not state["playing"])
    editor.tap("space", "playing", lambda s: s["playing"])
    paused_at(editor, 0.5)
    t.check("a scrub while it plays pauses it", not editor.state()["playing"])


def steps(t, editor):
    editor.click("timeline/start")
    state = editor.wait_until("the start", lambda s: s["clip_time"] == 0)
    start = state["bones"]
    for count in (1, 2):
        editor.click("timeline/next")
        editor.wait_until("%d frames on" % count, lambda s: abs(s["clip_time"] - count * STEP) < NEAR)
    t.check("the next frame, a 30th of a second on, is another pose", editor.state()["bones"] != start)
    editor.click("timeline/previous")
    editor.wait_until("one frame back", lambda s: abs(s["clip_time"] - STEP) < NEAR)
    editor.tap("period", "the period key, one on", lambda s: abs(s["clip_time"] - 2 * STEP) < NEAR)
    editor.tap("comma", "the comma key, one back", lambda s: abs(s["clip_time"] - STEP) < NEAR)
    state = editor.tap("comma", "the comma key, to the start", lambda s: abs(s["clip_time"]) < NEAR)
    t.check_equal("back at the start, the first pose", state["bones"], start)
    state = editor.tap("comma", "back over the start", lambda s: s["clip_time"] > 0.5 * WALK)
    t.check("looping, it wraps to the end", abs(state["clip_time"] - (WALK - STEP)) < NEAR, state["clip_time"])
    t.check("stepping leaves it paused", not state["playing"])


def stops_at_the_end(t, editor):
    editor.click("timeline/loop")
    paused_at(editor, 0.9)
    editor.tap("space", "playing near the end", lambda s: s["playing"])
    state = editor.wait_until("the end", lambda s: not s["playing"])
    t.check("without loop it stops at the end", abs(state["clip_time"] - WALK) < NEAR, state["clip_time"])
    states = editor.act("playing once more", lambda: editor.key("space"), lambda s: s["playing"])
    t.check("played from its end it starts over", states["clip_time"] < 0.5 * WALK, states["clip_time"])
    editor.tap("space", "pause", lambda s: not s["playing"])
    editor.key("l")
    editor.tap("space", "playing", lambda s: s["playing"])
    before = editor.state()["clip_time"]
    editor.wait_until("the L key to bring the loop back", lambda s: s["playing"] and s["clip_time"] < before)
    t.check("with the loop back it starts over and plays on", editor.next_frames(2)[-1]["playing"])
    editor.tap("space", "pause", lambda s: not s["playing"])


def rate(editor):
    """Clip seconds per second, over enough frames that the first and the last matter little."""
    states = editor.next_frames(16)
    advanced = 0.0
    for a, b in zip(states, states[1:]):
        advanced += (b["clip_time"] - a["clip_time"]) % IDLE
    return advanced / (states[-1]["seconds"] - states[0]["seconds"])


def speed(t, editor):
    editor.choose_clip(1, "Idle")
    t.check_equal("another clip starts at its start", editor.state()["clip_time"], 0)
    editor.tap("space", "playing", lambda s: s["playing"])
    usual = rate(editor)
    editor.type_number("timeline/speed", "0.25")
    editor.move((640, 300))
    slow = rate(editor)
    # Frames of a busy machine vary; a quarter is told from the whole all the same.
    t.check("at speed 1 a second is about a second", 0.6 < usual < 1.6, usual)
    t.check("at speed 0.25 it is about a quarter", 0.12 < slow < 0.45, slow)
    editor.tap("space", "pause", lambda s: not s["playing"])


def bind_pose(t, editor):
    editor.choose_clip(-1, "")
    editor.key("space")
    # The key after it has arrived, so the space has too.
    state = editor.tap("5", "the wire", lambda s: s["display"]["wire"])
    t.check("the bind pose does not play", not state["playing"] and state["clip_time"] == 0)


def story(t):
    editor = t.edit(t.copy(t.assets / "demo.glb"))
    editor.wait_until("a character", lambda s: s["triangles"] > 0)
    for act in (plays_and_loops, pauses, scrubs, steps, stops_at_the_end, speed, bind_pose):
        act(t, editor)
    t.check_equal("quits: playing changes no document", editor.quit(), 0)


if __name__ == "__main__":
    sys.exit(driver.run("playback", story))
