#!/usr/bin/env python3
"""Plays with real keys in a real window: title, play, move, shoot, pause, resume, leave; then checks the recording.

    play_e2e.py GPUWARS FOLDER      needs Xvfb, xdotool and ImageMagick's import; pictures stay in FOLDER
"""
import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run
from screen import Screen, below_header, lit


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    recording = folder / "played.gwr"
    screen = Screen(folder)
    game = subprocess.Popen([program, "--record", recording, "--seed", "7", "--mute"], env=screen.environment,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 2000), "the title appears")
        time.sleep(1)
        title = screen.picture("title.png")

        screen.keys("key", "Return")
        time.sleep(1)
        playing = screen.picture("play.png")
        failures.check(playing != title, "Enter starts at once")
        screen.keys("keydown", "d", "keydown", "Up")
        time.sleep(1.5)
        screen.keys("keyup", "Up", "keydown", "w", "keydown", "Left")
        time.sleep(1)
        screen.picture("shooting.png")
        screen.keys("key", "space")
        time.sleep(0.3)
        screen.keys("keyup", "d", "keyup", "w", "keyup", "Left")

        screen.keys("key", "Escape")
        time.sleep(1)
        paused = screen.picture("pause.png")
        time.sleep(1)
        failures.check(below_header(screen.picture()) == below_header(paused), "nothing moves while paused")
        screen.keys("key", "Escape")
        time.sleep(1)
        resumed = screen.picture("resumed.png")
        time.sleep(0.5)
        failures.check(resumed != paused and screen.picture() != resumed, "Escape resumes")

        screen.keys("key", "Escape")
        time.sleep(0.7)
        screen.keys("key", "q")
        time.sleep(1)
        failures.check(game.poll() is None, "Q in the pause leads to the title")
        failures.check(recording.is_file(), "leaving the run writes the recording")
        screen.keys("key", "Escape")
        code = game.wait(timeout=30)
        stdout, stderr = (stream.decode() for stream in (game.stdout.read(), game.stderr.read()))
        failures.check(code == 0 and stderr == "", f"Escape in the title leaves: exit {code}, {stderr!r}")
        failures.check("recorded to" in stdout, "it says where the recording is")

        code, out, _ = run(program, "verify", recording, "--json", "-")
        failures.check(code == 0, "the recording verifies")
        replay = json.loads(out)["replays"][0]
        print({key: replay[key] for key in ("ticks", "travelled_m", "shots", "flushes", "score")})
        failures.check(replay["ticks"] > 60, "a second or more was played")
        failures.check(replay["travelled_m"] > 5, "the ship moved")
        failures.check(replay["shots"] >= 5, "shots were fired")
        failures.check(replay["flushes"] == 1, "one press of space is one flush")

        # A run that is killed from outside keeps its recording too.
        killed = folder / "killed.gwr"
        game = subprocess.Popen([program, "--autopilot", "novice", "--seed", "3", "--record", killed, "--mute"],
                                env=screen.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        screen.wait_for(lambda pixels: lit(pixels) > 500)
        time.sleep(2)
        game.send_signal(signal.SIGTERM)
        failures.check(game.wait(timeout=30) == 143 and run(program, "verify", killed)[0] == 0,
                       "a run ended by SIGTERM leaves a valid recording")
    finally:
        if game.poll() is None:
            game.kill()
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
