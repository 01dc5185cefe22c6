# assets/maker/arguments.py: what the scripts that make the bundled characters are told.
import argparse
import pathlib


def parse(here):
    parser = argparse.ArgumentParser(description="Makes a bundled character and its rigs.")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=here, help="default: the folder of the script")
    parser.add_argument("--texture-rows", type=int, default=1, metavar="N",
                        help="paint every Nth row of the texture only, for a quick check of the script")
    return parser.parse_args()
