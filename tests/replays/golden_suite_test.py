#!/usr/bin/env python3
"""The suite as it stands in replays/: its table is up to date, together the replays cover what they must, and nothing
records them by itself.

    golden_suite_test.py SOURCE
"""
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import readme_table
from golden_suite import golden_list, read_facts

SOURCE = Path(sys.argv.pop(1)).resolve()
REPLAYS = SOURCE / "replays"
# What may name update_replays without running it: documents, and comments or messages that tell a person to.
RUNS = (".py", ".sh", ".cmake", ".yml", ".yaml", "")


class Table(unittest.TestCase):
    def test_is_up_to_date(self):
        self.assertEqual(readme_table.with_table(REPLAYS), (REPLAYS / "README.md").read_text(),
                         "run tests/replays/readme_table.py --write")

    def test_follows_what_it_is_made_of(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = shutil.copytree(REPLAYS, Path(folder) / "replays")
            name = next(iter(golden_list(copy)))
            before = readme_table.with_table(copy)
            expect = copy / f"{name}.expect"
            expect.write_text("# Something else.\n" + expect.read_text().partition("\nmode")[2].join(["mode", ""]))
            self.assertIn("Something else.", readme_table.with_table(copy))
            with (copy / f"{name}.gwr").open("ab") as replay:
                replay.write(bytes(100_000))
            self.assertNotEqual(before, readme_table.with_table(copy))
            (copy / "README.md").write_text("no marks")
            with self.assertRaisesRegex(ValueError, "lost the marks"):
                readme_table.with_table(copy)
            (copy / "golden.facts").unlink()
            with self.assertRaisesRegex(ValueError, f"does not tell of {name}"):
                readme_table.table(copy)


class Coverage(unittest.TestCase):
    def setUp(self):
        self.golden, self.facts = golden_list(REPLAYS), read_facts(REPLAYS)

    def test_modes_and_endings(self):
        self.assertEqual({facts["mode"] for facts in self.facts.values()}, {"arcade", "deadline", "swarm", "practice"})
        self.assertEqual({facts["ending"] for facts in self.facts.values()},
                         {"none", "frame_rate", "time_up", "cleared"})

    def test_every_edge(self):
        taken = {}
        for facts in self.facts.values():
            for machine, edges in facts["edges"].items():
                for edge, count in edges.items():
                    taken[machine, edge] = taken.get((machine, edge), 0) + count
        self.assertTrue(taken)
        self.assertEqual([edge for edge, count in taken.items() if not count], [])

    def test_each_type_alone(self):
        for kind in next(iter(self.facts.values()))["killsByType"]:
            kills = self.facts[f"{kind}_alone"]["killsByType"]
            self.assertEqual([name for name, count in kills.items() if count], [kind])

    def test_every_way_to_find_neighbours(self):
        verified = {word for one in self.golden.values() for word in one.verified}
        self.assertLessEqual({"grid", "grid-hashed", "brute", "bitonic", "full", "frozen"}, verified)
        recorded = {" ".join(one.recorded[:4]) for one in self.golden.values() if one.recorded[0] == "--gather"}
        recorded |= {"thesis" for one in self.golden.values() if "--thesis" in one.recorded}
        self.assertLessEqual({"thesis", "--gather adaptive --sort odd-even", "--gather fixed --sort bitonic",
                              "--gather fixed --sort odd-even"}, recorded)

    def test_both_bots_and_a_long_run(self):
        words = [word for one in self.golden.values() for word in one.recorded]
        self.assertIn("novice", words)
        self.assertIn("expert", words)
        self.assertGreaterEqual(max(facts["ticks"] for facts in self.facts.values()), 36_000)


class NothingRecordsByItself(unittest.TestCase):
    def test_no_program_calls_update_replays(self):
        looked = callers = 0
        for path in [SOURCE / "check", SOURCE / "play", *SOURCE.glob("cmake/*"), *SOURCE.glob(".ci/*"),
                     *SOURCE.glob("tools/*"), *SOURCE.glob("tests/**/*"), SOURCE / "CMakeLists.txt"]:
            if not path.is_file() or path.name in ("update_replays", "golden_suite_test.py"):
                continue
            if path.suffix not in RUNS and path.name != "CMakeLists.txt":
                continue
            looked += 1
            for line in path.read_text(errors="replace").splitlines():
                if "update_replays" not in line or line.strip().startswith(("#", '"""')):
                    continue
                # A test of it, which works in a folder of its own; else it is a sentence for a person.
                allowed = "${CMAKE_CURRENT_SOURCE_DIR}/update_replays" in line or "tests/update_replays" in line
                runs = any(word in line for word in ("subprocess", "must ", "COMMAND", "execute_process", "$(", "exec "))
                self.assertTrue(allowed and not runs or path.name in ("golden_replays_test.py", "add_replay_test.py"),
                                f"{path}: {line}")
                callers += 1
        self.assertGreater(looked, 20)
        self.assertGreater(callers, 0)


if __name__ == "__main__":
    unittest.main()
