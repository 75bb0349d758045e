#!/usr/bin/env python3
"""Every mode, chosen on the title and played for a while with real keys; then its recording is checked.

    modes_e2e.py GPUWARS REPLAY_INPUTS FOLDER      pictures stay in FOLDER
"""
import json
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run
from screen import Screen, below_header, lit

# From arcade, which the title begins with, to each of them: arrows, and the keys that move the ship.
CHOICES = {"arcade": ("Right", "Left"), "deadline": ("Right",), "swarm": ("d", "d"), "practice": ("a",)}
SPAWN, CLEAR = 4, 8
HEXAGON, FIVE_HUNDRED = 2, 8  # the third type; an index into kPracticeCounts
ROUNDS = 4  # of about five seconds


class Game:
    def __init__(self, program, screen, recording, failures, *options):
        self.screen, self.failures = screen, failures
        self.process = subprocess.Popen([program, "--record", recording, "--seed", "7", "--mute", *options],
                                        env=screen.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 2000), "the title appears")
        time.sleep(0.5)

    def press(self, *keys, wait=0.3):
        for key in keys:
            self.screen.keys("key", key)
            time.sleep(wait)

    def fly_and_fire(self):
        for held in (("d", "Up"), ("w", "Left"), ("a", "Down"), ("s", "Right")):
            self.screen.keys(*[word for key in held for word in ("keydown", key)])
            time.sleep(1.2)
            self.screen.keys(*[word for key in held for word in ("keyup", key)])

    def leave(self):
        """By keys: from play, and from the result if there is one already."""
        self.press("Escape", "q", "Escape", wait=0.8)
        _, stderr = self.process.communicate(timeout=60)
        self.failures.check(self.process.returncode == 0 and stderr == "",
                            f"the keys lead out: {self.process.returncode}, {stderr!r}")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()


def practise(game, screen, failures):
    """Asks for many, looks at one, and clears them."""
    game.press("3", "equal", "equal", "equal", "equal", "equal", "n", wait=0.2)
    time.sleep(1.5)
    screen.picture("practice_asked.png")
    game.press("t")
    game.press("n", wait=1)
    screen.picture("practice_slow.png")
    game.press("t")
    game.press("Escape", wait=1)
    before = screen.picture("practice_pause.png")
    for x, y in ((640, 420), (500, 400), (760, 300), (420, 500), (860, 520)):
        screen.keys("mousemove", str(x), str(y))
        time.sleep(0.3)
        screen.keys("click", "1")
        time.sleep(0.7)
        looked = screen.picture("practice_inspect.png")
        if below_header(looked) != below_header(before):
            break
    time.sleep(0.5)
    failures.check(below_header(looked) != below_header(before), "a click in the pause shows an enemy")
    failures.check(below_header(screen.picture()) == below_header(looked), "and nothing moves")
    game.press("Escape", wait=0.8)
    game.press("c", wait=2)
    screen.picture("practice_cleared.png")


def check_practice(failures, replay, inputs):
    before, asked, cleared = 0, [], 0
    for line in inputs.splitlines():
        buttons = int(line.split()[3])
        pressed = buttons & ~before
        if pressed & SPAWN:
            asked.append((buttons >> 4 & 7, buttons >> 8 & 15))
        cleared += pressed & CLEAR != 0
        before = buttons
    failures.check(asked == [(HEXAGON, FIVE_HUNDRED)] * 2, f"what was asked for stands in the recording: {asked}")
    failures.check(cleared == 1, "and that all was cleared")
    failures.check(replay["peakEnemies"] >= 500, f"they came: {replay['peakEnemies']}")
    failures.check(replay["enemiesLeft"] == 0, f"and went: {replay['enemiesLeft']} left")


def main():
    program, inputs_of, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    screen = Screen(folder)
    game = None
    try:
        for mode, choice in CHOICES.items():
            print(mode)
            recording = folder / f"{mode}.gwr"
            game = Game(program, screen, recording, failures)
            game.press(*choice)
            screen.picture(f"{mode}_title.png")
            game.press("Return", wait=1)
            for i in range(ROUNDS):
                game.fly_and_fire()
                screen.picture(f"{mode}_{i}.png")
            if mode == "practice":
                practise(game, screen, failures)
            game.leave()

            code, out, err = run(program, "verify", recording, "--json", "-")
            if not failures.check(code == 0, f"the recording verifies: {code}, {err!r}"):
                continue
            replay = json.loads(out)["replays"][0]
            print({key: replay[key] for key in ("ticks", "travelled_m", "shots", "kills", "contacts", "ending")})
            failures.check(replay["mode"] == mode, f"its mode is {replay['mode']}")
            failures.check(replay["travelled_m"] > 5 and replay["shots"] >= 5, "the ship moved and fired")
            if mode == "practice":
                failures.check(replay["ending"] == "none", "practice has no end")
                check_practice(failures, replay, run(inputs_of, recording)[1])
            elif mode == "swarm":
                failures.check(replay["peakEnemies"] > 8000, "all of them came at once")

        # What --mode names is chosen already.
        recording = folder / "named.gwr"
        game = Game(program, screen, recording, failures, "--mode", "swarm", "--enemies", "100")
        game.press("Return", wait=2)
        game.leave()
        replay = json.loads(run(program, "verify", recording, "--json", "-")[1])["replays"][0]
        failures.check(replay["mode"] == "swarm", "--mode chooses on the title")
    finally:
        if game:
            game.kill()
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
