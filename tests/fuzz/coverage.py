# tests/fuzz/coverage.py: how much of core/files the fuzzers have run. Usage: coverage.py BUILD [FOLDER]
"""Runs what the fuzzers have learned so far and their seeds once more, and prints for each file of FOLDER (core/files) how many of its
branches ("edges") some fuzzer took. Of a function that several fuzzers reach, the one that sees most of it counts. A third to a half
of the branches are those that an exception would take, as where memory is short: none is thrown here."""
import collections
import os
import pathlib
import re
import subprocess
import sys

LINE = re.compile(r"^(?:UN)?COVERED_FUNC: hits: \d+ edges: (\d+)/(\d+) (.*) (\S+):\d+$", re.M)


def main():
    build = pathlib.Path(sys.argv[1])
    folder = sys.argv[2] if len(sys.argv) > 2 else "core/files"
    functions = {}
    for target in ("import", "rig", "set", "smooth", "export"):
        learned = [str(each) for each in (build / "fuzz" / target, build / "fuzz" / "seeds" / target) if each.is_dir()]
        run = subprocess.run([build / "tests" / "fuzz" / ("fuzz_" + target), "-runs=0", "-print_coverage=1", "-timeout=60", *learned],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        if run.returncode != 0:
            sys.exit("fuzz_%s: status %d\n%s" % (target, run.returncode, run.stdout[-2000:]))
        print("%-7s %d inputs" % (target, sum(len(os.listdir(each)) for each in learned)))
        for taken, edges, name, file in LINE.findall(run.stdout):
            place = file.find("/" + folder + "/")
            if place >= 0:
                key = (file[place + 1:], name)
                functions[key] = max(functions.get(key, (0, 0)), (int(taken), int(edges)))
    files = collections.defaultdict(lambda: [0, 0])
    for (file, _), (taken, edges) in functions.items():
        for key in (file, folder):
            files[key][0] += taken
            files[key][1] += edges
    for file, (taken, edges) in sorted(files.items()):
        print("%-50s %6d of %6d edges, %3.0f %%" % (file, taken, edges, 100.0 * taken / edges))


if __name__ == "__main__":
    main()
