# tests/gui/keyboard.py: through the window by Tab, arrows, Space and Enter, and back by Esc.
# Usage: keyboard.py PROGRAM ROOT OUT CHARACTERS
import sys

import driver


def focus(editor, control, key="Tab"):
    """Until the ring is on the control."""
    for _ in range(30):
        if editor.state()["focus"] == control:
            return
        editor.taps(*[key] * 8)
        editor.settle()
        for _ in range(9):
            if editor.state()["focus"] == control:
                return
            before = editor.state()["focus"]
            editor.tap("shift+" + key, "the control before", lambda s: s["focus"] != before)
        editor.taps(*[key] * 9)
        editor.settle()
    raise driver.Failure("Tab does not come to " + control)


def keyboard(t):
    editor = t.edit(t.assets / "humanoid.rig.json", *(["--scale", t.scale] if t.scale != 1 else []))
    editor.wait_until("a character", lambda s: s["document"]["primitives"] > 10)
    editor.tap("space", "a pause", lambda s: not s["playing"])
    state = editor.tap("Tab", "the ring", lambda s: s["focus"])
    t.check_equal("first the menus", state["focus"], "menu/file")
    seen = [state["focus"]]
    for _ in range(7):
        editor.tap("ctrl+Tab", "the next panel", lambda s: s["focus"] not in ("", seen[-1]))
        seen.append(editor.state()["focus"])
    t.check("all panels have their turn", {"outliner/tab", "inspector/header", "timeline/clip"} <= set(seen), seen)
    editor.screenshot(t.out / "keyboard_panels.png")
    focus(editor, "toolstrip/rotate")
    editor.screenshot(t.out / "keyboard_tool.png")
    editor.tap("space", "the tool", lambda s: s["tool"] == "rotate" and not s["playing"])
    editor.tap("Down", "the next tool's button", lambda s: s["focus"] == "toolstrip/scale")
    editor.tap("Return", "the next tool", lambda s: s["tool"] == "scale")
    editor.palette("tightness", "control/surface/iso")
    editor.wait_until("the slider", lambda s: s["focus"] == "surface/iso")
    editor.tap("Return", "typing", lambda s: True)
    editor.type("0.3")
    editor.tap("Return", "a step", lambda s: s["document"]["undo"] == 1)
    editor.settle()
    editor.screenshot(t.out / "keyboard_slider.png")
    editor.tap("Escape", "no ring", lambda s: s["focus"] == "")
    editor.tap("space", "the clip again", lambda s: s["playing"])


if __name__ == "__main__":
    driver.Scenario.scale = 1
    sys.exit(driver.run("keyboard", keyboard))
