# tests/limits/soak.py: a long session without a window, and its figures. Usage: soak.py PANELS_TESTS [FRAMES [ACTIONS]]
"""Not a test of ctest, which runs the same for seconds: 100,000 frames of playing and editing, then 10,000 random actions
that are undone to the first byte. Exit status 1 if either fails or if memory grows by more than MOST after the warm-up, a tenth of
the frames: what is in use on the heap, what the process holds when the heap has given back what is free, and resident memory, which
also has holes between what is in use and pages of the program as they are first needed. The heap keeps no blocks for each thread
here: glibc counts those as in use."""
import os
import re
import subprocess
import sys

MOST = 2.0  # Percent.
NO_BLOCKS_KEPT = "glibc.malloc.tcache_count=0"


def run(program, name, **variables):
    command = [program, "--gtest_filter=" + name]
    ended = subprocess.run(command, env=dict(os.environ, **variables), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if ended.returncode != 0:
        print(ended.stdout)
    return ended


def main():
    program = sys.argv[1]
    frames = sys.argv[2] if len(sys.argv) > 2 else "100000"
    actions = sys.argv[3] if len(sys.argv) > 3 else "10000"
    session = run(program, "Soak.*", SINEW_SOAK_FRAMES=frames, GLIBC_TUNABLES=NO_BLOCKS_KEPT)
    print("\n".join(re.findall(r"^soak: (.*)", session.stdout, re.M)), flush=True)
    grown = re.findall(r"^soak: (?:in use|held|resident) .* (-?[\d.]+) % more", session.stdout, re.M)
    flat = len(grown) == 3 and all(float(each) <= MOST for each in grown)
    if not flat:
        print("memory is not flat")
    random = run(program, "RandomActions.*", SINEW_SOAK_ACTIONS=actions)
    print("\n".join(re.findall(r"^seed .* all undone$", random.stdout, re.M)))
    return 0 if flat and session.returncode == 0 and random.returncode == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
