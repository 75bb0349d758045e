#!/usr/bin/env python3
"""A controller that the system lists twice, so that each of its presses comes twice, some milliseconds apart: in the
settings, when a key is bound, in play and in practice each press acts once.

    twin_pads_e2e.py PLAY_WITH_PAD REPLAY_INPUTS FOLDER      pictures stay in FOLDER
"""
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, saved_settings
from screen import Screen, below_header, lit

APART_MS = (0, 1, 4, 8, 16, 30)  # frames take 16 ms: within one, and in two
SPAWN, CLEAR = 4, 8


class Game:
    def __init__(self, player, screen, failures, *arguments):
        self.failures, self.presses = failures, 0
        self.process = subprocess.Popen([player, *map(str, arguments), "--seed", "7", "--mute"], env=screen.environment,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 2000), "the title appears")
        self.command("attach")
        self.command("twin attach")
        time.sleep(0.5)

    def command(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().strip()
        while answer.startswith("score") or answer.endswith("plays the same game."):  # what the game itself says
            answer = self.process.stdout.readline().strip()
        if answer != "done":
            self.failures.check(False, f"'{line}': {answer!r}")

    def press(self, *buttons, wait=0.15):
        """Both copies, by another distance each time."""
        for button in buttons:
            apart = APART_MS[self.presses % len(APART_MS)]
            self.presses += 1
            self.command(f"both {apart} button {button} 1")
            time.sleep(0.1)
            self.command(f"both {apart} button {button} 0")
            time.sleep(wait)

    def leave(self):
        self.press("start", wait=0.6)
        self.press("b", wait=0.8)
        self.command("both 8 button b 1")  # and it is let go unseen
        _, stderr = self.process.communicate(timeout=30)
        self.failures.check(self.process.returncode == 0 and stderr == "",
                            f"the game ends: {self.process.returncode}, {stderr!r}")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()


def check_settings(game, screen, settings, failures):
    game.press("y", wait=0.5)
    game.press(*["dpdown"] * 9)
    game.press("dpright", "dpright")
    screen.picture("settings.png")
    game.press("leftshoulder")  # the other column
    game.press("dpdown", "dpdown", "dpdown")
    game.press("a", wait=0.3)  # move right waits for a button ...
    game.press("b", wait=0.5)  # ... which leads back at any other time
    screen.picture("bound.png")
    failures.check(not settings.is_file(), "the button that is bound does nothing else")
    game.press("dpleft", wait=0.3)  # its defaults again
    game.press("b", wait=0.5)
    failures.check(settings.is_file(), "B leads back and saves")
    saved = saved_settings(settings)
    failures.check(abs(saved["pad"]["move_dead_zone"] - 0.3) < 1e-6, f"nine rows down, two steps right: {saved['pad']}")
    failures.check(saved["pad_buttons"]["move_right"] == ["dpright"], f"{saved['pad_buttons']}")


def check_pauses(game, screen, failures):
    game.press("a", wait=1)
    for turn in range(len(APART_MS)):
        game.press("start", wait=0.6)
        paused = below_header(screen.picture(f"pause_{turn}.png"))
        time.sleep(0.4)
        failures.check(below_header(screen.picture()) == paused, f"one press of Start pauses ({turn})")
        game.press("start", wait=0.6)
        failures.check(below_header(screen.picture()) != paused, f"one more goes on ({turn})")


def main():
    player, inputs_of, folder = *sys.argv[1:3], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    settings, recording, practice = folder / "settings.toml", folder / "twin.gwr", folder / "practice.gwr"
    screen = Screen(folder)
    game = None
    try:
        game = Game(player, screen, failures, "--record", recording, "--settings", settings)
        check_settings(game, screen, settings, failures)
        check_pauses(game, screen, failures)
        game.leave()
        failures.check(recording.is_file(), "the run is recorded")

        game = Game(player, screen, failures, "--mode", "practice", "--record", practice, "--settings",
                    folder / "none.toml")
        game.press("a", wait=1)
        game.press(*["y"] * 6, wait=0.3)
        screen.picture("practice.png")
        game.press(*["back"] * 3, wait=0.3)
        game.leave()
        ticks = [tuple(map(int, line.split())) for line in run(inputs_of, practice)[1].splitlines()]
        asked, cleared = (sum(1 for tick in ticks if tick[3] & bit) for bit in (SPAWN, CLEAR))
        failures.check((asked, cleared) == (6, 3), f"six presses of Y and three of Back: {asked}, {cleared}")
    finally:
        if game:
            game.kill()
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
