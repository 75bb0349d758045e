"""The kernels that are installed (cmake/packages/kernel_variants.cmake): the baseline runs on every x86-64, the variants
for newer processors use what those have and no fused multiply-add, and none of them shows more than the seam, so that
no function of one ever runs in place of another's. The program beside them runs on every x86-64, too, and brings no
kernels of its own for the cpu device."""
import platform
import re
import shutil
import subprocess

import gate_tools
from vfmadd_gate import FUSED

EXPORTED = {"gw::cpu::kernelTarget()", "gw::cpu::makeSimulation(gw::SimulationConfig const&)"}
# Instructions with a VEX or EVEX prefix; the others that begin with v are as old as the 286.
NEWER = re.compile(r"^ *[0-9a-f]+:\t(?!ver[rw]\b|vm\w+\b)(v[a-z]\w+)", re.MULTILINE)
WIDE = re.compile(r"%ymm")


def text_of(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True).stdout


def code_of(file):
    return text_of("objdump", "-d", "--no-show-raw-insn", file)


def old_offences(name, file):
    found = sorted(set(NEWER.findall(code_of(file))))
    return [f"{name}: has instructions that older processors lack: {' '.join(found[:5])}"] if found else []


def new_offences(name, file):
    code = code_of(file)
    offences = [f"{name}: {instruction}" for instruction in sorted(set(FUSED.findall(code)))]
    if not WIDE.search(code):
        offences.append(f"{name}: uses nothing that the baseline lacks")
    return offences


def export_offences(name, file):
    lines = text_of("nm", "--dynamic", "--defined-only", "--demangle", file).splitlines()
    exported = {line.split(" ", 2)[2] for line in lines if " A " not in line}
    return ([f"{name}: shows {symbol}" for symbol in sorted(exported - EXPORTED)] +
            [f"{name}: does not show {symbol}" for symbol in sorted(EXPORTED - exported)])


def program_offences(name, file):
    needed = re.findall(r"NEEDED.*\[(.*)\]", text_of("readelf", "--dynamic", "--wide", file))
    own = [line for line in text_of("nm", "--defined-only", "--demangle", file).splitlines()
           if "gw::cpu::DeviceSimulation" in line]
    return (old_offences(name, file) + [f"{name}: brings kernels of its own: {line}" for line in own[:1]] +
            [f"{name}: does not ask for libgpuwars-cpu.so"] * ("libgpuwars-cpu.so" not in needed))


def require_tools():
    if platform.machine() not in ("x86_64", "AMD64"):
        raise gate_tools.Skip(f"{platform.machine()} is not x86-64")
    for tool in ("objdump", "readelf", "nm"):
        if not shutil.which(tool):
            raise gate_tools.Skip(f"{tool} is missing")


def check(_source, build):
    require_tools()
    libraries = sorted((build / "packaged").glob("**/libgpuwars-cpu.so"))
    if not libraries:
        raise gate_tools.Skip("this build makes no packages (GW_PACKAGES is off)")
    offences, levels = [], set()
    for library in libraries:
        name = library.relative_to(build / "packaged").as_posix()
        level = library.parent.name if library.parent.parent.name == "glibc-hwcaps" else "x86-64"
        levels.add(level)
        offences += export_offences(name, library)
        offences += (old_offences if level == "x86-64" else new_offences)(name, library)
    for program in sorted((build / "packaged").glob("*/gpuwars")):
        if program.is_file():
            levels.add("program")
            offences += program_offences(program.relative_to(build).as_posix(), program)
    missing = {"x86-64", "x86-64-v3", "program"} - levels
    print(f"looked at {sorted(levels)}")
    return offences + [f"there is no {part}" for part in sorted(missing)]


def planted(build, folder):
    require_tools()
    commands = [c for c in gate_tools.compile_commands(build) if not c.is_cuda]
    source = folder / "planted.cpp"
    source.write_text("void planted(float* a, const float* x) { for (int i = 0; i < 64; ++i) a[i] = a[i] * x[i] + 1; }\n")

    def compiled(name, *options):
        file = folder / name
        subprocess.run([commands[0].compiler, "-O3", "-shared", "-fPIC", "-o", str(file), str(source), *options], check=True)
        return file

    plain, contracted = ["-ffp-contract=off"], ["-ffp-contract=fast"]
    base = compiled("base.so", "-march=x86-64", *plain)
    newer = compiled("newer.so", "-march=x86-64-v3", *plain)
    fused = compiled("fused.so", "-march=x86-64-v3", *contracted)
    return ([f"refused for nothing: {offence}" for offence in old_offences("base", base) + new_offences("newer", newer)] +
            gate_tools.escaped("AVX in the baseline", old_offences("newer", newer), ["older processors lack"]) +
            gate_tools.escaped("a contracted variant", new_offences("fused", fused), ["fused: vf"]) +
            gate_tools.escaped("the baseline as variant", new_offences("base", base), ["lacks"]) +
            gate_tools.escaped("another symbol", export_offences("base", base), ["shows planted", "does not show"]) +
            gate_tools.escaped("a program without them", program_offences("base", base), ["does not ask"]))


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
