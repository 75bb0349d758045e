"""What ptxas makes of the simulation's kernels: registers, stack, spills, shared memory, constants.

ptxas runs on the PTX that kernel_ptx.py compiled, as nvcc itself would, and again only when that has changed.
"""
import dataclasses
import hashlib
import itertools
import json
import re
import shutil
import struct
import subprocess

import gate_tools
import kernel_ptx
from kernel_files import key_of

FUNCTION = re.compile(r"Function properties for (\S+)\n\s*(\d+) bytes stack frame, (\d+) bytes spill stores, "
                      r"(\d+) bytes spill loads")
ENTRY = re.compile(r"Compiling entry function '([^']+)' for '(\w+)'(.*?Used (\d+) registers[^\n]*)", re.DOTALL)
CUB_FILES = ("gpu/sort_keys.cu",)  # hold no kernel of ours


@dataclasses.dataclass
class Usage:
    """One kernel on one architecture; bytes but for the registers."""
    registers: int
    stack: int
    spill_stores: int
    spill_loads: int
    shared: int  # static; what a team asks for at launch is not known here
    constant: int  # its parameters among them


def nvcc_version(compiler):
    text = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    return re.search(r"\bV([\d.]+)", text).group(1)


def constant_banks(cubin):
    """Bytes of constant memory by the kernel's symbol: the sections .nv.constant<bank>.<symbol> of an ELF file."""
    at, size, count, names_at = (struct.unpack_from("<Q", cubin, 40)[0], *struct.unpack_from("<HHH", cubin, 58))
    sections = [struct.unpack_from("<IIQQQQ", cubin, at + i * size) for i in range(count)]
    names = sections[names_at][4]
    banks = {}
    for name_at, _, _, _, _, length in sections:
        begin = names + name_at
        name = cubin[begin:cubin.index(b"\0", begin)].decode()
        found = re.fullmatch(r"\.nv\.constant\d+\.(.+)", name)
        if found:
            banks[found.group(1)] = banks.get(found.group(1), 0) + length
    return banks


def parsed(text, cubin):
    """What ptxas said, by symbol; functions that were not inlined have no registers of their own."""
    functions = {name: [int(n) for n in numbers] for name, *numbers in FUNCTION.findall(text)}
    banks = constant_banks(cubin)
    usages = {}
    for name, _, said, registers in ENTRY.findall(text):
        shared = re.search(r"(\d+) bytes smem", said)
        usages[name] = Usage(int(registers), *functions.pop(name), int(shared.group(1)) if shared else 0,
                             banks.get(name, 0))
    for name, numbers in functions.items():
        usages[name] = Usage(0, *numbers, 0, 0)
    return usages


def usages_of(compiler, ptx, architecture, folder):
    """Usage by symbol, of one PTX file."""
    key = hashlib.sha256(f"{nvcc_version(compiler)} {architecture} {ptx.read_text()}".encode()).hexdigest()[:16]
    remembered = folder / f"{key}.json"
    if remembered.is_file():
        return {name: Usage(**fields) for name, fields in json.loads(remembered.read_text()).items()}
    cubin = folder / f"{key}.cubin"
    run = subprocess.run([compiler, "-cubin", f"-arch={architecture}", "-Xptxas", "-v", str(ptx), "-o", str(cubin)],
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise RuntimeError(f"{ptx}: ptxas refuses it:\n{run.stderr}")
    usages = parsed(run.stdout + run.stderr, cubin.read_bytes())
    cubin.unlink()
    remembered.write_text(json.dumps({name: dataclasses.asdict(usage) for name, usage in usages.items()}))
    return usages


def readable(symbols):
    """The kernel structs' own names, in the order of the symbols: forEachKernel<gw::cuda::X>(...) is X."""
    if not shutil.which("c++filt"):
        raise gate_tools.Skip("c++filt is missing")
    plain = subprocess.run(["c++filt"], input="\n".join(symbols), capture_output=True, text=True, check=True).stdout
    names = []
    for name in plain.splitlines():
        struct_name = re.match(r"void gw::cuda::forEach(?:Team)?Kernel<(.*)>\(", name)
        name = struct_name.group(1) if struct_name else re.sub(r"^void ", "", name).split("(")[0]
        name = re.sub(r"\(anonymous namespace\)::|\bgw::(?:cuda::)?", "", name).replace("> >", ">>").strip()
        if "cub::" in name:
            name = "cub " + name.split("<")[0].split("::")[-1]
        names.append(name)
    return names


def collect(source, build):
    """(version, {(file, kernel): {architecture: Usage}}, offences)."""
    commands, offences = gate_tools.cuda_kernel_commands(source, build)
    cache, folder = gate_tools.CompileCache(build, "ptx"), gate_tools.CompileCache(build, "ptxas").folder
    found = {}

    def look(pair):
        command, architecture = pair
        ptx = kernel_ptx.ptx_of(command, cache, command.file, command.options, architecture)
        usages = usages_of(command.compiler, ptx, architecture, folder)
        file = key_of(command.file.resolve().relative_to(source).as_posix())
        for name, usage in zip(readable(usages), usages.values()):
            if architecture in found.setdefault((file, name), {}):
                return [f"{file}: two kernels are called {name}; ptxas.readable() has to tell them apart"]
            found[file, name][architecture] = usage
        return []

    offences += gate_tools.in_parallel(look, itertools.product(commands, kernel_ptx.ARCHITECTURES))
    return nvcc_version(commands[0].compiler), found, offences
