#!/usr/bin/env -S python3 -S -E
"""debootstrap and chroot as the test of tests/distributions puts them on PATH, which need no root's rights.

A fake root is an ordinary folder, and what runs "in" it is answered here. BREAK="SUITE WHAT" breaks one thing.
"""
import json
import os
import sys
import time
from pathlib import Path

NAME, WORDS = Path(sys.argv[0]).name, sys.argv[1:]
WIDTH, HEIGHT, FRAMES = 640, 360, 31
VERSIONS = {"bookworm": "12.2.0", "trixie": "14.2.0", "forky": "16.2.0", "aarch64": "14.2.0"}


def said(line):
    with open(os.environ["FAKE_CALLS"], "a", encoding="utf-8") as calls:
        calls.write(line + "\n")


def debootstrap():
    release, target = [word for word in WORDS if not word.startswith("--")][:2]
    said(f"debootstrap {release} {' '.join(WORDS[-2:]) if WORDS[-1].endswith('sid') else ''}".strip())
    if os.environ.get("BREAK") == "debootstrap":
        sys.exit(1)
    for name in ("proc", "sys", "dev", "etc", "var/cache/apt/archives"):
        (Path(target) / name).mkdir(parents=True)


def chroot():
    root, start = Path(WORDS[0]), WORDS.index("sh")
    os.chdir(root / WORDS[start + 3].lstrip("/"))
    command = WORDS[start + 4:]
    preloaded = any("LD_PRELOAD" in word for word in command)
    while "=" in command[0] or command[0] in ("env", "qemu-aarch64", "-E"):
        command.pop(0)
    said(f"{root.name}: {' '.join(command)}")
    Inside(root, command, preloaded).answer()


def as_bt601(red, green, blue):
    """What is read as BT.601 of a colour that was stored as BT.709."""
    luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue
    cr, cb = (red - luma) / 1.5748, (blue - luma) / 1.8556
    read = (luma + 1.402 * cr, luma - 0.344136 * cb - 0.714136 * cr, luma + 1.772 * cb)
    return tuple(min(255, max(0, round(value))) for value in read)


class Inside:
    """One command in a root."""

    def __init__(self, root, command, preloaded):
        self.root, self.suite, self.command, self.preloaded = root, root.name, command, preloaded

    def broken(self, what):
        return os.environ.get("BREAK") == f"{self.suite} {what}"

    def path(self, option):
        return self.root / self.command[self.command.index(option) + 1].lstrip("/")

    def answer(self):
        answers = {"./play": self.play, "./check": self.check, "g++": self.version, "cmake": self.cmake,
                   "aarch64-linux-gnu-g++": self.version, "ffmpeg": self.decode, "ffprobe": self.probe,
                   "gpuwars": self.game, "sh": lambda: print("/usr/bin/ffmpeg")}
        answers.get(self.command[0].rpartition("/")[2] if "gpuwars" in self.command[0] else self.command[0],
                    lambda: None)()

    def play(self):
        Path("out").mkdir(exist_ok=True)
        for name in ("play.png", "play.gwr", *([] if self.broken("summary") else ["summary.txt"])):
            (Path("out") / name).write_text("x")
        sys.exit(1 if self.broken("play") else 0)

    def check(self):
        while self.broken("patience"):
            time.sleep(0.1)
        junit = Path("build/release/junit_rest.xml")
        junit.parent.mkdir(parents=True)
        failing = '<failure message=""/>' if self.broken("check") else ""
        new = "" if self.suite == "bookworm" else '<testcase name="new" status="run"/>'
        junit.write_text(f'<testsuite><testcase name="one" status="run">{failing}</testcase>'
                         '<testcase name="screen" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase>'
                         f"{new}</testsuite>")
        passed = 1 + bool(new) - bool(failing)
        print("Segmentation fault" if self.broken("the last line") else
              f"{passed} passed, {int(bool(failing))} failed, 1 skipped")
        sys.exit(1 if failing else 0)

    def version(self):
        print(VERSIONS[self.suite])

    def cmake(self):
        print("cmake version 3.31.6\n\nCMake suite")
        sys.exit(1 if self.broken("cmake") and "--build" in self.command else 0)

    def game(self):
        if "verify" in self.command:
            kept = json.loads(Path("replays/golden.facts").read_text())
            names = [Path(word).stem for word in self.command if word.endswith(".gwr")]
            told = [{**kept[name], "file": name, "equal": True, "ticksCompared": kept[name]["ticks"]} for name in names]
            if self.broken("replay"):
                told[0].update(equal=False, firstDifference={"tick": 7})
            if self.broken("report"):
                told[0]["score"] += 1
            if self.broken("length"):
                told[0]["ticksCompared"] -= 1
            self.path("--json").write_text("" if self.broken("verify") else json.dumps({"replays": told}))
        elif "render" in self.command:
            self.path("--out").write_text("x")
        else:
            other = self.broken("hash") or (self.broken("float state") and self.preloaded)
            value = "0123456789abcdef" if other else "fedcba9876543210"
            self.path("--hashes").write_text(f"1 00\n{self.command[self.command.index('--ticks') + 1]} {value}\n")

    def decode(self):
        """A picture of five colours; the film's frame in the middle shows the same, or as another matrix reads it."""
        film = "film.mp4" in self.command
        colours = [(220, 0, 0), (0, 220, 0), (0, 0, 220), (200, 200, 200), (10, 10, 20)]
        if self.broken("picture"):
            colours[3] = (160, 200, 200)
        if film and self.broken("matrix"):
            colours = [as_bt601(*colour) for colour in colours]
        if film and self.broken("range"):
            colours = [tuple(16 + value * 219 // 255 for value in colour) for colour in colours]
        if film and self.broken("colour"):
            colours = [(sum(colour) // 3,) * 3 for colour in colours]
        frame = b"".join(bytes(colour) * (WIDTH // len(colours)) for colour in colours) * HEIGHT
        with open(self.command[-1], "wb") as file:
            file.truncate(len(frame) * (FRAMES - self.broken("frames") if film else 1))
            file.seek(len(frame) * (FRAMES // 2) if film else 0)
            file.write(frame)

    def probe(self):
        stream = dict.fromkeys(("color_space", "color_primaries", "color_transfer"), "bt709")
        if self.broken("tags"):
            del stream["color_transfer"]
        print(json.dumps({"streams": [stream]}))


if __name__ == "__main__":
    {"debootstrap": debootstrap, "chroot": chroot}[NAME]()
