# tests/install/package_root.py: a package made and unpacked, and programs run as if the source tree were not there.
import subprocess


def make(build, work):
    """(the .deb of the program, the folder it is unpacked in), both under `work`; other packages lie beside the first."""
    done = subprocess.run(["cpack", "--config", build / "CPackConfig.cmake", "-B", work / "cpack"], cwd=build,
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit("cpack: exit %d\n%s%s" % (done.returncode, done.stdout, done.stderr))
    deb, = (work / "cpack").glob("sinew_*.deb")
    root = work / "root"
    subprocess.run(["dpkg-deb", "--extract", deb, root], check=True)
    return deb, root


def can(command):
    try:
        return subprocess.run(command, capture_output=True).returncode == 0
    except OSError:
        return False


def without(source):
    """What to put before a command, so that it runs with an empty folder over the source tree; None if that cannot be
    done here."""
    for options in ("-m", "-rm"):
        words = ["unshare", options, "sh", "-c", 'mount -t tmpfs none "$1" && shift && exec "$@"', "sh", str(source)]
        if can([*words, "true"]):
            return words
    return None
