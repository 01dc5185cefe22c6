# tests/gui/clips.py: clips of other files in the window: added, dropped, played, taken back, saved, gone, located.
# Usage: clips.py PROGRAM ROOT OUT CHARACTERS
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import driver
from clip_gltf import write_clips, write_still


def added_from_the_menu(t, editor):
    editor.click("menu/file")
    editor.click("file/add-clips")
    editor.wait_until("the dialog", lambda s: s["dialog"] == "open" and "dialog/path" in s["widgets"])
    editor.settle()
    editor.screenshot(t.out / "clips_dialog.png")
    editor.fill("dialog/path", "walk.glb")
    state = editor.wait_until("its first clip to play", lambda s: s["clip"] == "Walk" and s["playing"] and s["dialog"] == "")
    t.check_equal("its clips", state["clips"], ["Walk", "Dance"])
    t.check_equal("one step", state["document"]["undo"], 1)
    bones = state["bones"]
    editor.wait_until("the body to move", lambda s: s["bones"] and s["bones"] != bones)


def dropped(t, editor):
    editor.drop(t.folder / "lizard.glb")
    state = editor.wait_until("a clip of a relative's", lambda s: s["clip"] == "Crawl" and s["playing"])
    t.check_equal("nothing is asked", state["dialog"], "")
    editor.wait_until("what did not match", lambda s: "clip-files/file/1" in s["widgets"])
    editor.key("space")
    editor.settle()
    editor.screenshot(t.out / "clips_list.png")
    editor.click("clip-files/close")
    editor.click("timeline/clip")
    editor.widget("timeline/clip/add")
    editor.settle()
    editor.screenshot(t.out / "clips_picker.png")
    editor.click("timeline/clip/2")
    editor.wait_until("the list to close", lambda s: "timeline/clip/add" not in s["widgets"])


def taken_back(t, editor):
    state = editor.tap("ctrl+z", "the file to go", lambda s: s["document"]["undo"] == 1 and s["clips"] == ["Walk", "Dance"])
    t.check_equal("a walk shows instead", state["clip"], "Walk")
    editor.choose_clip(1, "Dance")
    editor.tap("ctrl+shift+z", "the file to come back", lambda s: s["clips"] == ["Walk", "Dance", "Crawl"])
    t.check_equal("what showed goes on", editor.state()["clip"], "Dance")


def asked(t, editor):
    """Another character, with muscles to keep."""
    editor.select_bone("thigh.L")
    editor.tap("ctrl+m", "a muscle", lambda s: s["document"]["primitives"] > 0)
    steps = editor.state()["document"]["undo"]
    editor.drop(t.copy(t.assets / "demo.glb"))
    editor.wait_until("the question", lambda s: s["dialog"] == "keep-muscles")
    editor.settle()
    editor.screenshot(t.out / "clips_question.png")
    editor.click("keep-muscles/clips")
    state = editor.wait_until("the clips", lambda s: s["dialog"] == "" and s["document"]["undo"] == steps + 1)
    t.check_equal("this character plays them", state["clips"], ["Walk", "Dance", "Crawl", "Walk 2", "Idle"])
    editor.tap("ctrl+z", "them to go", lambda s: len(s["clips"]) == 3)


def saved_and_gone(t, editor):
    path = t.folder / "rigs" / "hero.rig.json"
    path.parent.mkdir()
    editor.save_as(path)
    t.check_equal("the files by their paths from there", json.loads(path.read_text())["clips"], ["../walk.glb", "../lizard.glb"])
    t.check_equal("quits", editor.quit(), 0)
    (t.folder / "walk.glb").rename(t.folder / "rigs" / "stroll.glb")
    again = t.edit(path)
    state = again.wait_until("the list of files", lambda s: "clip-files/locate/0" in s["widgets"])
    t.check_equal("the rest is there", state["clips"], ["Crawl"])
    t.check("a message says which is gone", any("walk.glb" in message for message in state["messages"]), state["messages"])
    t.check("nothing has changed", not state["document"]["modified"])
    again.settle()
    again.screenshot(t.out / "clips_gone.png")
    again.click("clip-files/locate/0")
    again.fill("dialog/path", "stroll.glb")
    again.wait_until("its clips", lambda s: s["clips"] == ["Walk", "Dance", "Crawl"] and s["dialog"] == "")
    t.check_equal("the new path", again.saved_rig()["clips"], ["stroll.glb", "../lizard.glb"])
    again.click("clip-files/remove/1")
    again.wait_until("the other to go", lambda s: s["clips"] == ["Walk", "Dance"])
    t.check_equal("and removed", again.saved_rig()["clips"], ["stroll.glb"])
    t.check_equal("quits again", again.quit(), 0)


def clips(t):
    man = t.assets / "humanoid.glb"
    write_clips(man, t.folder / "walk.glb", {"Walk": "Walk", "Dance": "Dance"})
    write_clips(t.assets / "demo.glb", t.folder / "lizard.glb", {"Walk": "Crawl"})
    editor = t.edit(write_still(man, t.folder / "still.glb"))
    editor.wait_until("a character without a clip", lambda s: "head" in s["bones"] and s["clips"] == [])
    added_from_the_menu(t, editor)
    dropped(t, editor)
    taken_back(t, editor)
    asked(t, editor)
    saved_and_gone(t, editor)


if __name__ == "__main__":
    sys.exit(driver.run("clips", clips))
