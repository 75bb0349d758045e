#!/usr/bin/env python3
"""Watches replays with real keys and a real mouse: pause, step, seek, speed, time bar, free camera. What is reached is
told by the line at exit, whose hash must be the recorded one.

    replay_e2e.py GPUWARS FORGE_REPLAY FOLDER      needs Xvfb, xdotool and ImageMagick's import
"""
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run
from screen import SIZE, Screen, lit

TICKS = 1500


class Watching:
    """One replay in a window."""

    def __init__(self, program, screen, replay, *options):
        self.screen = screen
        self.process = subprocess.Popen([program, "replay", replay, "--mute", *map(str, options)],
                                        env=screen.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.shown = screen.wait_for(lambda pixels: lit(pixels) > 1500)

    def press(self, *keys, then_s=0.4):
        for key in keys:
            self.screen.keys("key", key)
            time.sleep(0.05)
        time.sleep(then_s)

    def leave(self):
        """(exit code, tick, hash, stderr)"""
        self.screen.keys("key", "q")
        out, err = self.process.communicate(timeout=60)
        found = re.search(r"left at tick (\d+) of (\d+), state hash ([0-9a-f]{16})", out.decode())
        return self.process.returncode, int(found[1]), found[3], err.decode()

    def end(self):
        if self.process.poll() is None:
            self.process.kill()


def hashes_of(program, replay):
    lines = run(program, "verify", replay, "--hashes", "-")[1].splitlines()
    return dict(line.split() for line in lines if not line.startswith("#"))


def world(pixels):
    """The picture without the figures above and the bar below."""
    return pixels[SIZE[0] * 170 * 3:SIZE[0] * 670 * 3]


def main():
    program, forge, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    replay = folder / "run.gwr"
    code, _, err = run(program, "--headless", "--mode", "swarm", "--enemies", 200, "--seed", 3, "--autopilot", "expert",
                       "--ticks", TICKS, "--record", replay)
    failures.check(code == 0, f"a run is recorded {err}")
    hashes = hashes_of(program, replay)
    failures.check(len(hashes) == TICKS, "with a hash a tick")
    screen = Screen(folder)
    watching = None

    def expect_left_at(what, low, high=None):
        code, tick, state, err = watching.leave()
        good = code == 0 and err == "" and low <= tick <= (high or low) and state == hashes.get(str(tick))
        failures.check(good, f"{what}: left at tick {tick}, with the recorded hash: {state == hashes.get(str(tick))} "
                             f"(exit {code}) {err}")

    try:
        # Pause, steps, and seeks from there: every tick is known.
        watching = Watching(program, screen, replay, "--from", 300)
        failures.check(watching.shown, "the replay appears")
        watching.press("space", then_s=1)
        help_shown = screen.picture("help.png")
        watching.press("h")
        paused = screen.picture("paused.png")
        failures.check(world(help_shown) != world(paused), "a pause shows the keys, H hides them")
        time.sleep(0.7)
        failures.check(world(screen.picture()) == world(paused), "nothing moves while paused")
        watching.press("period")
        stepped = screen.picture("stepped.png")
        failures.check(world(stepped) != world(paused), "a step on shows the next tick")
        watching.press("period", "comma", then_s=1)
        failures.check(world(screen.picture()) == world(stepped), "a step on and one back show the same picture again")
        watching.press("Home", then_s=1)
        watching.press("Right", "Right", *["period"] * 7, *["comma"] * 3, then_s=2)
        expect_left_at("twice 5 s on, seven ticks on, three back", 604)

        watching = Watching(program, screen, replay)
        watching.press("space")
        watching.press("End", then_s=0.5)
        watching.press("Prior", then_s=0.2)  # a minute is more than the run has
        watching.press("shift+Right", "Left", then_s=3)
        expect_left_at("to the end, to the start, a minute on, 5 s back", TICKS - 300)

        # The bar: a click in its middle, then a drag.
        watching = Watching(program, screen, replay)
        watching.press("space")
        screen.keys("mousemove", "640", "706", "click", "1")
        time.sleep(2.5)
        screen.picture("bar.png")
        screen.keys("mousemove", "640", "706", "mousedown", "1", "mousemove", "800", "500")
        time.sleep(0.3)
        screen.keys("mousemove", "946", "300", "mouseup", "1")
        time.sleep(2.5)
        expect_left_at("a drag on the bar to three quarters", TICKS * 3 // 4 - 3, TICKS * 3 // 4 + 3)

        # Speed: a tenth and sixteen times.
        watching = Watching(program, screen, replay, "--speed", 0.1)
        slow = screen.picture()
        time.sleep(1)
        failures.check(world(screen.picture()) != world(slow), "a tenth of the speed still moves")
        watching.press("minus")  # slower there is not
        expect_left_at("a few seconds at a tenth", 2, 120)
        watching = Watching(program, screen, replay)
        watching.press("plus", "plus", "plus", "plus", then_s=3)
        screen.picture("sixteen.png")
        expect_left_at("three seconds at sixteen times", 400, TICKS)

        # The camera: away, and back to the ship.
        watching = Watching(program, screen, replay, "--from", 400)
        watching.press("space", "h", then_s=1)
        followed = world(screen.picture())
        screen.keys("keydown", "d")
        time.sleep(0.7)
        screen.keys("keyup", "d")
        time.sleep(0.5)
        panned = world(screen.picture("panned.png"))
        failures.check(panned != followed, "D looks to the right")
        screen.keys("mousemove", "640", "360", "click", "5", "click", "5", "click", "5", "click", "5")
        time.sleep(0.5)
        zoomed = world(screen.picture("zoomed.png"))
        failures.check(zoomed != panned, "the wheel zooms")
        watching.press("0", then_s=0.7)
        back = screen.picture("back.png")
        failures.check(world(back) != zoomed, "0 goes back to the ship")
        code, tick, state, _ = watching.leave()
        failures.check(code == 0 and state == hashes[str(tick)], "and the game was not changed by any of it")

        # What is wrong is reported: while watching, and at exit.
        false = folder / "false.gwr"
        failures.check(run(forge, replay, false, "hash", 700)[0] == 0, "a replay with a false hash is made")
        watching = Watching(program, screen, false)
        watching.press("End", then_s=4)
        screen.picture("differs.png")
        code, tick, _, err = watching.leave()
        failures.check(code == 4 and "differs from tick 700" in err, f"a desync is reported, wherever one seeks: {err!r}")
        code, _, err = run(program, "replay", replay, "--from", TICKS + 1, environment=screen.environment)
        failures.check(code == 2 and "past the last tick" in err and err.count("\n") == 1, f"a tick too many: {err!r}")
    finally:
        if watching:
            watching.end()
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
