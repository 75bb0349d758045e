#!/usr/bin/env python3
"""Other keys in the real window: from the settings file, and from the settings screen.

    settings_e2e.py GPUWARS REPLAY_INPUTS FOLDER      pictures stay in FOLDER
"""
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, saved_settings
from screen import Screen, lit

FULL, FIRE, FLUSH = 32767, 1, 2

OTHER_KEYS = """
[keys]
move_up = ["I", "Keypad 8"]
fire = ["J"]
flush = ["Left Ctrl", "Nonsense"]
move_left = 12
[sound]
music = nan
"""


def main():
    program, inputs_of, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    settings = folder / "settings.toml"
    settings.write_text(OTHER_KEYS)
    screen = Screen(folder)

    def start(recording):
        game = subprocess.Popen([program, "--record", recording, "--seed", "7", "--mute", "--settings", settings],
                                env=screen.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 2000), "the title appears")
        time.sleep(0.5)
        return game

    def leave(game):
        for key in ("Escape", "q", "Escape"):
            screen.keys("key", key)
            time.sleep(0.7)
        _, stderr = game.communicate(timeout=30)
        failures.check(game.returncode == 0, f"the game ends: {game.returncode}")
        return stderr

    def hold(*keys):
        for key in keys:
            screen.keys("keydown", key)
        time.sleep(0.7)
        for key in keys:
            screen.keys("keyup", key)
        time.sleep(0.2)

    def ticks(recording):
        return [tuple(map(int, line.split())) for line in run(inputs_of, recording)[1].splitlines()]

    game = None
    try:
        # From the file: the new keys act, the old ones do not, and what is wrong is named.
        game = start(folder / "file.gwr")
        screen.keys("key", "Return")
        time.sleep(0.5)
        hold("w", "space")
        hold("i", "j")
        hold("KP_8", "Control_L")
        hold("a")
        stderr = leave(game)
        sentences = stderr.splitlines()
        failures.check(len(sentences) == 3, f"one sentence for each wrong value: {sentences}")
        for key in ("keys.flush", "keys.move_left", "sound.music"):
            failures.check(any(key in sentence and "line" in sentence for sentence in sentences), f"{key} is named")
        played = ticks(folder / "file.gwr")
        kinds = {(tick[0], tick[1], tick[3]) for tick in played}
        failures.check(kinds >= {(0, FULL, FIRE), (0, FULL, FLUSH), (-FULL, 0, 0)}, f"what the keys did: {kinds}")
        first = next(tick for tick in played if tick[0] or tick[1] or tick[3])
        failures.check(first[:2] == (0, FULL) and not first[3] & FLUSH, "W and space did nothing before")
        failures.check(settings.read_text() == OTHER_KEYS, "playing changes nothing in the file")

        # On the screen: the third action of the second column is to the left; it gets E.
        game = start(folder / "screen.gwr")
        screen.keys("key", "o")
        time.sleep(0.5)
        screen.keys("key", "--delay", "100", "Tab", "Down", "Down", "Return")
        time.sleep(0.5)
        screen.picture("waiting.png")
        screen.keys("key", "e")
        time.sleep(0.5)
        screen.picture("rebound.png")
        screen.keys("key", "Escape")
        time.sleep(0.5)
        failures.check((folder / "settings.toml.bad").read_text() == OTHER_KEYS, "the damaged file is kept")
        saved = saved_settings(settings)["keys"]
        failures.check(saved["move_left"] == ["E"] and saved["move_up"] == ["I", "Keypad 8"], f"what is saved: {saved}")
        screen.keys("key", "Return")
        time.sleep(0.5)
        hold("a")
        hold("e")
        stderr = leave(game)
        failures.check("settings.toml.bad" in stderr, "it says where the damaged file is")
        moves = {tick[:2] for tick in ticks(folder / "screen.gwr")}
        failures.check(moves == {(0, 0), (-FULL, 0)}, f"E moves left: {moves}")

        # An editor at work meanwhile: what is changed on the screen is changed in its text, and nothing else.
        settings.write_text("[sound]\nmusic = 0.50\n")
        settings.chmod(0o600)
        game = start(folder / "meanwhile.gwr")
        edited = '# my own\n[sound]\nmusic = 0.50 # as at home\n[keys]\nflush = ["Left Shift"]\n'
        settings.write_text(edited)
        screen.keys("key", "o")
        time.sleep(0.5)
        screen.keys("key", "--delay", "100", "Down", "Right")
        time.sleep(0.5)
        screen.keys("key", "Escape")
        time.sleep(0.5)
        failures.check(settings.read_text() == edited.replace("0.50", "0.55"), f"both are there: {settings.read_text()!r}")
        failures.check(settings.stat().st_mode & 0o777 == 0o600, "and no other user may read it now either")
        failures.check(leave(game) == "", "nothing has to be reported")

        # A file that is no TOML costs a sentence, not the game.
        settings.write_text("[keys\nmove_up = \n")
        game = start(folder / "broken.gwr")
        screen.keys("key", "Return")
        time.sleep(0.5)
        hold("w")
        stderr = leave(game)
        failures.check(len(stderr.splitlines()) == 1 and "line 1" in stderr, f"one sentence: {stderr!r}")
        failures.check((0, FULL) in {tick[:2] for tick in ticks(folder / "broken.gwr")}, "and W moves up")
        failures.check(settings.read_text() == "[keys\nmove_up = \n", "the file stays as it is")
    finally:
        if game and game.poll() is None:
            game.kill()
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
