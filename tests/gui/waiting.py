# tests/gui/waiting.py: waits for what is to happen, and what is raised when it does not.
import time

PATIENCE = 60.0  # Seconds that any one wait may take: generous, the picture is drawn in software on a shared machine.
POLL = 0.004


class Failure(Exception):
    """A check did not hold, or what was waited for did not come."""


class Skip(Exception):
    """The scenario cannot run here; the text says why."""


def wait_for(what, condition, timeout=PATIENCE):
    """Until condition() is true (returned) or the patience is over."""
    end = time.monotonic() + timeout
    while True:
        found = condition()
        if found:
            return found
        if time.monotonic() > end:
            raise Failure("waited %.0f s in vain: %s" % (timeout, what))
        time.sleep(POLL)
