#!/usr/bin/env python3
"""What cannot be built is refused by one sentence with a remedy, when it is configured.

    requirements_test.py SOURCE FOLDER      CXX and CMAKE_GENERATOR in the environment
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures  # noqa: E402

GAME = ["libgl-dev", "libegl-dev", "libglew-dev", "libstb-dev", "libcli11-dev", "nlohmann-json3-dev", "libfmt-dev",
        "libtomlplusplus-dev", "libutfcpp-dev", "libpugixml-dev", "libxxhash-dev", "zlib1g-dev"]
WINDOW = ["libsdl2-dev", "libopenal-dev", "libimgui-dev"]
TESTS = ["libgtest-dev", "librapidcheck-dev", "libnanoflann-dev"]


class Tree:
    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        self.compiler = os.environ.get("CXX", "/usr/bin/c++")

    def ask(self, script, *definitions):
        """What a script of CMake says that includes our requirements."""
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "ask.cmake").write_text(script.replace("SOURCE", str(self.source)))
        result = subprocess.run(["cmake", *definitions, "-P", "ask.cmake"], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, check=False)
        return " ".join(result.stdout.split())

    def refusal(self, function, *arguments):
        quoted = " ".join(f"[==[{argument}]==]" for argument in arguments)
        return self.ask(f"include(SOURCE/cmake/requirements.cmake)\ngw_refusal_of_{function}({quoted} said)\n"
                        'message("${said}")\n')

    def configure(self, *options, game=False):
        """(exit status, output on one line) of configuring this project."""
        build = self.folder / "build"
        shutil.rmtree(build, ignore_errors=True)
        parts = [] if game else ["-DGW_GAME=OFF", "-DGW_TESTS=OFF"]
        result = subprocess.run(["cmake", "-S", self.source, "-B", build, "-G",
                                 os.environ.get("CMAKE_GENERATOR", "Ninja"), f"-DCMAKE_CXX_COMPILER={self.compiler}",
                                 "-DGW_CUDA=OFF", *parts, *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True, check=False)
        return result.returncode, " ".join(result.stdout.split())


def check_versions(failures, tree):
    for version, fine in (("3.16.3", False), ("3.21.9", False), ("3.22", True), ("4.3.4", True)):
        said = tree.ask(f"set(CMAKE_VERSION {version})\ninclude(SOURCE/cmake/before_project.cmake)\n")
        failures.check(("needs CMake 3.22 or newer, and this is " + version in said and "pip install cmake" in said)
                       if not fine else said == "", f"CMake {version}: {said or 'fine'}")
    for name, version, fine in (("GNU", "9.4.0", False), ("GNU", "10.2.1", False), ("GNU", "11.1.0", True),
                                ("GNU", "16.2.0", True), ("Clang", "13.0.1", False), ("Clang", "14.0.6", True),
                                ("Clang", "21.1.0", True), ("IntelLLVM", "1.0", True)):
        said = tree.refusal("compiler", name, version)
        failures.check(("GpuWars needs g++ 11" in said and version in said and "install" in said)
                       if not fine else said == "", f"{name} {version}: {said or 'fine'}")


def check_machines(failures, tree):
    def macros(*flags):
        return subprocess.run([tree.compiler, *flags, "-dM", "-E", "-x", "c++", os.devnull], stdout=subprocess.PIPE,
                              text=True, check=True).stdout

    here = macros()
    failures.check(tree.refusal("machine", here) == "", "this compiler's own target is fine")
    arm = "#define __aarch64__ 1\n#define __SIZEOF_POINTER__ 8\n#define __FLT_EVAL_METHOD__ 0\n"
    failures.check(tree.refusal("machine", arm) == "", "AArch64 is fine")
    others = {"32-bit ARM": "#define __arm__ 1\n#define __SIZEOF_POINTER__ 4\n",
              "RISC-V": "#define __riscv 1\n#define __SIZEOF_POINTER__ 8\n",
              "32-bit pointers": "#define __x86_64__ 1\n#define __SIZEOF_POINTER__ 4\n"}
    if "__x86_64__" in here:
        others["-m32"] = macros("-m32")
    for name, text in others.items():
        said = tree.refusal("machine", text)
        failures.check("64-bit x86-64 and AArch64 only" in said and "use a compiler" in said, f"{name}: {said}")
    said = tree.refusal("machine", "#define __x86_64__ 1\n#define __SIZEOF_POINTER__ 8\n#define __FLT_EVAL_METHOD__ 2\n")
    failures.check("x87" in said and "-mfpmath" in said, f"x87 arithmetic of 64-bit x86: {said}")


def check_flags(failures, tree):
    for flags in ("-ffast-math", "-O2 -Ofast", "-g -funsafe-math-optimizations", "--use_fast_math", "-use_fast_math -O3",
                  "-Xcompiler=-ffast-math", "-Xcompiler -O2,-ffast-math", "-mrecip=all", "-fno-signed-zeros"):
        said = tree.refusal("flags", "CMAKE_X_FLAGS", flags)
        failures.check(" in CMAKE_X_FLAGS does not: leave it out" in said, f"{flags}: {said}")
    for flags in ("", "-O3 -DNDEBUG", "-march=native -fno-fast-math", "-DX=-ffast-mathematics", "-I/opt/a-Ofast/b",
                  "-ffp-contract=fast", "-fno-trapping-math"):
        failures.check(tree.refusal("flags", "CMAKE_X_FLAGS", flags) == "", f"'{flags}' is fine")


def check_configuring(failures, tree):
    status, said = tree.configure()
    failures.check(status == 0, f"the library is configured: {said[-300:] if status else 'yes'}")
    for option, words in (("-DCMAKE_CXX_FLAGS=-O2 -ffast-math", "-ffast-math in CMAKE_CXX_FLAGS"),
                          ("-DCMAKE_CXX_FLAGS_RELEASE=-Ofast", "-Ofast in CMAKE_CXX_FLAGS_RELEASE"),
                          ("-DCMAKE_CUDA_FLAGS=--use_fast_math", "-use_fast_math in CMAKE_CUDA_FLAGS"),
                          ("-DCMAKE_EXE_LINKER_FLAGS=-ffast-math", "-ffast-math in CMAKE_EXE_LINKER_FLAGS"),
                          ("-DCMAKE_CXX_FLAGS=-m32", "there is -m32 in CMAKE_CXX_FLAGS")):
        status, said = tree.configure(option)
        failures.check(status != 0 and words in said and said.count("CMake Error") == 1,
                       f"{option} is refused: {re.sub('.*CMake Error', '', said)}")


def check_libraries(failures, tree):
    hidden = ["-DCMAKE_FIND_ROOT_PATH=/nonexistent", *(f"-DCMAKE_FIND_ROOT_PATH_MODE_{what}=ONLY"
                                                       for what in ("PACKAGE", "INCLUDE", "LIBRARY"))]

    def missing(*options):
        status, said = tree.configure("-DGW_TESTS=ON", *options, game=True)
        found = re.search(r"CMake Error .* Libraries are missing: install the packages (.*) \(Debian's names\)", said)
        failures.check(status != 0 and found and said.count("CMake Error") == 1, f"{options[-1]}: one sentence")
        return set(found[1].split()) if found else said

    failures.check(missing(*hidden) == {*GAME, *WINDOW, *TESTS}, "without any library all are named at once")
    failures.check(missing(*hidden, "-DGW_WINDOW=OFF", "-DGW_TESTS=OFF") == set(GAME), "what is left out needs none")
    for package, name in (("libsdl2-dev", "SDL2"), ("libfmt-dev", "fmt"), ("libcli11-dev", "CLI11")):
        failures.check(missing(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON") == {package}, f"{package} alone is named")


def main():
    tree = Tree(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve())
    shutil.rmtree(tree.folder, ignore_errors=True)
    failures = Failures()
    check_versions(failures, tree)
    check_machines(failures, tree)
    check_flags(failures, tree)
    check_configuring(failures, tree)
    check_libraries(failures, tree)
    failures.finish()


if __name__ == "__main__":
    main()
