"""What is asked of a built game in a root: the golden replays, the fixed run, a picture and a film of it."""
import json
import os
import sys
from pathlib import Path

from film_colours import blocks, colours_fault
from outcome import FAILED, PASSED
from root import RESULTS

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "replays"))
from golden_replays import other_facts  # noqa: E402
from golden_suite import golden_list, read_facts  # noqa: E402

CLONE = "usr/src/gpuwars"  # in a root: where the newcomer's clone lies
# Every type of enemy, hits, flushes: wave after wave.
FIXED_TICKS, PICTURE_TICK, FILM_TICKS = 1800, 1500, 30
FIXED_RUN = ("--headless", "--device", "cpu", "--seed", "20", "--autopilot", "expert", "--enemies", "2048",
             "--ticks", str(FIXED_TICKS))
WIDTH_PX, HEIGHT_PX = 640, 360
FRAME_BYTES = WIDTH_PX * HEIGHT_PX * 3
TAGS = ("color_space", "color_primaries", "color_transfer")


class Game:
    """`program`: the words that start it in the clone."""

    def __init__(self, root, outcome, *program):
        self.root, self.outcome, self.program = root, outcome, program

    def run(self, *arguments, limit_s=3600):
        return self.root.status(f"/{CLONE}", *self.program, *arguments, limit_s=limit_s)

    def fixed_run(self):
        """Plays it, records it and takes its last hash down."""
        self.outcome.hash, why = self.played("--record", f"/{RESULTS}/fixed.gwr")
        return self.outcome.add("fixed run", FAILED if why else PASSED, why)

    def played(self, *more):
        """(the last hash of the fixed run, why there is none)."""
        hashes = self.root.results / "hashes"
        hashes.unlink(missing_ok=True)
        status = self.run(*FIXED_RUN, "--hashes", f"/{RESULTS}/hashes", *more)
        last = hashes.read_text().split()[-2:] if status == 0 and hashes.is_file() else []
        if len(last) == 2 and last[0] == str(FIXED_TICKS):
            return last[1], ""
        return "", f"exit status {status}, its last hash is {' of tick '.join(reversed(last)) or 'not there'}"

    def golden(self, source, most_ticks=None):
        """Verifies the golden replays: all, or those of at most so many ticks. A row each."""
        kept, groups = read_facts(source / "replays"), {}
        for golden in golden_list(source / "replays").values():
            if most_ticks is None or kept[golden.name]["ticks"] <= most_ticks:
                groups.setdefault(tuple(golden.verified), []).append(golden.name)
        for options, names in groups.items():
            told = self.root.results / "verified.json"
            told.unlink(missing_ok=True)
            status = self.run("verify", *(f"replays/{name}.gwr" for name in names), "--device", "cpu", "-j",
                              os.cpu_count() or 1, "--json", f"/{RESULTS}/verified.json", *options, limit_s=7200)
            try:
                replays = json.loads(told.read_text())["replays"]
            except (OSError, ValueError, KeyError):
                replays = []
            for name, facts in zip(names, replays + [{}] * (len(names) - len(replays)), strict=False):
                why = replay_fault(name, kept, facts, status)
                self.outcome.add(f"replay {name}", FAILED if why else PASSED, why)
        verified = sum(len(names) for names in groups.values())
        if most_ticks is not None and verified < len(kept):
            self.outcome.notes.append(f"with --quick {verified} of {len(kept)} golden replays, those of at most "
                                      f"{most_ticks:,} ticks")

    def picture(self):
        """Draws one tick of the fixed run; the picture's blocks are compared with other suites' later."""
        status = self.run("render", f"/{RESULTS}/fixed.gwr", "--out", f"/{RESULTS}/picture.png", "--to", PICTURE_TICK,
                          "--width", WIDTH_PX, "--height", HEIGHT_PX)
        return self.outcome.add("picture", PASSED if status == 0 else FAILED, f"exit status {status}" if status else "")

    def film(self):
        """Films the ticks around the picture; the decoded colours must be the picture's."""
        why = self._film_fault()
        return self.outcome.add("film", FAILED if why else PASSED, why)

    def _film_fault(self):
        first, last = PICTURE_TICK - FILM_TICKS // 2, PICTURE_TICK + FILM_TICKS // 2
        status = self.run("render", f"/{RESULTS}/fixed.gwr", "--out", f"/{RESULTS}/film.mp4", "--from", first, "--to", last,
                          "--width", WIDTH_PX, "--height", HEIGHT_PX)
        if status:
            return f"exit status {status}"
        for file in ("picture.png", "film.mp4"):
            if self.root.status(f"/{RESULTS}", "ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-i", file,
                                "-f", "rawvideo", "-pix_fmt", "rgb24", f"{file}.rgb"):
                return f"ffmpeg cannot decode {file}"
        film = self.root.results / "film.mp4.rgb"
        frames, wanted = film.stat().st_size / FRAME_BYTES, last - first + 1
        if frames != wanted:
            return f"it has {frames:g} frames of {wanted}"
        with film.open("rb") as file:
            file.seek((PICTURE_TICK - first) * FRAME_BYTES)
            frame = file.read(FRAME_BYTES)
        probe = self.root.said(f"/{RESULTS}", "ffprobe", "-v", "error", "-show_streams", "-of", "json", "film.mp4")
        return self._colours_fault((self.root.results / "picture.png.rgb").read_bytes(), frame,
                                   json.loads(probe)["streams"][0])

    def _colours_fault(self, picture, frame, stream):
        drawn, decoded = (blocks(rgb, WIDTH_PX, HEIGHT_PX) for rgb in (picture, frame))
        self.outcome.picture = drawn.hex()
        wrong = [f"{tag} {stream.get(tag, 'unknown')}" for tag in TAGS if stream.get(tag) != "bt709"]
        if wrong:
            return f"it must be marked as bt709, but says {', '.join(wrong)}"
        return colours_fault(drawn, decoded)


def replay_fault(name, kept, facts, status):
    """Why a verified replay is not good; empty when it is."""
    if not facts:
        return f"verify says nothing of it (exit status {status})"
    if not facts.get("equal"):
        first = facts.get("firstDifference", {}).get("tick")
        return f"differs from tick {first} on" if first else str(facts.get("error") or "is not equal")
    if facts["ticksCompared"] != kept[name]["ticks"]:
        return f"{facts['ticksCompared']} of {kept[name]['ticks']} ticks were compared"
    return "; ".join(other_facts(name, kept, facts))
