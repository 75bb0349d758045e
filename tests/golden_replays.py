#!/usr/bin/env python3
"""Verifies the golden replays, and that each still shows what it was recorded for.

Beside each replays/NAME.gwr of replays/golden.list stands replays/NAME.expect: what the run must at least
contain, so that no new recording can hollow it out. Lines are `key = value`; `#` starts a comment.

    ticks = 3600                            at least; so for all numbers. ticks, kills, over are required
    kills = 500
    kills.vertex = 100                      of one type
    peakEnemies, refused, contacts, flushes, shots, bitsTaken, score, travelled_m
    mode = arcade                           the mode's name
    over = frame_rate                       how it ends: frame_rate, time_up, cleared; no: it does not
    edge = group: attacking -> grouping     this state change happens; as often as needed
    edges = tricky                          every one of this machine; all: of all three

    golden_replays.py GPUWARS [--replays FOLDER] [-j N]
"""
import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NUMBERS = ("ticks", "kills", "peakEnemies", "refused", "contacts", "flushes", "shots", "bitsTaken", "score",
           "travelled_m")
ENDINGS = ("frame_rate", "time_up", "cleared", "no")
MODES = ("arcade", "deadline", "swarm", "practice")
REQUIRED = ("ticks", "kills", "over")
REPEATED = ("edge", "edges")


class Expectation:
    """One .expect file. Raises ValueError, one sentence, when it is missing or wrong."""

    def __init__(self, path):
        self.values, self.edges = {}, []
        if not path.is_file():
            raise ValueError(f"{path} is missing: write down there what the replay must show")
        for number, line in enumerate(path.read_text().splitlines(), 1):
            line = line.partition("#")[0].strip()
            if line:
                try:
                    self._add(*(part.strip() for part in line.partition("=")))
                except ValueError as error:
                    raise ValueError(f"{path}:{number}: {error}") from None
        for key in REQUIRED:
            if key not in self.values:
                raise ValueError(f"{path}: '{key}' is missing; a replay that need not show it shows nothing")

    def _add(self, key, equals, value):
        if not equals:
            raise ValueError(f"'{key}' has no value; write key = value")
        if key in REPEATED:
            self.edges.append((key, value))
            return
        if key in self.values:
            raise ValueError(f"'{key}' stands twice; keep one")
        words = {"over": ENDINGS, "mode": MODES}.get(key)
        if words:
            if value not in words:
                raise ValueError(f"'{key}' is one of {', '.join(words)}, not '{value}'")
            self.values[key] = value
        elif key in NUMBERS or (key.startswith("kills.") and key != "kills."):
            if not value.isascii() or not value.isdigit() or int(value) == 0:
                raise ValueError(f"'{key}' takes a whole number from 1, not '{value}'")
            self.values[key] = int(value)
        else:
            raise ValueError(f"there is no key '{key}'; tests/golden_replays.py lists them")

    def unmet(self, facts):
        """Sentences on what a verified run lacks; `facts` is its entry in the output of verify --json."""
        lacks = []
        for key, wanted in self.values.items():
            if key == "over":
                is_so = facts["ending"] if facts["over"] else "no"
            elif key == "mode":
                is_so = facts["mode"]
            elif key.startswith("kills."):
                name = key.removeprefix("kills.")
                if name not in facts["killsByType"]:
                    lacks.append(f"{key}: there is no such type; there are {', '.join(facts['killsByType'])}")
                    continue
                is_so = facts["killsByType"][name]
            else:
                is_so = facts[key]
            if isinstance(wanted, str) and is_so != wanted:
                lacks.append(f"{key} must be {wanted}, is {is_so}")
            elif isinstance(wanted, int) and is_so < wanted:
                lacks.append(f"{key} must be at least {wanted}, is {is_so}")
        for key, value in self.edges:
            lacks += self._unmet_edge(value, facts["edges"]) if key == "edge" else self._unmet_edges(value, facts["edges"])
        return lacks

    @staticmethod
    def _unmet_edge(value, machines):
        machine, _, edge = (part.strip() for part in value.partition(":"))
        if machine not in machines:
            return [f"edge '{value}': there is no machine '{machine}'; there are {', '.join(machines)}"]
        if edge not in machines[machine]:
            return [f"edge '{value}': no such edge; {machine} has {', '.join(machines[machine])}"]
        return [] if machines[machine][edge] else [f"edge '{value}' is never taken"]

    @staticmethod
    def _unmet_edges(value, machines):
        if value != "all" and value not in machines:
            return [f"edges '{value}': there is no such machine; there are {', '.join(machines)}, or all"]
        return [f"edge '{machine}: {edge}' is never taken" for machine in machines if value in ("all", machine)
                for edge, count in machines[machine].items() if count == 0]


def golden_list(folder):
    """The names of golden.list with their options, as text."""
    golden, path = {}, folder / "golden.list"
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        name, bar, options = (part.strip() for part in line.partition("|"))
        if not bar or not name or name in golden:
            raise ValueError(f"{path}:{number}: expected 'name | options', each name once")
        golden[name] = options
    return golden


def verify(gpuwars, files, jobs, more=()):
    """What verify --json says of each file, in their order."""
    command = [gpuwars, "verify", *files, "--device", "cpu", "-j", str(jobs), "--json", "-", *more]
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    try:
        return json.loads(result.stdout)["replays"]
    except (ValueError, KeyError):
        raise ValueError(f"verify failed ({result.returncode}): {result.stderr.decode(errors='replace')}") from None


def shortcomings(name, expectation, facts):
    """Why one verified replay is not good; nothing when it is."""
    if not facts["equal"]:
        first = facts.get("firstDifference", {}).get("tick")
        cause = f"differs from tick {first} on" if first else facts.get("error") or facts.get("wrongResult")
        return [f"{name}: {cause}"]
    return [f"{name}: {sentence}; see replays/{name}.expect" for sentence in expectation.unmet(facts)]


def check(gpuwars, folder, jobs):
    """All sentences on what is wrong with a folder of golden replays."""
    wrong, expectations = [], {}
    names = list(golden_list(folder))
    for kind in (".gwr", ".expect"):
        for path in sorted(folder.glob("*" + kind)):
            if path.stem not in names:
                wrong.append(f"{path}: golden.list does not name it; add it there or delete the file")
    for name in names:
        if not (folder / f"{name}.gwr").is_file():
            wrong.append(f"{folder / name}.gwr is missing: tests/update_replays {name} records it")
        try:
            expectations[name] = Expectation(folder / f"{name}.expect")
        except ValueError as error:
            wrong.append(str(error))
    present = [name for name in names if (folder / f"{name}.gwr").is_file() and name in expectations]
    if not names:
        wrong.append(f"{folder}/golden.list names no replay")
    if present:
        found = verify(gpuwars, [folder / f"{name}.gwr" for name in present], jobs)
        for name, facts in zip(present, found, strict=True):
            lacks = shortcomings(name, expectations[name], facts)
            wrong += lacks
            print(f"{'FAIL ' if lacks else 'ok   '} {name}: {facts['ticksCompared']} ticks", flush=True)
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
