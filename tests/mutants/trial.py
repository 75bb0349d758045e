"""Tries mutants: the golden replays, shortest first, until one fails."""
import hashlib
import json
import subprocess
from dataclasses import asdict, dataclass

from workshop import DoesNotCompile, Failed

MUCH_LONGER = 10  # a mutant that takes so many times as long as the unchanged program does not end by itself
AT_LEAST_S = 60


@dataclass(frozen=True)
class Outcome:
    """What became of a mutant: caught, survived, timed out (which counts as caught) or does not compile."""
    what: str
    replay: str = ""
    tick: int = 0  # the first that differs; 0: it did not get so far
    note: str = ""

    @property
    def caught(self):
        """Whether the suite would have refused it."""
        return self.what in ("caught", "timed out")

    def __str__(self):
        place = f"{self.replay}, tick {self.tick}" if self.tick else self.replay
        return " ".join(part for part in (self.what, f"({place})" if place else "", self.note) if part)


class Trial:
    """Outcomes are kept by content: a second run asks only what is new."""

    def __init__(self, workshop, replays, kept, digest):
        self.workshop, self.replays, self.kept, self.digest = workshop, replays, kept, digest
        self.seconds = {}

    def baseline(self, program):
        """Every replay must be equal with the unchanged program; tells how long each takes."""
        file = self.kept / f"baseline-{self.digest[:32]}.json"
        if file.is_file():
            self.seconds = json.loads(file.read_text(encoding="utf-8"))
        else:
            found, error = self._verify(program, self.replays, None)
            if not found or any(not replay["equal"] for replay in found):
                raise Failed(f"The unchanged program does not verify the golden replays; make it do so first. {error}")
            self.seconds = {replay["file"]: replay["ticks"] / replay["ticksPerSecond"] for replay in found}
            self._keep(file, self.seconds)
        self.replays = sorted(self.replays, key=lambda path: (self.seconds[str(path)], str(path)))

    def kept_outcome(self, mutant):
        """What a run before this one found, or None."""
        file = self._file(mutant)
        return Outcome(**json.loads(file.read_text(encoding="utf-8"))) if file.is_file() else None

    def outcome(self, mutant):
        """Builds it and plays the replays, a few at a time."""
        found = self.kept_outcome(mutant)
        if found:
            return found
        try:
            with self.workshop.built(mutant) as program:
                found = self._play(program)
        except DoesNotCompile:
            found = Outcome("does not compile")
        self._keep(self._file(mutant), asdict(found))
        return found

    def _play(self, program):
        at_a_time = self.workshop.jobs
        for first in range(0, len(self.replays), at_a_time):
            files = self.replays[first:first + at_a_time]
            names = ", ".join(file.stem for file in files)
            limit = max(AT_LEAST_S, MUCH_LONGER * sum(self.seconds[str(file)] for file in files))
            try:
                found, error = self._verify(program, files, limit)
            except subprocess.TimeoutExpired:
                return Outcome("timed out", names)
            if found is None:
                return Outcome("caught", names, note=f"the program fails: {error}")
            for file, replay in zip(files, found, strict=True):
                if not replay["equal"]:
                    tick = replay.get("firstDifference", {}).get("tick", 0)
                    return Outcome("caught", file.stem, tick, replay.get("error", "") or replay.get("wrong", ""))
        return Outcome("survived")

    def _verify(self, program, files, limit_s):
        """(what it says of each file, why not): without the first when it crashed."""
        command = [program, "verify", "--device", "cpu", "-j", self.workshop.jobs, "--json", "-", *files]
        result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, errors="replace", timeout=limit_s, check=False)
        try:
            return json.loads(result.stdout)["replays"], result.stderr.strip()
        except (ValueError, KeyError):
            return None, (result.stderr.strip() or f"exit status {result.returncode}").splitlines()[-1]

    def _file(self, mutant):
        key = hashlib.sha256(f"{self.digest}\0{mutant.name}\0{mutant.offset}".encode()).hexdigest()
        return self.kept / f"{key[:32]}.json"

    def _keep(self, file, content):
        self.kept.mkdir(parents=True, exist_ok=True)
        part = file.with_suffix(".part")
        part.write_text(json.dumps(content), encoding="utf-8")
        part.replace(file)
