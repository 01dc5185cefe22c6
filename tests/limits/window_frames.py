# tests/limits/window_frames.py: frames of the real window in clay and in the anatomy view, while the eye or the clip moves.
# Usage: window_frames.py PROGRAM [RIG...]     a minute; needs Xvfb and xdotool, as the GUI tests do
"""Not a test of ctest: times depend on what else the machine does. Both views take turns, so that both see the same machine.
All numbers are from the log that the editor writes (--log-state). While something moves the editor may draw fewer pixels
(app/window/picture.h); how many is printed too. Exit status 1 where anatomy's frame is more than 3 times clay's."""
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "gui"))
import driver  # noqa: E402

RIGS = ("humanoid-flex", "horse-flex")
VIEWS = ("clay", "anatomy")
TURNS = 4      # Of each view.
FRAMES = 50    # Of each turn; the first ones, in which the resolution is found, are not counted.
SETTLING = 15
MOST = 3.0     # Times clay's frame.


def show(editor, view):
    wanted = view == "anatomy"
    if editor.state()["display"]["anatomy"] != wanted:
        editor.tap("v", view, lambda s: s["display"]["anatomy"] == wanted)


def moved_frames(editor, value, going):
    """States of frames in which a value became another one, while something is going on."""
    states, before = [], value(editor.state())
    while len(states) < FRAMES:
        if not going():
            raise driver.Failure("it has stopped after %d frames" % len(states))
        for state in editor.next_frames(1):
            if value(state) != before:
                states.append(state)
            before = value(state)
    return states


def playing(editor):
    """The clip plays."""
    editor.tap("space", "the clip to play", lambda s: s["playing"])
    states = moved_frames(editor, lambda s: s["clip_time"], lambda: True)
    editor.tap("space", "the pause", lambda s: not s["playing"])
    return states


def turning(editor):
    """A drag beside the character: the eye goes around it, back and forth, three pixels at a time."""
    x, y, width, height = editor.state()["viewport"]
    place = lambda i: (round(x + 0.75 * width) + 3 * abs(i % 60 - 30), round(y + 0.25 * height))  # noqa: E731
    editor.move(place(0))
    editor.press()
    steps = []
    for i in range(1, 100 * FRAMES):  # More than are waited for.
        steps += ["mousemove", *map(str, place(i)), "sleep", "0.008"]
    hand = subprocess.Popen(["xdotool", *steps], env=editor.scenario.environment)
    states = moved_frames(editor, lambda s: s["camera"]["yaw"], lambda: hand.poll() is None)
    hand.kill()
    hand.wait()
    editor.release()
    return states


def measure(editor, what):
    """{view: (ms of a frame, pixels drawn for one of the window)}: lower quartile of the times, which is less of what else
    the machine does, and median of the pixels."""
    times, pixels = {view: [] for view in VIEWS}, {view: [] for view in VIEWS}
    for _ in range(TURNS):
        for view in VIEWS:
            show(editor, view)
            states = what(editor)[SETTLING:]
            times[view] += [1e3 * (b["seconds"] - a["seconds"]) for a, b in zip(states, states[1:])]
            pixels[view] += [state["picture_scale"] ** 2 for state in states]
    return {view: (statistics.quantiles(times[view], n=4)[0], statistics.median(pixels[view])) for view in VIEWS}


def story(t):
    told = []
    for rig in t.rigs:
        t.copy(t.assets / (rig.split("-")[0] + ".glb"))
        editor = t.edit(t.copy(t.assets / (rig + ".rig.json")))
        editor.wait_until("the character", lambda s: s["triangles"] > 0 and s["clips"])
        if editor.state()["playing"]:
            editor.tap("space", "the pause", lambda s: not s["playing"])
        editor.key("2")
        for what in (turning, playing):
            told.append((rig, what.__name__, measure(editor, what)))
        editor.kill()
    print("%-14s %-8s %-8s %6s %9s %7s %6s" % ("rig", "moves", "view", "ms", "a second", "pixels", "times"))
    slow = False
    for rig, what, figures in told:
        for view in VIEWS:
            frame, pixels = figures[view]
            times = frame / figures["clay"][0]
            slow = slow or times > MOST
            print("%-14s %-8s %-8s %6.1f %9.1f %6.0f%% %6.2f" % (rig, what, view, frame, 1e3 / frame, 100 * pixels, times))
    t.check("the anatomy view's frame takes at most %.0f times clay's" % MOST, not slow)


def main():
    program, *rigs = sys.argv[1:]
    driver.Scenario.rigs = rigs or RIGS
    with tempfile.TemporaryDirectory() as out:
        sys.argv[1:] = [program, str(ROOT), out, str(ROOT / "assets")]
        return driver.run("window_frames", story)


if __name__ == "__main__":
    sys.exit(main())
