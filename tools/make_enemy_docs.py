#!/usr/bin/env python3
"""Writes docs/reference/enemies.md and the diagrams of the state machines from the tables.

    tools/make_enemy_docs.py DESCRIBE_ENEMIES [--check]

DESCRIBE_ENEMIES is the program of that name, of a build. --check writes nothing, and fails when a file is out of date.
"""
import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

import state_diagram

ROOT = Path(__file__).resolve().parent.parent
REFRESH = "tools/make_enemy_docs.py build/release/describe_enemies"


def number(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def size_of(enemy):
    if enemy["circle"]:
        return f"circle, radius {number(enemy['halfWidth_m'])} m"
    return f"rectangle, {number(2 * enemy['halfWidth_m'])} x {number(2 * enemy['halfHeight_m'])} m"


class Page:
    """Fills the template's {{ ... }}."""

    def __init__(self, facts):
        self.facts = facts
        self.enemies = {enemy["name"]: enemy for enemy in facts["enemies"]}
        self.told = set()

    def overview(self):
        lines = ["| type | machine | bounds | speed, m/s | sight, m | energy | mass | contact, ms | value | bits |",
                 "|---|---|---|---|---|---|---|---|---|---|"]
        for enemy in self.facts["enemies"]:
            cells = [f"[{enemy['name']}](#{enemy['name']})", enemy["machine"], size_of(enemy)]
            cells += [number(enemy[key]) for key in ("speed_mps", "sight_m", "energy", "mass")]
            cells += [number(enemy["contact_us"] / 1000), str(enemy["value"]), str(enemy["bits"])]
            lines.append(f"| {' | '.join(cells)} |")
        return "\n".join(lines)

    def machine(self, name):
        lines = ["| # | from | when | to |", "|---|---|---|---|"]
        for index, row in enumerate(self.facts["machines"][name], 1):
            lines.append(f"| {index} | {', '.join(row['from'])} | {' and '.join(row['needs']) or 'otherwise'} "
                         f"| {row['to']} |")
        return "\n".join(lines)

    def type(self, name):
        enemy = self.enemies[name]
        self.told.add(name)
        facts = [size_of(enemy), f"{number(enemy['speed_mps'])} m/s", f"sees the ship from {number(enemy['sight_m'])} m",
                 f"others from {number(enemy['vision_m'])} m", f"energy {number(enemy['energy'])}",
                 f"mass {number(enemy['mass'])}", f"contact {number(enemy['contact_us'] / 1000)} ms",
                 f"value {enemy['value']}", f"{enemy['bits']} bit{'s' if enemy['bits'] != 1 else ''}"]
        if enemy["avoidCooldown_ticks"]:
            facts.append(f"dodges every {number(enemy['avoidCooldown_ticks'] / 60)} s at most")
        weak = "; dies, without score, in the blast of a contact" if enemy["energy"] <= self.facts["weakEnergy"] else ""
        return f"### {name}\n{', '.join(facts)}{weak}.\n"

    def fill(self, match):
        words = match.group(1).split()
        if words[0] in ("overview", "machine", "type"):
            return getattr(self, words[0])(*words[1:])
        value = self.enemies | self.facts
        for key in words[-1].split("."):
            value = value[key]
        return f"{number(value * 100)} %" if words[0] == "percent" else number(value)

    def text(self, template):
        text = re.sub(r"\{\{ (.*?) \}\}", self.fill, template)
        untold = set(self.enemies) - self.told
        if untold:
            sys.exit(f"tools/enemies_template.md does not tell of {', '.join(sorted(untold))}; "
                     "add '{{ type NAME }}' and how it behaves")
        return text


def files_of(facts):
    """Every file that is made, relative to the root, with its text."""
    made = {f"docs/images/machine_{machine.replace(' ', '_')}.svg": state_diagram.diagram(machine, rows)
            for machine, rows in facts["machines"].items()}
    made["docs/reference/enemies.md"] = Page(facts).text((ROOT / "tools/enemies_template.md").read_text())
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("describe", type=Path, metavar="DESCRIBE_ENEMIES")
    parser.add_argument("--assets", type=Path, default=ROOT / "assets")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    described = subprocess.run([arguments.describe, arguments.assets], stdout=subprocess.PIPE, check=False)
    if described.returncode != 0:
        sys.exit(1)
    try:
        made = files_of(json.loads(described.stdout))
    except ValueError as error:
        sys.exit(str(error))
    stale = [name for name, text in made.items()
             if not (ROOT / name).is_file() or (ROOT / name).read_bytes() != text.encode()]
    if arguments.check:
        for name in stale:
            print(f"{name} is not what the tables say; run {REFRESH} and commit it", file=sys.stderr)
        sys.exit(1 if stale else 0)
    for name in stale:
        (ROOT / name).write_bytes(made[name].encode())
        print(f"wrote {name}")


if __name__ == "__main__":
    main()
