"""How much each step does: all of it on a GPU, less with --quick, and what two processor cores do in a minute."""
import dataclasses
from pathlib import Path


@dataclasses.dataclass
class Sizes:
    replays: Path
    out: Path  # for pictures
    pairs: int = 10**9
    roots: int = 2**32  # all there are
    parity_filter: str = "*"
    block_sizes: tuple = (64, 128, 256)
    picture_ticks: int = 600
    sanitised_ticks: int = 60
    enemies: tuple = (1024, 8192, 65536, 1048576)
    ticks: int = 240
    rounds: int = 5
    copy_mebibytes: int = 256
    crowds: tuple = (8192, 65536, 1048576)
    frames: int = 40
    crowd_s: float = 20.0


QUICK_PARITY = ":".join(f"*/{case}" for case in "ForEach Teams Graph Scan ExactMath Philox StateHash".split())
QUICK = {"pairs": 2_000_000, "roots": 2_000_000, "parity_filter": f"KernelCount.*:{QUICK_PARITY}", "block_sizes": (64,),
         "picture_ticks": 60, "sanitised_ticks": 6, "enemies": (1024,), "ticks": 30, "rounds": 1, "copy_mebibytes": 16,
         "crowds": (2048,), "frames": 5, "crowd_s": 2.0}
ON_CPU = {**QUICK, "pairs": 4_000_000, "roots": 4_000_000, "parity_filter": "*", "picture_ticks": 120,
          "enemies": (1024, 8192), "rounds": 3, "crowds": (8192,), "frames": 10}


def sizes_for(device, quick, replays, out):
    if quick:
        return Sizes(replays, out, **QUICK)
    return Sizes(replays, out, **(ON_CPU if device == "cpu" else {}))
