"""Records a golden replay as its line in golden.list says, and tells what is new in it."""
import shlex
import subprocess
import tempfile
from pathlib import Path

from golden_suite import ROOT, look_closer, replay_facts, shortcomings, tool, verify
from table_options import with_tables


def command_of(gpuwars, golden, options, kept, fresh):
    """`options`: those of the line, tables already changed."""
    if golden.person:
        return [tool(gpuwars, "replay_again"), kept.resolve(), fresh, "--assets", ROOT / "assets"]
    program = [Path(gpuwars).resolve()]
    if golden.script:
        program, options = [tool(gpuwars, "play_script"), golden.script], options[2:]
    return [*program, "--headless", "--device", "cpu", *options, "--record", fresh]


def record(gpuwars, golden, options, kept, fresh, expectation):
    """Records `fresh` with all threads and verifies with one, so that no replay is golden that depends on them.
    Returns what the recording lacks, and its facts. Paths in its command line are relative, for the replay keeps them."""
    with tempfile.TemporaryDirectory() as scratch:
        options = with_tables(options, ROOT / "assets", Path(scratch), "assets")
        command = [str(part) for part in command_of(gpuwars, golden, options, kept, fresh.name)]
        result = subprocess.run(command, cwd=scratch, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                check=False)
        if result.returncode != 0:
            raise ValueError(f"{golden.name}: {shlex.join(command)} failed ({result.returncode}):\n{result.stdout}")
        fresh.write_bytes((Path(scratch) / fresh.name).read_bytes())
    facts = verify(gpuwars, [fresh], 1, ["--threads", "1", *golden.verified])[0]
    if facts["equal"]:
        look_closer(gpuwars, fresh, expectation, facts)
    return shortcomings(golden.name, expectation, facts), facts


def other_seeds(options, count):
    """The same options with each of the next seeds."""
    at = options.index("--seed") + 1
    for seed in range(int(options[at]) + 1, int(options[at]) + 1 + count):
        yield [*options[:at], str(seed), *options[at + 1:]]


def first_difference(old, new):
    """The first tick whose hash differs, or that only one of them has; None: there is none."""
    for tick, (a, b) in enumerate(zip(old, new), 1):
        if a != b:
            return tick
    return None if len(old) == len(new) else min(len(old), len(new)) + 1


def hashes_of(gpuwars, file):
    return replay_facts(gpuwars, file, "--hashes")["hashes"]


def changes(old, new):
    """What facts tell otherwise, `key old -> new`, kills by type among them."""
    told = []
    for key in ("ticks", "ending", "score", "kills", "contacts", "bitsTaken", "peakEnemies", "refused"):
        if old.get(key) != new[key]:
            told.append(f"{key} {old.get(key)} -> {new[key]}")
    types = [f"{name} {old.get('killsByType', {}).get(name, 0)} -> {count}" for name, count in new["killsByType"].items()
             if old.get("killsByType", {}).get(name, 0) != count]
    return told + ([f"kills by type: {', '.join(types)}"] if types else [])
