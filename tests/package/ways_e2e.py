#!/usr/bin/env python3
"""Another author's project takes the library in, in one of four ways.

    ways_e2e.py WAY SOURCE BUILD FOLDER [--cuda]      find_package, add_subdirectory, fetch_content or pkg_config

It is strict, has files of the library's names, makes a program and a shared library with a kernel of its own, and finds
as many neighbours as a recount. None of its own settings changes. --cuda: it enables CUDA as well, and then gets it.
"""
import ctypes
import shutil
import subprocess
import sys
from pathlib import Path

from library import (COMPILER, STRICT, Failures, built, cached, count_pairs, installed, libraries, random_points, skip,
                     write_mine)


def output(*command, **options):
    result = subprocess.run(command, stdin=None if "input" in options else subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, check=False, **options)
    return result.returncode, result.stdout


class Way:
    def __init__(self, name, source, build, folder):
        self.name, self.source, self.build, self.folder = name, source, build, folder
        self.failures = Failures()
        self.user = shutil.copytree(source / "tests/package/user", folder / "project")
        write_mine(source, self.user / "mine")
        self.prefix = installed(build, folder) if name in ("find_package", "pkg_config") else None

    def configure(self, out, *options):
        return ["cmake", "-S", self.user, "-B", out, f"-DWAY={self.name}", f"-DGPUWARS_SOURCE={self.source}",
                f"-DCMAKE_PREFIX_PATH={self.prefix or ''}", "-DCMAKE_BUILD_TYPE=Debug", *options]

    def built(self, command, **variables):
        return built(self.failures, command, self.folder, self.prefix, **variables)

    def by_cmake(self):
        """Builds everything, and looks for what was not asked for."""
        out, check = self.folder / "build", self.failures.check
        if not (self.built(self.configure(out)) and self.built(["cmake", "--build", out])):
            return None
        made = {path.name for path in out.iterdir() if path.is_file() and path.stat().st_mode & 0o111}
        check(made == {"user", "devices", "libuser_shared.so"}, f"no programs but the user's: {sorted(made)}")
        check(not (out / "compile_commands.json").exists(), "no compile commands")
        check("Total Tests: 0" in output("ctest", "-N", cwd=out)[1], "no tests")
        code, _ = output("cmake", "--install", out, "--prefix", self.folder / "none")
        check(code == 0 and not (self.folder / "none").exists(), "installs nothing")
        return out

    def by_pkg_config(self):
        if not shutil.which("pkg-config"):
            skip("pkg-config is not here")
        where = {"PKG_CONFIG_PATH": str(libraries(self.build, self.prefix) / "pkgconfig")}
        compiler = " ".join([COMPILER, *STRICT, "-fPIC", f"-I{self.user}/mine", "$(pkg-config --cflags gpuwars)",
                             "-x c++"])
        for name, options in (("user", "kernels/count.cu main.cpp"), ("devices", "devices.cpp"),
                              ("libuser_shared.so", "kernels/count.cu shared.cpp -shared")):
            if not self.built(f"cd {self.user} && {compiler} {options} -x none $(pkg-config --libs gpuwars) "
                              f"-o {self.folder / name}", **where):
                return None
        return self.folder

    def check_results(self, out):
        check, points = self.failures.check, random_points(1000)
        wanted = count_pairs(points)
        _, text = output(out / "user", input="".join(f"{x} {y}\n" for x, y in points))
        check(f"cpu {wanted}\n" in text, f"the program finds {wanted} neighbours: {text!r}")
        _, text = output(out / "devices")
        check("cpu" in text.split(), f"the program without kernels lists devices: {text.split()}")
        count = ctypes.CDLL(str(out / "libuser_shared.so")).count_pairs
        count.restype = ctypes.c_uint64
        xy = (ctypes.c_float * (2 * len(points)))(*(number for point in points for number in point))
        found = count(xy, len(points), ctypes.c_float(3.0))
        check(found == wanted, f"the shared library finds {found}")

    def check_cuda(self):
        """CUDA among the languages of the project is enough, and GW_CUDA alone is not, where it cannot be."""
        out, check = self.folder / "cuda", self.failures.check
        if self.built(self.configure(out, "-DUSER_CUDA=ON", "-DCMAKE_CUDA_ARCHITECTURES=80")):
            check(cached(out, "CMAKE_CUDA_ARCHITECTURES") == "80", "the architectures stay the user's")
            self.built(["cmake", "--build", out, "--target", "user_kernels_cuda"])
        if self.name != "find_package":
            code, text = output(*self.configure(self.folder / "asks", "-DGW_CUDA=ON"))
            check(code != 0 and "LANGUAGES CXX CUDA" in text, f"GW_CUDA without CUDA is refused, with a remedy: {text}")


def main():
    name, *folders = sys.argv[1:5]
    source, build, folder = (Path(argument).resolve() for argument in folders)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    way = Way(name, source, build, folder)
    out = way.by_pkg_config() if name == "pkg_config" else way.by_cmake()
    if out:
        way.check_results(out)
    if "--cuda" in sys.argv:
        way.check_cuda()
    way.failures.finish()


if __name__ == "__main__":
    main()
