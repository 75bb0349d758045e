#!/usr/bin/env python3
"""Every mode without a window: the summary names it and how it ended, and the recording agrees.

    headless_modes_e2e.py GPUWARS FOLDER      needs no display
"""
import json
import shutil
import sys
from pathlib import Path

from program import Failures, run

# Few enemies, so that the whole run takes seconds. No input where the end comes by itself.
CASES = (
    ("arcade", "under 12.0 FPS", "frame_rate", ("--enemies", 64, "--ticks", 20000)),
    ("arcade", "not over", "none", ("--enemies", 64, "--ticks", 60)),
    ("deadline", "time up", "time_up", ("--enemies", 2, "--ticks", 20000)),
    ("swarm", "cleared", "cleared", ("--enemies", 2, "--ticks", 20000, "--autopilot", "expert")),
    ("practice", "not over", "none", ("--enemies", 64, "--ticks", 600, "--autopilot", "expert")),
)


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    for number, (mode, words, ending, options) in enumerate(CASES):
        recording = folder / f"{number}.gwr"
        code, stdout, stderr = run(program, "--headless", "--mode", mode, "--record", recording, *options)
        said = [line.split(maxsplit=1)[1] for line in stdout.splitlines() if line.startswith("mode ")]
        failures.check(code == 0 and said == [f"{mode}: {words}"], f"{mode}: {words}; it says {said}, {stderr!r}")
        code, out, _ = run(program, "verify", recording, "--json", "-")
        replay = json.loads(out)["replays"][0]
        failures.check((code, replay["mode"], replay["ending"]) == (0, mode, ending),
                       f"the recording says so too: {replay['mode']}, {replay['ending']}, {replay['ticks']} ticks")
    failures.finish()


if __name__ == "__main__":
    main()
