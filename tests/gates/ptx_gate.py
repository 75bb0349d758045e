"""Refuses contracted, approximate or order-dependent float operations in the simulation's PTX.

Every simulation .cu is compiled to PTX with the project's own flags. An FMA inside an IEEE division or
square root exists only in SASS, so PTX has to be free of them altogether.
"""
import re

import gate_tools

REFUSED = [
    (re.compile(r"^(fma|mad)\.(?!lo|hi|wide)"), "contracted multiply-add"),
    (re.compile(r"\.approx\b"), "approximate instruction"),
    (re.compile(r"\.ftz\b"), "flush to zero"),
    (re.compile(r"^(atom|red)\..*\bf(16|16x2|32|64)\b"), "float atomic"),
]
# An instruction, after an optional label or guard: "@%p1 bra", "fma.rn.f32 %f1, ...".
INSTRUCTION = re.compile(r"^\s*(?:@!?%\w+\s+)?([a-z]\w*(?:\.[\w:]+)+)", re.MULTILINE)


def ptx_of(command, cache, file, options):
    kept = [option for option in options if not option.startswith(("--generate-code", "-gencode", "-arch"))]
    words = [command.compiler, *kept, "-x", "cu", "-ptx", "-arch=sm_90", str(file)]
    return cache.output(words, str(file), ".ptx", command.folder).read_text()


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
    entries = [0]

    def look(command):
        ptx = ptx_of(command, cache, command.file, command.options)
        entries[0] += ptx.count(".entry")
        return offences_in(command.file.resolve().relative_to(source).as_posix(), ptx)

    offences += gate_tools.in_parallel(look, commands)
    print(f"{len(commands)} files, {entries[0]} kernels looked at")
    if entries[0] == 0:
        offences.append("no kernel in any PTX: the gate looked at nothing")
    return offences


KERNEL = """
__global__ void planted(float* y, const float* x, float a) {{ {body} }}
"""


def planted(build, folder):
    commands = [c for c in gate_tools.compile_commands(build) if c.is_cuda]
    if not commands:
        raise gate_tools.Skip("this build has no CUDA files (nvcc is missing or GW_CUDA is off)")
    command = commands[0]
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

    def look(case):
        name, body, options, expected = case
        file = folder / f"{name}.cu"
        file.write_text(KERNEL.format(body=body))
        if name == "flushed":
            options = [o for o in options if o != "--ftz=false"]
        offences = offences_in(name, ptx_of(command, cache, file, options))
        if not expected:
            return [f"a clean kernel was refused: {offence}" for offence in offences]
        return gate_tools.escaped(name, offences, expected)

    return gate_tools.in_parallel(look, cases)


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
