#!/usr/bin/env python3
"""Fewer processors than the machine has (an affinity, a quota of time), and who sets their clocks: threads, `devices` and
the report know of it.

    processors_e2e.py GPUWARS SCHEMA FOLDER      a quota and a governor need root, and are left out where it is lacking
"""
import contextlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from program import Failures, run, without_display

VERSION1 = Path("/sys/fs/cgroup/cpu")  # where this hierarchy is mounted; in version 2 a group may hold no siblings here
PRESENT = os.sysconf("SC_NPROCESSORS_ONLN")


def outside(failures, program):
    code, stdout, _ = run(program, "devices", "--json", "-")
    facts = json.loads(stdout)["processors"]
    allowed = len(os.sched_getaffinity(0))
    failures.check(code == 0 and facts["present"] == PRESENT, f"{facts['present']} processors are there")
    least = min(PRESENT, allowed, max(1, -(-(facts["quota"] or PRESENT) // 1)))
    failures.check(facts["threads"] == least, f"{facts['threads']} threads: {facts}")


def with_affinity(failures, program, folder):
    """To one processor, as taskset and containers with a set of processors do it."""
    def command(*arguments):
        return subprocess.run([program, *map(str, arguments)], env=without_display(), text=True, capture_output=True,
                              check=False, preexec_fn=lambda: os.sched_setaffinity(0, {min(os.sched_getaffinity(0))}))

    facts = json.loads(command("devices", "--json", "-").stdout)
    failures.check(facts["processors"]["threads"] == 1, f"one thread on one processor: {facts['processors']}")
    line = next(line for line in command("devices").stdout.splitlines() if line.startswith("cpu"))
    failures.check("1 thread" in line and (PRESENT == 1 or f"an affinity to 1 of {PRESENT} processors" in line), line)
    replay = folder / "one.gwr"
    made = command("--headless", "--device", "cpu", "--seed", 1, "--autopilot", "expert", "--enemies", 64, "--ticks", 60,
                   "--record", replay)
    verified = json.loads(command("verify", replay, "--json", "-").stdout)["replays"][0]
    failures.check(made.returncode == 0 and verified["device"] == "cpu, 1 thread", f"a run takes {verified['device']}")


def profile(program, out, wrapper=(), entered=None, more=()):
    """The report of a short session, and what it printed."""
    command = [*wrapper, program, "profile", "--device", "cpu", "--no-draw", "--scene", "swarm", "--enemies", "64", "--ticks",
               "120", "--runs", "10", "--out", out, *more]
    result = subprocess.run([str(part) for part in command], env=without_display(), text=True, capture_output=True,
                            check=False, preexec_fn=entered)
    report = Path(out) / "report.json"
    return json.loads(report.read_text()) if report.is_file() else None, result.stdout + result.stderr


@contextlib.contextmanager
def quota_of(share):
    """A function that moves a process into a group with a share of a processor's time; None where none can be made."""
    group = VERSION1 / f"gpuwars_test_{os.getpid()}"
    try:
        group.mkdir()
        (group / "cpu.cfs_period_us").write_text("100000")
        (group / "cpu.cfs_quota_us").write_text(str(int(share * 100000)))
    except OSError:
        with contextlib.suppress(OSError):
            group.rmdir()
        yield None
        return
    try:
        yield lambda: (group / "cgroup.procs").write_text(str(os.getpid()))
    finally:
        group.rmdir()


def with_quota(failures, program, schema, folder, baseline):
    with quota_of(0.05) as enter:
        if enter is None:
            print("      no group with a quota can be made here: none was tried")
            return
        devices = subprocess.run([program, "devices"], env=without_display(), text=True, capture_output=True, check=False,
                                 preexec_fn=enter).stdout
        line = next(line for line in devices.splitlines() if line.startswith("cpu"))
        failures.check("1 thread:" in line and f"a quota of 0.05 of {PRESENT} processor" in line, line)
        report, said = profile(program, folder / "quota", entered=enter, more=("--baseline", baseline))
    if not failures.check(report is not None, f"a session inside has a report{'' if report else ': ' + said}"):
        return
    check_schema(failures, report, schema)
    state = report["machine"]["processors"]
    failures.check(state["quota"] == 0.05 and state["throttled_s"] > 0, f"that names the quota: {state}")
    failures.check(any("A quota of 0.05" in warning for warning in report["warnings"]), f"and warns: {report['warnings']}")
    failures.check("Gate: cannot judge" in said and "Another quota" in said, "against one outside the gate does not judge")


def check_schema(failures, report, schema):
    try:
        import jsonschema
    except ImportError:
        return
    offences = list(jsonschema.Draft202012Validator(json.loads(schema.read_text())).iter_errors(report))
    failures.check(not offences, f"report.json is as its schema says {[str(o)[:200] for o in offences[:2]]}")


def other_clocks(folder, governor):
    """A wrapper that shows a program this governor; None where nothing can be mounted."""
    cpus = folder / governor
    for number in range(PRESENT):
        policy = cpus / f"cpu{number}/cpufreq"
        policy.mkdir(parents=True)
        for name, text in (("scaling_governor", governor), ("scaling_min_freq", "800000"), ("scaling_max_freq", "3400000")):
            (policy / name).write_text(text + "\n")
    (cpus / "online").write_text(f"0-{PRESENT - 1}\n" if PRESENT > 1 else "0\n")
    wrapper = ["unshare", "-m", "sh", "-c", f'mount --bind "{cpus}" /sys/devices/system/cpu && exec "$@"', "sh"]
    try:
        tried = subprocess.run([*wrapper, "true"], capture_output=True, check=False)
    except OSError:
        return None
    return wrapper if tried.returncode == 0 else None


def with_governors(failures, program, schema, folder):
    performance, powersave = other_clocks(folder, "performance"), other_clocks(folder, "powersave")
    if performance is None or powersave is None:
        print("      nothing can be mounted here: no governor was tried")
        return
    first, _ = profile(program, folder / "fixed", performance)
    failures.check(first["machine"]["processors"]["governor"] == "performance"
                   and not any("governor" in warning for warning in first["warnings"]), "a fixed governor is told of")
    second, said = profile(program, folder / "moving", powersave, more=("--baseline", folder / "fixed/report.json"))
    check_schema(failures, second, schema)
    failures.check(any("governor of the clocks was powersave (800 to 3400 MHz)" in warning for warning in second["warnings"]),
                   f"one that moves the clocks is warned of: {second['warnings']}")
    failures.check('Another governor: it was "performance" and is "powersave"' in said and "Gate: cannot judge" in said,
                   "and against the first the gate does not judge")
    page = (folder / "moving/report.html").read_text()
    failures.check("powersave" in page and "800 to 3400 MHz" in page, "the page has it too")


def main():
    program, schema, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    failures = Failures()
    outside(failures, program)
    with_affinity(failures, program, folder)
    report, said = profile(program, folder / "outside")
    if failures.check(report is not None, f"a session outside of any has a report{'' if report else ': ' + said}"):
        check_schema(failures, report, schema)
        with_quota(failures, program, schema, folder, folder / "outside/report.json")
    with_governors(failures, program, schema, folder)
    failures.finish()


if __name__ == "__main__":
    main()
