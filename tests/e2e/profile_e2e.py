#!/usr/bin/env python3
"""profile from the command line to the folder of its report: what it measures, refuses and leaves behind.

    profile_e2e.py GPUWARS FORGE_REPLAY FOLDER
"""
import csv
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, without_display

FINE, FAILED, USAGE, FILE, DESYNC = range(5)
TICKS, WARM_UP = 150, 37
GAME = ["--headless", "--device", "cpu", "--seed", 3, "--autopilot", "expert", "--enemies", 256, "--ticks", TICKS]
COMPARED = "ngrid,grid,grid-hashed,brute,thesis"


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


class Session:
    """Runs the program and looks at what it left."""

    def __init__(self, program, folder, failures):
        self.program, self.folder, self.failures = program, folder, failures

    def profile(self, name, code, *arguments, environment=None):
        got, stdout, stderr = run(self.program, "profile", "--device", "cpu", *arguments, environment=environment)
        self.failures.check(got == code, f"{name}: exit {code}" + ("" if got == code else f"; got {got}: {stdout}{stderr}"))
        return stdout, stderr

    def refused(self, name, code, *arguments, says):
        _, stderr = self.profile(name, code, *arguments)
        good = len(stderr.splitlines()) == 1 and says in stderr
        self.failures.check(good, f"{name}: one sentence: {stderr.strip()!r}")

    def interrupt(self, name, after_s, out, *arguments):
        """Ctrl-C so long after the folder of the report was made, which is the first thing that happens."""
        child = subprocess.Popen([str(part) for part in (self.program, "profile", "--device", "cpu", "--out", out, *arguments)],
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=without_display())
        for _ in range(600):
            if (out / "plots").exists() or child.poll() is not None:
                break
            time.sleep(0.1)
        time.sleep(after_s)
        child.send_signal(signal.SIGINT)
        stdout, stderr = child.communicate(timeout=60)
        print(f"      {name}: exit {child.returncode}: {stderr.strip()}")
        return child.returncode, stdout, stderr


def check_report(failures, out, runs):
    report = json.loads((out / "report.json").read_text())
    failures.check(report["gpuwarsProfile"] == 1, "report.json says its version")
    case = report["cases"][0]
    names = [contender["name"] for contender in case["contenders"]]
    failures.check(names == COMPARED.split(","), f"it tells of all: {names}")
    hashes = {contender["hash"] for contender in case["contenders"] if not contender["shadow"]}
    failures.check(len(hashes) == 1 and len(hashes.pop()) == 16, "all exact contenders ended on the same hash")
    failures.check([c["shadow"] for c in case["contenders"]] == [False] * 4 + [True], "the thesis's was in shadow")
    failures.check(all(len(contender["runs"]) == runs for contender in case["contenders"]), f"of {runs} runs each")
    failures.check(all(contender["stages"] for contender in case["contenders"]), "with the times of the stages")
    rows = rows_of(out / "frames.csv")
    failures.check(len(rows) == len(names) * runs * TICKS, f"frames.csv has a row a frame: {len(rows)}")
    failures.check({row["run"] for row in rows} == {str(run) for run in range(runs)}, "runs are counted from 0")
    failures.check(all(row["draw_ms"] == row["wait_ms"] == "" for row in rows), "what was not drawn has no time of it")
    warm = [row for row in rows if row["warm_up"] == "1"]
    failures.check(len(warm) == len(names) * runs * WARM_UP, f"{len(warm)} of them are of the warm-up")
    page = (out / "report.html").read_text()
    failures.check(all(name in page for name in names) and "http" not in page.replace("http://www.w3.org", ""),
                   "report.html tells of all, and needs no network")
    plots = sorted((out / "plots").glob("*.svg"))
    failures.check(len(plots) >= 6, f"{len(plots)} pictures")


def main():
    program, forge, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    session = Session(program, folder, failures)
    good, bad = folder / "good.gwr", folder / "bad.gwr"
    run(program, *GAME, "--record", good)
    run(forge, good, bad, "hash", 70)

    # A whole session, all that can be compared.
    out, trace = folder / "whole", folder / "trace.json"
    stdout, _ = session.profile("all contenders", FINE, "--replay", good, "--no-draw", "--runs", 2, "--compare", COMPARED,
                                "--out", out, "--trace", trace)
    failures.check("report.html" in stdout and "too few for intervals" in stdout, "says where the report is, and what it is worth")
    check_report(failures, out, 2)
    events = json.loads(trace.read_text())["traceEvents"]
    failures.check(len({event["pid"] for event in events}) == 5 and any(event["name"] == "think" for event in events),
                   f"the trace has {len(events)} events of all contenders")

    # Scenes that are recorded first, several numbers of enemies, drawn without a window.
    drawn = folder / "drawn"
    got, stdout, stderr = run(program, "profile", "--device", "cpu", "--scene", "ramp", "--ticks", TICKS, "--enemies", "64,256",
                              "--headless", "--runs", 1, "--width", 320, "--height", 200, "--effects", "off", "--out", drawn)
    if got == FAILED and "No OpenGL" in stderr:
        print("      no OpenGL here: drawing was not tried")
    else:
        failures.check(got == FINE, f"drawn: exit 0: {stderr.strip()}")
        cases = json.loads((drawn / "report.json").read_text())["cases"]
        failures.check([case["enemies"] for case in cases] == [64, 256], "a case for each number of enemies")
        overall = cases[1]["contenders"][0]["overall"]
        failures.check(overall["draw_ms.mean"]["value"] > 0 and overall["gl_ms.mean"]["value"] > 0,
                       "drawing was timed, by OpenGL too")
        failures.check(all(float(row["draw_ms"]) > 0 for row in rows_of(drawn / "frames.csv")), "every frame was drawn")
        failures.check("droppedTicks" not in overall, "a tick a frame drops none, so none are told")
    session.profile("swarm and its end", FINE, "--scene", "swarm", "--enemies", 64, "--ticks", TICKS, "--no-draw", "--runs", 1,
                    "--out", folder / "swarm")

    # As a gate.
    stdout, _ = session.profile("beside itself", FINE, "--replay", good, "--no-draw", "--runs", 10, "--out", folder / "gate")
    baseline = folder / "gate/report.json"
    _, stderr = session.profile("a baseline that is none", FILE, "--replay", good, "--no-draw", "--out", folder / "x",
                                "--baseline", good)
    failures.check(len(stderr.splitlines()) == 1 and "report.json" in stderr, f"says so: {stderr.strip()!r}")
    old = json.loads(baseline.read_text())
    for old_run in old["cases"][0]["contenders"][0]["runs"]:
        old_run["ticksPerSecond"] *= 50
        old_run["frame_ms.p99"] /= 50
    fast = folder / "fast.json"
    fast.write_text(json.dumps(old))
    stdout, _ = session.profile("slower than its baseline", FAILED, "--replay", good, "--no-draw", "--runs", 10,
                                "--out", folder / "gate1", "--baseline", fast)
    failures.check("slower" in stdout and (folder / "gate1/report.json").exists(), "says so, and leaves its report")
    session.refused("a baseline of another length", FILE, "--replay", good, "--no-draw", "--ticks", 100, "--baseline", baseline,
                    "--out", folder / "gate3", says="number of ticks")
    failures.check(not (folder / "gate3/report.json").exists(), "before anything is measured")
    old["machine"]["cpu"] = "another processor"
    other = folder / "other.json"
    other.write_text(json.dumps(old))
    stdout, stderr = session.profile("a baseline from another machine", FINE, "--replay", good, "--no-draw", "--runs", 10,
                                     "--out", folder / "gate2", "--baseline", other)
    failures.check("another processor" in stdout + stderr, "says that it is from another machine")

    # What cannot be measured.
    session.refused("a replay that differs", DESYNC, "--replay", bad, "--no-draw", "--runs", 1, "--out", folder / "bad",
                    says="from tick 70 on")
    failures.check(not (folder / "bad/report.json").exists(), "and leaves no report")
    session.refused("no such replay", FILE, "--replay", folder / "none.gwr", "--no-draw", "--out", folder / "x", says="no such file")
    session.refused("no such contender", USAGE, "--compare", "ngrid,tree", "--no-draw", "--out", folder / "x", says="none of ngrid")
    (folder / "file").write_text("")
    session.refused("a folder that is a file", FILE, "--replay", good, "--no-draw", "--out", folder / "file", says="file")
    session.refused("a folder nobody may make", FILE, "--replay", good, "--no-draw", "--out", "/proc/report", says="/proc/report")
    full = subprocess.run([program, "profile", "--replay", good, "--no-draw", "--runs", "1", "--out", folder / "full"],
                          env=without_display(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
    failures.check(full.returncode == FILE and len(full.stderr.splitlines()) == 1,
                   f"a folder without room: exit 3, one sentence: {full.stderr.strip()!r}")
    failures.check(not (folder / "full/report.json").exists(), "and no half of a report")

    # Ctrl-C: what there is, or that there is nothing.
    long = ["--scene", "five-minutes", "--no-draw", "--runs", 10, "--compare", "ngrid,grid"]
    code, stdout, _ = session.interrupt("in the first run", 4, folder / "short", *long)
    report = json.loads((folder / "short/report.json").read_text())
    failures.check(code == FINE and report["setup"]["interrupted"] and "Interrupted after 1 run:" in stdout,
                   "Ctrl-C leaves a report of what there was")
    code, _, stderr = session.interrupt("while the scene is recorded", 1, folder / "nothing", "--scene", "ramp", "--enemies", 100000,
                                        "--no-draw")
    failures.check(code == FAILED and "before a single frame" in stderr and len(stderr.splitlines()) == 1,
                   "Ctrl-C before the first frame is said")
    failures.check(not list(folder.glob("*/*.part-*")) and not os.path.exists(folder / "nothing/report.json"),
                   "nothing half-written is left")
    failures.finish()


if __name__ == "__main__":
    main()
