#!/usr/bin/env python3
# docs/measure.py: writes docs/measured.md: every figure that a page of Sinew refers to, by the command that prints it.
"""Usage: docs/measure.py [BUILD] [TITLE...]: BUILD is build/release, made with tests; with titles only those sections are measured
again and the others stay as they are. Without titles it takes about a quarter of an hour on an idle machine."""
import json
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "measured.md"
HEAD = """# Measured

`docs/measure.py` makes this page: each section is what its command printed. Speeds differ from machine to machine and from hour to hour, so
compare figures within one section; pages say in words what follows from them. H is the character's height.
"""
# Title -> command, in words that a shell takes; BUILD stands for the build. A pattern keeps the lines that match.
COMMANDS = {
    "Speed, scaling and the paper's tables": ("BUILD/app/sinew bench --rounds 3", ""),
    "Adaptive detail": ("BUILD/tests/sinew_bench detail", ""),
    "Stages of a frame": ("BUILD/tests/sinew_bench stages --frames 4", ""),
    "Drags and settling": ("BUILD/tests/sinew_bench settle --frames 4 --rounds 2", ""),
    "Muscle lines and drivers": ("BUILD/tests/sinew_bench animation", ""),
    "Export times": ("BUILD/tests/sinew_bench exports --frames 5", ""),
    "Quality of the skin": ("BUILD/tests/viewport_tests --gtest_filter='SkinQuality.IsGoodOnBundled*'", r"^  "),
    "Largest steps within a frame": ("BUILD/tests/surface_tests --gtest_filter='*ClipCoherence*Fox*'", r"^  "),
    "Lines over joints, mended": ("BUILD/tests/viewport_tests --gtest_filter='MendedLines.*'", r"^  "),
    "The graphics card beside the processor": ("BUILD/app/sinew bench gpu assets/humanoid.rig.json --frames 3", ""),
    "The window": ("docs/window_rate.py BUILD/app/sinew assets/humanoid-flex.rig.json", ""),
    "Size of the runtime": ("ls -l --block-size=K BUILD/core/libsinew_runtime.a", ""),
}
RIGS = ("humanoid", "humanoid-flex", "horse", "horse-flex")
KINDS = {"transferred weights": "--as skinned --weights transferred", "fitted weights": "--as skinned", "24 helpers": "--as helpers"}
BAKED = (("humanoid", "Walk"), ("humanoid", "Dance"), ("horse-flex", "Gallop"))


def output(command):
    run = subprocess.run(command, shell=True, cwd=ROOT, capture_output=True, text=True)
    return run.stdout if run.returncode == 0 else "%sexit status %d\n%s" % (run.stdout, run.returncode, run.stderr)


def exports(build):
    """How far exports are from the live surface, over all clips."""
    yield "`sinew export assets/RIG.rig.json OPTIONS --json -o out.glb`; distances in percent of H.\n"
    yield "| rig | options | rms | 99.9 % | largest | kB |\n|---|---|---|---|---|---|"
    with tempfile.TemporaryDirectory() as folder:
        for rig in RIGS:
            for name, options in KINDS.items():
                told = json.loads(output("%s/app/sinew export assets/%s.rig.json %s --json -o %s/out.glb" % (build, rig, options, folder)))
                off = told["error_percent_of_height"]["all_clips"]
                size = os.path.getsize(folder + "/out.glb") // 1000
                yield "| %s | %s | %.3f | %.2f | %.2f | %d |" % (rig, name, off["rms"], off["percentile_99_9"], off["max"], size)


def baked(build):
    """How many morph targets a bound takes."""
    yield "`sinew export assets/RIG.rig.json --as baked --clip CLIP --bound B --json -o out.glb`; distances in percent of H.\n"
    yield "| rig | clip | bound | targets | rms | largest | kB |\n|---|---|---|---|---|---|---|"
    with tempfile.TemporaryDirectory() as folder:
        for rig, clip in BAKED:
            for bound in ("0.1", "0.3", "1"):
                told = json.loads(output("%s/app/sinew export assets/%s.rig.json --as baked --clip %s --bound %s --json -o %s/out.glb" %
                                         (build, rig, clip, bound, folder)))
                off = told["error_percent_of_height"]["baked"]
                size = os.path.getsize(folder + "/out.glb") // 1000
                yield "| %s | %s | %s | %d | %.3f | %.2f | %d |" % (rig, clip, bound, told["targets"], off["rms"], off["max"], size)


def section(title, build):
    if title in TABLES:
        return "\n".join(TABLES[title](build))
    command, pattern = COMMANDS[title]
    lines = output(command.replace("BUILD", build)).replace(build + "/", "build/release/").rstrip().splitlines()
    kept = [line.rstrip() for line in lines if re.search(pattern, line)]
    return "    " + "\n    ".join(["$ " + command.replace("BUILD", "build/release"), *kept])


TABLES = {"Distance of exports": exports, "Baked morph targets": baked}


def main():
    words = sys.argv[1:]
    build = words.pop(0) if words and (ROOT / words[0]).is_dir() else "build/release"
    titles = [*COMMANDS, *TABLES]
    if unknown := [word for word in words if word not in titles]:
        sys.exit("no section is called %s" % ", ".join(unknown))
    former = dict(re.findall(r"^## (.*)\n\n((?:.|\n)*?)\n(?=\n## |\Z)", PAGE.read_text(), re.MULTILINE)) if PAGE.exists() else {}
    processor = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    text = HEAD + "\nTaken on %d cores of an %s, %s.\n" % (os.cpu_count(), processor[1] if processor else "unknown processor", platform.system())
    for title in titles:
        if title in words or not words:
            print(title, file=sys.stderr, flush=True)
            former[title] = section(title, build)
        if title in former:
            text += "\n## %s\n\n%s\n" % (title, former[title])
    PAGE.write_text(text)


main()
