"""tests/on_gpu --run with programs made for the purpose: every way to fail has to show in the exit status."""
import contextlib
import io
import json
import os
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "on_gpu_run"))
import correctness  # noqa: E402  (found by the line above)
import sanitizer  # noqa: E402
from outcome import Outcome  # noqa: E402
from programs import Programs  # noqa: E402

# One script under every program's name. BREAK names the one that misbehaves, HOW says in which way.
FAKE = f"#!{sys.executable}\n" + r'''
import json, os, sys, time
name, words = os.path.basename(sys.argv[0]), sys.argv[1:]
how = os.environ.get("HOW", "fails") if os.environ.get("BREAK") == name else ""
value = lambda option: words[words.index(option) + 1]
if name == "compute-sanitizer":
    kind = value("--tool")
    count = 2 if how == "reports" else 0
    line = "RACECHECK SUMMARY: %d hazards displayed (0 errors)" if kind == "racecheck" else "ERROR SUMMARY: %d errors"
    print("========= " + line % count if how != "silent" else "nothing")
    sys.exit(1 if count else 0)
if "--version" in words:
    sys.exit(0)
if "devices" in words:
    devices = [{"kind": "cuda", "name": "a GPU"}, {"kind": "cpu", "name": "worker pool"}]
    renderers = [] if os.environ.get("NO_OPENGL") else [{"name": "a GPU"}]
    open(value("--json"), "w").write(json.dumps({"devices": devices, "renderers": renderers}))
    sys.exit(0)
if how == "hangs":
    time.sleep(60)
if how == "fails":
    print("This went wrong; try another.", file=sys.stderr)
    sys.exit(1)
if how == "falls back" and "--screenshot" in words:
    print("CUDA failed at running a kernel. The game goes on with the cpu device.", file=sys.stderr)
if name == "gw_arithmetic":
    for what in ("pairs", "roots"):
        print(f"{what}: 4096 inputs, 16384 results compared, {int(how == 'differs')} blocks of 4096 inputs differ")
    if how == "differs":
        print("pairs: the first difference: 0x00000001 (1e-45) / 0x40000000 (2) is 0x00000000 (0) on one, 0x1 on other")
        sys.exit(1)
if name in ("parity_test", "draw_parity_gl_test"):
    state = "SKIPPED" if how == "skips" else "FAILED" if how == "differs" else "OK"
    print(f"[ RUN      ] Cases/PrimitivesParity.BothDevicesAgree/Scan\n"
          f"[ {state:>8} ] Cases/PrimitivesParity.BothDevicesAgree/Scan, where GetParam() = 3 (5 ms)")
    if how == "differs":
        sys.exit(1)
if name == "gpuwars" and "verify" in words:
    replay = {"file": "golden/a.gwr", "equal": True, "ticks": 9, "ticksCompared": 9}
    if how == "differs":
        replay.update(equal=False, firstDifference={"tick": 7})
    if how == "compares nothing":
        replay.update(ticksCompared=0)
    open(value("--json"), "w").write(json.dumps({"replays": [replay]}))
    if how == "differs":
        sys.exit(4)
if name == "gpuwars" and "--screenshot" in words and how != "draws nothing":
    open(value("--screenshot"), "w").write("PNG")
if name == "gw_bench_queued":
    row = {"scene": "mixed", "enemies": 8192, "tick_us": 40.0, "launchesPerTick": 30, "stages_us": {"think": 10.0}}
    open(value("--json"), "w").write(json.dumps({"copies_GBps": {"toHost": 50.0}, "rows": [row]}))
if name == "gw_bench_neighbours":
    if how == "writes nonsense":
        open(value("--csv"), "w").write("a,b\n1,2\n")
    else:
        rows = "ngrid,0.01,0.02,0.03\ngrid,0.01,0.01,0.02\n"
        open(value("--csv"), "w").write("way,maintain_ms,gather_ms,total_ms\n" + rows)
if how != "runs no kernel" and not os.environ.get("NO_KERNELS"):
    print("1,234 CUDA kernels run")
'''
PROGRAMS = ("gpuwars", "parity_test", "draw_parity_gl_test", "gw_arithmetic", "gw_bench_queued",
            "gw_bench_neighbours")


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "golden").mkdir()
        (self.folder / "golden" / "a.gwr").write_text("")
        self.tools = self.folder / "tools"
        self.tools.mkdir()
        for path in [self.folder / name for name in PROGRAMS] + [self.tools / "compute-sanitizer"]:
            path.write_text(FAKE)
            path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def run_all(self, *options, device="cuda", **environment):
        """(exit status, rows by "step: what", the table)."""
        result = self.folder / "result.json"
        result.unlink(missing_ok=True)
        run = subprocess.run(
            [sys.executable, HERE / "on_gpu_run", "--programs", self.folder, "--replays", self.folder / "golden",
             "--device", device, "--json", result, *options], capture_output=True, text=True, check=False,
            env={**os.environ, "PATH": f"{self.tools}:{os.environ['PATH']}", **environment})
        if not result.is_file():
            return run.returncode, {}, run.stderr
        self.document = json.loads(result.read_text())
        return run.returncode, {f"{row['step']}: {row['what']}": row for row in self.document["rows"]}, run.stdout

    def assert_fails(self, what, why, **how):
        step = what.split(":")[0].removeprefix("compute-")
        only = [] if step == "run" else ["--only", step]
        status, rows, table = self.run_all(*only, **how)
        self.assertEqual(status, 1, table)
        self.assertEqual(rows[what]["state"], "failed", rows[what])
        self.assertIn(why, rows[what]["text"])
        self.assertRegex(table.splitlines()[-2], r"[1-9]\d* failed")

    def test_all_is_well(self):
        status, rows, table = self.run_all()
        self.assertEqual(status, 0, table)
        self.assertFalse([row for row in rows.values() if row["state"] == "failed"])
        self.assertEqual(rows["replays: 1 golden, blocks of 64"]["figures"]["ticks"], 9)
        self.assertIn("goal at most 50 us: met", rows["ticks: 8,192 enemies, mixed"]["text"])
        self.assertIn("goal at most 20 us: missed", rows["neighbours: 8,192, ngrid"]["text"])
        self.assertNotIn("goal", rows["neighbours: 8,192, grid"]["text"])
        self.assertEqual(rows["compute-sanitizer: racecheck"]["state"], "passed")
        # 1 to see whether the device answers, arithmetic, parity, 3 verify, 2 for pictures, 2 scenes, 3 crowds.
        self.assertEqual(self.document["cudaKernelsRun"], 13 * 1234)
        self.assertTrue(table.endswith(f"{13 * 1234:,} CUDA kernels run\n"))
        self.assertIn("cores", self.document["machine"])
        self.assertIn("---- GpuWars on the cuda device: a GPU ----", table)
        self.assertRegex(self.document["date"], r"^\d{4}-\d\d-\d\dT")

    def test_each_program_that_fails_is_a_failure(self):
        for program, what in (("gw_arithmetic", "arithmetic: gw_arithmetic"), ("parity_test", "parity: as a whole"),
                              ("gw_bench_queued", "ticks: mixed"),
                              ("gw_bench_neighbours", "neighbours: 8,192")):
            with self.subTest(program):
                self.assert_fails(what, "exit status 1: This went wrong", BREAK=program)

    def test_each_program_that_is_missing_is_a_failure(self):
        for program, what in (("gw_arithmetic", "arithmetic: gw_arithmetic"), ("parity_test", "parity: parity_test"),
                              ("draw_parity_gl_test", "pictures: draw_parity_gl_test"),
                              ("gw_bench_queued", "ticks: gw_bench_queued")):
            with self.subTest(program):
                (self.folder / program).rename(self.folder / "away")
                self.assert_fails(what, "has not been built")
                (self.folder / "away").rename(self.folder / program)

    def test_differences_are_failures(self):
        for program, how, what, why in (
                ("gw_arithmetic", "differs", "arithmetic: + - * /", "0x00000001 (1e-45) / 0x40000000"),
                ("parity_test", "differs", "parity: Cases/PrimitivesParity", "0 passed, 1 failed"),
                ("gpuwars", "differs", "replays: a.gwr, blocks of 256", "tick 7 is the first"),
                ("gpuwars", "compares nothing", "replays: a.gwr, blocks of 64", "nothing was compared"),
                ("gpuwars", "falls back", "pictures: a game through EGL", "went on without its device: CUDA failed"),
                ("gpuwars", "draws nothing", "pictures: a game through EGL", "exit status 0"),
                ("compute-sanitizer", "reports", "compute-sanitizer: memcheck", "2 reports"),
                ("compute-sanitizer", "silent", "compute-sanitizer: initcheck", "exit status 0"),
                ("gw_bench_neighbours", "writes nonsense", "neighbours: as a whole", "KeyError")):
            with self.subTest(program=program, how=how):
                self.assert_fails(what, why, BREAK=program, HOW=how)

    def test_a_suite_of_skipped_tests_fails_where_the_device_is(self):
        self.assert_fails("parity: Cases/PrimitivesParity", "1 skipped", BREAK="parity_test", HOW="skips")
        status, rows, table = self.run_all(device="cpu", BREAK="parity_test", HOW="skips", NO_KERNELS="1")
        self.assertEqual(status, 0, table)
        self.assertEqual(rows["parity: Cases/PrimitivesParity"]["state"], "skipped")
        self.assertEqual(rows["compute-sanitizer: memcheck"]["state"], "skipped")
        self.assertEqual(self.document["cudaKernelsRun"], 0)

    def test_without_opengl_pictures_are_skipped(self):
        status, rows, table = self.run_all(NO_OPENGL="1")
        self.assertEqual(status, 0, table)
        self.assertEqual(rows["pictures: OpenGL"]["state"], "skipped")

    def test_no_kernels_are_no_test(self):
        self.assert_fails("run: CUDA kernels", "none has run", NO_KERNELS="1")

    def test_a_missing_device_is_one_sentence(self):
        status, rows, said = self.run_all(BREAK="gpuwars")
        self.assertEqual((status, rows), (1, {}))
        self.assertEqual(said, "This went wrong; try another.\n")

    def test_no_replay_is_a_failure(self):
        (self.folder / "golden" / "a.gwr").unlink()
        self.assert_fails(f"replays: {self.folder / 'golden'}", "there is none")

    def test_what_hangs_is_stopped(self):
        os.environ.update(BREAK="gw_arithmetic", HOW="hangs")
        self.addCleanup(lambda: [os.environ.pop(name) for name in ("BREAK", "HOW")])
        with contextlib.redirect_stdout(io.StringIO()):
            run = Programs(self.folder, Outcome("cuda"), self.folder, 470).run("gw_arithmetic", limit=1)
        self.assertTrue(run.stopped)
        self.assertFalse(run.fine)
        self.assertEqual(run.why, "stopped at its limit of 1 s")
        self.assertLess(run.seconds, 10)


class Parsing(unittest.TestCase):
    def test_suites(self):
        text = ("[ RUN      ] A.one\n[       OK ] A.one (3 ms)\n[  FAILED  ] A.two (12 ms)\n"
                "[  SKIPPED ] B/C.three/5, where GetParam() = 5 (0 ms)\n[  FAILED  ] 1 test, listed below:\n"
                "[  FAILED  ] A.two\n[  PASSED  ] 1 test.\n")
        self.assertEqual(correctness.gtest_suites(text), {"A": [1, 1, 0], "B/C": [0, 0, 1]})

    def test_reports(self):
        self.assertEqual(sanitizer.reports_in("========= ERROR SUMMARY: 0 errors\n"), 0)
        self.assertEqual(sanitizer.reports_in("========= ERROR SUMMARY: 1 error\n"), 1)
        self.assertEqual(sanitizer.reports_in("========= RACECHECK SUMMARY: 3 hazards displayed (3 errors)\n"), 3)
        self.assertIsNone(sanitizer.reports_in("========= COMPUTE-SANITIZER\n"))


if __name__ == "__main__":
    unittest.main()
