#!/usr/bin/env python3
"""The window itself: no text input, the pointer, a lost focus, full screen, a hidden window, runs that end by
themselves.

    window_e2e.py GPUWARS PLAY_WITH_PAD LAYOUT_LABELS FORGE_REPLAY NO_SWAP_WAIT FOLDER      pictures stay in FOLDER
"""
import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, saved_settings
from screen import Screen, lit

SMALL = ("--width", "640", "--height", "360")
NOT_SWITCHED = "The window system did not switch full screen"


def lower_half(pixels):
    """Without the real frame rate, which is real even in a pause."""
    return pixels[len(pixels) // 2:]


class Game:
    """play_with_pad, which answers what SDL says of its window; or the game itself."""

    def __init__(self, program, screen, failures, *arguments, preload=None):
        self.screen, self.failures = screen, failures
        self.process = subprocess.Popen([program, *map(str, arguments), "--mute"], text=True,
                                        env={**screen.environment, **(preload or {})}, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 500), f"a picture appears: {arguments[:2]}")
        self.id = screen.window_of(self.process)
        time.sleep(0.7)

    def ask(self, question):
        self.process.stdin.write(f"ask {question}\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        while answer not in ("0\n", "1\n"):  # what the game itself says
            if not answer:
                raise RuntimeError(f"the game ended when it was asked {question}: {self.process.stderr.read()}")
            answer = self.process.stdout.readline()
        return answer == "1\n"

    def press(self, *keys, wait=0.5):
        for key in keys:
            self.screen.keys("key", key)
            time.sleep(wait)

    def focus(self):
        self.screen.keys("windowfocus", self.id)
        time.sleep(0.5)

    def processor_s(self):
        words = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def leave(self, *keys, says=""):
        self.press(*keys, wait=0.7)
        out, err = self.process.communicate(timeout=60)
        good = self.process.returncode == 0 and (err == "" or (says and err.startswith(says)))
        self.failures.check(good, f"the game ends: {self.process.returncode}, {err!r}")
        return out

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()


class OtherWindow:
    """Something else that has the focus."""

    def __init__(self, program, screen):
        self.process = subprocess.Popen([program], env=screen.environment, stdin=subprocess.PIPE)
        screen.keys("windowfocus", screen.window_of(self.process))
        time.sleep(0.7)

    def close(self):
        self.process.stdin.close()
        self.process.wait(timeout=30)


def check_text_input(game, failures, where):
    failures.check(not game.ask("text_input"), f"no input method is asked for letters: {where}")


def play(player, labels, screen, folder, failures):
    settings = folder / "settings.toml"
    game = Game(player, screen, failures, "--seed", 7, "--settings", settings, *SMALL)
    try:
        game.focus()
        check_text_input(game, failures, "title")
        failures.check(not game.ask("pointer_kept"), "the pointer is free on the title")
        game.press("o")
        check_text_input(game, failures, "settings")
        game.press("Escape", "Return")
        check_text_input(game, failures, "play")
        failures.check(game.ask("pointer_kept"), "in play it is kept")
        screen.keys("mousemove_relative", "--", "1000", "600")
        time.sleep(0.3)
        x, y = screen.pointer()
        geometry = dict(line.split("=") for line in subprocess.run(
            ["xdotool", "getwindowgeometry", "--shell", game.id], env=screen.environment, check=True, text=True,
            stdout=subprocess.PIPE).stdout.splitlines())
        left, top = int(geometry["X"]), int(geometry["Y"])
        failures.check(left <= x < left + 640 and top <= y < top + 360, f"it stays in the window: {x}, {y} in {geometry}")
        game.press("Escape")
        check_text_input(game, failures, "pause")
        failures.check(not game.ask("pointer_kept"), "the pause lets it go")
        screen.keys("mousemove", "5", "5")
        failures.check(screen.pointer() == (5, 5), "it goes wherever it likes")
        screen.keys("mousemove", str(left + 300), str(top + 200))
        game.press("Escape")

        other = OtherWindow(labels, screen)
        paused = lower_half(screen.picture("lost_focus.png"))
        time.sleep(1)
        failures.check(lower_half(screen.picture()) == paused, "a lost focus pauses a person's run")
        failures.check(not game.ask("pointer_kept"), "and lets the pointer go")
        other.close()
        game.focus()

        # The last row of values but two: down to it from the first.
        game.press("o")
        screen.keys("key", "--delay", "60", *["Down"] * 12)
        game.press("Return")
        screen.picture("settings.png")
        game.press("Escape")
        failures.check(saved_settings(settings)["video"] == {"fullscreen": False, "keep_pointer": False},
                       f"the setting is saved: {saved_settings(settings)['video']}")
        game.press("Escape")
        failures.check(not game.ask("pointer_kept"), "the player's choice: it is not kept in play")
        game.leave("Escape", "q", "Escape")
    finally:
        game.kill()


def watch(player, screen, replay, failures):
    game = Game(player, screen, failures, "replay", replay, *SMALL)
    try:
        game.focus()
        check_text_input(game, failures, "replay")
        failures.check(not game.ask("pointer_kept"), "the pointer is free beside a replay")
        game.leave("q")
    finally:
        game.kill()


def fill_the_screen(player, screen, folder, failures):
    """Without a window manager it works with some versions of SDL; what must not happen is that the game believes so."""
    settings = folder / "full.toml"
    game = Game(player, screen, failures, "--settings", settings, *SMALL)
    try:
        game.focus()
        game.press("f", wait=2)
        full = game.ask("fullscreen")
        screen.picture("fullscreen.png")
        print(f"full screen without a window manager: {full}")
        game.press("o")
        screen.keys("key", "--delay", "60", "Down", "Right")  # another value, so that the file is written
        time.sleep(0.3)
        game.press("Escape")
        failures.check(not saved_settings(settings)["video"]["fullscreen"],
                       "a key's full screen is not saved along with another setting")
        game.leave("Escape", says="" if full else NOT_SWITCHED)
    finally:
        game.kill()


def bots(program, labels, screen, folder, failures):
    recording = folder / "bot.gwr"
    game = Game(program, screen, failures, "--autopilot", "expert", "--seed", 3, "--ticks", 420, "--record", recording,
                  *SMALL)
    try:
        game.focus()
        other = OtherWindow(labels, screen)
        game.leave()
        other.close()
    finally:
        game.kill()
    code, out, _ = run(program, "verify", recording, "--json", "-")
    failures.check(code == 0 and json.loads(out)["replays"][0]["ticks"] == 420, "a bot plays on without the focus")
    return recording


def replays_end(program, forge, screen, folder, replay, failures):
    out, err, code = finished(program, screen, "replay", replay, "--speed", 4, "--quit-at-end", *SMALL)
    failures.check(code == 0 and err == "" and "left at tick 420 of 420" in out, f"--quit-at-end: {code}, {out!r} {err!r}")
    false = folder / "false.gwr"
    failures.check(run(forge, replay, false, "hash", 100)[0] == 0, "a replay with a false hash is made")
    out, err, code = finished(program, screen, "replay", false, "--speed", 16, "--quit-at-end", *SMALL)
    failures.check(code == 4 and "differs from tick 100" in err, f"a desync is still said: {code}, {err!r}")


def finished(program, screen, *arguments):
    process = subprocess.Popen([program, *map(str, arguments), "--mute"], env=screen.environment, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        out, err = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        out, err = process.communicate()
    return out, err, process.returncode


def nobody_looks(program, library, screen, folder, failures):
    """A window taken from the screen draws nothing, computes on, and leaves the processor alone."""
    swaps = folder / "swaps"
    preload = {"LD_PRELOAD": library, "GW_SWAPS": str(swaps)}

    def rates(game, seconds=3):
        """(pictures, seconds of processor time) for each second."""
        time.sleep(0.5)
        pictures, processor, begin = int(swaps.read_text()), game.processor_s(), time.monotonic()
        time.sleep(seconds)
        passed = time.monotonic() - begin
        return (int(swaps.read_text()) - pictures) / passed, (game.processor_s() - processor) / passed

    recording = folder / "unseen.gwr"
    game = Game(program, screen, failures, "--autopilot", "expert", "--seed", 3, "--ticks", 900, "--record", recording,
                  *SMALL, preload=preload)
    try:
        begin, shown = time.monotonic(), int(swaps.read_text())
        screen.keys("windowunmap", game.id)
        unseen = rates(game)
        game.leave()
        passed = time.monotonic() - begin
        failures.check(unseen[0] == 0, f"no picture is drawn unseen: {unseen}, {shown} before")
        failures.check(passed < 40, f"ticks go on in real time: {passed:.1f} s")
        print(f"a bot's unseen run: {unseen[1]:.2f} of a core")
    finally:
        game.kill()
    failures.check(run(program, "verify", recording)[0] == 0, "the recording verifies")

    game = Game(program, screen, failures, "--seed", 3, *SMALL, preload=preload)
    try:
        game.press("Return", wait=1)
        game.press("Escape", wait=1)
        seen = rates(game)
        failures.check(seen[0] < 300, f"a driver that does not wait is no reason to draw ever faster: {seen[0]:.0f} a second")
        screen.keys("windowunmap", game.id)
        unseen = rates(game)
        failures.check(unseen[0] == 0 and unseen[1] < 0.2, f"an unseen pause: {unseen}, seen: {seen}")
        screen.keys("windowmap", game.id)
        failures.check(screen.wait_for(lambda pixels: lit(pixels) > 500), "shown again it is drawn again")
        game.focus()
        game.leave("q", "Escape")
    finally:
        game.kill()


def main():
    program, player, labels, forge, library, folder = *sys.argv[1:6], Path(sys.argv[6])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    screen = Screen(folder)
    try:
        play(player, labels, screen, folder, failures)
        fill_the_screen(player, screen, folder, failures)
        replay = bots(program, labels, screen, folder, failures)
        watch(player, screen, replay, failures)
        replays_end(program, forge, screen, folder, replay, failures)
        nobody_looks(program, library, screen, folder, failures)
    finally:
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
