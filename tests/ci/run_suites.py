# tests/ci/run_suites.py: the tests of a build, a suite in one process. Usage: run_suites.py BUILD WITHOUT
"""ctest starts a process for each case, which takes longer than most cases where sanitizers are linked in. WITHOUT is a file of regular
expressions of names, one a line, that are left out. What a suite prints is shown where it fails; exit status 1 then."""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import time

TIMEOUT = 1200
FILTER = "--gtest_filter="


def tests_of(build):
    shown = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True, text=True).stdout
    for test in json.loads(shown)["tests"]:
        properties = {each["name"]: each["value"] for each in test.get("properties", [])}
        if not properties.get("DISABLED"):
            yield test["name"], test["command"], properties


def suites_of(tests):
    """{name: (command, folder, environment, exit status of what is left out, number of cases)}; what is no case of GoogleTest is a
    suite of its own."""
    cases, suites = {}, {}
    for name, command, properties in tests:
        rest = (properties.get("WORKING_DIRECTORY", "."), properties.get("ENVIRONMENT", []), properties.get("SKIP_RETURN_CODE"))
        words = [word for word in command if word.startswith(FILTER)]
        if not words:
            suites[name] = (command, *rest, 1)
            continue
        case = words[0][len(FILTER):]
        key = (command[0], case.partition(".")[0])
        own = cases.setdefault(key, (name.partition(".")[0], [], rest))
        own[1].append(case)
    for (program, _), (name, names, rest) in cases.items():
        suites[name] = ([program, FILTER + ":".join(names)], *rest, len(names))
    return suites


def run(suite):
    command, folder, environment, skip, _ = suite
    began = time.monotonic()
    try:
        done = subprocess.run(command, cwd=folder, env={**os.environ, **dict(each.split("=", 1) for each in environment)},
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT)
        status, said = done.returncode, done.stdout
    except subprocess.TimeoutExpired as late:
        status, said = "more than %d s" % TIMEOUT, late.stdout or b""
    return status in (0, skip), status, said.decode(errors="replace"), time.monotonic() - began


def main():
    build, without = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    lines = [line for line in without.read_text().splitlines() if line and not line.startswith("#")]
    left_out = re.compile("|".join("(?:%s)" % line for line in lines))
    suites = suites_of(test for test in tests_of(build) if not left_out.search(test[0]))
    assert suites, "no tests in %s" % build
    failed = []
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        running = {pool.submit(run, suite): name for name, suite in suites.items()}
        for future in concurrent.futures.as_completed(running):
            name, (passed, status, said, seconds) = running[future], future.result()
            print("%s %s: %d in %.1f s" % ("ok" if passed else "FAILED", name, suites[name][-1], seconds), flush=True)
            if not passed:
                failed.append(name)
                print(said + "exit status: %s" % status, flush=True)
    print("%d cases in %d suites, %d suites failed" % (sum(suite[-1] for suite in suites.values()), len(suites), len(failed)))
    for name in failed:
        print("failed: " + name)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
