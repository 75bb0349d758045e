#!/usr/bin/env python3
"""Two builds of the preset `package`, in folders of different names and without a compiler cache, give the same bytes;
nothing in the packages names a folder that they were built in.

    deb_reproducible.py SOURCE FOLDER [cmake options...]
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "gates"))
import deb_tools  # noqa: E402
import gate_tools  # noqa: E402
from program import Failures, skip  # noqa: E402

UNLIKE = {"a": {"TZ": "UTC", "LC_ALL": "C"}, "another_and_longer": {"TZ": "Asia/Kathmandu", "LC_ALL": "C.UTF-8"}}


def copied(source, folder):
    """What git knows of the tree, and nothing built."""
    for name in gate_tools.repository_files(source):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source / name, folder / name)
    return folder


def packages(tree, environment, options):
    environment = {**os.environ, **environment, "CCACHE_DISABLE": "1"}
    for command in (["cmake", "--preset", "package", *options], ["cmake", "--build", "--preset", "package"]):
        subprocess.run(command, cwd=tree, env=environment, stdout=subprocess.DEVNULL, check=True)
    return {path.name: path for path in (tree / "build/package").glob("*.deb")}


def main():
    source, folder, *options = sys.argv[1:]
    source, folder = Path(source).resolve(), Path(folder).resolve()
    if deb_tools.missing_tools():
        skip(f"packages cannot be made here without {', '.join(deb_tools.missing_tools())}")
    failures = Failures()
    shutil.rmtree(folder, ignore_errors=True)
    made = {}
    for name, environment in UNLIKE.items():
        made[name] = packages(copied(source, folder / name), environment, options)
    one, other = made.values()
    failures.check(len(one) == 2 and one.keys() == other.keys(), f"two packages, twice: {sorted(one)} {sorted(other)}")
    for name in one.keys() & other.keys():
        failures.check(one[name].read_bytes() == other[name].read_bytes(), f"{name}: the same bytes")
        root = deb_tools.unpack(one[name], folder / "unpacked")
        naming = [path.relative_to(root).as_posix() for path in root.rglob("*")
                  if path.is_file() and bytes(folder) in path.read_bytes()]
        failures.check(not naming, f"{name}: names no folder of the build: {naming}")
    failures.finish()


if __name__ == "__main__":
    main()
