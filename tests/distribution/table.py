"""The table of suites, for a terminal and for docs/guide/building.md."""
from comparison import told_apart
from outcome import FAILED, SKIPPED, STATES

HEAD = ("suite", "compiler", "CMake", "./play, min", "./check, min", "passed", "failed", "skipped", "hash of the fixed run")


def minutes(outcome, what):
    return f"{outcome.seconds[what] / 60:.1f}" if what in outcome.seconds else "-"


def row(outcome):
    return (outcome.suite, outcome.compiler or "-", outcome.cmake or "-", minutes(outcome, "play"),
            minutes(outcome, "check"), *(f"{outcome.count(state):,}" for state in STATES), outcome.hash or "-")


def plain(outcomes):
    rows = [HEAD, *map(row, outcomes)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(cell.ljust(width) for cell, width in zip(cells, widths, strict=True)).rstrip() for cells in rows]


def markdown(outcomes):
    lines = [f"| {' | '.join(cells)} |" for cells in (HEAD, *map(row, outcomes))]
    lines.insert(1, "|---" * len(HEAD) + "|")
    return lines


def remarks(outcomes):
    """What the numbers do not say, a sentence each."""
    for state in (FAILED, SKIPPED):
        for outcome in outcomes:
            yield from (f"{state} on {outcome.suite}: {sentence}" for sentence in outcome.sentences(state))
    yield from told_apart(outcomes)
    for outcome in outcomes:
        yield from (f"{outcome.suite}: {note}" for note in outcome.notes)


def total(outcomes):
    counts = [sum(outcome.count(state) for outcome in outcomes) for state in STATES]
    return f"{counts[0]} passed, {counts[1]} failed, {counts[2]} skipped"


def document(outcomes, commit, quick):
    """The section's table in Markdown, with its date."""
    dates = sorted({outcome.date[:10] for outcome in outcomes if outcome.date})
    way = "tests/distributions --quick" if quick else "tests/distributions"
    return [f"`{way}`, {' to '.join(dict.fromkeys((dates[0], dates[-1]))) if dates else 'not run'}, commit "
            f"{commit[:12]}:", "", *markdown(outcomes), "", *(f"- {remark}" for remark in remarks(outcomes))]
