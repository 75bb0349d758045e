#!/usr/bin/env python3
"""Golden replays must not become hollow: what is wrong with one is found, and said in a sentence.

    golden_replays_test.py GPUWARS UPDATE_REPLAYS
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
OPTIONS = "--seed 7 --autopilot expert --ticks 900 --enemies 500"
GOOD = """# a comment
mode = arcade
over = no
ticks = 900       # all of them
kills = 5
kills.triangle = 5
shots = 50
edge = kamikaze: wandering -> attacking
edge = kamikaze: checking energy -> dead
"""


class Folder:
    """A folder of golden replays of our own, with one replay in it."""

    def __init__(self, gpuwars, update, path):
        self.gpuwars, self.update, self.path = gpuwars, update, path
        self.write("golden.list", f"# name | options\nshort | {OPTIONS}\n")
        self.write("short.expect", GOOD)
        self.failures = 0

    def write(self, name, text):
        (self.path / name).write_text(text)

    def run(self, *command):
        result = subprocess.run([sys.executable, *map(str, command)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, check=False)
        return result.returncode, result.stderr

    def check(self):
        return self.run(HERE / "golden_replays.py", self.gpuwars, "--replays", self.path, "-j", 1)

    def record(self):
        return self.run(self.update, "--gpuwars", self.gpuwars, "--replays", self.path)

    def want(self, outcome, sentence, says=None):
        """`says`: what a failure must tell; none: all must be well."""
        code, error = outcome
        good = code == 0 and error == "" if says is None else code == 1 and says in error and "Traceback" not in error
        print(("ok    " if good else "FAIL  ") + sentence + ("" if good else f": exit {code}: {error}"), flush=True)
        self.failures += not good


def planted(folder):
    """(what, .expect, what the checker says)"""
    yield "a number raised", GOOD.replace("kills = 5", "kills = 99999"), "kills must be at least 99999, is "
    yield "a type's kills raised", GOOD.replace("triangle = 5", "triangle = 99999"), "kills.triangle must be at least"
    yield "more ticks", GOOD.replace("900", "901"), "ticks must be at least 901, is 900"
    yield "another ending", GOOD.replace("over = no", "over = frame_rate"), "over must be frame_rate, is no"
    yield "another mode", GOOD.replace("arcade", "swarm"), "mode must be swarm, is arcade"
    yield "an edge not taken", GOOD + "edge = tricky: escaping -> wandering\n", "escaping -> wandering' is never taken"
    yield "every edge", GOOD + "edges = all\n", "is never taken"
    yield "an unknown edge", GOOD + "edge = kamikaze: dead -> wandering\n", "no such edge; kamikaze has wandering ->"
    yield "an unknown machine", GOOD + "edge = zombie: dead -> wandering\n", "there is no machine 'zombie'"
    yield "edges of an unknown machine", GOOD + "edges = zombie\n", "there is no such machine"
    yield "an unknown type", GOOD + "kills.pentagon = 1\n", "there is no such type; there are triangle"
    yield "an unknown key", GOOD + "joy = 3\n", "short.expect:10: there is no key 'joy'"
    yield "an unknown ending", GOOD.replace("over = no", "over = soon"), "'over' is one of"
    yield "a key twice", GOOD + "shots = 3\n", "'shots' stands twice"
    yield "a negative number", GOOD.replace("shots = 50", "shots = -50"), "takes a whole number from 1 or none, not '-50'"
    yield "a number that asks for nothing", GOOD.replace("shots = 50", "shots = 0"), "from 1 or none, not '0'"
    yield "no value", GOOD + "shots\n", "'shots' has no value"
    yield "none of what there is", GOOD.replace("shots = 50", "shots = none"), "shots must be none, is "
    yield "inputs that are not there", GOOD + "halfTurns = 700\n", "halfTurns must be at least 700, is "
    yield "places that were not visited", GOOD + "corners = 4\n", "corners must be at least 4, is "
    yield "heaps that were not there", GOOD + "atOnePlace = 50\n", "atOnePlace must be at least 50, is "
    yield "nothing asked for", "# nothing\n", "'ticks' is missing"


def main():
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(sys.argv[1], sys.argv[2], Path(path))
        replay, expect = folder.path / "short.gwr", folder.path / "short.expect"
        folder.want(folder.check(), "a replay that is not there", "short.gwr is missing")
        folder.want(folder.record(), "recording one that shows what it must")
        folder.want(folder.check(), "a good folder")
        for what, text, says in planted(folder):
            expect.write_text(text)
            folder.want(folder.check(), what, says)
        expect.unlink()
        folder.want(folder.check(), "no .expect", "short.expect is missing")
        folder.want(folder.record(), "recording without .expect", "short.expect is missing")

        expect.write_text(GOOD + "kills.compute = none\nkeyMoves_ticks = 1\natOnePlace = 1\n")
        folder.want(folder.check(), "what is there, and what must not be")

        # What reports tell is not hashed; golden.facts holds it.
        told = folder.path / "golden.facts"
        text = told.read_text()
        expect.write_text(GOOD)
        told.write_text(text.replace('"shots": ', '"shots": 1'))
        folder.want(folder.check(), "reports that tell otherwise", "short: shots was 1")
        told.unlink()
        folder.want(folder.check(), "no golden.facts", "golden.facts does not tell of it")
        told.write_text(text)

        # A new recording that shows less is refused, and the good one stays.
        expect.write_text(GOOD)
        kept = replay.read_bytes()
        folder.write("golden.list", f"short | {OPTIONS.replace('900', '60')}\n")
        folder.want(folder.record(), "recording a hollow one", "ticks must be at least 900, is 60")
        folder.want((int(replay.read_bytes() != kept), ""), "the good recording stays")
        folder.want(folder.check(), "and is good")

        # Other tables are another game.
        folder.write("golden.list", f"short | {OPTIONS} --with-waves-of hexagon\n")
        folder.want(folder.record(), "recording with other waves", "kills.triangle must be at least 5, is 0")
        folder.write("golden.list", f"short | {OPTIONS} --with-sight 0.1\n")
        folder.want(folder.record(), "recording with less sight", "attacking' is never taken")
        folder.write("golden.list", f"short | {OPTIONS} --with-waves-of pentagon\n")
        folder.want(folder.record(), "recording with waves of an unknown type", "pentagon")
        for options, says in (("--with game.joy=3", "finds nothing to change"), ("--with joy", "takes game.KEY=NUMBER"),
                              ("--with-sight", "--with-sight needs a value")):
            folder.write("golden.list", f"short | {OPTIONS} {options}\n")
            folder.want(folder.record(), f"recording with {options}", says)
        folder.write("golden.list", f"short | {OPTIONS} | --broad-phase triangles\n")
        folder.want(folder.check(), "an option of verify that there is not", "verify failed (2)")
        folder.write("golden.list", f"short | {OPTIONS} | --broad-phase brute --threads 2\n")
        folder.want(folder.check(), "options of verify")
        folder.write("golden.list", "short | script\n")
        folder.want(folder.check(), "a script without a name", "'script' needs a name")
        folder.write("golden.list", f"short | {OPTIONS} | | \n")
        folder.want(folder.check(), "too many columns", "golden.list:1: expected 'name | options'")
        folder.write("golden.list", f"short | {OPTIONS}\n")

        damaged = bytearray(kept)
        damaged[len(damaged) // 2] ^= 1
        replay.write_bytes(damaged)
        folder.want(folder.check(), "a damaged replay", "short: ")
        replay.write_bytes(kept)
        folder.write("stray.gwr", "")
        folder.want(folder.check(), "a replay that is not in the list", "golden.list does not name it")
        (folder.path / "stray.gwr").unlink()
        os.truncate(replay, (16 << 20) + 1)
        folder.want(folder.check(), "too many bytes", "more than 16777216; shorten some")
        replay.write_bytes(kept)
        folder.want(folder.check(), "and the good one again")
        folder.write("golden.list", "")
        folder.want(folder.check(), "an empty list", "names no replay")
        sys.exit(1 if folder.failures else 0)


if __name__ == "__main__":
    main()
