#!/usr/bin/env python3
"""Listens to the program itself: OpenAL Soft writes what it would play into a file, or finds no device at all.

    sound_e2e.py GPUWARS FOLDER      needs what screen.py does
"""
import array
import shutil
import sys
from pathlib import Path

from program import Failures, run
from screen import Screen

RUN = ("--autopilot", "expert", "--seed", "7", "--ticks", "150", "--width", "320", "--height", "200")


def samples_of(path):
    """Of a file with 16-bit samples, as shares of full scale."""
    data = path.read_bytes()
    begin = data.index(b"data") + 8
    return [value / 32768 for value in array.array("h", data[begin:len(data) - (len(data) - begin) % 2])]


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    screen = Screen(folder)
    try:
        silent = {**screen.environment, "ALSOFT_DRIVERS": "none"}
        code, _, said = run(program, *RUN, environment=silent)
        failures.check(code == 0, f"the game goes on without a sound device: exit {code}")
        failures.check(said.count("\n") == 1 and "no sound device" in said, f"it says so in one line: {said!r}")
        code, _, said = run(program, *RUN, "--mute", environment=silent)
        failures.check(code == 0 and said == "", f"muted it says nothing: {said!r}")

        written = folder / "heard.wav"
        settings = folder / "openal.conf"
        settings.write_text("[general]\nchannels = stereo\nsample-type = int16\nfrequency = 44100\n"
                            f"[wave]\nfile = {written}\n")
        heard = {**screen.environment, "ALSOFT_DRIVERS": "wave", "ALSOFT_CONF": str(settings)}
        code, _, said = run(program, *RUN, environment=heard)
        failures.check(code == 0 and said == "", f"with a device it plays and says nothing: {said!r}")
        if failures.check(written.is_file(), "and something was played"):
            samples = samples_of(written)
            peak = max(map(abs, samples), default=0)
            rms = (sum(v * v for v in samples) / max(1, len(samples))) ** 0.5
            failures.check(len(samples) > 44100 and 0.005 < rms < 0.2, f"{len(samples)} samples, RMS {rms:.3f}")
            failures.check(peak < 0.9, f"none near the limit: peak {peak:.2f}")
            written.unlink()
        code, _, said = run(program, *RUN, "--mute", environment=heard)
        failures.check(code == 0 and not written.exists(), "muted it opens no device")
    finally:
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
