"""In a build with GW_PTX_MACHINE every kernel body is nvcc's PTX; the C++ compiler made none of them.

What that program computes on its cuda device is then what nvcc compiled, run by tests/ptx_machine. So: the sources of the
cuda device go through nvcc, which makes PTX of them and no more; on the host a kernel is a stub that launches and does
nothing else; and no runtime of NVIDIA's is linked.
"""
import re
import shutil
import subprocess

import gate_tools

STAND_IN = re.compile(r"-DGW_(CUDA_STAND_IN|STAND_IN_KERNELS)\b")
CODE = re.compile(r",code=\[?([\w,]+)")
ENTRY = re.compile(rb"\.entry (\w+)")
FUNCTION = re.compile(r"^[0-9a-f]+ <(.*)>:$")
CALL = re.compile(r"R_X86_64_(?:PLT32|GOTPCRELX?)\s+([\w.$]+)")
# What a stub needs: the launch itself, a static variable that is set once, and the way out when that throws.
LAUNCHES = "__cudaLaunchKernel"
OF_STUBS = re.compile(r"__cuda(GetKernel|PopCallConfiguration|LaunchKernel)$|__cxa_guard_\w+$|_Unwind_Resume$"
                      r"|_Z\w*__device_stub__\w+$|__stack_chk_fail$")
ARITHMETIC = re.compile(r"\t(?:v?(?:add|sub|mul|div|sqrt|max|min)[sp][sd]|v?fn?m(?:add|sub)\w+|i?div|i?mul)\b")
NVIDIA = re.compile(r"\b(cudart\w*::|__cudart\w+|cuLaunchKernel)\b")


def tool(*words):
    if not shutil.which(words[0]):
        raise gate_tools.Skip(f"{words[0]} is missing")
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


def demangled(names):
    return dict(zip(names, tool("c++filt", *names).splitlines())) if names else {}


def functions(built):
    """The code of each function of an object: what objdump writes, by mangled name."""
    code, current = {}, None
    for line in tool("objdump", "-dr", "--no-show-raw-insn", str(built)).splitlines():
        head = FUNCTION.match(line)
        if head:
            current = code.setdefault(head.group(1), [])
        elif current is not None:
            current.append(line)
    return {name: "\n".join(lines) for name, lines in code.items()}


def foreign_commands(commands):
    """What compiles code of the cuda device without being nvcc, or against the stand-in."""
    offences = []
    for command in commands:
        options = " ".join(command.options)
        if STAND_IN.search(options):
            offences.append(f"{command.file.name}: is compiled for the stand-in")
        if command.defines("GW_DEVICE=cuda") and not command.is_cuda:
            offences.append(f"{command.file.name}: code of the cuda device is compiled by {command.compiler}")
        made = [code for codes in CODE.findall(options) for code in codes.split(",")]
        if command.is_cuda and not all(code.startswith("compute_") for code in made):
            offences.append(f"{command.file.name}: is compiled to more than PTX")
    return offences


def bodies(name, built):
    """Kernels of an object that are more on the host than a stub; and how many kernels there are."""
    entries = [entry.decode() for entry in sorted(set(ENTRY.findall(built.read_bytes())))]
    code = functions(built)
    readable = demangled(entries + list(code))
    hosts = {}
    for mangled in code:
        hosts.setdefault(readable[mangled].replace(" [clone .cold]", ""), []).append(mangled)
    offences = []
    for entry in entries:
        parts = hosts.get(readable[entry], [])
        stub = "\n".join(code[part] for part in parts)
        if LAUNCHES not in stub and not any(LAUNCHES in code[c] for c in CALL.findall(stub) if c in code):
            offences.append(f"{name}: the host's {readable[entry]} does not launch the kernel")
        for called in CALL.findall(stub):
            if not OF_STUBS.match(called):
                offences.append(f"{name}: the stub of {readable[entry]} calls {called}")
        if ARITHMETIC.search(stub):
            offences.append(f"{name}: the stub of {readable[entry]} computes")
    return offences, len(entries)


def linked_runtime(program):
    return [f"{program.name}: is linked with a runtime of NVIDIA's"] if NVIDIA.search(tool("nm", "-C", str(program))) \
        else []


def check(source, build):
    cache = build / "CMakeCache.txt"
    if not cache.is_file() or "GW_PTX_MACHINE:BOOL=ON" not in cache.read_text():
        raise gate_tools.Skip("this build is without GW_PTX_MACHINE")
    commands = gate_tools.compile_commands(build)
    offences = foreign_commands(commands)
    kernels, objects = 0, 0
    for command in commands:
        if command.is_cuda and command.object.is_file():
            found, count = bodies(command.file.name, command.object)
            offences += found
            kernels += count
            objects += 1
    program = build / "gpuwars"
    if not program.is_file():
        raise gate_tools.Skip("gpuwars has not been built")
    offences += linked_runtime(program)
    print(f"{kernels} kernels in {objects} objects of nvcc, all of them PTX")
    if kernels == 0:
        offences.append("no object holds a kernel")
    return offences


PLANTED = """#ifdef __CUDACC__
#define KERNEL __global__
#else
#define KERNEL
#endif
KERNEL void planted(float* x) { *x = *x * 3.0f + 1.0f; }
#ifdef __CUDACC__
void launch(float* x) { planted<<<1, 1>>>(x); }
#else
// As if the C++ compiler's kernel had come to stand beside nvcc's PTX.
const char ptx[] = ".entry _Z7plantedPf";
const char* keep() { return ptx; }
#endif
"""


def planted(build, folder):
    commands = [c for c in gate_tools.compile_commands(build) if c.is_cuda]
    if not commands or not any("--no-compress" in c.options for c in commands):
        raise gate_tools.Skip("this build is without GW_PTX_MACHINE")
    file = folder / "planted.cu"
    file.write_text(PLANTED)
    right, wrong = folder / "right.o", folder / "wrong.o"
    subprocess.run([commands[0].compiler, *commands[0].options, "-x", "cu", "-c", str(file), "-o", str(right)],
                   cwd=commands[0].folder, check=True)
    subprocess.run(["c++", "-O2", "-x", "c++", "-c", str(file), "-o", str(wrong)], check=True)
    found, kernels = bodies("right", right)
    escaped = [f"a right object was refused: {o}" for o in found] if kernels == 1 else ["a right object has no kernel"]
    escaped += gate_tools.escaped("compiled as C++", bodies("wrong", wrong)[0], ["does not launch", "computes"])

    def command(words):
        return gate_tools.CompileCommand({"directory": str(folder), "file": str(file), "arguments": words})

    escaped += gate_tools.escaped(
        "commands",
        foreign_commands([command(["c++", "-DGW_DEVICE=cuda", "-c", str(file)]),
                          command(["c++", "-DGW_CUDA_STAND_IN=1", "-c", str(file)]),
                          command(["nvcc", "-DGW_DEVICE=cuda", "--generate-code=arch=compute_90,code=[compute_90,sm_90]",
                                   "-c", str(file)])]),
        ["compiled by c++", "for the stand-in", "more than PTX"])
    return escaped


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
