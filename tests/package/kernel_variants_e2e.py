#!/usr/bin/env python3
"""The installed program takes the kernels that suit the processor, and all of them play the same game, tick by tick.

    kernel_variants_e2e.py PACKAGED STATIC REPLAY...       STATIC has one set of kernels, linked in
"""
import json
import platform
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
import program as gpuwars  # noqa: E402

LOADER = "/lib64/ld-linux-x86-64.so.2"
HIDDEN = "glibc.cpu.hwcaps=-AVX2"  # the dynamic loader then believes that there is none


def expected_here():
    """The kernels that the loader ought to take on this machine. Which levels it searches is its own word, glibc 2.33 on:
    /proc/cpuinfo leaves out flags that a hypervisor or the kernel hides and the processor's CPUID shows."""
    if platform.machine() != "x86_64":
        return platform.machine()
    levels = subprocess.run([LOADER, "--help"], capture_output=True, text=True, check=False).stdout
    return "x86-64-v3" if re.search(r"^ *x86-64-v3 \(supported, searched\)", levels, re.MULTILINE) else "x86-64"


def kernels_of(program, environment):
    code, out, err = gpuwars.run(program, "devices", "--json", "-", environment=environment)
    return json.loads(out)["cpuKernels"] if code == 0 else err


def hashes_of(program, replays, environment):
    """(exit code, a line a tick, what it complains of)."""
    code, out, err = gpuwars.run(program, "verify", "--device", "cpu", "--hashes", "-", *replays, environment=environment,
                                 timeout=7000)
    return code, re.findall(r"^\d+ [0-9a-f]{16}$", out, re.MULTILINE), err


def main():
    packaged, static, *replays = sys.argv[1:]
    failures = gpuwars.Failures()
    plain = gpuwars.without_display()
    code, hashes, err = hashes_of(static, replays, plain)
    failures.check(code == 0 and len(hashes) > 100 * len(replays), f"kernels without choice, {len(hashes)} ticks: {code} {err}")
    here = expected_here()
    variants = {here: plain}
    if here == "x86-64-v3":
        variants["x86-64"] = {**plain, "GLIBC_TUNABLES": HIDDEN}
    for kernels, environment in variants.items():
        found = kernels_of(packaged, environment)
        failures.check(found == kernels, f"kernels for {kernels} are taken: {found}")
        code, own, err = hashes_of(packaged, replays, environment)
        failures.check(code == 0 and own == hashes, f"and give the same hashes in {len(own)} ticks: {code} {err}")
    failures.finish()


if __name__ == "__main__":
    main()
