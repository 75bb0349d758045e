#!/usr/bin/env python3
"""The library is installed, moved, and used by programs that know nothing of this repository.

    package_e2e.py SOURCE BUILD FOLDER      CXX and others in the environment say what to compile with

Nothing of the game is installed; every header compiles, whatever was included before; docs/examples builds with the
command that its README gives, and prints what the README says, the same on every device and number of threads. Other
ways to take the library in: ways_e2e.py.
"""
import re
import shutil
import struct
import sys
from pathlib import Path

from library import STRICT, Failures, built, cached, installed, run

INCLUDE = re.compile(r'^#include [<"]([^>"]+)[>"]', re.MULTILINE)
USE_HEADERS = """cmake_minimum_required(VERSION 3.22)
project(use_headers LANGUAGES CXX)
set(GW_CUDA ON)
find_package(gpuwars REQUIRED)
gw_add_kernels(headers forwards.cu backwards.cu)
add_executable(use_headers main.cpp)
target_link_libraries(use_headers PRIVATE headers)
"""


def check_files(failures, source, build, prefix):
    files = {path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if path.is_file()}
    library = Path(cached(build, "CMAKE_INSTALL_LIBDIR")).as_posix()
    devices = ["cpu", "cuda"] if f"{library}/libgw_gpu_cuda.a" in files else ["cpu"]
    package = f"{library}/cmake/gpuwars/"
    wanted = {path.relative_to(build).as_posix() for path in (build / "include/gpuwars").rglob("*.h")}
    wanted |= {f"{library}/libgw_gpu_{part}.a" for part in ["host", *devices]} | {f"{library}/pkgconfig/gpuwars.pc"}
    wanted |= {package + name for name in ("gpuwarsConfig.cmake", "gpuwarsConfigVersion.cmake", "gpuwarsTargets.cmake",
                                           "cuda_host_compiler.cmake", "cuda_language.cmake", "cuda_math.h",
                                           "gw_add_kernels.cmake")}
    others = {path for path in files - wanted if not path.startswith(package + "gpuwarsTargets-")}
    failures.check(files >= wanted and not others,
                   f"headers, libraries, package; missing {sorted(wanted - files)}, too much {sorted(others)}")
    naming = [path for path in sorted(files) if not path.endswith(".a")
              and any(str(place) in (prefix / path).read_text() for place in (source, build, prefix.parent))]
    failures.check(not naming, f"none of them names a folder of this machine: {naming}")
    return devices


def check_public_headers(failures, source, prefix):
    """Users get what users need: the headers that are for them, and what these include."""
    include = prefix / "include"
    sources = {path.name: path.read_text() for path in (source / "gpu").rglob("*.h")}
    places = {path.name: path.relative_to(include).as_posix() for path in include.rglob("*.h")}
    changed = [name for name in places if (include / places[name]).read_text() != sources.get(name)]
    failures.check(places and not changed, f"{len(places)} headers are those of gpu/: {changed}")
    for_users = {name for name, text in sources.items() if "Not for users" not in text.split("#pragma once")[0]}
    named = {name for text in sources.values() for name in INCLUDE.findall(text) if name.startswith("gpuwars/")}
    public = {name for name, place in places.items() if place == f"gpuwars/{name}"}
    detail = {place for place in places.values() if place.startswith("gpuwars/detail/")}
    failures.check(public == for_users, f"public are all that do not say otherwise: {sorted(public ^ for_users)}")
    failures.check(named <= set(places.values()), f"what they name is there: {sorted(named - set(places.values()))}")
    failures.check(detail <= named, f"details that nothing includes: {sorted(detail - named)}")
    by_name = [name for name in places if re.search(r'#include "', sources[name])]
    failures.check(not by_name, f"they name each other as users do: {by_name}")


def check_headers(failures, command, folder, prefix, devices):
    folder.mkdir()
    names = sorted(path.name for path in (prefix / "include/gpuwars").glob("*.h"))
    for order, headers in (("forwards", names), ("backwards", reversed(names))):
        (folder / f"{order}.cu").write_text("".join(f"#include <gpuwars/{header}>\n" for header in headers))
    (folder / "main.cpp").write_text("int main() {}\n")
    (folder / "CMakeLists.txt").write_text(USE_HEADERS)
    if built(failures, command, folder, prefix, CXXFLAGS=" ".join(STRICT)):
        objects = {path.name for path in folder.rglob("lib*.a")}
        failures.check(objects == {f"libheaders_{device}.a" for device in devices},
                       f"{len(names)} headers compile in both orders for {devices}: {sorted(objects)}")


def rounded(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def near(a, b, radius):
    """isNeighbour() of gpu/neighbours/neighbour.h, in floats where it matters."""
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


def check_together(failures, program):
    """All start in one place, and are soon apart in every direction."""
    runs = {run(program, "cpu", threads, "together")[1] for threads in (1, 2, 7)}
    out = runs.pop()
    failures.check(not runs, f"a crowd that starts in one place has the same bits on 1, 2 and 7 threads: {out} {runs}")
    before, after = (list(map(float, re.findall(r"\d+\.\d+", line))) for line in out.splitlines()[1:3])
    failures.check(before == [0.0] * 4, f"it starts there: {before}")
    closest, _, x, y = after
    failures.check(closest > 0 and x > 5 and y > 5 and 0.8 < x / y < 1.25,
                   f"no two share a position, and it is as high as it is wide: {after}")


def main():
    source, build, folder = (Path(argument).resolve() for argument in sys.argv[1:4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    prefix = installed(build, folder)
    devices = check_files(failures, source, build, prefix)
    check_public_headers(failures, source, prefix)

    examples = shutil.copytree(source / "docs/examples", folder / "examples", ignore=shutil.ignore_patterns("build"))
    readme = (examples / "README.md").read_text()
    command = re.search(r"^cmake -B build .*$", readme, re.MULTILINE).group()
    if built(failures, command, examples, prefix, CXXFLAGS=" ".join(STRICT)):
        check_neighbours(failures, examples / "build/neighbours", readme)
        check_crowd(failures, examples / "build/crowd", readme.splitlines(), devices)
        check_together(failures, examples / "build/crowd")
    check_headers(failures, command, folder / "headers", prefix, devices)
    failures.finish()


if __name__ == "__main__":
    main()
