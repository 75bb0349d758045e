"""Files of the simulation by a name that stays when they move: the folder that they lie below, and their own name.

game/sim/behaviour/think.cu is game/sim/think.cu here. So lists of files, mutants and reports follow a file wherever it
goes, and a file that a list names and that is nowhere is an error, never nothing.
"""
from pathlib import Path, PurePosixPath

FOLDERS = ("game/sim", "gpu")


def key_of(file):
    """Of a path relative to the sources; any other file is known by its path."""
    for folder in FOLDERS:
        if str(file).startswith(folder + "/"):
            return f"{folder}/{PurePosixPath(file).name}"
    return str(file)


def kernel_files(source):
    """{key: path relative to the sources} of all .cu and .h below those folders; ValueError when two have one key."""
    found = {}
    for folder in FOLDERS:
        for path in sorted((Path(source) / folder).rglob("*")):
            if path.suffix in (".cu", ".h"):
                relative = path.relative_to(source).as_posix()
                other = found.setdefault(key_of(relative), relative)
                if other != relative:
                    raise ValueError(f"{other} and {relative} have the same name: give one of them another")
    return found


def path_of(source, key):
    found = kernel_files(source)
    if key not in found:
        raise ValueError(f"there is no {PurePosixPath(key).name} below {PurePosixPath(key).parent}/: name the file that "
                         "took its place")
    return Path(source) / found[key]
