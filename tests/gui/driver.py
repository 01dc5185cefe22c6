# tests/gui/driver.py: the real window on a screen of its own, moved by xdotool, understood through --log-state.
"""Nothing here sleeps for effect: every wait is for a state that the editor writes, or for a file, or for an end."""
import ctypes
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from acts import Acts
from waiting import PATIENCE, Failure, Skip, wait_for
from x_messages import ask_to_close, drop_file

SCREEN = (1280, 800)
LEFT, MIDDLE, RIGHT = 1, 2, 3
SKIPPED = 77  # What CTest takes as "left out".


def die_with_parent():
    """In the child: killed when the test is, however that ends."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)


class Display:
    """An Xvfb on a number of its own choosing."""

    def __init__(self, folder, screen=SCREEN):
        read, write = os.pipe()
        self.complaints = open(folder / "xvfb.txt", "wb")
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "%dx%dx24" % screen, "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stdin=subprocess.DEVNULL, stdout=self.complaints, stderr=self.complaints,
            preexec_fn=die_with_parent)
        os.close(write)
        with os.fdopen(read) as answer:
            number = answer.readline().strip()
        if not number:
            raise Failure("Xvfb did not start; see %s" % (folder / "xvfb.txt"))
        self.name = ":" + number

    def stop(self):
        self.process.kill()
        self.process.wait()
        self.complaints.close()


class Editor(Acts):
    """One run of the editor. State is the last line of its log, as a dictionary (keys: the design's section 7)."""

    def __init__(self, scenario, file, name, arguments=()):
        self.scenario = scenario
        self.log_path = scenario.folder / (name + ".log.jsonl")
        self.log_path.write_bytes(b"")
        self.log = open(self.log_path, "rb")
        self.error_path = scenario.folder / (name + ".stderr.txt")
        with open(self.error_path, "wb") as errors:
            self.process = subprocess.Popen(
                [scenario.program, "edit", str(file), "--log-state", str(self.log_path),
                 *map(str, arguments)], env=scenario.environment,
                cwd=scenario.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors,
                preexec_fn=die_with_parent)
        self.rest = b""
        self.last = None
        self.mouse = None
        self.origin = (0, 0)  # Of the window on the screen, where it was moved away.
        self.wait_until("the first frame", lambda s: s["viewport"][2] > 0)

    # What the editor says ------------------------------------------------------------------------------------------

    def read_new(self):
        """The states logged since the last call, in order."""
        data = self.rest + self.log.read()
        *lines, self.rest = data.split(b"\n")
        states = [json.loads(line) for line in lines if line]
        if states:
            self.last = states[-1]
        return states

    def state(self):
        """The newest state there is."""
        self.read_new()
        return self.last

    def wait_until(self, what, predicate, timeout=PATIENCE):
        """The first state for which it holds: of the newest at the call and all after it."""
        found = []

        def look():
            candidates = [self.last] if self.last is not None and not found else []
            found.append(None)
            for state in candidates + self.read_new():
                if predicate(state):
                    return state
            if self.process.poll() is not None:
                raise Failure("the editor ended with %d while waiting: %s\n%s" % (
                    self.process.returncode, what, self.error_path.read_text(errors="replace")))
            return None

        return wait_for(what, look, timeout)

    def next_frames(self, count):
        """The next states that are logged. Only while something moves."""
        states = []

        def look():
            states.extend(self.read_new())
            return len(states) >= count

        self.read_new()
        wait_for("%d more frames" % count, look)
        return states

    # Hands ---------------------------------------------------------------------------------------------------------

    def xdotool(self, *arguments):
        done = subprocess.run(["xdotool", *map(str, arguments)], env=self.scenario.environment, capture_output=True,
                              text=True, timeout=PATIENCE)
        if done.returncode != 0:
            raise Failure("xdotool %s: %s" % (" ".join(map(str, arguments)), done.stderr.strip()))
        return done.stdout

    def move(self, point):
        """The pointer goes there and the editor has drawn a frame with it there."""
        x, y = round(point[0]), round(point[1])
        self.xdotool("mousemove", x + self.origin[0], y + self.origin[1])
        self.mouse = (x, y)
        self.wait_until("the pointer at %d, %d" % (x, y),
                        lambda s: abs(s["mouse"][0] - x) < 0.1 and abs(s["mouse"][1] - y) < 0.1)

    def press(self, button=LEFT):
        self.xdotool("mousedown", button)

    def release(self, button=LEFT):
        self.xdotool("mouseup", button)

    def key(self, *names):
        """Taps: down and up at once."""
        for name in names:
            self.xdotool("key", name)

    def hold(self, name):
        self.xdotool("keydown", name)

    def let_go(self, name):
        self.xdotool("keyup", name)

    def type(self, text):
        # A letter that no key has is lent one until the delay is over: a window that looks later finds the key empty.
        self.xdotool("type", "--delay", 0 if text.isascii() else 1000, "--", text)

    def widget(self, name, along=0.5):
        """Where a control is: its middle, or that part of its width."""
        box = self.wait_until("the control %s on the screen" % name, lambda s: name in s["widgets"])["widgets"][name]
        return box[0] + along * box[2], box[1] + 0.5 * box[3]

    def point_at(self, where):
        """Moves to where() and stays with it until it stands still under the pointer."""
        def aim():
            self.move(where())
            return math.dist(where(), self.mouse) < 1.5

        wait_for("a thing that stands still", aim)

    def click(self, name, along=0.5, held=None):
        """A short click in the middle of a control, with a key held down if one is named."""
        self.point_at(lambda: self.widget(name, along))
        if held:
            self.hold(held)
        self.xdotool("click", LEFT)
        if held:
            self.let_go(held)

    def drag(self, start, end, steps=4, button=LEFT):
        """Press, steps, release; a frame is seen after every step."""
        self.move(start)
        self.press(button)
        for i in range(1, steps + 1):
            self.move([a + (b - a) * i / steps for a, b in zip(start, end)])
        self.release(button)

    def window(self):
        """Its number on the display."""
        return self.xdotool("search", "--onlyvisible", "--name", ".").split()[0]

    def title(self):
        return self.xdotool("getwindowname", self.window()).strip()

    def drop(self, file):
        """A file is let go in the middle of the picture."""
        left, top, width, height = self.state()["viewport"]
        place = (left + 0.5 * width + self.origin[0], top + 0.5 * height + self.origin[1])
        drop_file(self.scenario.display.name, int(self.window()), place, file)

    def close(self):
        """As by the button of its frame."""
        ask_to_close(self.scenario.display.name, int(self.window()))

    def pixels(self, box, colors="rgb"):
        """Bytes of a part of the window (x, y, width, height) as it is on the screen: rgb or gray."""
        x, y, width, height = (round(v) for v in box)
        crop = "%dx%d+%d+%d" % (width, height, x + self.origin[0], y + self.origin[1])
        return subprocess.run(["import", "-window", "root", "-crop", crop, "+repage", "-depth", "8", colors + ":-"],
                              env=self.scenario.environment, check=True, capture_output=True, timeout=PATIENCE).stdout

    def screenshot(self, path):
        subprocess.run(["import", "-window", "root", str(path)], env=self.scenario.environment, check=True, timeout=PATIENCE)

    def wait_for_end(self):
        """The exit status of an editor that was told to quit."""
        wait_for("the editor to end", lambda: self.process.poll() is not None)
        return self.process.returncode

    def quit(self):
        self.key("ctrl+q")
        return self.wait_for_end()

    def kill(self):
        """As a crash would end it: without a word."""
        self.process.kill()
        self.process.wait()

    def stop(self):
        self.kill()
        self.log.close()


class Scenario:
    """Checks, and all that has to be ended. Arguments of every script: PROGRAM ROOT OUT CHARACTERS."""

    def __init__(self, name):
        program, root, out, characters = sys.argv[1:5]
        self.name = name
        self.program = str(pathlib.Path(program).resolve())
        self.assets = pathlib.Path(root).resolve() / "assets"
        self.characters = pathlib.Path(characters).resolve()
        self.out = pathlib.Path(out).resolve()
        self.out.mkdir(parents=True, exist_ok=True)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="sinew-gui-"))
        self.editors = []
        self.display = None
        # A home of its own: nothing of the user's is read, nothing is left there.
        self.environment = dict(os.environ, HOME=str(self.folder), XDG_CONFIG_HOME=str(self.folder / "config"),
                                XDG_STATE_HOME=str(self.folder / "state"), XDG_DATA_HOME=str(self.folder / "data"),
                                XDG_CACHE_HOME=str(self.folder / "cache"))
        self.environment.pop("WAYLAND_DISPLAY", None)
        # The driver is unloaded before leaks are sought, so that its own count as ours.
        self.environment.setdefault("ASAN_OPTIONS", "detect_leaks=0")

    def start_display(self, screen=SCREEN):
        missing = [tool for tool in ("Xvfb", "xdotool", "import", "convert") if shutil.which(tool) is None]
        if missing:
            raise Skip("no window can be driven here without " + ", ".join(missing))
        self.display = Display(self.folder, screen)
        self.environment["DISPLAY"] = self.display.name

    def copy(self, source, name=None):
        """A file to work on, in the scenario's own folder."""
        target = self.folder / (name or source.name)
        shutil.copyfile(source, target)
        return target

    @property
    def preferences(self):
        return pathlib.Path(self.environment["XDG_CONFIG_HOME"]) / "sinew" / "preferences.json"

    def prefer(self, **changes):
        """For editors that are started from here on; all else is as by default."""
        self.preferences.parent.mkdir(parents=True, exist_ok=True)
        self.preferences.write_text(json.dumps({"format": "sinew-preferences", "version": 1, **changes}))

    def edit(self, file, *arguments):
        """An editor on a file, with more arguments for it if any are named."""
        editor = Editor(self, file, "editor-%d" % (len(self.editors) + 1), arguments)
        self.editors.append(editor)
        return editor

    def run_program(self, *arguments):
        """A verb, or an editor that should refuse to start."""
        return subprocess.run([self.program, *map(str, arguments)], env=self.environment, cwd=self.folder,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=PATIENCE)

    def check(self, what, holds, seen=""):
        if not holds:
            raise Failure("%s%s" % (what, "; seen: %s" % (seen,) if seen != "" else ""))
        print("ok: " + what, flush=True)

    def check_equal(self, what, seen, wanted):
        self.check(what, seen == wanted, "%r, expected %r" % (seen, wanted))

    def keep_evidence(self):
        """What is on the screen and what was logged, for whoever looks into a failure."""
        kept = self.out / (self.name + "-failed")
        shutil.rmtree(kept, ignore_errors=True)
        kept.mkdir(parents=True)
        running = [editor for editor in self.editors if editor.process.poll() is None]
        if running:
            try:
                running[-1].process.send_signal(signal.SIGCONT)
                running[-1].screenshot(kept / "screen.png")
            except (OSError, subprocess.SubprocessError) as error:
                print("no screenshot: %s" % error)
        for path in self.folder.iterdir():
            if path.is_file():
                shutil.copyfile(path, kept / path.name)
        print("what was seen is kept in %s" % kept)

    def stop(self):
        for editor in self.editors:
            editor.stop()
        if self.display:
            self.display.stop()
        shutil.rmtree(self.folder, ignore_errors=True)


def run(name, story, screen=SCREEN):
    """Runs story(scenario) and gives the exit status: 0, 1, or SKIPPED."""
    scenario = Scenario(name)
    begun = time.monotonic()
    try:
        scenario.start_display(screen)
        story(scenario)
    except Skip as reason:
        print("left out: %s" % reason)
        return SKIPPED
    except (Failure, subprocess.SubprocessError, OSError, KeyError) as failure:
        print("FAILED: %s: %s" % (type(failure).__name__, failure), flush=True)
        scenario.keep_evidence()
        return 1
    finally:
        scenario.stop()
    print("done in %.1f s" % (time.monotonic() - begun))
    return 0
