"""The determinism matrix: variants, how each is built, and results that outlive an interrupted run."""
import hashlib
import json
import os
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass

from golden_suite import ROOT, golden_list, replace

HEADLESS = ("-DGW_CUDA=OFF", "-DGW_WINDOW=OFF", "-DGW_TESTS=OFF")


@dataclass(frozen=True)
class Variant:
    """A column: a build of the game, and options with which it verifies."""
    name: str
    build: str                # a folder of build/matrix
    configure: tuple = ()     # what cmake is told
    options: tuple = ()       # of verify
    slow: bool = False        # a sanitiser, or not optimised: --quick leaves the long replays out


def flags(level):
    return ("-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS_RELEASE={level} -DNDEBUG")


GCC2 = flags("-O2")
# Assertions stay on in the sanitised builds; -O1 and line numbers only halve their time to compile.
SANITISED = ("-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1")


def newest_clang():
    """The newest clang++-N that there is, 19 at best; clang++ else."""
    folders = os.environ.get("PATH", "").split(os.pathsep)
    found = [f"clang++-{n}" for n in range(19, 13, -1) if any(os.access(f"{f}/clang++-{n}", os.X_OK) for f in folders)]
    return (found or ["clang++"])[0]


def variants(clang):
    number = clang.rpartition("-")[2]
    compilers = [
        Variant("g++ -O0", "gcc_o0", flags("-O0"), slow=True),
        Variant("g++ -O2", "gcc_o2", GCC2),
        Variant("g++ -O3 native", "gcc_o3_native", (*flags("-O3"), "-DGW_NATIVE=ON")),
        Variant(f"clang {number} -O3", f"clang_{number}", (*flags("-O3"), f"-DCMAKE_CXX_COMPILER={clang}",
                                                           f"-DCMAKE_C_COMPILER={clang.replace('++', '')}")),
        Variant("ASan + UBSan", "asan", (*SANITISED, "-DGW_SANITIZE=address,undefined"), slow=True),
        Variant("TSan", "tsan", (*SANITISED, "-DGW_SANITIZE=thread"), ("--threads", "2"), slow=True),
    ]
    ways = [Variant(f"{n} thread{'s' * (n > 1)}", "gcc_o2", GCC2, ("--threads", str(n))) for n in (1, 2, 3, 7, 16)]
    ways += [Variant(order, "gcc_o2", GCC2, ("--order", order, "--threads", "2")) for order in ("reversed", "shuffled")]
    ways.append(Variant("heavy", "gcc_o2", GCC2, ("--heavy",)))
    return [v for v in compilers + ways if not v.slow] + [v for v in compilers if v.slow]


def build(variant, jobs):
    """Its program, built if need be."""
    folder = ROOT / "build/matrix" / variant.build
    environment = {**os.environ, "CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1"}
    for command in (["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", *HEADLESS, *variant.configure],
                    ["cmake", "--build", folder, "--target", "gpuwars", "--parallel", str(jobs)]):
        result = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True, check=False, env=environment)
        if result.returncode != 0:
            raise ValueError(f"{variant.name} does not build:\n{result.stdout[-3000:]}")
    digest = decisive_digest(variant)
    program_of(variant).with_name(DIGEST).write_text(digest)
    return program_of(variant)


# What the hashes that a build computes may depend on; a change of a screen's text does not make hours of work stale.
DECISIVE = ("cmake", "game/sim", "game/tables", "gpu", "host/platform/toml_library.cpp", "host/platform/toml_library.h")
DIGEST = "decisive_digest"


def decisive_files(root):
    """In an order that does not change when a file moves; ValueError when a part of DECISIVE is nowhere."""
    found = []
    for path in (root / name for name in DECISIVE):
        files = [path] if path.is_file() else [file for file in path.rglob("*") if file.is_file()]
        if not files:
            raise ValueError(f"DECISIVE in tests/replays/matrix.py names {path.relative_to(root)}, which is not there: name the "
                             "place that it moved to")
        found += sorted(files, key=lambda file: (file.name, file))
    return found


def decisive_digest(variant):
    """Of the sources that decide, the compiler and what it is told."""
    digest = hashlib.sha256(repr(variant.configure).encode())
    compiler = next((option.partition("=")[2] for option in variant.configure if "CXX_COMPILER=" in option), "c++")
    digest.update(subprocess.run([compiler, "--version"], stdout=subprocess.PIPE, check=True).stdout)
    for file in decisive_files(ROOT):
        digest.update(f"{file.name}\n".encode() + file.read_bytes())
    return digest.hexdigest()[:24]


def digest_of(program):
    """Of a program that build() made, what decides what it computes; of any other, all of it."""
    beside = program.with_name(DIGEST)
    if not program.is_file():
        return None
    return beside.read_text() if beside.is_file() else content_hash(program)


def program_of(variant):
    return ROOT / "build/matrix" / variant.build / "gpuwars"


def content_hash(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()[:24]


def compare(program, file, options, recorded):
    """How many ticks were compared and how many mismatch; what else went wrong as `error`. `recorded`: a function that
    tells the recorded hashes, asked only where some differ."""
    environment = {**os.environ, "TSAN_OPTIONS": f"suppressions={ROOT}/tests/tsan_suppressions.txt"}
    result = subprocess.run([str(program), "verify", str(file), "--device", "cpu", "--json", "-", *options],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, env=environment)
    try:
        facts = json.loads(result.stdout)["replays"][0]
    except (ValueError, KeyError, IndexError):
        return {"compared": 0, "mismatching": 0, "error": result.stderr[-2000:] or f"exit {result.returncode}"}
    found = {"ticks": facts["ticks"], "compared": facts["ticksCompared"], "mismatching": 0}
    if facts.get("firstDifference"):
        lines = subprocess.run([str(program), "verify", str(file), "--device", "cpu", "--hashes", "-", *options],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False).stdout
        computed = [int(line.split()[1], 16) for line in lines.splitlines() if line[:1].isdigit()]
        found["mismatching"] = sum(a != b for a, b in zip(computed, recorded(), strict=False)) or 1
        found["first"] = facts["firstDifference"]["tick"]
    elif result.returncode != 0 or not facts["equal"]:
        found["error"] = facts.get("error") or facts.get("wrong") or result.stderr[-2000:] or f"exit {result.returncode}"
    return found


class Results:
    """build/matrix/results.json: a cell holds as long as what decides, replay and options are what they were."""

    def __init__(self, path):
        self.path = path
        self.cells = json.loads(path.read_text()) if path.is_file() else {}

    def get(self, variant, name, key):
        cell = self.cells.get(variant, {}).get(name)
        return cell if cell and cell["key"] == key and "error" not in cell else None

    def now(self, variant, name, digests):
        """The cell, when program and replay are still those that it is of; `digests`: of both, None where there is none."""
        cell = self.cells.get(variant, {}).get(name)
        return cell if cell and tuple(cell["key"].split()[:2]) == digests else None

    def put(self, variant, name, key, found):
        self.cells.setdefault(variant, {})[name] = {"key": key, **found}
        self.path.parent.mkdir(parents=True, exist_ok=True)
        replace(self.path, json.dumps(self.cells, indent=1))


def fill(variant, program, replays, results, jobs, recorded, most_ticks=None, say=print):
    """Verifies what is not known yet, several at a time; a result is kept as soon as it is there."""
    digest, pending = digest_of(program), []
    for name, golden in golden_list(replays).items():
        file = replays / f"{name}.gwr"
        options = [*golden.verified, *variant.options]
        if "--threads" not in options:
            options += ["--threads", str(max(1, (os.cpu_count() or 1) // jobs))]
        key = f"{digest} {content_hash(file)} {' '.join(options)}"
        if results.get(variant.name, name, key) is None and (most_ticks is None or most_ticks >= recorded[name]["ticks"]):
            pending.append((name, file, options, key))
    start = time.monotonic()
    with ThreadPoolExecutor(jobs) as pool:
        running = {pool.submit(compare, program, file, options, recorded[name]["hashes"]): (name, key)
                   for name, file, options, key in pending}
        for done, job in enumerate(as_completed(running), 1):
            name, key = running[job]
            results.put(variant.name, name, key, job.result())
            say(f"{variant.name}: {name}: {job.result().get('error') or cell_text(job.result())} "
                f"({done} of {len(pending)}, {time.monotonic() - start:.0f} s)")


def cell_text(found):
    """Mismatching ticks / ticks compared; a dash: not run."""
    if found is None:
        return "-"
    if "error" in found:
        return "failed"
    return f"{found['mismatching']:,} / {found['compared']:,}"
