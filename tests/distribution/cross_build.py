"""The headless game for AArch64: cross-built on Debian with the toolchain file, run under qemu-user."""
import time

from game_steps import CLONE, Game
from native import cmake_version
from outcome import FAILED, PASSED
from root import APT_INSTALL, RESULTS

TRIPLET = "aarch64-linux-gnu"
TOOLS = (f"g++-{TRIPLET}", "cmake", "ninja-build", "qemu-user")
# The headless part of what tools/install_packages.sh installs for playing: headers for all, libraries for arm64.
HEADERS = ("libglm-dev", "libcli11-dev", "nlohmann-json3-dev", "libutfcpp-dev")
LIBRARIES = tuple(f"{name}:arm64" for name in (
    "libglew-dev", "libegl-dev", "libgl-dev", "libtomlplusplus-dev", "libxxhash-dev", "zlib1g-dev", "libfmt-dev",
    "libstb-dev", "libpugixml-dev"))
BUILD = "build/aarch64"
QUICK_TICKS = 1800  # longer replays take minutes each under emulation
LIMIT_S = 2 * 3600


def check_cross(root, outcome, source, quick):
    started = time.monotonic()
    why = fault_of_build(root)
    outcome.seconds["play"] = time.monotonic() - started
    outcome.notes.append("the minutes under ./play are those of installing and cross-building")
    outcome.compiler = f"{TRIPLET}-g++ {root.said('/', f'{TRIPLET}-g++', '-dumpfullversion')}"
    outcome.cmake = cmake_version(root)
    if not outcome.add("cross-build", FAILED if why else PASSED, why):
        return
    game = Game(root, outcome, "qemu-aarch64", f"{BUILD}/gpuwars")
    game.golden(source, QUICK_TICKS if quick else None)
    if game.fixed_run():
        why = fault_of_float_state(root, outcome)
        outcome.add("floating-point state", FAILED if why else PASSED, why)


def fault_of_float_state(root, outcome):
    """Why the fixed run does not end as it did when a library has changed FPCR before main()."""
    library = f"/{RESULTS}/rounds_up.so"
    if root.status(f"/{CLONE}", f"{TRIPLET}-gcc", "-shared", "-fPIC", "-o", library, "tests/distribution/rounds_up.c"):
        return "the library that changes it does not compile"
    changed = Game(root, outcome, "qemu-aarch64", "-E", f"LD_PRELOAD={library}", f"{BUILD}/gpuwars")
    found, why = changed.played()
    return why or ("" if found == outcome.hash else f"rounding upwards before main(), the fixed run ends on {found}")


def fault_of_build(root):
    """Why there is no program; empty when it is built."""
    install = (*APT_INSTALL, *TOOLS, *HEADERS, *LIBRARIES)
    configure = ("cmake", "-S", ".", "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                 f"-DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/{TRIPLET}.cmake", "-DGW_CUDA=OFF", "-DGW_WINDOW=OFF",
                 "-DGW_TESTS=OFF")
    for what, command in (("dpkg does not take arm64", ("dpkg", "--add-architecture", "arm64")),
                          ("apt-get update failed", ("apt-get", "update", "-q")),
                          ("the packages could not be installed", install),
                          ("CMake failed", configure),
                          ("it does not compile", ("cmake", "--build", BUILD, "--target", "gpuwars"))):
        status = root.status(f"/{CLONE}", *command, limit_s=LIMIT_S)
        if status:
            return f"{what} (exit status {status})"
    return ""
