#!/usr/bin/env python3
"""Renders replays without a display: pictures, one picture, films; the same pictures every time; refusals.

    render_e2e.py GPUWARS FORGE_REPLAY FOLDER      the films need ffmpeg and ffprobe, else they are skipped and counted
"""
import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from program import Failures, run, skip, without_display

FINE, FAILED, USAGE, BAD_FILE, DESYNC = range(5)
CTRL_C = 130
SMALL = ("--width", 320, "--height", 200)


def frames(folder):
    return sorted(folder.glob("frame_*.png"))


def size_of(picture):
    """Of a PNG, from its header."""
    head = picture.read_bytes()[:24]
    return int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")


class Render:
    def __init__(self, program, folder, failures):
        self.program, self.folder, self.failures = program, folder, failures
        self.replay = folder / "run.gwr"
        code, _, err = run(program, "--headless", "--mode", "swarm", "--enemies", 60, "--seed", 3, "--autopilot",
                           "expert", "--ticks", 240, "--record", self.replay)
        failures.check(code == FINE, f"a run is recorded {err}")

    def good(self, what, out, *options, says=""):
        code, stdout, err = run(self.program, "render", self.replay, "--out", self.folder / out, *options)
        self.failures.check(code == FINE and err == "" and says in stdout, f"{what}: exit {code} {stdout} {err}")

    def refused(self, what, code, out, *options, says, replay=None, environment=None):
        got, stdout, err = run(self.program, "render", replay or self.replay, "--out", self.folder / out, *options,
                               environment=environment)
        self.failures.check(got == code and says in err and err.count("\n") == 1 and stdout == "",
                            f"{what}: exit {got}, {err.strip()!r}")


def pictures(render, failures, folder):
    render.good("a folder of pictures", "a", "--from", 100, "--to", 120, *SMALL, says="21 of 21 frames")
    render.good("once more, on one thread", "b", "--from", 100, "--to", 120, "--threads", 1, *SMALL)
    a, b = frames(folder / "a"), frames(folder / "b")
    failures.check(len(a) == 21 and a[0].name == "frame_000001.png", "one picture a tick, numbered from 1")
    failures.check([f.read_bytes() for f in a] == [f.read_bytes() for f in b], "two runs give identical pictures")
    failures.check(len({f.read_bytes() for f in a}) == 21, "and each is another")
    failures.check(size_of(a[0]) == (320, 200), "of the size that was asked for")
    render.good("a film that begins later", "c", "--from", 110, "--to", 112, *SMALL)
    failures.check(frames(folder / "c")[0].read_bytes() == a[10].read_bytes(), "shows a tick as any other film does")
    render.good("half the rate", "d", "--from", 100, "--to", 120, "--fps", 30, *SMALL, says="11 of 11")
    failures.check([f.read_bytes() for f in frames(folder / "d")] == [f.read_bytes() for f in a[::2]],
                   "30 a second are every second of 60")
    render.good("twice the rate", "e", "--from", 100, "--to", 101, "--fps", 120, *SMALL, says="4 of 4")
    failures.check(frames(folder / "e")[1].read_bytes() == a[0].read_bytes(), "every second of 120 is one of 60")

    render.good("one picture", "one.png", "--to", 110, *SMALL, says="1 of 1 picture")
    failures.check((folder / "one.png").read_bytes() == a[10].read_bytes(), "one picture is of the tick of --to")
    render.good("one without figures", "bare.png", "--to", 110, "--hud", "off", *SMALL)
    failures.check((folder / "bare.png").read_bytes() != a[10].read_bytes(), "--hud off leaves the figures out")
    render.good("the last tick", "last.png", *SMALL, says="ticks 240 to 240")


def refusals(render, failures, folder, forge):
    render.refused("frames of another render", BAD_FILE, "a", says="give an empty folder")
    failures.check(len(frames(folder / "a")) == 21, "which stay as they were")
    (folder / "file").write_text("x")
    render.refused("a file where a folder should be", BAD_FILE, "file", says="it is a file")
    render.refused("a folder in no folder", BAD_FILE, "none/below", says="choose a folder inside")
    (folder / "folder.png").mkdir()
    render.refused("a folder where a picture should be", BAD_FILE, "folder.png", says="it is a folder")
    render.refused("a tick that is not there", USAGE, "f", "--to", 5000, says="past the last tick")
    failures.check(not (folder / "f").exists(), "and no folder is made for it")
    render.refused("no ffmpeg", FAILED, "f.mp4", says="install it", environment={**without_display(), "PATH": "/none"})
    render.refused("no replay", BAD_FILE, "f", replay=folder / "none.gwr", says="none.gwr")

    false = folder / "false.gwr"
    failures.check(run(forge, render.replay, false, "hash", 50)[0] == 0, "a replay with a false hash is made")
    code, _, err = run(render.program, "render", false, "--out", folder / "false", "--to", 60, *SMALL)
    failures.check(code == DESYNC and "differs from tick 50" in err, f"a desync is reported: {code} {err.strip()!r}")
    failures.check(len(frames(folder / "false")) == 60, "and its pictures are there to look at")


def interrupted(render, failures, folder):
    child = subprocess.Popen([render.program, "render", render.replay, "--out", folder / "left"],
                             env=without_display(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while child.poll() is None and len(frames(folder / "left")) < 3:
        time.sleep(0.05)
    child.send_signal(signal.SIGINT)
    err = child.communicate(timeout=60)[1].decode()
    left = list((folder / "left").iterdir())
    failures.check(child.returncode == CTRL_C and "Interrupted" in err, f"Ctrl-C is reported: {err.strip()!r}")
    failures.check(0 < len(left) < 240 and all(f.read_bytes().endswith(b"IEND\xaeB`\x82") for f in left),
                   f"Ctrl-C leaves {len(left)} whole pictures and nothing else")


def decoded(path):
    """The pixels of a picture, or of the first frame of a film, as a player would show them."""
    return subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                          stdout=subprocess.PIPE, check=True).stdout


def colours(render, failures, folder):
    """A film shows the picture that render makes of the same tick."""
    render.good("a film of a tick", "tick.mp4", "--from", 110, "--to", 110, *SMALL)
    film, picture = decoded(folder / "tick.mp4"), decoded(folder / "one.png")
    apart = [abs(a - b) for a, b in zip(film, picture)]
    failures.check(len(film) == len(picture) == 3 * 320 * 200 and sum(apart) / len(apart) < 3,
                   f"is the picture of that tick: {sum(apart) / len(apart):.2f} of 255 apart")


def films(render, failures, folder):
    render.good("a film", "film.mp4", "--from", 60, "--to", 149, *SMALL, says="90 of 90 frames")
    probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-show_format", "-of", "json",
                            folder / "film.mp4"], stdout=subprocess.PIPE, check=True)
    facts = json.loads(probe.stdout)
    stream = facts["streams"][0]
    failures.check((stream["width"], stream["height"], stream["pix_fmt"]) == (320, 200, "yuv420p"), "of this size")
    failures.check(stream["nb_read_frames"] == "90" and stream["r_frame_rate"] == "60/1", "90 frames at 60 a second")
    failures.check(abs(float(facts["format"]["duration"]) - 1.5) < 0.05, "which last 1.5 s")
    failures.check(len(facts["streams"]) == 1, "and no sound")
    colours(render, failures, folder)
    render.good("a film at 120", "fast.mp4", "--from", 60, "--to", 69, "--fps", 120, *SMALL, says="20 of 20")

    child = subprocess.Popen([render.program, "render", render.replay, "--out", folder / "left.mp4"],
                             env=without_display(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    time.sleep(3)
    child.send_signal(signal.SIGINT)
    err = child.communicate(timeout=60)[1].decode()
    whole = not (folder / "left.mp4").exists() or subprocess.run(
        ["ffprobe", "-v", "error", folder / "left.mp4"], stdout=subprocess.DEVNULL).returncode == 0
    failures.check(child.returncode in (FINE, CTRL_C) and whole, f"Ctrl-C leaves a whole film: {err.strip()!r}")
    failures.check(not list(folder.glob("*.part*")), "and no part of one")


def main():
    program, forge, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    render = Render(program, folder, failures)
    pictures(render, failures, folder)
    refusals(render, failures, folder, forge)
    interrupted(render, failures, folder)
    if failures.count == 0 and not (shutil.which("ffmpeg") and shutil.which("ffprobe")):
        skip("films: ffmpeg or ffprobe is not installed; the pictures were fine")
    films(render, failures, folder)
    failures.finish()


if __name__ == "__main__":
    main()
