#!/usr/bin/env python3
"""tests/add_replay adds a run whole, or leaves the folder as it was; tests/update_replays then plays its inputs again.

    add_replay_test.py GPUWARS TESTS
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import readme_table

GPUWARS, TESTS = (Path(path).resolve() for path in sys.argv[1:3])
del sys.argv[1:3]
README = f"# Replays\n{readme_table.BEGIN}\n{readme_table.END}\n"


def run(*command):
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False)


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


class AddReplay(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        base = Path(self.scratch.name)
        self.folder, self.played = base / "replays", base / "played.gwr"
        self.folder.mkdir()
        (self.folder / "golden.list").write_text("# name | how\n")
        (self.folder / "README.md").write_text(README)
        self.play(self.played, 3)

    def tearDown(self):
        self.scratch.cleanup()

    def play(self, file, seed):
        done = run(GPUWARS.parent / "play_script", "pad", "--headless", "--device", "cpu", "--enemies", 100, "--seed",
                   seed, "--ticks", 400, "--record", file)
        self.assertEqual(done.returncode, 0, done.stderr)

    def add(self, file, *more, guards="Flies into a wall."):
        return run(TESTS / "add_replay", file, "--guards", guards, "--gpuwars", GPUWARS, "--replays", self.folder, *more)

    def refused(self, says, *arguments, **named):
        before = contents(self.folder)
        done = self.add(*arguments, **named)
        self.assertEqual(done.returncode, 1)
        self.assertIn(says, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertEqual(contents(self.folder), before)

    def golden(self):
        return run(sys.executable, TESTS / "replays/golden_replays.py", GPUWARS, "--replays", self.folder, "-j", 1)

    def update(self):
        return run(TESTS / "update_replays", "--gpuwars", GPUWARS, "--replays", self.folder)

    def test_adds_all_that_belongs_to_it(self):
        done = self.add(self.played)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "played.gwr").read_bytes(), self.played.read_bytes())
        self.assertIn("played               | person\n", (self.folder / "golden.list").read_text())
        self.assertIn("# Flies into a wall.\nmode = arcade\nover = no\nticks = 400\n",
                      (self.folder / "played.expect").read_text())
        self.assertIn("| `played` | Flies into a wall. | arcade | 400 |", (self.folder / "README.md").read_text())
        self.assertEqual(self.golden().returncode, 0, self.golden().stderr)

    def test_is_played_again_by_its_inputs(self):
        self.assertEqual(self.add(self.played).returncode, 0)
        done = self.update()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("played: the same game\n", done.stdout)
        self.assertIn("1 the same, 0 changed or new, 0 refused\n", done.stdout)
        self.assertEqual(self.golden().returncode, 0, self.golden().stderr)

    def test_an_update_says_what_changed(self):
        (self.folder / "golden.list").write_text("pad | script pad --seed 3 --enemies 100 --ticks 400\n")
        (self.folder / "pad.expect").write_text("# Changes.\nticks = 400\nkills = 1\nover = no\n")
        self.assertEqual(self.update().returncode, 0, self.update().stderr)
        (self.folder / "golden.list").write_text("pad | script pad --seed 4 --enemies 100 --ticks 500\n")
        dry = run(TESTS / "update_replays", "--dry-run", "--gpuwars", GPUWARS, "--replays", self.folder)
        self.assertIn("differs from tick 1 on\n  ticks 400 -> 500\n", dry.stdout)
        self.assertIn("nothing was written", dry.stdout)
        done = self.update()
        self.assertIn("kills by type: ", done.stdout)
        self.assertIn("0 the same, 1 changed or new, 0 refused\n", done.stdout)
        self.assertIn("| 500 |", (self.folder / "README.md").read_text())
        self.assertIn("pad: the same game\n", self.update().stdout)

    def test_refuses(self):
        self.assertEqual(self.add(self.played).returncode, 0)
        copy, other = Path(self.scratch.name) / "copy.gwr", Path(self.scratch.name) / "other.gwr"
        copy.write_bytes(self.played.read_bytes())
        self.play(other, 4)
        self.refused("is the same game as", copy)
        self.refused("there is a replay played already", other, "--name", "played")
        self.refused("is no name for a replay", other, "--name", "../played")
        self.refused("is not there", Path(self.scratch.name) / "nothing.gwr")
        self.refused("--guards takes one line", other, guards="a | b")
        self.refused("--guards takes one line", other, guards=" ")
        damaged = bytearray(other.read_bytes())
        damaged[len(damaged) // 2] ^= 1
        copy.write_bytes(damaged)
        self.refused("does not verify", copy)
        (self.folder / "large.gwr").write_bytes(bytes(16 << 20))
        self.refused("more than 16777216", other)
        (self.folder / "large.gwr").unlink()
        # At the very last step: what was written before goes back.
        (self.folder / "README.md").write_text("without marks")
        self.refused("has lost the marks", other)


if __name__ == "__main__":
    unittest.main()
