"""compute-sanitizer on a short game: reads of uninitialised memory, accesses out of bounds, races."""
import os
import re
import shutil

from outcome import FAILED, PASSED, SKIPPED

TOOLS = ("memcheck", "racecheck", "initcheck")
USUAL_PLACE = "/usr/local/cuda/bin/compute-sanitizer"
SUMMARY = re.compile(r"(?:ERROR|RACECHECK) SUMMARY: (\d+) (?:error|hazard)")


def reports_in(text):
    """How many reports the tool's last line counts; None when there is no such line."""
    found = SUMMARY.findall(text)
    return sum(map(int, found)) if found else None


def sanitizer(programs, outcome, sizes):
    tool = shutil.which("compute-sanitizer") or (USUAL_PLACE if os.access(USUAL_PLACE, os.X_OK) else None)
    why = "it looks at the cuda device" if programs.device == "cpu" else None if tool else "is not on this machine"
    for kind in TOOLS:
        if why:
            outcome.add("compute-sanitizer", kind, SKIPPED, why)
            continue
        run = programs.run("gpuwars", "play", "--headless", "--ticks", sizes.sanitised_ticks, "--autopilot", "expert",
                           "--device", "cuda", "--seed", 1, *programs.assets, limit=60,
                           before=(tool, "--tool", kind, "--error-exitcode", "1"))
        reports = reports_in(run.text)
        clean = run.fine and reports == 0
        text = run.why if reports is None or run.stopped else f"{reports} reports in {sizes.sanitised_ticks} ticks"
        outcome.add("compute-sanitizer", kind, PASSED if clean else FAILED, text, run.command, reports=reports)
