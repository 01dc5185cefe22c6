#!/usr/bin/env python3
# packaging/make_pages.py: man page and shell completions from the program's help. Usage: make_pages.py PROGRAM [FOLDER]
"""Writes sinew.1 and completions/ into FOLDER (here, if none is named). They are part of the tree; tests/install makes
them again and compares, so a changed verb or option needs this script to be run."""
import pathlib
import sys

sys.dont_write_bytecode = True
import completions
import help_text
import man_page


def main():
    root = help_text.read(sys.argv[1])
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).resolve().parent
    (folder / "completions").mkdir(parents=True, exist_ok=True)
    for name, text in (("sinew.1", man_page.page(root)), ("completions/sinew.bash", completions.bash(root)),
                       ("completions/_sinew", completions.zsh(root)),
                       ("completions/sinew.fish", completions.fish(root))):
        (folder / name).write_text(text)


if __name__ == "__main__":
    main()
