"""What the gates share: the command line, the source tree, and the project's own compile commands.

A gate exits 0 when the tree is clean, 1 with one line per offence, and 77 (skipped, never passed) when
this machine lacks the compiler it looks at. With --planted it runs on an offender made for the purpose
instead, and exits 0 only if it catches it.
"""
import argparse
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SKIPPED = 77
SIMULATION_FOLDERS = ("gpu", "game/sim", "game/autopilot")
SOURCE_SUFFIXES = (".h", ".cpp", ".cu", ".cuh", ".hpp", ".c", ".cc")
JOBS = 2


class Skip(Exception):
    """This machine lacks what the gate looks at; the text says what."""


def run_gate(check, planted):
    """check(source, build) returns offences; planted(build, folder) returns how offenders escaped it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--planted", action="store_true")
    arguments = parser.parse_args()
    source, build = arguments.source.resolve(), arguments.build.resolve()
    try:
        if arguments.planted:
            with tempfile.TemporaryDirectory() as folder:
                offences = planted(build, Path(folder))
        else:
            offences = check(source, build)
    except Skip as reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    for offence in offences:
        print(offence)
    print("refused" if offences else "clean" if not arguments.planted else "the planted offenders were caught")
    sys.exit(1 if offences else 0)


def escaped(what, offences, expected):
    """For planted(): one line per expected text that no offence holds."""
    return [f"{what}: not caught: {text}" for text in expected if not any(text in o for o in offences)]


def repository_files(source):
    """Relative paths of what git tracks or would track; without git, everything but build outputs."""
    if (source / ".git").exists() and shutil.which("git"):
        listed = subprocess.run(
            ["git", "-c", "safe.directory=*", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=source, capture_output=True, check=False)
        if listed.returncode == 0:
            names = sorted(set(listed.stdout.decode().split("\0")) - {""})
            return [name for name in names if (source / name).is_file()]
    found = []
    for folder, folders, files in os.walk(source):
        if Path(folder) == source:
            folders[:] = [name for name in folders if name not in ("build", "out", ".git")]
        found += [str((Path(folder) / name).relative_to(source)) for name in files]
    return sorted(found)


def source_files(source, folders):
    return [name for name in repository_files(source)
            if name.endswith(SOURCE_SUFFIXES) and any(name.startswith(folder + "/") for folder in folders)]


def without_comments_and_strings(text):
    """The same text with comments and literals blanked, so that line numbers stay."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)

    def blank(match):
        # A quote between digits separates them: 1'000'000.
        return re.sub(r"[^\n]", " ", match.group())

    return pattern.sub(blank, re.sub(r"(?<=\d)'(?=\d)", "", text))


class CompileCommand:
    """One entry of compile_commands.json, without the compiler cache in front and without its outputs."""

    def __init__(self, entry):
        self.folder = Path(entry["directory"])
        self.file = Path(entry["file"])
        words = shlex.split(entry["command"]) if "command" in entry else list(entry["arguments"])
        while Path(words[0]).name in ("env", "ccache", "sccache") or re.match(r"\w+=", words[0]):
            words = words[1:]
        self.compiler = words[0]
        self.object = None
        self.options = []
        index = 1
        while index < len(words):
            word = words[index]
            if word == "-o":
                self.object = self.folder / words[index + 1]
                index += 1
            elif word in ("-MF", "-MT", "-MQ", "-x"):
                index += 1
            elif word in ("-c", "-dc", "-MD", "-MMD") or (self.folder / word) == self.file:
                pass
            else:
                self.options.append(word)
            index += 1

    @property
    def is_cuda(self):
        return Path(self.compiler).name.startswith("nvcc")

    def defines(self, text):
        return f"-D{text}" in self.options


def compile_commands(build):
    path = build / "compile_commands.json"
    if not path.is_file():
        raise Skip(f"{path.name} is not in the build folder")
    return [CompileCommand(entry) for entry in json.loads(path.read_text())]


def in_simulation(path, source):
    try:
        relative = path.resolve().relative_to(source).as_posix()
    except ValueError:
        return False
    return any(relative.startswith(folder + "/") for folder in SIMULATION_FOLDERS)


def cuda_kernel_commands(source, build):
    """The nvcc commands of the simulation's files; no such file may be missing."""
    commands = [c for c in compile_commands(build) if c.is_cuda and in_simulation(c.file, source)]
    if not commands:
        raise Skip("this build has no CUDA files (nvcc is missing or GW_CUDA is off)")
    built = {c.file.resolve().relative_to(source).as_posix() for c in commands}
    forgotten = [name for name in source_files(source, SIMULATION_FOLDERS)
                 if name.endswith(".cu") and name not in built]
    return commands, [f"{name}: is not compiled for CUDA by this build" for name in forgotten]


def cpu_kernel_commands(source, build):
    """The C++ commands of the same files, which go through one-line stubs named <file>.cu.cpp."""
    commands = [c for c in compile_commands(build)
                if c.file.name.endswith(".cu.cpp") and c.defines("GW_DEVICE=cpu")]
    if not commands:
        raise Skip("this build has no kernel files")
    built = set()
    for command in commands:
        included = re.search(r'#include "([^"]+)"', command.file.read_text())
        if included and in_simulation(Path(included.group(1)), source):
            built.add(Path(included.group(1)).resolve().relative_to(source).as_posix())
    forgotten = [name for name in source_files(source, SIMULATION_FOLDERS)
                 if name.endswith(".cu") and name not in built]
    return commands, [f"{name}: is not compiled for the cpu device by this build" for name in forgotten]


def _digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


class CompileCache:
    """Compiles into <build>/gates/<name>, and again only when the command or a file it read has changed."""

    def __init__(self, build, name):
        self.folder = build / "gates" / name
        self.folder.mkdir(parents=True, exist_ok=True)

    def output(self, words, key, suffix, folder):
        """Runs `words -MD -MF <dependencies> -o <output>` and returns the output's path."""
        output = self.folder / (hashlib.sha256(key.encode()).hexdigest()[:16] + suffix)
        manifest = output.with_suffix(".json")
        if output.is_file() and manifest.is_file():
            record = json.loads(manifest.read_text())
            if record["words"] == words and all(
                    Path(path).is_file() and _digest(Path(path)) == digest
                    for path, digest in record["inputs"].items()):
                return output
        manifest.unlink(missing_ok=True)
        dependencies = output.with_suffix(".d")
        run = subprocess.run([*words, "-MD", "-MF", str(dependencies), "-o", str(output)],
                             cwd=folder, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise RuntimeError(f"{key}: does not compile:\n{run.stderr}")
        listed = dependencies.read_text().split(":", 1)[1].replace("\\\n", " ").split()
        inputs = {str(Path(folder) / name): _digest(Path(folder) / name) for name in listed}
        manifest.write_text(json.dumps({"words": words, "inputs": inputs}))
        return output


def in_parallel(function, items):
    """function(item) returns a list of offences; JOBS at a time, in the order of the items."""
    def guarded(item):
        try:
            return function(item)
        except RuntimeError as error:
            return [str(error)]
    with ThreadPoolExecutor(JOBS) as pool:
        return [offence for offences in pool.map(guarded, items) for offence in offences]
