"""Runs gpuwars as a user does, for the end-to-end tests."""
import json
import os
import subprocess
import sys


class Failures:
    """Collects what went wrong, so that one run names everything."""

    def __init__(self):
        self.count = 0

    def check(self, good, sentence):
        print(("ok    " if good else "FAIL  ") + sentence, flush=True)
        self.count += not good
        return good

    def finish(self):
        sys.exit(1 if self.count else 0)


def without_display():
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")}
    return {**environment, "XDG_CONFIG_HOME": "/nonexistent"}  # no user's settings take part


def run(program, *arguments, environment=None, timeout=300):
    """(exit code, stdout, stderr) of one finished command."""
    result = subprocess.run([program, *map(str, arguments)], env=environment or without_display(), timeout=timeout,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return result.returncode, result.stdout.decode(errors="replace"), result.stderr.decode(errors="replace")


def has_terminals():
    """Whether a pseudo-terminal can be had: a minimal root has none before devpts is mounted."""
    try:
        for side in os.openpty():
            os.close(side)
    except OSError:
        return False
    return True


def saved_settings(path):
    """A settings file as the game writes it: there every value of TOML is one of JSON too."""
    sections = {}
    for line in path.read_text().splitlines():
        if line.startswith("["):
            section = sections.setdefault(line.strip("[]"), {})
        elif "=" in line:
            key, value = line.split(" = ", 1)
            section[key] = json.loads(value)
    return sections


def skip(reason):
    print("skipped: " + reason)
    sys.exit(77)
