# tests/gui/opening.py: characters made elsewhere: first clip, short names, helper bones, a view that comes back, a
# character that has moved.
import json
import pathlib
import struct
import sys

import driver


def parts_of(glb):
    """JSON and binary of a .glb."""
    length = struct.unpack_from("<I", glb, 12)[0]
    return json.loads(glb[20:20 + length]), bytearray(glb[20 + length + 8:])


def glb_of(document, binary):
    document["buffers"][0]["byteLength"] = len(binary)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + b"\0" * (-len(binary) % 4)
    return (b"glTF" + struct.pack("<III", 2, 28 + len(text) + len(binary), len(text)) + b"JSON" + text +
            struct.pack("<I", len(binary)) + b"BIN\0" + binary)


def add_joints(document, binary, names, parent):
    """Joints under the joint of that name that no vertex follows, each with an inverse bind matrix of its own."""
    skin = document["skins"][0]
    nodes = document["nodes"]
    accessor = document["accessors"][skin["inverseBindMatrices"]]
    view = document["bufferViews"][accessor["bufferView"]]
    begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    matrices = bytes(binary[begin:begin + 64 * accessor["count"]])
    above = next(i for i in skin["joints"] if nodes[i]["name"] == parent)
    place = skin["joints"].index(above)
    for name in names:
        nodes[above].setdefault("children", []).append(len(nodes))
        skin["joints"].append(len(nodes))
        nodes.append({"name": name, "translation": [0.6, 0.1, 0.0]})
        own = list(struct.unpack_from("<16f", matrices, 64 * place))
        own[12] -= 0.6
        own[13] -= 0.1
        matrices += struct.pack("<16f", *own)
    binary.extend(b"\0" * (-len(binary) % 4))
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(matrices)})
    binary.extend(matrices)
    document["accessors"].append({"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126, "type": "MAT4",
                                  "count": len(matrices) // 64})
    skin["inverseBindMatrices"] = len(document["accessors"]) - 1


def stranger(t, name="stranger.glb"):
    """The bundled lizard as other tools export: a death first, prefixes on all names, targets for inverse kinematics."""
    document, binary = parts_of((t.assets / "demo.glb").read_bytes())
    add_joints(document, binary, ["ik_hand.L", "pole.L"], "hips")
    for index in document["skins"][0]["joints"]:
        document["nodes"][index]["name"] = "rig:" + document["nodes"][index]["name"]
    walk = next(a for a in document["animations"] if a["name"] == "Walk")
    idle = next(a for a in document["animations"] if a["name"] == "Idle")
    walk["name"], idle["name"] = "Armature|Armature|Walk_Cycle", "Armature|Armature|Death"
    document["animations"] = [idle, walk]
    file = t.folder / name
    file.write_bytes(glb_of(document, binary))
    return file


def bone_rows(state):
    return sorted(w.removeprefix("outliner/bone/") for w in state["widgets"] if w.startswith("outliner/bone/"))


def opened(t, name):
    """(editor, state) of a real character; None where it is not at hand."""
    file = t.characters / name
    if not file.exists():
        print("left out: no " + name)
        return None
    editor = t.edit(file)
    return editor, editor.wait_until("its bones", bone_rows)


def fox_walks(t):
    found = opened(t, "Fox.glb")
    if not found:
        return
    editor, state = found
    t.check_equal("the fox's first clip in the file is another", state["clips"][0], "Survey")
    t.check_equal("the fox opens walking", (state["clip"], state["playing"]), ("Walk", True))
    editor.quit()


def cesium_opens(t):
    found = opened(t, "cesium_man.gltf")
    if not found:
        return
    editor, state = found
    t.check_equal("its one clip plays", (state["clip"], state["playing"]), (state["clips"][0], True))
    t.check("bones that differ by a number alone keep their names", "joint 0" in bone_rows(state), bone_rows(state))
    editor.quit()


def robot_walks(t):
    found = opened(t, "robot.glb")
    if not found:
        return
    editor, state = found
    t.check_equal("the robot's clips begin with a dance and a death", state["clips"][:2], ["Robot_Dance", "Robot_Death"])
    t.check_equal("the robot opens walking", (state["clip"], state["playing"]), ("Robot_Walking", True))
    t.check("its pole targets are no rows", not any("PoleTarget" in row for row in bone_rows(state)), bone_rows(state))
    editor.quit()


def stranger_arrives(t, editor):
    state = editor.wait_until("its bones", bone_rows)
    t.check_equal("a death stands first in the file", state["clips"][0], "Armature|Armature|Death")
    t.check_equal("it walks", (state["clip"], state["playing"]), ("Armature|Armature|Walk_Cycle", True))


def hover_tells_the_short_name(t, editor):
    """The status line, over the middle of the body."""
    editor.palette("rig:chest", "bone/rig:chest")  # The file's name finds it.
    editor.wait_until("the bone", lambda s: s["document"]["bone"] == "rig:chest" and not s["camera_moving"])
    editor.palette("neck", "bone/rig:neck")  # And so does the short one.
    editor.wait_until("the bone", lambda s: s["document"]["bone"] == "rig:neck" and not s["camera_moving"])
    editor.tap("p", "the pose tool", lambda s: s["tool"] == "pose")
    editor.move(editor.state()["bones"]["rig:neck"])
    state = editor.wait_until("the joint under the pointer", lambda s: "neck" in s["status"])
    t.check("the status says the short name", "rig:" not in state["status"], state["status"])
    editor.tap("w", "the move tool", lambda s: s["tool"] == "move")


def search(editor, text):
    """In the tree, whose rows out of sight have no widgets."""
    editor.click("outliner/search")
    editor.key("ctrl+a", "BackSpace")
    editor.type(text)
    editor.key("Return")
    return editor.settle()


def helpers_are_hidden(t, editor):
    editor.wait_until("its bones", bone_rows)
    search(editor, "pole")
    state = editor.settle()
    t.check_equal("helper bones are not in the tree", bone_rows(state), [])


def helpers_can_be_seen(t, editor):
    editor.tap("space", "a pause, so that bones stand still", lambda s: not s["playing"])
    editor.click("outliner/helper-bones")
    state = editor.wait_until("helpers in the tree", lambda s: "rig:pole.L" in bone_rows(s))
    t.check_equal("with what they hang on", bone_rows(state), ["rig:hips", "rig:pole.L"])
    editor.tap("7", "the skeleton", lambda s: s["display"]["skeleton"])
    pole = editor.state()["bones"]["rig:pole.L"]
    editor.move(pole)
    editor.wait_until("a shown helper under the pointer", lambda s: "pole" in s["status"] or "ik_hand" in s["status"])
    editor.click("menu/view")
    editor.click("view/helper-bones")
    state = editor.wait_until("no helpers", lambda s: "rig:pole.L" not in bone_rows(s) and "view/helper-bones" not in s["widgets"])
    editor.move((pole[0] + 1, pole[1]))
    state = editor.wait_until("nothing under the pointer", lambda s: "pole" not in s["status"] and "ik_hand" not in s["status"])
    editor.tap("7", "no skeleton", lambda s: not s["display"]["skeleton"])
    search(editor, "")
    editor.wait_until("all rows again", lambda s: len(bone_rows(s)) > 3)


def the_view_comes_back(t, file):
    editor = t.edit(file)
    editor.wait_until("its bones", bone_rows)
    bytes_before = file.read_bytes()
    editor.palette("clay", "view/clay")
    editor.wait_until("clay", lambda s: s["display"]["shading"] == "clay")
    if editor.state()["playing"]:
        editor.tap("space", "a pause", lambda s: not s["playing"])
    editor.tap("ctrl+Left", "the start", lambda s: s["clip_time"] == 0)
    for frame in range(1, 8):
        editor.tap("period", "the next frame", lambda s, f=frame: abs(s["clip_time"] - f / 30) < 1e-3)
    x, y, width, height = editor.state()["viewport"]
    low = (x + 0.5 * width, y + height - 30)
    camera = editor.state()["camera"]
    editor.drag(low, (low[0] + 140, low[1] - 20))
    editor.wait_until("another view", lambda s: abs(s["camera"]["yaw"] - camera["yaw"]) > 0.2)
    editor.click("outliner/search")
    editor.type("spine")
    editor.wait_until("fewer rows", lambda s: s["outliner"]["search"] == "spine")
    editor.click("outliner/helper-bones")
    before = editor.wait_until("helpers", lambda s: s["outliner"]["helper_bones"])
    t.check_equal("quits", editor.quit(), 0)
    again = t.edit(file)
    state = again.wait_until("its bones", bone_rows)
    for what in ("clip", "playing", "display", "outliner"):
        t.check_equal("as it was left: " + what, state[what], before[what])
    t.check("as it was left: the time", abs(state["clip_time"] - before["clip_time"]) < 1e-6, state["clip_time"])
    far = [abs(state["camera"][k] - before["camera"][k]) for k in ("yaw", "pitch", "distance")]
    t.check("as it was left: the camera", max(far) < 1e-4, (state["camera"], before["camera"]))
    t.check("the file keeps its bytes", file.read_bytes() == bytes_before)
    kept = list((pathlib.Path(t.environment["XDG_STATE_HOME"]) / "sinew" / "views").glob("*.json"))
    t.check("the view is kept in the user's state folder", len(kept) >= 1)
    again.quit()
    for path in kept:
        path.write_bytes(b"\0garbage{")
    third = t.edit(file)
    state = third.wait_until("its bones", bone_rows)
    t.check_equal("garbage there is as if there were nothing", (state["display"]["shading"], state["messages"]), ("textured", []))
    return third


def rig_without_character(t, name, character):
    file = t.folder / name
    file.write_text(json.dumps({"format": "sinew-rig", "version": 1, "character": character, "groups": [{"name": "g"}],
                                "primitives": [{"name": "thigh", "bone": "rig:thigh.L", "group": "g", "center": [0, 0, 0],
                                                "radii": [0.1, 0.2, 0.1]}]}))
    return file


def ask_for(editor, rig):
    editor.tap("ctrl+o", "the open dialog", lambda s: s["dialog"] == "open")
    editor.fill("dialog/path", str(rig))
    return editor.wait_until("the question", lambda s: s["dialog"] == "locate" and "locate/locate" in s["widgets"])


def a_character_that_moved(t, editor):
    rig = rig_without_character(t, "lost.rig.json", "gone/stranger.glb")
    (t.folder / "found").mkdir()
    moved = stranger(t, "found/moved.glb")
    before = editor.state()["document"]
    ask_for(editor, rig)
    editor.click("locate/cancel")
    state = editor.wait_until("the question to go", lambda s: s["dialog"] == "" and "locate/cancel" not in s["widgets"])
    t.check_equal("canceled, the open document stays", state["document"], before)
    ask_for(editor, rig)
    editor.click("locate/locate")
    editor.wait_until("the file dialog", lambda s: s["dialog"] == "locate-file" and "dialog/path" in s["widgets"])
    editor.key("Escape")
    state = editor.wait_until("the dialog to go", lambda s: s["dialog"] == "" and "dialog/path" not in s["widgets"])
    t.check_equal("canceled there, too", state["document"], before)
    ask_for(editor, rig)
    editor.click("locate/locate")
    editor.wait_until("the file dialog", lambda s: s["dialog"] == "locate-file" and "dialog/path" in s["widgets"])
    editor.fill("dialog/path", str(rig))  # No character.
    editor.settle()
    t.check_equal("what is no character is not taken", editor.state()["dialog"], "locate-file")
    editor.fill("dialog/path", str(moved))
    state = editor.wait_until("the rig", lambda s: s["dialog"] == "" and s["document"]["path"] == str(rig))
    t.check("it counts as changed", state["document"]["modified"])
    t.check_equal("its muscle is there", state["document"]["primitives"], 1)
    editor.tap("ctrl+s", "it to be saved", lambda s: not s["document"]["modified"])
    t.check_equal("the new path is written, relative", json.loads(rig.read_text())["character"], "found/moved.glb")
    editor.quit()
    state = t.edit(rig).wait_until("its bones", bone_rows)
    t.check_equal("from then on it opens", (state["dialog"], state["document"]["modified"]), ("", False))
    t.editors[-1].quit()


def asked_for_at_the_start(t):
    rig = rig_without_character(t, "lost2.rig.json", "nobody.glb")
    editor = t.edit(rig)
    editor.wait_until("the question", lambda s: s["dialog"] == "locate" and "locate/cancel" in s["widgets"])
    editor.key("Escape")
    editor.wait_until("the question to go", lambda s: s["dialog"] == "")
    editor.quit()
    display = t.environment.pop("DISPLAY")
    done = t.run_program("edit", rig)
    t.environment["DISPLAY"] = display
    t.check_equal("without a screen it is refused", done.returncode, 1)
    lines = done.stderr.splitlines()
    t.check("in one line that names what is missing", len(lines) == 1 and "nobody.glb" in lines[0], done.stderr)


def other_missing_files(t):
    document, binary = parts_of((t.assets / "demo.glb").read_bytes())
    document["buffers"][0] = {"byteLength": len(binary), "uri": "gone.bin"}
    (t.folder / "apart.gltf").write_text(json.dumps(document))
    rig = rig_without_character(t, "apart.rig.json", "apart.gltf")
    done = t.run_program("edit", rig)
    t.check_equal("a missing buffer is no missing character", done.returncode, 1)
    t.check("its message names it", "gone.bin" in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr)


def story(t):
    fox_walks(t)
    cesium_opens(t)
    robot_walks(t)
    file = stranger(t)
    editor = t.edit(file)
    stranger_arrives(t, editor)
    helpers_are_hidden(t, editor)
    helpers_can_be_seen(t, editor)
    hover_tells_the_short_name(t, editor)
    editor.quit()
    other_missing_files(t)
    editor = the_view_comes_back(t, stranger(t, "second.glb"))
    a_character_that_moved(t, editor)
    asked_for_at_the_start(t)


if __name__ == "__main__":
    sys.exit(driver.run("opening", story))
