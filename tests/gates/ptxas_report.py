"""bench/results/ptxas.md: every kernel's registers and spills, written and read.

    python3 tests/gates/ptxas_report.py --source . --build build/release --write

Without --write it prints the report. tests/gates/ptxas_gate.py compares the committed one with the code.
"""
import argparse
import dataclasses
import re
import sys
from pathlib import Path

import gate_tools
import kernel_ptx
import ptxas

PLACE = "bench/results/ptxas.md"
REMEDY = "run python3 tests/gates/ptxas_report.py --write"
COLUMNS = [field.name.replace("_", " ") for field in dataclasses.fields(ptxas.Usage)]


def is_cub(key):
    return key[0] in ptxas.CUB_FILES


def table(found):
    lines = [f"| file | kernel | {' | '.join(COLUMNS)} |", "|---|---|" + "---|" * len(COLUMNS)]
    for (file, kernel), usages in sorted(found.items()):
        columns = zip(*(dataclasses.astuple(usages[a]) for a in kernel_ptx.ARCHITECTURES))
        lines.append(f"| {file} | `{kernel}` | " + " | ".join(" / ".join(map(str, cell)) for cell in columns) + " |")
    return "\n".join(lines)


def written(version, found):
    own = {key: usages for key, usages in found.items() if not is_cub(key)}
    cub = {key: usages for key, usages in found.items() if is_cub(key)}
    architectures = " / ".join(kernel_ptx.ARCHITECTURES)
    most = {a: max(own.items(), key=lambda item: item[1][a].registers) for a in kernel_ptx.ARCHITECTURES}
    needs = "; ".join(f"{usages[a].registers} on {a} (`{key[1]}`)" for a, (key, usages) in most.items())
    return f"""# Registers and spills

Every kernel of the simulation as ptxas builds it with the project's own flags. nvcc {version}; no GPU took part.
`{REMEDY.removeprefix("run ")} --source . --build build/release` writes this file; a gate says when it is out of date.

Each cell holds {architectures}. All but the registers are bytes. Shared memory is what a kernel declares: teams ask for
theirs at launch. Constants are the parameters and what the architecture keeps before them. A stack without spills holds
arrays that are indexed at run time.

{len(own)} kernels of our own. The most registers: {needs}.

{table(own)}

## CUB's

Of the radix sort in `{ptxas.CUB_FILES[0]}`; not ours to change, so the gate looks at their names only.

{table(cub)}
"""


def read(text):
    """(version, {(file, kernel): {architecture: Usage}}) of a report."""
    version = re.search(r"nvcc ([\d.]+);", text)
    found = {}
    for file, kernel, cells in re.findall(r"^\| (\S+\.cu) \| `([^`]+)` \| (.*) \|$", text, re.MULTILINE):
        columns = [[int(number) for number in cell.split(" / ")] for cell in cells.split(" | ")]
        found[file, kernel] = {a: ptxas.Usage(*numbers) for a, numbers in zip(kernel_ptx.ARCHITECTURES, zip(*columns))}
    return version.group(1) if version else None, found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--write", action="store_true", help=f"into {PLACE} instead of stdout")
    arguments = parser.parse_args()
    source = arguments.source.resolve()
    try:
        version, found, offences = ptxas.collect(source, arguments.build.resolve())
    except gate_tools.Skip as reason:
        sys.exit(f"There is nothing to report: {reason}.")
    if offences:
        sys.exit("\n".join(offences))
    if arguments.write:
        (source / PLACE).write_text(written(version, found))
    else:
        print(written(version, found), end="")


if __name__ == "__main__":
    main()
