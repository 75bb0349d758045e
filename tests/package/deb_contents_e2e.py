#!/usr/bin/env python3
"""cpack makes two packages of this build that hold what they should, play from wherever they are unpacked, and hold the
same when they are made again.

    deb_contents_e2e.py SOURCE BUILD FOLDER       leaves them in FOLDER/debs
"""
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "e2e"))
import deb_tools  # noqa: E402
from program import Failures, run, skip  # noqa: E402

SIZES = ("16x16", "24x24", "32x32", "48x48", "64x64", "128x128", "256x256")


def wanted(verbs, library, variants):
    game = {"usr/games/gpuwars", "usr/share/applications/gpuwars.desktop", "usr/share/gpuwars/assets/game.toml",
            "usr/share/metainfo/org.gpuwars.gpuwars.metainfo.xml", "usr/share/bash-completion/completions/gpuwars",
            "usr/share/icons/hicolor/scalable/apps/gpuwars.svg", "usr/share/man/man6/gpuwars.6.gz",
            "usr/share/doc/gpuwars/copyright", "usr/share/doc/gpuwars/changelog.gz",
            f"{library}/gpuwars/libgpuwars-cpu.so"}
    game |= {f"usr/share/icons/hicolor/{size}/apps/gpuwars.png" for size in SIZES}
    game |= {f"usr/share/man/man6/gpuwars-{verb}.6.gz" for verb in verbs}
    game |= {f"{library}/gpuwars/glibc-hwcaps/{variant}/libgpuwars-cpu.so" for variant in variants}
    developer = {f"{library}/libgw_gpu_host.a", f"{library}/libgw_gpu_cpu.a",
                 f"{library}/cmake/gpuwars/gpuwarsConfig.cmake", "usr/share/doc/libgpuwars-dev/copyright", "usr/share/doc/libgpuwars-dev/changelog.gz"}
    return {"gpuwars": game, "libgpuwars-dev": developer}


# Nothing lies elsewhere: what belongs to the game alone below its name, the rest in folders made for such files.
PLACES = {
    "gpuwars": re.compile(r"usr/(games/gpuwars|lib/.*gpuwars/.*libgpuwars-cpu\.so|share/gpuwars/assets/.*"
                          r"|share/(applications|metainfo|man/man6|icons/hicolor/\w+/apps|bash-completion/completions"
                          r"|lintian/overrides)/[\w.-]*gpuwars[\w.-]*|share/doc/gpuwars/.*)"),
    "libgpuwars-dev": re.compile(r"usr/(include/(gpu|gpuwars)/.*|lib/.*libgw_gpu_\w+\.a|lib/.*cmake/gpuwars/.*"
                                 r"|lib/.*pkgconfig/gpuwars\.pc|share/doc/libgpuwars-dev/.*"
                                 r"|share/lintian/overrides/libgpuwars-dev)"),
}


def check_contents(failures, name, deb, files, epoch):
    found = deb_tools.members(deb)
    plain = {path for path, member in found.items() if not member.isdir()}
    stray = sorted(path for path in plain if not PLACES[name].fullmatch(path))
    failures.check(files <= plain and not stray,
                   f"{name}: {len(plain)} files; missing {sorted(files - plain)}, elsewhere {stray}")
    odd = [path for path, member in found.items()
           if (member.uid, member.gid) != (0, 0) or member.mtime != epoch
           or member.mode != (0o755 if member.isdir() or path == "usr/games/gpuwars" else 0o644)]
    failures.check(not odd, f"{name}: all of root, dated by the changelog, written by root alone: {odd[:5]}")


def check_fields(failures, debs, version):
    for name, section in (("gpuwars", "games"), ("libgpuwars-dev", "libdevel")):
        values = [deb_tools.field(debs[name], key) for key in ("Package", "Version", "Section")]
        failures.check(values == [name, version, section], f"{name}: says who it is: {values}")
    depends = deb_tools.field(debs["gpuwars"], "Depends")
    failures.check(all(re.search(rf"\b{library}", depends) for library in ("libc6", "libsdl2", "libopenal1", "libglew"))
                   and "gpuwars" not in depends, f"needs what it is linked with: {depends}")


def check_program(failures, root):
    """It plays with the assets beside it, whatever folder it is started in."""
    program = root / "usr/games/gpuwars"
    arguments = ("play", "--headless", "--autopilot", "expert", "--ticks", "30", "--device", "cpu", "--hashes", "-")
    code, out, err = run(program, *arguments)
    failures.check(code == 0 and out.count("\n") >= 30, f"unpacked, it plays: {code} {err.strip()}")
    table = root / "usr/share/gpuwars/assets/game.toml"
    text = table.read_text()
    table.write_text("damaged = [\n")
    code, _, err = run(program, *arguments)
    table.write_text(text)
    failures.check(code == 3 and str(table) in err, f"with the assets beside it: {code} {err.strip()}")


def check_menu(failures, root):
    entry = root / "usr/share/applications/gpuwars.desktop"
    command, keys = deb_tools.command_of(entry)
    failures.check((root / "usr/games" / command[0]).is_file(), f"the menu's entry starts it: {command}")
    icons = deb_tools.icon_files(root, keys["Icon"])
    failures.check(len(icons) == len(SIZES) + 1, f"with icons of {len(icons)} sizes")


def verbs_of(program):
    """As --help lists them."""
    out = subprocess.run([str(program), "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    return re.findall(r"^  (\w+) ", out.split("Verbs:")[1], re.MULTILINE)


def cached(build, name):
    return re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE).group(1)


def main():
    source, build, folder = (Path(argument).resolve() for argument in sys.argv[1:4])
    lacking = deb_tools.missing_tools()
    if lacking:
        skip(f"packages cannot be made here without {', '.join(lacking)}")
    failures = Failures()
    debs = deb_tools.make(build, folder / "debs")
    if not failures.check(sorted(debs) == ["gpuwars", "libgpuwars-dev"], f"two packages: {sorted(debs)}"):
        failures.finish()

    first = (source / "cmake/packages/debian/changelog.in").read_text().splitlines()[0]
    version = re.match(r"gpuwars \(([\d.]+)\)", first).group(1)
    check_fields(failures, debs, version)
    epoch = int(re.search(r"SOURCE_DATE_EPOCH} (\d+)", (build / "package/cpack_options.cmake").read_text()).group(1))
    library = "usr/" + cached(build, "CMAKE_INSTALL_LIBDIR")
    variants = [path.parent.name for path in (build / "packaged").glob("**/glibc-hwcaps/*/libgpuwars-cpu.so")]
    root = deb_tools.unpack(debs["gpuwars"], folder / "unpacked")
    for name, files in wanted(verbs_of(root / "usr/games/gpuwars"), library, variants).items():
        check_contents(failures, name, debs[name], files, epoch)
    check_program(failures, root)
    check_menu(failures, root)

    again = deb_tools.make(build, folder / "again", umask=0o077)
    different = [name for name in debs if deb_tools.archives(debs[name]) != deb_tools.archives(again[name])]
    failures.check(not different, f"made again, under another umask, they hold the same: {different}")
    failures.finish()


if __name__ == "__main__":
    main()
