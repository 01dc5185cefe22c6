#!/usr/bin/env python3
# docs/window_rate.py: pictures a second in the real window, 1280 x 800 on a screen of its own, playing the first clip.
# Usage: docs/window_rate.py SINEW FILE...   SINEW: the program; FILE: rigs or characters. Needs what the GUI tests need.
import pathlib
import statistics
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "gui"))
import driver  # noqa: E402

WARM, SPAN, SPANS = 4.0, 2.0, 5  # Seconds; how many spans are counted.


def rates(editor):
    """Of each span, after the first seconds."""
    editor.wait_until("the clip to play", lambda s: s["playing"])
    time.sleep(WARM)
    out = []
    first = editor.next_frames(1)[-1]
    for _ in range(SPANS):
        time.sleep(SPAN)
        last = editor.next_frames(1)[-1]
        out.append((last["frame"] - first["frame"]) / (last["seconds"] - first["seconds"]))
        first = last
    return out, first["triangles"]


def story(t):
    for file in files:
        editor = t.edit(file)
        seen, triangles = rates(editor)
        print("%-28s %6d triangles  %.1f pictures a second (%.1f to %.1f)" % (
            file.name, triangles, statistics.median(seen), min(seen), max(seen)), flush=True)
        editor.stop()


if len(sys.argv) < 3:
    sys.exit("usage: docs/window_rate.py SINEW FILE...")
files = [pathlib.Path(name).resolve() for name in sys.argv[2:]]
sys.argv[1:] = [sys.argv[1], str(ROOT), tempfile.gettempdir(), str(ROOT)]
sys.exit(driver.run("window_rate", story))
