"""Runs our programs: where they are, which libraries they find, for how long they may, what they have said."""
import dataclasses
import os
import re
import shlex
import signal
import subprocess
import time
from pathlib import Path

# A game that outlives its device is fine for who plays it, and no test of that device.
FELL_BACK = re.compile(r"^.*(?:game goes on with the cpu device|cpu device plays instead).*$", re.MULTILINE)
KERNELS = re.compile(r"\b([\d,]+) CUDA kernels run\b")


@dataclasses.dataclass
class Finished:
    command: str
    status: int
    text: str  # stdout and stderr together
    seconds: float
    limit: float
    stopped: bool  # it reached its limit
    fell_back: str  # what it said when it went on without its device

    @property
    def fine(self):
        return self.status == 0 and not self.stopped and not self.fell_back

    @property
    def why(self):
        """Of a failure, in a few words and what it said last."""
        if self.stopped:
            return f"stopped at its limit of {self.limit:.0f} s"
        if self.fell_back:
            return f"went on without its device: {self.fell_back}"
        said = self.text.strip().splitlines()
        return f"exit status {self.status}" + (f": {said[-1]}" if said else "")


class Programs:
    """The programs of one folder, within a time for all of them."""

    def __init__(self, folder, outcome, logs, total_s):
        self.folder, self.outcome, self.device = Path(folder).resolve(), outcome, outcome.device
        self.logs = Path(logs)  # for what programs write
        self.ends = time.monotonic() + total_s
        self.environment = dict(os.environ)
        if self.device == "cpu":  # on a machine that has a GPU: nothing may touch it
            self.environment["CUDA_VISIBLE_DEVICES"] = ""
        self._find_libraries()

    def _find_libraries(self):
        """The pack's own libraries; its GL front ends only where the machine has none: a driver's own come first."""
        for folders in (["lib"], ["lib", "lib/gl"]):
            present = [str(self.folder / name) for name in folders if (self.folder / name).is_dir()]
            inherited = [path for path in [os.environ.get("LD_LIBRARY_PATH")] if path]
            if present:
                self.environment["LD_LIBRARY_PATH"] = ":".join(present + inherited)
            run = subprocess.run([str(self.folder / "gpuwars"), "--version"], env=self.environment, check=False,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if run.returncode == 0:
                return

    def has(self, name):
        return os.access(self.folder / name, os.X_OK)

    @property
    def assets(self):
        """Options that name the tables, for programs that would look in the source tree."""
        folder = self.folder / "assets"
        return ["--assets", str(folder)] if folder.is_dir() else []

    def run(self, name, *arguments, limit, before=(), environment=None):
        """Runs folder/name, or `before` with it as its arguments. Counts the kernels that it says it ran."""
        words = [*before, str(self.folder / name), *map(str, arguments)]
        shown = shlex.join([*before, name, *map(str, arguments)])
        limit = max(1.0, min(limit, self.ends - time.monotonic()))
        print(f"$ {shown}", flush=True)
        begin, stopped = time.monotonic(), False
        # A session of its own: what a stopped program has started is stopped with it.
        process = subprocess.Popen(words, env={**self.environment, **(environment or {})}, text=True, errors="replace",
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            text, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            stopped = True
            os.killpg(process.pid, signal.SIGKILL)
            text, _ = process.communicate()
        print(text, end="", flush=True)
        self.outcome.kernels += sum(int(number.replace(",", "")) for number in KERNELS.findall(text))
        fell_back = FELL_BACK.search(text) if self.device == "cuda" else None
        return Finished(shown, process.returncode, text, time.monotonic() - begin, limit, stopped,
                        fell_back.group() if fell_back else "")
