"""What a suite came to: kept as a file with the commit it belongs to, shown as a row of the table."""
import dataclasses
import json
from pathlib import Path

PASSED, FAILED, SKIPPED = "passed", "failed", "skipped"
STATES = (PASSED, FAILED, SKIPPED)


@dataclasses.dataclass
class Outcome:
    suite: str
    commit: str
    quick: bool
    date: str = ""
    compiler: str = ""
    cmake: str = ""
    seconds: dict = dataclasses.field(default_factory=dict)  # of ./play and ./check
    rows: list = dataclasses.field(default_factory=list)  # (what, state, why)
    counted: list = dataclasses.field(default_factory=lambda: [0, 0, 0])  # the last line of ./check
    tests: dict = dataclasses.field(default_factory=dict)  # the state of each test of ./check
    hash: str = ""
    picture: str = ""  # colours of its blocks, in hexadecimal
    notes: list = dataclasses.field(default_factory=list)
    finished: bool = False

    def add(self, what, state, why=""):
        self.rows.append([what, state, why])
        return state == PASSED

    def count(self, state):
        return sum(row[1] == state for row in self.rows) + self.counted[STATES.index(state)]

    @property
    def holds(self):
        """Whether a rerun of the same commit need not repeat it."""
        return self.finished and self.count(FAILED) == 0

    def sentences(self, state):
        """What failed or was skipped, each with its reason."""
        said = [f"{what}: {why}" if why else what for what, is_state, why in self.rows if is_state == state]
        return said + [name for name, is_state in self.tests.items() if is_state == state]


class Kept:
    """The outcomes of one commit, as files."""

    def __init__(self, folder, commit, quick):
        self.folder, self.commit, self.quick = Path(folder) / f"{commit[:12]}-{'quick' if quick else 'full'}", commit, quick

    def log(self, suite):
        self.folder.mkdir(parents=True, exist_ok=True)
        return self.folder / f"{suite}.log"

    def read(self, suite):
        """None when there is none, or none that can be read."""
        try:
            outcome = Outcome(**json.loads((self.folder / f"{suite}.json").read_text()))
        except (OSError, ValueError, TypeError):
            return None
        return outcome if (outcome.commit, outcome.quick) == (self.commit, self.quick) else None

    def write(self, outcome):
        self.folder.mkdir(parents=True, exist_ok=True)
        part = self.folder / f"{outcome.suite}.part"
        part.write_text(json.dumps(dataclasses.asdict(outcome), indent=1) + "\n")
        part.replace(self.folder / f"{outcome.suite}.json")
