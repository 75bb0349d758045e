#!/usr/bin/env python3
"""The overlay in a real window, by keys and mouse: F3, F4, F5 in play, in a pause and in a replay. The game must not
notice: recordings verify, and a replay ends with the recorded hash.

    overlay_e2e.py GPUWARS FOLDER      needs Xvfb, xdotool and ImageMagick's import; pictures stay in FOLDER
"""
import json
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run
from screen import SIZE, Screen, lit

PANEL = (8, 112, 285, 500)   # left, top, right, bottom: what it covers at least of a picture 1280 wide
NOTICE = (300, 622, 980, 652)
BESIDE = (340, 130, 1270, 600)
BROAD_PHASES = ("grid", "grid-hashed", "brute", "ngrid")


def part(pixels, box):
    """Rows of the picture within a box."""
    left, top, right, bottom = box
    return [pixels[(y * SIZE[0] + left) * 3:(y * SIZE[0] + right) * 3] for y in range(top, bottom)]


def changed(before, after, box):
    """The share of bytes that differ within a box."""
    pairs = list(zip(b"".join(part(before, box)), b"".join(part(after, box))))
    return sum(a != b for a, b in pairs) / len(pairs)


class Window:
    def __init__(self, program, screen, failures, *arguments):
        self.screen, self.failures = screen, failures
        self.process = subprocess.Popen([program, *map(str, arguments), "--mute"], env=screen.environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 1500), f"a picture appears: {arguments[0]}")
        time.sleep(1.5)

    def press(self, *keys, then_s=0.5):
        for key in keys:
            self.screen.keys("key", key)
            time.sleep(then_s)

    def leave(self, *keys):
        self.press(*keys, then_s=0.8)
        out, err = self.process.communicate(timeout=120)
        self.failures.check(self.process.returncode == 0 and err == "",
                            f"the keys lead out: {self.process.returncode}, {err!r}")
        return out

    def end(self):
        if self.process.poll() is None:
            self.process.kill()


def verified(program, recording, failures, least_ticks):
    code, out, err = run(program, "verify", recording, "--json", "-")
    failures.check(code == 0, f"{recording.name} verifies {err}")
    replay = json.loads(out)["replays"][0]
    failures.check(replay["ticks"] >= least_ticks, f"{replay['ticks']} ticks were played, {least_ticks} or more")
    return replay


def look_in_a_pause(window, screen, failures):
    """Nothing moves there, so every change of the picture is the overlay's."""
    window.press("Escape", then_s=1.5)
    before = screen.picture("pause.png")
    window.press("F4")
    told = screen.picture("pause_f4_notice.png")
    time.sleep(2.5)
    coloured = screen.picture("pause_f4.png")
    failures.check(changed(told, coloured, NOTICE) > 0.02, "F4 says for a moment what it did")
    failures.check(changed(before, coloured, BESIDE) > 0.005, "F4 colours the world, in a pause too")
    window.press("F4", then_s=3)
    failures.check(changed(before, screen.picture(), BESIDE) == 0, "F4 again gives the same picture as before")

    # Each broad phase says its name; the world stays as it is.
    notices = []
    for broad_phase in BROAD_PHASES:
        window.press("F5", then_s=0.6)
        notices.append(screen.picture(f"pause_{broad_phase}.png"))
        time.sleep(2.5)
    failures.check(all(changed(before, notice, NOTICE) > 0.02 for notice in notices), "F5 says what it did")
    alike = [(a, b) for i, a in enumerate(BROAD_PHASES) for j, b in enumerate(BROAD_PHASES)
             if i < j and changed(notices[i], notices[j], NOTICE) < 0.002]
    failures.check(not alike, f"and names another one each time {alike}")
    failures.check(changed(before, screen.picture(), BESIDE) == 0, "which changes nothing in the world")

    window.press("F3", then_s=1)
    shown = screen.picture("pause_f3.png")
    failures.check(changed(before, shown, PANEL) > 0.3, "F3 shows the panel")
    failures.check(changed(before, shown, BESIDE) == 0, "and covers nothing else")
    # A click in a pause goes on with the game, but for one on the panel.
    screen.keys("mousemove", "100", "300")
    time.sleep(0.5)
    screen.keys("click", "1")
    time.sleep(1)
    failures.check(changed(shown, screen.picture(), BESIDE) == 0, "a click on the panel is the panel's")
    screen.keys("mousemove", "1100", "650")
    time.sleep(0.5)
    window.press("F3", then_s=1)
    failures.check(changed(before, screen.picture(), PANEL) == 0, "F3 again hides it")
    window.press("F3", "Escape", then_s=1)
    failures.check(changed(shown, screen.picture(), BESIDE) > 0.05, "Escape goes on with the game under the panel")


def play(program, screen, folder, failures):
    recording = folder / "played.gwr"
    window = Window(program, screen, failures, "--mode", "swarm", "--enemies", 2500, "--seed", 5, "--autopilot", "expert",
                    "--record", recording)
    try:
        look_in_a_pause(window, screen, failures)
        screen.picture("play_f3.png")
        window.press("F4", then_s=1)
        screen.picture("play_f4.png")
        for broad_phase in BROAD_PHASES:
            window.press("F5", then_s=1.2)
            screen.picture(f"play_{broad_phase}.png")
        window.press("F3", "F5", "F3", then_s=0.7)
        window.leave("Escape", "q", "Escape")
    finally:
        window.end()
    verified(program, recording, failures, 300)
    return recording


def shoot_through_the_panel(program, screen, folder, failures):
    """In play the mouse is the ship's, wherever the pointer is."""
    recording = folder / "shot.gwr"
    window = Window(program, screen, failures, "--seed", 7, "--record", recording)
    try:
        window.press("Return", "F3", then_s=1)
        screen.keys("mousemove", "100", "300", "mousedown", "1", "keydown", "d")
        time.sleep(2)
        screen.picture("shooting.png")
        screen.keys("mouseup", "1", "keyup", "d")
        window.leave("Escape", "q", "Escape")
    finally:
        window.end()
    replay = verified(program, recording, failures, 60)
    failures.check(replay["shots"] >= 5 and replay["travelled_m"] > 3,
                   f"the ship flies and shoots under the panel: {replay['shots']} shots, {replay['travelled_m']} m")


def watch(program, screen, replay, failures):
    lines = run(program, "verify", replay, "--hashes", "-")[1].splitlines()
    hashes = dict(line.split() for line in lines if not line.startswith("#"))
    window = Window(program, screen, failures, "replay", replay, "--from", 100)
    try:
        window.press("space", "h", then_s=1.5)
        before = screen.picture("replay.png")
        window.press("F3", then_s=1.5)
        shown = screen.picture("replay_f3.png")
        failures.check(changed(before, shown, PANEL) > 0.3, "F3 shows the panel over a replay")
        for _ in range(4):
            window.press("F5", "period", "period", then_s=0.4)
        window.press("comma", "F4", then_s=1)
        screen.picture("replay_f4.png")
        window.press("space", then_s=1.5)
        window.press("F5", "Right", then_s=1)
        out = window.leave("q")
    finally:
        window.end()
    found = re.search(r"left at tick (\d+) of (\d+), state hash ([0-9a-f]{16})", out)
    failures.check(found and hashes.get(found[1]) == found[3], f"the replay is left with the recorded hash: {out!r}")


def play_inexactly(program, screen, folder, failures):
    """Only the NGrid can find what an inexact game finds."""
    recording = folder / "thesis.gwr"
    window = Window(program, screen, failures, "--thesis", "--enemies", 500, "--autopilot", "expert", "--seed", 1,
                    "--record", recording)
    try:
        window.press("Escape", then_s=1.5)
        before = screen.picture()
        window.press("F5", then_s=0.7)
        failures.check(changed(before, screen.picture("thesis_f5.png"), NOTICE) > 0.02, "F5 says that there is no other")
        window.press("Escape", then_s=0.7)
        window.leave("Escape", "q", "Escape")
    finally:
        window.end()
    verified(program, recording, failures, 60)


def look_at_a_small_window(program, screen, failures):
    """For a look at the pictures."""
    window = Window(program, screen, failures, "--mode", "swarm", "--enemies", 2500, "--seed", 5, "--autopilot", "expert",
                    "--width", 800, "--height", 600)
    try:
        window.press("F3", then_s=1.5)
        screen.picture("small_f3.png")
        window.press("F5", then_s=0.7)
        screen.picture("small_f5.png")
        window.leave("Escape", "q", "Escape")
    finally:
        window.end()


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    screen = Screen(folder)
    try:
        recording = play(program, screen, folder, failures)
        watch(program, screen, recording, failures)
        shoot_through_the_panel(program, screen, folder, failures)
        play_inexactly(program, screen, folder, failures)
        look_at_a_small_window(program, screen, failures)
        failures.check(not list(folder.glob("**/imgui.ini")) and not Path("imgui.ini").exists(), "no imgui.ini is left")
    finally:
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
