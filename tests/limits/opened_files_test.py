# tests/limits/opened_files_test.py: hostile characters make the program open nothing outside their folder. Usage: opened_files_test.py PROGRAM
"""strace says which files are opened: those of the system and of the program apart, all must lie in the character's folder."""
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


def uris(folder):
    """What a file may name that it must not have."""
    (folder.parent / "secret.bin").write_bytes(b"\0" * 4096)
    (folder / "link.bin").symlink_to(folder.parent / "secret.bin")
    os.symlink(folder.parent, folder / "up")
    return ["../secret.bin", "%2e%2e/secret.bin", str(folder.parent / "secret.bin"), "file://" + str(folder.parent / "secret.bin"),
            "link.bin", "up/secret.bin", "a/../../secret.bin", "..\\secret.bin", "http://localhost/secret.bin"]


def write(folder, name, buffer, image):
    post = Post()
    data = "data:;base64," + base64.b64encode(post.bytes).decode()
    text = dict(post.json, buffers=[{"byteLength": len(post.bytes), "uri": buffer or data}])
    text["images"] = [{"uri": image}]
    text["textures"] = [{"source": 0}]
    text["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    text["meshes"][0]["primitives"][0]["material"] = 0
    (folder / name).write_text(json.dumps(text))


def outside(folder, words):
    """The run, the paths that were opened but for the system's and the character's, and how many were the character's."""
    log = folder.parent / "trace"
    run = subprocess.run(["strace", "-f", "-qq", "-e", "trace=open,openat,openat2", "-o", str(log), PROGRAM, *words], cwd=folder,
                         capture_output=True, text=True)
    home = pathlib.Path(PROGRAM).resolve().parents[1]
    found, own = [], 0
    for line in log.read_text(errors="replace").splitlines():
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
        for kind in ("buffer", "image"):
            for uri in names:
                write(folder, "hostile.gltf", uri if kind == "buffer" else "", uri if kind == "image" else "none.png")
                for words in (["inspect", "hostile.gltf"], ["smooth", "hostile.gltf", "-o", "out.obj"],
                              ["export", "hostile.gltf", "--as", "skinned", "--depth", "1", "-o", "out.gltf"]):
                    run, found, own = outside(folder, words)
                    sound = not found and own > 0 and run.returncode == 1 and len(run.stderr.splitlines()) == 1
                    bad += not sound
                    if not sound:
                        print("%s of %s %s: exit %d, opened %s\n%s" % (words[0], kind, uri, run.returncode, found, run.stderr))
        print("%d runs, %d of them wrong" % (2 * 3 * len(names), bad))
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
