# tests/blender/missing_test.py: without the module nothing opens, and one sentence says why.
import json
import pathlib
import subprocess
import sys

from tools import ADDON, ASSETS, ROOT, blender, check, main


def is_line(text):
    return bool(text) and "\n" not in text.strip()


def seen(printed):
    return [json.loads(line[6:]) for line in printed.splitlines() if line.startswith("seen: ")]


def test(folder):
    again = folder / "again.zip"
    subprocess.run([sys.executable, "-B", ROOT / "blender" / "make_zip.py", again], check=True)
    check("the same sources give the same zip", again.read_bytes() == pathlib.Path(ADDON).read_bytes())
    other = folder / "other"
    (other / "sinew").mkdir(parents=True)
    (other / "sinew" / "__init__.py").write_text('__version__ = "9.4.1"\n')
    empty = folder / "empty"
    empty.mkdir()
    broken = folder / "broken.rig.json"
    broken.write_text((ASSETS / "horse.rig.json").read_text().replace('"horse.glb"', '"nowhere.glb"'))
    lame = folder / "lame.rig.json"
    text = (ASSETS / "horse.rig.json").read_text().replace('"horse.glb"', '"%s"' % (ASSETS / "horse.glb"))
    bone = json.loads(text)["primitives"][0]["bone"]
    lame.write_text(text.replace('"bone": "%s"' % bone, '"bone": "of another horse"'))
    for what, path, words in (("no module", empty, "cannot be loaded"), ("another version", other, "is 9.4.1")):
        printed = blender(folder, "missing_in_blender.py", ASSETS / "horse.rig.json", PYTHONPATH=str(path))
        (found,) = seen(printed)
        check("%s: the rig is refused in one line: %s" % (what, found["refused"]),
              words in found["refused"] and is_line(found["refused"]) and not found["objects"], found)
    tried = blender(folder, ROOT / "blender" / "try.py", ASSETS / "horse.rig.json")
    check("what ./run.sh blender runs opens a rig", "glTF import finished" in tried and "Error" not in tried,
          tried[-2000:])
    printed = blender(folder, "missing_in_blender.py", lame, broken)
    muscle = json.loads(text)["primitives"][0]["name"]
    said = [line for line in printed.splitlines() if line.startswith("Warning: Left out") and muscle in line]
    check("muscles whose bones the character lacks are named: " + "".join(said), len(said) == 1, printed[-2000:])
    found = seen(printed)
    check("with the module a rig without its character is refused in one line",
          "nowhere.glb" in found[1]["refused"] and is_line(found[1]["refused"]), found[1])


main(test)
