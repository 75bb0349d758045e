"""The committed sounds are what tools/make_sounds.py makes, byte for byte."""
import subprocess
import sys
import tempfile
from pathlib import Path

import gate_tools

GENERATOR = "tools/make_sounds.py"
SOUNDS = "assets/sounds"


def check(source, _build):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.executable, str(source / GENERATOR), folder], capture_output=True, text=True)
        if run.returncode != 0:
            return [f"{GENERATOR} failed: {run.stderr.strip()}"]
        made = {path.name: path.read_bytes() for path in Path(folder).iterdir()}
    kept = {path.name: path.read_bytes() for path in (source / SOUNDS).iterdir()}
    offences = [f"{SOUNDS}/{name}: {GENERATOR} does not make it" for name in sorted(kept.keys() - made.keys())]
    offences += [f"{SOUNDS}/{name}: is missing" for name in sorted(made.keys() - kept.keys())]
    offences += [f"{SOUNDS}/{name}: differs from what {GENERATOR} makes"
                 for name in sorted(made.keys() & kept.keys()) if made[name] != kept[name]]
    print(f"{len(made)} sounds made")
    if not made:
        offences.append("no sound was made")
    return offences


def planted(build, folder):
    (folder / "tools").mkdir()
    (folder / SOUNDS).mkdir(parents=True)
    (folder / GENERATOR).write_text(
        "import sys\nfrom pathlib import Path\n"
        "for name in ('same', 'changed', 'forgotten'):\n"
        "    (Path(sys.argv[1]) / f'{name}.wav').write_bytes(name.encode())\n")
    for name, text in (("same", b"same"), ("changed", b"changeD"), ("foreign", b"foreign")):
        (folder / SOUNDS / f"{name}.wav").write_bytes(text)
    offences = check(folder, build)
    escaped = gate_tools.escaped("planted sound", offences, ["changed.wav: differs", "forgotten.wav: is missing",
                                                             "foreign.wav: "])
    if len(offences) != 3:
        escaped.append(f"3 offences were planted, {len(offences)} reported: {offences}")
    (folder / GENERATOR).write_text("raise SystemExit('broken')\n")
    return escaped + gate_tools.escaped("broken generator", check(folder, build), ["failed: broken"])


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
