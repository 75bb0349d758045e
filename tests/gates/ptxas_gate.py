"""Refuses simulation kernels that spill registers, and a report of registers that is out of date.

The report is bench/results/ptxas.md. Which kernels there are is always compared; their numbers only when this
nvcc is the one that the report names, since another one allocates otherwise.
"""
import dataclasses

import gate_tools
import kernel_ptx
import ptxas
import ptxas_report

# 64 values alive at once, in the 32 registers that 2 blocks of 1,024 threads leave each thread.
SPILLING = """
__global__ void __launch_bounds__(1024, 2) planted(float* y, const float* x) {
  float v[64];
  for (int i = 0; i < 64; ++i) v[i] = x[threadIdx.x + 1024 * i];
  __syncthreads();
  for (int i = 0; i < 64; ++i) y[threadIdx.x + 1024 * i] = v[i] * v[63 - i] + v[(i * 7 + 3) % 64];
}
"""
CLEAN = "__global__ void planted(float* y, const float* x) { y[threadIdx.x] = x[threadIdx.x] * 2.0f; }\n"


def spills_in(found):
    return [f"{file}: {kernel} spills on {architecture}: {usage.spill_stores} bytes stored, {usage.spill_loads} loaded"
            for (file, kernel), usages in sorted(found.items()) if not ptxas_report.is_cub((file, kernel))
            for architecture, usage in usages.items() if usage.spill_stores or usage.spill_loads]


def out_of_date(version, found, report_version, reported):
    remedy = f"; {ptxas_report.REMEDY}"
    if not reported:
        return [f"there is no report{remedy}"]
    offences = [f"{kernel} of {file} is missing{remedy}" for file, kernel in sorted(found.keys() - reported.keys())]
    offences += [f"{file} has no kernel {kernel}{remedy}" for file, kernel in sorted(reported.keys() - found.keys())]
    if report_version == version:
        offences += [f"{key[1]} of {key[0]} needs other resources now{remedy}"
                     for key in sorted(found.keys() & reported.keys()) if found[key] != reported[key]]
    return [f"{ptxas_report.PLACE}: {offence}" for offence in offences]


def check(source, build):
    version, found, offences = ptxas.collect(source, build)
    offences += spills_in(found)
    if not found:
        offences.append("no kernel was found: the gate looked at nothing")
    report = source / ptxas_report.PLACE
    report_version, reported = ptxas_report.read(report.read_text() if report.is_file() else "")
    offences += out_of_date(version, found, report_version, reported)
    print(f"{len(found)} kernels for {' and '.join(kernel_ptx.ARCHITECTURES)} looked at")
    if reported and report_version != version:
        print(f"The report is of nvcc {report_version}, this is {version}: registers were not compared.")
    return offences


def planted(build, folder):
    command = kernel_ptx.any_cuda_command(build)
    cache = gate_tools.CompileCache(folder, "ptx")
    problems, clean = [], {}
    for name, text in (("spilling", SPILLING), ("clean", CLEAN)):
        file = folder / f"{name}.cu"
        file.write_text(text)
        usages = {}
        for architecture in kernel_ptx.ARCHITECTURES:
            ptx = kernel_ptx.ptx_of(command, cache, file, command.options, architecture)
            symbols = ptxas.usages_of(command.compiler, ptx, architecture, folder)
            usages[architecture] = dict(zip(ptxas.readable(symbols), symbols.values()))["planted"]
        found = {(file.name, "planted"): usages}
        if name == "spilling":
            problems += gate_tools.escaped(name, spills_in(found), [f"spills on {a}" for a in kernel_ptx.ARCHITECTURES])
        else:
            problems += [f"a clean kernel was refused: {offence}" for offence in spills_in(found)]
            clean = found

    # The report: as written it is current; a missing, an odd or a changed row is not.
    version, reported = ptxas_report.read(ptxas_report.written("13.0.0", clean))
    problems += [f"a current report was refused: {o}" for o in out_of_date("13.0.0", clean, version, reported)]
    more = {**clean, ("other.cu", "Other"): next(iter(clean.values()))}
    changed = {key: {a: dataclasses.replace(usage, registers=usage.registers + 1) for a, usage in usages.items()}
               for key, usages in clean.items()}
    for what, now, expected in (("missing row", more, "Other of other.cu is missing"),
                                ("odd row", {}, "no kernel planted"), ("registers", changed, "needs other resources")):
        problems += gate_tools.escaped(what, out_of_date(version, now, version, reported), [expected])
    problems += gate_tools.escaped("no report", out_of_date(version, clean, None, {}), ["there is no report"])
    return problems + [f"another nvcc's registers were compared: {offence}"
                       for offence in out_of_date("14.0", changed, version, reported)]


if __name__ == "__main__":
    gate_tools.run_gate(check, planted)
