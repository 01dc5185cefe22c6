# tests/gui/shapes.py: a face's shapes in the window: dragged, typed, driven by the turn of the head, saved, opened again.
# Usage: shapes.py PROGRAM ROOT OUT CHARACTERS
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import driver
from face_gltf import write_face


def shapes(t):
    editor = t.edit(pathlib.Path(write_face(t.folder / "face.glb")))
    editor.wait_until("a character", lambda s: "head" in s["bones"])
    editor.save_as(t.folder / "face.rig.json")
    editor.key("space")
    editor.click("shapes/tab")
    editor.settle()
    x, y = editor.widget("shapes/smile")
    editor.drag((x - 30, y), (x + 40, y))
    editor.wait_until("one step", lambda s: s["document"]["undo"] == 1)
    editor.settle()
    editor.screenshot(t.out / "shapes.png")
    rig = editor.saved_rig()
    t.check_equal("the smile alone is written", [each["name"] for each in rig["shapes"]], ["smile"])
    t.check("it smiles", 0.1 < rig["shapes"][0]["weight"] <= 1.0, rig["shapes"])

    editor.choose("shapes/blink.L", "drive", "drive/bend", "drive/bend/head")
    editor.wait_until("a driver", lambda s: s["document"]["undo"] == 2)
    editor.settle()
    editor.screenshot(t.out / "shapes_driven.png")
    rig = editor.saved_rig()
    (driven,) = [each for each in rig["shapes"] if each["name"] == "blink.L"]
    t.check_equal("what drives it", driven["animated"][0]["drivers"][0]["input"], {"kind": "bend", "bone": "head"})

    editor.click("shapes/reset")
    editor.wait_until("reset", lambda s: s["document"]["undo"] == 3)
    editor.tap("ctrl+z", "one step back", lambda s: s["document"]["undo"] == 2)
    editor.key("ctrl+s")
    editor.wait_until("saved", lambda s: not s["document"]["modified"])
    editor.kill()

    again = t.edit(t.folder / "face.rig.json")
    again.wait_until("a character", lambda s: "head" in s["bones"])
    t.check("as it was saved", not again.state()["document"]["modified"])
    again.click("shapes/tab")
    again.click("shapes/name/blink.L")
    again.widget("inspector/animation/weight/0/curve")


if __name__ == "__main__":
    sys.exit(driver.run("shapes", shapes))
