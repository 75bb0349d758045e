#!/usr/bin/env python3
"""The installed headers in a strict project: each alone, and with files of the same names in the way.

    headers_e2e.py SOURCE BUILD FOLDER      CXX and CUDACXX in the environment; clang++ beside g++ where it is

No warning of -Wall -Wextra -Wpedantic -Wshadow -Wconversion comes from them, though they are no system headers, and
none is taken from a user's folder, whichever stands first. Without C++20 they say so.
"""
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from library import COMPILER, STRICT, Failures, installed, write_mine

CPU = ["-DGW_DEVICE=cpu", "-ffp-contract=off", "-x", "c++", "-fsyntax-only"]


def said(command, text=""):
    """What a compiler says, and whether it went well."""
    result = subprocess.run(list(map(str, command)), input=text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True, check=False)
    return result.returncode == 0, result.stdout


class Headers:
    def __init__(self, source, build, folder):
        self.failures = Failures()
        self.include = installed(build, folder) / "include"
        self.mine = write_mine(source, folder / "mine")
        self.examples, self.templates = source / "docs/examples", source / "tests/package/every_template.cu"
        self.public = sorted(path.name for path in (self.include / "gpuwars").glob("*.h"))
        other = "g++" if "clang" in COMPILER else "clang++"
        self.compilers = [COMPILER, other] if shutil.which(other) else [COMPILER]

    def alone(self, compiler):
        """Every header, in a program that includes nothing else."""
        def compiled(header):
            _, text = said([compiler, *STRICT, *CPU, f"-I{self.include}", "-"], f"#include <gpuwars/{header}>\n")
            return f"{header}:\n{text}" if text else ""
        with ThreadPoolExecutor(2) as pool:
            wrong = list(filter(None, pool.map(compiled, self.public)))
        self.failures.check(len(self.public) > 20 and not wrong,
                            f"{len(self.public)} headers compile alone with {compiler}: {''.join(wrong)}")

    def in_use(self, compiler):
        """Templates warn where they are made."""
        for file in (self.templates, self.examples / "neighbours.cpp", self.examples / "crowd.cu"):
            _, text = said([compiler, *STRICT, *CPU, f"-I{self.include}", file])
            self.failures.check(not text, f"{file.name} compiles with {compiler}: {text}")

    def beside_mine(self, compiler):
        """With the user's headers first or last, by either kind of option."""
        program = "".join(f"#include {header}\n" for header in ('"gpu/buffer.h"', "<gpuwars/ngrid.h>",
                                                                 "<gpuwars/row_gather.h>")) + "mine::Buffer b;\n"
        for options in ([f"-I{self.mine}", "-isystem", self.include], [f"-I{self.mine}", f"-I{self.include}"],
                        [f"-I{self.include}", f"-I{self.mine}"], ["-isystem", self.mine, "-isystem", self.include],
                        ["-iquote", self.mine, f"-I{self.include}"]):
            good, text = said([compiler, *STRICT, *CPU, *options, "-"], program)
            self.failures.check(good, f"{compiler} {' '.join(map(str, options))}: {text}")

    def with_old_standard(self, compiler):
        good, text = said([compiler, "-std=c++17", *CPU, f"-I{self.include}", "-"], "#include <gpuwars/ngrid.h>\n")
        self.failures.check(not good and "C++20" in text, f"{compiler}: C++17 is refused by name")

    def as_cuda(self, nvcc, folder):
        """All of them and their templates, for the device. The wrapping that nvcc writes is pedantic nowhere."""
        host = [word for word in STRICT if word not in ("-std=c++20", "-Wpedantic")]
        _, text = said([nvcc, "-std=c++20", "-DGW_DEVICE=cuda", "-arch=sm_90", "-I", self.include,
                        "-Werror=all-warnings", f"-Xcompiler={','.join(host)}", "-c", "-o", folder / "templates.o",
                        self.templates])
        self.failures.check(not text, f"{self.templates.name} compiles as CUDA: {text}")


def main():
    source, build, folder = (Path(argument).resolve() for argument in sys.argv[1:4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    headers = Headers(source, build, folder)
    for compiler in headers.compilers:
        headers.alone(compiler)
        headers.in_use(compiler)
        headers.beside_mine(compiler)
        headers.with_old_standard(compiler)
    if "CUDACXX" in os.environ:
        headers.as_cuda(os.environ["CUDACXX"], folder)
    headers.failures.finish()


if __name__ == "__main__":
    main()
