"""Which mutants are tried: the same ones for the same sources, and every kernel that decides the game among them."""
import re
from pathlib import Path

from mutations import mutants_of  # first: it makes the gates' modules known
from kernel_files import kernel_files, key_of

# What `gpuwars verify` cannot see, and why. A file by its key (kernel_files.py), or a file and a function of it.
LEFT_OUT = {
    "game/sim/autopilot.cu": "plays only while a run is recorded; verify plays the inputs of the file",
    "game/sim/candidates.cu": "counts pair tests for the profiler; nothing of the game follows",
    "game/sim/broad_phase.h": "which structure is asked, whose bins change no game, and the row that colours show",
    "game/sim/census.cu": "counts who lives for the overlay; nothing of the game follows",
    "game/sim/row_colour.h": "only drawn",
    "game/sim/draw_list.cu": "only drawn: culls, orders and packs what a frame shows",
    "game/sim/particle_list.cu": "only drawn",
    "game/sim/particles.cu": "only drawn: cosmetic particles draw chance of their own and feed nothing back",
    "game/sim/particle.h": "only drawn",
    "game/sim/entity_fields.h": "a table, and what is computed of it while it compiles",
    "game/sim/entity_copies.h": "runs when a snapshot is taken or given back, or when a tick is inspected",
    "game/sim/forwarding_simulation.h": "passes calls on; no kernel calls it",
    "game/sim/snapshot.cu": "runs when a snapshot is taken or given back, which no tick does",
    "game/sim/state_bytes.cu": "runs when a tick is inspected",
    "game/sim/state_columns.cu": "runs when a tick is inspected",
    "game/sim/state_members.h": "names of what an inspected tick shows",
    "game/sim/hash.cu: partOfTables": "0 as long as nothing writes to the tables, whatever the game does",
    "game/sim/state.h: wordHash": "compared with itself only: what it is when tables are uploaded, and in each tick",
    "game/sim/report.cu: sounds": "tells the host what to play; no part of the hash",
    "game/sim/report.cu: pops": "tells the host where to show points; no part of the hash",
    "game/sim/broad_phase.cu": "sizes of the uniform grids, which find the same neighbours whatever they are",
    "game/sim/settle.cu: kMiddlePan_m": "tells the host on which side a sound is; no part of the hash",
    "game/sim/settle.cu: tallyWordOf": "counts for the report only; no part of the hash",
    "gpu/exact_math.h: arcTangent2": "asked only by bots and drawing",
    "gpu/exact_math.h: exponential": "asked only by drawing",
    "gpu/bits.h: orderedBits": "orders keys of other broad phases and of other orders of visits",
    "gpu/row_gather.h: operator()": "asks about a position without an entity: bots and tests",
}
REPORTED = re.compile(r"^report\.(?!hash|fieldHashes)|\bpops\b|tallyWordOf|kMiddlePan_m")  # told the host, not hashed
DAMAGE = re.compile(r"kDamageField|partOfTables")  # adds nothing to a hash as long as nothing is damaged
OTHER_WORLDS = re.compile(r"\b(?:Float3|Cell3)\b|firstSlabAt|heightOf")  # three dimensions, which no game has
# What of gpu/ a tick of an exact game runs, and what decides rather than speeds up.
OF_GPU = ("bits.h", "exact_math.h", "fixed_sum.h", "neighbour.h", "ngrid_pack.cu", "philox.h", "row_gather.h",
          "scan_block.h", "scan_reduce.cu", "scan_reduce.h", "state_hash.h", "ngrid_rows.h", "ngrid_reach.h")
KERNEL = re.compile(r"^struct (\w+)[^;{]*\{(?:(?!^\};).)*?\boperator\(\)", re.M | re.S)
PER_GPU_FILE = 1
BOUNDARY = ("<", "<=", ">", ">=")  # between real numbers it is met by chance only: taken where there is nothing else


def left_out(file, function=""):
    """The reason, or nothing."""
    file = key_of(file)
    return LEFT_OUT.get(file) or LEFT_OUT.get(f"{file}: {function}")


def decides(mutant):
    """Whether verify could feel it."""
    return not (left_out(mutant.file, mutant.function) or REPORTED.search(mutant.context) or DAMAGE.search(mutant.context) or
                OTHER_WORLDS.search(mutant.head))


def ranked(mutants):
    """The order in which they are candidates."""
    return sorted(mutants, key=lambda mutant: (mutant.old in BOUNDARY, mutant.rank))


def kernels_of(text):
    """The structs with an operator(): what forEach and forEachTeam run."""
    return KERNEL.findall(text)


def files(source):
    """The files whose kernels decide the game."""
    found = kernel_files(source)
    keys = [key for suffix in (".cu", ".h") for key in sorted(found) if key.startswith("game/sim/") and key.endswith(suffix)]
    keys += [f"gpu/{name}" for name in OF_GPU]
    missing = [key for key in [*keys, *(name.partition(": ")[0] for name in LEFT_OUT)] if key not in found]
    if missing:
        raise ValueError(f"tests/mutants/choice.py names {', '.join(missing)}, which is nowhere below game/sim/ or gpu/")
    return [found[key] for key in keys if not left_out(key)]


def slots(source):
    """[(what is tested, its candidates)]: the first candidate that compiles is the mutant tried. First a constant of
    every kernel, then something else of every kernel, then one of every other function, then of gpu/."""
    source = Path(source)
    constants, others, functions, of_gpu = [], [], [], []
    for file in files(source):
        text = (source / file).read_text(encoding="utf-8")
        groups = {}
        for mutant in mutants_of(file, text):
            if decides(mutant):
                groups.setdefault(mutant.kernel, []).append(mutant)
        if file.startswith("gpu/"):
            inside = ranked(mutant for group in groups.values() for mutant in group)
            of_gpu += [(f"{file} {n + 1}", inside[n::PER_GPU_FILE]) for n in range(min(PER_GPU_FILE, len(inside)))]
            continue
        kernels = set(kernels_of(text))
        for name, group in groups.items():
            group = ranked(group)
            if name not in kernels:
                functions.append((f"{file} {name}", group))
                continue
            numbers = [mutant for mutant in group if mutant.kind == "constant"]
            signs = [mutant for mutant in group if mutant.kind != "constant"]
            constants += [(f"{file} {name}, a constant", numbers)] if numbers else []
            others += [(f"{file} {name}, a sign", signs)] if signs else []
    return constants + others + functions + of_gpu
