# tests/limits/opened_files_test.py: hostile characters make the program open nothing outside their folder. Usage: opened_files_test.py PROGRAM
"""strace says which files are opened and where is connected to: files of the system and of the program apart, all must lie in the
character's folder, and nothing is connected to. That strace tells is shown by files that lie outside and were asked for."""
import base64
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from hostile_post import Post

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())  # Runs have other working directories.
SYSTEM = ("/lib", "/lib64", "/usr", "/etc", "/proc", "/sys", "/dev")
OPENED = re.compile(r'open(?:at|at2)?\((?:AT_FDCWD|\d+)?,? ?"((?:[^"\\]|\\.)*)".*= (\d+)')
CONNECTED = re.compile(r"connect\((.*)")
VERBS = (["inspect"], ["smooth", "-o", "out.obj"], ["export", "--as", "skinned", "--depth", "1", "-o", "out.gltf"])


def uris(folder):
    """What a file may name that it must not have."""
    (folder.parent / "secret.bin").write_bytes(b"\0" * 4096)
    (folder / "link.bin").symlink_to(folder.parent / "secret.bin")
    os.symlink(folder.parent, folder / "up")
    return ["../secret.bin", "%2e%2e/secret.bin", str(folder.parent / "secret.bin"), "file://" + str(folder.parent / "secret.bin"),
            "link.bin", "up/secret.bin", "a/../../secret.bin", "..\\secret.bin", "FILE:" + str(folder.parent / "secret.bin"),
            "//localhost/secret.bin", "http://localhost/secret.bin"]


def write(folder, kind, uri):
    """hostile.gltf, whose buffer or image is there; or hostile.glb with such an image. @return its name"""
    post = Post()
    data = "data:;base64," + base64.b64encode(post.bytes).decode()
    text = dict(post.json, buffers=[{"byteLength": len(post.bytes), "uri": uri if kind == "buffer" else data}])
    image = "none.png" if kind == "buffer" else uri
    text["images"] = [{"uri": image}]
    text["textures"] = [{"source": 0}]
    text["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    text["meshes"][0]["primitives"][0]["material"] = 0
    if kind == "image of a .glb":
        post.json = text
        (folder / "hostile.glb").write_bytes(post.glb())
        return "hostile.glb"
    (folder / "hostile.gltf").write_text(json.dumps(text))
    return "hostile.gltf"


def outside(folder, words):
    """The run, what was opened but for files of the system and the character, or connected to, and how many files were the character's."""
    log = folder.parent / "trace"
    run = subprocess.run(["strace", "-f", "-qq", "-e", "trace=open,openat,openat2,connect", "-o", str(log), PROGRAM, *words], cwd=folder,
                         capture_output=True, text=True)
    home = pathlib.Path(PROGRAM).resolve().parents[1]
    found, own = [], 0
    for line in log.read_text(errors="replace").splitlines():
        found += CONNECTED.findall(line)
        match = OPENED.search(line)
        if not match:
            continue
        path = pathlib.Path(os.path.realpath(folder / match.group(1)))
        inside = folder == path or folder in path.parents
        own += inside
        if not inside and home not in path.parents and not str(path).startswith(SYSTEM):
            found.append(str(path))
    return run, found, own


def main():
    if not shutil.which("strace"):
        print("left out: strace is not installed")
        return 77
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place).resolve() / "character"
        folder.mkdir()
        names = uris(folder)
        (folder / "plain.glb").write_bytes(Post().glb())
        probe, found, own = outside(folder, ["inspect", "plain.glb"])
        if probe.returncode != 0:
            print("left out: strace cannot trace here")
            return 77
        bad = int(own == 0 or bool(found))
        (folder.parent / "beside.glb").write_bytes(Post().glb())
        for asked in ("../beside.glb", "up/beside.glb", str(folder.parent / "beside.glb")):
            bad += set(outside(folder, ["inspect", asked])[1]) != {str(folder.parent / "beside.glb")}
        runs = 0
        for kind in ("buffer", "image", "image of a .glb"):
            for uri in names:
                file = write(folder, kind, uri)
                for verb, *options in VERBS:
                    run, found, own = outside(folder, [verb, file, *options])
                    sound = not found and own > 0 and run.returncode == 1 and len(run.stderr.splitlines()) == 1
                    runs, bad = runs + 1, bad + (not sound)
                    if not sound:
                        print("%s of %s %s: exit %d, opened %s\n%s" % (verb, kind, uri, run.returncode, found, run.stderr))
        print("%d runs, %d of them wrong" % (runs, bad))
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
