#!/usr/bin/env python3
"""verify beside another device or another build, heavy and shuffled, and what it writes for machines.

    verify_e2e.py GPUWARS FORGE_REPLAY FOLDER
"""
import json
import os
import re
import shutil
import signal
import stat
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from program import Failures, run

FINE, FAILED, USAGE, FILE, DESYNC = range(5)
TICKS = 150
GAME = ["--headless", "--device", "cpu", "--seed", 3, "--autopilot", "novice", "--enemies", 256, "--ticks", TICKS]


def script(path, text):
    """A program that a test makes up."""
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def main():
    program, forge, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    good, bad_hash, bad_input = folder / "good.gwr", folder / "hash.gwr", folder / "input.gwr"

    def verify(name, code, *arguments):
        got, stdout, stderr = run(program, "verify", *arguments, "--device", "cpu")
        failures.check(got == code, f"{name}: exit {code}" + ("" if got == code else f"; got {got}: {stdout}{stderr}"))
        return stdout, stderr

    def refused(name, code, *arguments, says=()):
        _, stderr = verify(name, code, *arguments)
        good = len(stderr.splitlines()) == 1 and all(word in stderr for word in says)
        failures.check(good, f"{name}: one sentence" + ("" if good else f": {stderr!r}"))

    run(program, *GAME, "--record", good)
    for path, what in ((bad_hash, "hash"), (bad_input, "input")):
        code, _, stderr = run(forge, good, path, what, 70)
        failures.check(code == 0, f"a replay with another {what} in tick 70 is forged{stderr}")

    # One that is good, whichever way it is looked at.
    for arguments in (["--heavy"], ["--shuffle"], ["--against", "cpu"], ["--reference", program],
                      ["--reference", program, "--reference-options", "--device cpu --threads 3 --broad-phase brute"]):
        stdout, stderr = verify("equal with " + " ".join(map(str, arguments)), FINE, good, *arguments)
        failures.check(f"{TICKS} of {TICKS} ticks compared" in stdout and stderr == "", "and says so: " + stdout.strip())
    stdout, _ = verify("several at a time", FINE, good, good, good, "-j", 3)
    failures.check(stdout.count("equal ") == 3, "says each")

    # A recording that is wrong, while both sides agree.
    stdout, stderr = verify("a hash that is wrong", DESYNC, bad_hash)
    failures.check("tick 70 is the first that differs" in stderr and "all fields are equal again" in stderr,
                   "names the tick, and that the state is the recorded one: " + stderr.strip())
    _, stderr = verify("an input that is wrong", DESYNC, bad_input)
    failures.check("tick 70 is the first that differs" in stderr and "by tick 120" in stderr and "master and tables differ" in stderr,
                   "names the tick and the fields that differ by the next kept one: " + stderr.strip())
    _, stderr = verify("beside another build", DESYNC, bad_input, "--reference", program)
    failures.check("so it is on both sides" in stderr, "says that both agree")

    # For machines.
    out, junit = folder / "out.json", folder / "junit.xml"
    verify("three, two of them bad", DESYNC, good, bad_input, folder / "nothing.gwr", "--json", out, "--junit", junit)
    results = json.loads(out.read_text())["replays"]
    failures.check([result["exitCode"] for result in results] == [FINE, DESYNC, FILE], "JSON tells each")
    failures.check(results[1]["firstDifference"]["tick"] == 70 and results[1]["fields"]["tick"] == 120
                   and "place" in results[1]["fields"]["differ"], f"and where: {results[1].get('fields')}")
    suite = ElementTree.parse(junit).getroot()
    failures.check((suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("3", "1", "1"), "JUnit counts them")
    cases = suite.findall("testcase")
    failures.check(len(cases) == 3 and len(cases[0]) == 0 and "tick 70" in cases[1].find("failure").get("message")
                   and "no such file" in cases[2].find("error").text, "and tells each")

    # Ctrl-C goes to the whole foreground group; the reference stands in its own and is asked to end.
    long = Path(__file__).resolve().parents[2] / "replays/long_watch.gwr"
    child = subprocess.Popen([str(part) for part in (program, "verify", long, "--device", "cpu", "--reference", program)],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    time.sleep(1.5)
    os.killpg(child.pid, signal.SIGINT)
    _, stderr = child.communicate(timeout=60)
    # In the middle of an answer of the reference where the machine is busy.
    failures.check(child.returncode == 130 and re.search("interrupted (after|while)", stderr),
                   f"Ctrl-C is reported as such: {child.returncode} {stderr.strip()!r}")

    # One that hangs, and does not end by itself either.
    hangs = script(folder / "hangs", "trap '' TERM; echo '{\"gpuwarsProbe\":1,\"name\":\"x\"}'; while true; do sleep 1; done\n")
    child = subprocess.Popen([str(part) for part in (program, "verify", good, "--device", "cpu", "--reference", hangs)],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(1)
    child.send_signal(signal.SIGINT)
    _, stderr = child.communicate(timeout=60)
    failures.check(child.returncode == 130 and "interrupted while" in stderr, f"one that hangs is left by Ctrl-C: {stderr.strip()!r}")
    left = subprocess.run(["pgrep", "-f", str(hangs)], stdout=subprocess.PIPE, text=True, check=False).stdout
    failures.check(left == "", f"and is not left behind: {left!r}")
    verify("more jobs than files", FINE, good, "-j", 8)

    # References that are none.
    refused("no such program", FAILED, good, "--reference", folder / "none", says=["cannot be started", "give"])
    refused("a program that ends", FAILED, good, "--reference", script(folder / "ends", "exit 0\n"), says=["ended before"])
    refused("a program that talks", FAILED, good, "--reference", script(folder / "talks", "echo hello\n"), says=["knows 'gpuwars probe'"])
    refused("another language", FAILED, good, "--reference", script(folder / "other", "echo '{\"gpuwarsProbe\":99,\"name\":\"x\"}'\n"),
            says=["version 99"])
    refused("one that dies", FAILED, good, "--reference",
            script(folder / "dies", "echo '{\"gpuwarsProbe\":1,\"name\":\"x\"}'; read line\n"), says=["ended while"])
    refused("one that lies", FAILED, good, "--reference",
            script(folder / "lies", "echo '{\"gpuwarsProbe\":1,\"name\":\"x\"}'; while read line; do echo '{}'; done\n"),
            says=["answered something else"])
    refused("one that says too little", FAILED, good, "--reference",
            script(folder / "little", "echo '{\"gpuwarsProbe\":1,\"name\":\"x\"}'; while read line; do echo '{\"hashes\":[1]}'; done\n"),
            says=["answered something else"])
    refused("one that fails", FAILED, good, "--reference",
            script(folder / "fails", "echo '{\"gpuwarsProbe\":1,\"name\":\"x\"}'; while read line; do echo '{\"error\":\"no\"}'; done\n"),
            says=["failed: no"])
    refused("both kinds of another side", USAGE, good, "--reference", program, "--against", "cpu", says=["leave out one"])
    refused("options of no reference", USAGE, good, "--reference-options", "--threads 1", says=["add it"])
    refused("heavy beside another side", USAGE, good, "--heavy", "--against", "cpu", says=["leave out one"])
    refused("JUnit over JSON", USAGE, good, "--junit", out, "--json", out, says=["give each its own"])
    for option in ("--junit", "--json"):
        stdout, stderr = verify(f"{option} where writing is refused", FILE, good, option, "/nonexistent/x")
        failures.check("cannot be written" in stderr and "compared" not in stdout, "says so before it begins")
    failures.finish()


if __name__ == "__main__":
    main()
