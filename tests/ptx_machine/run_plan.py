"""What tests/ptx_machine/run runs: a list of steps for ./check, and a longer one for --full."""
import dataclasses
import os

SHORT_TICKS, LONG_TICKS = 120, 300
BLOCK_SIZES = (64, 128, 256)
ORDERS = ("ascending", "reversed", "shuffled")
ARCHITECTURES = (90, 75)

# A golden replay with each way of finding neighbours. An inexact one is the replay's own: another would be another game.
SEARCHES = (
    ("swarm_expert", ("--sort", "frozen")),
    ("together", ("--sort", "full")),
    ("tricky_expert", ("--sort", "bitonic")),
    ("kamikaze_expert", ("--broad-phase", "grid")),
    ("group_expert", ("--broad-phase", "grid-hashed")),
    ("practice_expert", ("--broad-phase", "brute")),
    ("thesis", ()),  # adaptive, bitonic
    ("adaptive_odd_even", ()),
    ("fixed_bitonic", ()),
    ("fixed_odd_even", ()),
)


@dataclasses.dataclass(frozen=True)
class Step:
    name: str
    program: str
    arguments: tuple
    architecture: int = 90
    replay: str = ""       # cut to `ticks` first, and put behind the arguments
    ticks: int = 0         # 0: whole
    machine: str = ""      # of GW_PTX_MACHINE
    shards: tuple = ()     # (how many, which): a part of a program of GoogleTest
    cost: int = 1          # begun first when high


def parity_steps(shards):
    primitives = [Step(f"primitives, part {s + 1} of {shards}", "parity_test",
                       ("--items", "4096", "--block", "128", "--gtest_filter=Cases/*:KernelCount.*"),
                       shards=(shards, s), cost=5) for s in range(shards)]
    # A game for each broad phase, either mode, and a snapshot carried over.
    games = Step("games of 256 enemies", "parity_test",
                 ("--enemies", "256", "--ticks", "30", "--first-tick", "300", "--block", "128",
                  "--gtest_filter=*GameParity*:SnapshotParity.*"), cost=9)
    return [games, *primitives]


def quick_steps():
    verify = ("verify", "--device", "cuda")
    return [*parity_steps(8),
            Step("first_seconds", "gpuwars", verify, replay="first_seconds", cost=3),
            Step(f"swarm_expert, {SHORT_TICKS} ticks", "gpuwars", verify, replay="swarm_expert", ticks=SHORT_TICKS, cost=8),
            Step(f"thesis, {SHORT_TICKS} ticks", "gpuwars", verify, replay="thesis", ticks=SHORT_TICKS, cost=8)]


def full_steps():
    """Every search with every block size; order and architecture turn, so that each pair of any two settings occurs."""
    steps = []
    for s, (replay, search) in enumerate(SEARCHES):
        for b, block in enumerate(BLOCK_SIZES):
            order, architecture = ORDERS[(s + b) % len(ORDERS)], ARCHITECTURES[(s + b) % len(ARCHITECTURES)]
            machine = f"order={order}" + (f",seed={s + 1}" if order == "shuffled" else "")
            steps.append(Step(f"{replay}, blocks of {block}, {order}, sm_{architecture}", "gpuwars",
                              ("verify", "--device", "cuda", "--block-size", str(block), *search),
                              architecture=architecture, replay=replay, ticks=LONG_TICKS, machine=machine))
    return steps


def environment(step):
    changed = {**os.environ, "GW_PTX_MACHINE": step.machine}
    if step.shards:
        changed["GTEST_TOTAL_SHARDS"], changed["GTEST_SHARD_INDEX"] = map(str, step.shards)
    return changed
