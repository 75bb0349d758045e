#!/usr/bin/env python3
"""Other keyboard layouts: the screens name the keys as they are printed, keys act by place, and the file keeps places.

    layout_e2e.py GPUWARS LAYOUT_LABELS FOLDER      needs setxkbmap too; pictures stay in FOLDER
"""
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, saved_settings
from screen import SIZE, Screen, below_header, lit

US = {"move": "WASD", "flush": "SPACE", "pause": "ESC", "confirm": "ENTER", "retry": "R", "quit": "Q", "settings": "O",
      "fullscreen": "F", "mute": "M", "more": "=", "fewer": "-", "step_on": ".", "step_back": ",", "faster": "+",
      "slower": "-", "camera": "C", "help": "H", "ship": "0", "pan": "WASD"}
FRENCH = US | {"move": "ZQSD", "quit": "A", "mute": ",", "fewer": ")", "step_on": ":", "step_back": ";", "slower": ")",
               "pan": "ZQSD"}
DVORAK = US | {"move": ",AOE", "retry": "P", "quit": "'", "settings": "R", "fullscreen": "U", "more": "]", "fewer": "[",
               "step_on": "V", "step_back": "W", "faster": "]", "camera": "J", "help": "D", "pan": ",AOE"}


def check_labels(screen, tool, failures):
    asked = subprocess.Popen([tool], env=screen.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def labels():
        asked.stdin.write("now\n")
        asked.stdin.flush()
        return dict(word.split("=", 1) for word in asked.stdout.readline().strip("\n").split("\t") if word)

    def expect(what, wanted):
        told = labels()
        wrong = {name: told.get(name) for name in wanted if told.get(name) != wanted[name]}
        failures.check(not wrong, f"labels of {what} {wrong}")

    expect("us", US)
    for name, wanted in (("fr", FRENCH), ("us -variant dvorak", DVORAK), ("us", US)):
        screen.layout(*name.split())
        expect(f"{name}, switched while the window is open", wanted)
    screen.layout("de")
    # Its "=" is a dead accent, for which SDL 2 has no name; SDL 3 behind sdl2-compat (2.32.50 and newer) tells the US one.
    sdl = [int(word) for word in labels()["sdl"].split(".")]
    expect("de", {"move": "WASD", "more": "=" if sdl >= [2, 32, 50] else "US =", "fewer": "US -", "faster": "+", "slower": "-"})
    screen.layout("ru")
    russian = labels()
    failures.check({name: russian[name] for name in ("move", "quit", "camera")} == {"move": "WASD", "quit": "Q", "camera": "C"},
                   f"letters of another script go by the Latin ones {russian}")
    failures.check(all(" " <= c <= "~" for label in russian.values() for c in label), "and the typeface has them all")
    screen.layout("us")
    asked.stdin.close()
    asked.wait()


class Game:
    def __init__(self, program, screen, failures, *arguments):
        self.screen, self.failures = screen, failures
        self.process = subprocess.Popen([program, *map(str, arguments), "--mute"], env=screen.environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 1500), f"a picture appears: {arguments[0]}")
        time.sleep(0.7)

    def press(self, *keys, wait=0.5):
        for key in keys:
            self.screen.keys("key", key)
            time.sleep(wait)

    def wait(self):
        _, stderr = self.process.communicate(timeout=60)
        self.failures.check(self.process.returncode == 0 and stderr == "",
                            f"the keys lead out: {self.process.returncode}, {stderr!r}")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()


def lasting(screen, top, bottom, pictures=5):
    """What stays bright for two seconds in some rows of the picture: the text, but nothing that moves behind it."""
    least = None
    for _ in range(pictures):
        rows = screen.picture()[SIZE[0] * top * 3:SIZE[0] * bottom * 3]
        least = rows if least is None else bytes(map(min, least, rows))
        time.sleep(0.4)
    return bytes(value > 110 for value in least)


def differ(one, other):
    return sum(a != b for a, b in zip(one, other))


def check_moving_screen(screen, failures, what, top, bottom):
    """us, fr, us: the text changes, and changes back."""
    screen.layout("us")
    before = lasting(screen, top, bottom)
    screen.layout("fr")
    french = lasting(screen, top, bottom)
    screen.picture(f"{what}_fr.png")
    screen.layout("us")
    after = lasting(screen, top, bottom)
    changed, noise = differ(before, french), differ(before, after)
    failures.check(changed > 40 and changed > 4 * noise, f"{what}: {changed} bytes of text change, {noise} do anyway")


def still(pixels):
    """Without the frame rate above and the bar below, which grows while a replay is looked through."""
    return below_header(pixels)[:-SIZE[0] * 3 * 50]


def check_still_screen(screen, failures, what):
    screen.layout("us")
    before = still(screen.picture(f"{what}_us.png"))
    screen.layout("fr")
    french = still(screen.picture(f"{what}_fr.png"))
    screen.layout("us")
    failures.check(before != french, f"{what}: another layout, other names")
    failures.check(still(screen.picture()) == before, f"{what}: and back")


def play(program, screen, folder, failures):
    settings = folder / "settings.toml"
    game = Game(program, screen, failures, "--seed", 7, "--settings", settings)
    try:
        check_moving_screen(screen, failures, "title", 632, 652)
        game.press("o")
        check_moving_screen(screen, failures, "settings", 150, 640)
        screen.layout("fr")
        game.press("Tab", "Return")
        screen.press_place("Q")  # the key with an A on it
        time.sleep(0.5)
        screen.picture("settings_bound_fr.png")
        game.press("Escape")
        saved = saved_settings(settings)["keys"]
        failures.check(saved["move_up"] == ["Q"], f"the file keeps the place: {saved['move_up']}")
        screen.layout("us")
        game.press("Return", "Escape")
        check_still_screen(screen, failures, "pause")
        screen.layout("fr")
        game.press("q")  # what is called so: the place A, which does nothing here
        failures.check(game.process.poll() is None, "the key with a Q on it is not the one that leads to the title")
        game.press("a", "Escape")
        game.wait()
    finally:
        game.kill()
        screen.layout("us")


def watch(program, screen, replay, failures):
    game = Game(program, screen, failures, "replay", replay, "--from", 60)
    try:
        game.press("space", wait=1)
        check_still_screen(screen, failures, "viewer")
        screen.layout("fr")
        game.press("Home", *["colon"] * 5, *["semicolon"] * 2)  # the places of . and ,
        game.press("h", "h", "a")
        out, stderr = game.process.communicate(timeout=60)
        failures.check(game.process.returncode == 0 and stderr == "", f"A leaves: {game.process.returncode} {stderr!r}")
        failures.check("left at tick 3 of 1200" in out, f"five ticks on and two back {out!r}")
    finally:
        game.kill()
        screen.layout("us")


def main():
    program, tool, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    screen = Screen(folder)
    try:
        check_labels(screen, tool, failures)
        play(program, screen, folder, failures)
        replay = folder / "run.gwr"
        failures.check(run(program, "--headless", "--autopilot", "expert", "--ticks", 1200, "--record", replay)[0] == 0,
                       "a run is recorded")
        watch(program, screen, replay, failures)
    finally:
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
