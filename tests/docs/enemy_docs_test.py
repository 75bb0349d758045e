#!/usr/bin/env python3
"""Changed tables make docs/reference/enemies.md stale, and the check says so.

    enemy_docs_test.py MAKE_ENEMY_DOCS DESCRIBE_ENEMIES ASSETS
"""
import copy
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

make, describe, assets = map(Path, sys.argv[1:4])
sys.path.insert(0, str(make.parent))
import state_diagram  # noqa: E402

failures = 0


def want(good, sentence):
    global failures
    print(("ok    " if good else "FAIL  ") + sentence, flush=True)
    failures += not good


def refused(machine, rows):
    try:
        state_diagram.diagram(machine, rows)
    except ValueError:
        return True
    return False


with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(assets, folder, dirs_exist_ok=True)
    table = Path(folder) / "enemies.toml"
    text = table.read_text()
    table.write_text(text.replace("speed_mps = 7\n", "speed_mps = 7.5\n", 1))
    check = subprocess.run([sys.executable, make, describe, "--assets", folder, "--check"], stderr=subprocess.PIPE,
                           text=True, check=False)
    want(table.read_text() != text and check.returncode == 1, "a faster triangle makes the page stale")
    want("docs/reference/enemies.md is not what the tables say; run tools/make_enemy_docs.py" in check.stderr,
         "and the message names what refreshes it")

machines = json.loads(subprocess.run([describe, assets], stdout=subprocess.PIPE, check=True).stdout)["machines"]
for machine, rows in machines.items():
    want(not refused(machine, rows), f"{machine} is drawn")
    for index in range(len(rows)):
        want(refused(machine, rows[:index] + rows[index + 1:]), f"{machine} without row {index + 1} is not drawn")
    other = copy.deepcopy(rows)
    other[-1]["needs"] = ["damaged"]
    want(state_diagram.diagram(machine, other) != state_diagram.diagram(machine, rows), f"{machine} with another condition differs")
    other[-1]["to"] = "dead"
    want(refused(machine, other), f"{machine} with another edge is not drawn")
want(refused("zombie", []), "a machine without a layout is not drawn")
sys.exit(1 if failures else 0)
