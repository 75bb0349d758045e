#!/usr/bin/env python3
"""profile from the command line to the folder of its report: what it measures, refuses and leaves behind. What it draws
is profile_drawn_e2e.py's.

    profile_e2e.py GPUWARS FORGE_REPLAY SCHEMA FOLDER
"""
import csv
import json
import os
import pty
import re
import resource
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from program import Failures, has_terminals, run, skip, without_display

FINE, FAILED, USAGE, FILE, DESYNC = range(5)
CTRL_C = 130
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

    def interrupt(self, name, when, out, *arguments):
        """Ctrl-C as soon as what a terminal is shown of the progress matches `when`."""
        terminal, side = pty.openpty()
        child = subprocess.Popen([str(part) for part in (self.program, "profile", "--device", "cpu", "--out", out, *arguments)],
                                 stdout=subprocess.PIPE, stderr=side, text=True, env=without_display())
        os.close(side)
        shown, interrupted = "", False
        try:
            while part := os.read(terminal, 4096):
                shown += part.decode(errors="replace")
                if not interrupted and re.search(when, shown):
                    interrupted = True
                    child.send_signal(signal.SIGINT)
        except OSError:  # its other side is closed
            pass
        os.close(terminal)
        stdout = child.communicate(timeout=60)[0]
        said = re.split(r"\r\x1b\[K", shown)[-1].strip()
        print(f"      {name}: exit {child.returncode}: {said}")
        self.failures.check(interrupted, f"{name}: the progress was shown")
        return child.returncode, stdout, said, shown


def check_schema(failures, report, schema):
    try:
        import jsonschema
    except ImportError:
        return print("      no jsonschema here: report.json was not held against its schema")
    offences = list(jsonschema.Draft202012Validator(json.loads(schema.read_text())).iter_errors(report))
    return failures.check(not offences, f"report.json is as its schema says {[str(o)[:200] for o in offences[:2]]}")


def check_report(failures, out, runs, schema):
    report = json.loads((out / "report.json").read_text())
    check_schema(failures, report, schema)
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
    program, forge, schema, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4])
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
    check_report(failures, out, 2, schema)
    events = json.loads(trace.read_text())["traceEvents"]
    failures.check(len({event["pid"] for event in events}) == 5 and any(event["name"] == "think" for event in events),
                   f"the trace has {len(events)} events of all contenders")

    picture, drawer = folder / "trace.svg", Path(__file__).resolve().parents[2] / "tools/draw_trace.py"
    subprocess.run([sys.executable, drawer, trace, picture, "--length", "20"], check=True)
    svg = picture.read_text()
    failures.check("think: " in svg and svg.count(">stages<") == 5, "a stretch of it can be drawn")
    code = subprocess.run([sys.executable, drawer, good, picture], stderr=subprocess.DEVNULL, check=False).returncode
    failures.check(code == 1 and picture.read_text() == svg, "a file that is no trace is refused")

    # A scene that is recorded first.
    session.profile("swarm and its end", FINE, "--scene", "swarm", "--enemies", 64, "--ticks", TICKS, "--no-draw", "--runs", 1,
                    "--out", folder / "swarm")

    # As a gate: beside itself, slower, of another length, from another machine.
    ten = ("--replay", good, "--no-draw", "--runs", 10)
    session.profile("a baseline", FINE, *ten, "--out", folder / "gate")
    baseline = folder / "gate/report.json"
    _, stderr = session.profile("a baseline that is none", FILE, "--replay", good, "--no-draw", "--out", folder / "x",
                                "--baseline", good)
    failures.check(len(stderr.splitlines()) == 1 and "report.json" in stderr, f"says so: {stderr.strip()!r}")

    def changed(name, times_faster, **machine):
        """The baseline as of a machine that was so many times as fast."""
        old = json.loads(baseline.read_text())
        for old_run in old["cases"][0]["contenders"][0]["runs"]:
            old_run["ticksPerSecond"] *= times_faster
            for metric in ("frame_ms.p99", "upkeepAndGathering_ms.mean"):
                old_run[metric] /= times_faster
        old["machine"].update(machine)
        file = folder / f"{name}.json"
        file.write_text(json.dumps(old))
        return file

    stdout, _ = session.profile("faster than its baseline", FINE, *ten, "--out", folder / "gate0",
                                "--baseline", changed("slow", 0.02))
    failures.check("Gate: passed" in stdout, "passes the gate")
    stdout, _ = session.profile("slower than its baseline", FAILED, *ten, "--out", folder / "gate1",
                                "--baseline", changed("fast", 50))
    failures.check("slower" in stdout and "Gate: failed" in stdout and (folder / "gate1/report.json").exists(),
                   "says so, and leaves its report")
    session.refused("a baseline of another length", FILE, "--replay", good, "--no-draw", "--ticks", 100, "--baseline", baseline,
                    "--out", folder / "gate3", says="number of ticks")
    failures.check(not (folder / "gate3/report.json").exists(), "before anything is measured")
    stdout, _ = session.profile("a baseline from another machine", FINE, *ten, "--out", folder / "gate2",
                                "--baseline", changed("other", 50, cpu="another processor", commit="0123456789ab"))
    failures.check("another processor" in stdout and "0123456789ab" in stdout and "Gate: cannot judge" in stdout,
                   "says that it is from another machine and version, and does not judge")

    # What cannot be measured.
    session.refused("a replay that differs", DESYNC, "--replay", bad, "--no-draw", "--runs", 1, "--out", folder / "bad",
                    says="from tick 70 on")
    failures.check(not (folder / "bad/report.json").exists(), "and leaves no report")
    session.refused("no such replay", FILE, "--replay", folder / "none.gwr", "--no-draw", "--out", folder / "x", says="no such file")
    session.refused("no such contender", USAGE, "--compare", "ngrid,tree", "--no-draw", "--out", folder / "x", says="none of ngrid")
    (folder / "file").write_text("")
    session.refused("a folder that is a file", FILE, "--replay", good, "--no-draw", "--out", folder / "file", says="file")
    session.refused("a folder that cannot be made", FILE, "--replay", good, "--no-draw", "--out", "/proc/report", says="/proc/report")
    full = subprocess.run([program, "profile", "--replay", good, "--no-draw", "--runs", "1", "--out", folder / "full"],
                          env=without_display(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
    failures.check(full.returncode == FILE and len(full.stderr.splitlines()) == 1,
                   f"a folder without room: exit 3, one sentence: {full.stderr.strip()!r}")
    failures.check(not (folder / "full/report.json").exists(), "and no half of a report")

    session.refused("more ticks than it has", FILE, "--replay", good, "--no-draw", "--ticks", TICKS + 1, "--out", folder / "x",
                    says=f"has {TICKS} ticks")
    session.refused("a case twice", USAGE, "--enemies", "64,64", "--no-draw", "--out", folder / "x", says="names 64 twice")

    # Ctrl-C: what there is, or that there is nothing.
    if failures.count == 0 and not has_terminals():
        skip("Ctrl-C: there is no pseudo-terminal, since no devpts is mounted on /dev/pts; all else was fine")
    long = ["--scene", "five-minutes", "--no-draw", "--runs", 10, "--compare", "ngrid,grid"]
    code, stdout, _, shown = session.interrupt("in the first run", r"run 1 of 10, ngrid: [1-9]\d+ of 18000", folder / "short", *long)
    report = json.loads((folder / "short/report.json").read_text())
    failures.check(code == CTRL_C and report["setup"]["interrupted"] and "Interrupted after 1 run:" in stdout,
                   "Ctrl-C leaves a report of what there was")
    code, _, said, shown = session.interrupt("while the scene is recorded", r"recording ramp.*: [1-9]\d* of 3600, about .* left",
                                             folder / "nothing", "--scene", "ramp", "--enemies", 8000, "--no-draw")
    failures.check(code == CTRL_C and "before a single frame" in said and len(said.splitlines()) == 1,
                   "Ctrl-C before the first frame is reported")
    failures.check(not list(folder.glob("*/*.part-*")) and not os.path.exists(folder / "nothing/report.json"),
                   "nothing half-written is left")
    failures.finish()


if __name__ == "__main__":
    main()
