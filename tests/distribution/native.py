"""What a newcomer does on a Debian of today: ./play, ./check. With --quick: what ./play builds, and what it can do."""
import re
import sys
import time
from pathlib import Path

from game_steps import CLONE, Game
from outcome import FAILED, PASSED, SKIPPED
from root import APT_INSTALL

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "gates"))
from junit_counts import cases  # noqa: E402

PLAY_LIMIT_S, CHECK_LIMIT_S = 2 * 3600, 8 * 3600
LEFT_BY_PLAY = ("play.png", "play.gwr", "summary.txt")


def check_native(root, outcome, source, quick):
    clone = root.path / CLONE
    played = timed(root, outcome, "play", "./play", *(["--version"] if quick else []), limit_s=PLAY_LIMIT_S)
    if not quick and played == 0:
        absent = [name for name in LEFT_BY_PLAY if not (clone / "out" / name).is_file()]
        outcome.add("./play", FAILED if absent else PASSED, f"it left no {', '.join(absent)}" if absent else "")
    else:
        outcome.add("./play", FAILED if played else PASSED, f"exit status {played}" if played else "")
    outcome.compiler = f"g++ {root.said('/', 'g++', '-dumpfullversion')}"
    outcome.cmake = cmake_version(root)
    if not quick:
        read_check(outcome, root, clone, timed(root, outcome, "check", "./check", limit_s=CHECK_LIMIT_S))
    if played == 0:
        game = Game(root, outcome, "build/play/gpuwars")
        if quick:
            game.golden(source)
        if game.fixed_run() and game.picture():
            if root.said("/", "sh", "-c", "command -v ffmpeg") or root.status("/", *APT_INSTALL, "ffmpeg") == 0:
                game.film()
            else:
                outcome.add("film", SKIPPED, "ffmpeg could not be installed")


def timed(root, outcome, name, *command, limit_s):
    started = time.monotonic()
    status = root.status(f"/{CLONE}", *command, limit_s=limit_s)
    outcome.seconds[name] = time.monotonic() - started
    return status


def cmake_version(root):
    return root.said("/", "cmake", "--version").partition("\n")[0].removeprefix("cmake version ")


def read_check(outcome, root, clone, status):
    """The counts of its last line, and the names of its tests."""
    lines = root.log.read_text(errors="replace").rstrip().splitlines()
    last = re.fullmatch(r"(\d+) passed, (\d+) failed, (\d+) skipped", lines[-1]) if lines else None
    if last:
        outcome.counted = [int(count) for count in last.groups()]
    if not last or (status != 0) != (outcome.counted[1] > 0):
        outcome.add("./check", FAILED, f"exit status {status}, and its last line is '{lines[-1] if lines else ''}'")
    for junit in sorted((clone / "build").glob("*/junit_*.xml")):
        outcome.tests.update((f"{junit.parent.name}: {name}", state) for name, state in cases(junit))
