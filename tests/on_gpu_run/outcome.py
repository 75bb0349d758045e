"""What a run of tests/on_gpu has found: rows of a table, counts, figures, and the exit status they come to."""
import dataclasses
import json
from pathlib import Path

PASSED, FAILED, SKIPPED, FIGURE = "passed", "failed", "skipped", "figure"


@dataclasses.dataclass
class Row:
    step: str
    what: str
    state: str
    text: str
    command: str = ""
    figures: dict = dataclasses.field(default_factory=dict)


class Outcome:
    def __init__(self, device):
        self.device = device
        self.computing = ""  # the device's name
        self.rows = []
        self.kernels = 0

    def add(self, step, what, state, text, command="", **figures):
        self.rows.append(Row(step, what, state, text, command, figures))
        print(f"{step}: {what}: {self.rows[-1].state}: {text}", flush=True)

    def count(self, state):
        return sum(row.state == state for row in self.rows)

    def conclude(self):
        """Adds what is wrong with the run as a whole."""
        if self.device == "cuda" and self.kernels == 0:
            self.add("run", "CUDA kernels", FAILED, "none has run, so nothing was tested on a GPU")
        if self.count(PASSED) == 0:
            self.add("run", "tests", FAILED, "none has passed")

    @property
    def exit_status(self):
        return 1 if self.count(FAILED) else 0

    def table(self):
        width = max((len(f"{row.step}: {row.what}") for row in self.rows), default=0)
        lines = [f"---- GpuWars on the {self.device} device: {self.computing} ----"]
        for row in self.rows:
            state = "" if row.state == FIGURE else row.state.upper() if row.state == FAILED else row.state
            lines.append(f"{row.step + ': ' + row.what:<{width}}  {state:<7}  {row.text}".rstrip())
        lines.append(f"{self.count(PASSED)} passed, {self.count(FAILED)} failed, {self.count(SKIPPED)} skipped, "
                     f"{self.count(FIGURE)} figures")
        lines.append(f"{self.kernels:,} CUDA kernels run")
        return "\n".join(lines) + "\n"

    def write_json(self, path, facts):
        document = {**facts, "device": self.device, "computing": self.computing, "cudaKernelsRun": self.kernels,
                    "exitStatus": self.exit_status,
                    "counts": {state: self.count(state) for state in (PASSED, FAILED, SKIPPED, FIGURE)},
                    "rows": [dataclasses.asdict(row) for row in self.rows]}
        Path(path).write_text(json.dumps(document, indent=2) + "\n")
