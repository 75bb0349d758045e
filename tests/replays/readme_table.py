#!/usr/bin/env python3
"""The table in replays/README.md, made from golden.list, the .expect files, golden.facts and the files' sizes.

    readme_table.py [--replays FOLDER] [--write]       without --write: says whether it is up to date
"""
import argparse
import sys
from pathlib import Path

from expectation import Expectation
from golden_suite import ROOT, golden_list, read_facts, replace

BEGIN, END = "<!-- table: tests/update_replays writes it -->", "<!-- end of table -->"


def option(golden, name, otherwise):
    return golden.recorded[golden.recorded.index(name) + 1] if name in golden.recorded else otherwise


def made(golden):
    """How it was recorded, in words."""
    if golden.person:
        return "a person's inputs"
    who = f"script `{golden.script}`" if golden.script else option(golden, "--autopilot", "no autopilot")
    words, rest = [who, f"seed {option(golden, '--seed', '1')}"], list(golden.recorded)
    while rest:
        word = rest.pop(0)
        if word in ("--with-sight", "--with-waves-of", "--with", "--gather", "--sort"):
            words.append(f"`{word} {rest.pop(0)}`")
        elif word == "--thesis":
            words.append(f"`{word}`")
    if golden.verified:
        words.append(f"verified with `{' '.join(golden.verified)}`")
    return ", ".join(words)


def ending(facts):
    return {"frame_rate": "under 12 FPS", "time_up": "time up", "cleared": "cleared"}.get(facts["ending"], "goes on")


def table(folder):
    """The rows, and a line that adds them up."""
    golden, facts = golden_list(folder), read_facts(folder)
    rows = ["| replay | guards | mode | ticks | end | enemies fit | kills | KiB | made by |",
            "|---|---|---|---|---|---|---|---|---|"]
    ticks = size = 0
    for name, one in golden.items():
        if name not in facts:
            raise ValueError(f"golden.facts does not tell of {name}; tests/update_replays {name} writes it there")
        told, bytes_ = facts[name], (folder / f"{name}.gwr").stat().st_size
        ticks, size = ticks + told["ticks"], size + bytes_
        rows.append(f"| `{name}` | {Expectation(folder / f'{name}.expect').guards} | {told['mode']} | "
                    f"{told['ticks']:,} | {ending(told)} | {told['enemiesFit']:,} | {told['kills']:,} | "
                    f"{bytes_ / 1024:.0f} | {made(one)} |")
    rows.append("")
    rows.append(f"{len(golden)} replays, {ticks:,} ticks, {size / 1024:,.0f} KiB.")
    return "\n".join(rows)


def with_table(folder):
    """The text of README.md as it should be."""
    text = (folder / "README.md").read_text()
    before, begin, rest = text.partition(BEGIN)
    _old, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"{folder}/README.md has lost the marks of its table; put back '{BEGIN}' and '{END}'")
    return f"{before}{BEGIN}\n{table(folder)}\n{END}{after}"


def write(folder):
    if (folder / "README.md").is_file():
        replace(folder / "README.md", with_table(folder))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--replays", type=Path, default=ROOT / "replays")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    if arguments.write:
        write(arguments.replays)
    elif with_table(arguments.replays) != (arguments.replays / "README.md").read_text():
        sys.exit("replays/README.md is out of date; run tests/replays/readme_table.py --write")


if __name__ == "__main__":
    try:
        main()
    except (OSError, ValueError) as error:
        sys.exit(str(error))
