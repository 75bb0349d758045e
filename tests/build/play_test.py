#!/usr/bin/env python3
"""./play with programs around it that only say how they were called: what it builds, and what it starts.

    play_test.py SOURCE FOLDER
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures, without_display  # noqa: E402

# Says its arguments; a game makes what a headless one is asked for.
GAME = """#!/bin/sh
printf 'game:'; printf ' <%s>' "$@"; echo
while [ $# -gt 0 ]; do
  case "$1" in --record | --screenshot) echo content > "$2" ;; esac
  shift
done
"""
CMAKE = """#!/bin/sh
echo "cmake: $*" >> "$LOG"
[ "$1" = --build ] || { mkdir -p build/play; : > build/play/build.ninja; : > build/play/CMakeCache.txt; }
"""


def script(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)


class Checkout:
    """A folder with ./play, a game that is built already, and tools that write a log."""

    def __init__(self, source, folder):
        shutil.rmtree(folder, ignore_errors=True)
        self.folder, self.log, self.tools = folder, folder / "log", folder / "path"
        script(folder / "play", (source / "play").read_text())
        script(folder / "tools/install_packages.sh", "#!/bin/sh\n")
        script(folder / "build/play/gpuwars", GAME)
        script(self.tools / "cmake", CMAKE)
        self.compiler("c++", "g++ 12.2")

    def compiler(self, name, version):
        script(self.tools / name, f"#!/bin/sh\necho {version}\n")

    def play(self, *arguments, **variables):
        """(what ./play printed, how CMake was called)"""
        self.log.write_text("")
        environment = {**without_display(), "LOG": str(self.log), "PATH": f"{self.tools}:/usr/bin:/bin", **variables}
        environment.pop("CXX", None)
        result = subprocess.run([self.folder / "play", *arguments], env=environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, cwd=os.sep)
        return result.stdout, self.log.read_text()


def check_what_is_started(failures, checkout):
    def started(arguments, **variables):
        return checkout.play(*arguments, **variables)[0]

    as_asked = [["trim", "a.gwr", "--out", "b.gwr"], ["diff", "a", "b"], ["probe", "a"], ["verify", "a", "-j", "2"],
                ["replay", "a"], ["render", "a", "--out", "b.png"], ["profile", "--out", "c"], ["devices"], ["scores"],
                ["--headless", "--ticks", "5"], ["play", "--headless", "--ticks", "5"], ["--help"], ["-h"],
                ["--version"], ["play", "--help"]]
    for arguments in as_asked:
        told = "".join(f" <{argument}>" for argument in arguments)
        out = started(arguments)
        failures.check(out.endswith(f"game:{told}\n") and "autopilot" not in out,
                       f"without a display {' '.join(arguments)} is what is started: {out.splitlines()[-1:]}")
    for arguments in ([], ["play"], ["--seed", "3"], ["play", "--mode", "swarm"]):
        out = started(arguments)
        own = [word for word in arguments if word != "play"]
        failures.check("game: <--headless> <--autopilot> <expert>" in out and all(f"<{word}>" in out for word in own)
                       and "<play>" not in out and "out/play.png (8 bytes)" in out,
                       f"without a display the autopilot plays '{' '.join(arguments)}'")
        out = started(arguments, DISPLAY=":7")
        failures.check("autopilot" not in out and "game:" in out, f"with one a player does: {out.splitlines()[-1:]}")
    out = started(["--ticks", "60", "--autopilot=novice"])
    failures.check(out.count("--ticks") == 1 and "expert>" not in out, "what was asked for is not said twice")


def check_what_is_built(failures, checkout):
    shutil.rmtree(checkout.folder / "build")
    script(checkout.folder / "build/play/gpuwars", GAME)
    _, first = checkout.play("devices")
    failures.check("-DGW_TESTS=OFF" in first and "--target gpuwars" in first, f"only the game is built: {first}")
    _, again = checkout.play("devices")
    failures.check("-S ." not in again and "--build" in again, f"nothing is configured twice: {again}")

    def configured(why):
        _, log = checkout.play("devices")
        failures.check("-S ." in log, f"{why} configures again: {log}")
        _, log = checkout.play("devices")
        failures.check("-S ." not in log, f"and once only: {log}")

    checkout.compiler("c++", "g++ 16.2")
    configured("another version of the compiler")
    checkout.compiler("g++-15", "g++ 15.1")
    configured("a compiler that nvcc may take")
    script(checkout.tools / "nvcc", "#!/bin/sh\n")
    configured("nvcc")
    os.utime(checkout.tools / "nvcc", (1, 1))
    configured("another nvcc of the same name")


def main():
    source, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    failures = Failures()
    checkout = Checkout(source, folder)
    check_what_is_started(failures, checkout)
    check_what_is_built(failures, checkout)
    failures.finish()


if __name__ == "__main__":
    main()
