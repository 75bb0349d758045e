#!/usr/bin/env python3
"""The determinism matrix: what mismatches is counted, what failed is no zero, what is known is not run again, and what
has changed is.

    determinism_matrix_test.py GPUWARS SOURCE
"""
import importlib.machinery
import importlib.util
import shutil
import stat
import sys
import tempfile
import unittest
from pathlib import Path

from golden_suite import replay_facts
from matrix import DECISIVE, Results, Variant, compare, decisive_digest, decisive_files, digest_of, fill

GPUWARS, SOURCE = (Path(path).resolve() for path in sys.argv[1:3])
del sys.argv[1:3]
LOADER = importlib.machinery.SourceFileLoader("determinism_matrix", str(SOURCE / "tests/replays/determinism_matrix"))
script = importlib.util.module_from_spec(importlib.util.spec_from_loader(LOADER.name, LOADER))
LOADER.exec_module(script)
NAME = "first_seconds"
# A game that computes another hash from tick 100 on, and says so as verify does.
LIAR = '''#!/usr/bin/env python3
import json, subprocess, sys
real = subprocess.run([{game!r}, *sys.argv[1:]], stdout=subprocess.PIPE, text=True).stdout
if "--hashes" in sys.argv:
    for line in real.splitlines():
        tick, value = line.split()
        print(tick, value if int(tick) < 100 else "0123456789abcdef")
else:
    told = json.loads(real)
    told["replays"][0].update(equal=False, exitCode=4, firstDifference=dict(tick=100))
    print(json.dumps(told))
sys.exit(4)
'''


class Matrix(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        base = Path(self.scratch.name)
        self.replays, self.path = base / "replays", base / "results.json"
        self.replays.mkdir()
        for kind in (".gwr", ".expect"):
            shutil.copy(SOURCE / "replays" / (NAME + kind), self.replays)
        (self.replays / "golden.list").write_text(f"{NAME} | script nothing\n")
        self.file = self.replays / f"{NAME}.gwr"
        facts = replay_facts(GPUWARS, self.file, "--hashes")
        self.ticks, self.hashes = facts["ticks"], facts["hashes"]
        self.recorded = {NAME: {"ticks": self.ticks, "hashes": lambda: self.hashes}}
        self.said = []

    def tearDown(self):
        self.scratch.cleanup()

    def program(self, name, text):
        path = Path(self.scratch.name) / name
        path.write_text(text)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return path

    def fill(self, program, variant=Variant("way", "none"), most_ticks=None):
        self.said.clear()
        fill(variant, program, self.replays, Results(self.path), 2, self.recorded, most_ticks, self.said.append)
        return script.matrix_table(self.replays, [variant], Results(self.path), lambda _variant: digest_of(program))

    def test_equal(self):
        table, wrong = self.fill(GPUWARS)
        self.assertEqual(wrong, 0)
        self.assertIn(f"0 of {self.ticks} ticks mismatch, in 1 replays and 1 variants; 0 of 1 cells were not run", table)
        self.assertIn(f"| `{NAME}` | 0 / {self.ticks} |", table)

    def test_mismatches_are_counted(self):
        liar = self.program("liar", LIAR.format(game=str(GPUWARS)))
        table, wrong = self.fill(liar)
        self.assertEqual(wrong, self.ticks - 99)
        self.assertIn(f"| `{NAME}` | {self.ticks - 99} / {self.ticks} |", table)

    def test_a_failure_is_no_zero(self):
        table, wrong = self.fill(self.program("crash", "#!/bin/sh\necho 'data race' >&2\nexit 66\n"))
        self.assertEqual(wrong, 1)
        self.assertIn(f"| `{NAME}` | failed |", table)
        self.assertIn("data race", self.said[0])
        self.fill(self.program("crash", "#!/bin/sh\necho 'data race' >&2\nexit 66\n"))
        self.assertEqual(len(self.said), 1, "what failed is run again")

    def test_a_sanitiser_that_complains_after_equal_ticks(self):
        shell = f"#!/bin/sh\n'{GPUWARS}' \"$@\"\necho 'heap-use-after-free' >&2\nexit 1\n"
        found = compare(self.program("late", shell), self.file, [], None)
        self.assertIn("heap-use-after-free", found["error"])

    def test_what_is_known_is_not_run_again(self):
        self.fill(GPUWARS)
        self.assertEqual(len(self.said), 1)
        self.fill(GPUWARS)
        self.assertEqual(self.said, [])
        table, _wrong = script.matrix_table(self.replays, [Variant("way", "none")], Results(self.path),
                                            lambda _variant: None)
        self.assertIn("1 of 1 cells were not run", table)
        with self.file.open("ab") as replay:
            replay.write(b"x")
        table, wrong = self.fill(GPUWARS)
        self.assertEqual((len(self.said), wrong), (1, 1), "another file, which is refused")

    def test_what_decides_is_told_from_what_does_not(self):
        plain = decisive_digest(Variant("a", "a"))
        self.assertEqual(plain, decisive_digest(Variant("b", "b")))
        self.assertNotEqual(plain, decisive_digest(Variant("a", "a", ("-DCMAKE_BUILD_TYPE=Release",))))
        program = self.program("gpuwars", "#!/bin/sh\n")
        whole = digest_of(program)
        program.with_name("decisive_digest").write_text(plain)
        self.assertEqual(digest_of(program), plain)
        program.write_text("#!/bin/sh\nexit 1\n")
        self.assertEqual(digest_of(program), plain)
        program.with_name("decisive_digest").unlink()
        self.assertNotEqual(digest_of(program), whole)
        self.assertIsNone(digest_of(Path("nowhere")))

    def test_what_decides_is_followed_and_never_lost(self):
        here = decisive_files(SOURCE)
        self.assertGreater(len(here), 100)
        self.assertLessEqual({"think.cu", "ngrid.cu", "input_record.h", "floating_point.cmake"}, {file.name for file in here})
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for number, name in enumerate(DECISIVE):
                place = root / name
                place = place if place.suffix else place / f"room{number}" / "z.cu"
                place.parent.mkdir(parents=True, exist_ok=True)
                place.write_text(name)
            self.assertEqual(len(decisive_files(root)), len(DECISIVE))
            (root / "host/platform/toml_library.h").unlink()
            with self.assertRaisesRegex(ValueError, "toml_library.h, which is not there"):
                decisive_files(root)

    def test_a_build_of_other_sources_is_not_todays(self):
        variant, program = Variant("way", "none"), self.program("gpuwars", "#!/bin/sh\n")
        before, script.program_of = script.program_of, lambda _variant: program
        try:
            program.with_name("decisive_digest").write_text("of yesterday")
            self.assertIsNone(script.current_digest(variant))
            program.with_name("decisive_digest").write_text(decisive_digest(variant))
            self.assertEqual(script.current_digest(variant), decisive_digest(variant))
            program.unlink()
            self.assertIsNone(script.current_digest(variant))
        finally:
            script.program_of = before

    def test_quick_leaves_long_replays_out(self):
        table, wrong = self.fill(GPUWARS, most_ticks=self.ticks - 1)
        self.assertIn(f"| `{NAME}` | - |", table)
        self.assertEqual(wrong, 0)

    def test_marks(self):
        text = (SOURCE / "docs/design/determinism.md").read_text()
        self.assertIn("\nsomething\n<!-- end of matrix -->", script.between(text, "matrix", "something"))
        with self.assertRaisesRegex(ValueError, "has lost the marks of its matrix"):
            script.between("nothing", "matrix", "something")


if __name__ == "__main__":
    unittest.main()
