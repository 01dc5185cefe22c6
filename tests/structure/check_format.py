# tests/structure/check_format.py: every C++ file is as .clang-format says. Usage: check_format.py ROOT
"""Prints the places that differ and exits 1 if there are any. To mend: clang-format-14 -i FILES."""
import pathlib
import shutil
import subprocess
import sys

TOOL = "clang-format-14"  # Each release formats a little differently.


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if shutil.which(TOOL) is None:
        print(TOOL + " is not installed")
        return 1
    files = sorted(str(f) for top in ("app", "core", "tests") for f in (root / top).rglob("*")
                   if f.suffix in (".h", ".cpp"))
    return subprocess.run([TOOL, "--dry-run", "-Werror", *files], cwd=root).returncode


if __name__ == "__main__":
    sys.exit(main())
