#!/usr/bin/env python3
"""The packages on a bare Debian 13: built there, installed, played from the menu's entry, used as a library, removed.

    deb_installed.py SOURCE FOLDER [--debs DIR]      DIR: packages that were built on Debian 13 before

Needs root's rights, debootstrap, Xvfb, and the mirror of Debian that apt uses here; else it is skipped. Roots are those
of tests/distributions.
"""
import argparse
import os
import re
import shutil
import stat
import subprocess
import sys
import time
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / name) for name in ("e2e", "gates", "distribution")]
import deb_tools  # noqa: E402
import gate_tools  # noqa: E402
from mirror import NoMirror, apt_settings, check_answers, machine_mirror, proxies  # noqa: E402
from program import Failures, skip  # noqa: E402
from root import APT_INSTALL, RESULTS, Cannot, Failed, Roots, check_machine  # noqa: E402
from screen import Screen, lit  # noqa: E402

RELEASE = "trixie"
TREE = "usr/src/gpuwars"
HOME = "/".join(("", "home", "player"))  # in pieces: no place of a developer's machine
PLAYER = ("setpriv", "--reuid=player", "--regid=player", "--clear-groups",
          "env", "-i", f"HOME={HOME}", "USER=player", "XDG_RUNTIME_DIR=/run/user/player",
          "PATH=/usr/local/bin:/usr/bin:/bin:/usr/local/games:/usr/games", "LANG=C.UTF-8")
WITHOUT_AVX2 = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2"  # what the dynamic loader is to believe
# Of the base directory specification, and what the tests write themselves.
MAY_CHANGE = re.compile(r"home/player(/\.local)?|home/player/\.(config|cache|local/share|local/state)(/.*)?"
                        rf"|run/user/player(/.*)?|tmp|{RESULTS}(/.*)?")
NO_FILES = re.compile(rf"dev|proc|sys|run|var/cache/apt/archives(/.*)?|{RESULTS}/.*")


def paths_of(root):
    """What lies in a root: path to what changes when a program writes there."""
    found = {}
    for folder, names, files in os.walk(root.path):
        inside = Path(folder).relative_to(root.path)
        for name in names + files:
            path = (inside / name).as_posix()
            if NO_FILES.fullmatch(path):
                continue
            facts = os.lstat(root.path / path)
            found[path] = (facts.st_mode, facts.st_mtime_ns, 0 if stat.S_ISDIR(facts.st_mode) else facts.st_size)
        names[:] = [name for name in names if not NO_FILES.fullmatch((inside / name).as_posix())]
    return found


def changed(before, after):
    return sorted(path for path in before.keys() | after.keys() if before.get(path) != after.get(path))


def must(root, *command, folder="/", limit_s=3600):
    if root.status(folder, *command, limit_s=limit_s) != 0:
        raise Failed(f"{' '.join(command[:4])} ... fails; see {root.log}")


def built_packages(source, roots, log):
    """The commands of docs/guide/building.md on a Debian 13 with what play needs."""
    root = roots.fresh_copy(RELEASE, "package_builder", log)
    for name in gate_tools.repository_files(source):
        (root.path / TREE / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source / name, root.path / TREE / name)
    must(root, "tools/install_packages.sh", "play", folder=f"/{TREE}")
    must(root, *APT_INSTALL, "dpkg-dev", "file")
    must(root, "cmake", "--preset", "package", folder=f"/{TREE}")
    must(root, "cmake", "--build", "--preset", "package", folder=f"/{TREE}", limit_s=7200)
    kept = roots.folder / "debs"
    shutil.rmtree(kept, ignore_errors=True)
    kept.mkdir(parents=True)
    for deb in (root.path / TREE / "build/package").glob("*.deb"):
        shutil.copy2(deb, kept)
    root.remove()
    return kept


def installed_root(roots, debs, log):
    """A bare root with the packages and what they depend on, and a player."""
    root = roots.fresh_copy(RELEASE, "package_bare", log)
    must(root, "useradd", "--create-home", "player")
    must(root, "install", "--directory", "--owner=player", "--mode=0700", "/run/user/player")
    must(root, "apt-get", "update", "-q")
    for deb in debs:
        shutil.copy2(deb, root.results)
    must(root, *APT_INSTALL, *(f"/{RESULTS}/{deb.name}" for deb in debs))
    return root


def check_menu(failures, root, screen):
    """What the menu's entry names is there, shows the game, and leaves at Escape."""
    command, keys = deb_tools.command_of(root.path / "usr/share/applications/gpuwars.desktop")
    failures.check(deb_tools.icon_files(root.path, keys["Icon"]), f"the icon {keys['Icon']} is there")
    before = paths_of(root)
    variables = (f"DISPLAY={screen.environment['DISPLAY']}", "SDL_VIDEODRIVER=x11", "SDL_AUDIODRIVER=dummy")
    with root.log.open("a") as log:
        game = subprocess.Popen(root.command("/", *PLAYER, *variables, *command), stdin=subprocess.DEVNULL, stdout=log,
                                stderr=log, start_new_session=True)
    shown = screen.wait_for(lambda pixels: lit(pixels) > 2000, 120)
    failures.check(shown, f"'{keys['Exec']}' shows the title")
    if shown:
        time.sleep(1)
        title = screen.picture("title.png")
        screen.keys("key", "m")  # a setting, which is written down
        screen.keys("key", "Return")
        time.sleep(2)
        failures.check(screen.picture("play.png") != title, "and plays")
        for key in ("Escape", "q", "Escape"):
            screen.keys("key", key)
            time.sleep(1.5)
    try:
        code = game.wait(timeout=30)
    except subprocess.TimeoutExpired:
        os.killpg(game.pid, 9)
        code = game.wait()
    failures.check(code == 0, f"it leaves with {code}")
    check_writes(failures, before, root, "playing from the menu")


def check_writes(failures, before, root, what):
    written = changed(before, paths_of(root))
    stray = [path for path in written if not MAY_CHANGE.fullmatch(path)]
    folders = sorted({"/".join(path.split("/")[:4]) for path in written})
    failures.check(not stray, f"{what} writes below the player's base folders: {folders}; elsewhere: {stray}")


def check_anywhere(failures, root):
    """From any folder, one that cannot be written to included, and with either set of kernels."""
    before = paths_of(root)
    found = []
    for folder, variables in (("/", ()), ("/usr/games", (WITHOUT_AVX2,)), (HOME, ())):
        said = root.said(folder, *PLAYER, *variables, "gpuwars", "play", "--headless", "--autopilot", "expert",
                         "--ticks", "600", "--device", "cpu", "--hashes", "-")
        kernels = root.said(folder, *PLAYER, *variables, "sh", "-c", "gpuwars devices | grep kernels")
        found.append(re.findall(r"^\d+ [0-9a-f]{16}$", said, re.MULTILINE))
        failures.check(len(found[-1]) == 600 and found[-1] == found[0],
                       f"in {folder} it plays {len(found[-1])} ticks, the same as in /; {kernels}")
    check_writes(failures, before, root, "a run without a window")


def check_library(failures, root):
    """The examples as installed, with the command that their README gives."""
    must(root, *APT_INSTALL, "cmake", "g++", "make")
    readme = (root.path / "usr/share/doc/libgpuwars-dev/examples/README.md").read_text()
    command = re.search(r"^cmake -B build .*$", readme, re.MULTILINE).group()
    must(root, "cp", "-r", "/usr/share/doc/libgpuwars-dev/examples", "/var/tmp/examples")
    status = root.status("/var/tmp/examples", "sh", "-c", f"PREFIX=/usr; {command}")
    first = root.said("/var/tmp/examples", "sh", "-c", "build/neighbours | head -n 1")
    failures.check(status == 0 and first and first in readme, f"the library's examples build and run: {status} {first}")
    must(root, "rm", "-r", "/var/tmp/examples")


def check_removal(failures, root, debs):
    installed = {path for deb in debs for path in deb_tools.members(deb)}
    must(root, "dpkg", "--purge", "gpuwars", "libgpuwars-dev")
    left = sorted(path for path in paths_of(root)
                  if "gpuwars" in path and not path.startswith(("home/player/", "var/log/")))
    owned = set(root.said("/", "sh", "-c", "cat /var/lib/dpkg/info/*.list").splitlines())
    left += sorted(path for path in installed if (root.path / path).exists() and f"/{path}" not in owned)
    failures.check(not left, f"purged, nothing of {len(installed)} files and folders is left: {left}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--debs", type=Path)
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    log = folder / "log"
    log.write_text("")
    settings = apt_settings()
    failures = Failures()
    try:
        check_machine()
        mirror = machine_mirror().rstrip("/")
        check_answers(mirror, RELEASE, proxies(settings, os.environ))
    except (Cannot, NoMirror) as why:
        skip(str(why))
    screen = Screen(folder)
    try:
        kept = Path(os.environ.get("GW_DISTRIBUTIONS", arguments.source / "build/distributions")).resolve()
        roots = Roots(kept, mirror, settings, lambda *_: None)
        where = arguments.debs or built_packages(arguments.source.resolve(), roots, log)
        debs = sorted(where.resolve().glob("*.deb"))
        failures.check(len(debs) == 2, f"two packages: {[deb.name for deb in debs]}")
        root = installed_root(roots, debs, log)
        check_menu(failures, root, screen)
        check_anywhere(failures, root)
        check_library(failures, root)
        check_removal(failures, root, debs)
        if failures.count == 0:
            root.remove()
    except Failed as why:
        failures.check(False, str(why))
    finally:
        screen.close()
    failures.finish()


if __name__ == "__main__":
    main()
