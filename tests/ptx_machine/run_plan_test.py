"""The plan of --full: every pair of settings occurs, every search has a golden replay of its own."""
import itertools
import unittest
from pathlib import Path

import run_plan

REPLAYS = Path(__file__).resolve().parents[2] / "replays"


def settings_of(step):
    block = step.arguments[step.arguments.index("--block-size") + 1]
    return {"search": step.replay, "block": block, "order": step.machine.split(",")[0].split("=")[1],
            "architecture": step.architecture}


class Plan(unittest.TestCase):
    def test_every_pair_of_settings_occurs(self):
        rows = [settings_of(step) for step in run_plan.full_steps()]
        self.assertEqual(len(rows), len(run_plan.SEARCHES) * len(run_plan.BLOCK_SIZES))
        for one, other in itertools.combinations(rows[0], 2):
            wanted = {(a[one], b[other]) for a in rows for b in rows}
            self.assertEqual({(row[one], row[other]) for row in rows}, wanted, f"{one} and {other}")

    def test_ten_golden_replays_with_ten_searches(self):
        self.assertEqual(len({replay for replay, _ in run_plan.SEARCHES}), 10)
        # By its options, or for an inexact one by the replay.
        self.assertEqual(len({search or replay for replay, search in run_plan.SEARCHES}), 10)
        for replay, _ in run_plan.SEARCHES:
            self.assertTrue((REPLAYS / f"{replay}.gwr").is_file(), replay)

    def test_names_are_different(self):
        for steps in (run_plan.quick_steps(), run_plan.full_steps()):
            names = [step.name for step in steps]
            self.assertEqual(len(names), len(set(names)))


if __name__ == "__main__":
    unittest.main()
