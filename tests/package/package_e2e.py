#!/usr/bin/env python3
"""The library is installed, moved, and used by programs that know nothing of this repository.

    package_e2e.py SOURCE BUILD FOLDER      CXX and others in the environment say what to compile with

Nothing of the game is installed; every header compiles, whatever was included before; docs/examples builds with the
command that its README gives, and prints what the README says, the same on every device and number of threads.
"""
import os
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures, run  # noqa: E402

# gpu/exec.h takes in one of them.
PARTS_OF_OTHERS = {"cuda_check.h", "exec_cpu.h", "exec_cuda.h"}

USE_HEADERS = """cmake_minimum_required(VERSION 3.22)
project(use_headers LANGUAGES CXX)
find_package(gpuwars REQUIRED)
gw_add_kernels(headers forwards.cu backwards.cu)
add_executable(use_headers main.cpp)
target_link_libraries(use_headers PRIVATE headers)
"""


def installed_files(build, folder):
    """The prefix, moved after installing, and the relative paths of what is in it."""
    subprocess.run(["cmake", "--install", build, "--component", "gpu", "--prefix", folder / "installed"], check=True,
                   stdout=subprocess.DEVNULL)
    prefix = (folder / "installed").rename(folder / "moved")
    return prefix, {path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if path.is_file()}


def cached(build, name):
    return re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE).group(1)


def check_files(failures, source, build, prefix, files):
    library = Path(cached(build, "CMAKE_INSTALL_LIBDIR")).as_posix()
    devices = ["cpu", "cuda"] if f"{library}/libgw_gpu_cuda.a" in files else ["cpu"]
    package = f"{library}/cmake/gpuwars/"
    wanted = {f"include/gpu/{header.name}" for header in (source / "gpu").glob("*.h")}
    wanted |= {f"{library}/libgw_gpu_{part}.a" for part in ["host", *devices]}
    wanted |= {package + name for name in ("gpuwarsConfig.cmake", "gpuwarsConfigVersion.cmake", "gpuwarsTargets.cmake",
                                           "cuda_language.cmake", "gw_add_kernels.cmake")}
    others = {path for path in files - wanted if not path.startswith(package + "gpuwarsTargets-")}
    failures.check(files >= wanted and not others,
                   f"headers, libraries, package; missing {sorted(wanted - files)}, too much {sorted(others)}")
    naming = [path for path in sorted(files) if not path.endswith(".a")
              and any(str(place) in (prefix / path).read_text() for place in (source, build, prefix.parent))]
    failures.check(not naming, f"none of them names a folder of this machine: {naming}")
    return devices


def built(failures, command, folder, prefix):
    """Runs a shell command that builds folder/build."""
    environment = {**os.environ, "PREFIX": str(prefix), "CMAKE_BUILD_PARALLEL_LEVEL": "2", "CCACHE_BASEDIR": str(folder),
                   "CCACHE_NOHASHDIR": "1"}
    result = subprocess.run(command, shell=True, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return failures.check(result.returncode == 0, f"builds: {command}" + "\n" * bool(result.returncode)
                          + result.stdout * bool(result.returncode))


def check_headers(failures, command, folder, prefix, devices):
    folder.mkdir()
    names = sorted({path.name for path in (prefix / "include/gpu").glob("*.h")} - PARTS_OF_OTHERS)
    for order, headers in (("forwards", names), ("backwards", reversed(names))):
        (folder / f"{order}.cu").write_text("".join(f'#include "gpu/{header}"\n' for header in headers))
    (folder / "main.cpp").write_text("int main() {}\n")
    (folder / "CMakeLists.txt").write_text(USE_HEADERS)
    if built(failures, command, folder, prefix):
        objects = {path.name for path in folder.rglob("lib*.a")}
        failures.check(objects == {f"libheaders_{device}.a" for device in devices},
                       f"{len(names)} headers compile in both orders for {devices}: {sorted(objects)}")


def rounded(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def near(a, b, radius):
    """isNeighbour() of gpu/neighbour.h, in floats where it matters."""
    exactly = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 - radius * radius
    if abs(exactly) > 1e-3:
        return exactly < 0
    dx, dy = rounded(b[0] - a[0]), rounded(b[1] - a[1])
    return rounded(rounded(dx * dx) + rounded(dy * dy)) <= radius * radius and max(abs(dx), abs(dy)) <= radius


def check_neighbours(failures, program, readme):
    code, out, _ = run(program)
    lines = out.splitlines()
    points, found = [], []
    for line in lines:
        place, ids = line.split(":")
        number, x, y = place.split()
        failures.count += int(number) != len(points)
        points.append((rounded(float(x)), rounded(float(y))))
        found.append([int(word) for word in ids.split()])
    wrong = [i for i, asker in enumerate(points)
             if found[i] != [j for j, other in enumerate(points) if j != i and near(asker, other, 3.0)]]
    pairs = sum(map(len, found)) // 2
    failures.check(code == 0 and len(points) == 1000 and pairs > 1000 and not wrong,
                   f"{pairs} pairs of {len(points)} points are those of a recount; wrong for {wrong[:5]}")
    failures.check(lines[0] in readme, f"the README shows the first line: {lines[0]}")


def check_crowd(failures, program, readme, devices):
    runs = {"cpu 1": ("cpu", 1), "cpu 2": ("cpu", 2), "auto": ()}
    for name, arguments in runs.items():
        code, out, err = run(program, *arguments)
        reports = out.splitlines()[1:]
        failures.check(code == 0 and len(reports) == 2 and all(line in readme for line in reports),
                       f"crowd {name}: what the README says: {out or err}")
    code, out, err = run(program, "cuda")
    if devices == ["cpu"]:
        failures.check(code == 2 and "built without CUDA" in err, f"crowd cuda is refused: {err}")
    else:  # whether or not there is a GPU here
        failures.check((code == 0 and out.splitlines()[2] in readme) or (code == 1 and "CUDA" in err),
                       f"crowd cuda is the same or says why not: {out or err}")


def main():
    source, build, folder = (Path(argument).resolve() for argument in sys.argv[1:4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    prefix, files = installed_files(build, folder)
    devices = check_files(failures, source, build, prefix, files)

    examples = shutil.copytree(source / "docs/examples", folder / "examples", ignore=shutil.ignore_patterns("build"))
    readme = (examples / "README.md").read_text()
    command = re.search(r"^cmake -B build .*$", readme, re.MULTILINE).group()
    if built(failures, command, examples, prefix):
        check_neighbours(failures, examples / "build/neighbours", readme)
        check_crowd(failures, examples / "build/crowd", readme.splitlines(), devices)
    check_headers(failures, command, folder / "headers", prefix, devices)
    failures.finish()


if __name__ == "__main__":
    main()
