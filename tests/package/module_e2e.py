#!/usr/bin/env python3
"""A module of CPython and a shared library for ctypes, made of the library, in this process and in forked ones.

    module_e2e.py SOURCE BUILD FOLDER      skipped (77) without the headers of CPython

Counts are those of a recount. A forked child has none of its parent's threads, and computes all the same: with a queue
of its own, with one that the parent has used, and after giving that one back.
"""
import array
import ctypes
import os
import shutil
import signal
import sys
import sysconfig
import time
from pathlib import Path

from library import Failures, built, count_pairs, installed, random_points, skip, write_mine

ANSWERS_WITHIN_S = 30


def in_child(answers):
    """Whether answers() is true in a forked child, which ends without its parent's cleaning up."""
    child = os.fork()
    if child == 0:
        try:
            os._exit(0 if answers() else 1)
        finally:
            os._exit(2)
    end = time.monotonic() + ANSWERS_WITHIN_S
    while time.monotonic() < end:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return os.waitstatus_to_exitcode(status) == 0
        time.sleep(0.01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return False


def check_module(failures, module, points, wanted):
    xy = array.array("f", (number for point in points for number in point)).tobytes()
    found = [module.count_pairs(xy, 3.0) for _ in range(2)]
    failures.check(found == [wanted, wanted], f"the module finds {found}, a recount {wanted}")
    failures.check(in_child(lambda: module.count_pairs(xy, 3.0) == wanted), "so does a forked child")


def check_kept_queue(failures, library, points, wanted):
    xy = (ctypes.c_float * (2 * len(points)))(*(number for point in points for number in point))

    def count(function):
        function.restype = ctypes.c_uint64
        return function(xy, len(points), ctypes.c_float(3.0))

    def kept():
        return count(library.count_pairs_with_kept_queue) == wanted

    def all_ways():
        return kept() and count(library.count_pairs) == wanted and kept()

    def dropped():
        library.drop_kept_queue()
        return kept()

    failures.check(in_child(all_ways), "a child of a parent that has launched nothing counts")
    failures.check(all_ways(), f"a queue that is kept finds {wanted} neighbours")
    failures.check(in_child(all_ways), "a child counts with the queue that its parent has used")
    failures.check(in_child(dropped), "a child gives that queue back and makes another")
    failures.check(all_ways(), "the parent still has it")
    library.drop_kept_queue()


def main():
    source, build, folder = (Path(argument).resolve() for argument in sys.argv[1:4])
    if not (Path(sysconfig.get_paths()["include"]) / "Python.h").is_file():
        skip("the headers of CPython (python3-dev) are not here")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    user = shutil.copytree(source / "tests/package/user", folder / "project")
    write_mine(source, user / "mine")
    out, prefix = folder / "build", installed(build, folder)
    configure = ["cmake", "-S", user, "-B", out, "-DWAY=find_package", f"-DCMAKE_PREFIX_PATH={prefix}",
                 "-DUSER_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}"]
    if built(failures, configure, folder) and built(failures, ["cmake", "--build", out], folder):
        points = random_points(1000)
        wanted = count_pairs(points)
        sys.path.insert(0, str(out))
        import user_module
        check_module(failures, user_module, points, wanted)
        check_kept_queue(failures, ctypes.CDLL(str(out / "libuser_shared.so")), points, wanted)
    failures.finish()


if __name__ == "__main__":
    main()
