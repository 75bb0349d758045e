"""The library installed as users get it, and what the tests of it share.

CXX and others in the environment say what to compile with.
"""
import os
import random
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
from program import Failures, run, skip  # noqa: E402, F401

STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
COMPILER = os.environ.get("CXX", "c++")


def installed(build, folder):
    """The prefix, moved after installing."""
    subprocess.run(["cmake", "--install", build, "--component", "gpu", "--prefix", folder / "installed"], check=True,
                   stdout=subprocess.DEVNULL)
    return (folder / "installed").rename(folder / "moved")


def cached(build, name):
    return re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE).group(1)


def libraries(build, prefix):
    return prefix / cached(build, "CMAKE_INSTALL_LIBDIR")


def built(failures, command, folder, prefix=None, **variables):
    """Runs a command, of a shell when it is a text, in the folder; says whether it succeeded."""
    environment = {**os.environ, "PREFIX": str(prefix), "CMAKE_BUILD_PARALLEL_LEVEL": "2",
                   "CCACHE_BASEDIR": str(folder), "CCACHE_NOHASHDIR": "1", **variables}
    result = subprocess.run(command, shell=isinstance(command, str), cwd=folder, env=environment,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False)
    words = command if isinstance(command, str) else " ".join(map(str, command))
    failed = result.returncode != 0
    return failures.check(not failed, f"builds: {words}" + "\n" * failed + result.stdout * failed)


def write_mine(source, folder):
    """A user's own headers of all names that the library's have, in gpu/ and beside it: none may be taken for one."""
    (folder / "gpu").mkdir(parents=True)
    for header in (source / "gpu").rglob("*.h"):
        for place in (folder, folder / "gpu"):
            (place / header.name).write_text('#error "The header of the user was taken for that of the library"\n')
    (folder / "gpu/buffer.h").write_text("#pragma once\n#include <gpuwars/plain_types.h>\n#include <vector>\n"
                                         "namespace mine {\nusing Buffer = std::vector<gw::Cell>;\n}\n")
    (folder / "buffer.h").write_text('#pragma once\n#include "gpu/buffer.h"\n')
    return folder


def random_points(count):
    """In a square of 100 m, on a lattice so fine that all arithmetic on them is exact in floats."""
    generator = random.Random(5)
    return [(generator.randrange(6400) / 64, generator.randrange(6400) / 64) for _ in range(count)]


def count_pairs(points, radius=3.0):
    """How many neighbours all have together, by looking at all pairs."""
    return sum((x - u) ** 2 + (y - v) ** 2 <= radius * radius for x, y in points for u, v in points) - len(points)
