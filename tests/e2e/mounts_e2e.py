#!/usr/bin/env python3
"""Files that are mount points of their own, as a container's may be, are written like any other.

    mounts_e2e.py GPUWARS FOLDER      skipped where nothing may be mounted (unshare -m, or -rm)
"""
import json
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

from program import Failures, run, skip, without_display

FINE, _, _, BAD_FILE, _ = range(5)
GAME = ("--headless", "--device", "cpu", "--autopilot", "expert", "--enemies", 64)
SMALL = ("--width", 320, "--height", 200)


def own_mounts():
    """The command that runs another where it may mount, or none."""
    for command in (["unshare", "-m"], ["unshare", "-rm"]):
        if shutil.which("unshare") and subprocess.run([*command, "mount", "-t", "tmpfs", "none", "/mnt"],
                                                      stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0:
            return command
    return None


class Mounted:
    """A folder of the host's, files of which stand in a container's."""

    def __init__(self, program, folder, failures, unshare):
        self.program, self.failures, self.unshare = program, failures, unshare
        self.host, self.container = folder / "host", folder / "container"
        self.host.mkdir()
        self.container.mkdir()

    def run(self, what, code, names, *arguments, before="", script=""):
        """Runs the program while NAMES are mounted, each holding `before`; the host's files hold what was written."""
        commands = [script]
        for name in names:
            for side in (self.host, self.container):
                (side / name).parent.mkdir(parents=True, exist_ok=True)
                (side / name).write_text(before)
            commands.append(f"mount --bind '{self.host / name}' '{self.container / name}'")
        commands.append('exec "$@"')
        result = subprocess.run([*self.unshare, "sh", "-ec", "\n".join(commands), "sh", self.program, *map(str, arguments)],
                                env=without_display(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, timeout=300, text=True)
        self.failures.check(result.returncode == code, f"{what}: exit {result.returncode} {result.stdout}{result.stderr}")
        left = [str(part) for part in self.container.rglob("*part*")]
        self.failures.check(not left, f"{what}: no part is left {left}")
        return result.stderr


def main():
    program, folder = sys.argv[1], Path(sys.argv[2]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    unshare = own_mounts()
    if unshare is None:
        skip("nothing may be mounted here (unshare -m)")
    there = Mounted(program, folder, failures, unshare)
    host, container = there.host, there.container

    there.run("a recording and its last picture", FINE, ["r.gwr", "s.png"], *GAME, *SMALL, "--ticks", 130, "--record",
              container / "r.gwr", "--screenshot", container / "s.png")
    replay = folder / "run.gwr"
    shutil.copy(host / "r.gwr", replay)
    failures.check(run(program, "verify", replay, "--device", "cpu")[0] == FINE, "is whole")
    there.run("over a longer file", FINE, ["t.gwr"], "trim", replay, "--device", "cpu", "--to", 61, "--out",
              container / "t.gwr", before="x" * 100000)
    code, stdout, _ = run(program, "verify", host / "t.gwr", "--device", "cpu")
    failures.check(code == FINE and "61 of 61" in stdout, f"nothing of which is left: {stdout.strip()}")
    there.run("JSON, JUnit and hashes", FINE, ["o.json", "j.xml", "h"], "verify", replay, "--device", "cpu", "--json",
              container / "o.json", "--junit", container / "j.xml", "--hashes", container / "h")
    failures.check(json.loads((host / "o.json").read_text())["exitCode"] == FINE
                   and ElementTree.parse(host / "j.xml").getroot().get("tests") == "1"
                   and len((host / "h").read_text().splitlines()) == 130, "are all there")
    report = ["rep/report.json", "rep/frames.csv", "rep/report.html", "trace.json"]
    there.run("a report", FINE, report, "profile", "--replay", replay, "--device", "cpu", "--no-draw", "--runs", 2, "--out",
              container / "rep", "--trace", container / "trace.json")
    failures.check(json.loads((host / "rep/report.json").read_text())["gpuwarsProfile"] == 1
                   and len((host / "rep/frames.csv").read_text().splitlines()) == 1 + 2 * 130
                   and json.loads((host / "trace.json").read_text()), "is whole")
    there.run("a picture", FINE, ["p.png"], "render", replay, "--out", container / "p.png", *SMALL)
    failures.check(all((host / name).read_bytes().endswith(b"IEND\xaeB`\x82") for name in ("p.png", "s.png")),
                   "is whole, and so is the one of the recording")
    if shutil.which("ffmpeg") and shutil.which("ffprobe"):
        there.run("a film", FINE, ["f.mp4"], "render", replay, "--to", 20, "--out", container / "f.mp4", *SMALL)
        failures.check(subprocess.run(["ffprobe", "-v", "error", host / "f.mp4"]).returncode == 0, "is whole")

    # A mount of its own size: what does not fit there leaves what stood there.
    small = folder / "small"
    small.mkdir()
    mounted = (f"mount -t tmpfs -o size=16k none '{small}'\necho earlier > '{small}/o.json'\n"
               f"mount --bind '{small}/o.json' '{container}/o.json'\n"
               f"after() {{ code=$?; cat '{container}/o.json'; exit $code; }}\ntrap after EXIT\n")
    script = mounted + '"$@" > /dev/null'
    result = subprocess.run([*unshare, "sh", "-c", script, "sh", program, "verify", *[str(replay)] * 40, "--device", "cpu",
                             "--json", str(container / "o.json")], env=without_display(), stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, timeout=300)
    failures.check(result.returncode == BAD_FILE and result.stdout == "earlier\n" and "make room" in result.stderr,
                   f"a full one keeps what stood there: {result.returncode} {result.stdout!r} {result.stderr!r}")
    failures.finish()


if __name__ == "__main__":
    main()
