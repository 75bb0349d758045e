"""Whether verify --reference finds a mutant: asks it where the mutant's program and the unchanged one part."""
import json
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from itertools import islice

from stages import spread, stages_of  # first: it makes the gates' modules known
from kernel_files import path_of
from report import escaped
from workshop import Failed

DESYNC = 4  # verify's exit status
LATEST_TICK = 3600  # both sides play up to there: what takes longer to differ gives way to another mutant
LIMIT_S = 600
FIELDS = "game/sim/entity_fields.h"
FIELD, BUFFER = re.compile(r'^  FIELD\(.*?"(\w+)"', re.M), re.compile(r"^  BUFFER\(.*", re.M)


@dataclass(frozen=True)
class Place:
    """Where verify locates a mutant's effect."""
    mutant: object
    replay: str
    desync: dict = field(default_factory=dict)

    def value(self, side):
        """Of the field: a real one with the digits that tell it from any other."""
        number = self.desync.get("values", {}).get(side, {}).get("number", "")
        return f"{number:.9g}" if isinstance(number, float) else str(number)

    def __str__(self):
        desync = self.desync
        who = f"entity {desync['entity']}, " if "entity" in desync else ""
        what = f"{who}{desync['field']}: {self.value('own')} and {self.value('reference')}" if "field" in desync else "-"
        return f"{self.replay}, tick {desync.get('tick')}, {desync.get('stage', 'no stage')}, {what}: {self.mutant.name}"


def entity_fields(source):
    """The names of the fields that every entity has; all others are globals."""
    table = path_of(source, FIELDS).read_text(encoding="utf-8")
    within_tick = [column for row in BUFFER.findall(table) for column in re.findall(r'"(\w+)"', row)[1:]]  # after its stage
    return {*FIELD.findall(table), *within_tick, "cell"}


def misplaced(mutant, tick, status, told, of_entities):
    """Sentences on what is wrong with what verify says of a mutant of which `tick` is the first to differ."""
    desync = told.get("desync")
    if status != DESYNC or not desync:
        return [f"verify ended with {status} and says {told.get('error') or 'nothing of a desync'}; {DESYNC} and a desync "
                "were to come"]
    wrong, first, stage = [], told.get("firstDifference", {}), desync.get("stage")
    if desync["tick"] != tick or first.get("tick") != tick:
        wrong.append(f"it names tick {desync['tick']}, but {tick} is the first that differs from the recording")
    if first.get("recorded") != desync["hashes"]["reference"]:
        wrong.append("the unchanged program, its reference, does not agree with the recording")
    if not desync["partsAgain"]:
        return [*wrong, "it could not make the two part again"]
    if stage not in stages_of(mutant.file):
        wrong.append(f"it names the stage {stage}, but {mutant.file} has its effect in {' or '.join(stages_of(mutant.file))}")
    if stage == "hash":  # nothing but the hash differs
        return wrong + ([f"it names a field, {desync['field']}, though only hash.cu is changed"] if "field" in desync else [])
    if "field" not in desync:
        return [*wrong, "it names no field"]
    if ("entity" in desync) != (desync["field"] in of_entities):
        wrong.append(f"the field {desync['field']} " +
                     ("is a global, but it names an entity" if "entity" in desync else "is one of entities, but it names none"))
    values = desync["values"]
    if values["own"]["bits"] == values["reference"]["bits"]:
        wrong.append(f"it names the field {desync['field']}, whose values are equal")
    return wrong


def places_table(places):
    """Between the marks of docs/results/mutants.md."""
    rows = ["| mutant | replay | tick | stage | entity | field | mutant's value | unchanged |",
            "|---|---|---|---|---|---|---|---|"]
    for place in places:
        mutant, desync = place.mutant, place.desync
        rows.append(f"| {mutant.kernel}: `{escaped(mutant.context)}`: `{escaped(mutant.old)}` to `{escaped(mutant.new)}` | "
                    f"{place.replay} | {desync['tick']} | {desync['stage']} | {desync.get('entity', '')} | "
                    f"{desync.get('field', 'the hash only')} | {place.value('own')} | {place.value('reference')} |")
    return "\n".join(rows)


class Localiser:
    """`program`: the unchanged one, of which a copy becomes the reference."""

    def __init__(self, trial, program, folder):
        self.trial, self.workshop = trial, trial.workshop
        self.reference = folder / "reference"
        shutil.copy2(program, self.reference)
        self.replays = {path.stem: path for path in trial.replays}
        self.of_entities = entity_fields(self.workshop.root)

    def places(self, wanted, most):
        """(places, {mutant: sentences on what is wrong}) of `most` caught mutants, spread over the stages."""
        places, wrong = [], {}
        for mutant, outcome in islice(spread(wanted, self._caught), most):
            status, told = self._ask(mutant, self.replays[outcome.replay])
            place = Place(mutant, outcome.replay, told.get("desync", {}))
            print(place, flush=True)
            places.append(place)
            sentences = misplaced(mutant, outcome.tick, status, told, self.of_entities)
            if sentences:
                wrong[mutant.name] = sentences
        if len(places) < most:
            raise Failed(f"Only {len(places)} of {most} mutants differ by tick {LATEST_TICK} and can be localised; ask for "
                         "fewer.")
        return places, wrong

    def _caught(self, slot):
        """(mutant, outcome) when a replay differs early enough, from the first candidate that compiles."""
        for mutant in slot[1]:
            outcome = self.trial.outcome(mutant)
            if outcome.what != "does not compile":
                return (mutant, outcome) if outcome.what == "caught" and 0 < outcome.tick <= LATEST_TICK else None
        return None

    def _ask(self, mutant, replay):
        """(exit status, what verify's JSON says of the replay)."""
        with self.workshop.built(mutant) as program:
            command = [program, "verify", replay, "--reference", self.reference, "--device", "cpu", "--reference-options",
                       "--device cpu", "--json", "-"]
            try:
                result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True, errors="replace", timeout=LIMIT_S, check=False)
            except subprocess.TimeoutExpired:
                return None, {"error": f"nothing within {LIMIT_S} s"}
        try:
            return result.returncode, json.loads(result.stdout)["replays"][0]
        except (ValueError, KeyError, IndexError):
            return result.returncode, {"error": (result.stderr.strip() or "nothing").splitlines()[-1]}
