#!/usr/bin/env python3
"""Which compiler nvcc is given for the host's part, and which message comes when it takes none: with an nvcc and compilers that
only say what real ones say, and a limit of g++ 15 and clang 20 as nvcc 13.0 has.

    cuda_host_compiler_test.py SOURCE FOLDER
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures  # noqa: E402

# Takes whatever answers -dumpversion with a number up to its limits.
NVCC = """#!/bin/sh
[ "$1" = --version ] && { echo 'Cuda compilation tools, release 13.0, V13.0.88'; exit 0; }
by=g++
while [ $# -gt 0 ]; do
  case "$1" in -ccbin) by=$2 ;; -o) out=$2 ;; */cuda_math.h) [ -f "$1" ] && NEW_LIBC= ;; esac
  shift
done
version=$($by -dumpversion)
case "$by" in
  *clang*) [ "${version%%.*}" -le 20 ] || {
    echo '#error -- unsupported clang version! clang version must be less than 21 and greater than 3.2 .'; exit 1; } ;;
  *) [ "${version%%.*}" -le 15 ] || {
    echo '#error -- unsupported GNU version! gcc versions later than 15 are not supported! The nvcc flag ...'; exit 1; } ;;
esac
[ -z "$NEW_LIBC" ] || { echo 'mathcalls.h(206): error: incompatible with "rsqrt"'; exit 2; }
[ -z "$BROKEN_HEADERS" ] || { echo 'In file included from x.h;y.h:'; echo '/usr/include/math.h(1): error: "cospi" differs'; exit 2; }
: > "$out"
"""
ASK = """include({source}/cmake/cuda_host_compiler.cmake)
gw_find_cuda_host_compiler({nvcc} host math why)
message("host=${{host}}")
message("math=${{math}}")
message("why=${{why}}")
"""


def script(path, text):
    path.write_text(text)
    path.chmod(0o755)


class Machine:
    """A PATH with these compilers, e.g. {"g++": "16.2.0"}, and nvcc."""

    def __init__(self, folder, compilers, nvcc=NVCC):
        shutil.rmtree(folder, ignore_errors=True)
        self.path = folder / "path"
        self.path.mkdir(parents=True)
        for name, version in compilers.items():
            script(self.path / name, f"#!/bin/sh\necho {version}\n")
        script(self.path / "nvcc", nvcc)

    def environment(self, **variables):
        kept = {name: value for name, value in os.environ.items() if name not in ("CUDAHOSTCXX", "CUDACXX")}
        return {**kept, "PATH": str(self.path), **variables}

    def ask(self, source, **variables):
        """(the name of the host compiler, whether cuda_math.h is needed, why there is no compiler)"""
        (self.path.parent / "ask.cmake").write_text(ASK.format(source=source, nvcc=self.path / "nvcc"))
        result = subprocess.run([shutil.which("cmake"), "-P", "ask.cmake"], cwd=self.path.parent, stderr=subprocess.PIPE,
                                env=self.environment(**variables), text=True, check=True)
        host, math, why = (line.split("=", 1)[1] for line in result.stderr.splitlines())
        return Path(host).name, math, why


def check_choices(failures, source, folder):
    def chooses(compilers, host, **variables):
        found, math, why = Machine(folder, compilers).ask(source, **variables)
        failures.check((found, why) == (host, ""), f"of {compilers} nvcc takes '{found}', '{host}' is right {why}")
        failures.check(math == ("ON" if "NEW_LIBC" in variables else "OFF"), f"cuda_math.h is needed: {math}")

    chooses({"g++": "12.2.0"}, "")
    chooses({"g++": "15.1.0", "g++-12": "12.2.0"}, "")
    chooses({"g++": "16.2.0", "g++-15": "15.2.0", "g++-14": "14.2.0"}, "g++-15")
    chooses({"g++": "16.2.0", "g++-16": "16.2.0", "g++-14": "14.2.0", "clang++-20": "20.1.0"}, "g++-14")
    chooses({"g++": "16.2.0", "clang++": "21.1.0", "clang++-21": "21.1.0", "clang++-20": "20.1.0"}, "clang++-20")
    chooses({"g++": "16.2.0", "g++-15": "15.2.0", "g++-13": "13.1.0"}, "g++-13", CUDAHOSTCXX="g++-13")
    chooses({"g++": "14.2.0", "g++-13": "13.1.0"}, "", NEW_LIBC="yes")
    chooses({"g++": "16.2.0", "g++-15": "15.2.0"}, "g++-15", NEW_LIBC="yes")


def check_sentences(failures, source, folder):
    def refuses(compilers, *words, nvcc=NVCC, **variables):
        found, _, why = Machine(folder, compilers, nvcc).ask(source, **variables)
        good = not found.startswith("g++-1") or variables.get("CUDAHOSTCXX")
        failures.check(good and all(word in why for word in words) and ";" not in why, f"of {compilers}: {why}")

    refuses({"g++": "16.2.0"}, "nvcc 13.0 does not take g++ 16.2.0", "install g++-15 and build again")
    refuses({"g++": "16.2.0", "g++-16": "16.2.0", "clang++-21": "21.1.0"}, "g++ 16.2.0", "install g++-15")
    refuses({"g++": "12.2.0", "g++-16": "16.2.0"}, "does not take g++-16 16.2.0", "CUDAHOSTCXX", CUDAHOSTCXX="g++-16")
    refuses({"g++": "14.2.0", "g++-13": "13.1.0"}, "cannot compile with g++ 14.2.0", "'cospi' differs",
            "nor with any other", "install a newer CUDA toolkit", BROKEN_HEADERS="yes")
    refuses({"g++": "16.2.0", "g++-15": "15.3.0"}, "cannot compile with g++-15 15.3.0", "'cospi' differs",
            "install a newer CUDA toolkit", BROKEN_HEADERS="yes")
    refuses({"g++": "12.2.0"}, "nvcc does not start here", nvcc="#!/nowhere/sh\n")
    refuses({}, "nvcc 13.0", "install")


def check_link_folders(failures, source, folder):
    """Folders with a C++ library of their own are not handed to the linker."""
    Machine(folder, {})
    for name, file in (("toolkit", "libcudadevrt.a"), ("gcc/15", "libstdc++.so"), ("llvm", "libc++.so")):
        (folder / name).mkdir(parents=True)
        (folder / name / file).write_text("")
    (folder / "ask.cmake").write_text(f'include({source}/cmake/cuda_host_compiler.cmake)\n'
                                      f'set(folders {folder}/toolkit {folder}/gcc/15 {folder}/llvm {folder}/none)\n'
                                      'gw_without_cxx_libraries(folders)\nmessage("${folders}")\n')
    result = subprocess.run(["cmake", "-P", folder / "ask.cmake"], stderr=subprocess.PIPE, text=True, check=True)
    failures.check(result.stderr.strip() == f"{folder}/toolkit;{folder}/none", f"the linker looks in {result.stderr}")


def check_project(failures, source, folder):
    """The library's own configuration goes on with the cpu alone, says why, and hands it to the program."""
    here = {program.name for place in os.environ["PATH"].split(os.pathsep) for program in Path(place).glob("*++-[0-9]*")}
    machine = Machine(folder, {"g++": "16.2.0", **{name: "99.1.0" for name in here}})
    build = folder / "build"
    tools = os.pathsep.join([str(machine.path), os.environ["PATH"]])
    environment = machine.environment(PATH=tools, CUDACXX=str(machine.path / "nvcc"))
    result = subprocess.run(["cmake", "-S", source, "-B", build, "-G", os.environ.get("CMAKE_GENERATOR", "Ninja"),
                             f"-DCMAKE_CXX_COMPILER={os.environ.get('CXX', '/usr/bin/c++')}", "-DGW_GAME=OFF",
                             "-DGW_TESTS=OFF", "-DGW_CUDA=ON"], env=environment, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, check=False)
    said = " ".join(result.stdout.split())
    failures.check(result.returncode == 0 and "Warning" in said and "install g++-15 and build again." in said,
                   f"a build without CUDA says why: {said[-600:]}")
    commands = (build / "compile_commands.json").read_text()
    failures.check("install g++-15 and build again" in commands, "and the program is told, too")


def main():
    source, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    failures = Failures()
    check_choices(failures, source, folder)
    check_sentences(failures, source, folder)
    check_link_folders(failures, source, folder)
    check_project(failures, source, folder)
    failures.finish()


if __name__ == "__main__":
    main()
