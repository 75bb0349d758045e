"""What must be equal on all systems, though each suite alone was fine: the fixed run's hash, its picture, the tests."""
from outcome import FAILED, PASSED

# Rasterisers of other Mesa versions round otherwise; a wrong colour or a missing thing differs by more in a whole block.
MOST_PICTURE_DIFFERENCE = 3


def most_difference(one, other):
    """Of two pictures' blocks, 0 to 255."""
    a, b = bytes.fromhex(one), bytes.fromhex(other)
    return max(abs(x - y) for x, y in zip(a, b, strict=True)) if len(a) == len(b) else 255


def compare(outcomes):
    """Adds to each outcome whether it agrees with the first that tells: no suite alone can know."""
    for outcome in outcomes:
        outcome.rows = [row for row in outcome.rows if row[0] not in ("same hash", "same picture")]
    hashes, drawn = ([outcome for outcome in outcomes if getattr(outcome, key)] for key in ("hash", "picture"))
    for outcome in hashes if len(hashes) > 1 else ():
        same = outcome.hash == hashes[0].hash
        outcome.add("same hash", PASSED if same else FAILED,
                    "" if same else f"{outcome.hash} here, {hashes[0].hash} on {hashes[0].suite}")
    for outcome in drawn if len(drawn) > 1 else ():
        differs = most_difference(drawn[0].picture, outcome.picture)
        same = differs <= MOST_PICTURE_DIFFERENCE
        outcome.add("same picture", PASSED if same else FAILED,
                    "" if same else f"a block differs by {differs} of 255 from {drawn[0].suite}'s")


def told_apart(outcomes):
    """Sentences on tests that passed on one suite and did not pass, or did not exist, on another."""
    checked = [outcome for outcome in outcomes if outcome.tests]
    passed = {name for outcome in checked for name, state in outcome.tests.items() if state == PASSED}
    for outcome in checked:
        absent = sorted(name for name in passed if name not in outcome.tests)
        if absent:
            yield f"{outcome.suite} has not: {', '.join(absent)}"
