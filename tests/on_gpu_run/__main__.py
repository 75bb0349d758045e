"""Runs all that needs a GPU, step by step, and says in one table what came of it. tests/on_gpu --run starts it.

Python's own library only: the machine may have nothing else. Every step has a time limit, and so has the whole.
"""
import argparse
import contextlib
import shlex
import sys
import tempfile
import time
from pathlib import Path

import correctness
import figures
import machine
import sanitizer
from outcome import FAILED, FIGURE, Outcome
from programs import Programs
from sizes import sizes_for

STEPS = {"arithmetic": correctness.arithmetic, "parity": correctness.parity, "replays": correctness.replays,
         "pictures": correctness.pictures, "sanitizer": sanitizer.sanitizer, "ticks": figures.ticks,
         "neighbours": figures.neighbours}
TOTAL_S = 470  # of the eight minutes that a run may take


def arguments():
    parser = argparse.ArgumentParser(prog="on_gpu --run", description="Tests and measures one device.")
    parser.add_argument("--device", choices=("cuda", "cpu"), default="cuda")
    parser.add_argument("--quick", action="store_true", help="little of everything; its figures mean nothing")
    parser.add_argument("--programs", type=Path, required=True, help="folder of the programs")
    parser.add_argument("--replays", type=Path, required=True, help="folder of the golden replays")
    parser.add_argument("--only", choices=STEPS, action="append", help="this step, and others named so; default: all")
    parser.add_argument("--table", type=Path, help="keeps the table")
    parser.add_argument("--json", type=Path, help="keeps every row, with date, machine and command")
    parser.add_argument("--out", type=Path, help="folder for pictures; default: none is kept")
    return parser.parse_args()


def no_device(programs):
    """One sentence when the device is asked for and does not answer; empty when it does."""
    if programs.device == "cpu":
        return ""
    run = programs.run("gpuwars", "play", "--headless", "--ticks", 1, "--device", "cuda", *programs.assets, limit=60)
    return "" if run.fine else (run.text.strip().splitlines() or [run.why])[-1]


def main():
    given = arguments()
    if not (given.programs / "gpuwars").is_file():
        sys.exit(f"There is no gpuwars in {given.programs}: build the preset release, or run in a folder of --pack.")
    with contextlib.ExitStack() as stack:
        out = given.out or Path(stack.enter_context(tempfile.TemporaryDirectory()))
        out.mkdir(parents=True, exist_ok=True)
        logs = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        outcome = Outcome(given.device)
        programs = Programs(given.programs, outcome, logs, TOTAL_S)
        missing = no_device(programs)
        if missing:
            sys.exit(missing)
        outcome.computing = machine.computing(programs) + (", little of everything" if given.quick else "")
        begin = time.monotonic()
        sizes = sizes_for(given.device, given.quick, given.replays, out.resolve())
        for name, step in STEPS.items():
            if given.only and name not in given.only:
                continue
            step_begin = time.monotonic()
            try:
                step(programs, outcome, sizes)
            except (OSError, ValueError, KeyError) as error:  # what a program wrote is not what was expected
                outcome.add(name, "as a whole", FAILED, f"{type(error).__name__}: {error}")
            print(f"{name}: {time.monotonic() - step_begin:.1f} s", flush=True)
        outcome.add("run", "time", FIGURE, f"{time.monotonic() - begin:.0f} s", seconds=time.monotonic() - begin)
        outcome.conclude()
        table = outcome.table()
        if given.table:
            given.table.write_text(table)
        if given.json:
            outcome.write_json(given.json, machine.facts(shlex.join(["on_gpu", "--run", *sys.argv[1:]])))
        print(table, end="")
        sys.exit(outcome.exit_status)


if __name__ == "__main__":
    main()
