"""What is measured: ticks and their stages, neighbour searches, copies; goals beside them."""
import csv
import json

from outcome import FAILED, FIGURE

TICK_GOALS_US = {8192: 50, 65536: 100, 1048576: 1000}
NEIGHBOUR_GOALS_US = {8192: 20, 65536: 30, 1048576: 150}  # upkeep and gathering, of the fastest exact NGrid
# How many enemies a scene is measured with at most: mixed begins as one crowd, which at a million takes minutes.
SCENES = {"uniform": 1048576, "mixed": 65536}


def held_against(device, us, goal):
    """The goals are a GPU's."""
    if goal is None or device != "cuda":
        return ""
    return f"; goal at most {goal:g} us: {'met' if us <= goal else 'missed'}"


def ticks(programs, outcome, sizes):
    if not programs.has("gw_bench_queued"):
        return outcome.add("ticks", "gw_bench_queued", FAILED, "has not been built")
    for scene, most in SCENES.items():
        result = programs.logs / "queued.json"
        enemies = ",".join(str(n) for n in sizes.enemies if n <= most)
        run = programs.run("gw_bench_queued", "--device", programs.device, "--scenes", scene, "--enemies", enemies,
                           "--ticks", sizes.ticks, "--rounds", sizes.rounds, "--copy-mebibytes", sizes.copy_mebibytes,
                           "--json", result, *programs.assets, limit=60)
        if not run.fine:
            outcome.add("ticks", scene, FAILED, run.why, run.command)
            continue
        measured = json.loads(result.read_text())
        if scene == "uniform":  # the same in every scene
            for way, speed in measured["copies_GBps"].items():
                outcome.add("copies", way, FIGURE, f"{speed:.1f} GB/s", run.command, GBps=speed)
        for row in measured["rows"]:
            add_tick(programs, outcome, run, row)
    return None


def add_tick(programs, outcome, run, row):
    goal = TICK_GOALS_US.get(row["enemies"])
    stages = ", ".join(f"{name} {us:.1f}" for name, us in row["stages_us"].items())
    outcome.add("ticks", f"{row['enemies']:,} enemies, {row['scene']}", FIGURE,
                f"{row['tick_us']:.1f} us a tick{held_against(programs.device, row['tick_us'], goal)} ({stages}; "
                f"{row['launchesPerTick']} kernels)", run.command, goal_us=goal, **row)


def fastest_ngrid(rows):
    """Of those that find every neighbour; the thesis's have another name."""
    exact = [row for row in rows if row["way"].startswith("ngrid")]
    return min(exact, key=lambda row: float(row["total_ms"]), default=None)


def neighbours(programs, outcome, sizes):
    if not programs.has("gw_bench_neighbours"):
        return outcome.add("neighbours", "gw_bench_neighbours", FAILED, "has not been built")
    result = programs.logs / "neighbours.csv"
    for entities in sizes.crowds:
        run = programs.run("gw_bench_neighbours", "--device", programs.device, "--entities", entities, "--distribution",
                           "swarm", "--frames", sizes.frames, "--seconds", sizes.crowd_s, "--csv", result, limit=60)
        if not run.fine:
            outcome.add("neighbours", f"{entities:,}", FAILED, run.why, run.command)
            continue
        with result.open() as file:
            rows = list(csv.DictReader(file))
        best = fastest_ngrid(rows)
        for row in rows:
            us = {part: 1000 * float(row[f"{part}_ms"]) for part in ("maintain", "gather", "total")}
            goal = NEIGHBOUR_GOALS_US.get(entities) if row is best else None
            outcome.add("neighbours", f"{entities:,}, {row['way']}", FIGURE,
                        f"{us['total']:.1f} us (maintain {us['maintain']:.1f}, gather {us['gather']:.1f})"
                        f"{held_against(programs.device, us['total'], goal)}", run.command, goal_us=goal,
                        way=row["way"], entities=entities, **{f"{part}_us": value for part, value in us.items()})
    return None
