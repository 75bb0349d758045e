#!/usr/bin/env python3
"""Runs that are told to end: what there is of them is whole, and the exit status says so: 128 and the signal.

    interrupts_e2e.py GPUWARS FORGE_REPLAY FOLDER      the films need ffmpeg and ffprobe, else they are skipped and counted
"""
import json
import os
import pty
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, skip, without_display

FINE, FAILED, USAGE, BAD_FILE, DESYNC = range(5)
ALL = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
GAME = ("--headless", "--device", "cpu", "--autopilot", "expert", "--enemies", 256)
LONG = Path(__file__).resolve().parents[2] / "replays/expert_to_the_end.gwr"


def wait_for(there, seconds=60):
    until = time.monotonic() + seconds
    while not there() and time.monotonic() < until:
        time.sleep(0.02)


def usual_hangup(how=signal.SIG_DFL):
    """Before the program starts: as a shell, or as nohup leaves it."""
    signal.signal(signal.SIGHUP, how)


class Runs:
    def __init__(self, program, folder, failures):
        self.program, self.folder, self.failures = program, folder, failures
        self.replay = folder / "run.gwr"
        failures.check(run(program, *GAME, "--ticks", 240, "--record", self.replay)[0] == FINE, "a run is recorded")

    def start(self, *arguments, hangup=signal.SIG_DFL, environment=None):
        return subprocess.Popen([self.program, *map(str, arguments)], env=environment or without_display(),
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                preexec_fn=lambda: usual_hangup(hangup))

    def part_of(self, path):
        return lambda: any(path.parent.glob(path.name + ".part-*"))

    def ended(self, what, child, code):
        stdout, stderr = child.communicate(timeout=120)
        self.failures.check(child.returncode == code, f"{what}: ends with {child.returncode}, {code} is right: {stderr.strip()}")
        left = list(self.folder.glob("**/*part*"))
        self.failures.check(not left, f"{what}: no part is left {left}")
        return stdout, stderr

    def profile(self, out):
        return ("profile", "--device", "cpu", "--no-draw", "--replay", self.replay, "--runs", 1000, "--out", out)


def recordings(runs, failures):
    for how in ALL:
        target = runs.folder / f"{how.name}.gwr"
        child = runs.start(*GAME, "--ticks", 500000, "--record", target)
        wait_for(lambda: any(part.stat().st_size > 6000 for part in target.parent.glob(target.name + ".part-*")))
        child.send_signal(how)
        stdout, _ = runs.ended(f"a recording, {how.name}", child, 128 + how)
        failures.check("(interrupted)" in stdout and run(runs.program, "verify", target, "--device", "cpu")[0] == FINE,
                       "is reported, and is whole")
    out = runs.folder / "trimmed.gwr"
    child = runs.start("trim", LONG, "--out", out, "--device", "cpu")
    time.sleep(1)
    child.send_signal(signal.SIGINT)
    _, stderr = runs.ended("trim", child, 130)
    failures.check("nothing was written" in stderr and not out.exists(), f"writes nothing: {stderr.strip()}")


def reports(runs, failures):
    for how in ALL:
        out = runs.folder / how.name
        child = runs.start(*runs.profile(out))
        wait_for(runs.part_of(out / "frames.csv"))
        child.send_signal(how)
        stdout, _ = runs.ended(f"a session, {how.name}", child, 128 + how)
        report = json.loads((out / "report.json").read_text())
        rows = len((out / "frames.csv").read_text().splitlines())
        failures.check(report["setup"]["interrupted"] and "Interrupted after" in stdout and rows % 240 == 1 and rows > 1,
                       f"leaves a report, and {rows} rows of frames")

    # nohup: no terminal matters. A run that ends by itself ends well.
    out = runs.folder / "nohup"
    arguments = [*runs.profile(out)]
    arguments[arguments.index(1000)] = 20
    child = runs.start(*arguments, hangup=signal.SIG_IGN)
    wait_for(runs.part_of(out / "frames.csv"))
    child.send_signal(signal.SIGHUP)
    runs.ended("a session under nohup", child, FINE)
    failures.check(not json.loads((out / "report.json").read_text())["setup"]["interrupted"], "goes on to its end")

    # A terminal that is closed: the system sends the signal, and no terminal is left to write to.
    out = runs.folder / "terminal"
    child, terminal = pty.fork()
    if child == 0:
        usual_hangup()
        os.execve(runs.program, [runs.program, *map(str, runs.profile(out))], without_display())
    wait_for(runs.part_of(out / "frames.csv"))
    os.close(terminal)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    failures.check(status == 129 and json.loads((out / "report.json").read_text())["setup"]["interrupted"],
                   f"a terminal that is closed: ends with {status}, and leaves a report")


def worse(runs, failures, forge):
    """What a run has found out counts more than that it was interrupted."""
    bad = runs.folder / "bad.gwr"
    run(forge, runs.replay, bad, "hash", 70)
    out = runs.folder / "verify.json"
    child = runs.start("verify", bad, LONG, "--device", "cpu", "--json", out)
    failures.check("DESYNC" in child.stdout.readline(), "a desync is found")
    child.send_signal(signal.SIGINT)
    runs.ended("verify", child, DESYNC)
    found = json.loads(out.read_text())
    failures.check(found["exitCode"] == DESYNC and "interrupted" in found["replays"][1]["error"], "and JSON tells both")
    child = runs.start("verify", LONG, "--device", "cpu", "--json", out)
    time.sleep(1)
    child.send_signal(signal.SIGTERM)
    runs.ended("verify without one", child, 143)
    failures.check(json.loads(out.read_text())["exitCode"] == 143, "and JSON says so")


def second_signal(runs, failures):
    """An ffmpeg that does not come to its end; a second signal means now, and takes the unreadable part along."""
    folder = runs.folder / "programs"
    folder.mkdir()
    slow = folder / "ffmpeg"
    slow.write_text('#!/bin/sh\ncase "$*" in *-encoders*) exit 0;; esac\ncat > /dev/null\nexec sleep 8\n')
    slow.chmod(0o755)
    film = runs.folder / "earlier.mp4"
    film.write_text("an earlier film")
    environment = {**without_display(), "PATH": f"{folder}:{os.environ['PATH']}"}

    def started():
        child = runs.start("render", LONG, "--out", film, "--width", 320, "--height", 200, environment=environment)
        wait_for(runs.part_of(film))
        time.sleep(0.5)
        return child

    child = started()
    child.send_signal(signal.SIGTERM)
    time.sleep(0.02)
    child.send_signal(signal.SIGTERM)  # as timeout(1) does
    child.send_signal(signal.SIGHUP)
    time.sleep(1)
    failures.check(child.poll() is None, "two signals at once are one wish")
    child.send_signal(signal.SIGHUP)
    time.sleep(0.5)
    failures.check(child.poll() is None, "and a terminal is closed as often as it likes")
    child.send_signal(signal.SIGTERM)
    runs.ended("a second signal", child, -signal.SIGTERM)
    failures.check(film.read_text() == "an earlier film", "the earlier film stays")


def films(runs, failures):
    for how in ALL:
        film = runs.folder / f"{how.name}.mp4"
        child = runs.start("render", LONG, "--out", film, "--width", 320, "--height", 200)
        wait_for(runs.part_of(film))
        time.sleep(2)
        child.send_signal(how)
        _, stderr = runs.ended(f"a film, {how.name}", child, 128 + how)
        whole = subprocess.run(["ffprobe", "-v", "error", film], stdout=subprocess.DEVNULL).returncode == 0
        failures.check(whole and "Interrupted at tick" in stderr, "is whole, and says where it ends")


def main():
    program, forge, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    runs = Runs(program, folder, failures)
    recordings(runs, failures)
    reports(runs, failures)
    worse(runs, failures, forge)
    second_signal(runs, failures)
    if failures.count == 0 and not (shutil.which("ffmpeg") and shutil.which("ffprobe")):
        skip("films: ffmpeg or ffprobe is not installed; all else was fine")
    films(runs, failures)
    failures.finish()


if __name__ == "__main__":
    main()
