#!/usr/bin/env python3
"""Libraries that change how the processor computes, before main or while the game runs, change neither a recording, nor
what verify says, nor a picture.

    float_state_e2e.py GPUWARS CHANGE_FLOAT_STATE REPLAYS FOLDER
"""
import platform
import shutil
import sys
from pathlib import Path

from program import Failures, run, skip, without_display

# What is added to MXCSR or FPCR.
STATES = {"x86_64": {"round to zero": 0x6000, "round up": 0x4000, "round down": 0x2000, "flush subnormals": 0x8040},
          "aarch64": {"round to zero": 3 << 22, "round up": 1 << 22, "round down": 2 << 22, "flush subnormals": 1 << 24}}
GAME = ("--headless", "--device", "cpu", "--seed", 7, "--autopilot", "expert", "--enemies", 2000, "--ticks", 300)
GOLDEN = ("with_grid", "first_seconds", "together", "thesis")


def changed(library, bits, where):
    return {**without_display(), "LD_PRELOAD": str(library), "GW_FLOAT_BITS": hex(bits), "GW_FLOAT_WHERE": where}


def recording(failures, program, path, *options, environment=None):
    """The hashes of its ticks, as a program in the default state computes them again."""
    code, _, stderr = run(program, *GAME, *options, "--record", path, environment=environment)
    failures.check(code == 0 and stderr == "", f"{path.name} is recorded{stderr and ': ' + stderr}")
    code, hashes, stderr = run(program, "verify", path, "--device", "cpu", "--hashes", "-")
    failures.check(code == 0, f"and verifies elsewhere{stderr and ': ' + stderr}")
    return hashes


def check_state(failures, program, library, name, bits, plain, golden, folder):
    for where, jobs in (("start", 1), ("threads", 2), ("always", 2)):
        environment = changed(library, bits, where)
        for kind, options in (("exact", ()), ("thesis", ("--thesis",))):
            path = folder / f"{kind} {name} {where}.gwr"
            same = recording(failures, program, path, *options, environment=environment) == plain[kind]
            failures.check(same, f"{name}, {where}: {kind}: the same recording")
        code, stdout, stderr = run(program, "verify", *golden, "--device", "cpu", "-j", jobs, environment=environment)
        failures.check(code == 0 and stdout.count("equal ") == len(golden) and stderr == "",
                       f"{name}, {where}: {len(golden)} golden replays are equal with -j {jobs}"
                       + ("" if code == 0 else f": {stdout}") + stderr)


def check_picture(failures, program, library, states, replay, folder):
    """Of the whole picture, with its text and its effects."""
    def picture(path, environment=None):
        code, _, stderr = run(program, "render", replay, "--device", "cpu", "--out", path, "--from", 300, "--width", 320,
                              "--height", 200, environment=environment)
        return path.read_bytes() if code == 0 else stderr

    plain = picture(folder / "plain.png")
    if isinstance(plain, str):
        print(f"      no picture can be drawn here, so none was compared: {plain.strip()}")
        return
    for name, bits in states.items():
        same = picture(folder / f"{name}.png", changed(library, bits, "start")) == plain
        failures.check(same, f"{name}, start: the same picture")


def main():
    program, library, replays, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]), Path(sys.argv[4])
    states = STATES.get(platform.machine())
    if states is None:
        skip(f"this test does not know the floating-point state of {platform.machine()}")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    golden = [replays / f"{name}.gwr" for name in GOLDEN]
    plain = {"exact": recording(failures, program, folder / "exact.gwr"),
             "thesis": recording(failures, program, folder / "thesis.gwr", "--thesis")}
    for name, bits in states.items():
        check_state(failures, program, library, name, bits, plain, golden, folder)
    check_picture(failures, program, library, states, folder / "exact.gwr", folder)
    failures.finish()


if __name__ == "__main__":
    main()
