# tests/gui/palette.py: Ctrl+P leads to muscles, controls and pages; pages open in the desktop's viewer.
# Usage: palette.py PROGRAM ROOT OUT CHARACTERS
import sys

import driver

MARKED = {"tightness": ("control/surface/iso", "surface/iso"), "reach": ("control/inspector/reach", "inspector/reach")}


def palette(t):
    tools, noted = t.folder / "tools", t.folder / "opened"
    tools.mkdir()
    (tools / "xdg-open").write_text("#!/bin/sh\necho \"$1\" >> '%s'\n" % noted)
    (tools / "xdg-open").chmod(0o755)
    t.environment["PATH"] = "%s:%s" % (tools, t.environment["PATH"])
    editor = t.edit(t.assets / "humanoid-flex.rig.json")
    editor.wait_until("a character", lambda s: s["document"]["primitives"] > 10)
    editor.tap("space", "a pause", lambda s: not s["playing"])
    editor.palette("opening a char", "page/opening")
    driver.wait_for("the page", lambda: noted.exists() and noted.read_text().endswith("docs/editor.md\n"))
    editor.palette("biceps L", "muscle/biceps L")
    editor.key("n")
    editor.wait_until("no panels at the right", lambda s: "surface/iso" not in s["widgets"])
    for words, (entry, control) in MARKED.items():
        editor.palette(words, entry)
        state = editor.wait_until("the control", lambda s: s["focus"] == control and control in s["widgets"])
        editor.screenshot(t.out / ("palette_%s.png" % words))
        t.check("nothing but the selection has changed", state["document"]["undo"] == 0, state["document"])
    t.check_equal("no message", editor.state()["messages"], [])


if __name__ == "__main__":
    sys.exit(driver.run("palette", palette))
