"""What a run says: survivors without a reason, reasons without a survivor, and the table of docs/results/mutants.md."""
from collections import Counter

HEAD = """# Mutants

A test suite is as good as the faults it notices. `tests/mutants/run_mutants` changes one constant, comparison or sign
of the simulation at a time and verifies the golden replays, shortest first, until one fails. [Testing](../guide/testing.md) says
how it chooses. This page is written by `run_mutants --write`.

"""
PLACES = """
## Localised

`gpuwars verify --reference` plays a replay on two programs at once and says where they part: tick, stage, field, entity and
both values. `run_mutants --localise` asks it about caught mutants of as many stages as possible, with the unchanged
program as the reference; it must name the stage that the change belongs to. Those of `hash.cu` change no value.

"""
BEGIN, END = "<!-- localised: run_mutants --localise writes it -->", "<!-- end of localised -->"


def survivors(file):
    """{mutant's name: reason}. A name stands at the margin, its reason is indented below it."""
    reasons, name = {}, None
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines() if file.is_file() else [], 1):
        if not line.strip() or line.startswith("#"):
            continue
        if not line[0].isspace():
            name = line.strip()
            if name in reasons:
                raise ValueError(f"{file}:{number}: '{name}' stands twice; keep one")
            reasons[name] = ""
        elif name:
            reasons[name] = f"{reasons[name]} {line.strip()}".strip()
    return reasons


def judged(found, reasons, whole):
    """Sentences on what is wrong; `whole`: all mutants were tried."""
    wrong, outcomes = [], {mutant.name: outcome for mutant, outcome in found}
    for name, outcome in outcomes.items():
        if outcome.caught and name in reasons:
            wrong.append(f"caught by now: {name}; take it out of tests/mutants/survivors.txt.")
        if not outcome.caught and not reasons.get(name):
            wrong.append(f"survived without a reason: {name}; add a replay that notices it, or the reason why none can "
                         "to tests/mutants/survivors.txt.")
    if whole:
        wrong += [f"no longer tried: {name}; take it out of tests/mutants/survivors.txt." for name in reasons
                  if name not in outcomes]
    return wrong


def escaped(text):
    """For a cell of a table."""
    return text.replace("|", "\\|")


def localised(page):
    """What stands between the marks of docs/results/mutants.md; nothing where there are none yet."""
    return page.partition(BEGIN)[2].partition(END)[0].strip()


def with_localised(page, rows):
    """The page with that replaced, or added at its end."""
    before, found, rest = page.partition(BEGIN)
    if not found:
        before, rest = page + PLACES, END + "\n"
    return f"{before}{BEGIN}\n{rows}\n{END}{rest.partition(END)[2]}"


def table(found, reasons, chosen):
    """docs/results/mutants.md as text, but for what is localised; `chosen`: how many there are to try."""
    caught = sum(outcome.caught for _, outcome in found)
    out = [HEAD, f"**{caught} of {len(found)} caught**; {len(found) - caught} survive, each for a reason given below.\n"]
    if len(found) < chosen:
        out.append(f"These are the first {len(found)} of {chosen} mutants that are chosen; the others are not tried yet.\n")
    out += ["\n| file | caught of tried |\n|---|---|\n"]
    tried = Counter(mutant.file for mutant, _ in found)
    good = Counter(mutant.file for mutant, outcome in found if outcome.caught)
    out += [f"| `{file}` | {good[file]} of {tried[file]} |\n" for file in sorted(tried)]
    out += ["\n## Survivors\n\n| kernel | change | why no replay can notice it |\n|---|---|---|\n"]
    out += [f"| {mutant.kernel} | `{escaped(mutant.context)}`: `{escaped(mutant.old)}` to `{escaped(mutant.new)}` | "
            f"{escaped(reasons[mutant.name])} |\n" for mutant, outcome in found if not outcome.caught]
    out += ["\n## Caught\n\n| stage | kernel | change | by |\n|---|---|---|---|\n"]
    for mutant, outcome in found:
        if outcome.caught:
            place = f"{outcome.replay}, tick {outcome.tick}" if outcome.tick else f"{outcome.replay}: it fails"
            place = f"{outcome.replay}: it does not end" if outcome.what == "timed out" else place
            out.append(f"| {mutant.stage} | {mutant.kernel} | `{escaped(mutant.context)}`: `{escaped(mutant.old)}` to "
                       f"`{escaped(mutant.new)}` | {place} |\n")
    return "".join(out)
