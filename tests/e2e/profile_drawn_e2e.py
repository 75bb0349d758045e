#!/usr/bin/env python3
"""Sessions that draw: without a window, in real time, behind the title, and in a window that is closed.

    profile_drawn_e2e.py GPUWARS FOLDER [window]      skipped without OpenGL; the window needs Xvfb and xdotool
"""
import csv
import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, skip
from screen import Screen, lit

FINE, FAILED = 0, 1
TICKS = 150
SMALL = ["--device", "cpu", "--runs", 1, "--width", 320, "--height", 200]


def report_in(out):
    return json.loads((out / "report.json").read_text())


def rows_of(out):
    with (out / "frames.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def profile(program, failures, name, out, *arguments):
    code, stdout, stderr = run(program, "profile", *SMALL, "--headless", "--out", out, *arguments)
    if code == FAILED and "No OpenGL" in stderr:
        skip("there is no OpenGL here")
    failures.check(code == FINE, f"{name}: exit 0: {stderr.strip()}")
    return report_in(out), stdout


def offscreen(program, folder, failures):
    report, _ = profile(program, failures, "two cases", folder / "cases", "--scene", "ramp", "--ticks", TICKS, "--enemies", "64,256",
                        "--effects", "off", "--compare", "ngrid,thesis")
    failures.check([case["enemies"] for case in report["cases"]] == [64, 256], "a case for each number of enemies")
    overall = report["cases"][1]["contenders"][0]["overall"]
    failures.check(overall["draw_ms.mean"]["value"] > 0 and overall["gl_ms.mean"]["value"] > 0, "drawing was timed, by OpenGL too")
    drawn = [row for row in rows_of(folder / "cases") if row["contender"] == "ngrid"]
    failures.check(len(drawn) == 2 * TICKS and all(float(row["draw_ms"]) > 0 for row in drawn), "every frame was drawn")
    longest = max(float(row["gl_ms"]) - float(row["draw_ms"]) - float(row["wait_ms"]) for row in drawn if row["gl_ms"])
    failures.check(longest < 1, f"by OpenGL no frame, the first included, takes longer than it did: {longest} ms")
    failures.check("droppedTicks" not in overall, "a tick a frame drops none, so none are told")
    failures.check(report["setup"]["drawn"] == "offscreen 320x200, effects off", f"says what was drawn: {report['setup']['drawn']}")
    failures.check(report["cases"][0]["speedUps"][0]["upkeepAndGathering"]["value"] is None,
                   "a shadow, which draws nothing, is not compared with who draws")

    report, _ = profile(program, failures, "the whole world without glow", folder / "world", "--scene", "swarm", "--ticks", 60,
                        "--enemies", 512, "--view", "world", "--glow", "off")
    failures.check(report["setup"]["drawn"] == "offscreen 320x200, the whole world, glow off", "says so")

    report, _ = profile(program, failures, "the menu", folder / "menu", "--scene", "menu", "--ticks", 60, "--enemies", 128)
    failures.check(report["setup"]["scene"] == "menu" and report["setup"]["mode"] == "arcade", "is a scene too")

    began = time.monotonic()
    report, _ = profile(program, failures, "in real time", folder / "paced", "--scene", "ramp", "--ticks", TICKS, "--enemies", 64,
                        "--paced")
    overall = report["cases"][0]["contenders"][0]["overall"]
    failures.check(time.monotonic() - began > TICKS / 60, f"takes as long as the game: {TICKS / 60} s")
    failures.check(report["setup"]["pacing"] == "real time" and "droppedTicks" in overall, "and tells what it dropped")
    failures.check(sum(int(row["ticks"]) for row in rows_of(folder / "paced")) == TICKS, "all ticks were played")


def in_a_window(program, folder, failures):
    screen = Screen(folder)
    try:
        def start(name, *arguments):
            child = subprocess.Popen([program, "profile", "--device", "cpu", "--width", "640", "--height", "400",
                                      "--scene", "ramp", "--enemies", "256", "--effects", "off", "--out",
                                      str(folder / name), *map(str, arguments)], env=screen.environment,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            failures.check(screen.wait_for(lambda pixels: lit(pixels) > 1500), f"{name}: a picture appears")
            return child

        def over(name, child, code):
            stdout, stderr = child.communicate(timeout=120)
            report = report_in(folder / name)
            failures.check(child.returncode == code and report["setup"]["interrupted"] and stderr == "",
                           f"{name}: leaves a report of what there was: {child.returncode} {stderr!r}")
            failures.check(report["setup"]["drawn"] == "window 640x400, effects off", f"{name}: {report['setup']['drawn']}")
            overall = report["cases"][0]["contenders"][0]["overall"]
            failures.check(overall["meanFps"]["value"] > 0 and overall["latency_ms.p50"]["value"] > 0,
                           f"{name}: {overall['meanFps']['value']:.0f} frames/s were shown")

        child = start("left")
        screen.picture("window.png")
        time.sleep(6)  # the warm-up takes 120 frames
        screen.keys("key", "Escape")
        over("left", child, FINE)
        child = start("interrupted", "--compare", "ngrid,grid")
        time.sleep(6)
        child.send_signal(signal.SIGINT)
        over("interrupted", child, 128 + signal.SIGINT)
    finally:
        screen.close()
    code, _, stderr = run(program, "profile", "--device", "cpu", "--scene", "ramp", "--enemies", 100000, "--out", folder / "nowhere")
    failures.check(code == FAILED and "No display" in stderr and len(stderr.splitlines()) == 1,
                   f"without a display: said before a scene is recorded: {stderr.strip()!r}")


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    window = "window" in sys.argv[3:]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    in_a_window(program, folder, failures) if window else offscreen(program, folder, failures)
    failures.finish()


if __name__ == "__main__":
    main()
