#!/usr/bin/env python3
"""Files and pictures are the same in a locale with decimal commas.

    locale_e2e.py GPUWARS COMMA_LOCALE FOLDER      skipped where there is no such locale and localedef makes none
"""
import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

from program import Failures, run, skip, without_display

FINE = 0
NAME = "de_DE.UTF-8"


def with_commas(folder, preload):
    """The environment of a program with decimal commas, or none."""
    environment = {**without_display(), "LC_ALL": NAME, "LOCPATH": str(folder), "LD_PRELOAD": str(preload),
                   "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"}
    made = shutil.which("localedef") and subprocess.run(
        ["localedef", "-i", "de_DE", "-f", "UTF-8", folder / NAME], stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL).returncode in (0, 1)
    if not made or not (folder / NAME).is_dir():
        del environment["LOCPATH"]
    said = subprocess.run(["printf", "%.1f", "0"], env={**environment, "LD_PRELOAD": ""}, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout
    return environment if said == "0,0" else None


def main():
    program, preload, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    commas = with_commas(folder, preload)
    if commas is None:
        skip("no locale with decimal commas, and localedef makes none")

    def good(name, *arguments, environment=commas):
        code, stdout, stderr = run(program, *arguments, environment=environment)
        failures.check(code == FINE and stderr == "", f"{name}: {code} {stderr.strip()!r}")
        return stdout

    replay = folder / "run.gwr"
    good("a run is recorded", "--headless", "--device", "cpu", "--autopilot", "expert", "--enemies", 64, "--ticks", 90,
         "--record", replay)
    junit, out = folder / "junit.xml", folder / "out.json"
    stdout = good("it verifies", "verify", replay, "--device", "cpu", "--junit", junit, "--json", out)
    seconds = [element.get("time") for element in ElementTree.parse(junit).iter() if element.get("time")]
    failures.check(len(seconds) == 2 and all(float(text) > 0 for text in seconds), f"JUnit's times are numbers: {seconds}")
    failures.check(json.loads(out.read_text())["replays"][0]["ticksPerSecond"] > 0, "so are JSON's")
    failures.check(" ticks/s" in stdout and "." in stdout.split(" ticks/s")[0].rsplit(" ", 1)[1], f"and a person's: {stdout}")
    good("a picture is drawn", "render", replay, "--out", folder / "commas.png", "--width", 640, "--height", 360)
    good("and without commas", "render", replay, "--out", folder / "points.png", "--width", 640, "--height", 360,
         environment=without_display())
    failures.check((folder / "commas.png").read_bytes() == (folder / "points.png").read_bytes(), "which is the same picture")
    good("a session", "profile", "--device", "cpu", "--replay", replay, "--no-draw", "--runs", 2, "--out", folder / "report")
    with (folder / "report/frames.csv").open(newline="") as file:
        rows = list(csv.reader(file))
    failures.check(len({len(row) for row in rows}) == 1 and float(rows[1][rows[0].index("total_ms")]) > 0,
                   "frames.csv has a number in each column")
    failures.check(isinstance(json.loads((folder / "report/report.json").read_text())["gpuwarsProfile"], int), "report.json is JSON")
    failures.finish()


if __name__ == "__main__":
    main()
