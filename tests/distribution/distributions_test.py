#!/usr/bin/env python3
"""tests/distributions without root's rights: fakes stand in for debootstrap, namespaces and what runs in them.

    distributions_test.py SOURCE
"""
import io
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(1)).resolve()
NEEDED = ("tests/distributions", "tests/distribution", "tests/replays", "tests/gates",
          "replays/golden.list", "replays/golden.facts")
# Neither needs namespaces: the command runs as it is, and of what would be mounted only empty folders matter.
UNSHARE = """#!/bin/sh
[ "$BREAK" != rights ] || { echo 'unshare: unshare failed: Operation not permitted' >&2; exit 1; }
while [ "$1" != -- ]; do shift; done
shift
exec "$@"
"""
MOUNT = """#!/bin/sh
for target; do :; done
case "$*" in *tmpfs*) rm -rf "$target" && mkdir "$target" ;; esac
"""
RELEASES = ("bookworm", "trixie", "forky")


class Fakes(unittest.TestCase):
    """A small repository with a commit, a mirror that is a folder, and fakes on PATH."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.repository, self.tools, self.calls = (self.folder / name for name in ("repository", "tools", "calls"))
        for name in NEEDED:
            copy = self.repository / name
            copy.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if (SOURCE / name).is_dir() else shutil.copy2)(SOURCE / name, copy)
        self.tools.mkdir()
        fake = (SOURCE / "tests/distribution/fake_machine.py").read_text()
        for name, text in (("debootstrap", fake), ("chroot", fake), ("unshare", UNSHARE), ("mount", MOUNT)):
            (self.tools / name).write_text(text)
            (self.tools / name).chmod(0o755)
        for release in RELEASES:
            (self.folder / "mirror/dists" / release).mkdir(parents=True)
            (self.folder / "mirror/dists" / release / "Release").write_text("")
        (self.folder / "scripts").mkdir()
        for name in ("bookworm", "trixie", "sid"):  # a debootstrap that is older than forky
            (self.folder / "scripts" / name).write_text("")
        self.git("init", "--quiet")
        self.commit("first")
        self.calls.write_text("")

    def git(self, *arguments):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *arguments], cwd=self.repository, check=True)

    def commit(self, text):
        (self.repository / "file").write_text(text)
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", text)

    def start(self, *arguments, broken="", mirror=None):
        environment = {**os.environ, "PATH": f"{self.tools}:{os.environ['PATH']}", "FAKE_CALLS": str(self.calls),
                       "BREAK": broken, "DEBOOTSTRAP_DIR": str(self.folder), "GW_DISTRIBUTIONS": str(self.folder / "kept"),
                       "PYTHONDONTWRITEBYTECODE": "1"}
        return subprocess.Popen(
            [self.repository / "tests/distributions", *arguments, "--mirror", mirror or (self.folder / "mirror").as_uri()],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)

    def distributions(self, *arguments, **how):
        """(exit status, all it said, the commands that ran in roots and debootstrap's)."""
        self.calls.write_text("")
        child = self.start(*arguments, **how)
        said, wrong = child.communicate(timeout=120)
        return child.returncode, said + wrong, self.calls.read_text().splitlines()

    def fails(self, *arguments, broken, says, last):
        status, said, _calls = self.distributions(*arguments, "--again", broken=broken)
        self.assertEqual(status, 1, said)
        self.assertIn(says, said)
        self.assertEqual(said.splitlines()[-1], last, said)


class Running(Fakes):
    def test_all_suites_in_full(self):
        status, said, calls = self.distributions("--markdown", str(self.folder / "table.md"))
        self.assertEqual(status, 0, said)
        self.assertEqual([call for call in calls if call.startswith("debootstrap")],
                         ["debootstrap bookworm", "debootstrap trixie",
                          f"debootstrap forky {(self.folder / 'mirror').as_uri()} {self.folder}/scripts/sid"])
        for release in RELEASES:
            self.assertLess(calls.index(f"{release}: ./play"), calls.index(f"{release}: ./check"))
        golden = sum(call.startswith("aarch64: build/aarch64/gpuwars verify") for call in calls)
        self.assertGreater(golden, 1, "a call for each set of options")
        replays = len((self.repository / "replays/golden.facts").read_text().splitlines()) - 2
        # ./play, fixed run, picture, film, same hash, same picture, and the tests of ./check; or cross-build, fixed run,
        # floating-point state, same hash, and the replays.
        passed = 6 + 1 + 2 * (6 + 2) + 4 + replays
        self.assertEqual(said.splitlines()[-1], f"{passed} passed, 0 failed, 3 skipped")
        self.assertRegex(said, r"trixie +g\+\+ 14\.2\.0 +3\.31\.6 +0\.\d +0\.\d +8 +0 +1 +fedcba9876543210")
        self.assertIn("skipped on forky: release: screen", said)
        self.assertIn("bookworm has not: release: new", said)
        table = (self.folder / "table.md").read_text()
        self.assertIn("| bookworm | g++ 12.2.0 | 3.31.6 |", table)
        self.assertIn("- bookworm has not: release: new", table)
        self.assertEqual(list((self.folder / "kept/runs").iterdir()), [], "roots in use are thrown away")

    def test_the_fake_names_its_results_as_check_does(self):
        self.assertIn("build/$preset/junit_$part.xml", (SOURCE / "check").read_text())
        self.assertIn("build/release/junit_rest.xml", (SOURCE / "tests/distribution/fake_machine.py").read_text())

    def test_quick_leaves_check_out_and_long_replays_under_emulation(self):
        status, said, calls = self.distributions("--quick", "trixie", "aarch64")
        self.assertEqual(status, 0, said)
        self.assertIn("trixie: ./play --version", calls)
        self.assertFalse([call for call in calls if "./check" in call])
        verified = [word for call in calls if call.startswith("trixie: build/play/gpuwars verify") for word in call.split()]
        self.assertIn("replays/long_watch.gwr", verified)
        emulated = [word for call in calls if call.startswith("aarch64: build") for word in call.split()]
        self.assertIn("replays/kamikaze_expert.gwr", emulated)
        self.assertNotIn("replays/long_watch.gwr", emulated)
        self.assertRegex(said, r"aarch64: with --quick \d+ of \d+ golden replays, those of at most 1,800 ticks")

    def test_what_fails_fails_the_run(self):
        for broken, says, last in (
                ("play", "failed on trixie: ./play: exit status 1", "2 passed, 1 failed, 1 skipped"),
                ("summary", "./play: it left no summary.txt", "5 passed, 1 failed, 1 skipped"),
                ("check", "failed on trixie: release: one", "5 passed, 1 failed, 1 skipped"),
                ("the last line", "its last line is 'Segmentation fault'", "4 passed, 1 failed, 0 skipped"),
                ("matrix", "decoded, the luma of pure", "5 passed, 1 failed, 1 skipped"),
                ("range", "decoded, the luma of pure", "5 passed, 1 failed, 1 skipped"),
                ("colour", "it has lost its colours", "5 passed, 1 failed, 1 skipped"),
                ("tags", "it must be marked as bt709, but says color_transfer unknown", "5 passed, 1 failed, 1 skipped"),
                ("frames", "it has 30 frames of 31", "5 passed, 1 failed, 1 skipped")):
            with self.subTest(broken):
                self.fails("trixie", broken=f"trixie {broken}", says=says, last=last)
        self.assertTrue((self.folder / "kept/runs/trixie/usr/src/gpuwars/file").is_file(), "its root is kept")

    def test_replays_that_differ_fail(self):
        whole = self.distributions("--quick", "trixie")[1].splitlines()[-1]
        passed = int(whole.split()[0])
        for broken, says in (("replay", "differs from tick 7 on"), ("report", "score was"), ("length", "ticks were compared")):
            with self.subTest(broken):
                groups = sum("| --" in line for line in (SOURCE / "replays/golden.list").read_text().splitlines())
                status, said, calls = self.distributions("--quick", "trixie", "--again", broken=f"trixie {broken}")
                calls = sum("gpuwars verify" in call for call in calls)
                self.assertGreater(groups, 1)
                self.assertEqual((status, said.splitlines()[-1]), (1, f"{passed - calls} passed, {calls} failed, 0 skipped"))
                self.assertIn(says, said)
        self.fails("--quick", "trixie", broken="trixie verify", says="verify says nothing of it",
                   last=f"4 passed, {passed - 4} failed, 0 skipped")

    def test_suites_are_held_against_each_other(self):
        status, said, _calls = self.distributions("bookworm", "forky", "aarch64", broken="forky hash")
        self.assertEqual(status, 1)
        self.assertIn("failed on forky: same hash: 0123456789abcdef here, fedcba9876543210 on bookworm", said)
        status, said, _calls = self.distributions("trixie", "forky", "--again", broken="forky picture")
        self.assertEqual(status, 1)
        self.assertIn("failed on forky: same picture: a block differs by 40 of 255 from trixie's", said)

    def test_a_cross_build_that_fails(self):
        self.fails("aarch64", broken="aarch64 cmake", says="failed on aarch64: cross-build: it does not compile",
                   last="0 passed, 1 failed, 0 skipped")

    def test_a_float_state_that_is_felt(self):
        status, said, _calls = self.distributions("aarch64", "--quick", broken="aarch64 float state")
        self.assertEqual(status, 1)
        self.assertIn("floating-point state: rounding upwards before main(), the fixed run ends on 0123456789abcdef", said)


class Resuming(Fakes):
    def ran(self, *arguments, **how):
        return {call.partition(":")[0] for call in self.distributions(*arguments, **how)[2] if ": ./" in call}

    def test_what_has_passed_is_kept_with_its_commit(self):
        self.assertEqual(self.ran("bookworm", "trixie", broken="trixie check"), {"bookworm", "trixie"})
        self.assertEqual(self.ran("bookworm", "trixie"), {"trixie"}, "what failed is repeated, and then kept")
        status, said, calls = self.distributions("bookworm", "trixie")
        self.assertEqual((status, calls), (0, []))
        self.assertIn("bookworm: passed before", said)
        self.assertEqual(said.splitlines()[-1], "15 passed, 0 failed, 2 skipped", "its tests count all the same")
        self.assertEqual(self.ran("bookworm", "trixie", "--again"), {"bookworm", "trixie"})
        self.assertEqual(self.ran("bookworm", "--quick"), {"bookworm"}, "the other way of running is another outcome")
        self.commit("second")
        status, said, calls = self.distributions("bookworm", "--table")
        self.assertEqual((calls, said.splitlines()[-1]), ([], "0 passed, 0 failed, 0 skipped"))
        status, said, calls = self.distributions("bookworm")
        self.assertIn("bookworm: ./check", calls)
        self.assertFalse([call for call in calls if call.startswith("debootstrap")], "the root is kept")

    def test_roots_that_are_old_or_half_made_are_made_anew(self):
        self.distributions("bookworm", broken="debootstrap")
        self.assertIn("debootstrap bookworm", self.distributions("bookworm")[2])
        long_ago = time.time() - 15 * 86400
        os.utime(self.folder / "kept/roots/bookworm", (long_ago, long_ago))
        self.assertIn("debootstrap bookworm", self.distributions("bookworm", "--again")[2])

    def test_an_interrupted_run_leaves_nothing_running_and_goes_on(self):
        child = self.start("bookworm", "trixie", broken="trixie patience")
        while "trixie: ./check" not in self.calls.read_text():
            time.sleep(0.05)
            self.assertIsNone(child.poll())
        group = [int(process) for process in os.listdir("/proc") if process.isdigit() and self.runs(process)]
        self.assertTrue(group)
        child.send_signal(signal.SIGTERM)
        said, wrong = child.communicate(timeout=60)
        self.assertEqual((child.returncode, wrong), (1, "Interrupted; run it again to go on.\n"), said)
        self.assertFalse([process for process in group if self.runs(process)])
        self.assertEqual(self.ran("bookworm", "trixie"), {"trixie"})

    def runs(self, process):
        try:
            return str(self.tools / "chroot").encode() in Path(f"/proc/{process}/cmdline").read_bytes()
        except OSError:
            return False

    def test_two_runs_in_one_folder(self):
        child = self.start("trixie", broken="trixie patience")
        while "trixie: ./check" not in self.calls.read_text():
            time.sleep(0.05)
        status, said, _calls = self.distributions("bookworm")
        child.send_signal(signal.SIGINT)
        child.communicate(timeout=60)
        self.assertEqual(status, 1)
        self.assertIn("Another run works in", said)


class Lacking(Fakes):
    def skipped(self, says, **how):
        status, said, _calls = self.distributions("trixie", "forky", **how)
        self.assertEqual((status, said.splitlines()[-1]), (0, "0 passed, 0 failed, 2 skipped"), said)
        self.assertIn(f"skipped on forky: forky: {says}", said)

    def test_what_the_machine_lacks_is_skipped_and_counted(self):
        self.skipped("root's rights are missing (unshare: unshare failed", broken="rights")
        self.skipped("the mirror has no forky or does not answer", mirror=(self.folder / "nowhere").as_uri())
        (self.tools / "debootstrap").unlink()
        if shutil.which("debootstrap") is None:
            self.skipped("debootstrap is not here; install the package debootstrap")
        self.assertEqual(self.distributions("--table")[1].splitlines()[-1], "0 passed, 0 failed, 2 skipped")

    def test_a_root_that_cannot_be_made_fails(self):
        self.fails("trixie", broken="debootstrap", says="failed on trixie: trixie: debootstrap could not make its root",
                   last="0 passed, 1 failed, 0 skipped")

    def test_bad_arguments(self):
        status, said, calls = self.distributions("woody")
        self.assertEqual((status, calls), (2, []))
        self.assertIn("there is no suite 'woody'; choose of bookworm, trixie, forky, aarch64", said)
        self.assertEqual(self.distributions("--slow")[0], 2)

    def test_uncommitted_changes_are_told(self):
        (self.repository / "file").write_text("changed")
        status, said, _calls = self.distributions("bookworm", "--quick")
        self.assertEqual(status, 0)
        self.assertIn("Uncommitted changes take no part", said)


class Mirrors(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.etc = Path(folder.name)
        (self.etc / "apt/sources.list.d").mkdir(parents=True)
        (self.etc / "os-release").write_text('ID=debian\nVERSION_CODENAME=bookworm\n')

    def sources(self, name, text):
        (self.etc / "apt" / name).write_text(text)

    def test_of_lines(self):
        self.sources("sources.list", "# deb http://old bookworm main\ndeb cdrom:[Debian 12]/ bookworm main\n"
                     "deb-src http://source.example bookworm main\ndeb http://security.example bookworm-security main\n"
                     "deb [arch=amd64 signed-by=/x.gpg] http://mirror.example/debian/ bookworm main contrib\n")
        self.assertEqual(mirror.machine_mirror(self.etc), "http://mirror.example/debian")

    def test_of_stanzas(self):
        self.sources("sources.list.d/a.sources", "Types: deb\nURIs: http://off.example\nSuites: bookworm\nComponents: main\n"
                     "Enabled: no\n\nTypes: deb\nURIs: http://other.example/\nSuites: nodistro\nComponents: main\n")
        self.sources("sources.list.d/b.sources", "# ours\nTypes: deb deb-src\nURIs:\n https://mirror.example/debian\n"
                     "Suites: bookworm bookworm-updates\nComponents: main\nSigned-By: /x.gpg\n")
        self.assertEqual(mirror.machine_mirror(self.etc), "https://mirror.example/debian")

    def test_none(self):
        with self.assertRaisesRegex(mirror.NoMirror, "--mirror"):
            mirror.machine_mirror(self.etc)
        (self.etc / "os-release").write_text("ID=ubuntu\n")
        with self.assertRaisesRegex(mirror.NoMirror, "no Debian"):
            mirror.machine_mirror(self.etc)

    def test_proxies(self):
        settings = 'Acquire::http::Proxy "http://proxy:3128";\nAcquire::https::Proxy "DIRECT";\n'
        self.assertEqual(mirror.proxies(settings, {}), {"http_proxy": "http://proxy:3128"})
        self.assertEqual(mirror.proxies(settings, {"http_proxy": "http://mine"}), {"http_proxy": "http://mine"})


class Colours(unittest.TestCase):
    def test_blocks(self):
        width, height = 40, 20  # not whole blocks
        rgb = bytes([200, 100, 0] * 16 + [0, 0, 0] * 8 + [20, 40, 60] * 16) * height
        means = film_colours.blocks(rgb, width, height)
        self.assertEqual(means, bytes([200, 100, 0, 10, 20, 30, 20, 40, 60] * 2))
        self.assertEqual(film_colours.colourful(means), 200)
        with self.assertRaises(ValueError):
            film_colours.blocks(rgb[1:], width, height)

    def test_faults(self):
        drawn = bytes([200, 0, 0, 0, 200, 0, 0, 0, 200, 0, 0, 0, 90, 90, 90])
        faint = bytes(100 - value // 8 for value in drawn)
        self.assertEqual(film_colours.colours_fault(drawn, drawn), "")
        self.assertIn("too little colour", film_colours.colours_fault(faint, drawn))
        swapped = b"".join(drawn[i:i + 3][::-1] for i in range(0, len(drawn), 3))
        self.assertIn("the luma of pure red is off by -36", film_colours.colours_fault(drawn, swapped))


class Namespaces(unittest.TestCase):
    """enter_root.sh for real, in a root that is made of this machine's own folders."""

    def test_nothing_outlives_the_command(self):
        if os.geteuid() != 0 or subprocess.run([*root.APART, "true"], stderr=subprocess.DEVNULL, check=False).returncode:
            self.skipTest("needs root's rights")
        with tempfile.TemporaryDirectory() as folder:
            place, packages = Path(folder) / "root", Path(folder) / "packages"
            for name in ("proc", "sys", "dev", "tmp", "etc", "var/cache/apt/archives"):
                (place / name).mkdir(parents=True)
            packages.mkdir()
            binds = []
            for name in ("usr", "bin", "sbin", "lib", "lib64"):
                if Path("/", name).is_symlink():
                    (place / name).symlink_to(os.readlink(f"/{name}"))
                elif Path("/", name).is_dir():
                    (place / name).mkdir()
                    binds.append(f"mount --bind /{name} {place}/{name}")
            inside = ("sleep 1000 & exec 3<>/dev/ptmx && test -t 3 && test -c /dev/null && test -w /dev/shm && "
                      "test -r /proc/self/mounts && test -r /sys/kernel && touch /var/cache/apt/archives/a.deb && "
                      "test \"$COLOUR\" = red && pwd")
            enter = " ".join([*root.APART, f"{SOURCE}/tests/distribution/enter_root.sh", f"{place} {packages} /tmp",
                              f"COLOUR=red sh -c '{inside}'"])
            done = subprocess.run(["unshare", "--mount", "sh", "-ec", "\n".join([*binds, f"exec {enter}"])],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (0, "/tmp\n"), done.stderr)
            self.assertTrue((packages / "a.deb").is_file())
            self.assertNotIn(str(place), Path("/proc/self/mounts").read_text())
            self.assertEqual(list((place / "dev").iterdir()), [])
            left = subprocess.run(["find", "/proc", "-maxdepth", "2", "-name", "root", "-lname", f"{place}*"],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
            self.assertEqual(left.stdout, "", "a process outlived its root")


class Terminal(io.StringIO):
    def isatty(self):
        return True


class Showing(unittest.TestCase):
    def test_progress_is_one_line_of_a_terminal(self):
        with tempfile.TemporaryDirectory() as folder:
            log = Path(folder) / "log"
            log.write_text("before\n[7/9] Building\x1b[0m " + "x" * 500)
            for stream, shown in ((Terminal(), True), (io.StringIO(), False)):
                progress = show.Progress(stream)
                progress.suite = "trixie"
                progress(83, log)
                self.assertEqual("\r\x1b[Ktrixie: 1:23 " in stream.getvalue(), shown)
                self.assertNotIn("\n", stream.getvalue())


if __name__ == "__main__":
    sys.path.insert(0, str(SOURCE / "tests/distribution"))
    import film_colours
    import mirror
    import root
    import show
    unittest.main()
