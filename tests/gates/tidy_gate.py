"""clang-tidy finds nothing of the list in .clang-tidy: in files that a change touches, or with --all in every file.

Without --all those are what differs from origin/main, or on it from the commit before, and what is not committed. A header is
looked at through a source file of its folder, a kernel file through the C++ that includes it.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import gate_tools
import llvm_tools

AT_MOST = 24  # changed files: more take minutes, and ./check --full looks at all
# Options of g++ that clang does not know, and its precompiled headers, which clang cannot read.
LEFT_OUT = re.compile(r"-Winvalid-pch|-Wno-restrict|-fno-tree-.*|-march=native")
WARNING = re.compile(r"^(/[^:]+):(\d+):\d+: (?:warning|error): (.*)$")


def git(source, *words):
    run = subprocess.run(["git", "-c", "safe.directory=*", *words], cwd=source, capture_output=True, text=True, check=False)
    return run.stdout.split("\n")[:-1] if run.returncode == 0 else None


def changed_files(source):
    """Relative paths; raises Skip where git cannot tell."""
    if not (source / ".git").exists() or not shutil.which("git"):
        raise gate_tools.Skip("git does not tell here what has changed")
    head = git(source, "rev-parse", "HEAD")
    base = git(source, "merge-base", "HEAD", "origin/main") or head
    if base == head:
        base = git(source, "rev-parse", "HEAD~1") or head
    if not base:
        raise gate_tools.Skip("git does not tell here what has changed")
    names = (git(source, "diff", "--name-only", "--diff-filter=d", base[0]) or []) + \
            (git(source, "ls-files", "--others", "--exclude-standard") or [])
    return sorted({name for name in names if name.endswith(gate_tools.SOURCE_SUFFIXES) and (source / name).is_file()})


def compiled_files(source, build):
    """{relative path: its C++ command}; kernels under the name of their .cu file."""
    found = {}
    for command in gate_tools.compile_commands(build):
        if command.is_cuda:
            continue
        path = command.file
        if path.name.endswith(".cu.cpp"):
            included = re.search(r'#include "([^"]+)"', path.read_text()) if path.is_file() else None
            if not included or not command.defines("GW_DEVICE=cpu"):
                continue
            path = Path(included.group(1))
        if path.resolve().is_relative_to(source) and not path.resolve().is_relative_to(build):
            found.setdefault(path.resolve().relative_to(source).as_posix(), command)
    return found


def command_for(name, compiled):
    """A header goes by a file near it; none where nothing of its folder is compiled."""
    if name in compiled:
        return compiled[name]
    stem, folder = Path(name).stem, str(Path(name).parent)
    near = [n for n in compiled if str(Path(n).parent) == folder]
    while not near and "/" in folder:
        folder = str(Path(folder).parent)
        near = [n for n in compiled if n.startswith(folder + "/")]
    return compiled[min(near, key=lambda n: (Path(n).stem != stem, n))] if near else None


def options_of(command):
    options, skip = [], False
    for index, word in enumerate(command.options):
        if skip:
            skip = False
        elif word == "-include" and command.options[index + 1].endswith("cmake_pch.hxx"):
            skip = True
        elif not LEFT_OUT.match(word):
            options.append(word)
    return options + ["-Wno-unknown-warning-option"]


def findings(source, name, command, headers):
    """What clang-tidy says of one file, and of the headers it includes whose path matches `headers`."""
    path = source / name
    kernel = name.endswith(".cu")
    looked_at = command.file if kernel else path
    run = subprocess.run(
        [llvm_tools.tool("clang-tidy"), "--quiet", f"--config-file={source / '.clang-tidy'}", f"--header-filter={headers}",
         str(looked_at), "--", *(["-x", "c++"] if name.endswith(".h") else []), *options_of(command)],
        cwd=command.folder, capture_output=True, text=True, check=False)
    found = []
    for line in run.stdout.splitlines():
        match = WARNING.match(line)
        if match:
            where = Path(os.path.normpath(match.group(1)))
            shown = where.relative_to(source) if where.is_relative_to(source) else where
            found.append(f"{shown}:{match.group(2)}: {match.group(3)}")
    if run.returncode != 0 and not found:
        found.append(f"{name}: clang-tidy failed: {run.stderr.strip()[-500:]}")
    return found


def look_at(source, build, names, headers=None):
    """`headers`: which included files are judged with a file; none but itself unless told."""
    compiled = compiled_files(source, build)
    commands = [(name, command_for(name, compiled)) for name in names]

    def look(item):
        name, command = item
        return findings(source, name, command, headers or re.escape(str(source / name)) + "$")

    seen = [item for item in commands if item[1]]
    offences = sorted(set(gate_tools.in_parallel(look, seen)))
    print(f"{len(seen)} files looked at, {len(names) - len(seen)} that this build does not compile")
    return offences


def check(source, build):
    llvm_tools.tool("clang-tidy")
    names = changed_files(source)
    if len(names) > AT_MOST:
        raise gate_tools.Skip(f"{len(names)} files have changed; ./check --full looks at all files")
    return look_at(source, build, names)


def check_all(source, build):
    llvm_tools.tool("clang-tidy")
    return look_at(source, build, sorted(compiled_files(source, build)),
                   f"^{re.escape(str(source))}/(gpu|render|host|game|labs|bench|tests)/.*")


PLANTED = """#include <memory>
#include <mutex>
#include <utility>
std::mutex guard;
std::unique_ptr<int> taken;
int afterMove(std::unique_ptr<int> number) {
  taken = std::move(number);
  return *number;
}
void unlocked() {
  std::lock_guard<std::mutex>{guard};
  taken.reset();
}
"""


def planted(build, folder):
    (folder / "planted.cpp").write_text(PLANTED)
    (folder / "plain.cpp").write_text("int twice(int number) { return 2 * number; }\n")
    shutil.copy(Path(__file__).resolve().parents[2] / ".clang-tidy", folder)
    entry = {"directory": str(folder), "arguments": ["c++", "-std=c++20", "-c"]}
    commands = {name: gate_tools.CompileCommand(entry | {"file": str(folder / name)}) for name in ("planted.cpp", "plain.cpp")}
    offences = [o for name in commands for o in findings(folder, name, commands[name], "$^")]
    escaped = gate_tools.escaped("planted fault", offences, ["planted.cpp:8:", "planted.cpp:11:"])
    return escaped + [f"refused for nothing: {o}" for o in offences if "plain.cpp" in o]


if __name__ == "__main__":
    everything = "--all" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--all"]
    gate_tools.run_gate(check_all if everything else check, planted)
