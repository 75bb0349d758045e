#!/usr/bin/env python3
"""Verifies the golden replays, each once, and that each still shows what it was recorded for.

Beside each replays/NAME.gwr of replays/golden.list stands replays/NAME.expect: what the run must at least
contain, so that no new recording can hollow it out (tests/replays/expectation.py says how). replays/golden.facts
holds what each showed when it was recorded; reports that tell otherwise are refused, for no hash covers them.

    golden_replays.py GPUWARS [--replays FOLDER] [-j N]
"""
import argparse
import os
import sys
from pathlib import Path

from expectation import Expectation
from golden_suite import (KEPT, MOST_BYTES, ROOT, golden_list, look_closer, read_facts, shortcomings,
                          verify)


def verified(gpuwars, folder, golden, jobs):
    """The facts of each, by name: those with the same options of verify at a time."""
    found = {}
    for options in dict.fromkeys(tuple(one.verified) for one in golden):
        names = [one.name for one in golden if tuple(one.verified) == options]
        facts = verify(gpuwars, [folder / f"{name}.gwr" for name in names], jobs, options)
        found.update(zip(names, facts, strict=True))
    return found


def other_facts(name, kept, facts):
    """Sentences on what the reports tell otherwise than golden.facts."""
    if name not in kept:
        return [f"{name}: golden.facts does not tell of it; tests/update_replays {name} writes it there"]
    return [f"{name}: {key} was {kept[name].get(key)} when it was recorded, is {facts[key]}; what reports tell has "
            "changed" for key in KEPT if facts[key] != kept[name].get(key)]


def check_files(folder, golden):
    wrong = []
    for kind in (".gwr", ".expect"):
        for path in sorted(folder.glob("*" + kind)):
            if path.stem not in golden:
                wrong.append(f"{path}: golden.list does not name it; add it there or delete the file")
    for name in golden:
        if not (folder / f"{name}.gwr").is_file():
            wrong.append(f"{folder / name}.gwr is missing: tests/update_replays {name} records it")
    size = sum(path.stat().st_size for path in folder.glob("*.gwr"))
    if size > MOST_BYTES:
        wrong.append(f"the replays have {size} bytes together, more than {MOST_BYTES}; shorten some")
    if not golden:
        wrong.append(f"{folder}/golden.list names no replay")
    return wrong


def check(gpuwars, folder, jobs):
    """All sentences on what is wrong with a folder of golden replays."""
    golden = golden_list(folder)
    wrong, expectations, kept = check_files(folder, golden), {}, read_facts(folder)
    for name in golden:
        try:
            expectations[name] = Expectation(folder / f"{name}.expect")
        except ValueError as error:
            wrong.append(str(error))
    present = [one for name, one in golden.items() if (folder / f"{name}.gwr").is_file() and name in expectations]
    for name, facts in verified(gpuwars, folder, present, jobs).items():
        if facts["equal"]:
            look_closer(gpuwars, folder / f"{name}.gwr", expectations[name], facts)
        lacks = shortcomings(name, expectations[name], facts)
        if facts["equal"]:
            lacks += other_facts(name, kept, facts)
        wrong += lacks
        print(f"{'FAIL ' if lacks else 'ok   '} {name}: {facts['ticksCompared']} ticks, "
              f"{facts['ticksPerSecond']:.0f} ticks/s", flush=True)
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gpuwars", type=Path)
    parser.add_argument("--replays", type=Path, default=ROOT / "replays")
    parser.add_argument("-j", type=int, default=os.cpu_count() or 1, dest="jobs")
    arguments = parser.parse_args()
    try:
        wrong = check(arguments.gpuwars, arguments.replays, arguments.jobs)
    except (OSError, ValueError) as error:
        wrong = [str(error)]
    for sentence in wrong:
        print(sentence, file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
