"""Committed files that a script of tools/ makes: that they are what it makes, and that a difference is found."""
import subprocess
import sys
import tempfile
from pathlib import Path

import gate_tools


def files_below(folder):
    return {path.relative_to(folder).as_posix(): path for path in folder.rglob("*") if path.is_file()}


def check(source, generator, kept_in, what, content=Path.read_bytes):
    """Offences; `content(path)` gives what has to be equal of a file."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.executable, str(source / generator), folder], capture_output=True, text=True)
        if run.returncode != 0:
            return [f"{generator} failed: {run.stderr.strip()}"]
        made = {name: content(path) for name, path in files_below(Path(folder)).items()}
    kept = {name: content(path) for name, path in files_below(source / kept_in).items()}
    offences = [f"{kept_in}/{name}: {generator} does not make it" for name in sorted(kept.keys() - made.keys())]
    offences += [f"{kept_in}/{name}: is missing" for name in sorted(made.keys() - kept.keys())]
    offences += [f"{kept_in}/{name}: differs from what {generator} makes"
                 for name in sorted(made.keys() & kept.keys()) if made[name] != kept[name]]
    print(f"{len(made)} {what} made")
    if not made:
        offences.append(f"no {what} was made")
    return offences


def planted(folder, generator, kept_in, look):
    """How offenders of every kind escaped look(source)."""
    (folder / generator).parent.mkdir(parents=True)
    (folder / kept_in).mkdir(parents=True)
    (folder / generator).write_text(
        "import sys\nfrom pathlib import Path\n"
        "for name in ('same', 'changed', 'forgotten'):\n"
        "    (Path(sys.argv[1]) / f'{name}.wav').write_bytes(name.encode())\n")
    for name, text in (("same", b"same"), ("changed", b"changeD"), ("foreign", b"foreign")):
        (folder / kept_in / f"{name}.wav").write_bytes(text)
    offences = look(folder)
    escaped = gate_tools.escaped("planted file", offences, ["changed.wav: differs", "forgotten.wav: is missing",
                                                            "foreign.wav: "])
    if len(offences) != 3:
        escaped.append(f"3 offences were planted, {len(offences)} reported: {offences}")
    (folder / generator).write_text("raise SystemExit('broken')\n")
    return escaped + gate_tools.escaped("broken generator", look(folder), ["failed: broken"])
