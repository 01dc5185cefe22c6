# tests/limits/full_disk_test.py: what the verbs say of a full disk, a read-only one and one that is gone. Usage: full_disk_test.py PROGRAM
"""Each gives one line and exit status 1, and the old file stays. The editor's own saving is in tests/gui/failed_save.py."""
import ctypes
import os
import pathlib
import subprocess
import sys
import tempfile

from hostile_post import Post, rig

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())  # Runs have other working directories.
NEW_MOUNTS, NEW_USERS = 0x00020000, 0x10000000
VERBS = {"smooth": ["smooth", "a.rig.json", "-o", "disk/o.ply"],
         "obj": ["smooth", "a.rig.json", "-o", "disk/o.obj"],
         "skinned": ["export", "a.rig.json", "--as", "skinned", "-o", "disk/s.gltf"],
         "cache": ["export", "a.rig.json", "--as", "baked", "--clip", "bend", "-o", "disk/c.pc2"],
         "rig": ["retarget", "a.rig.json", "post.glb", "-o", "disk/r.rig.json"],
         "farm": ["farm", "smooth", "a.rig.json", "-o", "f.ply", "--to", "commands", "--job", "disk/job.txt"]}


def own_mounts():
    user, group = os.getuid(), os.getgid()
    if ctypes.CDLL(None).unshare(NEW_MOUNTS | (NEW_USERS if user else 0)) != 0:
        return False
    if user:
        for name, text in (("setgroups", "deny"), ("uid_map", "0 %d 1" % user), ("gid_map", "0 %d 1" % group)):
            pathlib.Path("/proc/self", name).write_text(text)
    return subprocess.run(["mount", "--make-rprivate", "/"], capture_output=True).returncode == 0


def refused(folder, words, state, wanted):
    old = {path.name: path.read_bytes() for path in (folder / "disk").iterdir()} if (folder / "disk").exists() else {}
    run = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True)
    now = {path.name: path.read_bytes() for path in (folder / "disk").iterdir()} if (folder / "disk").exists() else {}
    lines = run.stderr.splitlines()
    sound = run.returncode == 1 and len(lines) == 1 and wanted in lines[0] and now == old
    print("%s, %s: %s %s" % (words[0], state, "ok" if sound else "BAD", run.stderr.strip()))
    return 0 if sound else 1


def main():
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        disk = folder / "disk"
        disk.mkdir()
        if not own_mounts() or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "none", str(disk)],
                                              capture_output=True).returncode != 0:
            print("left out: no file system can be mounted here")
            return 77
        (folder / "post.glb").write_bytes(Post().glb())
        (folder / "a.rig.json").write_text(rig("post.glb"))
        (disk / "r.rig.json").write_text("old")
        bad = 0
        with open(disk / "ballast", "wb", buffering=0) as ballast:
            try:
                while True:
                    ballast.write(b"x" * 512)
            except OSError:
                pass
        for words in VERBS.values():
            bad += refused(folder, words, "full", "No space left")
        (disk / "ballast").unlink()
        subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
        for words in VERBS.values():
            bad += refused(folder, words, "read-only", "Read-only")
        subprocess.run(["umount", "-l", str(disk)], check=True)
        disk.rmdir()
        for words in VERBS.values():
            bad += refused(folder, words, "gone", "")
        return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
