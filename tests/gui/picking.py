# tests/gui/picking.py: a click takes what is seen, further clicks what lies behind; the picture's context menu.
import sys

import driver

# File, and where a muscle on each side of the trunk is put: the middle of two bones, seen from two opposite sides.
PLACES = {
    "demo": ("demo.glb", ("spine", "chest"), ("KP_1", "ctrl+KP_1")),
    "fox": ("Fox.glb", ("b_Spine02_03", "b_Spine01_02"), ("KP_3", "ctrl+KP_3")),
    "robot": ("robot.glb", ("Abdomen", "Torso"), ("KP_1", "ctrl+KP_1")),
    "cesium_man": ("cesium_man.gltf", ("joint 1", "joint 2"), ("KP_3", "ctrl+KP_3")),
}


def middle(editor, bones):
    at = editor.state()["bones"]
    return [0.5 * (a + b) for a, b in zip(at[bones[0]], at[bones[1]])]


def look(editor, key):
    """From that side, standing still."""
    editor.key(key)
    editor.settle()
    editor.wait_until("the camera at rest", lambda s: not s["camera_moving"])
    editor.settle()


def click(editor, place):
    editor.move(place)
    editor.xdotool("click", driver.LEFT)
    editor.settle()


def right_click(editor, place):
    editor.move(place)
    editor.xdotool("click", driver.RIGHT)


def muscle_from(editor, side, bones):
    """A short stroke of the muscle tool on the skin of that side; its name."""
    look(editor, side)
    editor.tap("m", "the muscle tool", lambda s: s["tool"] == "add muscle")
    count = editor.state()["document"]["primitives"]
    x, y = middle(editor, bones)
    editor.move((x, y))
    editor.wait_until("skin under the pointer", lambda s: "grows on" in s["status"])
    editor.drag((x - 6, y), (x + 6, y))
    state = editor.wait_until("a muscle on the skin", lambda s: s["document"]["primitives"] == count + 1)
    editor.tap("q", "the select tool", lambda s: s["tool"] == "select")
    return state["document"]["selection"][0]


def nothing_selected(editor):
    editor.tap("Escape", "nothing selected", lambda s: not s["document"]["selection"])


def clicks(t, editor, bones, sides, front, back):
    """From either side the muscle of that side first, then the other, then the first again."""
    for side, own, other in ((sides[0], front, back), (sides[1], back, front)):
        look(editor, side)
        nothing_selected(editor)
        place = middle(editor, bones)
        seen = []
        for turn in (1, 2, 3):
            click(editor, place)
            number = (turn - 1) % 2 + 1
            wanted = [own] if number == 1 else [other]
            state = editor.wait_until("click %d at one place to select %s" % (turn, wanted),
                                      lambda s: s["document"]["selection"] == wanted)
            seen.append("%d of 2 here" % number in state["status"])
        t.check("from %s: its own muscle, the one behind, its own again, and the status line counts" % side, all(seen), seen)


def through_the_body(t, editor, bones, sides, front, back):
    """Where the near side has no muscle, a click takes the bone, not the muscle of the far side."""
    look(editor, sides[0])
    nothing_selected(editor)
    click(editor, middle(editor, bones))
    editor.wait_until("the near muscle", lambda s: s["document"]["selection"] == [front])
    editor.tap("Delete", "it to be gone", lambda s: s["document"]["primitives"] == 1)
    click(editor, middle(editor, bones))
    state = editor.wait_until("the click to select a bone", lambda s: s["document"]["bone"])
    t.check_equal("nothing is taken through the body", state["document"]["selection"], [])
    editor.tap("ctrl+z", "the near muscle again", lambda s: s["document"]["primitives"] == 2)


def while_it_plays(t, editor, bones, sides, front, back):
    look(editor, sides[0])
    nothing_selected(editor)
    editor.type_number("timeline/speed", "0.1")  # At full speed a step turns what lies behind out of the way.
    editor.tap("space", "the clip to play", lambda s: s["playing"])
    place = middle(editor, bones)
    for wanted in (front, back, front):
        click(editor, place)
        editor.wait_until("%s while the clip plays" % wanted, lambda s: s["document"]["selection"] == [wanted])
    editor.tap("space", "the clip to pause", lambda s: not s["playing"])
    t.check("cycling goes on while the clip plays", True)


def menu(t, editor, bones, sides, front, back):
    look(editor, sides[1])
    nothing_selected(editor)
    place = middle(editor, bones)
    right_click(editor, place)
    state = editor.wait_until("the context menu", lambda s: "context/title" in s["widgets"])
    t.check_equal("it is about the muscle under the pointer", state["document"]["selection"], [back])
    editor.tap("Escape", "Esc to close it", lambda s: "context/title" not in s["widgets"])
    t.check_equal("and nothing else", editor.state()["document"]["selection"], [back])
    right_click(editor, place)
    editor.move(editor.widget("context/select"))  # Opens it; it is then no control to be pointed at again.
    editor.click("context/select/" + front)
    editor.wait_until("the other of the two", lambda s: s["document"]["selection"] == [front])
    right_click(editor, place)
    editor.click("context/view/isolate")
    state = editor.wait_until("isolation", lambda s: s["visibility"]["isolated"] == [front])
    editor.tap("slash", "its end", lambda s: s["visibility"]["isolated"] is None)
    right_click(editor, place)
    editor.click("context/edit/duplicate")
    editor.wait_until("a copy", lambda s: s["document"]["primitives"] == 3)
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["primitives"] == 2)
    right_click(editor, place)
    editor.click("context/add-here")
    editor.wait_until("a muscle where the menu was opened", lambda s: s["document"]["primitives"] == 3)
    editor.tap("ctrl+z", "undo", lambda s: s["document"]["primitives"] == 2)
    before = editor.state()["bones"][bones[0]]
    editor.drag(place, (place[0] + 60, place[1] + 20), button=driver.RIGHT)
    editor.settle()
    state = editor.state()
    t.check("a drag with the right button pans and opens nothing",
            "context/title" not in state["widgets"] and abs(state["bones"][bones[0]][0] - before[0]) > 30,
            (before, state["bones"][bones[0]]))


def story(t):
    name = sys.argv[5]
    file, bones, sides = PLACES[name]
    source = (t.assets if name == "demo" else t.characters) / file
    if not source.exists():
        raise driver.Skip("no %s here" % source)
    editor = t.edit(t.copy(source))
    editor.wait_until("a character", lambda s: bones[0] in s["bones"])
    editor.one_sided()
    if editor.state()["playing"]:
        editor.tap("space", "the clip to pause", lambda s: not s["playing"])
    clip = editor.state()["clip"]
    if clip:
        editor.choose_clip(-1, "")
    front, back = (muscle_from(editor, side, bones) for side in sides)
    editor.tap("8", "all muscles shown", lambda s: s["display"]["primitives"])
    clicks(t, editor, bones, sides, front, back)
    through_the_body(t, editor, bones, sides, front, back)
    menu(t, editor, bones, sides, front, back)
    if name == "demo":
        editor.choose_clip(0, clip)
        if editor.state()["playing"]:
            editor.tap("space", "the clip to pause", lambda s: not s["playing"])
        while_it_plays(t, editor, bones, sides, front, back)
    t.check_equal("the editor ends well", (editor.key("ctrl+q"), editor.click("unsaved/discard"), editor.wait_for_end())[2], 0)


if __name__ == "__main__":
    sys.exit(driver.run("picking_" + sys.argv[5], story))
