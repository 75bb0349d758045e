#!/usr/bin/env python3
"""What finds mutants finds them where kernels compute, nowhere else, and the same ones each time."""
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from choice import LEFT_OUT, files, kernels_of, left_out, slots  # noqa: E402
from kernel_code import device_bodies, plain_code  # noqa: E402
from kernel_files import kernel_files, path_of  # noqa: E402
from localise import entity_fields  # noqa: E402
from mutations import changed_number, mutants_of  # noqa: E402
from report import judged, survivors, table  # noqa: E402
from stages import stages_of  # noqa: E402
from trial import Outcome  # noqa: E402

ROOT = HERE.parent.parent
KERNELS, FILES, SLOTS = 16, 55, 84  # of game/sim that decide; files looked into, those of gpu/ too; what run_mutants tests
SNIPPET = """// A comment of 11 words, if (a < 12).
#include "file13.h"
#define SIZE 14
namespace gw {
constexpr float kDrag = 0.5f;  // 15
constexpr uint32_t kCount = 16;
static_assert(sizeof(Cell) == 17, "18");

int hostOnly(int x) { return x + 19; }

struct Data {
  float values[20] = {};
  uint32_t count = 21;
};

template <class Search, int N = 22>
struct Kernel {
  static constexpr uint32_t kLanes = 23;
  View v;

  GW_BODY void operator()(uint32_t i) const {
    static_assert(kLanes < 24);
    float local[25] = {}, more[kCount + 26] = {};
    const Buffer<float, 27> buffer{"28", '9'};
    /* 30 */ if (v.x < 1.5f && v.y >= 2) v.z += i - 0x10u;
#if GW_ON_CUDA
    v.z = 31;
#else
    v.z = 32;
#endif
    search.around(i, [&](const Cell& other) { v.n = 3 * other.id + 1; });
  }

 private:
  GW_BODY float helper() const { return v.a != v.b ? 1.0e-3f : v.sums[3 * v.id]; }
};

GW_FN float free(float x) {
  return x - 4.0f;
}
}
"""


def found(kind):
    """(old, new, kernel, function) of the snippet's mutants of a kind."""
    return [(m.old, m.new, m.kernel, m.function) for m in mutants_of("game/sim/x.cu", SNIPPET) if m.kind == kind]


class Mutations(unittest.TestCase):
    """Of the snippet."""

    def test_finds_the_constants_of_kernels_and_of_what_they_call(self):
        kernel, helper, free = ("Kernel", "operator()"), ("Kernel", "helper"), ("free", "free")
        self.assertEqual(found("constant"), [
            ("0.5f", "0.505f", "kDrag", "kDrag"), ("1.5f", "1.515f", *kernel), ("2", "3", *kernel),
            ("0x10u", "0x11u", *kernel), ("32", "33", *kernel), ("3", "4", *kernel), ("1", "2", *kernel),
            ("1.0e-3f", "0.00101f", *helper), ("3", "4", *helper), ("4.0f", "4.04f", *free)])

    def test_finds_comparisons_and_signs(self):
        self.assertEqual([m[:2] for m in found("comparison")], [("<", "<="), (">=", ">"), ("!=", "==")])
        self.assertEqual([m[:2] for m in found("arithmetic")], [("+=", "-="), ("-", "+"), ("+", "-"), ("-", "+")])

    def test_touches_nothing_else(self):
        changed = {m.old for m in mutants_of("game/sim/x.cu", SNIPPET)}
        for left in (*range(11, 32), 9):  # comments, strings, includes, sizes, template arguments, host code
            if left not in (16,):
                self.assertNotIn(str(left), changed)
        self.assertNotIn("16", changed)

    def test_applies_one_change_and_finds_itself_again(self):
        for mutant in mutants_of("game/sim/x.cu", SNIPPET):
            changed = mutant.applied(SNIPPET)
            self.assertNotEqual(changed, SNIPPET)
            before, after = SNIPPET.splitlines(), changed.splitlines()
            different = [n for n, (a, b) in enumerate(zip(before, after, strict=True), 1) if a != b]
            self.assertEqual(different, [mutant.line])
            with self.assertRaises(ValueError):
                mutant.applied("another text")

    def test_changes_every_kind_of_number(self):
        for old, new in {"0": "1", "7u": "8u", "0.0f": "0.01f", "-1.0f"[1:]: "1.01f", "0xFFFFFFFFu": "0xFFFFFFFEu",
                         "0x94D049BB133111EBull": "0x94D049BB133111EAull", "0x1p-20f": "0x1p-19f", "100.0f": "101.0f",
                         "1.0e6f": "1010000.0f"}.items():
            self.assertEqual(changed_number(old), new)
        self.assertNotEqual(float(changed_number("7.549789948768648e-8f")[:-1]), 7.549789948768648e-8)

    def test_a_line_added_above_changes_no_name(self):
        names = [m.name for m in mutants_of("a.cu", SNIPPET)]
        self.assertEqual([m.name for m in mutants_of("a.cu", "// one more line\n" + SNIPPET)], names)

    def test_names_are_those_of_one_mutant_each(self):
        for file in files(ROOT):
            names = [m.name for m in mutants_of(file, (ROOT / file).read_text())]
            self.assertEqual(len(names), len(set(names)), file)


class Choice(unittest.TestCase):
    """Of the game's own sources."""

    def test_is_the_same_each_time(self):
        first, second = ([[m.name for m in found] for _, found in slots(ROOT)] for _ in range(2))
        self.assertEqual(first, second)

    def test_has_a_constant_of_every_kernel_that_decides(self):
        wanted = slots(ROOT)
        self.assertGreaterEqual(len(wanted), 40)
        with_constant = {m.kernel for what, found in wanted if what.endswith("a constant") for m in found}
        kernels = {name for file in files(ROOT) if file.startswith("game/sim/")
                   for name in kernels_of((ROOT / file).read_text())}
        self.assertLessEqual({"Think", "PushApart", "Integrate", "FillIds", "GameLogic"}, kernels)
        # It has none: it calls two others.
        self.assertEqual(kernels - with_constant, {"RespondAndFinishShots"})

    def test_counts_every_kernel_of_the_game(self):
        below = [path for path in (ROOT / "game/sim").rglob("*") if path.suffix in (".cu", ".h")]
        names = {path.relative_to(ROOT).as_posix(): kernels_of(path.read_text()) for path in below}
        chosen = {file for file in files(ROOT) if file.startswith("game/sim/")}
        self.assertEqual(chosen, {file for file in names if not left_out(file)})
        self.assertEqual((sum(len(names[file]) for file in chosen), len(files(ROOT)), len(slots(ROOT))), (KERNELS, FILES, SLOTS),
                         "another number of kernels, files or tested places: if that is meant, change it at the top")

    def test_follows_files_that_move(self):
        with tempfile.TemporaryDirectory() as folder:
            moved = Path(folder)
            for number, file in enumerate(sorted(kernel_files(ROOT).values())):
                top = "gpu" if file.startswith("gpu/") else "game/sim"
                place = moved / top / f"room{number % 3}" / "deeper" / Path(file).name
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_text((ROOT / file).read_text())
            here, there = ([(what, [m.name for m in found]) for what, found in slots(root)] for root in (ROOT, moved))
            self.assertEqual([names for _, names in here], [names for _, names in there])
            self.assertEqual(entity_fields(moved), entity_fields(ROOT))
            for key in ("game/sim/think.cu", "game/sim/maintain.cu", "game/sim/sweep.h"):
                self.assertEqual(stages_of(kernel_files(moved)[key]), stages_of(key))
            (moved / "game/sim/think.cu").write_text("")
            with self.assertRaisesRegex(ValueError, "have the same name"):
                slots(moved)

    def test_refuses_to_lose_a_file(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(ValueError, "philox.h.*nowhere"):
            for file in kernel_files(ROOT).values():
                if not file.endswith("philox.h"):
                    (Path(folder) / file).parent.mkdir(parents=True, exist_ok=True)
                    (Path(folder) / file).write_text((ROOT / file).read_text())
            files(Path(folder))

    def test_leaves_out_only_what_is_there(self):
        for name in LEFT_OUT:
            file, _, function = name.partition(": ")
            text = path_of(ROOT, file).read_text()
            self.assertTrue(not function or function in text, name)
            self.assertTrue(left_out(file, function), name)

    def test_every_slot_has_candidates_of_a_device_body(self):
        for what, found in slots(ROOT):
            self.assertTrue(found, what)
        bodies = device_bodies(plain_code((ROOT / "game/sim/collide.cu").read_text()))
        self.assertIn(("PushApart", "addTo"), {(body.kernel, body.function) for body in bodies})


class Verdict(unittest.TestCase):
    """What a run makes of its outcomes."""

    def setUp(self):
        self.mutants = mutants_of("game/sim/x.cu", SNIPPET)[:2]
        self.caught, self.survived = Outcome("caught", "short", 7), Outcome("survived")

    def judge(self, outcomes, reasons):
        return judged(list(zip(self.mutants, outcomes, strict=True)), reasons, whole=True)

    def test_refuses_a_survivor_without_a_reason(self):
        first, second = self.mutants
        self.assertEqual(self.judge([self.caught, self.survived], {second.name: "equal bits"}), [])
        self.assertIn("survived without a reason", self.judge([self.caught, self.survived], {})[0])
        self.assertIn("survived without a reason", self.judge([self.caught, self.survived], {second.name: ""})[0])
        self.assertIn("caught by now", self.judge([self.caught, self.caught], {first.name: "equal bits"})[0])
        self.assertIn("no longer tried", self.judge([self.caught, self.caught], {"another": "equal bits"})[0])
        self.assertEqual(self.judge([self.caught, Outcome("timed out", "short")], {}), [])

    def test_reads_names_and_reasons(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "survivors.txt"
            file.write_text("# why\nfirst: x [1: 0 -> 1]\n  one reason\n  in two lines\n\nsecond\n  another\n")
            self.assertEqual(survivors(file), {"first: x [1: 0 -> 1]": "one reason in two lines", "second": "another"})
            file.write_text("first\n  a\nfirst\n  b\n")
            with self.assertRaises(ValueError):
                survivors(file)

    def test_the_table_counts(self):
        second = self.mutants[1]
        text = table(list(zip(self.mutants, [self.caught, self.survived], strict=True)), {second.name: "equal bits"}, 2)
        self.assertIn("**1 of 2 caught**", text)
        self.assertNotIn("not tried yet", text)
        self.assertIn("short, tick 7", text)
        self.assertIn("| equal bits |", text)


if __name__ == "__main__":
    unittest.main()
