#!/usr/bin/env python3
"""Whatever a user gets wrong ends in one sentence on stderr and the documented exit code.

    bad_input_e2e.py GPUWARS FORGE_REPLAY ASSETS FOLDER
"""
import json
import shutil
import sys
from pathlib import Path

from program import Failures, run, without_display

FINE, FAILED, USAGE, FILE, DESYNC = range(5)


def main():
    program, forge, assets, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()

    def refused(name, code, *arguments, says=(), **variables):
        got, _, stderr = run(program, *arguments, environment={**without_display(), **variables})
        lines = stderr.splitlines()
        good = got == code and len(lines) == 1 and len(lines[0]) > 20 and all(word in stderr for word in says)
        failures.check(good, f"{name}: exit {code}, one sentence" + ("" if good else f"; got {got}: {stderr!r}"))

    good = folder / "good.gwr"
    code, stdout, stderr = run(program, "--headless", "--autopilot", "expert", "--ticks", 300, "--record", good)
    failures.check(code == FINE and stderr == "" and good.is_file(), "a headless run is recorded without a complaint")
    failures.check("state hash" in stdout and "score" in stdout, "it says what it was like")
    code, stdout, stderr = run(program, "verify", good)
    failures.check(code == FINE and stderr == "" and "300 of 300" in stdout, "it verifies, every tick")

    refused("no display", FAILED, says=["--headless"])
    refused("a display that does not answer", FAILED, says=["--headless"], DISPLAY=":987")
    refused("no display for a replay", FAILED, "replay", good, says=["--headless"])

    refused("unknown option", USAGE, "--fly", says=["--fly"])
    refused("unknown verb", USAGE, "dance", says=["dance"])
    refused("a number that is none", USAGE, "--enemies", "many", says=["--enemies"])
    refused("headless without an end", USAGE, "--headless", says=["--ticks"])

    short = ["--headless", "--ticks", 2]
    nowhere = folder / "nowhere"
    refused("unwritable recording", FILE, *short, "--record", nowhere / "a.gwr", says=["nowhere"])
    refused("a folder as recording", FILE, *short, "--record", folder)
    refused("unwritable hashes", FILE, *short, "--hashes", nowhere / "h", says=["nowhere"])
    refused("unwritable screenshot", FILE, *short, "--screenshot", nowhere / "s.png", says=["nowhere"])
    refused("unwritable results", FILE, "verify", good, "--json", nowhere / "j", says=["nowhere"])

    data = good.read_bytes()
    for name, damaged in {"empty": b"", "cut": data[: len(data) // 2], "text": b"hello\n" * 100,
                          "flipped": data[:200] + bytes([data[200] ^ 4]) + data[201:],
                          "longer": data + b"x"}.items():
        path = folder / f"{name}.gwr"
        path.write_bytes(damaged)
        refused(f"{name} replay", FILE, "verify", path, says=[path.name])
    refused("missing replay", FILE, "verify", folder / "none.gwr", says=["none.gwr"])
    refused("a folder as replay", FILE, "verify", folder)

    # The checker itself: whole files that are wrong in one place.
    for what, tick in (("hash", 1), ("hash", 150), ("hash", 300), ("input", 120), ("score", None)):
        path, result = folder / f"{what}{tick or ''}.gwr", folder / "result.json"
        forged, _, _ = run(forge, good, path, what, *([tick] if tick else []))
        failures.check(forged == 0, f"forged {path.name}")
        refused(f"desync {what} {tick or ''}", DESYNC, "verify", path, "--json", result, says=[path.name])
        outcome = json.loads(result.read_text())["replays"][0]
        first = outcome.get("firstDifference", {}).get("tick")
        exact = first == tick if what != "input" else first is not None and 120 <= first <= 125
        failures.check(exact, f"desync {what} {tick or ''}: first difference at {first}")
        failures.check(outcome["ticksCompared"] == 300, "and every tick was compared all the same")
    code, _, stderr = run(program, "verify", folder / "cut.gwr", good, folder / "hash150.gwr", "-j", 2)
    failures.check(code == DESYNC and len(stderr.splitlines()) == 2, "of several files each bad one is named")

    def with_assets(name, change, *arguments, says):
        copy = folder / "assets"
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(assets, copy)
        change(copy)
        refused(name, FILE, *arguments, "--assets", copy, says=says)

    picture = [*short, "--screenshot", folder / "picture.png"]
    with_assets("missing table", lambda a: (a / "waves.toml").unlink(), *short, says=["waves.toml"])
    with_assets("damaged table", lambda a: (a / "enemies.toml").write_text("what = ["), *short, says=["enemies.toml"])
    with_assets("missing shader", lambda a: (a / "shaders/text.frag").unlink(), *picture, says=["text.frag"])
    with_assets("missing font", lambda a: (a / "fonts/neon.json").unlink(), *picture, says=["neon.json"])
    with_assets("damaged font", lambda a: (a / "fonts/neon.png").write_bytes(b"no"), *picture, says=["neon.png"])
    with_assets("older assets", lambda a: (a / "version").write_text("0.0.9\n"), *short,
                says=[str(folder / "assets"), "0.0.9", "reinstall", "--assets"])
    with_assets("assets of no version", lambda a: (a / "version").unlink(), *short, says=["version", "reinstall"])
    with_assets("a version that is none", lambda a: (a / "version").write_bytes(b"\x1b[0m" * 99), *short,
                says=["does not say of which version"])
    with_assets("older assets for a picture", lambda a: (a / "version").write_text("9.9.9\n"), "render", good, "--out",
                folder / "frame.png", says=["9.9.9"])
    refused("no assets at all", FILE, *short, "--assets", nowhere, says=["nowhere", "reinstall", "--assets"])
    refused("a file for assets", FILE, *short, "--assets", good, says=[good.name, "no folder of assets"])

    # A program that was moved away from its assets.
    lonely = folder / "lonely/bin/gpuwars"
    lonely.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(program, lonely)
    shutil.rmtree(lonely.parent / "assets", ignore_errors=True)
    shutil.copytree(assets, lonely.parent / "assets")
    (lonely.parent / "assets/version").write_text("0.0.1\n")
    code, _, stderr = run(lonely, *short)
    failures.check(code == FILE and str(lonely.parent / "assets") in stderr and "0.0.1" in stderr,
                   f"the assets beside the program are taken, and looked at: {stderr.strip()}")

    code, stdout, _ = run(program, "devices", "--json", "-")
    devices = json.loads(stdout)
    failures.check(code == FINE and devices["devices"][-1]["kind"] == "cpu", "devices lists the cpu")
    if devices["auto"] == "cpu":
        refused("a device that is not here", FAILED, *short, "--device", "cuda", says=["--device cpu"])
    failures.finish()


if __name__ == "__main__":
    main()
