#!/usr/bin/env python3
"""What is asked of verify about a mutant: that it names where the change is, in numbers; and of which mutants."""
import copy
import sys
import unittest
from itertools import islice
from pathlib import Path
from types import SimpleNamespace

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from choice import slots  # noqa: E402
from localise import Place, entity_fields, misplaced, places_table  # noqa: E402
from kernel_files import path_of  # noqa: E402
from report import BEGIN, END, localised, with_localised  # noqa: E402
from stages import FELT_IN, STAGES, by_stage, spread, stages_of  # noqa: E402

ROOT = HERE.parent.parent
TICK = 65
TOLD = {
    "firstDifference": {"tick": TICK, "recorded": "00ff", "computed": "00aa"},
    "desync": {"tick": TICK, "hashes": {"own": "00aa", "reference": "00ff"}, "partsAgain": True, "fromStart": False,
               "stage": "spawn", "field": "x", "entity": 4,
               "values": {"own": {"number": 1.5, "bits": "3fc00000"}, "reference": {"number": 1.25, "bits": "3fa00000"}}},
}


def mutant(file):
    """As far as it matters here."""
    return SimpleNamespace(file=file, name=f"{file}: a mutant", kernel="Kernel", context="a || b", old="1", new="2")


class Misplaced(unittest.TestCase):
    """The verdict on what verify says."""

    def setUp(self):
        self.told, self.of_entities = copy.deepcopy(TOLD), {"x", "y"}

    def wrong(self, file="game/sim/spawn.cu", status=4, tick=TICK):
        return misplaced(mutant(file), tick, status, self.told, self.of_entities)

    def refused(self, words, **how):
        found = self.wrong(**how)
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_a_right_answer_passes(self):
        self.assertEqual(self.wrong(), [])
        del self.told["desync"]["entity"]
        self.told["desync"]["field"] = "tick.births"
        self.assertEqual(self.wrong(), [])

    def test_shared_code_may_be_felt_in_any_of_its_stages(self):
        for stage in stages_of("game/sim/state.h"):
            self.told["desync"]["stage"] = stage
            self.assertEqual(self.wrong(file="game/sim/state.h"), [])
        self.told["desync"]["stage"] = "logic"
        self.refused("stage logic", file="game/sim/state.h")

    def test_refuses_another_stage_or_tick(self):
        self.refused("stage spawn", file="game/sim/think.cu")
        self.refused("names tick 65", tick=64)

    def test_refuses_what_says_nothing(self):
        self.refused("ended with 0", status=0)
        self.refused("ended with None", status=None)
        self.told["desync"]["partsAgain"] = False
        del self.told["desync"]["stage"], self.told["desync"]["field"]
        self.refused("part again")
        del self.told["desync"]
        self.refused("ended with 4")

    def test_refuses_a_field_that_is_missing_or_equal_or_nobodys(self):
        self.told["desync"]["field"] = "tick.births"
        self.refused("is a global")
        self.told["desync"]["field"] = "y"
        del self.told["desync"]["entity"]
        self.refused("it names none")
        self.told["desync"]["entity"] = 4
        self.told["desync"]["values"]["own"]["bits"] = "3fa00000"
        self.refused("are equal")
        del self.told["desync"]["field"]
        self.refused("names no field")

    def test_refuses_a_reference_that_is_not_the_recorded_game(self):
        self.told["firstDifference"]["recorded"] = "00aa"
        self.refused("does not agree with the recording")

    def test_of_the_hash_only_the_hash_differs(self):
        self.told["desync"]["stage"] = "hash"
        self.refused("names a field", file="game/sim/hash.cu")
        for key in ("field", "entity", "values"):
            del self.told["desync"][key]
        self.assertEqual(self.wrong(file="game/sim/hash.cu"), [])
        self.refused("stage hash", file="game/sim/spawn.cu")

    def test_knows_the_fields_of_entities(self):
        fields = entity_fields(ROOT)
        self.assertLessEqual({"type", "x", "velocity_y", "energy", "flags", "threat", "choice_time", "push_sum_x", "cell"}, fields)
        self.assertFalse(fields & {"score", "ship.x", "tick.births", "tick"})


class Order(unittest.TestCase):
    """Which mutants are localised."""

    def test_every_file_has_its_stages(self):
        wanted = slots(ROOT)
        files = {found[0].file for _, found in wanted if found[0].file.startswith("game/sim/")}
        for file in files:
            self.assertTrue(set(stages_of(file)) <= set(STAGES), file)
        with self.assertRaises(ValueError):
            stages_of("gpu/philox.h")
        with self.assertRaises(ValueError):
            stages_of("game/sim/unheard_of.h")

    def test_says_the_reason_where_a_file_is_not_its_stage(self):
        for file, (stages, reason) in FELT_IN.items():
            self.assertTrue(path_of(ROOT, file).is_file(), file)
            self.assertTrue(set(stages) <= set(STAGES) and reason, file)

    def test_stages_are_those_of_a_tick(self):
        self.assertEqual((STAGES[0], STAGES[-1]), ("logic", "hash"))
        for stage in STAGES:
            self.assertTrue((ROOT / f"game/sim/{stage}.cu").is_file(), stage)

    def test_ten_are_of_all_that_decide(self):
        first = [(slot[1][0].file, stages_of(slot[1][0].file)) for slot in islice(spread(slots(ROOT), lambda slot: slot), 10)]
        of_one = {stages[0] for _, stages in first if len(stages) == 1}
        self.assertLessEqual({"logic", "spawn", "think", "integrate", "collide", "settle", "hash"}, of_one)

    def test_takes_one_of_each_group_in_turn_and_what_does_not_fit_gives_way(self):
        wanted = [(f"{file} {n}", [mutant(f"game/sim/{file}")]) for file in ("think.cu", "logic.cu") for n in range(3)]
        wanted.append(("gpu", [mutant("gpu/philox.h")]))
        self.assertEqual([len(group) for group in by_stage(wanted)], [3, 3])
        named = [slot[0] for slot in spread(wanted, lambda slot: None if slot[0] == "logic.cu 0" else slot)]
        self.assertEqual(named, ["logic.cu 1", "think.cu 0", "logic.cu 2", "think.cu 1", "think.cu 2"])


class Page(unittest.TestCase):
    """What is written."""

    def test_the_table_has_both_values(self):
        text = places_table([Place(mutant("game/sim/spawn.cu"), "short", TOLD["desync"])])
        self.assertIn("| short | 65 | spawn | 4 | x | 1.5 | 1.25 |", text)
        self.assertIn("`a \\|\\| b`", text)
        without = {key: TOLD["desync"][key] for key in ("tick", "stage")}
        self.assertIn("| the hash only |  |  |", places_table([Place(mutant("game/sim/hash.cu"), "short", without)]))

    def test_stands_between_its_own_marks_and_stays_there(self):
        page = with_localised("# Mutants\n", "rows")
        self.assertEqual(localised(page), "rows")
        self.assertTrue(page.startswith("# Mutants\n") and page.endswith(f"{BEGIN}\nrows\n{END}\n"))
        self.assertEqual(with_localised(page, "others"), page.replace("rows", "others"))
        self.assertEqual(localised("# Mutants\n"), "")


if __name__ == "__main__":
    unittest.main()
