"""Refuses contracted, approximate or order-dependent float operations in the simulation's PTX.

Every simulation .cu is compiled to PTX with the project's own flags, for each architecture of kernel_ptx.py.
An FMA inside an IEEE division or square root exists only in SASS, so PTX has to be free of them altogether.
"""
import itertools
import re

import gate_tools
import kernel_ptx

REFUSED = [
    (re.compile(r"^(fma|mad)\.(?!lo|hi|wide)"), "contracted multiply-add"),
    (re.compile(r"\.approx\b"), "approximate instruction"),
    (re.compile(r"\.ftz\b"), "flush to zero"),
    (re.compile(r"^(atom|red)\..*\bf(16|16x2|32|64)\b"), "float atomic"),
]
# An instruction, after an optional label or guard: "@%p1 bra", "fma.rn.f32 %f1, ...".
INSTRUCTION = re.compile(r"^\s*(?:@!?%\w+\s+)?([a-z]\w*(?:\.[\w:]+)+)", re.MULTILINE)


def offences_in(name, ptx):
    found = {}
    for instruction in INSTRUCTION.findall(ptx):
        for pattern, why in REFUSED:
            if pattern.search(instruction):
                found[instruction, why] = found.get((instruction, why), 0) + 1
    offences = [f"{name}: {why}: {instruction} ({count} times)" for (instruction, why), count in found.items()]
    if ".version" not in ptx:
        offences.append(f"{name}: this is not PTX")
    return offences


def check(source, build):
    commands, offences = gate_tools.cuda_kernel_commands(source, build)
    cache = gate_tools.CompileCache(build, "ptx")
    entries = dict.fromkeys(kernel_ptx.ARCHITECTURES, 0)

    def look(pair):
        command, architecture = pair
        ptx = kernel_ptx.ptx_of(command, cache, command.file, command.options, architecture).read_text()
        entries[architecture] += ptx.count(".entry")
        name = command.file.resolve().relative_to(source).as_posix()
        return offences_in(f"{name} for {architecture}", ptx)

    offences += gate_tools.in_parallel(look, itertools.product(commands, kernel_ptx.ARCHITECTURES))
    print(f"{len(commands)} files, " +
          ", ".join(f"{count} kernels for {architecture} looked at" for architecture, count in entries.items()))
    return offences + [f"no kernel in any PTX for {architecture}: the gate looked at nothing"
                       for architecture, count in entries.items() if count == 0]


KERNEL = """
__global__ void planted(float* y, const float* x, float a) {{ {body} }}
"""


def planted(build, folder):
    command = kernel_ptx.any_cuda_command(build)
    cache = gate_tools.CompileCache(folder, "ptx")
    contracted = [o for o in command.options if not o.startswith(("--fmad", "-fmad"))]
    cases = [  # name, body, options, what has to be caught (nothing: has to pass)
        ("clean", "y[0] = a * x[0] / y[0] + sqrtf(x[1]);", command.options, []),
        ("fmad", "y[0] = a * x[0] + y[0];", contracted, ["contracted multiply-add"]),
        ("sine", "y[0] = sinf(x[0]);", command.options, ["contracted multiply-add"]),
        ("approximate", "y[0] = __fdividef(a, x[0]);", command.options, ["approximate instruction"]),
        ("flushed", "y[0] = a * x[0];", [*command.options, "--ftz=true"], ["flush to zero"]),
        ("atomic", "atomicAdd(y, x[0]);", command.options, ["float atomic"]),
    ]

    def look(pair):
        (name, body, options, expected), architecture = pair
        file = folder / f"{name}_{architecture}.cu"
        file.write_text(KERNEL.format(body=body))
        if name == "flushed":
            options = [o for o in options if o != "--ftz=false"]
        offences = offences_in(name, kernel_ptx.ptx_of(command, cache, file, options, architecture).read_text())
        if not expected:
            return [f"a clean kernel was refused: {offence}" for offence in offences]
        return gate_tools.escaped(f"{name} for {architecture}", offences, expected)

    return gate_tools.in_parallel(look, itertools.product(cases, kernel_ptx.ARCHITECTURES))


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
