#!/usr/bin/env python3
"""Plays the real game with a controller that is connected, used, pulled out and connected again.

    pad_e2e.py GPUWARS PLAY_WITH_PAD REPLAY_INPUTS FOLDER      pictures stay in FOLDER
"""
import json
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, saved_settings
from screen import Screen, below_header, lit

FULL, FIRE = 32767, 1


def main():
    program, player, inputs_of, folder = *sys.argv[1:4], Path(sys.argv[4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    recording, settings = folder / "pad.gwr", folder / "settings.toml"
    screen = Screen(folder)
    game = subprocess.Popen([player, "--record", recording, "--seed", "7", "--mute", "--settings", settings],
                            env=screen.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)

    def pad(command):
        game.stdin.write(command + "\n")
        game.stdin.flush()
        answer = game.stdout.readline().strip()
        while answer.startswith("score") or answer.endswith("plays the same game."):  # what the game itself says
            answer = game.stdout.readline().strip()
        if answer != "done":
            failures.check(False, f"'{command}': {answer!r}")

    def press(button):
        pad(f"button {button} 1")
        time.sleep(0.2)
        pad(f"button {button} 0")
        time.sleep(0.2)

    try:
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 2000), "the title appears")
        pad("attach")
        time.sleep(0.5)

        # The settings, by pad alone: flashes off, another dead zone.
        press("y")
        time.sleep(0.5)
        for _ in range(4):
            press("dpdown")
        pad("button dpleft 1")  # held it repeats
        time.sleep(3.5)
        pad("button dpleft 0")
        for _ in range(5):
            press("dpdown")
        press("dpright")
        screen.picture("settings.png")
        press("b")
        time.sleep(0.5)
        failures.check(settings.is_file(), "leaving the settings saves them")
        saved = saved_settings(settings)
        failures.check(saved["effects"]["flash"] == 0, f"a held cross went all the way down: {saved['effects']}")
        failures.check(saved["pad"]["move_dead_zone"] == 0.25, f"the dead zone is one step larger: {saved['pad']}")

        press("a")
        time.sleep(1)
        pad("axis leftx 32767")
        pad("axis righty -32768")
        time.sleep(1.5)
        press("leftshoulder")
        playing = screen.picture("playing.png")

        pad("detach")
        time.sleep(1)
        paused = screen.picture("gone.png")
        time.sleep(2)
        failures.check(below_header(paused) != below_header(playing), "the pause is shown")
        failures.check(below_header(screen.picture()) == below_header(paused), "nothing moves while the pad is gone")

        pad("attach")
        time.sleep(0.3)
        press("start")
        time.sleep(1)
        failures.check(below_header(screen.picture("resumed.png")) != below_header(paused), "Start goes on")
        press("start")
        time.sleep(0.5)
        press("b")
        time.sleep(1)
        failures.check(game.poll() is None and recording.is_file(), "B in the pause leads to the title")
        pad("button b 1")  # and it is let go unseen
        _, stderr = game.communicate(timeout=30)
        failures.check(game.returncode == 0 and stderr == "", f"B in the title leaves: {game.returncode}, {stderr!r}")

        code, out, _ = run(program, "verify", recording, "--json", "-")
        replay = json.loads(out)["replays"][0]
        print({key: replay[key] for key in ("ticks", "travelled_m", "shots", "flushes", "score")})
        failures.check(code == 0, "the recording verifies")
        failures.check(replay["travelled_m"] > 5 and replay["shots"] >= 5, "the ship moved and fired")
        failures.check(replay["flushes"] == 1, "one press of a shoulder is one flush")

        code, out, _ = run(inputs_of, recording)
        ticks = [tuple(map(int, line.split())) for line in out.splitlines()]
        held = [i for i, tick in enumerate(ticks) if tick[0] == FULL and tick[1] == 0]
        fired = [i for i, tick in enumerate(ticks) if tick[3] & FIRE and tick[2] == 16384]
        failures.check(len(held) > 60 and len(fired) > 60, "the stick at its end is a full move; the other fires upwards")
        last = max(held + fired)
        after = ticks[last + 1:]
        failures.check(all(tick == (0, 0, 16384, 0) for tick in after), "pulled out it leaves neutral input")
        # Three seconds passed before Start was pressed; at 60 ticks a second they would have been 180 ticks more.
        failures.check(0 < len(after) < 180, f"no tick passed while it was gone: {len(after)} after it")
    finally:
        if game.poll() is None:
            game.kill()
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
