"""Builds mutants: a copy of the sources, configured once, in which one file at a time is changed and put back."""
import hashlib
import os
import subprocess
from contextlib import contextmanager
from pathlib import Path

COPIED = ("CMakeLists.txt", "cmake", "game", "gpu", "host", "render")
DECISIVE = ("cmake", "game/sim", "gpu")  # what an outcome may depend on, beside the replays: all else must verify
OPTIONS = ("-DCMAKE_BUILD_TYPE=Release", "-DGW_CUDA=OFF", "-DGW_WINDOW=OFF", "-DGW_TESTS=OFF")


class DoesNotCompile(Exception):
    """The change is no C++."""


class Failed(Exception):
    """One sentence: the unchanged sources do not build or do not verify."""


def files_under(root, names):
    """The files of folders and files, in a fixed order."""
    for name in names:
        path = root / name
        yield from [path] if path.is_file() else sorted(found for found in path.rglob("*") if found.is_file())


class Workshop:
    """`folder`: where copy and build lie, build/mutants as a rule."""

    def __init__(self, root, folder, jobs):
        self.root, self.source, self.build, self.jobs = root, folder / "source", folder / "build", jobs
        self.environment = dict(os.environ, CCACHE_BASEDIR=str(self.source), CCACHE_NOHASHDIR="1")

    def prepare(self):
        """The program of the unchanged sources."""
        self._copy()
        if not (self.build / "build.ninja").exists():
            self._must("configure", ["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", *OPTIONS])
        self._must("build", self._ninja())
        return self.build / "gpuwars"

    @contextmanager
    def built(self, mutant):
        """The mutant's program, until the end of the block; raises DoesNotCompile."""
        file = self.source / mutant.file
        text = file.read_text(encoding="utf-8")
        file.write_text(mutant.applied(text), encoding="utf-8")
        try:
            if self._run(self._ninja()).returncode:
                raise DoesNotCompile(mutant.name)
            yield self.build / "gpuwars"
        finally:
            file.write_text(text, encoding="utf-8")

    def _ninja(self):
        return ["ninja", "-C", self.build, "-j", str(self.jobs), "gpuwars"]

    def _run(self, command):
        return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", env=self.environment, check=False)

    def _must(self, what, command):
        result = self._run(command)
        if result.returncode:
            raise Failed(f"The unchanged sources do not {what}; make that work first.\n{result.stdout[-4000:]}")

    def _copy(self):
        """Writes only what differs, so that only that is built; deletes what is gone."""
        wanted = {path.relative_to(self.root) for path in files_under(self.root, COPIED)}
        for name in wanted:
            copy, content = self.source / name, (self.root / name).read_bytes()
            if not copy.is_file() or copy.read_bytes() != content:
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_bytes(content)
        for path in list(files_under(self.source, COPIED)) if self.source.exists() else []:
            if path.relative_to(self.source) not in wanted:
                path.unlink()


def digest(root, replays):
    """Of everything that an outcome may depend on: another digest, another outcome."""
    sums = hashlib.sha256()
    for path in [*files_under(root, DECISIVE), *map(Path, replays)]:
        name = path.relative_to(root) if path.is_relative_to(root) else path.name
        sums.update(f"{name}\0".encode() + hashlib.sha256(path.read_bytes()).digest())
    return sums.hexdigest()
