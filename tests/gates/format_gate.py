"""Every C++ file is laid out as clang-format does by .clang-format."""
import shutil
import subprocess
from pathlib import Path

import gate_tools
import llvm_tools

CHUNK = 100  # files per process


def unformatted(source, names):
    """file:line of each violation."""
    program = llvm_tools.tool("clang-format")

    def look(chunk):
        run = subprocess.run([program, "--dry-run", "--style=file", *chunk], cwd=source, capture_output=True, text=True,
                             check=False)
        if run.returncode != 0:
            return [run.stderr.strip()]
        return [":".join(line.split(":")[:2]) + ": is not laid out as clang-format does"
                for line in run.stderr.splitlines() if "[-Wclang-format-violations]" in line]

    chunks = [names[start:start + CHUNK] for start in range(0, len(names), CHUNK)]
    return gate_tools.in_parallel(look, chunks)


def sources(source):
    return [name for name in gate_tools.repository_files(source) if name.endswith(gate_tools.SOURCE_SUFFIXES)]


def check(source, _build):
    names = sources(source)
    offences = sorted(set(unformatted(source, names)))
    print(f"{len(names)} files looked at")
    if not names:
        offences.append("no file was found")
    elif offences:
        offences.append(f"clang-format-{llvm_tools.MAJOR} -i on these files repairs them")
    return offences


def planted(_build, folder):
    shutil.copy(Path(__file__).resolve().parents[2] / ".clang-format", folder)
    refused = {"indent.h": "#pragma once\nstruct S {\n    int a;\n};\n", "brace.cpp": "int f()\n{\n  return 1;\n}\n",
               "wide.cu": "// " + "word " * 30 + "\n"}
    allowed = {"plain.cpp": "int f() {\n  return 1;\n}\n"}
    for name, text in (refused | allowed).items():
        (folder / name).write_text(text)
    offences = unformatted(folder, sorted(refused | allowed))
    escaped = gate_tools.escaped("planted layout", offences, [f"{name}:" for name in refused])
    return escaped + [f"refused for nothing: {o}" for o in offences if o.startswith("plain.cpp")]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
