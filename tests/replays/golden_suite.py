"""The suite of golden replays as data: replays/golden.list, the facts of each, and the programs that tell them."""
import json
import os
import shlex
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
MOST_BYTES = 16 << 20  # of all replays together: every clone of the repository carries them
# What golden.facts keeps of verify --json: whole numbers and words only, equal on every machine.
KEPT = ("mode", "enemiesFit", "ticks", "score", "kills", "over", "ending", "shots", "flushes", "contacts", "bitsTaken",
        "peakEnemies", "enemiesLeft", "refused", "killsByType", "edges")
PERSON = "person"


@dataclass(frozen=True)
class Golden:
    """A line of golden.list: name | how it is recorded | options with which it is verified"""
    name: str
    recorded: list  # options of gpuwars; or script NAME and options; or person
    verified: list

    @property
    def script(self):
        return self.recorded[1] if self.recorded[:1] == ["script"] else None

    @property
    def person(self):
        return self.recorded == [PERSON]

    def line(self):
        columns = [f"{self.name:20}", shlex.join(self.recorded)] + ([shlex.join(self.verified)] if self.verified else [])
        return " | ".join(columns)


def golden_list(folder):
    """The lines of golden.list by name, in its order."""
    golden, path = {}, folder / "golden.list"
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        columns = [part.strip() for part in line.split("|")]
        name = columns[0]
        if not 2 <= len(columns) <= 3 or not name or name in golden:
            raise ValueError(f"{path}:{number}: expected 'name | options' or 'name | options | options of verify', "
                             "each name once")
        golden[name] = Golden(name, shlex.split(columns[1]), shlex.split(columns[2]) if len(columns) == 3 else [])
        if golden[name].recorded[:1] == ["script"] and len(golden[name].recorded) < 2:
            raise ValueError(f"{path}:{number}: 'script' needs a name; play_script lists them")
    return golden


def verify(gpuwars, files, jobs, more=()):
    """What verify --json says of each file, in their order."""
    command = [gpuwars, "verify", *files, "--device", "cpu", "-j", str(jobs), "--json", "-", *more]
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    try:
        return json.loads(result.stdout)["replays"]
    except (ValueError, KeyError):
        raise ValueError(f"verify failed ({result.returncode}): {result.stderr.decode(errors='replace')}") from None


def tool(gpuwars, name):
    """A tool of tests/replays, which the build puts beside the game."""
    path = Path(gpuwars).resolve().parent / name
    if not path.is_file():
        raise ValueError(f"{path} is not there; build the target {name}")
    return path


def replay_facts(gpuwars, file, *options):
    """What is in a replay of any version, and in its inputs."""
    command = [tool(gpuwars, "replay_facts"), *options, file]
    result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            check=False)
    if result.returncode != 0:
        raise ValueError(result.stderr.strip() or f"replay_facts failed ({result.returncode}) on {file}")
    return json.loads(result.stdout)


def look_closer(gpuwars, file, expectation, facts):
    """Adds to the facts of verify what only replay_facts tells, when the expectation asks for it."""
    if expectation.asks_played() or expectation.asks_inputs():
        more = replay_facts(gpuwars, file, *(["--played"] if expectation.asks_played() else []))
        for key, value in more.items():
            facts.setdefault(key, value)
    return facts


def shortcomings(name, expectation, facts):
    """Why one verified replay is not good; nothing when it is."""
    if not facts["equal"]:
        first = facts.get("firstDifference", {}).get("tick")
        cause = f"differs from tick {first} on" if first else facts.get("error") or facts.get("wrong")
        return [f"{name}: {cause}"]
    return [f"{name}: {sentence}; see replays/{name}.expect" for sentence in expectation.unmet(facts)]


def kept_facts(facts):
    return {key: facts[key] for key in KEPT}


def read_facts(folder):
    """golden.facts: what the replays showed when they were recorded, by name. Empty when there is none."""
    path = folder / "golden.facts"
    return json.loads(path.read_text()) if path.is_file() else {}


def facts_text(facts, names):
    """One line a replay, in the order of golden.list, so that a difference can be read."""
    lines = [f" {json.dumps(name)}: {json.dumps(facts[name])}" for name in names if name in facts]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def replace(path, content):
    """All or nothing."""
    beside = path.with_name(path.name + ".new")
    beside.write_bytes(content if isinstance(content, bytes) else content.encode())
    os.replace(beside, path)
