"""Debian packages: made from a build folder, and taken apart."""
import io
import os
import shutil
import subprocess
import tarfile
from pathlib import Path


def missing_tools():
    """What this machine lacks of what makes packages; empty: nothing."""
    return [tool for tool in ("cpack", "dpkg-deb", "dpkg-shlibdeps", "file", "gzip", "strip") if not shutil.which(tool)]


def make(build, folder, umask=0o022):
    """The packages of a build, by name; cpack leaves everything else that it makes in `folder`, too."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    environment = {key: value for key, value in os.environ.items() if key != "SOURCE_DATE_EPOCH"}
    run = subprocess.run(["cpack", "--config", str(build / "CPackConfig.cmake"), "-B", str(folder)], text=True, cwd=build,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment, check=False, umask=umask)
    if run.returncode != 0:
        raise RuntimeError(f"cpack failed:\n{run.stdout}")
    return {path.name.split("_")[0]: path for path in folder.glob("*.deb")}


def archives(deb):
    """The two archives in a package: what dpkg is told, and what it installs. Around them are headers of which the modes
    are the umask's."""
    return [subprocess.run(["dpkg-deb", option, str(deb)], stdout=subprocess.PIPE, check=True).stdout
            for option in ("--ctrl-tarfile", "--fsys-tarfile")]


def members(deb):
    """What a package installs: TarInfo by path, "usr/games/gpuwars"."""
    with tarfile.open(fileobj=io.BytesIO(archives(deb)[1])) as archive:
        return {member.name.removeprefix("./").rstrip("/"): member for member in archive if member.name not in (".", "./")}


def field(deb, name):
    return subprocess.run(["dpkg-deb", "--field", str(deb), name], stdout=subprocess.PIPE, text=True,
                          check=True).stdout.strip()


def unpack(deb, folder):
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run(["dpkg-deb", "--extract", str(deb), str(folder)], check=True)
    return folder


def command_of(desktop):
    """The words that a menu runs for a desktop entry without files."""
    keys = dict(line.split("=", 1) for line in desktop.read_text().splitlines() if "=" in line)
    return [word for word in keys["Exec"].split() if not word.startswith("%")], keys


def icon_files(root, name):
    return sorted(path.relative_to(root).as_posix() for path in Path(root).glob(f"usr/share/icons/hicolor/*/apps/{name}.*"))
