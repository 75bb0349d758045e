"""The CUDA libraries really hold kernels, and the cpu ones hold none.

One CMake folder with both kinds once compiled everything as C++ without a word; this is how it shows.
"""
import re
import shutil
import subprocess

import gate_tools

LAUNCHES = re.compile(r"\bforEach(?:Team)?\s*(?:<[^;]*?>)?\s*\(|__global__|<<<")
REGISTERS = re.compile(r"__cudaRegisterFunction|__device_stub")


def symbols(built):
    if not shutil.which("nm"):
        raise gate_tools.Skip("nm is missing")
    return subprocess.run(["nm", str(built)], capture_output=True, text=True, check=True).stdout


def missing_kernels(name, text, built):
    """For a file compiled as CUDA whose text starts kernels."""
    if not LAUNCHES.search(gate_tools.without_comments_and_strings(text)):
        return []
    return [] if REGISTERS.search(symbols(built)) else [f"{name}: starts kernels, but {built.name} registers none"]


def unwanted_kernels(name, built):
    return [f"{name}: the cpu device's object registers CUDA kernels"] if REGISTERS.search(symbols(built)) else []


def check(source, build):
    commands, offences = gate_tools.cuda_kernel_commands(source, build)
    looked = 0
    for command in commands:
        name = command.file.resolve().relative_to(source).as_posix()
        if not command.object.is_file():
            offences.append(f"{name}: has not been built")
            continue
        found = missing_kernels(name, command.file.read_text(), command.object)
        looked += bool(REGISTERS.search(symbols(command.object)))
        offences += found
    cpu, forgotten = gate_tools.cpu_kernel_commands(source, build)
    offences += forgotten
    for command in cpu:
        if command.object.is_file():
            offences += unwanted_kernels(command.file.name, command.object)
    print(f"{len(commands)} CUDA objects, {looked} of them register kernels; {len(cpu)} cpu objects")
    if looked == 0:
        offences.append("no CUDA object registers a kernel")
    return offences


def planted(build, folder):
    commands = [c for c in gate_tools.compile_commands(build) if c.is_cuda]
    if not commands:
        raise gate_tools.Skip("this build has no CUDA files (nvcc is missing or GW_CUDA is off)")
    text = "#ifdef __CUDACC__\n__global__ void planted() {}\nvoid launch() { planted<<<1, 1>>>(); }\n#endif\n"
    file = folder / "planted.cu"
    file.write_text(text)
    # The same file as CUDA and, by mistake, as C++.
    right, wrong = folder / "right.o", folder / "wrong.o"
    subprocess.run([commands[0].compiler, *commands[0].options, "-x", "cu", "-c", str(file), "-o", str(right)],
                   cwd=commands[0].folder, check=True)
    subprocess.run(["c++", "-x", "c++", "-c", str(file), "-o", str(wrong)], check=True)
    escaped = [f"a right object was refused: {o}" for o in missing_kernels("planted.cu", text, right)]
    escaped += gate_tools.escaped("compiled as C++", missing_kernels("planted.cu", text, wrong), ["registers none"])
    escaped += gate_tools.escaped("kernel in a cpu object", unwanted_kernels("planted.cu", right), ["registers CUDA"])
    return escaped


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
