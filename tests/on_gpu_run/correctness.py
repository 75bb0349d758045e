"""The steps that compare the device with another: arithmetic, parity tests, golden replays, pictures."""
import json
import re

from machine import devices
from outcome import FAILED, FIGURE, PASSED, SKIPPED

ARITHMETIC = re.compile(r"^(pairs|roots): (\d+) inputs, (\d+) results compared, (\d+) blocks", re.MULTILINE)
FIRST_DIFFERENCE = re.compile(r"^(?:pairs|roots): (the first difference: .*)$", re.MULTILINE)
# A result line is "[       OK ] Suite.Name (3 ms)"; the summary at the end repeats names without a time.
GTEST = re.compile(r"^\[ +(OK|SKIPPED|FAILED) +\] ([^\s.]+)\.\S+.* \(\d+ ms\)", re.MULTILINE)


def arithmetic(programs, outcome, sizes):
    if not programs.has("gw_arithmetic"):
        return outcome.add("arithmetic", "gw_arithmetic", FAILED, "has not been built")
    run = programs.run("gw_arithmetic", "--device", programs.device, "--pairs", sizes.pairs, "--roots", sizes.roots,
                       limit=90)
    found = ARITHMETIC.findall(run.text)
    other = "the cpu device" if programs.device == "cuda" else "doubles"
    for what, inputs, results, differing in found:
        equal = int(differing) == 0
        difference = FIRST_DIFFERENCE.search(run.text)
        text = f"{int(results):,} results of {int(inputs):,} inputs, compared with {other}: " + (
            "0 differences" if equal else f"{differing} blocks differ; {difference.group(1) if difference else ''}")
        outcome.add("arithmetic", "+ - * /" if what == "pairs" else "square roots", PASSED if equal else FAILED, text,
                    run.command, inputs=int(inputs), differingBlocks=int(differing))
    if not run.fine or len(found) != 2:
        outcome.add("arithmetic", "gw_arithmetic", FAILED, run.why, run.command)
    return None


def gtest_suites(text):
    """{suite: [passed, failed, skipped]}, in the order in which they ran."""
    suites = {}
    for state, suite in GTEST.findall(text):
        counts = suites.setdefault(suite, [0, 0, 0])
        counts[("OK", "FAILED", "SKIPPED").index(state)] += 1
    return suites


def add_suites(outcome, step, run, may_skip):
    """A row for each suite; one that is skipped altogether has failed where nothing has a reason to skip it."""
    suites = gtest_suites(run.text)
    for suite, (passed, failed, skipped) in suites.items():
        wrong = failed or not (passed or may_skip)
        state = FAILED if wrong else PASSED if passed else SKIPPED
        outcome.add(step, suite, state, f"{passed} passed, {failed} failed, {skipped} skipped", run.command,
                    passed=passed, failed=failed, skipped=skipped)
    if not run.fine or not suites:
        outcome.add(step, "as a whole", FAILED, run.why, run.command)


def parity(programs, outcome, sizes):
    if not programs.has("parity_test"):
        return outcome.add("parity", "parity_test", FAILED, "has not been built")
    run = programs.run("parity_test", "--gtest_color=no", f"--gtest_filter={sizes.parity_filter}", limit=120)
    return add_suites(outcome, "parity", run, may_skip=programs.device == "cpu")


def replays(programs, outcome, sizes):
    files = sorted(sizes.replays.glob("*.gwr"))
    if not files:
        return outcome.add("replays", str(sizes.replays), FAILED, "there is none")
    for block_size in sizes.block_sizes if programs.device == "cuda" else [None]:
        options = ["--block-size", block_size] if block_size else []
        result = programs.logs / "verify.json"
        result.unlink(missing_ok=True)
        run = programs.run("gpuwars", "verify", *files, "--device", programs.device, "--json", result, *options,
                           limit=120 if programs.device == "cuda" else 400)
        blocks = f", blocks of {block_size}" if block_size else ""
        try:
            verified = json.loads(result.read_text())["replays"]
        except (OSError, ValueError, KeyError):
            outcome.add("replays", f"all{blocks}", FAILED, run.why, run.command)
            continue
        equal = [replay for replay in verified if replay["equal"] and replay["ticks"] == replay["ticksCompared"] > 0]
        for replay in verified:
            if replay not in equal:
                where = replay.get("firstDifference", {}).get("tick")
                why = replay.get("error") or replay.get("wrongResult") or (
                    f"tick {where} is the first that differs" if where else "nothing was compared")
                outcome.add("replays", replay["file"].split("/")[-1] + blocks, FAILED, why, run.command)
        ticks = sum(replay["ticksCompared"] for replay in verified)
        good = run.fine and len(equal) == len(files)
        outcome.add("replays", f"{len(files)} golden{blocks}", PASSED if good else FAILED,
                    f"{ticks:,} ticks compared" + (", 0 mismatches" if good else f"; {run.why}"), run.command,
                    ticks=ticks, seconds=round(run.seconds, 3), blockSize=block_size)
    return None


def pictures(programs, outcome, sizes):
    """The game drawn without a window, by way of CUDA's memory shared with OpenGL where the device is cuda.

    A machine may compute and have no OpenGL at all: then all of this is skipped, and the table says so.
    """
    if not devices(programs)["renderers"]:
        return outcome.add("pictures", "OpenGL", SKIPPED, "no renderer answers here")
    picture = sizes.out / "play.png"
    picture.unlink(missing_ok=True)
    run = programs.run("gpuwars", "play", "--headless", "--ticks", sizes.picture_ticks, "--autopilot", "expert",
                       "--seed", 1, "--device", programs.device, "--screenshot", picture, *programs.assets, limit=60)
    drawn = run.fine and picture.is_file()
    outcome.add("pictures", "a game through EGL", PASSED if drawn else FAILED,
                f"{picture.name}, {picture.stat().st_size:,} bytes" if drawn else run.why, run.command)
    if not programs.has("draw_parity_gl_test"):
        return outcome.add("pictures", "draw_parity_gl_test", FAILED, "has not been built")
    # Faults can only be had from the stand-in, where ctest runs those tests by themselves.
    run = programs.run("draw_parity_gl_test", "--gtest_color=no", "--gtest_filter=-*Faults*", limit=90,
                       environment={"GW_SCREENSHOTS": str(sizes.out)})
    add_suites(outcome, "pictures", run, may_skip=True)
    return outcome.add("pictures", "screenshots", FIGURE, f"{len(list(sizes.out.glob('*.png')))} in {sizes.out}")
