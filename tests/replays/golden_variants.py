#!/usr/bin/env python3
"""Short golden replays in every way a run can be computed: none may change a single hash.

    golden_variants.py GPUWARS [--replays FOLDER]

A variant is a line of VARIANTS: options of verify, and for which replays. Exact games are free in how neighbours are
found; where the game depends on the arrangement of the NGrid, only threads and order are.
"""
import argparse
import sys
from pathlib import Path

from golden_suite import ROOT, golden_list, verify

# One of each machine; `together` has ties by id and zero distances too.
EXACT = ("hexagon_alone", "together_texels", "together_fragments")
INEXACT = ("adaptive_odd_even",)
EVERY = EXACT + INEXACT
VARIANTS = (
    ("1 thread", "--threads 1", EVERY),
    ("2 threads", "--threads 2", EVERY),
    ("3 threads", "--threads 3", EVERY),
    ("7 threads", "--threads 7", EVERY),
    ("16 threads", "--threads 16", EVERY),
    ("reversed", "--order reversed", EVERY),
    ("shuffled", "--order shuffled", EVERY),
    ("shuffled, 3 threads", "--order shuffled --threads 3", EVERY),
    ("grid", "--broad-phase grid", EXACT),
    ("grid, shuffled", "--broad-phase grid --order shuffled", EXACT),
    ("hashed grid", "--broad-phase grid-hashed", EXACT),
    ("hashed grid, shuffled", "--broad-phase grid-hashed --order shuffled", EXACT),
    ("brute force", "--broad-phase brute", EXACT),
    ("bitonic", "--sort bitonic", EXACT),
    ("full sort", "--sort full", EXACT),
    ("protected memory", "--protect-memory", EVERY),
    ("heavy", "--heavy", EVERY),  # a snapshot is taken and restored after every tick
)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gpuwars", type=Path)
    parser.add_argument("--replays", type=Path, default=ROOT / "replays")
    arguments = parser.parse_args()
    wrong = [f"golden.list does not name {name}, which VARIANTS asks for"
             for name in EVERY if name not in golden_list(arguments.replays)]
    compared = 0
    for title, options, names in VARIANTS if not wrong else ():
        ticks = 0
        for facts in verify(arguments.gpuwars, [arguments.replays / f"{name}.gwr" for name in names], 1, options.split()):
            ticks += facts["ticksCompared"]
            if not facts["equal"] or facts["ticksCompared"] != facts["ticks"]:
                first = facts.get("firstDifference", {}).get("tick")
                wrong.append(f"{title}: {facts['file']}: "
                             + (f"differs from tick {first} on" if first else str(facts.get("error"))))
        compared += ticks
        print(f"{title}: {ticks} ticks compared", flush=True)
    print(f"{len(VARIANTS)} variants, {compared} ticks")
    for sentence in wrong:
        print(sentence, file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError) as error:
        sys.exit(str(error))
