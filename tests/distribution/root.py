"""Minimal roots of Debian releases: made once, copied for each run, entered as a machine of their own."""
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

from mirror import proxies

HERE = Path(__file__).resolve().parent
ARCHITECTURE = "amd64"
ROOT_DAYS = 14  # older ones are rebuilt: a testing release moves on
APART = ("unshare", "--mount", "--pid", "--fork", "--kill-child=KILL", "--")  # what is mounted ends with the command
APT_INSTALL = ("env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "install", "-y", "-q", "--no-install-recommends")
RESULTS = "var/tmp/distributions"  # in a root: what steps write for this side to read


class Cannot(Exception):
    """One sentence: what this machine lacks for making and entering roots."""


class Failed(Exception):
    """One sentence: what went wrong."""


def check_machine():
    """Raises Cannot."""
    if os.uname().machine != "x86_64":
        raise Cannot(f"roots are made for x86-64, and this machine is {os.uname().machine}")
    for tool, package in (("debootstrap", "debootstrap"), ("unshare", "util-linux"), ("git", "git")):
        if shutil.which(tool) is None:
            raise Cannot(f"{tool} is not here; install the package {package}")
    tried = subprocess.run([*APART, "true"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    if tried.returncode != 0:
        raise Cannot(f"root's rights are missing ({tried.stderr.strip() or 'unshare fails'})")


def run_logged(command, log, limit_s, progress, environment=None):
    """The exit status of a command that writes to a log and has no terminal; every process of it is gone afterwards, on
    Ctrl-C too. progress(seconds, log) is called once a second."""
    started = time.monotonic()
    with log.open("ab") as out:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                 start_new_session=True, env=environment)
        try:
            while True:
                try:
                    return child.wait(timeout=1)
                except subprocess.TimeoutExpired:
                    seconds = time.monotonic() - started
                    progress(seconds, log)
                    if seconds > limit_s:
                        raise Failed(f"it was stopped at its limit of {limit_s / 60:.0f} minutes") from None
        finally:
            if child.poll() is None:
                os.killpg(child.pid, signal.SIGKILL)
                child.wait()


class Roots:
    """The folder that keeps roots, downloaded packages and copies in use."""

    def __init__(self, folder, mirror, settings, progress):
        self.folder, self.mirror, self.settings, self.progress = folder, mirror, settings, progress
        self.environment = {**os.environ, **proxies(settings, os.environ)}

    def fresh_copy(self, release, name, log):
        """A Root, nothing but what debootstrap makes in it."""
        pristine, copy = self.folder / "roots" / release, self.folder / "runs" / name
        if not self._is_young(pristine):
            self._make(release, pristine, log)
        remove(copy)
        copy.parent.mkdir(parents=True, exist_ok=True)
        if run_logged(["cp", "-a", "--reflink=auto", pristine, copy], log, 1800, self.progress) != 0:
            raise Failed("its root could not be copied")
        return Root(copy, self._packages(release), self, log)

    def _packages(self, release):
        packages = self.folder / "packages" / release
        (packages / "partial").mkdir(parents=True, exist_ok=True)
        return packages

    @staticmethod
    def _is_young(pristine):
        return pristine.is_dir() and time.time() - pristine.stat().st_mtime < ROOT_DAYS * 86400

    def _make(self, release, pristine, log):
        part = pristine.with_name(release + ".part")
        remove(part)
        part.parent.mkdir(parents=True, exist_ok=True)
        command = ["debootstrap", "--variant=minbase", f"--arch={ARCHITECTURE}",
                   f"--cache-dir={self._packages(release)}"]
        if self.mirror.startswith("https:"):
            command.append("--include=ca-certificates")
        command += [release, str(part), self.mirror]
        scripts = Path(os.environ.get("DEBOOTSTRAP_DIR", "/usr/share/debootstrap")) / "scripts"
        if not (scripts / release).exists():
            command.append(str(scripts / "sid"))  # newer than debootstrap itself: made as the newest it knows
        if run_logged([*APART, *command], log, 3600, self.progress, self.environment) != 0:
            raise Failed("debootstrap could not make its root")
        settings = part / "etc/apt/apt.conf.d"
        settings.mkdir(parents=True, exist_ok=True)
        (settings / "90of-this-machine").write_text(self.settings)
        dpkg = part / "etc/dpkg/dpkg.cfg.d"
        dpkg.mkdir(parents=True, exist_ok=True)
        (dpkg / "thrown-away-soon").write_text("force-unsafe-io\n")
        remove(pristine)
        os.utime(part)
        part.rename(pristine)


class Root:
    """A copy in use. Commands run in `folder`, a path inside it."""

    def __init__(self, path, packages, roots, log):
        self.path, self.packages, self.roots, self.log = path, packages, roots, log
        self.results = path / RESULTS
        self.results.mkdir(parents=True, exist_ok=True)
        if Path("/etc/resolv.conf").is_file():
            (path / "etc").mkdir(exist_ok=True)
            shutil.copyfile("/etc/resolv.conf", path / "etc/resolv.conf")

    def command(self, folder, *arguments):
        variables = [f"{key}={value}" for key, value in proxies(self.roots.settings, os.environ).items()]
        return [*APART, str(HERE / "enter_root.sh"), str(self.path), str(self.packages), folder, *variables,
                *map(str, arguments)]

    def status(self, folder, *arguments, limit_s=3600):
        """Runs a command to its end; what it says goes to the log."""
        with self.log.open("a") as log:
            log.write(f"\n== {' '.join(map(str, arguments))}\n")
        return run_logged(self.command(folder, *arguments), self.log, limit_s, self.roots.progress)

    def said(self, folder, *arguments):
        """What a short command prints, without the last line's end."""
        ended = subprocess.run(self.command(folder, *arguments), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True, check=False, start_new_session=True)
        return ended.stdout.strip()

    def remove(self):
        remove(self.path)


def remove(folder):
    """What is mounted in it stays."""
    subprocess.run(["rm", "-rf", "--one-file-system", folder], check=True)
