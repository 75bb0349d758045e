"""In which stages of a tick a mutant has its first effect, and the order in which mutants are taken to be localised."""

import re
from pathlib import Path

import mutations  # noqa: F401  makes the gates' modules known
from kernel_files import key_of

STEP = Path(__file__).parents[2] / "game/sim/step.cu"
# As step.cu lists them. Autopilot does not run while a replay is verified, particles feed nothing back.
STAGES = tuple(name for name in re.findall(r'^    \{"(\w+)", \[\]', STEP.read_text(encoding="utf-8"), re.M)
               if name not in ("autopilot", "particles"))

# A file of game/sim, by its key (kernel_files.py), that is not a stage itself, or that another stage feels: which stages, and why those.
FELT_IN = {
    "game/sim/maintain.cu": (("maintain", "think"), "its work is the order of cells, which is no state in an exact game: "
                             "think is the first to look for neighbours in it"),
    "game/sim/report.cu": (("hash",), "is timed with hash: it adds the globals to its sums"),
    "game/sim/waves.h": (("logic",), "what logic commands"),
    "game/sim/spawn_patterns.h": (("spawn",), "where spawn puts what is born"),
    "game/sim/behaviour.h": (("think",), "what think does in each state"),
    "game/sim/behaviour_group.h": (("think",), "what think does in each state"),
    "game/sim/behaviour_kamikaze.h": (("think",), "what think does in each state"),
    "game/sim/behaviour_tricky.h": (("think",), "what think does in each state"),
    "game/sim/overlap.h": (("collide",), "how deep bodies overlap, for collide"),
    "game/sim/pushes.h": (("collide",), "the sums of collide's pushes"),
    "game/sim/sum_scales.h": (("think", "collide"), "the scales of sums over neighbours: of headings in think, of pushes "
                              "in collide"),
    "game/sim/sweep.h": (("collide",), "when bodies meet, for collide"),
    "game/sim/state.cu": (("integrate",), "sets, as a game begins, the speed that integrate allows"),
    "game/sim/rules.h": (("logic", "think", "integrate", "collide"),
                         "the length of a tick: whatever moves, recovers or is swept multiplies by it"),
    "game/sim/state.h": (("spawn", "think", "integrate", "collide", "settle"),
                         "who is an enemy, who is only announced and how far a body reaches: all stages that tell "
                         "entities apart ask it"),
}


def stages_of(file):
    """The stages one of which must be named; raises ValueError for a file that FELT_IN does not list."""
    file = key_of(file)
    if file in FELT_IN:
        return FELT_IN[file][0]
    folder, _, name = file.rpartition("/")
    stage = name.removesuffix(".cu")
    if folder != "game/sim" or stage not in STAGES:
        raise ValueError(f"The stage in which a change of {file} has its first effect is unknown: add it to FELT_IN in "
                         "tests/mutants/stages.py, with the reason.")
    return (stage,)


def by_stage(wanted):
    """Slots of game/sim, a list for each set of stages: those of one stage in the order of a tick, then the shared."""
    groups = {}
    for slot in wanted:
        file = slot[1][0].file
        if file.startswith("game/sim/"):
            groups.setdefault(stages_of(file), []).append(slot)
    return [groups[stages] for stages in sorted(groups, key=lambda s: (len(s), [STAGES.index(stage) for stage in s]))]


def spread(wanted, fits):
    """What `fits(slot)` gives, where it gives something: of one slot of every group, then of a second one, and so on."""
    groups = [iter(group) for group in by_stage(wanted)]
    while groups:
        for group in list(groups):
            fitting = next((made for made in map(fits, group) if made is not None), None)
            if fitting is None:
                groups.remove(group)
            else:
                yield fitting
