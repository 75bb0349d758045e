#!/usr/bin/env python3
"""A recording survives the game that is killed, and trim and diff do what they say.

    cut_short_e2e.py GPUWARS FORGE_REPLAY FORMATS FOLDER
"""
import json
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, without_display

FINE, DIFFER, USAGE, FILE, DESYNC = range(5)
SMALL = ["--headless", "--device", "cpu", "--autopilot", "expert", "--enemies", 512]


def parts(target):
    return sorted(target.parent.glob(target.name + ".part-*"))


def kill_while_recording(program, target, how, seconds, meanwhile=lambda: None):
    """Starts a game that would take long and kills it once it has recorded for a while."""
    command = [program, *map(str, [*SMALL, "--ticks", 100000, "--record", target])]
    with subprocess.Popen(command, env=without_display(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as game:
        until = time.monotonic() + 60
        while time.monotonic() < until:
            time.sleep(0.05)
            if any(part.stat().st_size > 3000 + 1500 * seconds for part in parts(target)):
                break
        meanwhile()
        game.send_signal(how)
        game.wait(60)
        return game.returncode


def main():
    program, forge, formats, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()

    def refused(name, code, *arguments, says=()):
        got, stdout, stderr = run(program, *arguments)
        good = got == code and len(stderr.splitlines()) == 1 and all(word in stderr for word in says)
        failures.check(good, f"{name}: exit {code}, one sentence" + ("" if good else f"; got {got}: {stderr!r}"))

    def accepted(name, *arguments, code=FINE):
        got, stdout, stderr = run(program, *arguments)
        good = got == code and stderr == ""
        failures.check(good, f"{name}: exit {code}" + ("" if good else f"; got {got}: {stderr!r}"))
        return stdout

    # Killed, and made whole.
    target, whole = folder / "run.gwr", folder / "whole.gwr"
    failures.check(kill_while_recording(program, target, signal.SIGKILL, 4) == -signal.SIGKILL, "a recording game is killed")
    left = parts(target)
    failures.check(len(left) == 1 and not target.exists(), f"its recording is left as {[p.name for p in left]}")
    if not left:
        failures.finish()
    part = left[0]
    refused("verify of what is left", FILE, "verify", part, says=["without its end mark", "gpuwars trim"])
    before = part.read_bytes()
    accepted("trim makes it whole", "trim", part, "--out", whole, "--device", "cpu")
    failures.check(part.read_bytes() == before, "and leaves what it was made of")
    accepted("which verifies", "verify", whole, "--device", "cpu")
    found = json.loads(accepted("and differs in its end only", "diff", part, whole, "--json", code=DIFFER))
    ticks = found["b"]["ticks"]
    failures.check(found["a"]["ticks"] == ticks and ticks % 60 == 0 and ticks >= 120, f"every second of {ticks} ticks is there")
    failures.check(not found["a"]["whole"] and found["b"]["whole"] and not found["hash"] and not found["input"], "as diff says")

    live = folder / "live.gwr"
    kill_while_recording(program, live, signal.SIGKILL, 1, lambda: refused(
        "trim over what is being recorded", FILE, "trim", parts(live)[0], "--out", parts(live)[0], "--device", "cpu",
        says=["still being recorded", "another name"]))

    # Recorded again to the same name.
    code, _, stderr = run(program, *SMALL, "--ticks", 130, "--record", target)
    failures.check(code == FINE and len(stderr.splitlines()) == 1 and part.name in stderr and "trim" in stderr,
                   "the next recording to that name says what is left, in one sentence")
    failures.check(part.read_bytes() == before and parts(target) == [part], "and neither overwrites nor deletes it")
    accepted("it is recorded all the same", "verify", target, "--device", "cpu")
    part.unlink()

    # The polite way out is a whole recording.
    failures.check(kill_while_recording(program, folder / "polite.gwr", signal.SIGTERM, 2) == 143, "SIGTERM ends a game well, and its exit status says so")
    accepted("its recording is whole", "verify", folder / "polite.gwr", "--device", "cpu")
    failures.check(not parts(folder / "polite.gwr"), "and nothing else is left")

    # A disk that is full, by way of a limit on file sizes.
    full = folder / "full.gwr"
    limited = subprocess.run([program, *map(str, [*SMALL, "--ticks", 1200, "--record", full])], env=without_display(),
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (9000, 9000)),
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=300, check=False)
    said = limited.stderr.decode()
    failures.check(limited.returncode == FILE and len(said.splitlines()) == 1 and "gpuwars trim" in said,
                   f"a full disk is reported at the end of the run: {limited.returncode} {said!r}")
    accepted("what was written before is not lost", "trim", parts(full)[0], "--out", full, "--device", "cpu")
    accepted("and is whole", "verify", full, "--device", "cpu")

    # Trim: shorter, older, over itself, and refusals.
    short = folder / "short.gwr"
    accepted("trim to a tick", "trim", target, "--out", short, "--to", 61, "--device", "cpu")
    accepted("which verifies", "verify", short, "--device", "cpu")
    found = json.loads(accepted("and is shorter", "diff", target, short, "--json", code=DIFFER))
    failures.check((found["a"]["ticks"], found["b"]["ticks"], found["hash"]) == (130, 61, None), "by the ticks asked for")
    accepted("trim over itself", "trim", target, "--out", target, "--device", "cpu", "--threads", 1, "--broad-phase", "brute")
    accepted("changes nothing in a whole run", "verify", target, "--device", "cpu")
    shutil.copy(target, folder / "same.gwr")
    accepted("trim again", "trim", target, "--out", target, "--device", "cpu")
    failures.check(target.read_bytes() == (folder / "same.gwr").read_bytes(), "equal runs give equal files")
    updated = folder / "updated.gwr"
    accepted("trim brings format 1 up to date", "trim", formats / "format_1.gwr", "--out", updated, "--to", 300, "--device", "cpu")
    failures.check(updated.read_bytes()[8:10] == b"\x02\x00" and b"FLDS" in updated.read_bytes(), "with hashes by field")
    refused("trim past the end", USAGE, "trim", target, "--out", short, "--to", 131, says=["up to 130"])
    refused("trim to nowhere", FILE, "trim", target, "--out", folder / "none" / "x.gwr", says=["none"])
    run(forge, target, folder / "forged.gwr", "hash", 100)
    untouched = short.read_bytes()
    refused("trim of a run that differs", DESYNC, "trim", folder / "forged.gwr", "--out", short, "--device", "cpu",
            says=["tick 100", "--to 99"])
    failures.check(short.read_bytes() == untouched, "and what stood there is untouched")
    accepted("trim up to before that", "trim", folder / "forged.gwr", "--out", short, "--to", 99, "--device", "cpu")

    # A game that is over ends its replay, also where a file goes on after that.
    over, longer = folder / "over.gwr", folder / "longer.gwr"
    accepted("a game to its end", *SMALL[:-1], 8, "--mode", "swarm", "--ticks", 20000, "--record", over)
    run(forge, over, longer, "longer")
    accepted("trim of a file that goes on after it", "trim", longer, "--out", longer, "--device", "cpu")
    stdout = accepted("ends where the game was over", "diff", over, longer)
    failures.check(", over" in stdout, f"and says so: {stdout.strip()}")
    accepted("trim before it", "trim", over, "--out", longer, "--to", 60, "--device", "cpu")
    found = json.loads(accepted("is not over", "diff", over, longer, "--json", code=DIFFER))
    failures.check(found["a"]["result"]["over"] and not found["b"]["result"]["over"], "in its final report")

    # Diff.
    stdout = accepted("diff of one run", "diff", target, folder / "same.gwr")
    failures.check(stdout.startswith("same run: ") and "130 ticks" in stdout, "says so, with its ticks")
    run(forge, target, folder / "input.gwr", "input", 70)
    stdout = accepted("diff of an input", "diff", target, folder / "input.gwr", code=DIFFER)
    failures.check("input    from tick 70 on" in stdout and "hash " not in stdout, "names its tick")
    other = folder / "other.gwr"
    accepted("another game", *SMALL, "--seed", 2, "--ticks", 130, "--record", other)
    out = folder / "diff.json"
    stdout = accepted("diff of two games", "diff", target, other, "--json", out, code=DIFFER)
    found = json.loads(out.read_text())
    failures.check(found["header"] == [{"name": "seed", "a": "1", "b": "2"}] and found["hash"]["tick"] == 1
                   and found["fields"]["tick"] == 60 and "master and tables" in found["fields"]["names"], "names seed, tick and fields")
    failures.check("header   seed: 1 | 2" in stdout and "fields   " in stdout, "for people too")
    refused("diff with no file", FILE, "diff", target, folder / "nothing.gwr", says=["nothing.gwr"])
    failures.finish()


if __name__ == "__main__":
    main()
