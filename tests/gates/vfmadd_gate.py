"""Refuses fused multiply-adds in the cpu device's kernels.

Baseline x86-64 has no such instruction, so a gate on the ordinary build proves nothing: the kernel files
are compiled again with the project's flags for x86-64-v3, which has them. What packages hold is compiled so anyway:
those objects are taken as they are.
"""
import platform
import re
import shutil
import subprocess

import gate_tools

MARCH = "-march=x86-64-v3"
FUSED = re.compile(r"\b(vfn?m(?:add|sub|addsub|subadd)\d{3}\w+)\b")
MACHINE_CODE = re.compile(r"^ *[0-9a-f]+:\t[a-z]", re.MULTILINE)


def require_tools():
    if platform.machine() not in ("x86_64", "AMD64"):
        raise gate_tools.Skip(f"{platform.machine()} is not x86-64")
    if not shutil.which("objdump"):
        raise gate_tools.Skip("objdump is missing")


def fused_in(name, command, cache, file, options):
    if MARCH in options and command.object and command.object.is_file():
        return fused_in_object(name, command.object)
    kept = [o for o in options if not o.startswith(("-march=", "-mtune=", "-fsanitize", "-flto"))]
    words = [command.compiler, *kept, MARCH, "-c", str(file)]
    return fused_in_object(name, cache.output(words, str(file), ".o", command.folder))


def fused_in_object(name, built):
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", str(built)],
                          capture_output=True, text=True, check=True).stdout
    offences = [f"{name}: {instruction}" for instruction in sorted(set(FUSED.findall(text)))]
    if not MACHINE_CODE.search(text):
        offences.append(f"{name}: holds no machine code, so nothing was looked at")
    return offences


def check(source, build):
    require_tools()
    commands, offences = gate_tools.cpu_kernel_commands(source, build)
    ready = {c.file for c in commands if MARCH in c.options}
    commands = [c for c in commands if MARCH in c.options or c.file not in ready]
    cache = gate_tools.CompileCache(build, "vfmadd")
    offences += gate_tools.in_parallel(
        lambda c: fused_in(c.file.name.removesuffix(".cpp"), c, cache, c.file, c.options), commands)
    print(f"{len(commands)} files looked at")
    return offences


def planted(build, folder):
    require_tools()
    commands = [c for c in gate_tools.compile_commands(build) if not c.is_cuda and "-ffp-contract=off" in c.options]
    if not commands:
        raise gate_tools.Skip("this build has no C++ file with the project's flags")
    command = commands[0]
    optimised = [o for o in command.options if not o.startswith(("-O", "-march="))] + ["-O2"]
    file = folder / "planted.cpp"
    file.write_text("float planted(float a, float x, float y) { return a * x + y; }\n")
    contracted = [o for o in optimised if o != "-ffp-contract=off"] + ["-ffp-contract=fast"]
    cache = gate_tools.CompileCache(folder, "vfmadd")
    clean = fused_in("planted", command, cache, file, optimised)
    caught = fused_in("planted", command, cache, file, contracted)
    return ([f"a clean file was refused: {offence}" for offence in clean] +
            gate_tools.escaped("without -ffp-contract=off", caught, ["vfmadd"]))


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
