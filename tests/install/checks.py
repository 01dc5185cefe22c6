# tests/install/checks.py: commands that have to succeed, and what has to hold.
import subprocess


def run(*command, **more):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **more)
    if done.returncode != 0:
        raise SystemExit("%s\nexit %d\n%s%s" % (" ".join(map(str, command)), done.returncode, done.stdout, done.stderr))
    return done.stdout


def check(what, holds, seen=""):
    if not holds:
        raise SystemExit("FAILED: %s; seen: %s" % (what, seen))
    print("ok: " + what, flush=True)
